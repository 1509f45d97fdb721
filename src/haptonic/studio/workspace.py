"""Study files of one folder, by name; no name and no link leads out of it."""

from __future__ import annotations

from pathlib import Path

from haptonic.atomic import write_atomically
from haptonic.errors import StudyError, shown
from haptonic.paths import inside
from haptonic.study import ENDING
from haptonic.study.loading import LARGEST_FILE, text_of

LONGEST_LIST = 500  # files


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
