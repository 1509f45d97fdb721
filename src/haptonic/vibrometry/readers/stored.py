"""Arrays that stay in their file until a part of them is asked for."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.errors import ScanError
from haptonic.foreign.process import ForeignError, ask


@dataclass(frozen=True, eq=False)
class Stored:
    """A large real variable of a MATLAB file of version 7.3, its axes in MATLAB's order.

    Variables of version 5 are compressed as a whole and cannot be read in parts.
    """

    path: Path
    name: str
    shape: tuple[int, ...]

    @property
    def ndim(self) -> int:
        return len(self.shape)

    @property
    def size(self) -> int:
        return math.prod(self.shape)

    def rows(self, start: int, stop: int) -> NDArray[Any]:
        """Those of the first axis from ``start`` up to ``stop``.

        Raises
        ------
        ScanError : they cannot be read
        """
        try:
            (part,) = ask("hdf5.rows", self.path, names=[self.name], start=start, stop=stop, last=True)
        except ForeignError as error:
            raise damaged_matlab(self.path, error) from error
        return np.asarray(part).T

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        return np.asarray(self.rows(0, self.shape[0]), dtype=dtype)


def damaged_matlab(path: Path, error: ForeignError) -> ScanError:
    """The error for a MATLAB file that cannot be read."""
    return ScanError(
        argument="MATLAB file",
        given=f"{path} ({error})",
        allowed="a whole .mat file of version 5 (save -v7) or 7.3 (save -v7.3)",
        cause="the file is text, or damaged: a copy was interrupted",
        next_step="save it again in MATLAB: save scan.mat -v7",
    )
