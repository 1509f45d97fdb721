"""Several pillars in a cell: against the bands of one folded back, and against each other."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from strategies import ALUMINIUM, reference_cell

from daily import daily
from haptonic.bloch.centred import lattice_pencil
from haptonic.bloch.pencil import eigenpairs
from haptonic.bloch.resolution import Resolution, meeting
from haptonic.cell import Pillar, Site, UnitCell
from haptonic.lattice import Lattice
from haptonic.superelement import Tiling

KAPPA = np.array([0.8, -1.9])
RECTANGULAR = UnitCell(Lattice.rectangular(8e-3, 6e-3), 2e-3, ALUMINIUM, Pillar(2.4e-3, 9e-3))
COARSE = Resolution(2, 1)


def rows_of(cell, *rows):
    """A supercell: rows of cells, each with the pillar's height as a multiple of the cell's own."""
    (x, _), (_, y) = cell.lattice.vectors
    count, columns = len(rows), len(rows[0])
    sites = tuple(
        Site(
            at=(i / columns, j / count),
            pillar=replace(cell.pillar, height=height * cell.pillar.height) if height else None,
        )
        for j, row in enumerate(rows)
        for i, height in enumerate(row)
    )
    return replace(cell, lattice=Lattice.rectangular(columns * x, count * y), pillar=None, site=sites)


@cache
def pencil(cell):
    """On the mesh that a pillar has alone, whatever there is beside it."""
    tiles = [placed.tile for placed in cell.tiles]
    plans = meeting(tiles, [COARSE.plan(tile) for tile in tiles])
    return lattice_pencil(Tiling.condensed(cell, plans, 2, 10, measured=False))


def values(cell, kappa, count):
    return eigenpairs(pencil(cell), np.array(kappa), count)[0]


@pytest.mark.parametrize(("columns", "rows"), daily([(1, 1), (2, 1), (1, 3), (2, 3)], (2, 1), (1, 3)))
@pytest.mark.parametrize("cell", [reference_cell(), RECTANGULAR], ids=["square", "rectangular"])
def test_equal_cells_have_the_bands_of_one_folded_back(cell, columns, rows):
    eigenvalues = values(rows_of(cell, *[[1.0] * columns] * rows), tuple(KAPPA), 12)
    steps = [(i, j) for i in range(columns) for j in range(rows)]
    folded = [(KAPPA + 2 * np.pi * np.array(step)) / [columns, rows] for step in steps]
    expected = np.sort(np.concatenate([values(cell, tuple(kappa), 12) for kappa in folded]))
    assert eigenvalues == pytest.approx(expected[:12], rel=1e-8)


def test_a_plate_on_other_pillars_has_three_motions_at_rest():
    eigenvalues = values(rows_of(reference_cell(), [1.0, 0.7], [0.9, 1.2]), (0.0, 0.0), 5)
    assert (np.abs(eigenvalues[:3]) < 1e-6 * eigenvalues[3]).all()


def test_the_first_cell_may_be_any():
    expected = values(rows_of(reference_cell(), [1.0, 0.6, 0.8]), tuple(KAPPA), 10)
    shifted = values(rows_of(reference_cell(), [0.6, 0.8, 1.0]), tuple(KAPPA), 10)
    assert shifted == pytest.approx(expected, rel=1e-8)
    swapped = values(rows_of(reference_cell(), [1.0, 0.8, 0.6]), tuple(KAPPA * [-1, 1]), 10)
    assert swapped == pytest.approx(expected, rel=1e-8), "mirror images"


def test_two_heights_open_a_gap_where_folded_bands_crossed():
    """At the edge of the supercell's zone bands of equal cells touch in pairs, others do not."""
    edge = (np.pi, 0.4)
    equal = values(rows_of(reference_cell(), [1.0, 1.0]), edge, 4)
    unequal = values(rows_of(reference_cell(), [1.0, 0.8]), edge, 4)
    assert equal[1] == pytest.approx(equal[0], rel=1e-8)
    assert unequal[1] > 1.05 * unequal[0]


def test_modes_have_unit_mass_and_solve_the_problem():
    cell = rows_of(reference_cell(), [1.0, 0.6, 0.8])
    eigenvalues, modes = eigenpairs(pencil(cell), KAPPA, 6)
    K, M = pencil(cell).at(KAPPA)
    assert modes.conj().T @ (M @ modes) == pytest.approx(np.eye(6), abs=1e-8)
    left = np.linalg.norm(K @ modes - (M @ modes) * eigenvalues, axis=0)
    assert (left < 1e-7 * np.linalg.norm(K @ modes, axis=0)).all()
