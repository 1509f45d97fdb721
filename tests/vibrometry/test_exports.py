"""Scans in other forms, read back; and readers that pass on what is no fault of a file."""

from __future__ import annotations

from pathlib import Path

import h5py
import numpy as np
import pytest
import pyuff
import scipy.io
from scans import VALUES, X, Y, nodes, response, uff, units

import haptonic
import haptonic.foreign.process as process
from five_parts import assert_explained
from haptonic.channels import Notebook, matlab
from haptonic.channels.uff import READERS
from haptonic.errors import ResourceError
from haptonic.response import Reference
from haptonic.vibrometry import (
    InMemory,
    TimeScan,
    estimate,
    read_scan,
    records as module,
    write_records,
    write_uff_records,
)
from haptonic.vibrometry.exports import csv_files, write_mat, write_mat_records, write_tdms
from haptonic.vibrometry.readers.mapped import Mapped
from haptonic.vibrometry.readers.tables import scan_of_groups

CHANCE = np.random.default_rng(8)
MOVED = CHANCE.normal(size=(12, 3, 40))
DRIVEN = CHANCE.normal(size=(12, 3, 40))


def records(shared: bool, origin: str = "simulated") -> TimeScan:
    reference = DRIVEN[:1] if shared else DRIVEN
    return TimeScan(
        InMemory(reference, MOVED), tuple(f"{i + 1}" for i in range(12)), X, Y, 3, 40, 200e3,
        Reference("A1", "V"), reference_scale=2.0, response_scale=1e-3, origin=origin, title="a plate",
    )  # fmt: skip


@pytest.mark.parametrize("shared", [True, False])
@pytest.mark.parametrize(("suffix", "writer"), [("mat", write_mat_records), ("uff", write_uff_records)])
def test_records_come_back(tmp_path, monkeypatch, shared, suffix, writer):
    monkeypatch.setattr(module, "WRITTEN", 5)
    path = tmp_path / f"a.{suffix}"
    writer(records(shared), path)
    scan = read_scan(path, unit="m/s", reference="A1, V").records
    assert (scan.origin, scan.motion, scan.sample_rate) == ("simulated", "velocity", pytest.approx(200e3))
    assert np.column_stack([scan.x, scan.y]) == pytest.approx(np.column_stack([X, Y]))
    for start, stop in ((0, 12), (3, 7)):
        reference, moved = scan.source.load(start, stop)
        assert moved * scan.response_scale == pytest.approx(1e-3 * MOVED[start:stop], rel=2e-5, abs=1e-9)
        expected = 2.0 * (DRIVEN[:1] if shared else DRIVEN[start:stop])
        assert reference * scan.reference_scale == pytest.approx(expected, rel=2e-5, abs=1e-6)


@pytest.mark.parametrize("shared", [True, False])
def test_records_come_back_from_tdms(tmp_path, monkeypatch, shared):
    monkeypatch.setattr(module, "WRITTEN", 2)
    write_tdms(records(shared), tmp_path / "a.tdms")
    scan = read_scan(tmp_path / "a.tdms")
    stored = scan.records
    assert (stored.origin, stored.samples) == ("simulated", 120)
    assert stored.reference == Reference("reference", "V")
    reference, moved = stored.source.load(2, 5)
    assert moved.reshape(3, 3, 40) == pytest.approx(1e-3 * MOVED[2:5], rel=1e-6)
    expected = np.broadcast_to(DRIVEN[:1], (3, 3, 40)) if shared else DRIVEN[2:5]
    assert reference.reshape(3, 3, 40) == pytest.approx(2.0 * expected, rel=1e-6)
    # cut into the periods again, the estimate is that of the records themselves
    same = estimate(stored, segment=40).response
    assert same.values == pytest.approx(estimate(records(shared)).response.values, rel=1e-4)


def test_large_records_of_matlab_stay_in_the_file(tmp_path):
    write_mat_records(records(False), tmp_path / "a.mat")

    def read():
        notes = Notebook(tmp_path / "a.mat", "MATLAB")
        how = Mapped({}, "m/s", file=notes.path)
        return scan_of_groups(matlab.read(notes.path, notes, large=1000), how, notes, "measured", "", ".")

    stored = read()
    assert stored.source.response.streamed
    assert stored.source.reference.streamed
    streamed = [piece for _, _, piece in stored.chunks(5)]
    assert np.concatenate(streamed) == pytest.approx(1e-3 * MOVED, rel=1e-6)
    # the other way round, with the samples first, it is read whole
    with h5py.File(tmp_path / "a.mat", "r+") as file:
        turned = {name: np.ascontiguousarray(file[name][:, 0].T) for name in ("response", "reference")}
        for name, values in turned.items():
            del file[name]
            file[name] = values
    again = read()
    assert not again.source.response.streamed
    assert again.source.load(4, 6)[1][:, 0] == pytest.approx(1e-3 * MOVED[4:6, 0], rel=1e-6)


def test_our_uff_records_are_read_by_pyuff(tmp_path):
    write_uff_records(records(True), tmp_path / "a.uff")
    sets = pyuff.UFF(str(tmp_path / "a.uff")).read_sets()
    times = [
        data_set
        for data_set in sets
        if data_set["type"] == 58 and data_set["ordinate_axis_units_lab"].strip() == "m/s"
    ]
    assert len(times) == 36
    assert times[4]["rsp_node"] == 2
    assert times[4]["data"] == pytest.approx(1e-3 * MOVED[1, 1], rel=2e-5)
    assert times[4]["id5"].strip() == "origin: simulated"
    assert times[4]["abscissa_inc"] == pytest.approx(5e-6)


@pytest.mark.parametrize("coherent", [True, False])
@pytest.mark.parametrize("form", ["mat", "csv"])
def test_responses_come_back(tmp_path, form, coherent):
    coherence = np.linspace(0, 1, 96).reshape(8, 12) if coherent else None
    before = response(origin="simulated", coherence=coherence)
    if form == "mat":
        path = tmp_path / "a.mat"
        write_mat(before, path)
    else:
        path = tmp_path
        for name, writer in csv_files(before).items():
            writer(tmp_path / name)
    after = read_scan(path, reference="A1, V").response
    assert after.dataset.attrs["origin"] == "simulated"
    assert after.values[..., 0] == pytest.approx(VALUES, rel=1e-7)
    assert after.points == pytest.approx(np.column_stack([X, Y]))
    assert after.units == "m/s/V"
    if coherent:
        assert after.dataset["coherence"].values == pytest.approx(coherence, abs=1e-8)


def test_a_measured_scan_is_not_marked_as_simulated(tmp_path):
    write_mat(response(origin="measured"), tmp_path / "a.mat")
    assert read_scan(tmp_path / "a.mat").response.dataset.attrs["origin"] == "measured"
    write_tdms(records(True, "measured"), tmp_path / "a.tdms")
    assert read_scan(tmp_path / "a.tdms").records.origin == "measured"


def test_read_scan_is_at_the_top():
    assert haptonic.read_scan is read_scan


class TestNoFaultOfTheFile:
    """Too little memory and a missing right are reported as such, and not as a damaged file."""

    @pytest.mark.parametrize("form", ["mat", "tdms", "h5", "uff"])
    def test_a_missing_right(self, tmp_path, monkeypatch, form):
        path = self.written(tmp_path, form)
        monkeypatch.setattr(Path, "open", raising(PermissionError))
        with pytest.raises(ResourceError) as caught:
            read_scan(path)
        assert_explained(caught.value, code="forbidden", argument="path")

    @pytest.mark.parametrize("form", ["mat", "h5", "uff"])
    def test_too_little_memory(self, tmp_path, monkeypatch, form):
        path = self.written(tmp_path, form)
        monkeypatch.setattr(process, "MEMORY", 2**28)
        if form == "mat":  # 40 kB that unfold to 400 MB
            scipy.io.savemat(path, {"h": np.zeros(50_000_000)}, do_compression=True)
        elif form == "h5":
            with h5py.File(path, "r+") as file:
                del file["name"]
                for name in ("x", "y"):
                    del file[name]
                    file.create_dataset(name, (2**40,), float, chunks=(1000,))
                for name in ("response", "reference"):
                    del file[name]
                    file.create_dataset(name, (2**40, 1, 1), float, chunks=(1000, 1, 1))
        else:
            monkeypatch.setitem(READERS, 2411, hiding(MemoryError))
        with pytest.raises(ResourceError) as caught:
            read_scan(path)
        assert_explained(caught.value, code="too-large")

    def test_records_that_announce_more_than_there_is(self, tmp_path):
        path = self.written(tmp_path, "h5")
        with h5py.File(path, "r+") as file:
            for name in ("response", "reference"):
                del file[name]
                file.create_dataset(name, (12, 1, 2**38), float, chunks=(1, 1, 1000))
        scan = read_scan(path).records
        for use in (lambda: next(scan.chunks(1)), lambda: estimate(scan)):
            with pytest.raises(ResourceError) as caught:
                use()
            assert_explained(caught.value, code="too-large", argument="records")

    def test_an_interrupt_is_not_swallowed_by_pyuff(self, tmp_path, monkeypatch):
        path = self.written(tmp_path, "uff")
        monkeypatch.setitem(READERS, 2411, hiding(KeyboardInterrupt))
        with pytest.raises(KeyboardInterrupt):
            read_scan(path)

    def written(self, folder, form):
        path = folder / f"a.{form}"
        if form == "mat":
            write_mat(response(), path)
        elif form == "tdms":
            write_tdms(records(True), path)
        elif form == "h5":
            write_records(records(True), path)
        else:
            uff(path, units(), nodes())
        return path


def raising(error):
    def fail(*_, **__):
        raise error

    return fail


def hiding(error):
    """As pyuff does it: a bare except and a plain Exception."""

    def fail(*_, **__):
        try:
            raise error
        except (Exception, KeyboardInterrupt):  # noqa: BLE001  as pyuff does it
            raise Exception("Error reading data-set") from None

    return fail
