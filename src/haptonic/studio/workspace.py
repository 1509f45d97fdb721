"""Studies and measured files of one folder, by name; no name and no link leads out of it."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import suppress
from itertools import islice
from pathlib import Path, PurePosixPath, PureWindowsPath

from haptonic.atomic import write_atomically
from haptonic.channels.formats import SUFFIXES
from haptonic.errors import StudyError, shown
from haptonic.paths import LONGEST, inside
from haptonic.study.template import ENDING
from haptonic.study.text_file import LARGEST_FILE, text_of

LONGEST_LIST = 500  # files
DEEPEST = 3  # folders in the name of a measured file
MOST_FILES = 20_000  # of a folder that is analysed


class Workspace:
    """The folder whose studies the page may open and save."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder.resolve()

    def names(self) -> list[str]:
        """Names of the studies, in the order of the alphabet."""
        paths = [path for path in self.folder.glob(f"*{ENDING}") if path.is_file() and self._is_here(path)]
        return sorted(path.name for path in paths)[:LONGEST_LIST]

    def read(self, name: object) -> str:
        """Text of a study.

        Raises
        ------
        HaptonicError : not a name in this folder, or a file that cannot be read
        """
        return text_of(self._path(name))

    def write(self, name: object, text: str) -> str:
        """Write a study and return the name of its file.

        Raises
        ------
        HaptonicError : not a name in this folder, a text that is too long, or a file that cannot be written
        """
        path = self._path(name)
        content = text.encode("utf-8", "replace")
        if len(content) > LARGEST_FILE:
            raise StudyError.too_large(
                argument="text of the study",
                given=f"{len(content)} bytes",
                allowed=f"at most {LARGEST_FILE} bytes",
                cause="the text is not that of a study",
                next_step="shorten it",
            )
        write_atomically(path, lambda draft: draft.write_bytes(content))
        return path.name

    def measured(self) -> list[str]:
        """Names of files and folders that may contain measurements, in the order of the alphabet."""
        names = set[str]()
        for path in islice(self._files(self.folder, DEEPEST), MOST_FILES):
            name = path.relative_to(self.folder)
            if path.suffix.lower() in SUFFIXES:
                names |= {name.as_posix(), *(parent.as_posix() for parent in name.parents)}
        return sorted(names - {"."}, key=lambda name: (name.count("/"), name))[:LONGEST_LIST]

    def _files(self, folder: Path, depth: int) -> Iterator[Path]:
        """Files of a folder and of those in it; links are left out."""
        ordered: list[os.DirEntry[str]] = []
        with suppress(OSError), os.scandir(folder) as entries:  # removed, or not to be read
            ordered = sorted(entries, key=lambda entry: entry.name)
        for entry in ordered:
            if entry.name.startswith(".") or entry.is_symlink():
                continue
            if entry.is_file():
                yield Path(entry.path)
            elif depth > 1 and entry.is_dir():
                yield from self._files(Path(entry.path), depth - 1)

    def measurement(self, name: object) -> Path:
        """Path of a file or folder of measurements, or of a study, to be read.

        Raises
        ------
        StudyError : a name that leads out of the folder, or a folder with a link in it that does
        """
        path = self.place(name)
        here = [path, *islice(path.rglob("*"), MOST_FILES)] if path.is_dir() else [path]
        if len(here) > MOST_FILES:
            raise _refused_file(name, f"the folder contains {MOST_FILES} files or more")
        if not all(each.resolve().is_relative_to(self.folder) for each in here):
            raise _refused_file(name, "it is, or contains, a link that leads out of the folder")
        return path

    def place(self, name: object) -> Path:
        """Path for a measured file, whose name may contain folders.

        Raises
        ------
        StudyError : a name that leads out of the folder, or that of a hidden file
        """
        parts = name.split("/") if isinstance(name, str) else []
        plain = all(part == PureWindowsPath(part).name and not part.startswith(".") for part in parts)
        if not parts or not plain or not all(parts) or any(not part.isprintable() for part in parts):
            raise _refused_file(
                name, "it is empty, begins with a dot, or has a step upwards or a drive in it"
            )
        if len(parts) > DEEPEST or any(len(os.fsencode(part)) > LONGEST for part in parts):
            raise _refused_file(name, "it is too long, or in too many folders")
        path = self.folder.joinpath(*PurePosixPath(*parts).parts)
        if not path.parent.resolve().is_relative_to(self.folder):
            raise _refused_file(name, "a link in it leads out of the folder")
        return path

    def _path(self, name: object) -> Path:
        def refused(cause: str) -> StudyError:
            return StudyError.forbidden(
                argument="name of the file",
                given=shown(name),
                allowed=f"a name without folders that ends with {ENDING}",
                cause=cause,
                next_step=f'choose a name such as "my{ENDING}"',
            )

        if not isinstance(name, str) or not name.endswith(ENDING) or name.startswith("."):
            raise refused(f"it does not end with {ENDING}, or it begins with a dot")
        path = inside(self.folder, name)
        if not self._is_here(path):
            raise refused("it is a link that leads out of the folder")
        return path

    def _is_here(self, path: Path) -> bool:
        return path.resolve().parent == self.folder


def _refused_file(name: object, cause: str) -> StudyError:
    return StudyError.forbidden(
        argument="name of the file",
        given=shown(name, 200),
        allowed=f"the name of a file in the folder of the studio, in at most {DEEPEST - 1} folders",
        cause=cause,
        next_step="copy the file into the folder, and give its name",
    )
