"""Frequency responses on disk: the same after a round trip, readable by others, and nothing else is read."""

import h5netcdf
import numpy as np
import pytest
import xarray as xr
from hypothesis import given, strategies as st
from hypothesis.extra import numpy as arrays
from waves import numbers, response_of_waves

from five_parts import refusing
from haptonic.atomic import write_atomically
from haptonic.errors import ResourceError, ResponseError
from haptonic.response import read, write


def assert_same(loaded, response):
    xr.testing.assert_identical(loaded.dataset, response.dataset)
    for name, variable in response.dataset.variables.items():
        assert loaded.dataset[name].dtype.kind == variable.dtype.kind
        if variable.dtype.kind != "U":
            assert loaded.dataset[name].dtype == variable.dtype
            assert loaded.dataset[name].values.tobytes() == variable.values.tobytes()


@pytest.mark.parametrize("precision", [np.complex64, np.complex128])
def test_round_trip_of_everything(tmp_path, precision):
    response = response_of_waves(
        response=numbers((6, 20, 3), precision=precision),
        direction=["x", "y", "z"],
        coherence=np.linspace(0, 1, 120, dtype=np.float32).reshape(6, 20),
        title="Größe, µm",
        inputs={"long": "x" * 100_000},
    )
    write_atomically(tmp_path / "new" / "a.nc", lambda path: write(response, path))
    assert_same(read(tmp_path / "new" / "a.nc"), response)


def test_round_trip_of_the_least(tmp_path):
    response = response_of_waves(region=None, title="", inputs=None, reference="", origin="measured").at(40e3)
    write(response, tmp_path / "a.nc")
    loaded = read(tmp_path / "a.nc")
    assert_same(loaded, response)
    assert loaded.regions == ()


@given(
    values=arrays.arrays(
        np.complex128, (2, 20, 1), elements=st.complex_numbers(allow_nan=False, allow_infinity=False)
    )
)
def test_round_trip_is_exact(tmp_path_factory, values):
    """Also for zeros with a sign and the smallest numbers."""
    path = tmp_path_factory.mktemp("exact") / "a.nc"
    response = response_of_waves(response=values, frequency=np.array([1.0, 2.0]))
    write(response, path)
    assert_same(read(path), response)


def test_the_version_is_that_of_the_writer(tmp_path):
    response = response_of_waves()
    response.dataset.attrs["haptonic_version"] = "0.0.1"
    write(response, tmp_path / "a.nc")
    assert read(tmp_path / "a.nc").dataset.attrs["haptonic_version"] == "0.0.1"


def test_any_reader_of_netcdf_finds_its_way(tmp_path):
    """Real and imaginary parts with their units, no complex type, no fill value that hides a number."""
    response = response_of_waves(coherence=np.ones((6, 20)))
    write(response, tmp_path / "a.nc")
    with h5netcdf.File(tmp_path / "a.nc", "r", decode_vlen_strings=True) as file:
        assert file.attrs["kind"] == "haptonic frequency response"
        for name, part in (("response_real", response.values.real), ("response_imag", response.values.imag)):
            variable = file.variables[name]
            assert variable.dimensions == ("frequency", "point", "direction")
            assert variable.dtype == np.float64
            assert np.array_equal(variable[...], part)
            assert variable.attrs["units"] == "m/s/V"
            assert "exp(+i omega t)" in variable.attrs["long_name"]
            assert "_FillValue" not in variable.attrs
        assert file.variables["frequency"].attrs["units"] == "Hz"


class TestOtherFiles:
    def test_a_missing_file(self, tmp_path):
        with refusing(ResourceError, "not-found", "file of a frequency response"):
            read(tmp_path / "a.nc")

    def test_a_folder(self, tmp_path):
        with refusing(ResourceError, "unreadable", "file of a frequency response", "folder"):
            read(tmp_path)

    @pytest.mark.parametrize("content", [b"", b"frequency;x;y\n", b"CDF\x01" + bytes(100)])
    def test_no_netcdf_4(self, tmp_path, content):
        (tmp_path / "a.nc").write_bytes(content)
        with refusing(ResponseError, "unreadable", "file of a frequency response", "not a NetCDF 4 file"):
            read(tmp_path / "a.nc")

    def test_half_of_a_file(self, tmp_path):
        write(response_of_waves(), tmp_path / "a.nc")
        whole = (tmp_path / "a.nc").read_bytes()
        (tmp_path / "a.nc").write_bytes(whole[: len(whole) // 2])
        with refusing(ResponseError, "unreadable", "file of a frequency response", "damaged"):
            read(tmp_path / "a.nc")

    def test_another_kind_of_result(self, tmp_path):
        response_of_waves().dataset.drop_vars("response").to_netcdf(tmp_path / "a.nc", engine="h5netcdf")
        with refusing(ResponseError, "unreadable", "file of a frequency response", "of another kind"):
            read(tmp_path / "a.nc")

    @pytest.mark.parametrize("lost", ["response_imag", "x", "direction"])
    def test_a_part_is_lost(self, tmp_path, lost):
        write(response_of_waves(), tmp_path / "a.nc")
        with xr.load_dataset(tmp_path / "a.nc", engine="h5netcdf") as data:
            data.drop_vars(lost).to_netcdf(tmp_path / "b.nc", engine="h5netcdf")
        with pytest.raises(ResponseError):
            read(tmp_path / "b.nc")

    def test_a_later_form(self, tmp_path):
        write(response_of_waves(), tmp_path / "a.nc")
        with xr.load_dataset(tmp_path / "a.nc", engine="h5netcdf") as data:
            data.assign_attrs(form=2).to_netcdf(tmp_path / "b.nc", engine="h5netcdf")
        with refusing(ResponseError, "unreadable", "file of a frequency response", "later haptonic"):
            read(tmp_path / "b.nc")

    def test_numbers_that_were_changed_to_nonsense(self, tmp_path):
        write(response_of_waves(coherence=np.ones((6, 20))), tmp_path / "a.nc")
        with xr.load_dataset(tmp_path / "a.nc", engine="h5netcdf") as data:
            (data.assign(coherence=data["coherence"] * 7)).to_netcdf(tmp_path / "b.nc", engine="h5netcdf")
        with refusing(ResponseError, "out-of-range", "response.coherence"):
            read(tmp_path / "b.nc")
