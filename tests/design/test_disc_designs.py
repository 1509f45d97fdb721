"""Designs and tolerances of discs: equal numbers move together, their order stays, plates drawn at random."""

import math
from dataclasses import replace

import numpy as np
import pytest

from five_parts import refusing
from haptonic.analyses.designing.search import compute_design
from haptonic.analyses.runner import Runner, design_gaps
from haptonic.bloch import gaps_of
from haptonic.bloch.settings import BandSettings, MeshSettings
from haptonic.cell import Disc, Site, UnitCell
from haptonic.design.brief import Brief
from haptonic.design.discs import moving_together, reason_fixed, with_shared
from haptonic.design.edges import beside_dataset, edge_slopes
from haptonic.design.parameters import values_of
from haptonic.design.settings import DesignLimits
from haptonic.design.spread_designs import samples
from haptonic.design.tolerance import Spread, Surface
from haptonic.design.unmet import check_met
from haptonic.errors import GeometryError, StudyError
from haptonic.lattice import Lattice
from haptonic.materials import material
from stacks import DRAFTED, EPOXY, RIGHT, STACKS, STEEL, above

MM, UM = 1e-3, 1e-6
ALUMINIUM = material("aluminium-7075")
SQUARE = Lattice.square(7 * MM)


def cell(*discs, **more):
    return UnitCell(SQUARE, 1.5 * MM, ALUMINIUM, disc=discs, **more)


def sizes(design):
    """Numbers of discs that can vary, and what moves with them, without the constants of materials."""
    return {path: others for path, others in moving_together(design).items() if ".material." not in path}


class TestNumbersThatMoveTogether:
    def test_a_shared_end_or_border_is_one_number(self):
        assert sizes(cell(*STACKS["pillar on glue"])) == {
            "cell.disc[1].diameter": ("cell.disc[2].diameter",),
            "cell.disc[1].high": ("cell.disc[2].low",),
            "cell.disc[2].high": (),
        }
        assert sizes(cell(*STACKS["hollow pillar"]))["cell.disc[1].high"] == ("cell.disc[2].high",)

    def test_an_end_at_a_face_or_below_the_middle_of_a_mirrored_plate_is_none(self):
        assert sizes(cell(*STACKS["hole"])) == {"cell.disc[1].diameter": ()}
        through = cell(Disc(4 * MM, low=-1.5 * MM, high=0.0, empty=True))
        assert sizes(through) == {"cell.disc[1].diameter": ()}
        assert "cell.thickness" not in values_of(through)
        half = cell(Disc(4 * MM, low=-0.75 * MM, empty=True), faces="both")
        assert "cell.thickness" not in values_of(half)
        for low in (-0.75 * MM, -1 * MM):
            mirrored = cell(Disc(4 * MM, low=low, high=1 * MM, material=STEEL), faces="both")
            assert set(sizes(mirrored)) == {"cell.disc[1].diameter", "cell.disc[1].high"}

    def test_a_material_of_two_discs_is_one(self):
        design = cell(
            above(3, 0, 1, material=STEEL), above(2, 1, 2, material=EPOXY), above(1, 2, 3, material=STEEL)
        )
        together = moving_together(design)
        assert together["cell.disc[1].material.density"] == ("cell.disc[3].material.density",)
        assert together["cell.disc[2].material.density"] == ()

    def test_a_number_that_would_part_two_sides_is_fixed(self):
        sunk = cell(*DRAFTED["countersunk hole"])
        assert sizes(sunk) == {
            "cell.disc[1].diameter": ("cell.disc[2].diameter",),
            "cell.disc[1].high": ("cell.disc[2].low",),
            "cell.disc[2].draft": (),
        }
        assert "cell.thickness" in values_of(sunk)
        cap = cell(*DRAFTED["cap on a cone"])  # between shaft and cap the cone is fixed, the chamfer is free
        assert sizes(cap) == {
            "cell.disc[3].high": ("cell.disc[4].low",),
            "cell.disc[4].draft": (),
            "cell.disc[4].high": (),
        }
        cause, _ = reason_fixed(cap, "cell.disc[2].draft")
        assert "no longer meet" in cause
        onto_a_face = cell(Disc(2 * MM, draft=-RIGHT, material=STEEL), above(5, 0, 1, material=STEEL))
        assert onto_a_face.stack.chains == ((0, 1),)
        assert "cell.thickness" not in values_of(onto_a_face)
        assert reason_fixed(onto_a_face, "cell.thickness") == reason_fixed(cap, "cell.disc[2].draft")

    @pytest.mark.parametrize("name", STACKS | DRAFTED)
    def test_every_number_leaves_the_grid_of_the_stack(self, name):
        """Little changes of each, in both directions; the equal numbers alone would divide it anew."""
        design = cell(*(STACKS | DRAFTED)[name])
        for path, others in moving_together(design).items():
            value = design.numbers()[path]
            for factor in (0.999, 1.001):
                moved = design.with_numbers(with_shared(design, {path: factor * value}))
                assert moved.stack.grid == design.stack.grid
                assert {moved.numbers()[other] for other in (path, *others)} == {factor * value}

    def test_sites_are_apart(self):
        discs = (Disc(3 * MM, material=STEEL),)
        sites = (Site(disc=discs), Site(disc=discs))
        two = UnitCell(Lattice(lattice="honeycomb", pitch=9 * MM), 1.5 * MM, ALUMINIUM, site=sites)
        assert sizes(two) == {"cell.site[1].disc[1].diameter": (), "cell.site[2].disc[1].diameter": ()}


class TestOrderOfDiscs:
    @staticmethod
    def brief(**limits):
        bounds = {"cell.disc[1].diameter": (3 * MM, 6 * MM), "cell.disc[2].high": (2 * MM, 5 * MM)}
        return Brief(cell(*STACKS["cap"]), 100e3, 8, bounds, DesignLimits(**limits))

    def test_limits_follow_borders_and_ends_past_each_other(self):
        """The shaft of 2.5 mm may widen to 4.5 mm, the cap's; the cap may end where it begins, at 3 mm."""
        brief = self.brief()
        rings = [
            brief.limits(np.array([(width * MM - 3 * MM) / (3 * MM), 0.6]))["rings of the discs"]
            for width in (4.0, 4.5, 5.0)
        ]
        assert rings[0] > 0 > rings[1] > rings[2]
        layers = [
            brief.limits(np.array([0.2, (high - 2) / 3]))["layers of the discs"] for high in (4.0, 3.0, 2.5)
        ]
        assert layers[0] > 0 > layers[1] > layers[2]
        for share in np.random.default_rng(1).random((6, 2)):
            brief.at(brief.feasible(share))

    def test_a_cone_keeps_its_tip(self):
        """A pillar of 3 mm whose upper end has 5 % of its width at 19.6 degrees."""
        bounds = {"cell.disc[1].draft": (0.1, 0.5)}
        brief = Brief(cell(above(3, 0, 4, draft=0.2)), 100e3, 8, bounds)
        least = math.atan(1.5 * 0.95 / 4)
        for draft, sign in ((least - 0.02, 1), (least + 0.02, -1)):
            assert sign * brief.limits(np.array([(draft - 0.1) / 0.4]))["taper of the discs"] > 0
        brief.at(brief.feasible(np.array([0.9])))

    def test_the_workshop_limits_the_sizes_of_discs(self):
        room = self.brief(tool=2 * MM, reach=5 * MM, slenderness=1.0).limits(np.array([0.0, 2 / 3]))
        assert room["reach of the tool"] == pytest.approx(1 - 4 / 5)
        assert room["slenderness"] == pytest.approx(1 - 4 / 3)
        assert room["gap between discs"] == pytest.approx((2.5 - 2) / 7)
        flush = Brief(
            cell(Disc(6.5 * MM, material=STEEL), above(2, 0, 3)), 1e5, 8, {}, DesignLimits(tool=2 * MM)
        )
        assert flush.limits(np.empty(0))["gap between discs"] == pytest.approx(1 - (6.5 + 0.14) / 7)
        hole = Brief(cell(Disc(1.5 * MM, empty=True)), 1e5, 8, {}, DesignLimits(tool=2 * MM))
        assert hole.limits(np.empty(0))["width of a hole"] == pytest.approx(-0.25)
        blind = Brief(cell(Disc(3 * MM, low=-0.5 * MM, empty=True)), 1e5, 8, {}, DesignLimits(reach=0.4 * MM))
        assert blind.limits(np.empty(0))["reach of the tool"] == pytest.approx(1 - 0.5 / 0.4)

    def test_a_spread_past_another_end_is_refused(self):
        layered = cell(Disc(4 * MM, low=-0.5 * MM, empty=True), Disc(3 * MM, low=-0.6 * MM, material=STEEL))
        of = (Spread("cell.disc[1].low", 0.1 * MM, "uniform"),)
        with refusing(GeometryError, "conflict", "cell.disc"):
            samples(layered, of, 16)
        assert len(samples(layered, (replace(of[0], spread=0.02 * MM),), 16)) == 16


UNMET = {
    "gap": ("disc[1].diameter", (7, 9), {}, "closer than 140 µm", 'from "6.86 mm"'),
    "layers": ("disc[2].high", (-1, -0.2), {}, "pass each other by 1.2 mm", 'to "1.01 mm"'),
    "reach": ("disc[2].high", (3, 6), {"reach": 2 * MM}, "than 2 mm", 'from "2 mm" or write reach = "3 mm"'),
    "slenderness": ("disc[2].high", (3, 6), {"slenderness": 0.5}, "0.5 times", "write slenderness = 1 in"),
    "tool": ("disc[2].high", (3, 6), {"tool": 5 * MM}, "closer than 5 mm", 'write tool = "4 mm"'),
}


@pytest.mark.parametrize("case", UNMET)
def test_limits_that_no_design_meets_are_named_with_values_that_would_do(case):
    """Discs of 3 mm on plates of 7 mm pitch; 2 % of it stay free, and 1 mm is the glue."""
    name, (low, high), limits, missed, proposed = UNMET[case]
    glued = cell(Disc(3 * MM, low=0.0, high=1 * MM, material=EPOXY), above(3, 1, 4, material=STEEL))
    brief = Brief(glued, 100e3, 8, {f"cell.{name}": (low * MM, high * MM)}, DesignLimits(**limits))
    with refusing(StudyError, "no-answer", "design", missed) as caught:
        check_met(brief)
    assert proposed in caught.value.next_step
    assert ("in [design]" in caught.value.next_step) == bool(limits)


COATED = UnitCell(
    Lattice.square(10 * MM), 2 * MM, ALUMINIUM,
    disc=(Disc(8 * MM, material=EPOXY), Disc(6 * MM, high=1 * MM, material=STEEL)),
)  # fmt: skip
SPREADS = (
    Spread("cell.disc[1].diameter", 50 * UM, per="pillar"),
    Spread("cell.disc[2].diameter", 50 * UM, "uniform", per="pillar"),
    Spread("cell.disc[2].high", 30 * UM),
)


DRAWN = 12  # plates


def gap_of(design):
    """Its complete gap at 100 kHz, of a mesh that no fit uses."""
    dataset = design_gaps((design, BandSettings(10, 13, 2e-2, MeshSettings(3, 2))))
    return next(gap for gap in gaps_of(dataset) if gap.complete and gap.lower < 100e3 < gap.upper)


@pytest.mark.nightly
def test_edges_of_drawn_plates_are_those_of_the_fit():
    """Direct Monte Carlo, each plate with its own mesh and its own search over the zone."""
    gap = gap_of(COATED)
    designs = samples(COATED, SPREADS, 20)
    frequency = beside_dataset((designs, gap))["frequency"].values
    widths = np.array([spread.spread for spread in SPREADS])
    at_rest = np.array([values_of(COATED)[spread.parameter] for spread in SPREADS])
    moved = np.array([[values_of(design)[s.parameter] for s in SPREADS] for design in designs])
    surface = Surface.fitted((moved - at_rest) / widths, frequency)

    rng = np.random.default_rng(7)
    drawn = np.stack([spread.frozen.rvs(DRAWN, random_state=rng) for spread in SPREADS], axis=1)
    plates = [
        COATED.with_numbers(dict(zip((s.parameter for s in SPREADS), at_rest + row * widths, strict=True)))
        for row in drawn
    ]
    direct = np.array([[other.lower, other.upper] for other in map(gap_of, plates)]) - [gap.lower, gap.upper]
    fitted = surface.at(drawn) - surface.at(np.zeros((1, 3)))
    assert direct.std(axis=0) == pytest.approx(fitted.std(axis=0), rel=0.03)
    assert np.abs(direct - fitted).max() < 0.1 * direct.std(axis=0).min()
    slopes = edge_slopes(COATED, gap, [spread.parameter for spread in SPREADS])
    assert np.abs(direct - drawn @ (slopes * widths[:, None])).max() < 0.35 * direct.std(axis=0).min()


@pytest.mark.nightly
def test_a_search_varies_equal_numbers_together():
    """Core and coating of one height: the found design is a cell of the same grid around the carrier."""
    ring, core = (replace(disc, high=1 * MM) for disc in COATED.disc)
    start = replace(COATED, disc=(ring, core))
    bounds = {"cell.disc[2].diameter": (4 * MM, 7 * MM), "cell.disc[1].high": (0.5 * MM, 2 * MM)}
    brief = Brief(start, 95e3, 10, bounds)
    settings = BandSettings(10, 13, 2e-2, MeshSettings(3, 1))
    design = compute_design(brief, settings, starts=4, climbs=1, steps=4, inputs={}, runner=Runner())
    best_cell = brief.made(design.values)
    assert best_cell.disc[0].high == best_cell.disc[1].high == design.values["cell.disc[1].high"]
    dataset = design_gaps((best_cell, settings))
    assert any(gap.complete and gap.lower < 95e3 < gap.upper for gap in gaps_of(dataset))
