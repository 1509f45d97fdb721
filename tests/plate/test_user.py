"""Somebody who never writes a study file: lattice, tile, tiling, bands, a ribbon and a plate of one cell."""

import numpy as np
import pytest

from haptonic.bloch import Resolution, bloch_pencil
from haptonic.bloch.pencil import eigenpairs, hertz
from haptonic.bloch.ribbon import RibbonModel
from haptonic.cell import MeshPlan, Pillar, Ribbon, UnitCell
from haptonic.lattice import Lattice
from haptonic.materials import material
from haptonic.plate import Band, Fineness, Force, Layout, Plate, PlateModel, modes_between
from haptonic.superelement import Tiling, condense

MM, LOSS = 1e-3, 5e-3
ALUMINIUM = material("aluminium-paper")
CELL = UnitCell(
    Lattice(a1=("7 mm", "0 mm"), a2=("0 mm", "7 mm")), 1.5 * MM, ALUMINIUM, Pillar(3.5 * MM, 6 * MM)
)


@pytest.fixture(scope="module")
def tiling():
    return Tiling.single(condense(CELL, MeshPlan.suited(CELL, 2, 0), 3))


def bands(tiling, kappa, count=8):
    return hertz(eigenpairs(bloch_pencil(tiling), np.array(kappa), count)[0])


def test_bands_of_a_tiling(tiling):
    """A quarter turn takes X to Y, but for what the interior's modes leave out; three motions are at rest."""
    assert tiling.cell.lattice.name == "square"
    assert bands(tiling, (np.pi, 0.0)) == pytest.approx(bands(tiling, (0.0, np.pi)), rel=1e-5)
    assert bands(tiling, (0.0, 0.0))[:3] == pytest.approx(np.zeros(3), abs=50)
    assert bands(tiling, (0.0, 0.0))[3] > 1e3


def test_a_ribbon_of_the_same_cell():
    """At k = 0 a free strip is at rest or fast; at another phase waves run along it."""
    model = RibbonModel.of(Ribbon((CELL, CELL)), Resolution(2, 0))
    assert len(model.frequencies(0.0, 50.0, 1e3)) == 0
    assert len(model.frequencies(1.0, 50.0, 40e3)) > 3


def test_a_plate_of_the_same_cell():
    """What is lost is the loss factor's share, whatever the mode."""
    lines = [tuple(7 * MM * np.arange(n + 1)) for n in (3, 2)]
    layout = Layout((("o", "p", "o"),) * 2, *lines, {"o": CELL}, CELL.thickness, ALUMINIUM)
    plate = Plate(layout, loss_factor=LOSS, forces=(Force("F", (10 * MM, 7 * MM)),))
    coarse = Fineness(along=3, through=2, cell=2, rings=0, plain=3)
    modes = modes_between(Band.of(PlateModel.of(plate, 40e3, coarse), 5e3, 40e3), 5e3, 40e3)
    assert len(modes.frequency) > 3
    assert modes.quality == pytest.approx(np.full(len(modes.frequency), 1 / LOSS), rel=1e-3)
