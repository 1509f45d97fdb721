"""Part for a workshop: the outline of a plate, and every pillar with its position.

A piece of lattice and the whole plate of a study are the same kind of value; all files are written from it.
Lengths are in millimetres here, as in the files.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

import numpy as np

from haptonic.arrays import Array
from haptonic.cell import Pillar, UnitCell
from haptonic.cell.stack import Feature, Stack
from haptonic.cell.tile import enclosed
from haptonic.errors import GeometryError
from haptonic.materials import Material
from haptonic.names import counted, listed
from haptonic.plate.layout.grid import Layout
from haptonic.plate.layout.outline import held, outline
from haptonic.plate.layout.parts import Actuator, Plate
from haptonic.plate.layout.supports import WORDS, Support
from haptonic.workshop.rings import Rings
from haptonic.workshop.shape import MM, PillarShape

# 900 square, stepped pillars take 49 s and 0.9 GB as STEP; both grow faster than the number of pillars
MOST_PILLARS = 1500


@dataclass(frozen=True)
class Mark:
    """A line for reference that is not an edge of the part.

    line : (n, 2) corners, with the first one repeated at the end of a closed line; (2, 2) for a support, with
        the plate to its left
    name, note : meaning of the line, and further facts
    """

    layer: Literal["CELL", "REGION", "PATCH", "HELD"]
    line: Array
    name: str = ""
    note: str = ""


@dataclass(frozen=True)
class Part:
    """A plate with its pillars between z = 0 and its thickness, or beyond both. Lengths in mm.

    outline : closed loops of (n, 2) corners with the plate to their left: its edge, which runs anticlockwise,
        then its holes
    standing : each kind of pillar, or of stack of discs, with the (n, 2) positions of its axes; both faces of
        a mirrored cell have it
    source : the study's cell, in m, which defines the names of dimensions and their tolerances
    count : numbers of columns and rows of cells of a piece of lattice; None for a whole plate
    """

    outline: tuple[Array, ...]
    standing: tuple[tuple[Feature, Array], ...]
    source: UnitCell
    marks: tuple[Mark, ...]
    count: tuple[int, int] | None = None

    @classmethod
    def piece(cls, cell: UnitCell, columns: int = 1, rows: int = 1) -> Part:
        """Make ``columns`` x ``rows`` cells about the origin; columns follow the translation nearer to x.

        A cell of several sites is cut in the widest gap between them.

        Raises
        ------
        GeometryError : a number of columns or rows that is not a positive integer, too many pillars, or a
            pillar that crosses the edge of the plate however the cell is cut
        """
        for name, number in (("columns", columns), ("rows", rows)):
            if isinstance(number, bool) or not isinstance(number, int) or number < 1:
                raise GeometryError.out_of_range(
                    argument=name,
                    given=number,
                    allowed="a positive integer",
                    cause="the plate's length was given instead of the number of its cells",
                    next_step="count the cells along that side, and give their number",
                )
        _check_number(columns * rows * sum(map(bool, cell.features)) * cell.copies)
        features = tuple(f.scaled(MM) if isinstance(f, Pillar) else f for f in cell.features)
        source, cell = cell, _in_mm(cell)
        assert np.linalg.det(cell.lattice.vectors) > 0, "a1, a2 turn anticlockwise"
        # the shortest vectors of an oblique lattice may begin with the one that the user gave last
        first_along_x = _steepness(cell.lattice.vectors[0]) <= _steepness(cell.lattice.vectors[1])
        first_count, second_count = (columns, rows) if first_along_x else (rows, columns)
        i, j = np.meshgrid(
            np.arange(first_count + 1) - first_count / 2,
            np.arange(second_count + 1) - second_count / 2,
            indexing="ij",
        )
        corners = np.asarray(np.stack([i, j], axis=-1) @ cell.lattice.vectors)  # (columns + 1, rows + 1, 2)
        # full lines, because two cells share their border
        borders = [line[[0, -1]] for line in [*corners, *corners.swapaxes(0, 1)]]
        first, kinds = corners[:-1, :-1].reshape(-1, 2), dict[Feature, list[Array]]()
        for share, pillar in zip(_cut(cell, features), features, strict=True):
            if pillar is not None:
                kinds.setdefault(pillar, []).append(first + share @ cell.lattice.vectors)
        standing = tuple((pillar, np.concatenate(places)) for pillar, places in kinds.items())
        outline = np.array([corners[0, 0], corners[-1, 0], corners[-1, -1], corners[0, -1]])
        marks = tuple(Mark("CELL", border) for border in borders)
        return cls(outline=(outline,), standing=standing, source=source, marks=marks, count=(columns, rows))

    @classmethod
    def whole(cls, plate: Plate, cell: UnitCell) -> Part:
        """Make the whole plate of a study; the origin is the lower left corner of its map.

        Regions, patches and supports are marks. ``cell`` is the study's cell.

        Raises
        ------
        GeometryError : too many pillars, or tiles that touch at a corner only
        """
        layout = plate.layout
        _check_number(len(layout.features))
        kinds: dict[Feature, list[tuple[float, float]]] = {}
        for x, y, pillar in layout.features:
            kinds.setdefault(pillar, []).append((x, y))
        # pillars of the study's cell come first, because their dimensions may have tolerances
        standing = tuple(
            (kind.scaled(MM) if isinstance(kind, Pillar) else kind, MM * np.array(kinds[kind]))
            for kind in sorted(kinds, key=lambda kind: (kind not in cell.features, -len(kinds[kind])))
        )
        marks = [
            Mark("REGION", MM * np.concatenate([loop, loop[:1]]), name)
            for name in layout.regions
            for loop in outline(layout, {name})
        ]
        marks += [_patch(actuator) for actuator in plate.actuators]
        marks += [mark for support in plate.supports for mark in _support_marks(layout, support)]
        edges = tuple(MM * loop for loop in outline(layout, set(layout.there.values())))
        _check_whole(edges)
        return cls(edges, standing, cell, tuple(marks))

    @cached_property
    def cell(self) -> UnitCell:
        """The study's cell in mm, without discs."""
        return _in_mm(self.source)

    @cached_property
    def corners(self) -> tuple[Array, Array]:
        """Lower left and upper right corner of the bounding rectangle."""
        every = np.concatenate(self.outline)
        return every.min(axis=0), every.max(axis=0)

    def table(self, feature: Feature) -> str | None:
        """Table of the study that gives a kind of feature, such as ``cell.site[2].``, or None."""
        features = (self.cell if isinstance(feature, Pillar) else self.source).features
        return self.source.table_of(features.index(feature)) if feature in features else None

    @property
    def size(self) -> tuple[float, float]:
        """Width and depth of the bounding rectangle."""
        low, high = self.corners
        return float(high[0] - low[0]), float(high[1] - low[1])

    @property
    def sides(self) -> tuple[float, float, float | None]:
        """Lengths of two sides of a piece, and their smaller angle (rad), None for a right one.

        A whole plate has the sides of its bounding rectangle.
        """
        if self.count is None:
            return *self.size, None
        # columns first, which lie along the side nearer to x
        first, second = sorted(np.diff(self.outline[0][:3], axis=0), key=_steepness)
        lengths = float(np.linalg.norm(first)), float(np.linalg.norm(second))
        angle = float(np.arccos(abs(first @ second) / np.prod(lengths)))
        return *lengths, None if np.isclose(angle, 0.5 * np.pi) else angle

    @property
    def pillars(self) -> tuple[tuple[Pillar, Array], ...]:
        """Kinds of pillars, with their positions."""
        return tuple((kind, places) for kind, places in self.standing if isinstance(kind, Pillar))

    @property
    def stacks(self) -> tuple[tuple[Rings, Array], ...]:
        """Kinds of stacks of discs, with their positions."""
        plate = self.cell.material
        return tuple((Rings.of(kind, plate), at) for kind, at in self.standing if isinstance(kind, Stack))

    @property
    def number(self) -> int:
        """Number of pillars on both faces together."""
        return self.cell.copies * sum(len(places) for _, places in self.pillars)

    @property
    def number_of_stacks(self) -> int:
        """Number of stacks of discs; an image on the lower face belongs to its stack."""
        return sum(len(places) for _, places in self.stacks)

    @property
    def parts(self) -> str:
        """Numbers of pillars and stacks of discs, as text."""
        numbers = {"pillar": self.number, "disc stack": self.number_of_stacks}
        texts = [counted(number, noun) for noun, number in numbers.items() if number]
        return listed(texts) or "0 pillars"

    @property
    def faces(self) -> int:
        """Number of smooth surfaces of pillars and discs, which determines the cost of a solid."""
        bodies = [(PillarShape.of(pillar), len(places)) for pillar, places in self.pillars]
        around = [body.outline.joints or 1 for body, _ in bodies]
        stacks = sum(len(places) * 4 * stack.grid.size for stack, places in self.stacks)
        return stacks + self.cell.copies * sum(
            number * (1 + sides * (len(body.side) - (body.arc is None)))
            for sides, (body, number) in zip(around, bodies, strict=True)
        )

    @property
    def narrowest(self) -> float:
        """Smallest of the lattice's pitch and the widths of pillars and rings."""
        widths = [2 * pillar.narrowest for pillar, _ in self.pillars]
        return min([self.cell.lattice.pitch, *widths, *(stack.narrowest for stack, _ in self.stacks)])

    @property
    def materials(self) -> tuple[Material, ...]:
        """All materials, the plate's first."""
        solids = [self.cell.material, *(self.solid_of(pillar) for pillar, _ in self.pillars)]
        return tuple(
            dict.fromkeys([*solids, *(solid for stack, _ in self.stacks for solid in stack.materials)])
        )

    def solid_of(self, pillar: Pillar) -> Material:
        """Material of a pillar, which by default is the plate's."""
        return pillar.material or self.cell.material

    def volume_of(self, material: Material) -> float:
        """Volume of all parts of a material, mm^3."""
        pillars = (
            len(at) * pillar.volume for pillar, at in self.pillars if self.solid_of(pillar) == material
        )
        rings = (len(at) * ring.volume for stack, at in self.stacks for ring in stack.rings(material))
        total = self.cell.copies * sum(pillars) + sum(rings)
        if material == self.cell.material:
            area = sum(enclosed(loop) for loop in self.outline)  # negative for holes, which run clockwise
            for stack, places in self.stacks:
                area -= len(places) * stack.rim.outline.area * stack.rim.half_width**2
            total += area * self.cell.thickness
        return total

    @property
    def volume(self) -> float:
        """Volume of all materials, mm^3."""
        return sum(self.volume_of(material) for material in self.materials)

    @property
    def mass(self) -> float:
        """Mass of all materials, kg."""
        return sum(self.volume_of(material) * material.density for material in self.materials) / MM**3


def _in_mm(cell: UnitCell) -> UnitCell:
    """A cell in mm without its discs, whose heights above the plate have limits in m."""
    sites = tuple(replace(site, disc=()) for site in cell.site)
    return replace(cell, disc=(), site=sites).scaled(MM)


def _steepness(side: Array) -> float:
    """Sine of the angle between a side (2,) and x."""
    return float(abs(side[1]) / np.linalg.norm(side))


def _check_number(pillars: int) -> None:
    if pillars > MOST_PILLARS:
        raise GeometryError.too_large(
            argument="export",
            given=f"{pillars} pillars",
            allowed=f"at most {MOST_PILLARS}",
            cause="a solid with every one of them would take too much time and memory",
            next_step="export a piece of it: --columns 10 --rows 10, and let the workshop repeat it",
        )


def _cut(cell: UnitCell, features: tuple[Feature | None, ...]) -> Array:
    """(n, 2) positions of a cell's sites in shares of the translations, cut so that features stay whole."""
    if cell.is_simple:
        return np.array([[0.5, 0.5]])
    shares = (cell.shares - [_widest_gap(along) for along in cell.shares.T]) % 1.0
    across = np.linalg.inv(cell.lattice.vectors)  # its columns are normal to the sides
    for share, feature in zip(shares, features, strict=True):
        room = (np.minimum(share, 1 - share) / np.linalg.norm(across, axis=0)).min()
        widest = feature.widest * (MM if isinstance(feature, Stack) else 1) if feature else 0.0
        if room < widest:
            raise GeometryError.conflict(
                argument="cell.site",
                given=f"a pillar or disc {2 * widest:.4g} mm wide, {room:.4g} mm from the plate's edge",
                allowed="pillars with their whole foot on the plate",
                cause="the sites leave no room for a straight cut between them",
                next_step="describe the same lattice by a larger cell, or draw the plate by hand",
            )
    return np.asarray(shares)


def _widest_gap(shares: Array) -> float:
    """Middle of the widest gap between some shares of a translation, from 0 to 1."""
    edges = np.sort(shares)
    gaps = np.diff(np.append(edges, edges[0] + 1.0))
    widest = int(np.argmax(np.round(gaps, 9)))
    return float((edges[widest] + 0.5 * gaps[widest]) % 1.0)


def _patch(actuator: Actuator) -> Mark:
    centre, (width, depth, thickness) = np.array(actuator.centre), actuator.size
    arms = 0.5 * np.array([width, depth]) * [[-1, -1], [1, -1], [1, 1], [-1, 1], [-1, -1]]
    glue = actuator.bond
    bond = f", {MM * glue.thickness:.4g} of {glue.material.name} below it" if glue else ""
    return Mark(
        "PATCH", MM * (centre + arms), actuator.name, f"{MM * thickness:.4g}, {actuator.material.name}{bond}"
    )


def _support_marks(layout: Layout, support: Support) -> list[Mark]:
    """Marks along the sides of a support, with its kind and, for a part of a side, its extent."""
    note = f", {MM * support.length:.4g} from the corners" if support.length is not None else ""
    return [Mark("HELD", MM * ends, WORDS[support.hold], note) for _, ends in held(layout, support)]


def _check_whole(edges: tuple[Array, ...]) -> None:
    """Refuse a plate with two tiles that touch at a corner only, where its edges pass twice."""
    places, passed = np.unique(np.concatenate(edges), axis=0, return_counts=True)
    if (passed == 1).all():
        return
    x, y = places[np.argmax(passed)]
    raise GeometryError.unsupported(
        argument="plate.map",
        given=f"two tiles that touch at a corner only, at ({x:.4g}, {y:.4g}) mm",
        allowed="a plate whose tiles meet at their sides",
        cause="a solid cannot have edges that meet in a line",
        next_step="add or leave out a tile there, or export a piece: --columns 10 --rows 10",
    )
