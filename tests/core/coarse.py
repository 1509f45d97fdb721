"""The reference lattice on a coarse mesh, and plain cells that fit to it unknown by unknown."""

from functools import cache

from strategies import reference_cell

from haptonic.bloch.rows import CondensedRows
from haptonic.cell import MeshPlan, Rows
from haptonic.superelement import Superelement, condense


@cache
def lattice() -> Superelement:
    cell = reference_cell()
    return condense(cell, MeshPlan.suited(cell, 3, 1), measured=False)


@cache
def plain() -> Superelement:
    """A cell without its pillar that has the lattice's trace: as many places, as many levels."""
    order = lattice().mesh.topology.plan.order
    plan = MeshPlan(order, 0, 0, outward=3, upward=lattice().levels - 1)
    return condense(reference_cell().without_pillar(), plan, measured=False)


def single(tile: Superelement, along: tuple[int, int] = (0, 1)) -> CondensedRows:
    """Rows of a condensed cell that is a rectangle along x and y."""
    return CondensedRows.joined(Rows(tile.cell, along), {tile.cell: tile})


@cache
def rows(*, pillars: bool = True) -> CondensedRows:
    """Condensed rows along y, of cells with pillars or of plain ones."""
    return single(lattice() if pillars else plain())
