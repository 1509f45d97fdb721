"""Motions from which interiors start, against Bloch waves whose places are matched by their positions."""

import numpy as np
import pytest
import scipy.linalg as la
from strategies import ALUMINIUM

from daily import daily
from haptonic.bloch import Resolution
from haptonic.bloch.centred import lattice_pencil
from haptonic.bloch.pencil import eigenpairs, hertz
from haptonic.bloch.truncation import largest_truncation
from haptonic.cell import Disc, UnitCell
from haptonic.cell.mesh import trace_shares
from haptonic.cell.sectors import along_sides
from haptonic.lattice import Lattice
from haptonic.superelement import Tiling, condense
from haptonic.superelement.folded import FoldedMesh
from haptonic.superelement.joint import repeated
from haptonic.superelement.standing import standing_motions

MM = 1e-3
SQUARE, TRIANGULAR = Lattice.square(7 * MM), Lattice.triangular(7 * MM)
TURNED = Disc(4 * MM, section="ellipse", length=5 * MM, turn=0.4, empty=True)
CELLS = {
    "square": UnitCell(SQUARE, 2 * MM, ALUMINIUM, disc=(Disc(5 * MM, empty=True),)),
    "triangular": UnitCell(TRIANGULAR, 2 * MM, ALUMINIUM, disc=(Disc(5 * MM, empty=True),)),
    "blind hole": UnitCell(SQUARE, 2 * MM, ALUMINIUM, disc=(Disc(5 * MM, high=0.5 * MM, empty=True),)),
    "two mirrors": UnitCell(
        Lattice.rectangular(7 * MM, 9 * MM), 2 * MM, ALUMINIUM, disc=(Disc(5 * MM, empty=True),)
    ),
    "half-turn": UnitCell(SQUARE, 2 * MM, ALUMINIUM, disc=(TURNED,)),
    "half-turn of a hexagon": UnitCell(TRIANGULAR, 2 * MM, ALUMINIUM, disc=(TURNED,)),
}
COUNT = 12


@pytest.mark.parametrize("name", CELLS)
def test_standing_motions_contain_bloch_waves(name):
    cell = CELLS[name]
    (plan,) = Resolution(3, 0).plans(cell)
    traces, body = FoldedMesh.of(cell, plan).traces, condense(cell, plan, measured=False)
    on_trace = np.s_[: body.trace_size]
    stiffness, mass = (form[on_trace, on_trace] for form in (body.stiffness, body.mass))
    motions = []
    for trace in traces:
        whole = trace.spread.toarray() * trace.images  # fields of the whole trace from the class's unknowns
        motions.append(
            whole @ standing_motions(cell, trace, whole.T @ stiffness @ whole, whole.T @ mass @ whole, COUNT)
        )
    motions = np.hstack(motions)
    assert motions.T @ mass @ motions == pytest.approx(np.eye(motions.shape[1]), abs=1e-6)
    every = ((1, 1), (1, -1), (-1, 1), (-1, -1))
    # mirrors of a hexagon exchange the last two, so no class contains these waves
    for signs in every[:2] if name == "triangular" else every:
        waves = bloch_waves(cell, plan, stiffness, mass, np.array(signs))
        away = waves - motions @ (motions.T @ (mass @ waves))
        # motions of several signs that are alike to 1e-2 are one
        assert np.einsum("ik,ik->k", away, mass @ away).max() < 0.02**2


def bloch_waves(cell, plan, stiffness, mass, signs):
    """(t, 6) lowest waves of unit mass whose displacement has a sign from one cell to the next."""
    places = along_sides(cell.corners, trace_shares(plan))
    master, shift = repeated(places, cell.lattice.vectors)
    phase = (signs.astype(float) ** shift).prod(axis=1)
    on_places = phase[:, None] * (master[:, None] == np.unique(master))
    levels = len(stiffness) // (3 * len(places))
    free = np.kron(np.eye(levels), np.kron(on_places, np.eye(3)))
    return free @ la.eigh(*(free.T @ form @ free for form in (stiffness, mass)), subset_by_index=(0, 5))[1]


def test_a_tile_without_opposite_sides_starts_from_its_free_boundary():
    cell = CELLS["half-turn"]
    (plan,) = Resolution(3, 0).plans(cell)
    trace = FoldedMesh.of(cell, plan).traces[0]
    size = len(trace.kept)
    stiffness = np.diag(np.arange(1.0, size + 1))

    class Kite:
        corners = np.array([(0.0, 0.0), (2.0, 0.0), (2.5, 2.5), (0.0, 2.0)])
        extent = 3.0

    motions = standing_motions(Kite(), trace, stiffness, np.eye(size), 3)
    assert np.abs(motions[3:]).max() < 1e-12


@pytest.mark.parametrize(("diameter", "thickness"), daily([(9.5, 4.0), (7.0, 4.0), (3.0, 8.0)], (3.0, 8.0)))
def test_three_blocks_suffice_around_holes(diameter, thickness):
    """Blocks that start from motions of a free boundary omit up to 2e-3 here."""
    hole = Disc(diameter * MM, empty=True)
    cell = UnitCell(Lattice.square(10 * MM), thickness * MM, ALUMINIUM, disc=(hole,))
    plans = Resolution(3, 1).plans(cell)
    few, many = (Tiling.condensed(cell, plans, *size, measured=False) for size in ((3, 10), (6, 20)))
    estimate, _ = largest_truncation(few, 10)
    assert estimate < 4e-4
    for kappa in cell.zone.triangles(3)[0]:
        ours, finer = (hertz(eigenpairs(lattice_pencil(tiling), kappa, 10)[0]) for tiling in (few, many))
        moving = finer > 1e-3 * finer[-1]
        assert ((ours - finer)[moving] < estimate * finer[moving]).all()
