"""Slopes and tolerances of cells with several pillars."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from daily import daily
from five_parts import refusing
from haptonic.bloch.centred import lattice_pencil
from haptonic.bloch.exact import exact_modes
from haptonic.bloch.pencil import eigenpairs
from haptonic.bloch.resolution import Resolution
from haptonic.cell import Pillar, Site, UnitCell
from haptonic.design.parameters import UNITS, values_of
from haptonic.design.sensitivity import sensitivity
from haptonic.errors import GeometryError
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial
from haptonic.superelement import TiledMesh

MM = 1e-3
ALUMINIUM = IsotropicMaterial(youngs_modulus=70e9, poisson_ratio=0.33, density=2700.0, name="aluminium")
KAPPA = np.array([1.1, 0.4])
PAIR = (Pillar(2 * MM, 4 * MM), Pillar(1.8 * MM, 5 * MM))
CELLS = {
    "honeycomb": UnitCell(
        Lattice(lattice="honeycomb", pitch=7 * MM),
        1.5 * MM,
        ALUMINIUM,
        site=tuple(Site(pillar=pillar) for pillar in PAIR),
    ),
    "kagome": UnitCell(Lattice(lattice="kagome", pitch=8 * MM), 1.5 * MM, ALUMINIUM, PAIR[0]),
}
MATERIAL = ("material.youngs_modulus", "material.poisson_ratio", "material.density")
PATHS = {
    "honeycomb": (
        "cell.pitch",
        "cell.thickness",
        "cell.site[2].pillar.height",
        "cell.site[1].pillar.diameter",
    ),
    "kagome": ("cell.pitch", "cell.pillar.height"),
}


@cache
def plans(name):
    return tuple(replace(plan, pillar_layers=1) for plan in Resolution(2, 0).plans(CELLS[name]))


@cache
def solved(name, band):
    shared = TiledMesh.of(CELLS[name], plans(name))
    values = eigenpairs(lattice_pencil(shared.condensed(2, 8, measured=False)), KAPPA, band + 1)[0]
    modes = exact_modes(shared, KAPPA, float(np.sqrt(values[band])))
    return modes, sensitivity(shared, modes)


def hertz(name, changes, omega):
    there = CELLS[name].with_numbers(changes)
    return exact_modes(TiledMesh.of(there, plans(name)), KAPPA, omega).omega / (2 * np.pi)


@pytest.mark.parametrize(
    ("name", "path"),
    daily(
        [(name, path) for name, paths in PATHS.items() for path in paths],
        ("honeycomb", "cell.site[2].pillar.height"),
        ("kagome", "cell.pitch"),
    ),
)
def test_slopes_are_those_of_exact_frequencies(name, path):
    modes, result = solved(name, 4)
    here = values_of(CELLS[name])[path]
    step = 1e-3 * here
    ahead, behind = (hertz(name, {path: here + sign * step}, modes.omega) for sign in (1, -1))
    slope = (ahead - behind) / (2 * step)
    assert UNITS[path] == "m"
    assert result.slopes[path] == pytest.approx([slope], rel=2e-4)


@pytest.mark.parametrize("name", CELLS)
def test_slopes_add_up_as_dimensions_ask(name):
    """All lengths in proportion are one over the frequency; stiffness and mass are a root each."""
    modes, result = solved(name, 4)
    values = values_of(CELLS[name])
    lengths = sum(result.slopes[path] * values[path] for path in values if path.startswith("cell."))
    assert lengths == pytest.approx([-result.frequency], rel=1e-6)
    modulus, _, density = (result.slopes[path] * values[path] for path in MATERIAL)
    assert modulus == pytest.approx([0.5 * result.frequency], rel=1e-9)
    assert density == pytest.approx([-0.5 * result.frequency], rel=1e-9)
    assert modes.fields.shape[2] == 1


def test_where_a_size_parts_tiles_that_meet_in_a_point_there_is_no_slope():
    """Square tiles about the corners and the middle of a rectangle whose sides happen to be equal."""
    places = ((0, 0), (0.5, 0.5))
    cell = UnitCell(
        Lattice.rectangular(7 * MM, 7 * MM),
        1.5 * MM,
        ALUMINIUM,
        site=tuple(Site(at=at, pillar=PAIR[0]) for at in places),
    )
    assert len(cell.tiles[0].tile.corners) == 4
    shared = TiledMesh.of(cell, [replace(plan, pillar_layers=1) for plan in Resolution(2, 0).plans(cell)])
    values = eigenpairs(lattice_pencil(shared.condensed(2, 8, measured=False)), KAPPA, 4)[0]
    modes = exact_modes(shared, KAPPA, float(np.sqrt(values[3])))
    with refusing(GeometryError, "conflict", "cell.pitch_y"):
        sensitivity(shared, modes, ["cell.pitch_y"])
