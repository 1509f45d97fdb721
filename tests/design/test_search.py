"""The brief's limits, the tangents that a search steps along, and that a search climbs."""

import json
import math
import re
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import xarray as xr
from hypothesis import assume, given, settings, strategies as st

from daily import daily
from five_parts import refusing
from haptonic.analyses.designing import refusals, tasks
from haptonic.analyses.designing.search import _round_to_micrometres, compute_design
from haptonic.analyses.runner import Runner
from haptonic.bloch import Gap, Resolution, gaps_of
from haptonic.bloch.settings import BandSettings, MeshSettings
from haptonic.cell import Pillar, Step, UnitCell
from haptonic.design import quick, search
from haptonic.design.brief import LEAST_GAP, Brief
from haptonic.design.parameters import values_of
from haptonic.design.quick import QuickDesign
from haptonic.design.search import HeightRow, Visited, begun_from, climb, spread, starts_of
from haptonic.design.settings import DesignLimits
from haptonic.design.unmet import check_met
from haptonic.errors import ResourceError, StudyError
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial, material
from haptonic.results.design import Design
from haptonic.store import Store

MM = 1e-3
ALUMINIUM = IsotropicMaterial(70e9, 0.33, 2700.0, name="aluminium")
SQUARE = Lattice.square(7 * MM)
CELL = UnitCell(SQUARE, 1.5 * MM, ALUMINIUM, Pillar(3.5 * MM, 9 * MM))
ALL = replace(CELL, pillar=Pillar(4.5 * MM, 9 * MM, "round", math.radians(2), 0.6 * MM, Step(3 * MM, 5 * MM)))
# and the bounds of what they have besides the pitch
LATTICES = {
    "square": (SQUARE, {}),
    "rectangular": (Lattice.rectangular(8 * MM, 7 * MM), {"cell.pitch_y": (4 * MM, 14 * MM)}),
    "triangular": (Lattice.triangular(7 * MM), {}),
    "centred": (Lattice.centred(8 * MM, 12 * MM), {"cell.pitch_y": (4 * MM, 14 * MM)}),
    "oblique": (
        Lattice.oblique(8 * MM, 9 * MM, 1.2), {"cell.pitch_2": (4 * MM, 14 * MM), "cell.angle": (0.8, 2.0)}
    ),
}  # fmt: skip
HEIGHT = "cell.pillar.height"
PATHS = ("cell.pitch", "cell.thickness", "cell.pillar.diameter", HEIGHT)


def brief_of(cell, bounds=None, carrier=60e3, **limits):
    if bounds is None:
        bounds = {path: (0.8 * values_of(cell)[path], 1.2 * values_of(cell)[path]) for path in PATHS}
    return Brief(cell, carrier, 8, bounds, DesignLimits(**limits))


class TestLimits:
    everything = brief_of(
        ALL,
        slenderness=4.0,
        tool=2 * MM,
        reach=10 * MM,
        finger_force=1.0,
        finger_span=60 * MM,
        finger_deflection=20e-6,
    )

    def room(self, **changes):
        """Limits of the cell with everything, some numbers (of its pillar, or others by their path) changed.

        The cell is a place in a box, since some of these cells could not be made.
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

    def test_widths_are_asked_of_the_pillar(self, monkeypatch):
        """So that a pillar of another shape has its limits without a change here."""
        own, before = Pillar.half_width, self.room()
        monkeypatch.setattr(Pillar, "half_width", lambda pillar, z, stage: own(pillar, z, stage) - 0.1 * z)
        room = self.room()
        assert room["tip"] == pytest.approx(before["tip"] - 2 * 0.1 * 9 / 4.5)
        assert room["step's width"] == pytest.approx(before["step's width"] - 0.93 * 2 * 0.1 * 5 / 4.5)

    def test_only_those_that_apply(self):
        assert set(brief_of(CELL).limits(np.full(4, 0.5))) == {"gap between pillars", "fillet", "tip"}
        plate = replace(CELL, pillar=None)
        assert brief_of(plate, {"cell.pitch": (5 * MM, 9 * MM)}).limits(np.array([0.5])) == {}

    @settings(max_examples=10)
    @given(st.lists(st.floats(0, 1), min_size=9, max_size=9), st.sampled_from(sorted(LATTICES)))
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
        given, further = LATTICES[lattice]
        brief = brief_of(replace(ALL, lattice=given), bounds | further)
        place = np.array(share[: len(brief.bounds)])
        nearby = brief.feasible(place)
        assume(min(brief.limits(nearby).values()) >= 0)
        brief.at(nearby)


class TestBounds:
    def test_those_that_contradict_each_other_are_refused(self):
        bounds = {"cell.pillar.diameter": (3.5 * MM, 4 * MM), "cell.pillar.height": (12 * MM, 14 * MM)}
        check_met(brief_of(CELL, bounds, slenderness=3.01))
        with refusing(StudyError, "no-answer", "design") as refusal:
            check_met(brief_of(CELL, bounds, slenderness=2.0))
        assert refusal.value.argument == "design"
        assert "cell.pillar.height" in refusal.value.given
        # the best of them is 4 mm wide and 12 mm high: 12 / (2 * 4) = 1.5
        for words in ("higher than 2", "cell.pillar.height = 12 mm"):
            assert words in refusal.value.cause
        for value in ('cell.pillar.diameter vary to "6 mm"', 'height vary from "8 mm"', "slenderness = 3"):
            assert value in refusal.value.next_step

    @settings(max_examples=30)
    @given(st.lists(st.floats(0, 1), min_size=4, max_size=4))
    def test_feasible_places_meet_the_limits_and_good_ones_are_left_alone(self, share):
        brief = brief_of(CELL, slenderness=2.4, tool=3 * MM, reach=9 * MM)
        place = np.array(share)
        feasible = brief.feasible(place)
        assert ((feasible >= 0) & (feasible <= 1)).all()
        assert min(brief.limits(feasible).values()) >= 0
        if min(brief.limits(place).values()) >= 0:
            assert np.array_equal(feasible, place)

    def test_shares_and_values_are_each_others_inverse(self):
        brief = brief_of(CELL)
        place = np.array([0.1, 0.5, 0.9, 1.0])
        assert brief.share(brief.at(place)) == pytest.approx(place)
        assert brief.at(brief.share(CELL)) == brief.at(np.full(4, 0.5))
        outside = CELL.with_numbers({"cell.thickness": 9 * MM})
        assert brief.share(outside) == pytest.approx([0.5, 1.0, 0.5, 0.5])
        held = brief.fixed("cell.pitch", 8 * MM)
        assert held.paths == PATHS[1:]
        assert held.at(np.full(3, 0.5)).lattice == Lattice.square(8 * MM)
        nothing_left = brief_of(CELL, {"cell.pitch": (6 * MM, 9 * MM)}).fixed("cell.pitch", 8 * MM)
        assert nothing_left.at(np.empty(0)).lattice == Lattice.square(8 * MM)
        check_met(nothing_left)

    @settings(max_examples=5, deadline=None)
    @given(
        st.sets(st.sampled_from(PATHS), min_size=1),
        st.integers(1, 60),
        st.floats(1.5, 16),
        st.floats(0.0, 3.0),
    )
    def test_what_is_looked_at_is_allowed_and_all_over_the_bounds(self, paths, count, slenderness, tool):
        bounds = {path: (0.5 * values_of(CELL)[path], 1.5 * values_of(CELL)[path]) for path in sorted(paths)}
        brief = brief_of(CELL, bounds, slenderness=slenderness, tool=max(tool, 0.1) * MM)
        assume(brief.allows(brief.feasible(brief.share(CELL))))
        columns = spread(brief, count)
        places = np.vstack(columns)
        assert all(brief.allows(place) for place in places)
        own = brief.feasible(brief.share(CELL))
        assert np.abs(places - own).max(axis=1).min() < 1e-12
        assert len(places) <= count + 1
        for column in columns:
            others = np.delete(column, [i for i, path in enumerate(bounds) if path == HEIGHT], axis=1)
            assert (others == others[0]).all()
        if count >= 30 and len(bounds) > 1:
            assert len(places) >= 0.8 * count
            drawn = np.random.default_rng(1).random((400, len(bounds)))
            allowed = np.array([place for place in drawn if brief.allows(place)])
            if len(allowed) > 40:  # as far as the limits leave
                for row, path in enumerate(bounds):
                    assert np.ptp(places[:, row]) > 0.5 * np.ptp(allowed[:, row]), path


@cache
def designed(path=None, share=1.0):
    """Sides of the gap above the sixth band of the cell with one number changed."""
    values = {} if path is None else {path: share * values_of(CELL)[path]}
    return QuickDesign.of(CELL.with_numbers(values), 8).sides(6, PATHS)


@pytest.mark.parametrize("path", daily(PATHS, HEIGHT))
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
    # of equal frequencies any may be first
    assert low.frequency[0] == pytest.approx(low.frequency.max(), rel=1e-9)
    assert high.frequency[0] == pytest.approx(high.frequency.min(), rel=1e-9)
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


def best_of(brief, share):
    """The gap that holds the carrier best, in the model of a climb."""
    edges = QuickDesign.of(brief.at(share), brief.count).edges()
    return HeightRow(share[None], edges[None]).best(brief.carrier)[0][1]


def test_a_search_climbs_and_stays_allowed(monkeypatch):
    monkeypatch.setattr(quick, "QUICK", Resolution(2, 1))
    brief = brief_of(CELL, carrier=110e3, slenderness=2.8, tool=2.5 * MM)
    start = brief.share(CELL)
    first = best_of(brief, start)
    visits, _ = climb(brief, start, first.band, (0.0, 0.0), 5)
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
    assert best_of(brief, visits[-1].share).margin == pytest.approx(margins[-1], abs=2e-3)

    for start_of_last, most, expected in ((visits[0].share, 2, False), (visits[-1].share, 40, True)):
        assert climb(brief, start_of_last, first.band, (0.0, 0.0), most)[1] is expected

    (shifted,), _ = climb(brief, start, first.band, (-200.0, 300.0), 1)
    assert shifted.lower == pytest.approx(visits[0].lower - 200.0)
    assert shifted.upper == pytest.approx(visits[0].upper + 300.0)


def test_a_search_that_ended_early_is_not_limited_by_the_bound_that_it_has_reached():
    gap = Gap((6, 7), 56e3, 64e3, 100.0, 100.0, (0.0, 0.0), (1.0, 1.0), True, "all", 9)
    held = json.dumps(["cell.thickness = 1.2 mm"])
    for is_settled, words in (
        (1, "The margin is limited by cell.thickness = 1.2 mm."),
        (0, "more steps in [design] may widen it. The design has reached cell.thickness = 1.2 mm."),
    ):
        attributes = {"settled": is_settled, "held_back_by": held, "left_out": "[]", "carrier_hz": 60e3}
        data = xr.Dataset({}, {"parameter": ["cell.thickness"]}, attributes)
        data["parameter"].attrs["units"] = json.dumps(["m"])
        summary = Design({"cell.thickness": 1.2e-3}, gap, 3.9e3, data).summary()
        assert summary[0].endswith("with a margin of at least 3.90 kHz.")
        assert summary[1].endswith(words)


class TestStarts:
    """Columns by hand, at a carrier of 100 Hz."""

    @staticmethod
    def column(place, *designs):
        """Designs one above the other, each with its (lower, upper) edges of every pair of bands."""
        shares = np.array([[place, height] for height in np.linspace(0, 1, len(designs))])
        return HeightRow(shares, np.array([np.transpose(edges) for edges in designs], dtype=float))

    def test_bands_that_touch_at_the_carrier_come_after_every_gap(self):
        touching = self.column(0.2, [(100, 100), (140, 120)])
        narrow = self.column(0.8, [(150, 120), (40, 42)])
        starts = starts_of([touching, narrow], 100.0)
        assert (starts[0].share[0], starts[0].band) == (0.8, 2)
        assert starts[0].is_open(100.0)
        assert not any(visit.is_open(100.0) for visit in starts[1:])

    def test_a_gap_between_two_heights_that_were_looked_at_is_seen(self):
        (first, *_) = starts_of([self.column(0.5, [(150, 180)], [(60, 72)])], 100.0)
        assert first.lower < 100 < first.upper
        assert 0.3 < first.share[1] < 0.6  # 165 Hz to 66 Hz, with 100 Hz on the way

    def test_each_basin_once(self):
        columns = [self.column(place, [(95, 106 + place)]) for place in (0.1, 0.15, 0.9)]
        assert [visit.share[0] for visit in starts_of(columns, 100.0)] == [0.9, 0.15]
        two_gaps = self.column(0.1, [(95, 106), (90, 99)])
        assert [visit.band for visit in starts_of([two_gaps], 100.0)] == [1, 2]

    @pytest.mark.parametrize(("opened", "overlapping", "expected"), [(9, 4, 6 + 2), (3, 9, 6), (0, 9, 6)])
    def test_bands_that_overlap_have_the_last_climbs(self, opened, overlapping, expected):
        """Of two climbs at a time, and three times as many."""
        widths = [5.0] * opened + [-5.0] * overlapping
        starts = [Visited(np.zeros(1), band, 60.0, 60.0 + width, 0.0) for band, width in enumerate(widths)]
        begun = begun_from(starts, 100.0, 2)
        assert len(begun) == expected
        assert [start.band for start in begun[:6]] == list(range(6))
        assert sum(not start.is_open(100.0) for start in begun) >= 2


CHEAP = Resolution(2, 1)
ASKED = BandSettings(8, 8, 0.02, MeshSettings(3, 1))


@pytest.fixture
def cheap(monkeypatch):
    monkeypatch.setattr(quick, "QUICK", CHEAP)


@pytest.fixture(scope="module")
def kept(tmp_path_factory):
    """Where searches of the same brief find again what they have looked at."""
    return Store(tmp_path_factory.mktemp("kept"))


def searched(brief, kept, asked=ASKED, starts=30, climbs=2, steps=12):
    return compute_design(
        brief, asked, starts=starts, climbs=climbs, steps=steps, inputs={}, runner=Runner(kept)
    )


def glass(carrier=40e3, start=(2.0, 10.0, 0.7), slenderness=16.0):
    """Slender pillars of glass, whose best gap no climb from the start alone comes near."""
    diameter, height, thickness = start
    cell = UnitCell(
        Lattice.square(4 * MM), thickness * MM, material("soda-lime-glass"),
        Pillar(diameter * MM, height * MM),
    )  # fmt: skip
    bounds = {
        "cell.pillar.diameter": (0.8 * MM, 3.5 * MM),
        HEIGHT: (3 * MM, 30 * MM),
        "cell.thickness": (0.3 * MM, 1.5 * MM),
    }
    return Brief(cell, carrier, 8, bounds, DesignLimits(slenderness=slenderness))


def drawn(seed):
    """A brief with two parameters, and a start anywhere in it."""
    rng = np.random.default_rng(seed)
    stuff, pitch = material(["brass", "soda-lime-glass", "steel"][seed % 3]), rng.uniform(4, 9) * MM
    shear = np.sqrt(stuff.youngs_modulus / (2 * (1 + stuff.poisson_ratio) * stuff.density))
    bounds = {"cell.pillar.diameter": (0.3 * pitch, 0.9 * pitch), HEIGHT: (1.0 * pitch, 5.0 * pitch)}
    cell = UnitCell(
        Lattice.square(pitch), rng.uniform(0.1, 0.2) * pitch, stuff, Pillar(0.5 * pitch, 2.0 * pitch)
    )
    brief = Brief(
        cell, rng.uniform(0.06, 0.16) * shear / pitch, 8, bounds, DesignLimits(slenderness=rng.uniform(4, 12))
    )
    return replace(brief, cell=brief.at(brief.feasible(rng.random(2))))


@pytest.mark.nightly
@pytest.mark.parametrize("seed", [3, 4])
def test_a_search_is_at_least_as_good_as_a_scan(cheap, seed, kept):
    """The benchmark ``search_finds_what_is_there`` draws twenty."""
    brief = drawn(seed)
    lines = [6 if path == HEIGHT else 3 for path in brief.paths]
    grid = np.stack(np.meshgrid(*(np.linspace(0, 1, n) for n in lines)), axis=-1).reshape(-1, len(lines))
    scan = [
        HeightRow.of(brief, place[None]).best(brief.carrier)[0][1] for place in grid if brief.allows(place)
    ]
    visit = max((seen for seen in scan if seen.is_open(brief.carrier)), key=lambda seen: seen.margin)
    gaps = gaps_of(tasks.gap_dataset((brief.at(visit.share), ASKED, visit.band)))
    (best,) = (gap for gap in gaps if gap.between[0] == visit.band)
    design = searched(brief, kept)
    assert min(brief.carrier - best.lower, best.upper - brief.carrier) > 0.01 * brief.carrier
    reached = min(brief.carrier - design.gap.lower, design.gap.upper - brief.carrier)
    assert reached > min(brief.carrier - best.lower, best.upper - brief.carrier) - 2e-3 * brief.carrier
    inside = brief.share(brief.cell.with_numbers(design.values))
    assert brief.allows(inside)
    assert all(low <= design.values[path] <= high for path, (low, high) in brief.bounds.items())


@settings(max_examples=200)
@given(st.lists(st.floats(0, 1), min_size=3, max_size=3), st.floats(4, 8), st.floats(0, 1e-6))
def test_a_design_is_written_in_whole_micrometres_and_stays_allowed(place, slenderness, off):
    """Where a climb ends: as slender as allowed, or at a bound, which need not be whole micrometres."""
    brief = glass(slenderness=slenderness)
    brief = replace(
        brief, bounds={path: (low + off, high - off) for path, (low, high) in brief.bounds.items()}
    )
    share = np.array(place)
    low, high = brief.box[1]
    share[1] = np.clip((slenderness * brief.values(share)[0] - low) / (high - low), 0, 1)
    assume(brief.allows(share))
    values = _round_to_micrometres(brief, share)
    assert tuple(values) == brief.paths
    for value, exact, (low, high) in zip(values.values(), brief.values(share), brief.box, strict=True):
        assert 1e6 * value == pytest.approx(round(1e6 * value), abs=1e-6)
        assert abs(value - exact) <= 1e-5  # a micrometre of diameter is worth up to eight of height
        assert low - 1e-12 <= value <= high + 1e-12
    assert brief.allows(brief.share(brief.cell.with_numbers(values)))


class TestWhatCannotBeComputed:
    """A machine without the memory for some of the designs found."""

    @staticmethod
    def refusing(monkeypatch, refuses):
        computed, tried = tasks.gap_dataset, []

        def too_large(argument):
            tried.append(argument)
            if refuses(tried):
                raise ResourceError.too_large(
                    argument="bands.accuracy", given="0.002", allowed="what fits into 8 GB",
                    cause="37 GB would be needed", next_step="ask for less accuracy",
                )  # fmt: skip
            return computed(argument)

        monkeypatch.setattr(tasks, "gap_dataset", too_large)
        return tried

    @pytest.mark.nightly
    def test_one_is_left_out_and_named(self, cheap, monkeypatch, kept):
        tried = self.refusing(monkeypatch, lambda tried: len(tried) == 1)
        design = searched(
            glass(), kept, replace(ASKED, accuracy=0.03), starts=48
        )  # not what another test has kept
        assert len(tried) >= 2
        assert design.margin > 0
        (left,) = design.left_out
        assert left["cause"] == "37 GB would be needed"
        assert left["values"].keys() == design.values.keys()
        assert left["values"]["cell.pillar.height"] == pytest.approx(tried[0][0].pillar.height, abs=1e-6)
        assert design.to_json()["left_out"] == [left]

    @pytest.mark.nightly
    def test_without_an_accurate_design_the_best_one_is_named(self, cheap, monkeypatch, kept):
        self.refusing(monkeypatch, lambda _: True)
        with refusing(ResourceError, "too-large", "bands.accuracy") as refusal:
            searched(glass(), kept, replace(ASKED, accuracy=0.04))
        assert "cell.pillar.height = " in refusal.value.cause


class TestRefusal:
    @settings(max_examples=100)
    @given(
        st.lists(st.sampled_from([0.0, 0.004, 0.5, 0.8, 1.0]), min_size=3, max_size=3),
        st.floats(1e3, 1e6),
        st.floats(-1e-2, 0.3),
        st.floats(-0.3, 0.3).filter(lambda away: abs(away) > 1e-6),
        st.booleans(),
        st.lists(st.floats(0.3, 3.0), max_size=5),
    )
    def test_limits_of_a_design_are_reported_without_contradiction(
        self, place, carrier, width, away, exact, ends
    ):
        """With ``away`` below zero a coarse gap may hold the carrier, while the exact one does not."""
        brief = glass(carrier, slenderness=9.0)
        share = brief.feasible(np.array(place))
        lower = carrier * (1 + away)
        visit = Visited(share, 3, lower, lower + width * carrier, min(-away, width + away))
        best = None
        if exact:
            best = Gap(
                (3, 4), 1.1 * carrier, 1.2 * carrier, 1.0, 1.0, (0.0, 0.0), (0.0, 0.0),
                complete=True, direction="all", samples=9,
            )  # fmt: skip
        refusal = refusals.out_of_reach(brief, best, [visit], [visit], [end * carrier for end in ends])
        values = dict(zip(brief.paths, brief.values(share), strict=True))
        slender = values[HEIGHT] / values["cell.pillar.diameter"] > 0.992 * 9
        assert ("slenderness" in refusal.cause) == slender
        at_bounds = [
            path
            for path, coordinate in zip(brief.paths, share, strict=True)
            if not 0.005 < coordinate < 0.995
        ]
        assert all(f"{path} = " in refusal.cause for path in at_bounds)
        held = "limited by" in refusal.cause
        assert held == ("widen" in refusal.next_step)
        assert held or not (at_bounds or slender)
        beyond = sum(end <= 1 for end in ends)
        assert (f"the 8 bands end below it in {beyond} of {len(ends)} " in refusal.cause) == (beyond > 0)
        assert ("count" in refusal.next_step) == (beyond > 0)
        missed = re.search(r"closest gap, (\S+) to (\S+) kHz, misses it by (\S+) kHz", refusal.cause)
        if missed:
            low, high, by = map(float, missed.groups())
            assert low < high
            assert by > 0
            assert by == pytest.approx(max(low - carrier / 1e3, carrier / 1e3 - high), abs=0.02)
        elif visit.is_open(carrier):
            assert visit.margin >= 0
            assert not exact
            assert "contains it only in the coarse model" in refusal.cause
        else:
            assert "no examined design has a gap" in refusal.cause
            assert not exact

    @given(st.lists(st.floats(1e-2, 1e7), min_size=1, max_size=4))
    def test_frequencies_that_differ_read_so(self, frequencies):
        words = refusals.in_khz(*frequencies)
        for a, first in zip(frequencies, words, strict=True):
            assert float(first) == pytest.approx(a / 1e3, abs=0.0051)
            assert float(first) > 0
            for b, second in zip(frequencies, words, strict=True):
                assert (first != second) or abs(a - b) <= 1e-5
