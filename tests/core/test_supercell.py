"""Several pillars in a cell: against the bands of one folded back, and against each other."""

from dataclasses import replace

import numpy as np
import pytest
from strategies import ALUMINIUM, reference_cell

from haptonic.bloch.pencil import bloch_pencil, eigenpairs
from haptonic.bloch.resolution import Resolution
from haptonic.bloch.supercell import Supercell
from haptonic.cell import Pillar, UnitCell
from haptonic.lattice import Lattice
from haptonic.superelement import condense_by_parts

KAPPA = np.array([0.8, -1.9])
RECTANGULAR = UnitCell(Lattice.rectangular(8e-3, 6e-3), 2e-3, ALUMINIUM, Pillar(2.4e-3, 9e-3))


def condensed(cell):
    return condense_by_parts(cell, Resolution(2, 1).plan(cell), measured=False)


def with_height(factor):
    cell = reference_cell()
    return condensed(replace(cell, pillar=replace(cell.pillar, height=factor * cell.pillar.height)))


@pytest.mark.parametrize(("columns", "rows"), [(1, 1), (2, 1), (1, 3), (2, 3)])
@pytest.mark.parametrize("cell", [reference_cell(), RECTANGULAR], ids=["square", "rectangular"])
def test_equal_cells_have_the_bands_of_one_folded_back(cell, columns, rows):
    one = condensed(cell)
    found, _ = Supercell.of([[one] * columns] * rows).eigenpairs(KAPPA, 12)
    steps = [(i, j) for i in range(columns) for j in range(rows)]
    folded = [(KAPPA + 2 * np.pi * np.array(step)) / [columns, rows] for step in steps]
    expected = np.sort(np.concatenate([eigenpairs(bloch_pencil(one), kappa, 12)[0] for kappa in folded]))
    assert found == pytest.approx(expected[:12], rel=1e-8)


def test_a_plate_on_other_pillars_has_three_motions_at_rest():
    supercell = Supercell.of([[with_height(1.0), with_height(0.7)], [with_height(0.9), with_height(1.2)]])
    values, _ = supercell.eigenpairs(np.zeros(2), 5)
    assert (np.abs(values[:3]) < 1e-6 * values[3]).all()


def test_the_first_cell_may_be_any():
    tall, low, other = with_height(1.0), with_height(0.6), with_height(0.8)
    one, shifted = ([[tall, low, other]], [[low, other, tall]])
    expected, _ = Supercell.of(one).eigenpairs(KAPPA, 10)
    assert Supercell.of(shifted).eigenpairs(KAPPA, 10)[0] == pytest.approx(expected, rel=1e-8)
    swapped = Supercell.of([[tall, other, low]]).eigenpairs(KAPPA * [-1, 1], 10)[0]
    assert swapped == pytest.approx(expected, rel=1e-8), "mirror images"


def test_two_heights_open_a_gap_where_folded_bands_crossed():
    """At the edge of the supercell's zone bands of equal cells touch in pairs, others do not."""
    edge = np.array([np.pi, 0.4])
    equal, _ = Supercell.of([[with_height(1.0)] * 2]).eigenpairs(edge, 4)
    unequal, _ = Supercell.of([[with_height(1.0), with_height(0.8)]]).eigenpairs(edge, 4)
    assert equal[1] == pytest.approx(equal[0], rel=1e-8)
    assert unequal[1] > 1.05 * unequal[0]


def test_modes_have_unit_mass_and_solve_the_problem():
    supercell = Supercell.of([[with_height(1.0), with_height(0.8)]])
    values, modes = supercell.eigenpairs(KAPPA, 6)
    K, M = supercell.at(KAPPA)
    assert modes.conj().T @ (M @ modes) == pytest.approx(np.eye(6), abs=1e-8)
    left = np.linalg.norm(K @ modes - (M @ modes) * values, axis=0)
    assert (left < 1e-7 * np.linalg.norm(K @ modes, axis=0)).all()
