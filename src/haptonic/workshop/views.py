"""The views of a drawing: plan and section of one cell, how a part looks, and its plan."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

import numpy as np

from haptonic.arrays import Array
from haptonic.cell import Pillar, UnitCell
from haptonic.workshop.dimensions import style_of, text_of
from haptonic.workshop.dxf import MARK, add_outline
from haptonic.workshop.part import Part
from haptonic.workshop.shape import MM, Dimension, PillarShape, heights, sides
from haptonic.workshop.sheet import APART, ARROW, SHELF, SIZE, Sheet, View, text_width
from haptonic.workshop.sight import seen_edges
from haptonic.workshop.stl import surface

Box = tuple[float, float, float, float]  # left, bottom, right, top, mm
Label = tuple[float, Callable[[float], None]]  # where it would best stand, and what draws it there

TOUCH = "touch face, keep flat"
ISOMETRIC = (1.0, -1.0, 1.0)  # from the body to the eye

SCALES = [step * 10.0**power for power in range(3, -4, -1) for step in (5, 2, 1)]  # ISO 5455
FACET = 0.01  # mm on the paper between a curve and its facets, which nobody sees in the isometric view
COARSEST = 0.017  # of the narrowest width: facets that meet at 30 degrees, so that no edge is seen there
LANE = 8.0  # mm between a view and its first dimension line
LEGIBLE = 1.0  # mm on the paper; smaller outlines are left out of the plan of the plate
NEXT = 7.0  # mm between two dimension lines


def fitting(width: float, height: float, box: Box, room: Box) -> View:
    """Largest standard scale that fits into a box with room around it; the origin is the lower middle."""
    across, up = box[2] - box[0] - room[0] - room[2], box[3] - box[1] - room[1] - room[3]
    scale = next((s for s in SCALES if s <= min(across / width, up / height)), SCALES[-1])
    bottom = box[1] + room[1] + 0.5 * (up - scale * height)
    return View((box[0] + room[0] + 0.5 * across, bottom), scale)


def draw_plan(sheet: Sheet, box: Box, cell: UnitCell, tolerances: Mapping[str, float], alone: bool) -> None:
    """Draw the cell (lengths in mm) as seen from above; ``alone``: its sides are edges of the plate."""
    width, depth = cell.lattice.a1[0], cell.lattice.a2[1]
    view = fitting(width, depth, box, (36.0, 14.0, 12.0, 14.0))
    (left, low), (right, high) = view.place(-0.5 * width, 0), view.place(0.5 * width, depth)
    corners = [(left, low), (right, low), (right, high), (left, high)]
    sheet.line(corners, "OUTLINE" if alone else "PERIOD", close=True)
    centre = view.place(0, 0.5 * depth)
    if cell.pillar is not None:
        _draw_edges(sheet, PillarShape.of(cell.pillar), centre, view.scale)
    sheet.line([(left - 3, centre[1]), (right + 3, centre[1])], "AXIS")
    sheet.line([(centre[0], low - 3), (centre[0], high + 3)], "AXIS")
    for x, out in ((left - 3, -1), (right + 3, 1)):  # the cutting plane
        end = x + out * 3
        sheet.line([(x, centre[1]), (end, centre[1])])
        sheet.line([(end, centre[1]), (end, centre[1] + 4)], "THIN")
        sheet.arrow((end, centre[1] + 6), 90)
        sheet.text((end + out * 3, centre[1] - 0.5 * SIZE), "A", align="CENTER", bold=True)
    across, deep = (style_of(one, tolerances.get(one.name or "")) for one in sides(cell))
    sheet.dimension(view, (corners[0], corners[1]), low - 9, across)
    lane = left - 14
    shelf = (lane - SHELF, centre[1])
    sheet.dimension(view, (corners[0], corners[3]), lane, deep, upright=True, shelf=shelf)
    _title(sheet, box, f"Plan of one cell   {view}")


def draw_section(
    sheet: Sheet,
    box: Box,
    size: tuple[float, float],
    pillar: Pillar | None,
    tolerances: Mapping[str, float],
    alone: bool,
    name: str = "A-A",
    table: str = "cell.pillar",
) -> View:
    """Draw the section through a pillar and the plate around it, which is so wide and thick; lengths in mm.

    ``alone``: its sides are edges of the plate; ``table`` of the study gives the pillar.
    """
    body, (width, thickness) = PillarShape.of(pillar) if pillar else None, size
    whole = fitting(width, thickness + (body.height if body else 0.0), box, (36.0, 17.0, 41.0, 33.0))
    view = View(whole.place(0, thickness), whole.scale)  # heights count from the plate's top
    section = _Section(
        sheet=sheet,
        view=view,
        half=0.5 * width,
        thickness=thickness,
        body=body,
        dimensions=heights(thickness, pillar, table),
        tolerances=tolerances,
    )
    section.draw_body(alone)
    section.draw_left(box[3])
    if body is not None:
        section.draw_widths(body, section.draw_right(body))
    _title(sheet, box, f"{name}   {view}")
    return view


def draw_isometric(sheet: Sheet, box: Box, part: Part) -> None:
    """Draw a part as it looks from above, as large as there is room for."""
    about = (box[2] - box[0]) / sum(part.size)  # the scale, up to the square root of 2
    skin = surface(part, chord=min(FACET / about, COARSEST * part.narrowest) / MM)
    edges = MM * np.array(seen_edges(skin.points, skin.cells_dict["triangle"], ISOMETRIC))
    low, high = edges.min(axis=(0, 1)), edges.max(axis=(0, 1))
    corners = np.array([box[:2], (box[2], box[3] - 14)])
    scale = ((corners[1] - corners[0]) / (high - low)).min()
    edges = scale * (edges - 0.5 * (low + high)) + corners.mean(axis=0)
    for edge in edges:
        sheet.line(edge, "SEEN")
    _title(sheet, box, "Isometric")


def draw_plate(sheet: Sheet, box: Box, part: Part, name: str) -> View:
    """Show the outlines in model space, so far as they are large enough, and dimension the plate's edges.

    The origin of the view is that of the part.
    """
    corner, (width, depth) = part.corners[0], part.size
    further = [2 * LANE if len(_lines(part, upright)) > 2 else 0.0 for upright in (True, False)]
    fitted = fitting(width, depth, box, (22.0 + further[0], 12.0 + 0.5 * further[1], 4.0, 8.0))
    view = View(fitted.place(-0.5 * width - corner[0], -corner[1]), fitted.scale)
    (left, low), (right, high) = (view.place(*place) for place in part.corners)
    widths = {"CELL": float(np.linalg.norm(part.cell.lattice.vectors, axis=1).min())}
    for pillar, _ in part.standing:
        outlines = {layer: 2 * half for layer, half in PillarShape.of(pillar).outlines.items()}
        for layer, size in {**outlines, "CENTRE": 2 * MARK * pillar.diameter}.items():
            widths[layer] = min(size, widths.get(layer, size))
    small = [layer for layer, size in widths.items() if view.scale * size < LEGIBLE]
    centre, about = (0.5 * (left + right), 0.5 * (low + high)), 0.5 * (part.corners[0] + part.corners[1])
    sheet.window(view, centre, (right - left + 1, high - low + 1), (float(about[0]), float(about[1])), small)
    for upright in (False, True):
        _draw_sizes(sheet, view, part, upright)
    _title(sheet, (*box[:3], min(box[3], high + 11)), f"{name}   {view}")
    return view


def _lines(part: Part, upright: bool) -> Array:
    """Where edges of the plate lie, its holes' too: along x, or along y."""
    return np.unique(np.concatenate(part.outline)[:, int(upright)].round(9))


def _draw_sizes(sheet: Sheet, view: View, part: Part, upright: bool) -> None:
    """Dimension the plate over all, and its edges one after the other where texts have room."""
    style, lines = {"dimdec": 4, "dimzin": 8}, _lines(part, upright)
    low = view.place(*part.corners[0])
    beside, lane = (low[0], low[0] - LANE) if upright else (low[1], low[1] - LANE)
    steps, paper = np.diff(lines), view.scale * np.diff(lines)
    needed = [APART if upright else text_width(f"{step:.4g}") + 3 * ARROW for step in steps]
    chains = [lines[[0, -1]]]
    if len(lines) > 2 and (paper >= needed).all():
        chains.insert(0, lines)
    for chain in chains:
        ends = [view.place(at, at)[upright] for at in chain]
        for one, other in pairwise(ends):
            places = ((beside, one), (beside, other)) if upright else ((one, beside), (other, beside))
            shelf = (lane - SHELF, 0.5 * (one + other)) if upright else None
            sheet.dimension(view, places, lane, style, upright=upright, shelf=shelf)
        lane -= 2 * LANE if upright else LANE


@dataclass(frozen=True)
class _Section:
    """A section on its way to the sheet; ``half`` is half its width, mm."""

    sheet: Sheet
    view: View
    half: float
    thickness: float
    body: PillarShape | None
    dimensions: Sequence[Dimension]
    tolerances: Mapping[str, float]

    def shown(self, kind: str) -> list[Dimension]:
        return [one for one in self.dimensions if one.kind == kind]

    def half_width(self, height: float) -> float:
        """Where an extension line to the side begins."""
        if self.body is None or height <= 0:
            return self.half
        return float(self.body.side[np.isclose(self.body.side[:, 1], height), 0].max())

    def draw_body(self, alone: bool) -> None:
        top = np.array([[self.half, 0.0], [-self.half, 0.0]])
        if self.body is not None:
            right = self.body.flank(60)
            top = np.concatenate([top[:1], right, right[::-1] * [-1, 1], top[1:]])
        low = -self.thickness
        bottom = np.array([[-self.half, low], [self.half, low]])
        top, bottom = (self.view.origin + self.view.scale * points for points in (top, bottom))
        self.sheet.hatch(np.concatenate([top, bottom]))
        self.sheet.line(top)
        self.sheet.line(bottom)
        for edge in ([top[-1], bottom[0]], [bottom[1], top[0]]):
            self.sheet.line(edge, "OUTLINE" if alone else "PERIOD")
        self.sheet.line(bottom - [0, 1.0], "TOUCH")
        self.sheet.leader(
            bottom[0] + [2.0, -1.3], (float(bottom[0, 0]) - 2, float(bottom[0, 1]) - 7), TOUCH, -1
        )
        if self.body is not None:
            x, (low, high) = self.view.origin[0], (bottom[0, 1], top[:, 1].max())
            self.sheet.line([(x, low - 3.5), (x, high + 3.5)], "AXIS")

    def height(self, one: Dimension, lane: float, side: Literal[-1, 1]) -> Label:
        """A dimension line beside the view, and where its text would best stand."""
        low, high = (self.view.place(side * self.half_width(z), z) for z in (one.low, one.high))
        style = style_of(one, self.tolerances.get(one.name or ""))

        def draw(y: float) -> None:
            shelf = (lane + side * SHELF, y)
            self.sheet.dimension(self.view, (low, high), lane, style, upright=True, shelf=shelf)

        return 0.5 * (low[1] + high[1]), draw

    def draw_left(self, ceiling: float) -> None:
        edge, face = self.view.place(-self.half, -self.thickness)
        labels = [self.height(one, edge - LANE, -1) for one in self.shown("left")]
        self.sheet.beside(labels, face + 0.5, ceiling)

    def draw_right(self, body: PillarShape) -> float:
        """Radii, heights, angles, and what cannot be dimensioned from above; the height they stay below."""
        column, face = self.view.place(self.half, -self.thickness)
        column += LANE
        labels = [self.height(one, column, 1) for one in self.shown("right")]
        column += SHELF
        for one in self.shown("radius"):
            labels.append(self.radius(body, one, column))
        for one in self.shown("angle"):
            labels.append(self.pointed(one, column, "draft "))
        for one in self.shown("width"):
            if one.place[1] > 0 and not body.is_free_above(*one.place):
                labels.append(self.pointed(one, column, body.form.sign))
        lowest = face - 3
        ceiling = max(self.view.place(0, body.height)[1], lowest + APART * (len(labels) - 1)) + 2
        self.sheet.beside(labels, lowest, ceiling)
        return ceiling

    def radius(self, body: PillarShape, one: Dimension, column: float) -> Label:
        assert body.arc is not None
        centre, tip = self.view.place(*body.arc.centre), self.view.place(*one.place)
        style = style_of(one, self.tolerances.get(one.name or ""), "R")
        rise = (centre[1] - tip[1]) / (centre[0] - tip[0])  # best seen along the radius
        wanted = tip[1] + rise * (column - tip[0])
        return wanted, lambda y: self.sheet.radius(self.view, centre, tip, style, (column, y))

    def pointed(self, one: Dimension, column: float, sign: str) -> Label:
        """A leader, where extension lines show nothing: those of a small angle lie on each other."""
        tip = self.view.place(*one.place)
        text = text_of(one, self.tolerances.get(one.name or ""), sign)
        return tip[1] + 4, lambda y: self.sheet.leader(tip, (column, y), text, 1)

    def draw_widths(self, body: PillarShape, ceiling: float) -> None:
        """Above ``ceiling``, the narrowest lowest; below the foot if it is narrower than what is above."""
        free = [one for one in self.shown("width") if body.is_free_above(*one.place)]
        beyond = self.view.place(max([one.place[0] for one in free], default=0.0), 0)[0]
        for k, one in enumerate(sorted(free, key=lambda one: one.place[0])):
            upright = body.side[np.isclose(body.side[:, 0], one.place[0]), 1]
            start = max(upright, default=body.side[0, 1])  # extension lines begin where the body leaves them
            self.width(body, one, start, ceiling + 5 + NEXT * k, beyond)
        face = self.view.place(0, -self.thickness)[1]
        for one in self.shown("width"):
            if one.place[1] <= 0 and one not in free:
                self.width(body, one, 0.0, face - LANE - 2, self.view.place(one.place[0], 0)[0])

    def width(self, body: PillarShape, one: Dimension, start: float, line: float, beyond: float) -> None:
        left, right = (self.view.place(side * one.place[0], start) for side in (-1, 1))
        half_width = self.tolerances.get(one.name or "")
        fits = text_width(text_of(one, half_width, body.form.sign)) + 2 * ARROW < right[0] - left[0]
        shelf = None if fits else (beyond + 2 * SHELF, line)
        self.sheet.dimension(
            self.view, (left, right), line, style_of(one, half_width, body.form.sign), shelf=shelf
        )


def _draw_edges(sheet: Sheet, body: PillarShape, centre: tuple[float, float], scale: float) -> None:
    """Every edge as seen from above; thin where a fillet runs out smoothly, dashed where it is hidden."""
    side = body.flank(1)
    smooth = 2 if body.arc else 0  # edges at the ends of the fillet
    for k, (half_width, height) in enumerate(side.tolist()):
        # seen twice when the side is upright: drawn once, for its upper end
        if np.isclose(side[k + 1 :, 0], half_width).any():
            continue
        is_end = k < smooth and k + 1 < len(side)
        upright = smooth and k and np.isclose(side[k - 1, 0], half_width)
        layer = "THIN" if is_end and not upright else "OUTLINE"
        if not body.is_free_above(half_width, height):
            layer = "HIDDEN"
        add_outline(sheet.space, body.outline, centre, scale * half_width, layer)
    for (one, low), (other, high) in pairwise(side.tolist()):
        if one > other and high > low:
            for corner in body.outline.corners:
                sheet.line([centre + scale * one * corner, centre + scale * other * corner], "THIN")


def _title(sheet: Sheet, box: Box, text: str) -> None:
    sheet.text((0.5 * (box[0] + box[2]), box[3] - 4), text, 3.0, "CENTER")
