"""NetCDF files: errors instead of crashes on a full disk, checksums of all numbers, and a fast reader."""

from __future__ import annotations

import io
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.later import h5py, xarray as xr

SIGNATURE = b"\x89HDF\r\n\x1a\n"  # first bytes of an HDF5 file
STUDY = "study"  # attribute of a result with the text of its study
# attributes by which HDF5 and NetCDF mark dimensions
DIMENSION_MARKS = frozenset(
    {"CLASS", "NAME", "DIMENSION_LIST", "REFERENCE_LIST", "_Netcdf4Dimid", "_Netcdf4Coordinates",
     "_NCProperties"}
)  # fmt: skip
BARE_DIMENSION = b"This is a netCDF dimension but not a netCDF variable"
CHUNK_BYTES = 1 << 20  # of a large array


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
    """Write NetCDF 4; see `save_dataset`.

    Raises
    ------
    OSError : the file cannot be created or written
    """
    with written(path) as file:
        save_dataset(dataset, file)


def save_dataset(dataset: xr.Dataset, file: io.IOBase) -> None:
    """Write NetCDF 4 with a checksum of every numeric array into an open file.

    Without checksums, a file with a changed byte in its numbers is read like a good one. xarray reads the
    file as one by ``dataset.to_netcdf(..., engine="h5netcdf")``, which takes ten times as long: h5netcdf
    looks up each dimension in the file again for each variable.

    Raises
    ------
    TypeError : an attribute that NetCDF has no type for, such as a boolean
    """
    plain = dataset.drop_encoding()
    conventions = xr.conventions
    variables, attributes = conventions.cf_encoder(*conventions.encode_dataset_coordinates(plain))
    with h5py.File(file, "w", track_order=True) as content:
        _set_attributes(content, attributes)
        scales = {}
        for name, size in plain.sizes.items():
            if name not in variables:
                mark = b"%s.%10d" % (BARE_DIMENSION, size)
                # NetCDF reads an empty dimension as one that can grow
                scales[name] = content.create_dataset(name, (size,), ">f4", maxshape=(size or None,))
                scales[name].make_scale(mark)
        for name, data in variables.items():
            assert "/" not in name, f"{name}: HDF5 would make a group of it"
            part = content.create_dataset(name, **_layout(data.values))
            data.attrs.pop("_FillValue", None)  # NaN, which is a value here and marks nothing
            _set_attributes(part, data.attrs)
            if name in plain.sizes:
                assert data.dims == (name,), f"{name}: the name of another dimension"
                part.make_scale(name)
                scales[name] = part
        for number, name in enumerate(plain.sizes):
            scales[name].attrs["_Netcdf4Dimid"] = np.int32(number)
        for name, data in variables.items():
            if name not in scales:
                for axis, dimension in zip(content[name].dims, data.dims, strict=True):
                    axis.attach_scale(scales[dimension])


def _layout(values: NDArray[Any]) -> dict[str, Any]:
    """Arguments of ``h5py.Group.create_dataset`` for an array, in one chunk for each ``CHUNK_BYTES``."""
    if values.dtype.kind in "OU":  # texts are stored apart from their array, which needs no checksum
        return {"data": values.astype(object), "dtype": h5py.string_dtype()}
    if values.ndim == 0:  # a scalar has no chunks
        return {"data": values}
    if values.size == 0:
        return {"data": values, "maxshape": tuple(size or None for size in values.shape)}
    rows = max(1, len(values) * CHUNK_BYTES // values.nbytes)
    return {"data": values, "chunks": (min(rows, len(values)), *values.shape[1:]), "fletcher32": True}


def _set_attributes(part: Any, attributes: Mapping[Any, Any]) -> None:
    for name, value in attributes.items():
        array = np.atleast_1d(value)
        if array.dtype.kind not in "iufU":
            raise TypeError(f"NetCDF has no type for attribute {name!r}: {value!r}")
        part.attrs[name] = value if array.dtype.kind == "U" else array


def read_dataset(content: bytes) -> xr.Dataset:
    """Read a NetCDF 4 file without groups, all of it at once.

    It equals ``xarray.load_dataset(..., engine="h5netcdf", decode_timedelta=False)`` in a fifth of its time:
    h5netcdf looks up each dimension in the file again for each variable.
    """
    variables = {}
    with h5py.File(io.BytesIO(content), "r", track_order=True) as file:
        for name, part in file.items():
            is_type = isinstance(part, h5py.Datatype)  # of complex numbers
            if is_type or part.attrs.get("NAME", b"").startswith(BARE_DIMENSION):
                continue
            axes = part.attrs.get("DIMENSION_LIST")  # missing if the variable is the dimension's own
            own = (name,) if part.ndim else ()
            dims = own if axes is None else tuple(file[references[0]].name[1:] for references in axes)
            is_text = h5py.check_string_dtype(part.dtype)
            values = part.asstr()[()] if is_text else part[()]
            variables[name] = dims, np.asarray(values, dtype=str) if is_text else values, _attributes(part)
        dataset = xr.Dataset(variables, attrs=_attributes(file))
    return xr.decode_cf(dataset, decode_timedelta=False)


def _attributes(part: Any) -> dict[str, Any]:
    """Attributes of a group or variable; a list of one number is a number, texts are a list."""
    attributes = {}
    for name, value in part.attrs.items():
        if name in DIMENSION_MARKS:
            continue
        if isinstance(value, np.ndarray):
            value = value.tolist() if value.dtype == object else value[0] if value.shape == (1,) else value
        attributes[name] = value
    return attributes
