"""HDF5 files written through Python: errors instead of crashes on a full disk, checksums of all numbers."""

from __future__ import annotations

import io
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import xarray as xr


class _Sturdy(io.RawIOBase):
    """A new file that continues in memory after its first failure; see `written`."""

    def __init__(self, path: Path) -> None:
        self.failure: OSError | None = None
        self._file: io.FileIO | io.BytesIO = io.FileIO(path, "w+")

    def write(self, data: Any) -> int:
        left = memoryview(data).cast("B")
        size = len(left)
        while left:
            try:
                left = left[self._file.write(left) :]  # a nearly full disk accepts only a part
            except OSError as error:
                self._go_on_in_memory(error)
        return size

    def truncate(self, size: int | None = None) -> int:
        try:
            return self._file.truncate(size)
        except OSError as error:
            self._go_on_in_memory(error)
            return self._file.truncate(size)

    def _go_on_in_memory(self, error: OSError) -> None:
        self.failure, place = error, self._file.tell()
        self._file.seek(0)
        content = io.BytesIO(self._file.read())
        content.seek(place)
        self._file.close()
        self._file = content

    def readinto(self, buffer: Any) -> int:
        return self._file.readinto(buffer)

    def seek(self, place: int, whence: int = io.SEEK_SET) -> int:
        return self._file.seek(place, whence)

    def seekable(self) -> bool:
        return True

    def readable(self) -> bool:
        return True

    def writable(self) -> bool:
        return True

    def close(self) -> None:
        self._file.close()
        super().close()


@contextmanager
def written(path: Path) -> Iterator[io.RawIOBase]:
    """A new file for ``h5py.File`` or xarray, in place of its path.

    HDF5 cannot close a file that it cannot write: the handle stays open, and the process ends with SIGSEGV
    (observed with HDF5 2.0 on a full disk). Therefore the error is hidden from HDF5: the file continues in
    memory, HDF5 reads back the data that it wrote and closes the file, and then the error is raised.

    Raises
    ------
    OSError : the file cannot be created, or the first failure to write it
    """
    with _Sturdy(path) as raw:
        try:
            yield raw
        finally:
            if raw.failure is not None:
                raise raw.failure


def write_dataset(dataset: xr.Dataset, path: Path) -> None:
    """Write NetCDF 4 with h5netcdf and a checksum of every numeric array.

    Without checksums, a file with a changed byte in its numbers is read like a good one.

    Raises
    ------
    OSError : the file cannot be created or written
    """
    # a scalar or an empty array has no chunks, and texts are stored apart from their array
    checked = [
        name for name, data in dataset.variables.items() if data.size > 1 and data.dtype.kind in "biuf"
    ]
    encoding = dict.fromkeys(checked, {"fletcher32": True, "_FillValue": None})
    with written(path) as file:
        dataset.to_netcdf(file, engine="h5netcdf", encoding=encoding)
