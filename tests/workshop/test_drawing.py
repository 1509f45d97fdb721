"""The drawing: its words, that it can be read, and that it is one reproducible page."""

import datetime
import io
import math
import re
from dataclasses import replace
from functools import cache
from itertools import chain, combinations

import ezdxf
import numpy as np
import pytest
from family import EXTREME, FAMILY, LATTICES, METAL, MM, OWN, PLATES, RECTANGLE, cell
from hypothesis import example, given, settings, strategies as st
from matplotlib.font_manager import FontProperties
from matplotlib.path import Path
from matplotlib.textpath import TextPath
from matplotlib.transforms import Affine2D

from daily import daily
from five_parts import refusing
from haptonic.cell import Pillar, Site, Step, UnitCell
from haptonic.cell.tile import enclosed
from haptonic.errors import ResourceError, StudyError
from haptonic.lattice import Lattice
from haptonic.materials import OrthotropicMaterial, material
from haptonic.names import visible
from haptonic.workshop import Part, part_drawing, write_drawing
from haptonic.workshop.dxf import outlines
from haptonic.workshop.section import Row, nearest
from haptonic.workshop.shape import dimensions_of
from haptonic.workshop.sheet import POINT, Sheet
from stacks import DRAFTED, STACKS

ALL = FAMILY | EXTREME
STEPPED = cell(Pillar(3.5 * MM, 9 * MM, "round", math.radians(2), 0.5 * MM, Step(2 * MM, 5 * MM)), RECTANGLE)


def toleranced(the_cell):
    """A tolerance on everything: the longest texts."""
    return {
        name: math.radians(0.25) if name.endswith("draft") else min(2e-5, 0.4 * abs(value))
        for name, value in dimensions_of(the_cell).items()
    }


THIN, WIDE = Pillar(2 * MM, 4 * MM), Pillar(1.8 * MM, 5 * MM, fillet=0.3 * MM)
OTHERS = {
    "honeycomb": UnitCell(
        Lattice(lattice="honeycomb", pitch=7 * MM),
        1.5 * MM,
        METAL,
        site=(Site(pillar=THIN), Site(pillar=WIDE)),
    ),
    "oblique": UnitCell(Lattice.oblique(7 * MM, 7.5 * MM, 1.3), 1.5 * MM, METAL, WIDE),
    "both faces": replace(STEPPED, faces="both"),
    "turned bars": cell(Pillar(2 * MM, 4 * MM, "rectangle", length=3 * MM, turn=0.4), RECTANGLE),
    "blind holes": UnitCell(RECTANGLE, 1.5 * MM, METAL, disc=STACKS["blind hole"]),
    "coated inclusions": UnitCell(RECTANGLE, 1.5 * MM, METAL, disc=STACKS["coated inclusion"]),
    "caps on cones": UnitCell(RECTANGLE, 1.5 * MM, METAL, disc=DRAFTED["cap on a cone"]),
    "hollow pillars": UnitCell(RECTANGLE, 1.5 * MM, METAL, disc=STACKS["hollow pillar"], faces="both"),
    "hexagons of epoxy": cell(Pillar(3 * MM, 4 * MM, "hexagon", material=material("silver-epoxy"))),
}


# the most dimensions, the smallest and the flattest body, both faces, discs, and a plate with a hole
DAILY = (
    "no pillar", "round draft 2 fillet 0.0005 step True", "square draft -3 fillet 0.0005 step True", "hair",
    "flat and undercut", "both faces", "honeycomb", "hollow pillars", "hole and cut corner",
)  # fmt: skip


def part_of(name):
    if name in OTHERS:
        return Part.piece(OTHERS[name], 4, 3)
    return Part.whole(PLATES[name], OWN) if name in PLATES else Part.piece(ALL[name], 12, 8)


@cache
def sheet_of(name):
    the_cell = OWN if name in PLATES else (ALL | OTHERS)[name]
    return part_drawing(part_of(name), "A plate with a title", tolerances=toleranced(the_cell))


def written(entity):
    """Text of a dimension, as it is drawn in the file."""
    return "".join(e.plain_text() for e in entity.virtual_entities() if e.dxftype() == "MTEXT")


def words(sheet):
    space = sheet.space
    shown = [e.dxf.text for e in space.query("TEXT")] + [written(e) for e in space.query("DIMENSION")]
    return shown + [line for e in space.query("MTEXT") for line in e.plain_text(split=True)]


def ink(text):
    """Left, bottom, right and top of what is printed of a text in a picture, mm."""
    size, weight = text.get_fontsize(), text.get_fontweight()
    font = FontProperties(family="DejaVu Sans", weight=weight)
    path = TextPath((0, 0), text.get_text(), size=size, prop=font)
    turned = path.transformed(Affine2D().rotate_deg(text.get_rotation()))
    # no letter reaches beyond the points that control its curves
    reached = turned.vertices[turned.codes != Path.CLOSEPOLY] * POINT
    low, high = reached.min(axis=0), reached.max(axis=0)
    x, y = text.get_position()
    assert text.get_horizontalalignment() == "left"
    assert text.get_verticalalignment() == "baseline"
    return x + low[0], y + low[1], x + high[0], y + high[1]


def stretches(figure):
    """(n, 2, 2) every line of a picture, mm."""
    axes = figure.axes[0]
    paths = [line.get_path() for line in axes.lines]
    paths += [path for part in axes.collections for path in part.get_paths()]
    paths += [patch.get_path() for patch in axes.patches]
    lines = [points for path in paths for points in path.to_polygons(closed_only=False)]
    return np.concatenate([np.stack([line[:-1], line[1:]], axis=1) for line in lines])


def crossing(box, lines):
    """Which stretches run through a box, by clipping them to it."""
    enter, leave, misses = np.zeros(len(lines)), np.ones(len(lines)), np.zeros(len(lines), bool)
    for k in (0, 1):
        low, high, a, b = box[k], box[k + 2], lines[:, 0, k], lines[:, 1, k]
        with np.errstate(divide="ignore", invalid="ignore"):
            ends = np.sort([(low - a) / (b - a), (high - a) / (b - a)], axis=0)
        level = a == b
        misses |= level & ((a <= low) | (a >= high))
        enter = np.where(level, enter, np.maximum(enter, ends[0]))
        leave = np.where(level, leave, np.minimum(leave, ends[1]))
    return lines[(enter < leave) & ~misses]


@pytest.mark.parametrize("name", daily([*ALL, *PLATES, *OTHERS], *DAILY))
def test_no_text_lies_on_another_or_on_a_line_or_leaves_the_frame(name):
    figure = sheet_of(name).figure()
    texts = [(text.get_text(), ink(text)) for text in figure.axes[0].texts]
    assert len(texts) > 25
    right, top = (side - 10 for side in sheet_of(name).size)
    lines = stretches(figure)
    for text, (x0, y0, x1, y1) in texts:
        assert 10 < x0 < x1 < right, text
        assert 10 < y0 < y1 < top, text
        assert not len(crossing((x0, y0, x1, y1), lines)), (text, crossing((x0, y0, x1, y1), lines))
    for (first, a), (second, b) in combinations(texts, 2):
        assert a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1], (first, second)


def test_a_line_through_a_text_is_noticed():
    lines = np.array(
        [[[0, 0], [4, 4]], [[0, 2], [4, 2]], [[2, 0], [2, 4]], [[0, 3.5], [4, 3.5]]], dtype=float
    )
    assert crossing((1, 1, 3, 3), lines).tolist() == lines[:3].tolist()


@pytest.mark.parametrize("name", daily(ALL, *(name for name in DAILY if name in ALL)))
def test_every_dimension_is_given_with_its_tolerance_and_lengths_are_measured(name, tmp_path):
    the_cell, tolerances = ALL[name], toleranced(ALL[name])
    sheet_of(name).document.saveas(tmp_path / "sheet.dxf")
    document = ezdxf.readfile(tmp_path / "sheet.dxf")
    assert not document.audit().has_errors
    shown = words(sheet_of(name))
    measured = []
    for dimension in document.paperspace("Drawing").query("DIMENSION"):
        if dimension.dimtype != 0:  # numbers beside an edge are ordinates
            continue
        style = dimension.override()
        value = dimension.get_measurement() * style.get("dimlfac")
        tolerance = style.get("dimtp", 0.0) if style.get("dimtol", 0) else 0.0
        measured.append((value, tolerance, written(dimension)))
    if the_cell.pillar is None:  # no pillar, no pitch
        assert any("1.500 ±0.020" in word for word in shown)
        return
    for key, value in dimensions_of(the_cell).items():
        if key.endswith("draft"):
            text = f"draft {math.degrees(value):.2f}° ±0.25°".replace("-", "\N{MINUS SIGN}")
            assert text in shown
            continue
        text = f"{value * 1e3:.3f} ±{tolerances[key] * 1e3:.3f}"
        assert any(text in word for word in shown), (key, text)
        is_hidden = key.endswith("step.diameter") and the_cell.pillar.draft < 0
        if is_hidden or key.endswith(("fillet", "pitch_y")):
            continue  # shown by a leader or in the list
        assert any(
            (length, tolerance) == pytest.approx((value * 1e3, tolerances[key] * 1e3), rel=1e-6)
            and word.endswith(text)
            for length, tolerance, word in measured
        ), key


def test_the_words_beside_the_views():
    part = Part.piece(STEPPED, 2, 3)
    sheet = part_drawing(part, "Plate", tolerances={"cell.pillar.diameter": 2e-5}, date=None)
    shown = words(sheet)
    for text in (
        "⌀3.500 ±0.020", "⌀2", "(⌀1.721)", "R0.5", "draft 2°", "5", "9", "1.5", "7", "14", "27", "3.5",
        "10.5", "4.5", "22.5", "touch face, keep flat", "dimensions in mm", "metal", "5 : 1", "ISO 2768-m",
        "6 pillars", "2.42 g", "Section along x   5 : 1",
        "14 \N{MULTIPLICATION SIGN} 27 \N{MULTIPLICATION SIGN} 1.5",
    ):  # fmt: skip
        assert text in shown, text
    notes = " ".join(shown)
    assert "tool radius at most 1.75." in notes
    assert "corner radius, 0.5." in notes
    assert "2026-02-03" in words(part_drawing(Part.piece(STEPPED), "Plate", date=datetime.date(2026, 2, 3)))
    assert not re.search(r"\d{4}-\d\d-\d\d", notes)


def scale_of(sheet, title):
    (shown,) = [word for word in words(sheet) if word.startswith(title)]
    size, true_size = re.search(r"(\d+) : (\d+)$", shown).groups()
    return int(size) / int(true_size)


def extent(points):
    return np.ptp(np.array([tuple(point)[:2] for point in points]), axis=0)


@pytest.mark.parametrize("name", daily([*ALL, *OTHERS, *PLATES], *DAILY))
def test_the_views_are_to_scale_and_the_section_has_the_area_of_the_cut(name):
    sheet, part = sheet_of(name), part_of(name)
    plan, section = sheet.space.query("VIEWPORT")[-2:]
    for window, title in ((plan, "Plan"), (section, "Section along x")):
        assert window.dxf.height / window.dxf.view_height == pytest.approx(scale_of(sheet, title), rel=1e-9)
    assert (plan.dxf.width, plan.dxf.height) == pytest.approx(
        scale_of(sheet, "Plan") * np.array(part.size) + 1
    )
    row = Row.of(part)
    hatched = sheet.document.modelspace().query("HATCH")
    areas = [enclosed(np.array(list(hatch.paths[0].vertices))[:, :2]) for hatch in hatched]
    if part.stacks:
        return  # see test_disc_files.py
    assert areas[-1] == pytest.approx((row.high - row.low) * part.cell.thickness)
    assert len(areas) == 1 + len(row.features) * part.cell.copies
    for (pillar, _), area in zip(row.features, areas[:: part.cell.copies], strict=False):
        if pillar.step is None and not pillar.fillet and pillar.section in ("round", "square", "hexagon"):
            trapezoid = pillar.height * (pillar.diameter - pillar.height * math.tan(pillar.draft))
            assert abs(area) == pytest.approx(trapezoid)
        if pillar.section == "rectangle":  # cut along x through its long sides
            assert abs(area) == pytest.approx(pillar.height * pillar.diameter / math.cos(pillar.turn))


class TestWholePlate:
    def test_the_list_has_number_and_sizes_of_every_kind_and_the_patches(self):
        shown = words(sheet_of("hole and cut corner"))
        for text in (
            "11 round, ⌀3.000 ±0.020, height 9.000 ±0.020, fillet 0.300 ±0.020, draft 0.57° ±0.25°, "
            "next along x 7.000 ±0.020, next along y 9.000 ±0.020",
            "8 square, □2, height 8, fillet 0.4, step height 5, step □1.5, next along x 7, next along y 9",
            "3 round, ⌀3.5, height 11, next along y 9",
            "centre 24.5, 4, size 6, 5, 0.5, pzt-5a, 0.05 of silver-epoxy below it",
        ):
            assert any(text in word for word in shown), text
        numbers = (
            "36",
            "49",
            "22 pillars",
            "A1",
            "A",
            "C",
            "49 \N{MULTIPLICATION SIGN} 36 \N{MULTIPLICATION SIGN} 1.5",
        )
        assert set(numbers) < set(shown)

    def test_dimensions_measure_the_outline_and_the_places_of_the_outermost_axes(self):
        sheet = sheet_of("hole and cut corner")
        window = sheet.space.query("VIEWPORT")[-2].dxf
        assert tuple(window.view_center_point)[:2] == pytest.approx((24.5, 18))
        measured = {
            round(d.get_measurement() * d.override().get("dimlfac"), 6)
            if d.dimtype == 0
            else float(written(d))
            for d in sheet.space.query("DIMENSION")
        }
        # along x: the first and last axis, the hole, the cut corner; along y alike; the sizes over all
        assert {3.5, 14, 28, 42, 45.5, 4.5, 9, 18, 27, 31.5, 49, 36} <= measured

    def test_supports_are_marked_on_their_edge_and_beside_it_in_the_plan(self):
        """The plate misses a corner of its map; its hole has sides that look left and up."""
        wanted = {
            "clamped": [((0, 0), (8, 0)), ((41, 0), (49, 0)), ((0, 36), (8, 36)), ((0, 0), (0, 8)),
                        ((49, 0), (49, 8)), ((0, 28), (0, 36))],
            "simple support": [((0, 0), (0, 36)), ((28, 9), (28, 18))],
            "elastic foundation": [((0, 36), (42, 36)), ((42, 27), (49, 27)), ((14, 9), (28, 9))],
        }  # fmt: skip
        sheet = sheet_of("hole and cut corner")
        scale, window = scale_of(sheet, "Plan"), sheet.space.query("VIEWPORT")[-2].dxf
        origin = np.array(window.center)[:2] - scale * np.array(window.view_center_point)[:2]
        marks = sheet.document.modelspace().query('*[layer=="HELD"]')
        marked = np.array(sorted(sorted(line.get_points("xy")) for line in marks))
        assert marked == pytest.approx(np.array(sorted(chain(*wanted.values()))), abs=1e-9)
        for name, ends in wanted.items():
            lines = [np.array([line.dxf.start, line.dxf.end])[:, :2]
                     for line in sheet.space.query(f'LINE[layer=="{name.upper()}"]')]  # fmt: skip
            *beside, sample = sorted(lines, key=lambda line: -line[0, 1])  # the legend is below the plan
            placed = np.array(sorted(np.sort((line - origin) / scale, axis=0).tolist() for line in beside))
            for line in placed:
                apart = scale * min(np.abs(line - end).max() for end in np.array(ends))
                assert apart == pytest.approx(1.2), name
            assert len(placed) == len(ends)
            at = [text.dxf.insert.x for text in sheet.space.query("TEXT") if text.dxf.text.startswith(name)]
            assert at == [pytest.approx(sample.max(axis=0)[0] + 2)]
        assert "clamped, 8 from the corners" in words(sheet)
        left = min(line.dxf.start.x for line in sheet.space.query('LINE[layer=="SIMPLE SUPPORT"]')[:2])
        assert left == pytest.approx(origin[0] - 1.2)  # outside
        assert not any(word.startswith("Thick lines") for word in words(sheet_of("touchpad")))

    def test_tolerances_belong_to_the_studys_own_pillar(self):
        other = part_drawing(Part.whole(PLATES["plain"], cell(None, RECTANGLE)), "Plain")
        assert not any("±" in word for word in words(other))
        assert "0 pillars" in words(other)
        assert "Section along x   10 : 1" in words(other)
        strange = part_drawing(
            Part.whole(PLATES["long"], LATTICES["slim"]), "Long", tolerances={"cell.pillar.height": 5e-5}
        )
        assert not any("±" in word for word in words(strange))


def test_tolerances_of_discs_are_on_the_section_and_in_the_list():
    """A height has one where its length counts from the plate, and is for reference between two others."""
    glued = UnitCell(RECTANGLE, 1.5 * MM, METAL, disc=STACKS["pillar on glue"])
    glue, pillar = glued.disc
    tolerances = {"cell.disc[1].diameter": 1e-5, "cell.disc[1].high": 2e-5, "cell.disc[2].low": 2e-5,
                  "cell.disc[2].high": 5e-5}  # fmt: skip
    sheet = part_drawing(Part.piece(glued), "Plate", tolerances=tolerances)
    shown = words(sheet)
    joint, top = f"{glue.high / MM:.3f} ±0.020", f"{pillar.high / MM:.3f} ±0.050"
    assert {joint, top} <= set(shown)
    assert f"({(pillar.high - glue.high) / MM:g})" in shown
    assert f"⌀{glue.diameter / MM:.3f} ±0.010 {glue.material.name}" in shown
    assert f"⌀{pillar.diameter / MM:g} {pillar.material.name}" in shown
    listed = " ".join(shown)
    assert f"⌀{glue.diameter / MM:.3f} ±0.010 from 0 to {joint} {glue.material.name}" in listed
    assert f"⌀{pillar.diameter / MM:g} from {joint} to {top} {pillar.material.name}" in listed
    assert "No dimension has a tolerance" not in listed


def test_a_leader_that_is_too_long_ends_inside_the_frame():
    name = "a material whose name is much longer than the room beside the section"
    coated = tuple(replace(disc, material=replace(METAL, name=name)) for disc in STACKS["pillar on glue"])
    shown = words(part_drawing(Part.piece(UnitCell(RECTANGLE, 1.5 * MM, METAL, disc=coated)), "Plate"))
    assert sum(word.startswith("⌀") and word.endswith("…") for word in shown) == 2


def test_a_fine_tolerance_is_not_shown_as_zero():
    texts = words(part_drawing(Part.piece(STEPPED), "Plate", tolerances={"cell.thickness": 2e-7}))
    assert "1.50000 ±0.00020" in texts


def test_pitches_of_nanometres_are_not_rounded_away():
    small = UnitCell(Lattice.triangular(526e-9), 200e-9, METAL, Pillar(300e-9, 400e-9))
    part = Part.piece(small, 3, 3)
    ((_, places),) = part.standing
    assert nearest(places, 0)[1] == pytest.approx(526e-6, rel=1e-9)
    assert nearest(places, 1)[1] == pytest.approx(526e-6 * math.sqrt(3), rel=1e-9)
    shown = " ".join(words(part_drawing(part, "Plate", tolerances={"cell.pitch": 1e-9})))
    assert "next along x 0.0005260 ±0.0000010, next along y 0.0009111" in shown


def test_the_axes_of_crystals_are_noted():
    for turn, words_of_turn in ((math.radians(45), "at 45° to x, anticlockwise"), (0.0, "along x")):
        silicon = OrthotropicMaterial(c11=166e9, c12=64e9, c44=80e9, density=2330, name="Si", turn=turn)
        shown = words(part_drawing(Part.piece(replace(STEPPED, material=silicon)), "Plate"))
        assert any(f"Axis 1 of Si lies {words_of_turn}" in word for word in shown)


def test_lengths_of_micrometres_are_not_rounded_away():
    small = UnitCell(Lattice.square(10e-6), 2.25e-6, METAL, Pillar(5.125e-6, 12.55e-6))
    shown = words(part_drawing(Part.piece(small), "Plate", tolerances={"cell.pillar.diameter": 1e-8}))
    assert {"0.00225", "0.01255", "⌀0.005125 ±0.000010", "none"} <= set(shown)
    listed = " ".join(shown)
    assert "side to side, 0.004875: tool radius at most 0.002437." in listed
    assert "ISO 2768 begins at 0.5 mm" in listed
    assert "ISO 2768" not in " ".join(words(part_drawing(Part.piece(STEPPED), "Plate"))).replace(
        "ISO 2768-m", ""
    )


@pytest.mark.parametrize(
    ("tolerances", "code"),
    [
        ({"cell.pillar.diametre": 1e-5}, "unknown"),
        ({"cell.thickness": 0.02}, "out-of-range"),
        ({"cell.thickness": -1e-6}, "out-of-range"),
        ({"cell.thickness": math.nan}, "out-of-range"),
    ],
)
def test_tolerances_that_mean_nothing_are_refused(tolerances, code):
    with refusing(StudyError, code, f"tolerances.{next(iter(tolerances))}"):
        part_drawing(Part.piece(STEPPED), "Plate", tolerances=tolerances)


def test_a_piece_of_other_cells_has_a_plan_with_every_pillar_and_lists_of_their_kinds():
    sheet = sheet_of("honeycomb")
    model, texts = sheet.document.modelspace(), words(sheet)
    assert len(model.query('*[layer=="PILLAR"]')) == 24
    assert nearest(part_of("honeycomb").standing[0][1], 0)[1] == pytest.approx(7)
    for text in (
        "12 round, ⌀2.000 ±0.020", "12 round, ⌀1.800 ±0.020, height 5.000 ±0.020",
        "fillet 0.300 ±0.020", "next along x 7.000 ±0.020, next along y 12.12",
        "24 pillars", "Section along x   5 : 1",
    ):  # fmt: skip
        assert any(text in word for word in texts), text
    way = 7 / 3**0.5 - 1.9  # between axes of neighbours, less half the sum of their diameters
    assert any(f"side to side, {way:.3f}: tool radius at most {way / 2:.3f}" in word for word in texts)
    assert any("repeat after (7, 0) and (3.5, 6.062)" in word for word in texts)


@pytest.mark.parametrize(
    ("lattice", "count", "size"),
    [
        (Lattice.triangular(10 * MM), (3, 2), "30 x 20 x 1.5, angle 60°"),
        (Lattice.oblique(7 * MM, 7.5 * MM, math.radians(100)), (2, 2), "14 x 15 x 1.5, angle 80°"),
        (Lattice.rectangular(6.125 * MM, math.sqrt(75) * MM), (5, 2), "30.625 x 17.32 x 1.5"),
    ],
)
def test_the_title_block_has_sides_and_angle_of_a_piece_and_no_digits_beyond_iso_2768(lattice, count, size):
    part = Part.piece(UnitCell(lattice, 1.5 * MM, METAL, Pillar(3 * MM, 4 * MM)), *count)
    shown = words(part_drawing(part, "Plate"))
    assert size.replace("x", "\N{MULTIPLICATION SIGN}") in shown
    assert not any(re.search(r"\d\.\d{4}", word) for word in shown)


def test_notes_name_the_kinds_that_the_section_does_not_show_and_its_hatches_only_if_it_has_several():
    """A kagome lattice has its first sites on rows of their own, the others on the rows between."""
    glued, hole, steel = (Site(disc=STACKS[name]) for name in ("pillar on glue", "hole", "inclusion"))
    kagome = Lattice(lattice="kagome", pitch=20 * MM)
    hatches = "Each hatch of the section is a material; the list names them."
    for sites, hatched, hidden in (
        ((hole, glued, steel), False, "B and C"),
        ((glued, steel, hole), True, "B and C"),
        ((glued, hole, glued), True, ""),
        ((glued, glued, glued), True, ""),
    ):
        shown = words(part_drawing(Part.piece(UnitCell(kagome, 1.5 * MM, METAL, site=sites), 3, 2), "Plate"))
        assert any(hatches in word for word in shown) is hatched
        notes = [word.split("show ")[1] for word in shown if "The section does not show" in word]
        assert notes == [f"{hidden}: the list gives their heights."] * bool(hidden)


def test_a_tolerance_is_that_of_the_table_which_gives_the_pillar():
    part = Part.piece(OTHERS["honeycomb"], 2, 2)
    texts = words(part_drawing(part, "Plate", tolerances={"cell.site[2].pillar.height": 2e-5}))
    assert any("height 5.000 ±0.020" in word for word in texts)
    assert any("height 4," in word for word in texts)
    with refusing(StudyError, "unknown", "tolerances.cell.pillar.height"):
        part_drawing(part, "Plate", tolerances={"cell.pillar.height": 2e-5})
    assert set(dimensions_of(OTHERS["oblique"])) >= {"cell.pitch", "cell.pitch_2", "cell.angle"}
    assert "cell.pitch_y" not in dimensions_of(OTHERS["honeycomb"])


def test_long_names_stay_in_their_boxes():
    figure = part_drawing(Part.piece(cell(None)), "A very long title " * 10).figure()
    (title,) = [text for text in figure.axes[0].texts if text.get_text().startswith("A very long")]
    assert title.get_text().endswith("…")
    assert ink(title)[2] < 388  # before the symbol of projection


@settings(max_examples=20, deadline=None)
@given(st.text(st.characters(codec="latin-1"), max_size=12))
@example("$x_$ %%c ^J {")
@example("\\P %%% ^ ")
@example("a\n  0\nEOF\n")
@example("^")
def test_a_title_means_itself_and_breaks_nothing(title):
    """Carets, per cent signs, backslashes and ends of line are codes of DXF, the dollar of mathtext."""
    sheet = Sheet.of(outlines(Part.piece(cell(None))))
    sheet.text((20, 20), title)
    sheet.notes((20, 100), "Notes", {"1": title}, 200)
    stream = io.StringIO()
    sheet.document.write(stream)
    stream.seek(0)
    document = ezdxf.read(stream)
    assert not document.audit().has_errors
    space = document.paperspace("Drawing")
    wanted = re.sub(r"[\t\n]", " ", visible(title)).replace("%%", "% %")
    wanted += "\N{NO-BREAK SPACE}" * wanted.endswith("^")  # else a reader takes the caret away
    (text,), (notes,) = space.query("TEXT"), space.query("MTEXT")
    assert text.plain_text() == wanted
    assert wanted in notes.plain_text()
    figure = Sheet(document, space).figure()
    assert not wanted.strip() or wanted in [shown.get_text() for shown in figure.axes[0].texts]


def test_the_pdf_is_one_a3_page_and_the_same_every_time(tmp_path):
    first, second = (
        write_drawing(tmp_path / f"{name}.pdf", part_drawing(Part.piece(STEPPED), "Plate")) for name in "ab"
    )
    content = first.read_bytes()
    assert content == second.read_bytes()
    assert content.startswith(b"%PDF")
    assert len(re.findall(rb"/Type /Page\b", content)) == 1
    box = re.search(rb"/MediaBox \[ 0 0 ([\d.]+) ([\d.]+) \]", content)
    assert [float(side) / 72 * 25.4 for side in box.groups()] == pytest.approx([420, 297], abs=0.1)
    assert b"CreationDate" not in content
    assert re.search(rb"/BaseFont /\w*\+?DejaVuSans\b", content)  # text is text
    day = datetime.date(2026, 2, 3)
    dated = write_drawing(tmp_path / "c.pdf", part_drawing(Part.piece(cell(None)), "Plate", date=day))
    assert b"CreationDate (D:20260203" in dated.read_bytes()


@pytest.mark.parametrize(("kind", "start"), [("dxf", b"  0\n"), ("svg", b"<?xml"), ("png", b"\x89PNG")])
def test_the_ending_of_the_path_chooses_the_kind(kind, start, tmp_path):
    part = Part.piece(cell(None))
    first, second = (write_drawing(tmp_path / f"{name}.{kind}", part_drawing(part, "Plate")) for name in "ab")
    assert first.read_bytes() == second.read_bytes()
    assert first.read_bytes().startswith(start)


def test_a_file_is_not_replaced_unasked(tmp_path):
    path = tmp_path / "a.pdf"
    path.write_text("mine")
    sheet = part_drawing(Part.piece(cell(None)), "Plate")
    with refusing(ResourceError, "repeated", "output file"):
        write_drawing(path, sheet)
    assert path.read_text() == "mine"
    write_drawing(path, sheet, overwrite=True)
    assert path.read_bytes().startswith(b"%PDF")
