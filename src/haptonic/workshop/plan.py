"""Plan of a drawing: the outlines in model space with sizes, positions, names and supports of the plate."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from haptonic.arrays import Array
from haptonic.plots.labels import spread
from haptonic.workshop.dimensions import DECIMALS, number
from haptonic.workshop.part import Part
from haptonic.workshop.section import LANE, pitch_of, span
from haptonic.workshop.shape import MM
from haptonic.workshop.sheet import APART, SHELF, SIZE, Box, Sheet, View, text_width

ROOM: Box = (41.0, 45.0, 16.0, 8.0)  # mm around the plan, for its dimensions
BESIDE = 1.2  # mm between an edge and the line of its support
SAMPLE = 12.0  # mm of such a line in the legend
NUMBERS = 17.0  # mm for the numbers along an edge, at least
AROUND_NUMBERS = 8.0  # mm, of which a number along an edge leaves this much free
CLOSEST = 4.0  # mm between two of these numbers


def draw_plan(sheet: Sheet, box: Box, part: Part, tolerances: Mapping[str, float]) -> View:
    """Show the outlines in model space from above, with dimensions; the origin is that of the part."""
    corner, (width, depth) = part.corners[0], part.size
    fitted = View.fitting(width, depth, box, ROOM)
    view = View(fitted.place(-0.5 * width - corner[0], -corner[1]), fitted.scale)
    rim = 0.5 / view.scale
    sheet.window(view, *((tuple(end + side * rim)) for side, end in zip((-1, 1), part.corners, strict=True)))
    for along in (0, 1):
        _draw_sizes(sheet, view, part, along, tolerances)
    _name_marks(sheet, view, part)
    _draw_supports(sheet, view, part, (box[0] + 2, box[1] + 1))
    if len(part.standing) > 1:
        _name_kinds(sheet, view, part)
    return view


def _draw_sizes(sheet: Sheet, view: View, part: Part, along: int, tolerances: Mapping[str, float]) -> None:
    """Draw the overall size, and positions of inner edges and outermost axes from the lower left corner."""
    first, last = (end[along] for end in part.corners)
    low, high = (view.place(*end) for end in part.corners)
    zero = View(low, view.scale)
    edges = np.concatenate(part.outline)[:, along]
    axes = [places[:, along] for _, places in part.standing]
    outermost = [extreme(np.concatenate(axes)) for extreme in (np.min, np.max)] if axes else []
    room = high[along] - low[along] - 2 * CLOSEST
    for listed in (np.concatenate([edges, outermost]), np.array(outermost)):
        shown = np.unique(listed.round(9))
        shown = shown[(shown > first + 1e-9) & (shown < last - 1e-9)]
        if CLOSEST * (len(shown) - 1) <= room:
            break
    places = [zero.place(*[value - first] * 2)[along] for value in shown]
    ends = spread(places, CLOSEST, low[along] + CLOSEST, high[along] - CLOSEST) if room > 0 else places
    other = low[1 - along] - LANE
    for place, end in zip(places, ends, strict=True):
        pair = [(place, low[1 - along]), (end, other)]
        sheet.ordinate(zero, *((b, a) if along else (a, b) for a, b in pair), upright=bool(along))
    size = part.size[along]
    overall = pitch_of(part, size, along)
    widest = max([text_width(number((value - first) / MM, DECIMALS)) for value in shown], default=0.0)
    line = other - max(NUMBERS, widest + AROUND_NUMBERS)
    corners = [(low[0], low[1]), (low[0], high[1]) if along else (high[0], low[1])]
    shelf = (line - SHELF, 0.5 * (low[1] + high[1])) if along else None
    half = tolerances.get(overall.name or "")
    sheet.dimension(view, (corners[0], corners[1]), line, overall, half, upright=bool(along), shelf=shelf)


def _name_marks(sheet: Sheet, view: View, part: Part) -> None:
    """Write the names of regions and patches into them, if there is room."""
    taken: list[Box] = []
    named = [mark for mark in part.marks if mark.layer in ("REGION", "PATCH")]
    for mark in sorted(named, key=lambda mark: mark.layer):  # patches come first: they lie on regions
        low, high = (view.place(*end(mark.line, axis=0)) for end in (np.min, np.max))
        if mark.layer == "PATCH":
            taken.append((*low, *high))
        width, x = text_width(mark.name) + 2, 0.5 * (low[0] + high[0])
        for share in (0.5, 0.75, 0.25, 0.9, 0.1):
            y = low[1] + share * (high[1] - low[1])
            box = (x - 0.5 * width, y - SIZE, x + 0.5 * width, y + SIZE)
            others = taken[:-1] if mark.layer == "PATCH" else taken
            fits = low[0] < box[0] and box[2] < high[0] and low[1] < box[1] and box[3] < high[1]
            if fits and not any(_meet(box, other) for other in others):
                sheet.text((x, y - 0.5 * SIZE), mark.name, align="CENTER")
                taken.append(box)
                break


def _meet(box: Box, other: Box) -> bool:
    return box[0] < other[2] and other[0] < box[2] and box[1] < other[3] and other[1] < box[3]


def _draw_supports(sheet: Sheet, view: View, part: Part, legend: tuple[float, float]) -> None:
    """Draw a thick line beside each supported side, and a legend of these lines below the plan."""
    meaning = {}
    for mark in part.marks:
        if mark.layer != "HELD":
            continue
        ends: Array = np.array([view.place(*end) for end in mark.line.tolist()])
        along = ends[1] - ends[0]
        outward = np.array([along[1], -along[0]]) / np.hypot(*along)  # the plate lies to the left
        sheet.line(ends + BESIDE * outward, mark.name.upper())
        meaning[mark.name] = f"{mark.name}{mark.note}"
    x, y = legend
    for name, text in meaning.items():
        sheet.line([(x, y + 0.5 * SIZE), (x + SAMPLE, y + 0.5 * SIZE)], name.upper())
        sheet.text((x + SAMPLE + 2, y), text)
        x += SAMPLE + text_width(text) + 8


def _name_kinds(sheet: Sheet, view: View, part: Part) -> None:
    """Point to the rightmost pillar of each kind, with its letter."""
    edge = view.place(*part.corners[1])[0]
    tips = []
    for feature, places in part.standing:
        x, y = places[np.lexsort((places[:, 1], places[:, 0]))[-1]]
        tips.append(view.place(float(x) + float(span(feature)[0]), float(y)))
    low, high = (view.place(*corner)[1] for corner in part.corners)
    lines = spread([tip[1] for tip in tips], APART, low, max(high, low + APART * len(tips)))
    for k, (tip, y) in enumerate(zip(tips, lines, strict=True)):
        sheet.leader(tip, (edge + 5, y), letter(k), 1)


def letter(number: int) -> str:
    """Name of a kind of pillar: A, B, ..., Z, A1, ..."""
    rounds, place = divmod(number, 26)
    return chr(ord("A") + place) + (str(rounds) if rounds else "")
