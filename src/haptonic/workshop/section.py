"""Section through the pillar's axis on a drawing."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from haptonic.cell import Pillar, UnitCell
from haptonic.plots.style import PALE_INK
from haptonic.workshop.dimensions import number
from haptonic.workshop.plan import Box, fitting_scale
from haptonic.workshop.shape import MM, straight_side
from haptonic.workshop.sheet import LABELS_APART, Label, Sheet

TOUCH = "touch face, keep flat"

_ROOM = (47.0, 18.0, 40.0, 34.0)  # for dimensions: left, below, right, above, mm
_LANE = 8.0  # mm between a view and its first dimension line
_NEXT = 7.0  # mm between two dimension lines
_LABEL = 2.5  # mm between a dimension line and the texts beside it


@dataclass(frozen=True)
class _View:
    """Where on the paper (mm) the section is: its axis, the flat face, the plate's top, half its width."""

    axis: float
    face: float
    floor: float
    half: float
    scale: float

    def place(self, half_width: float, height: float) -> tuple[float, float]:
        """The point at this distance to the right of the axis and this height above the plate's top."""
        return self.axis + self.scale * half_width, self.floor + self.scale * height


def draw_section(sheet: Sheet, box: Box, cell: UnitCell, texts: Mapping[str, str], alone: bool) -> str:
    """Draw the section A-A of a cell (lengths in mm); ``alone``: its sides are edges of the plate.

    Returns
    -------
    the scale, such as ``5 : 1``
    """
    pillar = cell.pillar
    width, total = cell.lattice.a1[0], cell.thickness + (pillar.height if pillar else 0.0)
    scale, name = fitting_scale(width, total, box, _ROOM)
    face = 0.5 * (box[1] + _ROOM[1] + box[3] - _ROOM[3] - scale * total)
    view = _View(
        axis=0.5 * (box[0] + _ROOM[0] + box[2] - _ROOM[2]),
        face=face,
        floor=face + scale * cell.thickness,
        half=0.5 * scale * width,
        scale=scale,
    )
    _draw_body(sheet, cell, view, alone)
    _draw_heights(sheet, pillar, view, texts, box)
    if pillar is not None:
        ceiling = _draw_right(sheet, pillar, view, texts)
        _draw_widths(sheet, pillar, view, texts, ceiling)
    sheet.text((view.axis, box[3] - 2), f"A-A   {name}", 10.0, ha="center")
    return name


def _draw_body(sheet: Sheet, cell: UnitCell, view: _View, alone: bool) -> None:
    half, thickness = 0.5 * cell.lattice.a1[0], cell.thickness
    top = np.array([[half, 0.0], [-half, 0.0]])
    if cell.pillar is not None:
        right = straight_side(cell.pillar)
        if cell.pillar.arc is not None:
            right = np.concatenate([cell.pillar.arc.at(np.linspace(0, 1, 60)), right])
        top = np.concatenate([top[:1], right, right[::-1] * [-1, 1], top[1:]])
    ends = np.array([[-half, -thickness], [half, -thickness]])
    body, bottom = ([view.axis, view.floor] + view.scale * points for points in (top, ends))
    x, y = np.concatenate([body, bottom]).T
    sheet.axes.fill(x, y, facecolor="none", edgecolor=PALE_INK, hatch="///", linewidth=0)
    sheet.line(body)
    sheet.line(bottom)
    for edge in ([body[-1], bottom[0]], [bottom[1], body[0]]):
        sheet.line(edge, "outline" if alone else "period")
    sheet.line(bottom - [0, 1.0], "touch")
    if cell.pillar is not None:
        sheet.line([(view.axis, view.face - 3.5), (view.axis, float(body[:, 1].max()) + 3.5)], "axis")


def _draw_heights(
    sheet: Sheet, pillar: Pillar | None, view: _View, texts: Mapping[str, str], box: Box
) -> None:
    """To the left: thickness and height on one line, and which face is touched."""
    edge = view.axis - view.half
    lane = edge - _LANE
    marks = [(view.face, edge), (view.floor, edge)]
    touch = Label(TOUCH, (view.axis - 0.7 * view.half, view.face - 1.3), True, view.face - 8)
    labels = [touch, Label(texts["cell.thickness"], (lane, 0.5 * (view.face + view.floor)))]
    if pillar is not None:
        x, top = view.place(-float(straight_side(pillar)[-1, 0]), pillar.height)
        marks.append((top, x))
        labels.append(Label(texts["cell.pillar.height"], (lane, 0.5 * (view.floor + top))))
    sheet.upright(lane, marks)
    sheet.labels(lane - _LABEL, -1, labels, box[1], box[3])


def _draw_right(sheet: Sheet, pillar: Pillar, view: _View, texts: Mapping[str, str]) -> float:
    """To the right: fillet, height of the step, draft; the height on the paper that they stay below."""
    column = view.axis + view.half + _LANE
    labels = []
    if pillar.arc is not None:
        width, height = pillar.arc.at(0.6)
        labels.append(Label(f"R{texts['cell.pillar.fillet']}", view.place(width, height), True))
    if pillar.step is not None:
        x, level = view.place(pillar.half_width(pillar.step.height, 0), pillar.step.height)
        sheet.upright(column, [(view.floor, view.axis + view.half), (level, x)])
        labels.append(Label(texts["cell.pillar.step.height"], (column, 0.5 * (view.floor + level))))
        column += _LABEL
        if pillar.draft < 0:
            corner = view.place(0.5 * pillar.step.diameter, pillar.step.height)
            text = _sign(pillar) + texts["cell.pillar.step.diameter"]
            labels.append(Label(text, corner, True, corner[1] + 4))
    if pillar.draft:
        low, high, _ = pillar.stages[-1]
        height = low + 0.6 * (high - low)
        side = view.place(pillar.half_width(height, len(pillar.stages) - 1), height)
        labels.append(Label(f"draft {texts['cell.pillar.draft']}", side, True))
    lowest = view.face - 3
    ceiling = max(view.place(0, pillar.height)[1], lowest + LABELS_APART * (len(labels) - 1)) + 2
    sheet.labels(column, 1, labels, lowest, ceiling)
    return ceiling


def _draw_widths(sheet: Sheet, pillar: Pillar, view: _View, texts: Mapping[str, str], ceiling: float) -> None:
    """Above ``ceiling``: widths at the foot, above the step and at the top, which is no dimension of its own.

    Extension lines run upwards beside the pillar. Where it becomes wider upwards that of the foot runs down
    through the plate, and the step is dimensioned at the right.
    """
    sign = _sign(pillar)
    foot, top = straight_side(pillar)[[0, -1]].tolist()  # (half-width, height)
    widths = []  # half-width, height from which extension lines run up freely, text
    if pillar.draft >= 0:
        height = foot[1] if pillar.draft else pillar.stages[0][1]
        widths.append((pillar.radius, height, sign + texts["cell.pillar.diameter"]))
        if pillar.step is not None:
            height = pillar.step.height if pillar.draft else pillar.height
            widths.append((0.5 * pillar.step.diameter, height, sign + texts["cell.pillar.step.diameter"]))
    else:
        ends = (view.place(-pillar.radius, 0)[0], view.place(pillar.radius, 0)[0])
        sheet.across(view.face - _LANE - 2, ends, view.floor, sign + texts["cell.pillar.diameter"])
    if pillar.draft:
        widths.append((top[0], pillar.height, f"({sign}{number(2 * top[0] / MM, 3)})"))
    for k, (half_width, height, text) in enumerate(sorted(widths)):
        lane = ceiling + 5 + _NEXT * k
        ends = (view.place(-half_width, 0)[0], view.place(half_width, 0)[0])
        free = view.place(max(width for width, _, _ in widths), 0)[0]
        sheet.across(lane, ends, view.place(0, height)[1], text, free)


def _sign(pillar: Pillar) -> str:
    return "⌀" if pillar.section == "round" else "□"
