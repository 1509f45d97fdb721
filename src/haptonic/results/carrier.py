"""What results about mirrors share: the condensed cell, kept, and the gap around the carrier."""

from __future__ import annotations

from functools import lru_cache

from haptonic.bloch import Gap, Resolution, gaps_of
from haptonic.cell import UnitCell
from haptonic.jobs import Task
from haptonic.results.common import Asked, key_of
from haptonic.results.runner import Runner
from haptonic.results.sweeps import design_gaps
from haptonic.superelement import Superelement, condense


@lru_cache(maxsize=2)
def condensed_cell(cell: UnitCell, resolution: Resolution) -> Superelement:
    """The superelement of a cell; kept for the next task of a worker."""
    return condense(cell, resolution.plan(cell), resolution.steps, block=resolution.block, measured=False)


def gap_around(cell: UnitCell, asked: Asked, carrier: float, runner: Runner) -> Gap | None:
    """The complete gap that holds the carrier, or else the widest."""
    (dataset,) = runner.run(design_gaps, [Task({"kind": "gaps", **key_of(cell, asked)}, (cell, asked))], 0)
    gaps = [gap for gap in gaps_of(dataset) if gap.complete and gap.certain]
    holding = [gap for gap in gaps if gap.lower < carrier < gap.upper]
    return max(holding or gaps, key=lambda gap: gap.width, default=None)
