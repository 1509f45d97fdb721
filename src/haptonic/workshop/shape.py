"""What every file of a workshop derives from: the plate, its pillars and the numbers that make them.

A plate of ``columns`` x ``rows`` cells is centred on the origin; its columns follow the lattice's first
translation. Files are in millimetres, so lengths here are too (`in_mm`). A place on a pillar is (half-width,
height above the plate's top). A new number of the cell is added here, to `PillarShape.of` and
`dimensions_of`; a new section is a row of `FORMS`: the files follow.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

import numpy as np

from haptonic.arrays import Array
from haptonic.cell import Pillar, UnitCell
from haptonic.cell.pillar import Fillet, Section
from haptonic.errors import GeometryError

Place = tuple[float, float]

TRIANGLES = "a surface of triangles"
MM = 1e3  # mm in a metre


@dataclass(frozen=True)
class Form:
    """Horizontal cut through a pillar, for a half-width of 1.

    sign, width : what a drawing writes before the width, and what a workshop calls it
    corners : anticlockwise, of a polygon with a centre of symmetry whose sides touch the circle of radius 1,
        the first one in direction x; none for the circle itself
    """

    sign: str
    width: str
    corners: tuple[Place, ...] = ()

    def polygon(self, count: int) -> Array:
        """(n, 2) its corners; of a circle, ``count`` points on it."""
        angle = 2 * math.pi * np.arange(count) / count
        return np.array(self.corners or np.stack([np.cos(angle), np.sin(angle)], axis=1), dtype=float)

    def normals(self) -> list[float]:
        """Directions of one of each two opposite sides, rad."""
        middles = [(a[0] + b[0], a[1] + b[1]) for a, b in pairwise(self.corners)]
        return [math.atan2(y, x) for x, y in middles[: len(self.corners) // 2]]


FORMS: Mapping[Section, Form] = {
    "round": Form("⌀", "diameter"),
    "square": Form("□", "width", ((1, -1), (1, 1), (-1, 1), (-1, -1))),
}


@dataclass(frozen=True)
class PillarShape:
    """What stands on every cell: a form whose half-width follows a profile.

    side : (n, 2) places from the foot, or the end of its fillet, to the top's edge, straight in between
    arc : the fillet before them, if there is one
    outlines : half-widths that are cut to, by the layer that a DXF file has them on
    """

    form: Form
    side: Array
    arc: Fillet | None
    outlines: Mapping[str, float]

    @classmethod
    def of(cls, pillar: Pillar) -> PillarShape:
        side = [pillar.arc.at(1.0) if pillar.arc else (pillar.radius, 0.0)]
        outlines = {"PILLAR": pillar.radius}
        if pillar.arc:
            outlines["FILLET"] = pillar.arc.centre[0]
        for stage, (low, high, width) in enumerate(pillar.stages):
            if stage:
                side.append((width, low))
                outlines["STEP"] = width
            side.append((pillar.half_width(high, stage), high))
        return cls(FORMS[pillar.section], np.array(side, dtype=float), pillar.arc, outlines)

    @property
    def height(self) -> float:
        return float(self.side[-1, 1])

    @property
    def foot(self) -> float:
        """Half-width where it meets the plate, the fillet counted."""
        return max(self.outlines["PILLAR"], self.outlines.get("FILLET", 0.0))

    @property
    def widest(self) -> float:
        """Largest half-width, the fillet not counted."""
        return max(self.outlines["PILLAR"], float(self.side[:, 0].max()))

    def flank(self, pieces: int) -> Array:
        """(n, 2) the profile from the plate to the top's edge, its fillet in so many straight pieces."""
        if self.arc is None:
            return self.side
        return np.concatenate([self.arc.at(np.arange(pieces) / pieces), self.side])

    def is_free_above(self, half_width: float, height: float) -> bool:
        """Whether nothing above this height is wider: a tool, or an extension line, gets there from above."""
        above = self.side[self.side[:, 1] > height, 0]
        return bool((above <= half_width * (1 + 1e-9)).all())


@dataclass(frozen=True)
class Dimension:
    """A number of the cell, and where the drawing shows it.

    name : its path in a study; none for one that follows from others and is shown for reference
    value : m or rad (mm for a cell in mm)
    kind : along the plan's sides, "across" and "deep"; in the section a height ("left" or "right" of it), the
        "width" at a place, the "radius" of the fillet or the "angle" of a side
    low, high : heights between which it lies, of a height
    place : where it is seen, of all others in the section
    """

    name: str | None
    value: float
    kind: Literal["across", "deep", "left", "right", "width", "radius", "angle"]
    low: float = 0.0
    high: float = 0.0
    place: Place = (0.0, 0.0)


def dimensions(cell: UnitCell) -> list[Dimension]:
    """Every dimension of a cell, in the cell's unit of length and radians."""
    across, deep = (math.hypot(*side) for side in (cell.lattice.a1, cell.lattice.a2))
    found = [
        Dimension("cell.pitch", across, "across"),
        Dimension("cell.pitch" if cell.lattice.name == "square" else "cell.pitch_y", deep, "deep"),
        Dimension("cell.thickness", cell.thickness, "left", low=-cell.thickness),
    ]
    pillar = cell.pillar
    if pillar is None:
        return found
    body, at = PillarShape.of(pillar), "cell.pillar."
    found.append(Dimension(f"{at}diameter", pillar.diameter, "width", place=(pillar.radius, 0.0)))
    found.append(Dimension(f"{at}height", pillar.height, "left", high=pillar.height))
    if pillar.arc is not None:
        width, height = pillar.arc.at(0.75).tolist()
        found.append(Dimension(f"{at}fillet", pillar.fillet, "radius", place=(width, height)))
    if pillar.step is not None:
        step = pillar.step
        found.append(Dimension(f"{at}step.height", step.height, "right", high=step.height))
        place = (0.5 * step.diameter, step.height)
        found.append(Dimension(f"{at}step.diameter", step.diameter, "width", place=place))
    if pillar.draft:
        top, last = body.side[-1].tolist(), len(pillar.stages) - 1
        height = 0.6 * top[1] + 0.4 * pillar.stages[last][0]
        place = (pillar.half_width(height, last), height)
        found.append(Dimension(f"{at}draft", pillar.draft, "angle", place=place))
        found.append(Dimension(None, 2 * top[0], "width", place=(top[0], top[1])))
    return found


def dimensions_of(cell: UnitCell) -> dict[str, float]:
    """Name and value (m, rad) of every dimension that makes this cell."""
    return {one.name: one.value for one in dimensions(cell) if one.name}


def in_mm(cell: UnitCell, columns: int, rows: int) -> UnitCell:
    """The cell with its lengths in mm.

    Raises
    ------
    GeometryError : a number of columns or rows that is not a positive integer
    """
    for name, number in (("columns", columns), ("rows", rows)):
        if isinstance(number, bool) or not isinstance(number, int) or number < 1:
            raise GeometryError.out_of_range(
                argument=name,
                given=number,
                allowed="a positive integer",
                cause="the plate's length was given in place of the number of its cells",
                next_step="count the cells along that side, and give their number",
            )
    assert np.linalg.det(cell.lattice.vectors) > 0, "a1, a2 turn anticlockwise"
    return cell.scaled(MM)


def corner_grid(cell: UnitCell, columns: int, rows: int) -> Array:
    """(columns + 1, rows + 1, 2) corners of the cells of a plate."""
    i, j = np.meshgrid(np.arange(columns + 1) - columns / 2, np.arange(rows + 1) - rows / 2, indexing="ij")
    return np.asarray(np.stack([i, j], axis=-1) @ cell.lattice.vectors)


def centres(cell: UnitCell, columns: int, rows: int) -> Array:
    """(columns * rows, 2) centres of the cells of a plate, column by column."""
    corners = corner_grid(cell, columns, rows)
    return np.asarray(0.5 * (corners[:-1, :-1] + corners[1:, 1:]).reshape(-1, 2))


def standing(cell: UnitCell, columns: int, rows: int) -> list[tuple[Pillar, Array]]:
    """Pillars of a plate, each with the (n, 2) places where it stands.

    A cell of several sites is cut where there is most room between them.

    Raises
    ------
    GeometryError : a pillar that reaches beyond the edge of the plate, wherever the cell is cut
    """
    if cell.is_simple:
        return [(cell.pillar, centres(cell, columns, rows))] if cell.pillar else []
    starts = [_widest_gap(along) for along in cell.shares.T]
    first = corner_grid(cell, columns, rows)[:-1, :-1].reshape(-1, 2)
    across = np.linalg.inv(cell.lattice.vectors)  # its columns are normal to the sides
    found = []
    for share, pillar in zip((cell.shares - starts) % 1.0, cell.pillars, strict=True):
        if pillar is None:
            continue
        room = np.minimum(share, 1 - share) / np.linalg.norm(across, axis=0)
        if room.min() < pillar.widest:
            raise GeometryError.conflict(
                argument="cell.site",
                given=f"a pillar {2 * pillar.widest:.4g} mm wide, {room.min():.4g} mm from the plate's edge",
                allowed="pillars that stand on the plate with their whole foot",
                cause="the sites leave no room for a straight cut between them",
                next_step="describe the same lattice by a larger cell, or draw the plate by hand",
            )
        found.append((pillar, np.asarray(first + share @ cell.lattice.vectors)))
    return found


def _widest_gap(shares: Array) -> float:
    """The middle of the widest gap between some shares of a translation, from 0 to 1."""
    edges = np.sort(shares)
    gaps = np.diff(np.append(edges, edges[0] + 1.0))
    widest = int(np.argmax(np.round(gaps, 9)))
    return float((edges[widest] + 0.5 * gaps[widest]) % 1.0)


def plate_outline(cell: UnitCell, columns: int, rows: int) -> Array:
    """(4, 2) corners of a plate, anticlockwise from the lower left one."""
    corners = corner_grid(cell, columns, rows)
    return np.array([corners[0, 0], corners[-1, 0], corners[-1, -1], corners[0, -1]])
