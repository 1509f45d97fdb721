"""Results on disk, found again by what made them.

A result is filed under the SHA-256 of its inputs and of the code that computed it (``content_key``). So a run
that was killed goes on where it was, a run that was done is instant, and a result is never taken from code
that has changed since. A file appears whole or not at all: it is written under a temporary name, brought to
the disk, then renamed.
"""

from __future__ import annotations

import errno
import hashlib
import io
import json
import os
import re
import secrets
import shutil
import time
import warnings
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass, fields, is_dataclass
from enum import Enum
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import platformdirs
import scipy

from haptonic.errors import HaptonicWarning, ResourceError
from haptonic.gate import passed
from haptonic.later import xarray as xr
from haptonic.paths import target

# Parts of the package that show or compare results but do not make them.
SHOWING = frozenset({"cli", "plots", "report", "verification", "workshop"})

DIGEST_BYTES = hashlib.sha256().digest_size
STALE_SECONDS = 24 * 3600.0
TEMPORARY = ".haptonic-"

_KEY = re.compile(r"[0-9a-f]{64}")

_CAUSES = {
    errno.ENOSPC: "the disk is full",
    errno.EDQUOT: "your share of the disk is used up",
    errno.EFBIG: "the file is larger than the system lets you write",
    errno.EACCES: "you may not write there",
    errno.EPERM: "you may not write there",
    errno.EROFS: "the disk can only be read",
    errno.ENOTDIR: "a part of the path is a file, not a folder",
    errno.EEXIST: "a part of the path is a file, not a folder",
    errno.EISDIR: "there is a folder of that name",
    errno.ENAMETOOLONG: "the name is too long",
}


@cache
def fingerprint() -> str:
    """Hash of the code that computes: the package's numerical source and the versions of numpy and scipy.

    Read once per process.
    """
    return _fingerprint(Path(__file__).parent, {"numpy": np.__version__, "scipy": scipy.__version__})


def _fingerprint(package: Path, versions: Mapping[str, str]) -> str:
    digest = hashlib.sha256(json.dumps(versions, sort_keys=True).encode())
    files = {
        path.relative_to(package): path for path in package.rglob("*") if path.suffix in (".py", ".toml")
    }
    for name in sorted(files, key=lambda name: name.as_posix()):
        if name.parts[0].removesuffix(".py") not in SHOWING:
            content = files[name].read_bytes()
            digest.update(f"\n{name.as_posix()} {len(content)}\n".encode())
            digest.update(content)
    return digest.hexdigest()


def content_key(inputs: Mapping[str, object]) -> str:
    """Key of a result: SHA-256 (64 hexadecimal digits) of its inputs and of ``fingerprint()``.

    ``inputs`` must hold everything that the result depends on, the kind of computation included: the frozen
    values themselves, not chosen fields of theirs, so that a new field changes the key; see `canonical`.
    """
    text = json.dumps(canonical(dict(inputs)), separators=(",", ":"))
    return hashlib.sha256(f"{fingerprint()}\n{text}".encode()).hexdigest()


def canonical(value: object, where: str = "inputs") -> list[Any]:
    """Nested lists of JSON types that are equal for equal values only, each led by what kind of value it is.

    Knows dataclasses (their type and every field), text, numbers (floats bit by bit, NaN apart), None, enums,
    arrays, bytes, sequences, mappings and sets. The order of mappings and sets does not matter; 1 and 1.0 are
    different; a list and a tuple are the same, as are a number of numpy and that number.
    """
    if isinstance(value, np.generic):
        value = value.item()
    match value:
        case Enum():
            return ["enum", _type_of(value), value.name]
        case None | bool() | int() | str():
            return [type(value).__name__, value]
        case float():
            return ["float", value.hex()]  # a repr would do as well; this one needs no rounding to be read
        case complex():
            return ["complex", value.real.hex(), value.imag.hex()]
        case bytes():
            return ["bytes", value.hex()]
        case np.ndarray():
            assert value.dtype != object, f"{where}: an array of objects cannot name a result"
            return ["array", value.dtype.str, list(value.shape), value.tobytes().hex()]
        case list() | tuple():
            return ["list", *(canonical(one, f"{where}[{i}]") for i, one in enumerate(value))]
        case set() | frozenset():
            return ["set", *sorted((canonical(one, where) for one in value), key=json.dumps)]
        case Mapping():
            pairs = [[canonical(k, where), canonical(one, f"{where}.{k}")] for k, one in value.items()]
            return ["mapping", *sorted(pairs, key=json.dumps)]
    has_fields = is_dataclass(value) and not isinstance(value, type)
    assert has_fields, f"{where}: {type(value).__name__} has no fields that could name a result"
    names = [one.name for one in fields(value)]  # type: ignore[arg-type]  # it is a dataclass, see above
    held = [[name, canonical(getattr(value, name), f"{where}.{name}")] for name in names]
    return ["value", _type_of(value), *held]


def _type_of(value: object) -> str:
    return f"{type(value).__module__}.{type(value).__qualname__}"


@dataclass(frozen=True)
class Store:
    """Datasets in files below ``root``, each named by its ``content_key``.

    A file is NetCDF (HDF5), followed by its key and by the SHA-256 of all that comes before that. NetCDF
    readers ignore the addition; ``get`` uses it to recognise a file that was damaged or is another key's.
    """

    root: Path

    @classmethod
    def default(cls) -> Store:
        """The folder named by ``$HAPTONIC_STORE``, else this user's cache folder.

        Raises
        ------
        ResourceError : that variable names no possible folder
        """
        chosen = os.environ.get("HAPTONIC_STORE")
        root = (
            target(chosen, "HAPTONIC_STORE")
            if chosen
            else platformdirs.user_cache_path("haptonic", appauthor=False)
        )
        return cls(root.absolute())

    def path(self, key: str) -> Path:
        """Where the result of this key is or would be."""
        assert _KEY.fullmatch(key), f"{key!r} does not come from content_key"
        return self.root / key[:2] / f"{key}.nc"

    def __contains__(self, key: str) -> bool:
        """Whether there is a file for this key; only ``get`` finds out whether it is sound."""
        return self.path(key).is_file()

    def get(self, key: str) -> xr.Dataset | None:
        """The dataset of this key, in memory; None when there is none.

        A file that is damaged or holds the result of another key counts as none: it is renamed to
        ``<name>.corrupt`` and a HaptonicWarning says so. A HaptonicWarning also says, before anybody computes
        what was not found, that nothing can be kept here.
        """
        path = self.path(key)
        try:
            content = path.read_bytes()
            if fault := _fault(content, key):
                _set_aside(path, fault)
                return None
        except FileNotFoundError:
            self._try()
            return None
        except OSError as error:
            self._warn(error)
            return None
        # A quantity whose unit is the second stays a number instead of becoming a timedelta.
        return xr.load_dataset(io.BytesIO(content), engine="h5netcdf", decode_timedelta=False)

    def kept(self, question: Mapping[str, object], make: Callable[[], xr.Dataset]) -> xr.Dataset:
        """What answers a question, all of which becomes its key; it is made if it is not here yet."""
        key = content_key(question)
        found = self.get(key)
        if found is None:
            found = make()
            self.put(key, found)
        return found

    def put(self, key: str, dataset: xr.Dataset) -> None:
        """Keep a dataset under this key, in place of one that is there.

        Its attributes must be ones that NetCDF knows: text, numbers, and lists of numbers, not booleans. If
        it cannot be written, a HaptonicWarning says so: a result is worth more than its copy.

        Raises
        ------
        NumericalError : a number in it is none, see `haptonic.gate`
        """
        path = self.path(key)
        passed(dataset)
        # Made in memory first: HDF5 reports a full disk by errors of many kinds, a plain write by one.
        content = io.BytesIO()
        dataset.to_netcdf(content, engine="h5netcdf")
        content.seek(0, io.SEEK_END)
        content.write(bytes.fromhex(key))
        content.write(hashlib.sha256(content.getbuffer()).digest())
        try:
            _replace(path, lambda temporary: temporary.write_bytes(content.getbuffer()))
            _remove_stale(path.parent)
        except OSError as error:
            self._warn(error)

    def _try(self) -> None:
        try:
            with draft_for(self.root):
                pass
        except ResourceError as error:
            self._warn(error.__cause__)

    def _warn(self, error: BaseException | None) -> None:
        assert isinstance(error, OSError)
        warnings.warn(
            "results of this run are not kept, and are computed again the next time: the results store "
            f"{self.root} cannot be used: {_cause(error)}. Free or permit that folder, or name another one: "
            "HAPTONIC_STORE=FOLDER haptonic ...",
            HaptonicWarning,
            stacklevel=3,
        )


def write_atomically(path: Path, writer: Callable[[Path], object]) -> None:
    """Write a file so that it appears whole or not at all; missing folders are made.

    ``writer`` is given a temporary path in the same folder and with the same suffix, and writes that. When
    it fails, nothing is left behind and a file that was there before is untouched.

    Raises
    ------
    ResourceError : the folder cannot be made or written, or the disk is full
    """
    try:
        _replace(path, writer)
    except OSError as error:
        raise _unwritable(path, error) from error


@contextmanager
def whole_set(folder: Path, *, overwrite: bool) -> Iterator[Path]:
    """A new empty folder to write files into, which come to stand in ``folder`` when the block ends well.

    If it does not end well, none of them is there, and ``folder`` is as it was. Two processes that write
    into the same folder do not meet before the files are renamed.

    Raises
    ------
    ResourceError : a name is taken, the folder cannot be made or written, or the disk is full
    """
    with draft_for(folder) as (draft, _):
        with _asked_for(folder, draft):
            yield draft
        files = sorted(path.relative_to(draft) for path in draft.rglob("*") if path.is_file())
        for name in files:
            refuse_overwrite(folder / name, overwrite)
        for name in files:
            try:
                (folder / name).parent.mkdir(parents=True, exist_ok=True)
                (draft / name).replace(folder / name)
            except OSError as error:
                raise _unwritable(folder / name, error) from error


@contextmanager
def _asked_for(path: Path, made: Path) -> Iterator[None]:
    """Errors tell of the path that was asked for, not of what was made in its place."""
    try:
        yield
    except ResourceError as error:
        raise error.changed(ResourceError, given=error.given.replace(str(made), str(path))) from error


@contextmanager
def draft_for(folder: Path) -> Iterator[tuple[Path, Path]]:
    """An empty folder on the disk where ``folder`` is or would be, gone after the block; then what of the
    path of ``folder`` is not there yet.

    Its name is its own and no other folder is made, so runs at the same time do not meet.

    Raises
    ------
    ResourceError : nothing can be written there
    """
    whole = folder.absolute()
    try:
        there = next(one for one in (whole, *whole.parents) if one.exists())
        _remove_stale(there)
        draft = there / f"{TEMPORARY}{secrets.token_hex(8)}.tmp"
        draft.mkdir()
    except OSError as error:
        raise _unwritable(folder, error) from error
    try:
        yield draft, whole.relative_to(there)
    finally:
        shutil.rmtree(draft, ignore_errors=True)


def _unwritable(path: Path, error: OSError) -> ResourceError:
    return ResourceError.unwritable(
        argument="output file",
        given=path,
        allowed="a file in a folder that can be written, with room for it",
        cause=_cause(error),
        next_step="choose another folder for the output (--out DIR), or make this one writable",
    )


def refuse_overwrite(path: Path, overwrite: bool) -> None:
    """Raise ResourceError if something of that name exists and was not asked to be replaced."""
    if path.is_dir():
        raise _unwritable(path, IsADirectoryError(errno.EISDIR, ""))
    if os.path.lexists(path) and not overwrite:
        raise ResourceError.repeated(
            argument="output file",
            given=path,
            allowed="a name that is not taken, unless overwriting was asked for",
            cause="an earlier run wrote it",
            next_step="choose another folder (--out DIR), or replace what is there: --overwrite, or "
            "overwrite=True in Python",
        )


def _replace(path: Path, writer: Callable[[Path], object]) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    # Not tempfile: its files are for their owner only, and results follow the umask like any other file.
    temporary = path.parent / f"{TEMPORARY}{secrets.token_hex(8)}.tmp{path.suffix}"
    try:
        with _asked_for(path, temporary):
            writer(temporary)
        assert temporary.exists(), f"the writer of {path.name} wrote nothing"
        with temporary.open("rb+") as written:
            os.fsync(written.fileno())
        temporary.replace(path)
    finally:
        temporary.unlink(missing_ok=True)


def _remove_stale(folder: Path) -> None:
    """Remove what killed runs left; what is younger than a day may be another run's work in progress."""
    for leftover in folder.glob(f"{TEMPORARY}*.tmp*"):
        with suppress(OSError):  # gone meanwhile, or somebody else's: not a reason to fail
            if time.time() - leftover.stat().st_mtime > STALE_SECONDS:
                shutil.rmtree(leftover) if leftover.is_dir() else leftover.unlink()


def _fault(content: bytes, key: str) -> str:
    """What is wrong with a file of the store; "" if nothing is."""
    view = memoryview(content)
    if hashlib.sha256(view[:-DIGEST_BYTES]).digest() != view[-DIGEST_BYTES:]:
        return "was damaged"
    if view[-2 * DIGEST_BYTES : -DIGEST_BYTES] != bytes.fromhex(key):
        return "is that of another question"
    return ""


def _set_aside(path: Path, fault: str) -> None:
    aside = path.with_name(f"{path.name}.corrupt")
    path.replace(aside)
    warnings.warn(
        f"a stored result {fault} and will be computed again; the file is kept as {aside}",
        HaptonicWarning,
        stacklevel=3,
    )


def _cause(error: OSError) -> str:
    known = _CAUSES.get(error.errno or 0)
    return known or error.strerror or str(error)
