"""The brief's limits, the tangents that a search steps along, and that a search climbs."""

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from haptonic.bloch import Resolution
from haptonic.cell import Pillar, Step, UnitCell
from haptonic.design import quick, search
from haptonic.design.brief import LEAST_GAP, Brief, Finger
from haptonic.design.parameters import changed, values_of
from haptonic.design.quick import QuickDesign
from haptonic.design.search import climb, looked_at, starting_points
from haptonic.errors import StudyError
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial

MM = 1e-3
ALUMINIUM = IsotropicMaterial(70e9, 0.33, 2700.0, name="aluminium")
SQUARE = Lattice.square(7 * MM)
CELL = UnitCell(SQUARE, 1.5 * MM, ALUMINIUM, Pillar(3.5 * MM, 9 * MM))
ALL = replace(CELL, pillar=Pillar(4.5 * MM, 9 * MM, "round", math.radians(2), 0.6 * MM, Step(3 * MM, 5 * MM)))
PATHS = ("cell.pitch", "cell.thickness", "cell.pillar.diameter", "cell.pillar.height")


def brief_of(cell, bounds=None, carrier=60e3, **limits):
    if bounds is None:
        bounds = {path: (0.8 * values_of(cell)[path], 1.2 * values_of(cell)[path]) for path in PATHS}
    return Brief(cell, carrier, 8, bounds, **limits)


class TestLimits:
    everything = brief_of(
        ALL, slenderness=4.0, tool=2 * MM, reach=10 * MM, finger=Finger(1.0, 60 * MM, 20e-6)
    )

    def room(self, **changes):
        """Of the cell with everything, some numbers (of its pillar, or others by their path) changed.

        A place in a box, since some of these cells could not be made.
        """
        values = {
            path if path.startswith("cell") else f"cell.pillar.{path}": v for path, v in changes.items()
        }
        box = {path: (value, 2 * value) for path, value in values.items()}
        return replace(self.everything, bounds=box).limits(np.zeros(len(box)))

    def test_by_hand(self):
        room, slope = self.room(), math.tan(math.radians(2))
        below = 4.5 - 2 * slope * 5
        tip = 3 - 2 * slope * 4
        # the plate's stiffness D = 0.00725 F b^2 / w = E t^3 / (12 (1 - nu^2))
        least = (12 * (1 - 0.33**2) * 0.00725 * 0.06**2 / 20e-6 / 70e9) ** (1 / 3)
        assert room == pytest.approx({
            "finger": 1.5 * MM / least - 1,
            "gap between pillars": (7 - 4.5 - 2) / 7,
            "fillet": 1 - (4.5 + 1.2 * (1 / math.cos(math.radians(2)) - slope)) / 7 - LEAST_GAP,
            "tip": tip / 4.5 - 0.1,
            "height of the fillet": 0.75 - 0.6 * (1 - math.sin(math.radians(2))) / 5,
            "step's height": 0.95 - 5 / 9,
            "step's width": (0.93 * below - 3) / 4.5,
            "slenderness": 1 - 9 / (4 * 3),
            "reach of the tool": 0.1,
        })  # fmt: skip
        assert all(value > 0 for value in room.values())

    @pytest.mark.parametrize(("change", "limit"), [
        ({"cell.thickness": 0.3 * MM}, "finger"),
        ({"diameter": 5.1 * MM}, "gap between pillars"),
        ({"fillet": 1.24 * MM}, "fillet"),
        ({"draft": math.radians(18), "step.height": 1 * MM}, "tip"),
        ({"fillet": 0.8 * MM, "step.height": 1.02 * MM}, "height of the fillet"),
        ({"step.height": 8.7 * MM}, "step's height"),
        ({"step.diameter": 3.92 * MM}, "step's width"),
        ({"step.diameter": 2.2 * MM}, "slenderness"),
        ({"height": 10.1 * MM}, "reach of the tool"),
    ], ids=lambda value: value if isinstance(value, str) else "")  # fmt: skip
    def test_each_is_negative_where_it_is_broken(self, change, limit):
        assert self.room()[limit] > 0
        assert self.room(**change)[limit] < 0

    def test_only_those_that_apply(self):
        assert set(brief_of(CELL).limits(np.full(4, 0.5))) == {"gap between pillars", "fillet", "tip"}
        plate = replace(CELL, pillar=None)
        assert brief_of(plate, {"cell.pitch": (5 * MM, 9 * MM)}).limits(np.array([0.5])) == {}

    @settings(max_examples=300)
    @given(st.lists(st.floats(0, 1), min_size=8, max_size=8), st.sampled_from(["square", "rectangular"]))
    def test_what_meets_the_limits_is_a_body(self, share, lattice):
        """Whatever the optimiser may try can be meshed."""
        bounds = {
            "cell.pitch": (4 * MM, 14 * MM),
            "cell.pillar.diameter": (1 * MM, 9 * MM),
            "cell.pillar.height": (1 * MM, 16 * MM),
            "cell.pillar.draft": (-0.25, 0.25),
            "cell.pillar.fillet": (0.05 * MM, 3 * MM),
            "cell.pillar.step.diameter": (0.1 * MM, 8 * MM),
            "cell.pillar.step.height": (0.3 * MM, 15 * MM),
        }
        start = ALL
        if lattice == "rectangular":
            start = replace(ALL, lattice=Lattice.rectangular(8 * MM, 7 * MM))
            bounds["cell.pitch_y"] = (4 * MM, 14 * MM)
        brief = brief_of(start, bounds)
        place = np.array(share[: len(bounds)])
        nearby = brief.feasible(place)
        assume(min(brief.limits(nearby).values()) >= 0)
        brief.at(nearby)


class TestBounds:
    def test_those_that_contradict_each_other_are_refused(self):
        bounds = {"cell.pillar.diameter": (3.5 * MM, 4 * MM), "cell.pillar.height": (12 * MM, 14 * MM)}
        brief_of(CELL, bounds, slenderness=3.01).check()
        with pytest.raises(StudyError, match="slenderness") as refusal:
            brief_of(CELL, bounds, slenderness=2.0).check()
        assert refusal.value.argument == "design"
        assert "cell.pillar.height" in refusal.value.given
        # the best of them is 4 mm wide and 12 mm high: 12 / (2 * 4) = 1.5
        assert "by 0.5 of" in refusal.value.cause

    @settings(max_examples=30)
    @given(st.lists(st.floats(0, 1), min_size=4, max_size=4))
    def test_feasible_places_meet_the_limits_and_good_ones_are_left_alone(self, share):
        brief = brief_of(CELL, slenderness=2.4, tool=3 * MM, reach=9 * MM)
        place = np.array(share)
        found = brief.feasible(place)
        assert ((found >= 0) & (found <= 1)).all()
        assert min(brief.limits(found).values()) >= 0
        if min(brief.limits(place).values()) >= 0:
            assert np.array_equal(found, place)

    def test_shares_and_values_are_each_others_inverse(self):
        brief = brief_of(CELL)
        place = np.array([0.1, 0.5, 0.9, 1.0])
        assert brief.share(brief.at(place)) == pytest.approx(place)
        assert brief.at(brief.share(CELL)) == brief.at(np.full(4, 0.5))
        outside = changed(CELL, {"cell.thickness": 9 * MM})
        assert brief.share(outside) == pytest.approx([0.5, 1.0, 0.5, 0.5])
        held = brief.fixed("cell.pitch", 8 * MM)
        assert held.paths == PATHS[1:]
        assert held.at(np.full(3, 0.5)).lattice == Lattice.square(8 * MM)
        nothing_left = brief_of(CELL, {"cell.pitch": (6 * MM, 9 * MM)}).fixed("cell.pitch", 8 * MM)
        assert nothing_left.at(np.empty(0)).lattice == Lattice.square(8 * MM)
        nothing_left.check()

    def test_starting_points_are_allowed_and_apart(self):
        bounds = {
            path: (0.9 * value, 1.2 * value) for path, value in values_of(CELL).items() if path in PATHS
        }
        brief = brief_of(CELL, bounds, tool=3 * MM)
        points = starting_points(brief, 6)
        assert len(points) == 6
        assert points[0] == pytest.approx(brief.share(CELL))
        assert min(min(brief.limits(point).values()) for point in points) >= 0
        apart = [np.linalg.norm(a - b) for i, a in enumerate(points) for b in points[:i]]
        assert min(apart) > 0.1


@cache
def designed(path=None, share=1.0):
    """Sides of the gap above the sixth band of the cell with one number changed."""
    values = {} if path is None else {path: share * values_of(CELL)[path]}
    return QuickDesign.of(changed(CELL, values), 8).sides(6, PATHS)


@pytest.mark.parametrize("path", PATHS)
def test_slopes_of_the_edges_are_those_of_whole_designs(path):
    """By the envelope theorem the edge's own wavevector need not be followed.

    Only to a hundredth: the fields are those of the reduced model, which is not differentiated itself.
    """
    step = 5e-3
    number = PATHS.index(path)
    for which in (0, 1):
        ahead, behind = (designed(path, 1 + sign * step)[which].frequency[0] for sign in (1, -1))
        expected = (ahead - behind) / (2 * step * values_of(CELL)[path])
        assert designed()[which].slopes[0, number] == pytest.approx(expected, rel=1e-2)


def test_sides_start_with_the_edges():
    low, high = designed()
    assert low.frequency[0] == low.frequency.max()
    assert high.frequency[0] == high.frequency.min()
    lower, upper = QuickDesign.of(CELL, 8).edges()[:, 5]
    assert low.frequency[0] == pytest.approx(lower, rel=1e-3)
    assert high.frequency[0] == pytest.approx(upper, rel=1e-3)


class Corner:
    """A limit of two parameters by hand: the second may not exceed some value."""

    def __init__(self, most):
        self.most = most

    def limits(self, share):
        return {"second": self.most - share[1]}


@pytest.mark.parametrize(("start", "most", "step", "expected", "promised"), [
    # t <= 0.2 + dx and t <= 0.2 - dx + dy, largest where both are equal and dy is
    ((0.5, 0.5), 9.0, 0.1, (0.55, 0.6), 0.25),
    ((0.5, 0.5), 0.54, 0.1, (0.52, 0.54), 0.22),  # the limit stops the second
    ((0.5, 0.5), 9.0, 0.02, (0.51, 0.52), 0.21),  # a shorter step
    ((0.5, 0.96), 9.0, 0.1, (0.52, 1.0), 0.22),  # the box stops the second
    ((0.5, 0.6), 0.5, 0.1, (0.5, 0.6), 0.2),  # a limit that is broken gets no worse
])  # fmt: skip
def test_a_step_goes_where_the_tangents_meet(start, most, step, expected, promised):
    sides = (np.array([0.2, 0.2]), np.array([[1.0, 0.0], [-1.0, 1.0]]))
    ahead, margin = search._best_within(Corner(most), np.array(start), sides, step)
    assert ahead == pytest.approx(np.array(expected), abs=1e-9)
    assert margin == pytest.approx(promised)


def test_a_search_climbs_and_stays_allowed(monkeypatch):
    monkeypatch.setattr(quick, "QUICK", Resolution(2, 1))
    brief = brief_of(CELL, carrier=110e3, slenderness=2.8, tool=2.5 * MM)
    start = brief.share(CELL)
    first = looked_at(brief, start)
    visits = list(climb(brief, start, first.band, (0.0, 0.0), 5))
    assert visits[0].margin == pytest.approx(first.margin, abs=2e-3)
    assert len(visits) >= 3
    margins = [visit.margin for visit in visits]
    assert (np.diff(margins) > 0).all()
    assert margins[-1] > margins[0] + 0.02
    for visit in visits:
        assert ((visit.share >= 0) & (visit.share <= 1)).all()
        assert brief.allows(visit.share)
        room = min(brief.carrier - visit.lower, visit.upper - brief.carrier) / brief.carrier
        assert visit.margin == pytest.approx(room)
    assert looked_at(brief, visits[-1].share).margin == pytest.approx(margins[-1], abs=2e-3)

    shifted = next(climb(brief, start, first.band, (-200.0, 300.0), 1))
    assert shifted.lower == pytest.approx(visits[0].lower - 200.0)
    assert shifted.upper == pytest.approx(visits[0].upper + 300.0)
