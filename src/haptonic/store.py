"""Store of results on disk, with keys from their inputs.

The key of a result is the SHA-256 of its inputs and of the code that computed it (``content_key``). So an
interrupted run continues, a repeated run is immediate, and results of changed code are never used.
"""

from __future__ import annotations

import hashlib
import io
import json
import os
import re
import warnings
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass, fields, is_dataclass
from enum import Enum
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import platformdirs
import scipy

from haptonic.atomic import cause_of, draft_for, remove_stale, replace_file
from haptonic.errors import HaptonicWarning, ResourceError
from haptonic.gate import passed
from haptonic.hdf5 import read_dataset, save_dataset
from haptonic.later import xarray as xr
from haptonic.paths import target

# parts of the package that show or compare results without computing them
SHOWING = frozenset({"cli", "plots", "report", "studio", "verification", "views", "workshop"})

DIGEST_BYTES = hashlib.sha256().digest_size

# bytes of all files of a kind. A picture of 0.1 MB is drawn in a second; a plate of 40 MB takes a minute.
MOST_BYTES = {"nc": 20e9, "svg": 250e6, "png": 250e6}

_KEY = re.compile(r"[0-9a-f]{64}")


@cache
def fingerprint() -> str:
    """Hash of the computing code: the numerical source of the package and the versions of numpy and scipy.

    It is computed once per process.
    """
    return source_hash(Path(__file__).parent, {"numpy": np.__version__, "scipy": scipy.__version__})


def source_hash(package: Path, versions: Mapping[str, str], omitted: frozenset[str] = SHOWING) -> str:
    """Hash of the source files in a folder, except ``omitted`` parts, and of versions of libraries."""
    digest = hashlib.sha256(json.dumps(versions, sort_keys=True).encode())
    files = {
        path.relative_to(package): path for path in package.rglob("*") if path.suffix in (".py", ".toml")
    }
    for name in sorted(files, key=lambda name: name.as_posix()):
        if name.parts[0].removesuffix(".py") not in omitted:
            content = files[name].read_bytes()
            digest.update(f"\n{name.as_posix()} {len(content)}\n".encode())
            digest.update(content)
    return digest.hexdigest()


def content_key(inputs: Mapping[str, object]) -> str:
    """Key of a result: SHA-256 (64 hexadecimal digits) of its inputs and of ``fingerprint()``.

    ``inputs`` must contain everything that the result depends on, including the kind of computation. Use the
    frozen values themselves, not some of their fields, so that a new field changes the key; see `canonical`.
    """
    text = json.dumps(canonical(dict(inputs)), separators=(",", ":"))
    return hashlib.sha256(f"{fingerprint()}\n{text}".encode()).hexdigest()


def canonical(value: object, where: str = "inputs") -> list[Any]:
    """Nested lists of JSON types that are equal for equal values only; each begins with the kind of value.

    It supports dataclasses (type and all fields), text, numbers (floats exactly, NaN excluded), None, enums,
    arrays, bytes, sequences, mappings and sets. The order of mappings and sets does not matter. 1 and 1.0
    differ; a list and a tuple are equal, as are a number of numpy and the same Python number.
    """
    if isinstance(value, np.generic):
        value = value.item()
    match value:
        case Enum():
            return ["enum", _type_of(value), value.name]
        case None | bool() | int() | str():
            return [type(value).__name__, value]
        case float():
            return ["float", value.hex()]  # exact, and readable without rounding
        case complex():
            return ["complex", value.real.hex(), value.imag.hex()]
        case bytes():
            return ["bytes", value.hex()]
        case np.ndarray():
            assert value.dtype != object, f"{where}: an array of objects cannot be part of a key"
            return ["array", value.dtype.str, list(value.shape), value.tobytes().hex()]
        case list() | tuple():
            return ["list", *(canonical(item, f"{where}[{i}]") for i, item in enumerate(value))]
        case set() | frozenset():
            return ["set", *sorted((canonical(item, where) for item in value), key=json.dumps)]
        case Mapping():
            pairs = [[canonical(k, where), canonical(item, f"{where}.{k}")] for k, item in value.items()]
            return ["mapping", *sorted(pairs, key=json.dumps)]
    has_fields = is_dataclass(value) and not isinstance(value, type)
    assert has_fields, f"{where}: {type(value).__name__} has no fields and cannot be part of a key"
    names = [field.name for field in fields(value)]  # type: ignore[arg-type]  # it is a dataclass, see above
    pairs_of_fields = [[name, canonical(getattr(value, name), f"{where}.{name}")] for name in names]
    return ["value", _type_of(value), *pairs_of_fields]


def _type_of(value: object) -> str:
    return f"{type(value).__module__}.{type(value).__qualname__}"


@dataclass(frozen=True)
class Store:
    """Datasets and pictures in files below ``root``, each with the name of its ``content_key``.

    A dataset is NetCDF (HDF5), a picture SVG or PNG. Each is followed by its key and by the SHA-256 of
    everything before. NetCDF readers ignore this addition; ``read`` uses it to detect a damaged file or a
    file with another key. Files that were not used for longest leave; see `MOST_BYTES`.
    """

    root: Path

    def __post_init__(self) -> None:
        object.__setattr__(self, "root", Path(self.root))

    @classmethod
    def default(cls) -> Store:
        """The store in ``$HAPTONIC_STORE``, or else in the user's cache folder.

        Raises
        ------
        ResourceError : the variable is not a possible folder
        """
        chosen = os.environ.get("HAPTONIC_STORE")
        usual = platformdirs.user_cache_path("haptonic", appauthor=False)
        return cls((target(chosen, "HAPTONIC_STORE") if chosen else usual).absolute())

    def path(self, key: str, kind: str = "nc") -> Path:
        """Path of the file for this key, with the ending ``kind``."""
        assert _KEY.fullmatch(key), f"{key!r} does not come from content_key"
        return self.root / key[:2] / f"{key}.{kind}"

    def __contains__(self, key: str) -> bool:
        """True if a file for this key exists; only ``get`` checks its content."""
        return self.path(key).is_file()

    def get(self, key: str) -> xr.Dataset | None:
        """The dataset of this key, in memory; None without one, see `read`."""
        content = self.read(key)
        return None if content is None else read_dataset(content)

    def read(self, key: str, kind: str = "nc") -> bytes | None:
        """The content of the file for this key; None without one.

        A damaged file, or one with another key, does not count: it is renamed to ``<name>.corrupt`` with a
        HaptonicWarning. If the store cannot be written, a HaptonicWarning is issued before a missing result
        is computed.
        """
        path = self.path(key, kind)
        try:
            content = path.read_bytes()
            if fault := _fault(content, key):
                _set_aside(path, fault)
                return None
            with suppress(OSError):  # a store that can only be read
                os.utime(path)
        except FileNotFoundError:
            self._try()
            return None
        except OSError as error:
            self._warn(error)
            return None
        return content[: -2 * DIGEST_BYTES]

    def kept(self, question: Mapping[str, object], make: Callable[[], xr.Dataset]) -> xr.Dataset:
        """The stored result for these inputs, which form its key; it is computed and stored if missing."""
        key = content_key(question)
        dataset = self.get(key)
        if dataset is None:
            dataset = make()
            self.put(key, dataset)
        return dataset

    def put(self, key: str, dataset: xr.Dataset) -> None:
        """Store a dataset under this key; an existing one is replaced.

        Its attributes must be of types of NetCDF: text, numbers, and lists of numbers, not booleans. If the
        file cannot be written, a HaptonicWarning is issued instead of an error, so that the result is not
        lost.

        Raises
        ------
        NumericalError : NaN or infinity in the dataset, see `haptonic.gate`
        """
        passed(dataset)
        # first in memory: HDF5 raises errors of many kinds on a full disk, a plain write only one
        content = io.BytesIO()
        save_dataset(dataset, content)
        self.write(key, content.getbuffer())

    def write(self, key: str, content: bytes | memoryview, kind: str = "nc") -> None:
        """Store the content of a file under this key; an existing one is replaced. See `put` for errors."""
        path = self.path(key, kind)
        digest = hashlib.sha256(content)
        digest.update(bytes.fromhex(key))
        parts = content, bytes.fromhex(key), digest.digest()
        try:
            replace_file(path, lambda temporary: temporary.write_bytes(b"".join(parts)))
            remove_stale(path.parent)
            _make_room(self.root)
        except OSError as error:
            self._warn(error)

    def size(self) -> tuple[int, int]:
        """Number of the stored files, and their bytes."""
        sizes = [about.st_size for every in _stored(self.root).values() for _, about in every]
        return len(sizes), sum(sizes)

    def _try(self) -> None:
        try:
            with draft_for(self.root):
                pass
        except ResourceError as error:
            self._warn(error.__cause__)

    def _warn(self, error: BaseException | None) -> None:
        assert isinstance(error, OSError)
        warnings.warn(
            "results of this run are not stored and will be computed again: the store "
            f"{self.root} cannot be used: {cause_of(error)}. Free or permit that folder, or choose another: "
            "HAPTONIC_STORE=FOLDER haptonic ...",
            HaptonicWarning,
            stacklevel=3,
        )


@cache
def _make_room(root: Path) -> None:
    """Remove the files of each kind that were not used for longest, beyond its limit; once per process."""
    for kind, files in _stored(root).items():
        total = 0
        for path, about in sorted(files, key=lambda file: file[1].st_mtime, reverse=True):
            total += about.st_size
            if total > MOST_BYTES[kind]:
                with suppress(OSError):
                    path.unlink()


def _stored(root: Path) -> dict[str, list[tuple[Path, os.stat_result]]]:
    """Files of a store by kind, with their sizes and times."""
    stored: dict[str, list[tuple[Path, os.stat_result]]] = {kind: [] for kind in MOST_BYTES}
    for path in root.glob("??/*.*"):
        with suppress(OSError):  # another process removed it
            if path.suffix[1:] in stored:
                stored[path.suffix[1:]].append((path, path.stat()))
    return stored


def _fault(content: bytes, key: str) -> str:
    """Fault of a file of the store; "" for a sound file."""
    view = memoryview(content)
    if hashlib.sha256(view[:-DIGEST_BYTES]).digest() != view[-DIGEST_BYTES:]:
        return "was damaged"
    if view[-2 * DIGEST_BYTES : -DIGEST_BYTES] != bytes.fromhex(key):
        return "has another key"
    return ""


def _set_aside(path: Path, fault: str) -> None:
    aside = path.with_name(f"{path.name}.corrupt")
    path.replace(aside)
    warnings.warn(
        f"a stored result {fault} and will be computed again; the file is kept as {aside}",
        HaptonicWarning,
        stacklevel=3,
    )
