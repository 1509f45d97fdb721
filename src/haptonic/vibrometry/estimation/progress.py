"""Results of an estimation that grow point by point, in memory or in a folder from which it can continue."""

from __future__ import annotations

import json
import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from haptonic.errors import ScanError

PROGRESS = "progress.json"
SECONDS = 5.0  # between two savings: each writes all changed pages to the disk


@dataclass(eq=False)
class Growing:
    """Arrays that are filled portion by portion; ``done`` counts the filled points.

    response : (line, point)
    coherence : (line, point)
    measures : (point, 3)
    """

    response: NDArray[Any]
    coherence: NDArray[Any]
    measures: NDArray[np.float64]
    done: int
    folder: Path | None
    key: str
    kept_at: float = field(init=False, default_factory=time.monotonic)

    def keep(self, *, now: bool = False) -> None:
        """Write filled arrays to the disk, then the count, every few seconds; a kill loses no more."""
        if self.folder is None or not (now or time.monotonic() - self.kept_at > SECONDS):
            return
        for array in (self.response, self.coherence, self.measures):
            if isinstance(array, np.memmap):
                array.flush()
        temporary = self.folder / f"{PROGRESS}.tmp"
        temporary.write_text(json.dumps({"key": self.key, "done": self.done}))
        temporary.replace(self.folder / PROGRESS)
        self.kept_at = time.monotonic()


def growing(shape: tuple[int, int], single: bool, key: Mapping[str, Any], folder: Path | None) -> Growing:
    """Arrays for an estimation of ``shape`` (line, point), continued from a folder with the same estimation.

    Raises
    ------
    ScanError : the folder has another estimation, or cannot be used
    """
    forms: dict[str, tuple[tuple[int, int], DTypeLike]] = {
        "response": (shape, np.complex64 if single else np.complex128),
        "coherence": (shape, np.float32 if single else np.float64),
        "measures": ((shape[1], 3), np.float64),
    }
    text = json.dumps(key, sort_keys=True)
    if folder is None:
        arrays: dict[str, NDArray[Any]] = {
            name: np.zeros(form, dtype=kind) for name, (form, kind) in forms.items()
        }
        return Growing(**arrays, done=0, folder=None, key=text)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        done = _done(folder, text)
        mode = "r+" if done else "w+"
        maps: dict[str, NDArray[Any]] = {
            name: np.lib.format.open_memmap(
                folder / f"{name}.npy", mode=mode, dtype=np.dtype(kind), shape=form if mode == "w+" else None
            )
            for name, (form, kind) in forms.items()
        }
    except (OSError, ValueError, KeyError) as error:
        raise _unusable(folder, f"it cannot be read or written ({error})") from error
    if any(maps[name].shape != form for name, (form, _) in forms.items()):
        raise _unusable(folder, "its arrays have another shape")
    return Growing(**maps, done=done, folder=folder, key=text)


def _done(folder: Path, key: str) -> int:
    record = folder / PROGRESS
    if not record.exists():
        if any(folder.iterdir()) and not (folder / "response.npy").exists():
            raise _unusable(folder, "it contains other files")
        return 0
    state = json.loads(record.read_text())
    if state["key"] != key:
        raise _unusable(folder, "it contains the estimation of another scan, or with other settings")
    return int(state["done"])


def _unusable(folder: Path, cause: str) -> ScanError:
    return ScanError.conflict(
        argument="state",
        given=str(folder),
        allowed="an empty folder, or one in which the same estimation was stopped",
        cause=cause,
        next_step="name another folder, or remove this one",
    )
