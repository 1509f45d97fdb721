"""Outlines: areas, moments, symmetry and gaps by closed forms and brute force; identities of sections."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from strategies import ALUMINIUM

from five_parts import refusing
from haptonic.cell import Disc, Pillar, Step, UnitCell
from haptonic.cell.outlines import CIRCLE, NUMBERS, SECTIONS, Scaled, taken_by
from haptonic.cell.pillar_parts import Corner
from haptonic.errors import GeometryError
from haptonic.lattice import Lattice

MM = 1e-3
TURNS = st.one_of(st.none(), st.floats(-3.1, 3.1), st.sampled_from([math.pi / 2, math.pi / 4, -math.pi / 6]))


def rotation(angle):
    return np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])


@st.composite
def sections(draw):
    """A pillar with any convex section, its numbers drawn from those that the section takes."""
    name = draw(st.sampled_from(sorted(set(SECTIONS) - {"cross", "snowflake"})))
    takes, given = taken_by(SECTIONS[name]), {}
    diameter = draw(st.floats(1.0, 4.0)) * MM
    if "length" in takes:
        given["length"] = diameter * draw(st.floats(0.4, 2.5))
    if "sides" in takes:
        given["sides"] = draw(st.integers(3, 12))
    if "turn" in takes:
        given["turn"] = draw(TURNS)
    if "point" in takes:
        count = draw(st.integers(3, 7))
        angles = 2 * math.pi * (np.arange(count) + [draw(st.floats(-0.2, 0.2)) for _ in range(count)]) / count
        given["point"] = tuple(Corner(x=math.cos(angle), y=math.sin(angle)) for angle in angles)
    pillar = Pillar(diameter, 6 * MM, name, **given)
    if "corner_radius" in takes and draw(st.booleans()):
        most = 0.5 * diameter * pillar.form.sharp.most_rounding
        pillar = replace(pillar, corner_radius=draw(st.floats(0.05, 0.95)) * most)
    return pillar


@st.composite
def stars(draw):
    """A disc whose section bends inwards, sharp or with rounded corners."""
    name, diameter = draw(st.sampled_from(["cross", "snowflake", "points"])), draw(st.floats(1.0, 4.0)) * MM
    given = {"turn": draw(TURNS)}
    if name == "points":
        count = draw(st.integers(3, 5))
        angles = (
            math.pi * (np.arange(2 * count) + [draw(st.floats(-0.2, 0.2)) for _ in range(2 * count)]) / count
        )
        reach = np.where(np.arange(2 * count) % 2, draw(st.floats(0.3, 0.45)), 1.0)
        given["point"] = tuple(
            Corner(x=r * math.cos(angle), y=r * math.sin(angle))
            for r, angle in zip(reach, angles, strict=True)
        )
    else:
        given["arm_width"] = diameter * draw(st.floats(0.1, 0.5))
    disc = Disc(diameter, section=name, **given)
    if draw(st.booleans()):
        most = 0.5 * diameter * disc.form.sharp.most_rounding
        disc = replace(disc, corner_radius=draw(st.floats(0.05, 0.95)) * most)
    return disc


def fine(outline):
    return outline.polygon(3000, 200)


def shoelace(points):
    x, y = points.T
    return 0.5 * float(x @ np.roll(y, -1) - y @ np.roll(x, -1))


@given(st.one_of(sections(), stars()))
@settings(max_examples=40)
def test_area_and_moments_are_those_of_a_fine_polygon(pillar):
    outline = pillar.outline
    loop = fine(outline)
    assert outline.area == pytest.approx(shoelace(loop), rel=1e-5)
    points, weights = outline.cubature(4)
    following = np.roll(loop, -1, axis=0)
    cross = loop[:, 0] * following[:, 1] - loop[:, 1] * following[:, 0]
    # integral of x^2 over a polygon
    exact = (cross * (loop[:, 0] ** 2 + loop[:, 0] * following[:, 0] + following[:, 0] ** 2)).sum() / 12
    assert weights @ points[:, 0] ** 2 == pytest.approx(exact, rel=1e-4)
    if isinstance(pillar, Pillar):
        assert pillar.volume == pytest.approx(outline.area * pillar.radius**2 * pillar.height, rel=1e-12)


@given(st.one_of(sections(), stars()), st.floats(-3.1, 3.1))
@settings(max_examples=40)
def test_the_support_is_the_farthest_point(pillar, angle):
    outline, direction = pillar.outline, np.array([[math.cos(angle), math.sin(angle)]])
    assert float(outline.support(direction)[0]) == pytest.approx(
        (fine(outline) @ direction[0]).max(), rel=1e-5
    )
    assert outline.inradius == pytest.approx(1.0, rel=1e-12)
    assert np.linalg.norm(fine(outline), axis=1).min() == pytest.approx(1.0, rel=1e-5)
    assert outline.reach == pytest.approx(np.linalg.norm(fine(outline), axis=1).max(), rel=1e-5)


@given(st.one_of(sections(), stars()), st.floats(-3.1, 3.1))
@settings(max_examples=40)
def test_a_turned_section_has_the_turned_outline(pillar, angle):
    turned = pillar.turned(angle)
    space = np.eye(3)
    space[:2, :2] = rotation(angle)
    assert pillar.is_image(turned, space)
    assert turned.outline.area == pytest.approx(pillar.outline.area, rel=1e-12)
    assert pillar.is_image(pillar, np.diag([1.0, -1.0, 1.0])) == pillar.has_symmetry(
        np.diag([1.0, -1.0, 1.0])
    )


@given(sections(), sections(), st.floats(0, 6.3), st.floats(6, 12))
@settings(max_examples=20)
def test_gaps_are_those_between_fine_polygons(pillar, other, angle, away):
    from scipy.spatial import cKDTree

    place = away * MM * np.array([math.cos(angle), math.sin(angle)])
    gap = float(pillar.raised.gap_to(other.raised, place[None])[0])
    here, there = pillar.radius * fine(pillar.outline), place + other.radius * fine(other.outline)
    nearest = float(cKDTree(here).query(there)[0].min())
    if gap > 0:
        assert gap == pytest.approx(nearest, abs=0.02 * MM)
        assert gap <= nearest * (1 + 1e-9)


@given(stars(), stars(), st.floats(0, 6.3), st.floats(6, 12))
@settings(max_examples=20)
def test_gaps_of_sections_that_bend_inwards_are_lower_bounds(disc, other, angle, away):
    from scipy.spatial import cKDTree

    place = away * MM * np.array([math.cos(angle), math.sin(angle)])
    gap = float(Scaled(disc.outline, disc.radius).gap_to(Scaled(other.outline, other.radius), place[None])[0])
    here, there = disc.radius * fine(disc.outline), place + other.radius * fine(other.outline)
    assert gap <= float(cKDTree(here).query(there)[0].min()) * (1 + 1e-9)


def test_the_area_of_arms_by_hand():
    """A cross is two bars without a square; six arms of width w leave a hexagon of width w in the middle."""
    span, width = 4 * MM, 1 * MM
    cross = Disc(span, section="cross", arm_width=width)
    assert cross.outline.area * cross.radius**2 == pytest.approx(2 * span * width - width**2, rel=1e-12)
    flake = Disc(span, section="snowflake", arm_width=width)
    hexagon, arm = 1.5 * math.sqrt(3) * width**2, width * (0.5 * span - math.sqrt(3) / 2 * width)
    assert flake.outline.area * flake.radius**2 == pytest.approx(hexagon + 6 * arm, rel=1e-12)
    assert flake.radius == pytest.approx(width, rel=1e-12)


def test_gaps_by_hand():
    square, circle = Scaled(Pillar(2.0, 1.0, "square").outline, 1.0), Scaled(CIRCLE, 1.0)
    places = np.array([[3.0, 0.0], [3.0, 3.0], [1.5, 0.0]])
    assert square.gap_to(square, places) == pytest.approx([1, math.sqrt(2), -0.5])
    assert circle.gap_to(circle, places) == pytest.approx([1, math.hypot(3, 3) - 2, -0.5])
    assert circle.gap_to(square, places) == pytest.approx([1, math.hypot(2, 2) - 1, -0.5])


SAME = {
    "a square is a polygon of four sides": (
        Pillar(3 * MM, 6 * MM, "square"),
        Pillar(3 * MM, 6 * MM, "polygon", sides=4),
    ),
    "an ellipse of equal axes is round": (
        Pillar(3 * MM, 6 * MM),
        Pillar(3 * MM, 6 * MM, "ellipse", length=3 * MM),
    ),
    "a square rounded to its middle is round": (
        Pillar(3 * MM, 6 * MM),
        Pillar(3 * MM, 6 * MM, "square", corner_radius=1.5 * MM),
    ),
    "a rectangle of equal sides is a square": (
        Pillar(3 * MM, 6 * MM, "square", turn=0.2),
        Pillar(3 * MM, 6 * MM, "rectangle", length=3 * MM, turn=0.2),
    ),
    "points of a hexagon are one": (
        Pillar(3 * MM, 6 * MM, "hexagon"),
        Pillar(
            3 * MM,
            6 * MM,
            "points",
            point=tuple(
                Corner(x=math.cos(a) / math.cos(math.pi / 6), y=math.sin(a) / math.cos(math.pi / 6))
                for a in -math.pi / 3 * (np.arange(6) + 0.5)
            ),
        ),
    ),
    "an ellipse turned by a right angle has exchanged axes": (
        Pillar(3 * MM, 6 * MM, "ellipse", length=2 * MM, turn=math.pi / 2),
        Pillar(2 * MM, 6 * MM, "ellipse", length=3 * MM),
    ),
}


@pytest.mark.parametrize(("pillar", "other"), SAME.values(), ids=SAME)
def test_sections_that_are_one(pillar, other):
    assert pillar.outline.is_same(other.outline)
    assert pillar.radius == pytest.approx(other.radius, rel=1e-12)
    assert pillar.volume == pytest.approx(other.volume, rel=1e-12)


GROUPS = {"square": 8, "hexagon": 12, "rectangle": 4, "ellipse": 4, "cross": 8, "snowflake": 12}


@pytest.mark.parametrize(("name", "order"), GROUPS.items())
def test_symmetry_is_that_of_the_section(name, order):
    more = {number: MM for number in ("length", "arm_width") if number in taken_by(SECTIONS[name])}
    outline = Disc(3 * MM, section=name, turn=0.3, **more).outline
    turns = [rotation(2 * math.pi * k / 24) for k in range(24)]
    mirrors = [rotation(2 * (0.3 + math.pi * k / 24)) @ np.diag([1.0, -1.0]) for k in range(24)]
    assert sum(outline.has_symmetry(turn) for turn in turns) == order // 2
    assert sum(outline.has_symmetry(turn) for turn in mirrors) == order // 2


REFUSED = {
    "a length of a round section": ({"length": MM}, "length", "conflict"),
    "an ellipse without a length": ({"section": "ellipse"}, "length", "missing"),
    "a polygon without sides": ({"section": "polygon"}, "sides", "missing"),
    "a turn of a round section": ({"turn": 0.1}, "turn", "conflict"),
    "corners that meet": ({"section": "square", "corner_radius": 2 * MM}, "corner_radius", "out-of-range"),
    "a draft of an ellipse": ({"section": "ellipse", "length": MM, "draft": 0.02}, "draft", "unsupported"),
    "a fillet under rounded corners": (
        {"section": "square", "corner_radius": 0.2 * MM, "fillet": 0.1 * MM},
        "fillet",
        "unsupported",
    ),
    "points that bend inwards": (
        {
            "section": "points",
            "point": tuple(Corner(x=x, y=y) for x, y in ((1, 0), (0.3, 0.3), (0, 1), (-1, -1))),
        },
        "section",
        "unsupported",
    ),
    "points that hide a corner": (
        {
            "section": "points",
            "point": tuple(
                Corner(x=x, y=y) for x, y in ((1, -1), (1, 0.6), (0.4, 0.2), (0.5, 1), (-1, 1), (-1, -1))
            ),
        },
        "point",
        "out-of-range",
    ),
    "a notch like a sliver": (
        {
            "section": "points",
            "point": tuple(Corner(x=x, y=y) for x, y in ((1, 0.1), (0.4, 0.15), (1, 0.2), (-1, 1), (-1, -1))),
        },
        "point",
        "out-of-range",
    ),
    "a pillar with arms": ({"section": "cross"}, "section", "unsupported"),
    "points beside the axis": (
        {"section": "points", "point": tuple(Corner(x=x, y=y) for x, y in ((1, 1), (2, 1), (2, 2)))},
        "point",
        "out-of-range",
    ),
}


@pytest.mark.parametrize(("changes", "at", "code"), REFUSED.values(), ids=REFUSED)
def test_numbers_that_make_no_section_are_refused(changes, at, code):
    with refusing(GeometryError, code, f"cell.pillar.{at}"):
        Pillar(3 * MM, 6 * MM, **changes)


@given(sections(), st.floats(1e-3, 1e3))
@settings(max_examples=20)
def test_scaling_keeps_the_outline(pillar, factor):
    assert pillar.scaled(factor).outline.is_same(pillar.outline)
    assert pillar.scaled(factor).radius == pytest.approx(factor * pillar.radius)


def test_above_a_step_the_section_is_a_scaled_copy():
    pillar = Pillar(3 * MM, 6 * MM, "ellipse", length=2 * MM, step=Step(1.5 * MM, 4 * MM))
    assert pillar.above_step.outline.is_same(pillar.outline)
    assert pillar.above_step.radius == pytest.approx(0.5 * pillar.radius)
    below = math.pi * 1.5 * MM * MM * 4 * MM
    assert pillar.volume == pytest.approx(below + math.pi * 0.75 * MM * 0.5 * MM * 2 * MM, rel=1e-12)


def test_every_number_of_a_section_is_a_field_of_a_disc():
    assert set(NUMBERS) <= set(Disc.__dataclass_fields__)
    assert set(NUMBERS) - {"arm_width"} <= set(Pillar.__dataclass_fields__)


@pytest.mark.parametrize("width", [0.1 * MM, 2.9 * MM])
def test_arms_like_slivers_and_arms_without_notches_are_refused(width):
    with refusing(GeometryError, "out-of-range", "cell.disc.arm_width"):
        Disc(3 * MM, section="cross", arm_width=width)


@pytest.mark.parametrize("section", ["round", "cross"])
def test_a_disc_leaves_a_hundredth_of_the_pitch_free_whatever_its_section(section):
    arm = 2 * MM if section == "cross" else None

    def cell(diameter: float) -> UnitCell:
        disc = Disc(diameter, section=section, arm_width=arm, empty=True)
        return UnitCell(Lattice.square(8 * MM), 1 * MM, ALUMINIUM, disc=(disc,))

    assert cell(7.83 * MM).discs
    with refusing(GeometryError, "out-of-range", "cell.disc[1].diameter") as caught:
        cell(7.85 * MM)
    assert caught.value.allowed.startswith("less than 7.84 mm")
