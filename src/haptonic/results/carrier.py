"""What results about mirrors share: the condensed cell, kept, and the gap around the carrier."""

from __future__ import annotations

from functools import lru_cache

from haptonic.bloch import Gap, Resolution
from haptonic.cell import UnitCell
from haptonic.errors import StudyError
from haptonic.results.common import Asked
from haptonic.results.runner import Runner
from haptonic.superelement import Superelement, condense
from haptonic.units import format_quantity


@lru_cache(maxsize=2)
def condensed_cell(cell: UnitCell, resolution: Resolution) -> Superelement:
    """The superelement of a cell; kept for the next task of a worker."""
    return condense(cell, resolution.plan(cell), resolution.steps, block=resolution.block, measured=False)


def gap_around(cell: UnitCell, asked: Asked, carrier: float, runner: Runner) -> Gap | None:
    """The complete gap that holds the carrier, or else the widest."""
    gaps = [gap for gap in runner.gaps(cell, asked) if gap.complete and gap.certain]
    holding = [gap for gap in gaps if gap.lower < carrier < gap.upper]
    return max(holding or gaps, key=lambda gap: gap.width, default=None)


def gap_holding(cell: UnitCell, asked: Asked, carrier: float, runner: Runner) -> Gap:
    """The complete gap that holds the carrier.

    Raises
    ------
    StudyError : there is none
    """
    gap = gap_around(cell, asked, carrier, runner)
    if gap is None or not gap.lower < carrier < gap.upper:
        nearest = f"; the widest is {gap.lower / 1e3:.2f} to {gap.upper / 1e3:.2f} kHz" if gap else ""
        raise StudyError(
            argument="carrier",
            given=format_quantity(carrier, "Hz"),
            allowed="a frequency in a complete gap of the cell",
            cause=f"the cell has no such gap there{nearest}",
            next_step="find a cell for this carrier with `haptonic design`",
        )
    return gap
