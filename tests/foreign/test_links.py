"""HDF5 can point into other files. A stranger's file must not bring out what else the user has."""

from __future__ import annotations

import h5py
import numpy as np
import pandas as pd
import pytest

from five_parts import refusing
from haptonic.channels import opened
from haptonic.errors import HaptonicError
from haptonic.friction.signals.tables import read_columns
from haptonic.response import FrequencyResponse, Reference, read, write
from haptonic.vibrometry import InMemory, TimeScan, read_scan, write_records

SECRET = np.arange(6.0) + 4711.0


def by_link(file, name, folder):
    with h5py.File(folder / "secret.h5", "w") as other:
        other[name] = SECRET
    file[name] = h5py.ExternalLink(str(folder / "secret.h5"), name)


def by_soft_link(file, name, folder):
    """Through a link of the file itself to one that leaves it."""
    by_link(file, f"{name}-there", folder)
    file[name] = h5py.SoftLink(f"/{name}-there")


def by_virtual_set(file, name, folder):
    with h5py.File(folder / "secret.h5", "w") as other:
        other[name] = SECRET
    layout = h5py.VirtualLayout((6,), float)
    layout[:] = h5py.VirtualSource(str(folder / "secret.h5"), name, (6,))
    file.create_virtual_dataset(name, layout)


def by_raw_storage(file, name, folder):
    (folder / "secret.bin").write_bytes(SECRET.tobytes())
    external = [(str(folder / "secret.bin"), 0, SECRET.nbytes)]
    file.create_dataset(name, (6,), float, external=external)


@pytest.fixture(params=[by_link, by_soft_link, by_virtual_set, by_raw_storage])
def stolen(request, tmp_path):
    """Puts the secret of another file where a data set was."""

    def change(path, name):
        with h5py.File(path, "r+") as file:
            if name in file:
                del file[name]
            request.param(file, name, tmp_path)

    return change


def test_the_thefts_work_in_h5py_itself(tmp_path, stolen):
    h5py.File(tmp_path / "a.h5", "w").close()
    stolen(tmp_path / "a.h5", "x")
    with h5py.File(tmp_path / "a.h5", "r") as file:
        assert np.array_equal(file["x"][:], SECRET)


@pytest.mark.parametrize("name", ["x", "response", "reference", "name"])
def test_time_records(tmp_path, stolen, name):
    path, places = tmp_path / "a.h5", np.arange(6) * 1e-3
    records = InMemory(np.ones((6, 1, 40)), np.ones((6, 1, 40)))
    write_records(TimeScan(records, tuple("abcdef"), places, places, 1, 40, 1e5, Reference("A1", "V")), path)
    stolen(path, name)
    with refusing(HaptonicError, "unreadable", "file of time records", "another file"):
        read_scan(path)


def test_a_response(tmp_path, stolen):
    values = np.ones((3, 6, 1), dtype=complex)
    places = {"x": np.arange(6) * 1e-3, "y": np.zeros(6)}
    lines = np.arange(1.0, 4)
    write(
        FrequencyResponse.of(values, frequency=lines, reference="", origin="measured", **places),
        tmp_path / "a.nc",
    )
    stolen(tmp_path / "a.nc", "x")
    with refusing(HaptonicError, "unreadable", "file of a frequency response", "another file"):
        read(tmp_path / "a.nc")


def test_matlab(tmp_path, stolen):
    path = tmp_path / "a.mat"
    with h5py.File(path, "w") as file:
        file["h"] = np.ones((6, 3), dtype=complex).view([("real", "f8"), ("imag", "f8")])
        file["f"], file["y"] = np.arange(1.0, 4), np.zeros(6)
    stolen(path, "x")
    with refusing(HaptonicError, "mismatch", "a.mat: x, y or points", "no coordinates"):
        read_scan(path, frequency_unit="Hz", length_unit="m")
    with h5py.File(path, "r+") as file:
        file["xs"] = np.arange(6) * 1e-3
    scan = read_scan(path, frequency_unit="Hz", length_unit="m")
    assert scan.response.points[:, 0].max() < 1
    assert any(
        'the variable "x"' in part.what and "another file" in part.reason for part in scan.report.dropped
    )


def test_recordings_and_tables_of_friction(tmp_path, stolen):
    path = tmp_path / "a.h5"
    with h5py.File(path, "w") as file:
        file["Fz"] = np.zeros(6)
        file.attrs["rate"] = 1e3
    stolen(path, "Fy")
    assert list(opened(path).group("").signals) == ["Fz"]
    assert list(read_columns(path, ["Fz"])) == ["Fz"]


def test_a_group_that_contains_itself(tmp_path):
    with h5py.File(tmp_path / "a.h5", "w") as file:
        file["Fz"] = np.zeros(6)
        file.attrs["rate"] = 1e3
        file.create_group("g")["g"] = file["/"]
    assert list(opened(tmp_path / "a.h5").group("").signals) == ["Fz"]


def test_tables_keep_their_columns(tmp_path):
    """What other programs write: text, whole numbers, a fill value in place of nothing."""
    table = pd.DataFrame({"a": ["x", "y"], "b": [1, 2], "c": [0.5, np.nan], "d": [True, False]})
    table.to_xarray().to_netcdf(tmp_path / "a.nc", engine="h5netcdf", encoding={"c": {"_FillValue": -9.0}})
    columns = read_columns(tmp_path / "a.nc", ["a", "b", "c", "d"])
    for name in table:
        assert columns[name].tolist() == pytest.approx(table[name].tolist(), nan_ok=True), name


def test_a_type_that_numpy_has_not_is_no_reason_to_refuse_the_rest(tmp_path):
    """HDF5's type of a time is in files of instruments."""
    for name in ("a.h5", "a.mat"):
        with h5py.File(tmp_path / name, "w") as file:
            file["Fz"] = np.zeros(6)
            file.attrs["rate"] = 1e3
            kind, place = h5py.h5t.UNIX_D32LE, h5py.h5s.create_simple((6,))
            h5py.h5d.create(file.id, b"when", kind, place)
            h5py.h5a.create(file.id, b"since", kind, h5py.h5s.create(h5py.h5s.SCALAR))
        assert set(opened(tmp_path / name).group("").signals) == {"Fz"}
