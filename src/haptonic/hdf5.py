"""HDF5 files that come into being through Python, so that a full disk is an error and not a crash."""

from __future__ import annotations

import io
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any


class _Sturdy(io.RawIOBase):
    """A new file that goes on in memory, from its first failure on: see `written`."""

    def __init__(self, path: Path) -> None:
        self.failure: OSError | None = None
        self._file: io.FileIO | io.BytesIO = io.FileIO(path, "w+")

    def write(self, data: Any) -> int:
        left = memoryview(data).cast("B")
        size = len(left)
        while left:
            try:
                left = left[self._file.write(left) :]  # near the end of a disk only a part is written
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
    """A new file to give to ``h5py.File`` or to xarray in place of its path.

    HDF5 cannot close a file that it cannot write: the handle stays, and the process ends by SIGSEGV (seen
    with HDF5 2.0 on a full disk). So it is not told, and what it reads back is what it wrote; it closes its
    file, and the error comes afterwards. Until then the file is in memory.

    Raises
    ------
    OSError : the file cannot be made, or the first failure to write it
    """
    with _Sturdy(path) as raw:
        try:
            yield raw
        finally:
            if raw.failure is not None:
                raise raw.failure
