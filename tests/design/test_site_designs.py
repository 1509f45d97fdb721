"""Searches of cells with several pillars: the values of limits, and that they find what a scan finds."""

from dataclasses import replace
from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from daily import daily
from haptonic.analyses.designing import tasks
from haptonic.analyses.designing.front import compute_front
from haptonic.analyses.designing.search import compute_design
from haptonic.analyses.runner import Runner
from haptonic.bloch import Resolution, gaps_of
from haptonic.bloch.settings import BandSettings, MeshSettings
from haptonic.cell import Pillar, Site, UnitCell
from haptonic.design import quick
from haptonic.design.brief import Brief
from haptonic.design.parameters import UNITS, values_of
from haptonic.design.search import HeightRow, Visited, climb, spread
from haptonic.design.settings import DesignLimits
from haptonic.errors import GeometryError
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial

MM = 1e-3
ALUMINIUM = IsotropicMaterial(70e9, 0.33, 2700.0, name="aluminium")
THIN, WIDE = Pillar(1.4 * MM, 4 * MM), Pillar(2.2 * MM, 3 * MM, fillet=0.2 * MM)
CHEAP = Resolution(2, 1)


def cell_of(lattice, *pillars, at=(), thickness=0.8 * MM):
    places = [{"position": place} if 0 < max(place) < 0.1 else {"at": place} for place in at] or [{}] * len(
        pillars
    )
    sites = tuple(Site(pillar=pillar, **place) for pillar, place in zip(pillars, places, strict=True))
    return UnitCell(lattice, thickness, ALUMINIUM, site=sites)


PLACES = ((0, 0), (3.4 * MM, 3.7 * MM))
SQUARE = replace(THIN, section="square")
CELLS = {
    "honeycomb": cell_of(Lattice(lattice="honeycomb", pitch=7 * MM), THIN, WIDE),
    "honeycomb of one": UnitCell(Lattice(lattice="honeycomb", pitch=7 * MM), 0.8 * MM, ALUMINIUM, THIN),
    "kagome": cell_of(Lattice(lattice="kagome", pitch=8 * MM), THIN, WIDE, None),
    "lieb": cell_of(Lattice(lattice="lieb", pitch=9 * MM), THIN, THIN, WIDE),
    "places in mm": cell_of(Lattice.rectangular(7 * MM, 8 * MM), WIDE, THIN, at=PLACES),
    "oblique": cell_of(Lattice.oblique(8 * MM, 9 * MM, 1.2), THIN, WIDE, at=PLACES),
    "squares": cell_of(
        Lattice.rectangular(7 * MM, 8 * MM),
        SQUARE,
        None,
        None,
        SQUARE,
        at=((0, 0), (3.5 * MM, 0), (0, 4 * MM), (3.5 * MM, 4 * MM)),
    ),
}


def bounds_of(cell, least=0.4, most=2.5):
    """Of every number of a cell but the material's, wide enough that most designs in them are no bodies."""
    own = values_of(cell)
    paths = [path for path in own if path.startswith("cell.") and UNITS[path] == "m"]
    return {path: (least * own[path], most * own[path]) for path in paths}


def brief_of(name, **limits):
    # squares need tiles that are rectangles about them, which places in mm keep at one pitch only
    bounds = bounds_of(CELLS[name])
    if name == "squares":
        bounds = {path: limits for path, limits in bounds.items() if "pitch" not in path}
    return Brief(CELLS[name], 60e3, 8, bounds, DesignLimits(**limits))


def near(brief, rng, away):
    """A place in the box, as far from the brief's own cell as that in each direction."""
    own = brief.share(brief.cell)
    return np.clip(own + away * rng.uniform(-1, 1, len(own)), 0, 1)


@given(st.sampled_from(sorted(CELLS)), st.integers(0, 10**6), st.floats(0.02, 1.0))
@settings(max_examples=50, deadline=None)
def test_what_meets_the_limits_is_a_body(name, seed, away):
    """Whatever the optimiser may try can be meshed, sites that move with the lattice included."""
    brief = brief_of(name)
    place = near(brief, np.random.default_rng(seed), away)
    if min(brief.limits(place).values()) >= 0:
        assert len(brief.at(place).tiles) == len(CELLS[name].tiles)


@pytest.mark.parametrize("name", daily(CELLS, "squares", "lieb"))
def test_the_tool_passes_between_the_outlines_of_all_pillars(name):
    """Half a hundredth more than the narrowest way, between points of the outlines, breaks a limit."""
    rng = np.random.default_rng(3)
    places = (near(brief_of(name), rng, 0.15) for _ in range(200))
    for place in [each for each in places if brief_of(name).allows(each)][:3]:
        way = narrowest(brief_of(name).at(place))
        assert brief_of(name, tool=0.99 * way).allows(place)
        room = brief_of(name, tool=1.005 * way).limits(place)
        assert min(value for limit, value in room.items() if limit.startswith("gap between pillars")) < 0


@pytest.mark.parametrize(("limit", "places", "least", "most"), [
    # tiles about corners and middles of rectangles are squares on edge where the sides are equal
    ("side of a tile", ((0, 0), (0.5, 0.5)), 7.001, 8.0),
    # two sites near each other, and no other for long
    ("corner of a tile", ((0, 0), (1.2 * MM, 0)), 9.0, 6.0),
    ("sites within the cell", ((0, 0), (3 * MM, 6.8 * MM)), 6.6, 8.0),
])  # fmt: skip
def test_tiles_that_cannot_be_meshed_break_a_limit(limit, places, least, most):
    """Where the cell of that pitch itself is refused."""
    thin = Pillar(0.4 * MM, 2 * MM)
    cell = cell_of(Lattice.rectangular(7 * MM, most * MM), thin, thin, at=places)
    brief = Brief(cell, 60e3, 8, {"cell.pitch_y": (least * MM, least * MM + MM)})
    assert brief.limits(np.zeros(1))[limit] < 0
    assert brief.limits(brief.share(cell))[limit] > 0 or most < least
    with pytest.raises(GeometryError):
        brief.at(np.zeros(1))


def narrowest(cell):
    """Least distance between points of the outlines of all pillars, m."""
    angle = np.linspace(0, 2 * np.pi, 241)
    circle = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    square = circle / np.abs(circle).max(axis=1)[:, None]
    steps = np.array([(n, m) for n in range(-2, 3) for m in range(-2, 3)])
    places, distances = cell.shares @ cell.vectors, []
    for i, pillar in enumerate(cell.pillars):
        for j, other in enumerate(cell.pillars):
            if pillar is None or other is None:
                continue
            for step in steps @ cell.vectors:
                away = places[j] - places[i] + step
                if away.any() and np.linalg.norm(away) < 2 * cell.lattice.pitch:
                    sides = [
                        p.broadest * (circle if p.section == "round" else square) for p in (pillar, other)
                    ]
                    apart = np.linalg.norm((away + sides[1])[:, None] - sides[0], axis=2)
                    distances.append(apart.min())
    return min(distances)


def test_limits_are_named_by_the_table_that_gives_the_pillar():
    limits = {"tool": 1 * MM, "slenderness": 3.0, "reach": 3.5 * MM}
    own = brief_of("honeycomb", **limits)
    room = own.limits(own.share(own.cell))
    assert room["reach of the tool of cell.site[1]"] == pytest.approx(1 - 4 / 3.5)
    assert room["slenderness of cell.site[2]"] == pytest.approx(1 - 3 / (3 * 2.2))
    assert "fillet of cell.site[2]" in room
    assert "reach of the tool" in brief_of("honeycomb of one", **limits).limits(np.full(4, 0.5))


def test_heights_of_all_pillars_grow_together_upon_the_same_feet():
    cell = CELLS["honeycomb"]
    heights = ["cell.site[1].pillar.height", "cell.site[2].pillar.height"]
    bounds = dict.fromkeys(heights, (1 * MM, 9 * MM)) | {"cell.thickness": (0.5 * MM, 1 * MM)}
    brief = Brief(cell, 60e3, 8, bounds, DesignLimits(slenderness=4.0))
    columns = spread(brief, 30)
    assert all(brief.allows(place) for column in columns for place in column)
    drawn = [np.array([brief.values(place) for place in column]) for column in columns[1:]]
    assert len({round(float(np.log(values[0, 0] / values[0, 1])), 6) for values in drawn}) >= 3
    for values in drawn:
        assert np.ptp(values[:, 2]) == 0
        assert np.ptp(values[:, 0] / values[:, 1]) < 1e-9
        assert (np.diff(values[:, 0]) > 0).all()


def test_a_step_of_a_climb_gives_what_the_tangents_promise(monkeypatch):
    """The diameter of one pillar and the height of the other vary."""
    monkeypatch.setattr(quick, "QUICK", CHEAP)
    cell = cell_of(Lattice(lattice="honeycomb", pitch=7 * MM), THIN, Pillar(2.2 * MM, 3 * MM))
    bounds = {
        "cell.site[1].pillar.height": (3 * MM, 6 * MM), "cell.site[2].pillar.diameter": (1.5 * MM, 3 * MM)
    }  # fmt: skip
    brief = Brief(cell, 85e3, 8, bounds)
    (first, second), _ = climb(brief, brief.share(cell), 6, (0.0, 0.0), 2)
    assert second.margin > first.margin + 0.02


def coarse_scan(brief, lines):
    """The best open gap around the carrier on a grid of the box, in the model of the search."""
    # heights change fastest: their feet are kept
    grid = np.array(list(product(*(np.linspace(0, 1, n) for n in reversed(lines)))))[:, ::-1]
    seen = [
        HeightRow.of(brief, place[None]).best(brief.carrier)[0][1] for place in grid if brief.allows(place)
    ]
    return max((visit for visit in seen if visit.is_open(brief.carrier)), key=lambda visit: visit.margin)


SEARCHED = {
    "honeycomb": (
        cell_of(Lattice(lattice="honeycomb", pitch=7 * MM), THIN, Pillar(2 * MM, 5 * MM)), 85e3,
        {"cell.site[1].pillar.height": (2 * MM, 8 * MM), "cell.site[2].pillar.height": (2 * MM, 8 * MM),
         "cell.site[2].pillar.diameter": (1.2 * MM, 3 * MM)},
        (7, 7, 4),
    ),
    "kagome": (
        UnitCell(Lattice(lattice="kagome", pitch=8 * MM), 0.8 * MM, ALUMINIUM, Pillar(1.8 * MM, 4 * MM)),
        103e3,
        {"cell.pillar.height": (2 * MM, 8 * MM), "cell.pillar.diameter": (1.2 * MM, 3 * MM),
         "cell.pitch": (7 * MM, 10 * MM)},
        (9, 5, 4),
    ),
}  # fmt: skip


@pytest.mark.nightly
@pytest.mark.parametrize("name", SEARCHED)
def test_a_search_is_at_least_as_good_as_a_scan(name, monkeypatch):
    """Both refined to the same accuracy."""
    monkeypatch.setattr(quick, "QUICK", CHEAP)
    cell, carrier, bounds, lines = SEARCHED[name]
    brief = Brief(cell, carrier, 12, bounds, DesignLimits(slenderness=4.0, tool=1 * MM))
    asked = BandSettings(12, 12, 0.02, MeshSettings(3, 1))
    visit = coarse_scan(brief, lines)
    gaps = gaps_of(tasks.gap_dataset((brief.at(visit.share), asked, visit.band)))
    (best,) = (gap for gap in gaps if gap.between[0] == visit.band)
    margin = min(carrier - best.lower, best.upper - carrier)
    design = compute_design(brief, asked, starts=24, climbs=2, steps=8, inputs={}, runner=Runner())
    reached = min(carrier - design.gap.lower, design.gap.upper - carrier)
    assert margin > 0
    assert reached > margin - 2e-3 * carrier
    assert brief.allows(brief.share(cell.with_numbers(design.values)))


class Kept(Runner):
    """Notes what it is to compute, and gives back where that starts."""

    def run(self, function, asked, done):
        self.__dict__["asked"] = [task.argument for task in asked]
        start = [Visited(share, 6, 80e3, 90e3, 0.05) for _, share, _ in self.__dict__["asked"]]
        return [tasks.as_dataset([visit]) for visit in start]


def test_a_front_starts_from_the_best_design_scaled_but_for_its_angles():
    pillar = replace(THIN, draft=0.05)
    cell = cell_of(Lattice(lattice="honeycomb", pitch=7 * MM), pillar, pillar)
    paths = ("cell.site[2].pillar.height", "cell.site[2].pillar.draft", "cell.thickness")
    bounds = {path: (0.2 * values_of(cell)[path], 3 * values_of(cell)[path]) for path in paths}
    brief, best = Brief(cell, 85e3, 8, {"cell.pitch": (6 * MM, 9 * MM)} | bounds), values_of(cell)
    runner = Kept()
    front = compute_front(brief, best, [6 * MM, 9 * MM], steps=2, runner=runner)
    assert list(front["parameter"].values) == list(paths)
    for pitch, (held, share, _) in zip((6 * MM, 9 * MM), runner.asked, strict=True):
        expected = [best[paths[0]] * pitch / (7 * MM), best[paths[1]], best[paths[2]]]
        assert held.values(share) == pytest.approx(expected)
