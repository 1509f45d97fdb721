"""A sheet of paper in millimetres: lines, dimension lines with arrows, leaders and text.

Dimensions are read from below (ISO 129-1, method 2): text is never turned, so it needs no room along the
line that it belongs to.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from typing import Literal

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties
from matplotlib.textpath import TextPath
from numpy.typing import NDArray

from haptonic.plots.style import CENTIMETRE, INK, spread

A4 = (297.0, 210.0)  # mm, landscape
POINT = 25.4 / 72  # mm

SIZE = 9.0  # points, of dimensions
SMALL = 6.5
ARROW, ARROW_HALF = 2.6, 0.42  # mm: length and half the width
GAP, BEYOND = 0.8, 1.5  # mm: extension lines begin and end so far from what they belong to
LEAST_FOR_ARROWS = 3 * ARROW  # mm; shorter dimension lines end in oblique strokes
SHELF = 2.0  # mm between a dimension line and its text
LABELS_APART = 5.5  # mm

Array = NDArray[np.float64]
Point = tuple[float, float] | Array  # mm
Kind = Literal["outline", "thin", "hidden", "axis", "touch", "period"]
_WIDTHS = {"outline": 0.5, "thin": 0.18, "hidden": 0.25, "axis": 0.18, "touch": 0.5, "period": 0.25}
_DASHES = {
    "hidden": (0, (7, 3)),
    "axis": (0, (24, 4, 2, 4)),
    "touch": (0, (7, 1.5, 1, 1.5)),
    "period": (0, (16, 3, 2, 3, 2, 3)),
}


@dataclass(frozen=True)
class Label:
    """Text beside a view, joined to ``anchor`` by a leader that ends there in an arrow if ``pointing``."""

    text: str
    anchor: tuple[float, float]
    pointing: bool = False
    height: float | None = None  # where the text would best stand; by default at its anchor's height


class Sheet:
    """An empty A4 sheet in landscape; the origin is its lower left corner, lengths are mm."""

    def __init__(self) -> None:
        self.figure = Figure(figsize=(A4[0] * 0.1 * CENTIMETRE, A4[1] * 0.1 * CENTIMETRE))
        self.axes: Axes = self.figure.add_axes((0, 0, 1, 1))
        self.axes.set_axis_off()
        self.axes.set_xlim(0, A4[0])
        self.axes.set_ylim(0, A4[1])

    def line(self, points: Sequence[Point] | Array, kind: Kind = "outline") -> None:
        x, y = np.asarray(points, dtype=float).T
        self.axes.plot(
            x, y, color=INK, linewidth=_WIDTHS[kind] / POINT, linestyle=_DASHES.get(kind, "-"),
            solid_capstyle="butt", solid_joinstyle="miter",
        )  # fmt: skip

    def text(
        self,
        place: Point,
        text: str,
        size: float = SIZE,
        ha: Literal["left", "center", "right"] = "left",
        va: Literal["baseline", "center", "bottom"] = "center",
        bold: bool = False,
    ) -> None:
        weight = "bold" if bold else "normal"
        self.axes.text(place[0], place[1], text, fontsize=size, ha=ha, va=_va(va), fontweight=weight)

    def arrow(self, tip: Point, towards: Point) -> None:
        """A head with its point at ``tip`` that flies in the direction ``towards``."""
        direction = np.asarray(towards, dtype=float) / np.hypot(*towards)
        back = np.asarray(tip) - ARROW * direction
        across = ARROW_HALF * np.array([-direction[1], direction[0]])
        x, y = np.array([tip, back + across, back - across]).T
        self.axes.fill(x, y, color=INK, linewidth=0)

    def dimension_line(self, start: Point, end: Point) -> None:
        """A thin line with an arrow at either end, or an oblique stroke where it is too short for arrows."""
        a, b = np.asarray(start, dtype=float), np.asarray(end, dtype=float)
        self.line([a, b], "thin")
        if np.hypot(*(b - a)) >= LEAST_FOR_ARROWS:
            self.arrow(a, a - b)
            self.arrow(b, b - a)
            return
        for place in (a, b):
            self.line([place - ARROW / 3, place + ARROW / 3], "thin")

    def across(
        self, y: float, x: tuple[float, float], start: float, text: str, free: float | None = None
    ) -> None:
        """Horizontal dimension at height ``y`` between two places; its extension lines begin at ``start``.

        Where the text does not fit between them it stands at the right, beyond ``free`` if that is given.
        """
        up = np.sign(y - start)
        for place in x:
            self.line([(place, start + up * GAP), (place, y + up * BEYOND)], "thin")
        self.dimension_line((x[0], y), (x[1], y))
        if text_width(text) + 2 * ARROW < x[1] - x[0]:
            self.text((0.5 * (x[0] + x[1]), y + 0.8), text, ha="center", va="baseline")
        else:
            end = (x[1] if free is None else max(x[1], free)) + 2 * SHELF
            self.line([(x[1], y), (end, y)], "thin")
            self.text((end + 0.5, y), text)

    def upright(self, x: float, marks: Sequence[tuple[float, float]]) -> None:
        """Chain of vertical dimension lines at ``x``; a mark is (height, where its extension line begins)."""
        for height, start in marks:
            out = np.sign(x - start)
            self.line([(start + out * GAP, height), (x + out * BEYOND, height)], "thin")
        for (low, _), (high, _) in pairwise(marks):
            self.dimension_line((x, low), (x, high))

    def labels(
        self, x: float, side: Literal[-1, 1], labels: Sequence[Label], low: float, high: float
    ) -> None:
        """Texts in a column that begins (side 1) or ends (side -1) at ``x``, moved apart where needed."""
        wanted = [label.anchor[1] if label.height is None else label.height for label in labels]
        for label, y in zip(labels, spread(wanted, LABELS_APART, low, high), strict=True):
            end = np.array([x, y])
            knee = end - (side * SHELF, 0)
            self.line([label.anchor, knee, end - (0.4 * side, 0)], "thin")
            if label.pointing:
                self.arrow(label.anchor, np.asarray(label.anchor) - knee)
            self.text(end, label.text, ha="left" if side > 0 else "right")


@cache
def text_width(text: str, size: float = SIZE, bold: bool = False) -> float:
    """Width of a text in mm."""
    if not text.strip():
        return 0.0  # matplotlib makes no path of nothing
    font = FontProperties(family="DejaVu Sans", weight="bold" if bold else "normal")
    return float(TextPath((0, 0), text, size=size, prop=font).get_extents().width) * POINT


def wrapped(text: str, width: float, size: float) -> list[str]:
    """Lines of a text that are at most ``width`` mm wide, as far as its words allow."""
    lines = [""]
    for word in text.split():
        longer = f"{lines[-1]} {word}".strip()
        if lines[-1] and text_width(longer, size) > width:
            lines.append(word)
        else:
            lines[-1] = longer
    return lines


def shortened(text: str, width: float, size: float, bold: bool = False) -> str:
    """A text cut so that it is at most ``width`` mm wide."""
    whole = text_width(text, size, bold)
    if whole <= width:
        return text
    text = text[: math.ceil(1.2 * len(text) * width / whole)]
    while text and text_width(f"{text}…", size, bold) > width:
        text = text[:-1].rstrip()
    return f"{text}…"


def _va(name: Literal["baseline", "center", "bottom"]) -> Literal["baseline", "center_baseline", "bottom"]:
    return "center_baseline" if name == "center" else name
