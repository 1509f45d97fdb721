"""The drawing: what it says, that it can be read, and that it is one reproducible page."""

import datetime
import math
import re
from functools import cache
from itertools import combinations, pairwise

import numpy as np
import pytest
from family import EXTREME, FAMILY, METAL, MM, RECTANGLE, cell
from matplotlib.backends.backend_agg import FigureCanvasAgg

from haptonic.cell import Pillar, Step, UnitCell
from haptonic.errors import GeometryError, ResourceError, StudyError
from haptonic.lattice import Lattice
from haptonic.workshop import cell_drawing, write_drawing
from haptonic.workshop.dimensions import dimensions_of

ALL = FAMILY | EXTREME
STEPPED = cell(Pillar(3.5 * MM, 9 * MM, "round", math.radians(2), 0.5 * MM, Step(2 * MM, 5 * MM)), RECTANGLE)


def toleranced(the_cell):
    """A tolerance on everything: the longest texts."""
    return {
        name: math.radians(0.25) if name.endswith("draft") else min(2e-5, 0.4 * value)
        for name, value in dimensions_of(the_cell).items()
    }


@cache
def figure_of(name):
    return cell_drawing(ALL[name], "A plate with a title", 12, 8, tolerances=toleranced(ALL[name]))


def words(figure):
    return [text.get_text() for text in figure.axes[0].texts]


def boxes(figure):
    FigureCanvasAgg(figure).draw()
    return [(text.get_text(), text.get_window_extent()) for text in figure.axes[0].texts]


def crosses(box, one, other):
    """Whether a stretch runs through a box, by clipping it to the box."""
    enter, leave = 0.0, 1.0
    for low, high, a, b in ((box.x0, box.x1, one[0], other[0]), (box.y0, box.y1, one[1], other[1])):
        low, high = low + 1, high - 1  # pixels that a glyph does not fill
        if a == b:
            if not low < a < high:
                return False
            continue
        first, last = sorted(((low - a) / (b - a), (high - a) / (b - a)))
        enter, leave = max(enter, first), min(leave, last)
    return enter < leave


@pytest.mark.parametrize("name", ALL)
def test_no_text_lies_on_another_or_on_a_line_or_leaves_the_frame(name):
    figure = figure_of(name)
    texts = boxes(figure)
    axes = figure.axes[0]
    (left, bottom), (right, top) = axes.transData.transform([(10, 10), (287, 200)])
    for text, box in texts:
        assert left < box.x0 < box.x1 < right, text
        assert bottom < box.y0 < box.y1 < top, text
    for (one, a), (other, b) in combinations(texts, 2):
        assert not a.overlaps(b), (one, other)
    for line in axes.lines:
        for start, end in pairwise(axes.transData.transform(line.get_xydata())):
            for text, box in texts:
                assert not crosses(box, start, end), (text, start, end)


@pytest.mark.parametrize("name", ALL)
def test_every_dimension_is_given_with_its_tolerance(name):
    tolerances = toleranced(ALL[name])
    found = words(figure_of(name))
    for key, value in dimensions_of(ALL[name]).items():
        if key.endswith("draft"):
            text = f"{math.degrees(value):.2f}° ± 0.25°".replace("-", "\N{MINUS SIGN}")
        else:
            text = f"{value * 1e3:.3f} ± {tolerances[key] * 1e3:.3f}"
        assert any(word.endswith(text) for word in found), (key, text)


def test_the_words_beside_the_views():
    figure = cell_drawing(STEPPED, "Plate", 2, 3, tolerances={"cell.pillar.diameter": 2e-5}, date=None)
    found = words(figure)
    for text in (
        "⌀3.500 ± 0.020", "⌀2", "(⌀1.721)", "R0.5", "draft 2°", "5", "9", "1.5", "7",
        "touch face, keep flat", "dimensions in mm", "metal", "2 \N{MULTIPLICATION SIGN} 3 = 6", "5 : 1",
        "14 \N{MULTIPLICATION SIGN} 27",
    ):  # fmt: skip
        assert text in found, text
    notes = " ".join(found)
    assert "tool radius at most 1.75." in notes
    assert "corner radius, 0.5." in notes
    assert "DATE" not in notes
    assert "2026-02-03" in words(cell_drawing(STEPPED, "Plate", date=datetime.date(2026, 2, 3)))


@pytest.mark.parametrize("name", ALL)
def test_the_views_are_to_scale(name):
    figure = figure_of(name)
    titles = [word for word in words(figure) if re.search(r"^(Plan|A-A).* : ", word)]
    scales = [int(a) / int(b) for a, b in (re.search(r"(\d+) : (\d+)", t).groups() for t in titles)]
    (hatched,) = [patch for patch in figure.axes[0].patches if patch.get_hatch()]
    pillar = ALL[name].pillar
    total = ALL[name].thickness + (pillar.height if pillar else 0)
    across, up = np.ptp(hatched.get_path().vertices, axis=0)
    assert (across, up) == pytest.approx(
        (scales[1] * ALL[name].lattice.pitch * 1e3, scales[1] * total * 1e3), rel=1e-9
    )
    squares = [line.get_xydata() for line in figure.axes[0].lines if len(line.get_xydata()) == 5]
    sides = [scales[0] * side * 1e3 for side in (ALL[name].lattice.a1[0], ALL[name].lattice.a2[1])]
    assert any(np.ptp(square, axis=0) == pytest.approx(sides, rel=1e-9) for square in squares)


def test_a_fine_tolerance_is_not_shown_as_zero():
    found = words(cell_drawing(STEPPED, "Plate", tolerances={"cell.thickness": 2e-7}))
    assert "1.5000 ± 0.0002" in found


@pytest.mark.parametrize(
    ("tolerances", "message"),
    [
        ({"cell.pillar.diametre": 1e-5}, 'write "cell.pillar.diameter"'),
        ({"cell.thickness": 0.02}, "it is in mm or degrees"),
        ({"cell.thickness": -1e-6}, "wrong sign"),
        ({"cell.thickness": math.nan}, "wrong sign"),
    ],
)
def test_tolerances_that_mean_nothing_are_refused(tolerances, message):
    with pytest.raises(StudyError, match=message):
        cell_drawing(STEPPED, "Plate", tolerances=tolerances)


def test_a_cell_that_is_no_rectangle_is_refused():
    oblique = Lattice(
        "oblique", (7 * MM, 0.0), (2 * MM, 7 * MM), (((1, 0), (0, 1)),), Lattice.square(1.0).zone
    )
    with pytest.raises(GeometryError, match="rectangular lattice"):
        cell_drawing(UnitCell(oblique, 1.5 * MM, METAL), "Plate")


def test_long_names_stay_in_their_boxes():
    figure = cell_drawing(cell(None), "A very long title " * 10)
    title, box = next((text, box) for text, box in boxes(figure) if text.startswith("A very long"))
    assert title.endswith("…")
    assert box.x1 < figure.axes[0].transData.transform((287, 0))[0]


def test_the_pdf_is_one_a4_page_and_the_same_every_time(tmp_path):
    one, other = (write_drawing(tmp_path / f"{name}.pdf", STEPPED, "Plate") for name in "ab")
    content = one.read_bytes()
    assert content == other.read_bytes()
    assert content.startswith(b"%PDF")
    assert len(re.findall(rb"/Type /Page\b", content)) == 1
    box = re.search(rb"/MediaBox \[ 0 0 ([\d.]+) ([\d.]+) \]", content)
    assert [float(side) / 72 * 25.4 for side in box.groups()] == pytest.approx([297, 210], abs=0.1)
    assert b"CreationDate" not in content
    dated = write_drawing(tmp_path / "c.pdf", STEPPED, "Plate", date=datetime.date(2026, 2, 3))
    assert b"CreationDate (D:20260203" in dated.read_bytes()


def test_a_file_is_not_replaced_unasked(tmp_path):
    path = tmp_path / "a.pdf"
    path.write_text("mine")
    with pytest.raises(ResourceError, match="not taken"):
        write_drawing(path, STEPPED, "Plate")
    assert path.read_text() == "mine"
    write_drawing(path, STEPPED, "Plate", overwrite=True)
    assert path.read_bytes().startswith(b"%PDF")
