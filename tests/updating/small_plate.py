"""A small plate on springs with a force, quick to compute, and simulated measurements of it."""

from functools import cache

import numpy as np

from haptonic.cell import Pillar, UnitCell
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial
from haptonic.plate import Fineness, Force, Layout, Plate, Support
from haptonic.plate.layout.sampling import grid_points
from haptonic.plate.vibration.responses import responded
from haptonic.updating.fit import SmallModel
from haptonic.updating.match import MeasuredResponse, Unknown
from haptonic.updating.parameters import changed

YOUNG, LOSS, EDGES = "material.youngs_modulus", "plate.loss_factor", "plate.edges.spring"
ALUMINIUM = IsotropicMaterial(youngs_modulus=70e9, poisson_ratio=0.33, density=2700.0, name="aluminium")
COARSE = Fineness(along=2, through=2, cell=2, rings=0, plain=2)
LINES = np.linspace(1e3, 30e3, 146)
UNKNOWNS = (Unknown(YOUNG, 63e9, 77e9), Unknown(LOSS, 2e-3, 2e-2), Unknown(EDGES, 3e10, 3e12))


def plate(springs=3e11, drive=(16e-3, 5e-3)):
    """12 x 20 mm of plain plate and a column of lattice, on springs at its left edge."""
    cell = UnitCell(Lattice.square(7e-3), 1.5e-3, ALUMINIUM, Pillar(3.5e-3, 10e-3))
    tiles = (("p", "p", "o"), ("p", "p", "o"))
    x, y = (0.0, 7e-3, 14e-3, 21e-3), (0.0, 7e-3, 14e-3)
    return Plate(
        Layout(tiles, x, y, {"o": cell}, 1.5e-3, ALUMINIUM),
        supports=(Support("left", "spring", stiffness=springs, loss_factor=0.02),),
        forces=(Force("F", drive, None),),
        loss_factor=6e-3,
    )


POINTS, REGIONS = grid_points(plate(), 3e-3)


@cache
def response(young=70e9, loss=6e-3, springs=3e11):
    """Velocity (lines, points) of the plate with some numbers."""
    of = changed(plate(), {YOUNG: young, LOSS: loss, EDGES: springs})
    return responded(of, LINES, POINTS, REGIONS, 1e-3, fineness=COARSE)


@cache
def small(unknowns=UNKNOWNS):
    return SmallModel.of(plate(), unknowns, LINES, POINTS, {"F": 1.0}, 1e-3, COARSE)


def noise(values, share, seed):
    """Independent complex noise, its root mean square in that of the values."""
    chance = np.random.default_rng(seed)
    size = share * np.sqrt((np.abs(values) ** 2).mean() / 2)
    return size * (chance.standard_normal(values.shape) + 1j * chance.standard_normal(values.shape))


def measured(young=70e9, loss=6e-3, springs=3e11, share=0.01, seed=0):
    values = response(young, loss, springs).values[..., 0]
    return MeasuredResponse.of(LINES, POINTS, values + noise(values, share, seed), True, {"F": 1.0})
