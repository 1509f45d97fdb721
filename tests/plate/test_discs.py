"""Plates whose lattice has discs: against plates of pillars, and by their mass."""

import math
from dataclasses import replace

import full
import numpy as np
import pytest
import scipy.linalg as la
from small import LOSS, drawn
from whole import lossless

from bricks import ALUMINIUM, PITCH, THICKNESS
from daily import daily
from haptonic.cell import Disc, MeshPlan, Pillar, UnitCell
from haptonic.lattice import Lattice
from haptonic.materials import material
from haptonic.plate.body.model import Fineness, PlateModel
from haptonic.plate.body.unreduced import body_of_brick
from haptonic.plate.layout.parts import Plate
from haptonic.plate.layout.supports import Support

MM, HZ = 1e-3, 2 * np.pi
SAME = Fineness(along=4, through=2, cell=2, rings=0, plain=3)
STEEL = material("steel")


def cell(*discs, pillar=None):
    return UnitCell(Lattice.square(PITCH), THICKNESS, ALUMINIUM, pillar, disc=discs)


CAP = cell(Disc(2.5 * MM, low=0.0, high=3 * MM), Disc(4.5 * MM, low=3 * MM, high=4 * MM))
CELLS = {
    "blind hole": (cell(Disc(4 * MM, low=-1 * MM, empty=True)), -ALUMINIUM.density * 1 * MM),
    "inclusion": (cell(Disc(4 * MM, material=STEEL)), (STEEL.density - ALUMINIUM.density) * THICKNESS),
    "cone": (
        cell(Disc(4 * MM, low=-1 * MM, draft=math.atan(1.0), empty=True)),
        -ALUMINIUM.density * 7 / 12 * MM,  # from 4 mm to 2 mm
    ),
}


@pytest.mark.parametrize("name", CELLS)
def test_mass_of_a_brick_is_that_of_its_solid(name):
    unit_cell, more = CELLS[name]
    body = body_of_brick(unit_cell, MeshPlan.suited(unit_cell, 4, 1), (0.0, PITCH), (0.0, PITCH))
    whole = ALUMINIUM.density * PITCH**2 * THICKNESS + more * np.pi * (2 * MM) ** 2
    assert body.mass[::3].sum() == pytest.approx(whole, rel=1e-6)


def small_plate(of_lattice):
    """A row of two cells with a plain tile between them, clamped on the left."""
    layout = replace(drawn("o1o"), cells={"o": of_lattice})
    return Plate(layout, supports=(Support("left", "clamped"),), loss_factor=LOSS)


LATTICES = {name: unit_cell for name, (unit_cell, _) in CELLS.items()} | {"cap": CAP}


@pytest.mark.parametrize("name", daily(LATTICES, "blind hole"))
def test_modes_are_those_of_the_whole_plate(name):
    """Against one mesh of which nothing is reduced."""
    plate = small_plate(LATTICES[name])
    exact = full.frequencies(full.full(plate, 2, 0, 3), 8, 10e3)
    model = PlateModel.of(plate, 80e3, SAME)
    window = (HZ * 0.99 * exact[0]) ** 2, (HZ * 1.003 * exact[-1]) ** 2
    modes = np.sqrt(la.eigh(*lossless(model), eigvals_only=True, subset_by_value=window)) / HZ
    assert len(modes) == len(exact)
    assert modes == pytest.approx(exact, rel=1e-4)


@pytest.mark.nightly
def test_a_disc_on_the_plate_is_a_pillar():
    pillar, disc = cell(pillar=Pillar(3 * MM, 4 * MM)), cell(Disc(3 * MM, low=0.0, high=4 * MM))
    of_pillar, of_disc = (
        full.frequencies(full.full(small_plate(each), 3, 1, 4), 6, 10e3) for each in (pillar, disc)
    )
    assert of_pillar == pytest.approx(of_disc, rel=3e-3)
