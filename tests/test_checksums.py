"""A changed byte in the numbers of a written file is noticed when the file is read."""

import numpy as np
import pytest
import xarray as xr

from haptonic.errors import HaptonicError
from haptonic.response import FrequencyResponse, read, write
from haptonic.results import write_netcdf


def damaged_copies(path, numbers):
    """Paths of copies in which one byte of an array is changed, for every byte of the array."""
    content, place = path.read_bytes(), path.read_bytes().find(numbers.tobytes())
    assert place > 0
    for byte in range(numbers.nbytes):
        changed = bytearray(content)
        changed[place + byte] ^= 1 << byte % 8
        path.with_name(f"{byte}.nc").write_bytes(changed)
        yield path.with_name(f"{byte}.nc")


@pytest.mark.parametrize("kind", ["f8", "f4", "i4"])
def test_every_changed_byte_of_an_array_is_noticed(tmp_path, kind):
    frequency = np.arange(7, 13).reshape(2, 3).astype(kind)
    write_netcdf(
        xr.Dataset({"frequency": (("point", "band"), frequency), "empty": ("nothing", [])}), tmp_path / "a"
    )
    with xr.open_dataset(tmp_path / "a", engine="h5netcdf") as good:
        np.testing.assert_array_equal(good["frequency"], frequency)
        assert good["frequency"].dtype == kind
    for path in damaged_copies(tmp_path / "a", frequency):
        with (
            xr.open_dataset(path, engine="h5netcdf") as damaged,
            pytest.raises(OSError, match=r"filter returned failure|checksum"),
        ):
            damaged["frequency"].load()


def test_a_response_with_a_changed_byte_is_refused(tmp_path):
    numbers = np.array([[1 + 2j, 3 - 1j], [5j, 0.5]])[..., None]
    response = FrequencyResponse.of(
        numbers, frequency=[1e3, 2e3], x=[0.0, 1e-3], y=[0.0, 0.0], reference="A1, V", origin="simulated",
        region=["", ""], title="", inputs={},
    )  # fmt: skip
    write(response, tmp_path / "a.nc")
    copies = damaged_copies(tmp_path / "a.nc", numbers.real.copy())
    for path in list(copies)[::5]:
        with pytest.raises(HaptonicError, match="damaged"):
            read(path)
    assert read(tmp_path / "a.nc").dataset["response"].size == 4
