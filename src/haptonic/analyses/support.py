"""What of a cell an analysis supports.

Every analysis says so by a function of the cell and its options: None, or the error with which it refuses.
`Analysis.admit` asks it before any work starts, for every command, method and report alike. So each analysis
answers for a new feature of a cell or refuses it.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from haptonic.cell import UnitCell
from haptonic.errors import HaptonicError

Supports = Callable[[UnitCell, Any], HaptonicError | None]


def every_cell(cell: UnitCell, options: Any) -> HaptonicError | None:
    """None: every outline, material, lattice and face of a cell is supported, as its mesh is."""
    return None


def no_cell(cell: UnitCell, options: Any) -> HaptonicError | None:
    """None: the answer does not depend on a cell."""
    return None
