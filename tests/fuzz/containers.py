"""Damage to the containers of a file, drawn with a seed: sizes, types, dimensions, attributes, nesting."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import scipy.io
import scipy.sparse

HUGE = (3 * 10**7, 3 * 10**8, 2**33, 2**40)  # numbers of a data set of some kB
ATTRIBUTES = (
    "kind", "form", "units", "unit", "scale_factor", "add_offset", "_FillValue", "_Unsigned", "dtype",
    "missing_value", "MATLAB_class", "MATLAB_empty", "sample_rate", "motion", "quantity", "reference",
    "origin",
    "inputs", "title", "haptonic_version", "reference_scale", "response_scale", "full_scale",
    "direction",
    "start", "measured", "simulated", "path_corners", "path_labels", "DIMENSION_LIST", "_Netcdf4Dimid",
)  # fmt: skip
NAMES = ("frequency", "f", "frf", "response", "real", "imag", "x", "y", "points", "fs", "ref", "unit", "coh",
         "direction", "region", "name", "phase", "mag")  # fmt: skip
DEPTH = 3  # of variables in variables
KINDS = ("u1", "i2", "<f4", ">f8", "f8", "c16", "?", "u8", "i8", "f2")


def damage_hdf5(path: Path, chance: np.random.Generator) -> None:
    """One to three faults in the containers of an HDF5 file, of NetCDF or MATLAB 7.3 alike."""
    with h5py.File(path, "r+") as file:
        for _ in range(int(chance.choice([1, 1, 2, 3]))):
            faults = (_other_set, _other_set, _other_set, _attribute, _attribute, _lost, _nested, _link)
            with suppress(RuntimeError, KeyError):  # a name that an earlier fault has made a link without end
                faults[int(chance.integers(len(faults)))](file, chance)


def _sets(file: h5py.File) -> list[str]:
    names: list[str] = []
    file.visititems(lambda name, item: names.append(name) if isinstance(item, h5py.Dataset) else None)
    return names


def _any_set(file: h5py.File, chance: np.random.Generator) -> str:
    names = _sets(file)
    if names and chance.random() < 0.9:
        return names[int(chance.integers(len(names)))]
    return NAMES[int(chance.integers(len(NAMES)))]


def _axes(chance: np.random.Generator, shape: tuple[int, ...]) -> tuple[int, ...]:
    """Dimensions that a data set of this shape should not have."""
    drawn = int(chance.integers(6))
    if drawn == 0:
        return ()
    if drawn == 1:
        return tuple(int(n) for n in chance.integers(0, 4, int(chance.integers(1, 6))))
    if drawn == 2:
        return (*shape, int(chance.integers(0, 4)))
    if drawn == 3:
        return shape[::-1]
    if drawn == 4:
        return shape[:-1]
    return tuple(n + int(chance.integers(-1, 2)) if n else n for n in shape)


def _other_set(file: h5py.File, chance: np.random.Generator) -> None:
    """A data set of another type or size in the place of one."""
    name = _any_set(file, chance)
    shape = file[name].shape or () if name in file and isinstance(file[name], h5py.Dataset) else (3,)
    shape = shape if np.prod(shape, dtype=float) < 1e6 else (3,)  # an earlier fault has made it huge
    attributes = dict(file[name].attrs) if name in file and chance.random() < 0.5 else {}
    if name in file:
        del file[name]
    drawn = int(chance.integers(8))
    try:
        if drawn <= 2:
            count = int(chance.choice(HUGE))
            axes = (count,) if chance.random() < 0.5 else (count // 8, *shape[1:])
            kind = str(chance.choice(KINDS))
            filled = {"fillvalue": 7} if kind not in ("?", "c16") else {}
            chunks = tuple(max(1, min(n, 10**6 if i == 0 else n)) for i, n in enumerate(axes))
            file.create_dataset(name, axes, kind, compression="gzip", chunks=chunks, **filled)
        elif drawn <= 4:
            values = chance.normal(size=_axes(chance, shape))
            if values.size and chance.random() < 0.3:
                values.flat[int(chance.integers(values.size))] = chance.choice([np.nan, np.inf, -1e308, 0])
            with np.errstate(all="ignore"):
                file[name] = values.astype(str(chance.choice(KINDS)))
        elif drawn == 5:
            file.create_dataset(name, _axes(chance, shape), h5py.string_dtype())
        elif drawn == 6:
            pair = np.zeros(shape or (1,), [("real", "f8"), (str(chance.choice(["imag", "r", "x"])), "i4")])
            file[name] = pair
        else:
            file[name] = h5py.Empty(str(chance.choice(KINDS)))
    except (ValueError, TypeError, OSError):
        return
    for word, value in attributes.items():
        file[name].attrs[word] = value


def _attribute(file: h5py.File, chance: np.random.Generator) -> None:
    names = _sets(file)
    item: Any = file
    if names and chance.random() < 0.5:
        item = file[names[int(chance.integers(len(names)))]]
    known = [*item.attrs] or list(ATTRIBUTES)
    word = str(chance.choice(known if chance.random() < 0.6 else ATTRIBUTES))
    values = (
        np.zeros(0), np.zeros((2, 3)), np.arange(3), np.array(["a", "b"], dtype=object), "", "x" * 60_000, 7,
        -1.5, np.nan, np.inf, True, h5py.Empty("f8"), np.bytes_(b"\xff\xfe"), 1 + 1j, np.float32(1e30),
        np.array([[1]]), "haptonic time records", "char", "cell", "[1", "NaN", 2**62,
        np.array([(1, 2)], [("a", "i4"), ("b", "f8")]),
    )  # fmt: skip
    try:
        item.attrs[word] = values[int(chance.integers(len(values)))]
    except (ValueError, TypeError, OSError):
        return


def _lost(file: h5py.File, chance: np.random.Generator) -> None:
    names = _sets(file)
    if names and chance.random() < 0.5:
        del file[names[int(chance.integers(len(names)))]]
    elif len(file.attrs):
        del file.attrs[str(chance.choice([*file.attrs]))]


def _nested(file: h5py.File, chance: np.random.Generator) -> None:
    """A data set moved into groups, or a group in its place."""
    name = _any_set(file, chance)
    if name not in file:
        return
    depth = int(chance.choice([1, 2, 60]))
    home = "/".join(["deep"] * depth)
    try:
        if chance.random() < 0.5:
            file.move(name, f"{home}/{name}")
        else:
            del file[name]
            file.create_group(name).attrs["MATLAB_class"] = np.bytes_("struct")
    except (ValueError, TypeError, OSError):
        return


def _link(file: h5py.File, chance: np.random.Generator) -> None:
    """A data set that lies elsewhere, a group that holds itself, cells that refer to anything."""
    name = _any_set(file, chance)
    if name in file:
        del file[name]
    drawn = int(chance.integers(4))
    if drawn == 0:
        file[name] = h5py.SoftLink(f"/{name}")
    elif drawn == 1:
        file[name] = h5py.ExternalLink("/etc/passwd", "/x")
    elif drawn == 2:
        file[name] = file["/"]
    else:
        others = [file[data_set].ref for data_set in _sets(file)[:4]] + [file.ref]
        file.create_dataset(name, data=np.array(others, h5py.ref_dtype), dtype=h5py.ref_dtype)
        file[name].attrs["MATLAB_class"] = np.bytes_("cell")


def damage_matlab(path: Path, chance: np.random.Generator) -> None:
    """One to three variables of a MATLAB 5 file exchanged for others."""
    content = {
        name: value for name, value in scipy.io.loadmat(path).items() if not name.startswith("__")
    }  # fmt: skip
    for _ in range(int(chance.choice([1, 1, 2, 3]))):
        names = [*content, *NAMES] if chance.random() < 0.2 else [*content]
        name = str(chance.choice(names))
        shape = np.shape(content.get(name, np.zeros((2, 3))))
        shape = shape if np.prod(shape, dtype=float) < 1e3 else (3,)  # an earlier fault has made it large
        content[name] = _variable(chance, shape, DEPTH)
        if chance.random() < 0.1:
            del content[name]
        if not content:
            content["x"] = 1.0
    scipy.io.savemat(path, content, do_compression=bool(chance.random() < 0.5))


def _variable(chance: np.random.Generator, shape: tuple[int, ...], depth: int) -> Any:
    """A variable of another kind, perhaps with others in it."""
    drawn = int(chance.integers(10))
    axes = _axes(chance, shape)
    if drawn <= 3:
        values = chance.normal(size=axes)
        kind = str(chance.choice([kind for kind in KINDS if kind != "f2"]))
        with np.errstate(all="ignore"):
            return values.astype(kind)
    if drawn == 4:
        return "m/s" * int(chance.integers(0, 3))
    if drawn == 5 and depth:
        return {str(chance.choice(NAMES)): _variable(chance, shape, depth - 1) for _ in range(3)}
    if drawn == 6 and depth:
        cells = np.empty(axes or (1,), dtype=object)
        for i in range(cells.size):
            cells.flat[i] = _variable(chance, shape[1:], depth - 1)
        return cells
    if drawn == 7:
        records = np.zeros(int(chance.integers(0, 5)), [("x", object), ("y", object), ("frf", object)])
        for i in range(len(records)):
            for word in ("x", "y", "frf"):
                records[word][i] = chance.normal(size=_axes(chance, (3,)))
        return records
    if drawn == 8:
        return scipy.sparse.random(4, 3, 0.5, random_state=1)
    # Compressed to some kB. Inside others it is small: thousands of them would fill the memory of the fuzzer.
    return np.zeros(int(chance.choice([10**6, 3 * 10**7])) if depth == DEPTH else 10**4, "u1")
