"""Section of a drawing: a row of pillars on their plate, cut along x through their axes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

import numpy as np
from ezdxf.layouts import Modelspace

from haptonic.arrays import Array
from haptonic.cell.disc import Disc
from haptonic.cell.outlines import Outline
from haptonic.cell.stack import Feature, Stack
from haptonic.materials import Material
from haptonic.plots.labels import spread
from haptonic.workshop.dimensions import disc_width, text_of
from haptonic.workshop.part import Part
from haptonic.workshop.rings import Rings
from haptonic.workshop.shape import MM, Dimension, Kind, PillarShape, heights, sides
from haptonic.workshop.sheet import APART, ARROW, SHELF, SIZE, Box, Sheet, View, shortened, text_width

Label = tuple[float, Callable[[float], None]]  # preferred height, and function that draws it at a height

TOUCH = "touch face, keep flat"
ROUND = 720  # corners of the polygon for a whole turn
ROOM: Box = (36.0, 32.0, 46.0, 33.0)  # mm around the section, for its dimensions
LANE = 8.0  # mm between a view and its first dimension line
NEXT = 7.0  # mm between two dimension lines
SAME_LEVEL = 1e-6  # mm
SAME = 1e-6  # relative difference of equal places and distances
HATCH = 0.6  # size of its pattern on the paper
ANGLES = (0.0, 90.0, 45.0, 135.0)  # of the hatches of four materials, degrees; others have wider patterns


@dataclass(frozen=True)
class Row:
    """Cut through the plate from ``low`` to ``high`` along x.

    features : pillars and stacks with axes on the cut, and their x
    axes : x of the first axis and of the next one of its kind; one for a single pillar, none for plain plate
    """

    y: float
    low: float
    high: float
    axes: tuple[float, ...]
    features: tuple[tuple[Feature, float], ...]

    @classmethod
    def of(cls, part: Part) -> Row:
        """Row of the first kind of pillar, at the place where two are nearest to each other."""
        corner, end = part.corners
        if not part.standing:
            width = min(part.cell.lattice.pitch, part.size[0])
            return cls(
                y=float(corner[1]), low=float(corner[0]), high=float(corner[0] + width), axes=(), features=()
            )
        feature, places = part.standing[0]
        first, step = nearest(places, 0)
        axes = (float(first[0]), float(first[0] + step)) if step else (float(first[0]),)
        margin = max(0.5 * (step or part.cell.lattice.pitch), 1.2 * span(feature).max())
        low, high = max(axes[0] - margin, corner[0]), min(axes[-1] + margin, end[0])
        y = float(first[1])
        inside = [
            (kind, float(x))
            for kind, others in part.standing
            for x in others[np.abs(others[:, 1] - y) < SAME * part.cell.lattice.pitch, 0]
            if low <= x - span(kind)[1] and x + span(kind)[0] <= high
        ]
        features = tuple(sorted(inside, key=lambda each: each[1]))
        return cls(y=y, low=float(low), high=float(high), axes=axes, features=features)

    def solids(self, part: Part) -> set[Material]:
        """Materials of the plate and of all features on the cut."""
        solids = {part.cell.material}
        for feature, _ in self.features:
            if isinstance(feature, Stack):
                rings = Rings.of(feature, part.cell.material)
                solids |= {solid for solid in rings.materials if rings.rings(solid)}
            else:
                solids.add(part.solid_of(feature))
        return solids


def nearest(places: Array, along: int) -> tuple[Array, float | None]:
    """Position with the nearest next one on its line along x or y, and their distance; None without two."""
    # axes on one line differ by rounding
    rounded = np.round(places / max(SAME * float(np.ptp(places, axis=0).max()), SAME_LEVEL * SAME))
    order = np.lexsort((rounded[:, along], rounded[:, 1 - along]))
    is_next = np.diff(rounded[order, 1 - along]) == 0
    apart = np.where(is_next, np.diff(places[order, along]), np.inf)
    if not len(apart) or not np.isfinite(apart.min()):
        return places[order[0]], None
    return places[order[int(apart.argmin())]], float(apart.min())


def pitch_of(part: Part, apart: float, along: int) -> Dimension:
    """A distance along x or y, with the name of the lattice's number if it equals that number."""
    side = sides(part.cell)[along]
    is_pitch = abs(apart - side.value) < SAME * side.value
    return Dimension(side.name if is_pitch else "distance", apart, side.kind)


def span(feature: Feature) -> Array:
    """Largest extent of a pillar or a stack to the right and to the left of its axis."""
    if isinstance(feature, Stack):
        return MM * feature.widest * chord(feature.outline)
    body = PillarShape.of(feature)
    return max(body.widest, body.foot) * chord(body.outline)


def _height(feature: Feature) -> float:
    return MM * feature.height if isinstance(feature, Stack) else feature.height


def draw_section(sheet: Sheet, box: Box, part: Part, tolerances: Mapping[str, float]) -> View:
    """Draw the row in model space, to the right of the plan, and show it in a box of the sheet."""
    row, thickness = Row.of(part), part.cell.thickness
    above = max((_height(feature) for feature, _ in row.features), default=0.0)
    below = thickness + above * part.cell.is_mirrored
    across, up = row.high - row.low, above + below
    view = View.fitting(across, up, box, ROOM)
    corner = part.corners[1] + [part.size[0], -part.size[1]]  # of the section in model space
    origin = corner + np.array([-row.low, below])
    _draw_row(sheet.document.modelspace(), part, row, origin, view.scale)
    view = View(view.place(-0.5 * across - row.low, below), view.scale)
    end, rim = corner + np.array([across, up]), 1 / view.scale
    sheet.window(View(view.place(*-origin), view.scale), tuple(corner - rim), tuple(end + rim))
    labels = _Labels(sheet=sheet, view=view, part=part, row=row, below=below, tolerances=tolerances, box=box)
    labels.draw()
    return view


def _draw_row(space: Modelspace, part: Part, row: Row, origin: Array, scale: float) -> None:
    """Draw hatches and edges of the cut; ``origin`` is the position of x = 0 on the plate's top."""
    plate, thickness = part.cell.material, part.cell.thickness

    def hatch(points: Array, solid: Material) -> None:
        entity = space.add_hatch(dxfattribs={"layer": "HATCH"})
        wider, number = divmod(part.materials.index(solid), len(ANGLES))
        entity.set_pattern_fill("ANSI31", scale=(1 + wider) * HATCH / scale, angle=ANGLES[number])
        entity.paths.add_polyline_path((origin + points).tolist(), is_closed=True)

    def edge(points: Array, layer: str = "OUTLINE") -> None:
        space.add_lwpolyline((origin + points).tolist(), dxfattribs={"layer": layer})

    solid_ends, above, below = [row.low], [row.low], [row.low]  # ends of the plate, and of its free faces
    for feature, x in row.features:
        if isinstance(feature, Stack):
            stack = Rings.of(feature, plate)
            _draw_stack(stack, np.array([x, -thickness]), hatch, edge)
            right, left = stack.rim.half_width * chord(stack.rim.outline)
            for ends in (solid_ends, above, below):
                ends += [x - left, x + right]
            continue
        body, solid = PillarShape.of(feature), part.solid_of(feature)
        right, left = chord(body.outline)
        flank = body.flank(60)
        shape = np.concatenate([flank * [right, 1], flank[::-1] * [-left, 1]])
        for sign, level, ends in ((1, 0.0, above), (-1, -thickness, below))[: part.cell.copies]:
            drawn = shape * [1, sign] + [x, level]
            hatch(drawn, solid)
            edge(drawn if solid == plate else np.concatenate([drawn, drawn[:1]]))
            ends += [drawn[-1, 0], drawn[0, 0]]
    for ends in (solid_ends, above, below):
        ends.append(row.high)
    for start, end in _pairs(solid_ends):
        hatch(np.array([[start, -thickness], [end, -thickness], [end, 0.0], [start, 0.0]]), plate)
    for level, ends in ((0.0, above), (-thickness, below)):
        for start, end in _pairs(ends):
            edge(np.array([[start, level], [end, level]]))
    for x in (row.low, row.high):
        is_edge = np.isclose(x, [corner[0] for corner in part.corners]).any()
        edge(np.array([[x, -thickness], [x, 0.0]]), "OUTLINE" if is_edge else "BREAK")


def _pairs(ends: list[float]) -> Iterator[tuple[float, float]]:
    return zip(ends[::2], ends[1::2], strict=True)


def _draw_stack(
    stack: Rings, foot: Array, hatch: Callable[[Array, Material], None], edge: Callable[[Array], None]
) -> None:
    """Draw rings on both sides of an axis; ``foot`` is its position on the plate's lower face."""
    solids, levels = stack.solids(), stack.levels
    for way, side in ((0, 1), (1, -1)):
        chords = np.array([side * chord(outline)[way] for outline in stack.outlines])
        widths = np.insert(chords[:, None] * stack.widths, 0, 0.0, axis=0)
        places = np.stack([widths, np.broadcast_to(levels, widths.shape)], axis=-1)  # border, level
        for storey, row in enumerate(solids):
            for border, (solid, beyond) in enumerate(pairwise(row)):
                inner, outer = places[border : border + 2, storey : storey + 2]
                if solid is not None:
                    hatch(foot + np.concatenate([inner, outer[::-1]]), solid)
                if solid != beyond:
                    edge(foot + outer)
        nothing: list[Material | None] = [None] * len(widths)
        for level, (lower, upper) in enumerate(pairwise([nothing, *solids, nothing])):
            for border, (below, above) in enumerate(zip(lower[:-1], upper, strict=False)):
                if below != above:
                    edge(foot + places[border : border + 2, level])


@dataclass(frozen=True)
class _Labels:
    """Dimensions around the section; heights are measured from the plate's top."""

    sheet: Sheet
    view: View
    part: Part
    row: Row
    below: float
    tolerances: Mapping[str, float]
    box: Box

    def draw(self) -> None:
        feature = self.part.standing[0][0] if self.part.standing else None
        pillar = None if isinstance(feature, Stack) else feature
        table = feature and self.part.table(feature)
        shown = heights(self.part.cell.thickness, pillar, f"{table}pillar")
        if isinstance(feature, Stack):
            shown += self.storeys(feature)
        left, face = self.view.place(self.row.low, -self.part.cell.thickness)
        column = self.view.place(self.row.high, 0)[0] + LANE
        at_left = [self.height(dimension, left - LANE, -1) for dimension in shown if dimension.kind == "left"]
        self.beside(at_left, self.view.place(0, -self.below)[1] + 0.5, self.box[3])
        if not self.part.cell.is_mirrored:
            right = self.view.place(self.row.high, 0)[0]
            self.sheet.line([(left, face - 1), (right, face - 1)], "TOUCH")
            self.sheet.leader((left + 2, face - 1.3), (left - 2, face - 7), TOUCH, -1)
        low = self.view.place(0, -self.below)[1]
        for _, x in self.row.features:
            across, top = self.view.place(x, max(_height(each) for each, _ in self.row.features))
            self.sheet.line([(across, low - 3.5), (across, top + 3.5)], "AXIS")
        if len(self.row.axes) == 2:
            pitch = pitch_of(self.part, self.row.axes[1] - self.row.axes[0], 0)
            ends = [(self.view.place(x, 0)[0], low - 3.5) for x in self.row.axes]
            half = self.tolerances.get(pitch.name or "")
            self.across((ends[0], ends[1]), low - 3 * LANE, pitch, half, "", ends[1][0])
        labels = [self.height(dimension, column, 1) for dimension in shown if dimension.kind == "right"]
        lowest = face - 3
        if isinstance(feature, Stack):
            discs = enumerate(feature.discs, start=1)
            labels += [self.disc(disc, f"{table}disc[{number}]", column + SHELF) for number, disc in discs]
        if pillar is not None:
            body = PillarShape.of(pillar)
            labels += [self.pointed(body, dimension, column + SHELF, sign) for dimension in shown
                       if (sign := self.sign(body, dimension)) is not None]  # fmt: skip
        height = _height(feature) if feature else 0.0
        top = max(self.view.place(0, height)[1], lowest + APART * (len(labels) - 1)) + 2
        self.beside(labels, lowest, top)
        if pillar is not None:
            self.widths(body, [dimension for dimension in shown if dimension.kind == "width"], top)

    def storeys(self, stack: Stack) -> list[Dimension]:
        """Heights of a stack: overall, and storey by storey."""
        ends = (MM * (stack.heights - stack.thickness)).tolist()
        whole = [self.storey(stack, 0.0, ends[-1], "left")] if stack.height else []
        within = [self.storey(stack, low, high, "right") for low, high in pairwise(ends)]
        return whole + (within if len(within) > 1 else [])

    def storey(self, stack: Stack, low: float, high: float, kind: Kind) -> Dimension:
        """Distance of two levels, mm above the plate's top.

        It is for reference if a level has a tolerance that does not count from the other one.
        """
        toleranced = [path for level in (low, high) if (path := self.level(stack, level))]
        name: str | None = "distance"
        if toleranced:
            name = toleranced[0] if np.isclose([low, high], 0.0, atol=SAME_LEVEL).any() else None
        return Dimension(name, high - low, kind, low=low, high=high)

    def level(self, stack: Stack, height: float) -> str:
        """Path of the end of a disc that has a tolerance, at a height, mm above the plate's top, or ""."""
        for number, disc in enumerate(stack.discs, start=1):
            for name, end in zip(("low", "high"), disc.ends(stack.thickness), strict=True):
                path = f"{self.part.table(stack)}disc[{number}].{name}"
                if abs(MM * (end - stack.thickness) - height) < SAME_LEVEL and path in self.tolerances:
                    return path
        return ""

    def disc(self, disc: Disc, at: str, column: float) -> Label:
        """A leader with the width and the material of a disc, whose table in the study is ``at``."""
        thickness = self.part.source.thickness
        width, height = MM * np.mean(disc.side(thickness), axis=0)
        right = self.row.axes[-1] + width * chord(disc.outline)[0]
        tip = self.view.place(float(right), height - MM * thickness)
        solid = "empty" if disc.empty else (disc.material or self.part.cell.material).name
        text = f"{disc.form.sign}{disc_width(disc, thickness, at, self.tolerances)} {solid}"
        text = shortened(text, self.box[2] - column, SIZE)
        return tip[1] + 4, lambda y: self.sheet.leader(tip, (column, y), text, 1)

    def sign(self, body: PillarShape, dimension: Dimension) -> str | None:
        """Sign before the text of a leader; None for a number with a dimension line."""
        if dimension.kind == "width" and (not is_measured(body) or self.hidden_width(body, dimension)):
            return body.form.sign
        return {"radius": "R", "angle": "draft "}.get(dimension.kind)

    @staticmethod
    def hidden_width(body: PillarShape, dimension: Dimension) -> bool:
        return dimension.place[1] > 0 and not body.is_free_above(*dimension.place)

    @staticmethod
    def beside(labels: list[Label], low: float, high: float) -> None:
        """Draw labels at their preferred heights, moved apart where necessary within bounds."""
        for (_, draw), height in zip(labels, spread([y for y, _ in labels], APART, low, high), strict=True):
            draw(height)

    def height(self, dimension: Dimension, lane: float, side: Literal[-1, 1]) -> Label:
        """A dimension line beside the view, and the preferred height of its text."""
        feature = self.part.standing[0][0] if self.part.standing else None

        def start(up: float) -> float:
            if up <= 0 or feature is None:
                return self.row.low if side < 0 else self.row.high
            reach, x = span(feature)[0 if side > 0 else 1], self.row.axes[-1 if side > 0 else 0]
            if isinstance(feature, Stack):
                return x + side * float(reach)
            body = PillarShape.of(feature)
            width = body.side[np.isclose(body.side[:, 1], up), 0].max() / max(body.widest, body.foot)
            return x + side * float(reach * width)

        low, high = (self.view.place(start(up), up) for up in (dimension.low, dimension.high))
        half = self.tolerances.get(dimension.name or "")

        def draw(y: float) -> None:
            shelf = (lane + side * SHELF, y)
            self.sheet.dimension(self.view, (low, high), lane, dimension, half, upright=True, shelf=shelf)

        return 0.5 * (low[1] + high[1]), draw

    def pointed(self, body: PillarShape, dimension: Dimension, column: float, sign: str) -> Label:
        """A leader, for numbers whose extension lines would coincide, such as a small angle."""
        right = chord(body.outline)[0]
        tip = self.view.place(self.row.axes[-1] + right * dimension.place[0], dimension.place[1])
        text = text_of(dimension, self.tolerances.get(dimension.name or ""), sign)
        return tip[1] + 4, lambda y: self.sheet.leader(tip, (column, y), text, 1)

    def widths(self, body: PillarShape, shown: list[Dimension], ceiling: float) -> None:
        """Draw widths above ``ceiling``, the narrowest lowest; a foot narrower than its pillar, below it."""
        if not is_measured(body):
            return
        axis = self.row.axes[-1]
        free = sorted(
            (dimension for dimension in shown if body.is_free_above(*dimension.place)),
            key=lambda dimension: dimension.place[0],
        )
        beyond = self.view.place(axis + max([dimension.place[0] for dimension in free], default=0.0), 0)[0]
        lines = [(dimension, ceiling + 5 + NEXT * k, beyond) for k, dimension in enumerate(free)]
        face = self.view.place(0, -self.below)[1]
        for dimension in shown:
            if dimension.place[1] <= 0 and dimension not in free:
                lines.append((dimension, face - LANE - 2, self.view.place(axis + dimension.place[0], 0)[0]))
        for dimension, line, right in lines:
            upright = body.side[np.isclose(body.side[:, 0], dimension.place[0]), 1]
            start = max(upright, default=body.side[0, 1]) if dimension in free else 0.0
            ends = [self.view.place(axis + side * dimension.place[0], start) for side in (-1, 1)]
            half = self.tolerances.get(dimension.name or "")
            self.across((ends[0], ends[1]), line, dimension, half, body.form.sign, right)

    def across(
        self,
        ends: tuple[tuple[float, float], tuple[float, float]],
        line: float,
        dimension: Dimension,
        half_width: float | None,
        sign: str,
        beyond: float,
    ) -> None:
        """A level dimension; if its text is wider than the length, it is to the right of ``beyond``."""
        fits = text_width(text_of(dimension, half_width, sign)) + 2 * ARROW < ends[1][0] - ends[0][0]
        shelf = None if fits else (beyond + 2 * SHELF, line)
        self.sheet.dimension(self.view, ends, line, dimension, half_width, sign=sign, shelf=shelf)


def chord(outline: Outline) -> Array:
    """Extent of an outline along x to the right and to the left of its axis, in half-widths."""
    corners = outline.polygon(ROUND, 1)
    after = np.roll(corners, -1, axis=0)
    crossing = (corners[:, 1] <= 0) != (after[:, 1] <= 0)
    (x, y), (x_after, y_after) = corners[crossing].T, after[crossing].T
    crossed = x - y * (x_after - x) / (y_after - y)
    return np.array([crossed.max(), -crossed.min()])


def is_measured(body: PillarShape) -> bool:
    """True if the cut along x is as wide as the numbers of the section."""
    return bool(np.allclose(chord(body.outline), 1, rtol=1e-6))
