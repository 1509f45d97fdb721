"""Arrays that stay in their file until a part of them is asked for."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray


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

    def rows(self, start: int, stop: int) -> NDArray[Any]:
        """Those of the first axis from ``start`` up to ``stop``."""
        with h5py.File(self.path, "r") as file:
            return np.asarray(file[self.name][..., start:stop]).T

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        return np.asarray(self.rows(0, self.shape[0]), dtype=dtype)
