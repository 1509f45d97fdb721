"""Slopes of exact frequencies against differences, scaling laws, and the numbers that can be changed."""

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from daily import daily
from five_parts import refusing
from haptonic.bloch.exact import exact_modes
from haptonic.bloch.pencil import bloch_pencil, eigenpairs
from haptonic.cell import Disc, MeshPlan, Pillar, Step, UnitCell
from haptonic.design.discs import with_shared
from haptonic.design.parameters import UNITS, values_of
from haptonic.design.sensitivity import sensitivity
from haptonic.errors import GeometryError, StudyError
from haptonic.fields.keys import pattern_of
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial, OrthotropicMaterial
from haptonic.materials.orthotropic import SYMMETRIES
from haptonic.superelement import TiledMesh
from stacks import DRAFTED, STACKS

MM = 1e-3
ALUMINIUM = IsotropicMaterial(70e9, 0.33, 2700.0, name="aluminium")
TUNGSTEN = IsotropicMaterial(411e9, 0.28, 19250.0, name="tungsten")
TITANIUM = OrthotropicMaterial(
    c11=162e9, c12=92e9, c13=69e9, c33=181e9, c44=46.7e9, density=4506.0, turn=0.3, name="crystal"
)
SQUARE, RECTANGLE = Lattice.square(7 * MM), Lattice.rectangular(8 * MM, 7 * MM)
ALL = Pillar(4.5 * MM, 14.7 * MM, "round", math.radians(2), 0.6 * MM, Step(3 * MM, 5 * MM))
GENERIC, ORIGIN = (1.3, 0.4), (0.0, 0.0)


# both ends inside and outside of the plate, and sections with every number that can vary
RECTANGLE_IN_ELLIPSE = (
    Disc(4 * MM, section="ellipse", length=4.6 * MM, low=-0.6 * MM, high=1.1 * MM),
    Disc(
        2 * MM, section="rectangle", length=1.6 * MM, corner_radius=0.2 * MM, low=-1 * MM, high=0.5 * MM,
        empty=True,
    ),
)  # fmt: skip


def cell(pillar, lattice=SQUARE, **more):
    return UnitCell(lattice, 1.5 * MM, ALUMINIUM, pillar, **more)


REFERENCE = cell(Pillar(3.5 * MM, 14.7 * MM))
CELLS = {
    "reference": REFERENCE,
    "all at once": cell(ALL),
    "square section": cell(replace(ALL, section="square", draft=math.radians(-2), step=None)),
    "rectangular": cell(Pillar(3.5 * MM, 9 * MM), RECTANGLE),
    "centred": cell(Pillar(3 * MM, 9 * MM), Lattice.centred(7 * MM, 10 * MM)),
    "oblique": cell(Pillar(3 * MM, 9 * MM), Lattice.oblique(7 * MM, 6 * MM, 1.3)),
    "pillar of another metal": cell(Pillar(3.2 * MM, 5 * MM, material=TUNGSTEN)),
    "crystal": replace(cell(Pillar(3.5 * MM, 7 * MM)), material=TITANIUM),
    "plain plate": cell(None),
    "ellipse": cell(Pillar(3 * MM, 5 * MM, "ellipse", length=2 * MM, turn=0.3)),
    "blind holes on both faces": cell(None, disc=(Disc(4 * MM, low=-0.4 * MM, empty=True),), faces="both"),
    "coated inclusion": cell(None, disc=STACKS["coated inclusion"]),
    "pillar on glue": cell(None, disc=STACKS["pillar on glue"]),
    "cap": cell(None, disc=STACKS["cap"]),
    "countersunk hole": cell(None, disc=DRAFTED["countersunk hole"]),
    "drafted coated inclusion": cell(None, disc=DRAFTED["drafted coated inclusion"]),
    "discs of all numbers": cell(None, disc=RECTANGLE_IN_ELLIPSE),
    "cross-shaped hole": cell(None, disc=(Disc(5 * MM, section="cross", arm_width=2 * MM, empty=True),)),
    "rounded": cell(Pillar(3 * MM, 5 * MM, "rectangle", length=2 * MM, corner_radius=0.4 * MM)),
}
MATERIALS = {  # number of them, where it is not one
    "pillar of another metal": 2,
    "coated inclusion": 3,
    "drafted coated inclusion": 3,
    "pillar on glue": 3,
}
CONSTANTS = {("crystal", "Pa"): 5}  # number of constants, where it is not that of materials
# (cell, phases, band from 0, degenerate modes)
CASES = [
    ("reference", GENERIC, 5, 1),
    ("reference", ORIGIN, 3, 2),
    ("all at once", GENERIC, 4, 1),
    ("square section", GENERIC, 6, 1),
    ("rectangular", GENERIC, 5, 1),
    ("centred", GENERIC, 5, 1),
    ("pillar of another metal", GENERIC, 4, 1),
    ("crystal", GENERIC, 4, 1),
    ("plain plate", GENERIC, 3, 1),
    ("ellipse", GENERIC, 4, 1),
    ("rounded", GENERIC, 4, 1),
    ("blind holes on both faces", GENERIC, 4, 1),
    ("coated inclusion", GENERIC, 4, 1),
    ("pillar on glue", GENERIC, 4, 1),
    ("cap", GENERIC, 4, 1),
    ("countersunk hole", GENERIC, 4, 1),
    ("drafted coated inclusion", GENERIC, 4, 1),
    ("discs of all numbers", GENERIC, 4, 1),
    ("cross-shaped hole", GENERIC, 4, 1),
]
DAILY = [
    case for case in CASES if case[0] in ("all at once", "crystal", "ellipse", "blind holes on both faces")
]
cases = pytest.mark.parametrize(("name", "kappa", "band", "together"), daily(CASES, *DAILY))


def coarse(cell: UnitCell) -> MeshPlan:
    """The slopes are those of the mesh, so that the coarsest will do; its trace is no copy of its levels."""
    plan = MeshPlan.suited(cell, 2, 1)
    return replace(plan, order=2)


@cache
def start(name):
    shared = TiledMesh.of(CELLS[name], [coarse(CELLS[name])])
    return shared, shared.condensed(2, 6, measured=False)


@cache
def solved(name, kappa, band):
    shared, tiling = start(name)
    guess = np.sqrt(eigenpairs(bloch_pencil(tiling), np.array(kappa), band + 1)[0][band])
    modes = exact_modes(shared, np.array(kappa), float(guess))
    return modes, sensitivity(shared, modes)


def exact_hertz(name, changes, kappa, omega):
    """Frequency of the changed cell's mesh near omega, Hz, found without any slope."""
    there = CELLS[name].with_numbers(with_shared(CELLS[name], changes))
    shared = TiledMesh.of(there, [coarse(CELLS[name])])
    return exact_modes(shared, np.array(kappa), omega).omega / (2 * np.pi)


def five_points(f, at, step):
    return (8 * (f(at + step) - f(at - step)) - (f(at + 2 * step) - f(at - 2 * step))) / (12 * step)


@cases
def test_slopes_together_are_those_of_exact_frequencies(name, kappa, band, together):
    """All numbers change at once, each by the step that it has alone in the next test, up or down."""
    modes, result = solved(name, kappa, band)
    values, rng = values_of(CELLS[name]), np.random.default_rng(2)
    assert modes.fields.shape[2] == together
    steps = {path: rng.choice([-1.0, 1.0]) * step_of(name, path) for path in values}

    def moved(t):
        return exact_hertz(name, {p: values[p] + t * step for p, step in steps.items()}, kappa, modes.omega)

    expected = five_points(moved, 0.0, 1.0)
    slope = sum(result.slopes[path] * step for path, step in steps.items())
    assert slope == pytest.approx(np.full(together, expected), rel=2e-6)


def step_of(name, path):
    # nodes between discs are interpolated in a table, whose intervals are as short as this
    share = 2e-5 if CELLS[name].disc else 2e-4
    return share * (1.0 if UNITS[path] == "rad" else abs(values_of(CELLS[name])[path]))


@pytest.mark.nightly
@pytest.mark.parametrize(("name", "kappa", "band", "together"), CASES)
def test_slopes_are_those_of_exact_frequencies(name, kappa, band, together):
    modes, result = solved(name, kappa, band)
    assert modes.fields.shape[2] == together
    assert result.frequency == pytest.approx(modes.omega / (2 * np.pi))
    assert list(result.slopes) == list(values_of(CELLS[name]))
    for path, slope in result.slopes.items():
        here = values_of(CELLS[name])[path]
        step = step_of(name, path)
        expected = five_points(lambda x, p=path: exact_hertz(name, {p: x}, kappa, modes.omega), here, step)
        # where a length hardly counts, rounding of the frequency is what limits the difference
        floor = 1e-11 * result.frequency / step
        assert slope == pytest.approx(np.full(together, expected), rel=2e-6, abs=floor), path


@pytest.mark.parametrize("path", daily(["cell.pitch", "cell.pitch_y"], "cell.pitch_y"))
def test_a_pair_parts_when_the_lattice_loses_its_diagonal(path):
    """One pitch of a square lattice that is called rectangular: each of two modes has its own slope."""
    lattice = Lattice.rectangular(7 * MM, 7 * MM)
    there = UnitCell(lattice, 1.5 * MM, ALUMINIUM, REFERENCE.pillar)
    shared = TiledMesh.of(there, [coarse(there)])
    tiling = shared.condensed(2, 6, measured=False)
    guess = float(np.sqrt(eigenpairs(bloch_pencil(tiling), np.zeros(2), 4)[0][3]))
    modes = exact_modes(shared, np.zeros(2), guess)
    slope = sensitivity(shared, modes, [path]).slopes[path]
    assert len(slope) == 2
    assert abs(slope[1] - slope[0]) > 0.05 * np.abs(slope).max()
    assert slope[1] > slope[0]

    def apart(size):
        bent = there.with_numbers({path: size})
        mesh = TiledMesh.of(bent, [coarse(there)])
        values = np.sqrt(
            eigenpairs(bloch_pencil(mesh.condensed(4, 20, measured=False)), np.zeros(2), 5)[0][3:5]
        )
        return np.sort([exact_modes(mesh, np.zeros(2), float(w)).omega for w in values]) / (2 * np.pi)

    step = 1e-3 * 7 * MM
    ahead, behind = apart(7 * MM + step), apart(7 * MM - step)
    centred = np.sort((ahead - behind[::-1]) / (2 * step))
    assert slope == pytest.approx(centred, rel=1e-4)


@cases
def test_sizes_and_constants_scale_as_they_must(name, kappa, band, together):
    """With fixed phases a cell twice as large has half the frequency; angles do not count."""
    _, result = solved(name, kappa, band)
    values = values_of(CELLS[name])
    lengths = sum(values[path] * slope for path, slope in result.slopes.items() if UNITS[path] == "m")
    assert lengths == pytest.approx(np.full(together, -result.frequency), rel=1e-7)
    for unit, exponent in (("Pa", 0.5), ("kg/m^3", -0.5)):
        # of all materials together
        paths = [path for path in values if UNITS[path] == unit]
        assert len(paths) == CONSTANTS.get((name, unit), MATERIALS.get(name, 1))
        shares = sum(values[path] * result.slopes[path] for path in paths)
        assert shares == pytest.approx(np.full(together, exponent * result.frequency), rel=1e-9)


def test_only_the_paths_asked_for():
    modes, result = solved("reference", GENERIC, 5)
    some = ["cell.thickness", "material.poisson_ratio"]
    fewer = sensitivity(start("reference")[0], modes, some)
    assert list(fewer.slopes) == some
    assert all(fewer.slopes[path] == pytest.approx(result.slopes[path], rel=1e-12) for path in some)


@pytest.mark.parametrize("name", CELLS)
def test_values_put_back_change_nothing_and_each_changes_what_it_names(name):
    there = CELLS[name]
    values = values_of(there)
    assert there.with_numbers(values) == there
    assert there.with_numbers({}) == there
    order = [list(UNITS).index(pattern_of(path)) for path in values]
    assert order == sorted(order)
    for path in values:
        other = there.with_numbers(with_shared(there, {path: values[path] * 1.01}))
        assert values_of(other) == {**values, path: values[path] * 1.01}
        assert other != there or values[path] == 0


def test_what_a_cell_does_not_have_cannot_be_varied():
    of_others = {"cell.pitch_2", "cell.angle", "cell.pillar.length", "cell.pillar.corner_radius"}
    elsewhere = ("cell.site[]", "cell.disc[]", "cell.pillar.material.")
    of_others |= {path for path in UNITS if path.startswith(elsewhere) or path.startswith("material.c")}
    assert set(values_of(CELLS["all at once"])) == set(UNITS) - {"cell.pitch_y"} - of_others
    assert set(values_of(CELLS["rectangular"])) == set(UNITS) - of_others - {
        "cell.pillar.fillet", "cell.pillar.step.diameter", "cell.pillar.step.height",
    }  # fmt: skip
    of_plate = {"cell.pitch": 8 * MM, "cell.pitch_y": 7 * MM, "cell.thickness": 1.5 * MM}
    of_solid = {f"material.{name}": getattr(TITANIUM, name) for name in SYMMETRIES["transversely isotropic"]}
    assert values_of(UnitCell(RECTANGLE, 1.5 * MM, TITANIUM)) == {
        **of_plate, **of_solid, "material.density": 4506.0,
    }  # fmt: skip
    with refusing(StudyError, "unknown", "name of a number", "step"):
        REFERENCE.with_numbers({"cell.pillar.step.height": 0.1 * MM})


def test_changes_come_at_once():
    """Neither change makes a body alone: the pillar is as wide as the cell, or the step as the pillar."""
    together = {"cell.pitch": 14 * MM, "cell.pillar.diameter": 9 * MM}
    with pytest.raises(GeometryError):
        REFERENCE.with_numbers({"cell.pillar.diameter": 9 * MM})
    assert REFERENCE.with_numbers(together).pillar == Pillar(9 * MM, 14.7 * MM)
    assert REFERENCE.with_numbers(together).lattice == Lattice.square(14 * MM)
    wider = {"cell.pillar.step.diameter": 4.6 * MM, "cell.pillar.diameter": 5.4 * MM}
    with refusing(GeometryError, "out-of-range", "cell.pillar.step.diameter"):
        CELLS["all at once"].with_numbers({"cell.pillar.step.diameter": 4.6 * MM})
    pillar = CELLS["all at once"].with_numbers(wider).pillar
    assert (pillar.diameter, pillar.step) == (5.4 * MM, Step(4.6 * MM, 5 * MM))
