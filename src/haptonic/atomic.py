"""Files that are complete or absent: written under a temporary name, flushed to the disk, then renamed."""

from __future__ import annotations

import errno
import os
import secrets
import shutil
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from haptonic.errors import ResourceError

STALE_SECONDS = 24 * 3600.0
TEMPORARY = ".haptonic-"

_CAUSES = {
    errno.ENOSPC: "the disk is full",
    errno.EDQUOT: "your disk quota is used up",
    errno.EFBIG: "the file is larger than the system lets you write",
    errno.EACCES: "you have no permission to write there",
    errno.EPERM: "you have no permission to write there",
    errno.EROFS: "the disk is read-only",
    errno.ENOTDIR: "a part of the path is a file, not a folder",
    errno.EEXIST: "a part of the path is a file, not a folder",
    errno.EISDIR: "a folder of this name exists",
    errno.ENAMETOOLONG: "the name is too long",
}


def write_atomically(path: Path, writer: Callable[[Path], object]) -> None:
    """Write a file that is complete or absent; missing folders are created.

    ``writer`` writes to a temporary path in the same folder with the same suffix. If it fails, no file is
    left and an existing file is not changed.

    Raises
    ------
    ResourceError : the folder cannot be created or written, or the disk is full
    """
    try:
        replace_file(path, writer)
    except OSError as error:
        raise _unwritable(path, error) from error


@contextmanager
def whole_set(folder: Path, *, overwrite: bool) -> Iterator[Path]:
    """A new empty folder for files, which are moved to ``folder`` at the end of the block.

    If the block fails, no file is moved, and ``folder`` is not changed. Two processes that write into the
    same folder do not interfere until their files are renamed.

    Raises
    ------
    ResourceError : a name is taken, the folder cannot be created or written, or the disk is full
    """
    with draft_for(folder) as (draft, _):
        with _errors_for(folder, draft):
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
def _errors_for(path: Path, temporary: Path) -> Iterator[None]:
    """Replace a temporary path in errors by the path that the user gave."""
    try:
        yield
    except ResourceError as error:
        raise error.changed(ResourceError, given=error.given.replace(str(temporary), str(path))) from error


@contextmanager
def draft_for(folder: Path) -> Iterator[tuple[Path, Path]]:
    """A temporary empty folder on the disk of ``folder``, and the part of its path that does not exist yet.

    The name of the temporary folder is random and no other folder is created, so parallel runs do not
    interfere.

    Raises
    ------
    ResourceError : the place cannot be written
    """
    whole = folder.absolute()
    try:
        existing = next(parent for parent in (whole, *whole.parents) if parent.exists())
        remove_stale(existing)
        draft = existing / f"{TEMPORARY}{secrets.token_hex(8)}.tmp"
        draft.mkdir()
    except OSError as error:
        raise _unwritable(folder, error) from error
    try:
        yield draft, whole.relative_to(existing)
    finally:
        shutil.rmtree(draft, ignore_errors=True)


def _unwritable(path: Path, error: OSError) -> ResourceError:
    return ResourceError.unwritable(
        argument="output file",
        given=path,
        allowed="a file in a folder that can be written, with room for it",
        cause=cause_of(error),
        next_step="choose another folder for the output (--out DIR), or make this one writable",
    )


def refuse_overwrite(path: Path, overwrite: bool) -> None:
    """Raise ResourceError if the path exists and may not be overwritten."""
    if path.is_dir():
        raise _unwritable(path, IsADirectoryError(errno.EISDIR, ""))
    if os.path.lexists(path) and not overwrite:
        raise ResourceError.repeated(
            argument="output file",
            given=path,
            allowed="a name that is not taken, unless files may be overwritten",
            cause="an earlier run wrote it",
            next_step="choose another folder (--out DIR), or replace the files: --overwrite, or "
            "overwrite=True in Python",
        )


def replace_file(path: Path, writer: Callable[[Path], object]) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    # not tempfile: its files are private to their owner, but results should follow the umask
    temporary = path.parent / f"{TEMPORARY}{secrets.token_hex(8)}.tmp{path.suffix}"
    try:
        with _errors_for(path, temporary):
            writer(temporary)
        assert temporary.exists(), f"the writer of {path.name} wrote nothing"
        with temporary.open("rb+") as content:
            os.fsync(content.fileno())
        temporary.replace(path)
    finally:
        temporary.unlink(missing_ok=True)


def remove_stale(folder: Path) -> None:
    """Remove leftovers of killed runs; younger ones than a day may belong to a running one."""
    for leftover in folder.glob(f"{TEMPORARY}*.tmp*"):
        with suppress(OSError):  # already removed, or the file of another user
            if time.time() - leftover.stat().st_mtime > STALE_SECONDS:
                shutil.rmtree(leftover) if leftover.is_dir() else leftover.unlink()


def cause_of(error: OSError) -> str:
    cause = _CAUSES.get(error.errno or 0)
    return cause or error.strerror or str(error)
