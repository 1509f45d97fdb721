"""Good files of every format that is read, and an attack that damages them one by one."""

from __future__ import annotations

import resource
import shutil
import time
import traceback
import warnings
from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path

import h5py
import numpy as np
import pyuff
import scipy.io
from containers import damage_hdf5, damage_matlab
from mutations import mutated

import haptonic.foreign.process as process
from haptonic.analyses.comparing import of_file
from haptonic.channels import opened, wav
from haptonic.errors import HaptonicError
from haptonic.friction.recordings.analysis import analysed
from haptonic.friction.recordings.sensor import Sensor
from haptonic.friction.signals.rules import Rules
from haptonic.response import FrequencyResponse, Reference, read as read_response, write
from haptonic.study import loads
from haptonic.vibrometry import InMemory, TimeScan, read_scan, write_records
from haptonic.vibrometry.exports import csv_files, write_mat, write_mat_records, write_tdms
from haptonic.vibrometry.writers import write_uff, write_uff_records
from trial_folders import WRITERS, channels, simulated, written

DATA = Path(__file__).parents[1] / "data" / "uff"
SMALL = 60_000  # bytes of a file of others, from which it is too slow to be damaged thousands of times
SECONDS = 10.0  # of processor time of the process that asks, for one file; all are below 100 kB


def _response() -> FrequencyResponse:
    chance = np.random.default_rng(3)
    x, y = (along.ravel() for along in np.meshgrid(np.arange(3) * 2e-3, np.arange(2) * 2e-3))
    values = chance.normal(size=(8, 6, 1)) + 1j * chance.normal(size=(8, 6, 1))
    return FrequencyResponse.of(
        values, frequency=100.0 * np.arange(1, 9), x=x, y=y, reference="A1, V", origin="measured",
        coherence=np.full((8, 6), 0.9), region=["WG1", "", "", "WG2", "", ""], title="a plate",
    )  # fmt: skip


def _records() -> TimeScan:
    chance = np.random.default_rng(5)
    moved, driven = (chance.integers(-30000, 30000, size=(6, 2, 40)).astype(np.int16) for _ in range(2))
    places = np.arange(6) * 1e-3
    return TimeScan(
        InMemory(driven, moved), tuple("abcdef"), places, places, 2, 40, 200e3, Reference("A1", "V"),
        response_scale=2e-6, reference_scale=3e-3,
    )  # fmt: skip


def _uff(folder: Path) -> list[Path]:
    write_uff(_response(), folder / "response.uff")
    write_uff_records(_records(), folder / "records.uff")
    common = {
        "type": 58, "func_type": 4, "rsp_dir": 3, "ref_node": 0, "ref_dir": 0, "abscissa_spacing": 1,
        "abscissa_spec_data_type": 18, "x": np.arange(1.0, 9), "ordinate_spec_data_type": 11,
        "ordinate_axis_units_lab": "m/s", "orddenom_axis_units_lab": "V", "orddenom_spec_data_type": 1,
        "data": np.arange(8) * (1 + 1j),
    }  # fmt: skip
    zeros = np.zeros(6, dtype=int)
    nodes = {"def_cs": zeros, "disp_cs": zeros, "color": zeros, "x": np.arange(6.0), "y": np.arange(6.0) ** 2,
             "z": np.zeros(6), "node_nums": np.arange(1, 7)}  # fmt: skip
    shape = pyuff.prepare_55(
        model_type=1, analysis_type=5, data_ch=2, spec_data_type=11, data_type=5, n_data_per_node=3,
        load_case=1, freq_step_n=1, freq=100.0, node_nums=np.arange(1, 7),
        r1=np.zeros(6) * 1j, r2=np.zeros(6) * 1j, r3=np.ones(6) * 1j,
    )  # fmt: skip
    units = {"type": 164, "units_code": 9, "length": 1e3, "force": 1.0, "temp": 1.0, "temp_offset": 0.0}
    line = pyuff.prepare_82(trace_num=1, n_nodes=4, color=0, id="outline", nodes=np.array([1, 4, 6, 3]))
    for kind, binary in ((15, 0), (2411, 1)):
        curves = [common | {"rsp_node": i, "binary": binary} for i in range(1, 7)]
        sets = [units, nodes | {"type": kind}, line, *(curves if kind == 2411 else [shape])]
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ResourceWarning)  # pyuff's binary writer leaves files open
            pyuff.UFF(str(folder / f"{kind}.uff")).write_sets(
                [dict(data_set) for data_set in sets], "overwrite"
            )
    for path in DATA.glob("*.uff"):
        if path.stat().st_size < SMALL:
            shutil.copy(path, folder)
    return sorted(folder.glob("*.uff"))


def _tdms(folder: Path) -> list[Path]:
    write_tdms(_records(), folder / "a.tdms")
    return [folder / "a.tdms"]


def _matlab_73(folder: Path) -> list[Path]:
    write_mat_records(_records(), folder / "records.mat")
    response = _response()
    pair = np.empty((6, 8), dtype=[("real", "f8"), ("imag", "f8")])
    pair["real"], pair["imag"] = response.values[..., 0].T.real, response.values[..., 0].T.imag
    with h5py.File(folder / "response.mat", "w", userblock_size=512) as file:
        file["h"], file["f"] = pair, response.frequency[:, None]
        file.create_dataset("x", data=response.points[:, :1], compression="gzip", chunks=(2, 1))
        file["y"] = response.points[:, 1:]
    return [folder / "records.mat", folder / "response.mat"]


def _matlab_5(folder: Path) -> list[Path]:
    response = _response()
    write_mat(response, folder / "a.mat")
    parts = {"h": response.values[..., 0], "f": response.frequency, "x": response.points[:, 0]}
    parts |= {"y": response.points[:, 1]}
    scipy.io.savemat(folder / "b.mat", parts, do_compression=True)
    scipy.io.savemat(
        folder / "c.mat", {"s": {"h": parts["h"]}, "cells": np.array(["a", 1.0], dtype=object)} | parts
    )
    return [folder / f"{name}.mat" for name in "abc"]


def _hdf5(folder: Path) -> list[Path]:
    write_records(_records(), folder / "a.h5")
    response = _response()
    with h5py.File(folder / "b.h5", "w") as file:  # as anybody stores a scan from Python
        file["frf"], file["frequency"] = response.values[..., 0].T, response.frequency
        file["x"], file["y"] = response.points.T
    with h5py.File(folder / "c.h5", "w") as file:
        group = file.create_group("scan")
        group["real"], group["imag"] = response.values[..., 0].real, response.values[..., 0].imag
        group["f"], group["points"] = response.frequency, response.points
    return [folder / f"{name}.h5" for name in "abc"]


def _netcdf(folder: Path) -> list[Path]:
    write(_response(), folder / "a.nc")
    return [folder / "a.nc"]


def _csv(folder: Path) -> list[Path]:
    for name, writer in csv_files(_response()).items():
        writer(folder / name)
    return [folder]


def _friction(folder: Path) -> list[Path]:
    records = simulated(participants=1, blocks=2, trials=2)[:2]
    return [written(folder / kind, records, kind=kind) for kind in ("csv", "h5", "mat", "tdms")]


def _read(path: Path) -> None:
    scan = read_scan(path)
    if isinstance(scan.content, TimeScan):
        for _ in islice(scan.records.chunks(4), 3):
            pass
    str(scan.report)


def _analyse(path: Path) -> None:
    analysed(path, Sensor(), Rules())


def _signals(folder: Path) -> list[Path]:
    """What friction reads, and what no scan is read from."""
    forces = channels([record for _, record in simulated(participants=1, blocks=2, trials=2)[:1]])
    for kind, write_one in WRITERS.items():
        write_one(forces, folder / f"a.{kind}")
    write_uff_records(_records(), folder / "a.uff")
    wav.write(folder / "a.wav", forces["Fz"], 1000)
    return sorted(folder.iterdir())


def _signals_hdf5(folder: Path) -> list[Path]:
    forces = channels([record for _, record in simulated(participants=1, blocks=2, trials=2)[:1]])
    WRITERS["h5"](forces, folder / "a.h5")
    return [folder / "a.h5"]


def _bands(folder: Path) -> list[Path]:
    """A file as `haptonic bands` writes it."""
    study = loads('material = "steel"\n[cell]\npitch = "7 mm"\nthickness = "1.5 mm"\n[cell.pillar]\n'
                  'diameter = "3 mm"\nheight = "8 mm"\n[bands]\ncount = 4\npoints = 8\naccuracy = 5e-2\n'
                  '[mesh]\norder = 2\nfoot_rings = 0\n')  # fmt: skip
    study.bands().write(folder)
    return [folder / "bands.nc"]


def _compare(path: Path) -> None:
    of_file(path)


def _look(path: Path) -> None:
    """All groups and channels, whatever they are."""
    for group in opened(path).groups.values():
        for channel in group.channels.values():
            np.asarray(channel)
        _ = group.rate, group.simulated


@dataclass(frozen=True)
class Attack:
    """A format: how good files (or folders of them) are made, and how they are read."""

    make: Callable[[Path], list[Path]]
    read: Callable[[Path], None] = _read
    text: bool = False
    containers: Callable[[Path, np.random.Generator], None] | None = None  # damages these instead of bytes


ATTACKS = {
    "UFF": Attack(_uff, text=True),
    "TDMS": Attack(_tdms),
    "MAT 7.3": Attack(_matlab_73),
    "MAT 5": Attack(_matlab_5),
    "HDF5 records": Attack(_hdf5),
    "NetCDF": Attack(_netcdf),
    "CSV folder": Attack(_csv, text=True),
    "friction folder": Attack(_friction, _analyse),
    "signals": Attack(_signals, _look),
    "MAT 5 variables": Attack(_matlab_5, containers=damage_matlab),
    "MAT 7.3 containers": Attack(_matlab_73, containers=damage_hdf5),
    "HDF5 containers": Attack(_hdf5, containers=damage_hdf5),
    "NetCDF containers": Attack(_netcdf, containers=damage_hdf5),
    "responses given": Attack(_netcdf, read_response, containers=damage_hdf5),
    "bands given": Attack(_bands, _compare, containers=damage_hdf5),
    "signals containers": Attack(_signals_hdf5, _look, containers=damage_hdf5),
}


@dataclass
class Counts:
    """What came of an attack. ``faults`` are what no file may do: tracebacks and what takes too long."""

    tried: int = 0
    refused: int = 0
    crashed: int = 0
    hung: int = 0
    large: int = 0
    faults: list[str] = field(default_factory=list)

    def __str__(self) -> str:
        return (
            f"{self.tried} tried, {self.refused} refused (the reading process crashed {self.crashed} times, "
            f"hung {self.hung} times, took too much {self.large} times), {len(self.faults)} faults"
        )


def attack(name: str, folder: Path, count: int, seed: int = 0) -> Counts:
    """Read ``count`` damaged files; each is drawn by (seed, its number), so that one can be made again."""
    how, counts = ATTACKS[name], Counts()
    folder.mkdir(parents=True)
    sources = how.make(folder)
    for path in sources:
        if not (DATA / path.name).exists():  # those of others hold parts of scans only
            how.read(path)
    for number in range(count):
        chance = np.random.default_rng([seed, number])
        path = sources[number % len(sources)]
        file = path
        if path.is_dir():
            file = sorted(path.iterdir())[int(chance.integers(len(list(path.iterdir()))))]
        content = file.read_bytes()
        text = how.text or file.suffix == ".csv"
        if how.containers is None:
            file.write_bytes(mutated(content, chance, text=text))
        else:
            how.containers(file, chance)
        before = time.process_time()
        with _counted(counts):
            _tried(how, path, counts, f"{name}, seed {seed}, number {number}, {file.name}")
        if (took := time.process_time() - before) > SECONDS:
            counts.faults.append(f"{name}, seed {seed}, number {number}: {took:.1f} s")
        counts.tried += 1
        file.write_bytes(content)
    return counts


def _tried(how: Attack, path: Path, counts: Counts, label: str) -> None:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            how.read(path)
    except HaptonicError as error:
        counts.refused += 1
        if not all(error.parts().values()):
            counts.faults.append(f"{label}\nnot five parts: {error}")
    except Exception:  # noqa: BLE001  whatever it is, it is what is looked for
        counts.faults.append(f"{label}\n{traceback.format_exc()}")


class _counted:  # noqa: N801
    """Counts how the reading process ended meanwhile."""

    def __init__(self, counts: Counts) -> None:
        self.counts, self.before = counts, process._error_for

    def __enter__(self) -> None:
        def counted(path, error, limits):
            kind = {"time": "hung", "memory": "large"}.get(error.reason, "crashed")
            setattr(self.counts, kind, getattr(self.counts, kind) + 1)
            return self.before(path, error, limits)

        process._error_for = counted

    def __exit__(self, *_) -> None:
        process._error_for = self.before


def peak_memory() -> float:
    """Largest memory of this process so far, bytes (Linux)."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024.0


if __name__ == "__main__":
    import argparse
    import tempfile

    parser = argparse.ArgumentParser(description="Attack the readers.")
    parser.add_argument("name", choices=list(ATTACKS))
    parser.add_argument("count", type=int)
    parser.add_argument("--seed", type=int, default=0)
    asked = parser.parse_args()
    process.SECONDS = 2.0
    with tempfile.TemporaryDirectory() as place:
        counts = attack(asked.name, Path(place) / "files", asked.count, asked.seed)
    for fault in counts.faults[:20]:
        print(fault)
    print(f"{asked.name}: {counts}; peak {peak_memory() / 1e6:.0f} MB; "
          f"{time.process_time():.0f} s of processor time here, "
          f"{sum(resource.getrusage(resource.RUSAGE_CHILDREN)[:2]):.0f} s in ended readers")  # fmt: skip
