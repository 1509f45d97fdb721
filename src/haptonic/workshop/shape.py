"""Shape of a pillar and dimensions of a cell, from which all workshop files are derived.

Lengths are in the unit of the source, millimetres for a `Part`. A place on a pillar is (half-width, height
above the plate's top). Add a new number of the cell here, to `PillarShape.of` and `dimensions`. Horizontal
cuts are outlines (`cell.outlines`), so the files support a new outline without a change.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np

from haptonic.arrays import Array
from haptonic.cell import Disc, Pillar, UnitCell
from haptonic.cell.outlines import Outline, Section
from haptonic.cell.pillar_parts import Fillet
from haptonic.cell.sectioned import LENGTHS

Place = tuple[float, float]
Kind = Literal["across", "deep", "left", "right", "width", "radius", "angle", "turn", "seen", "level"]

MM = 1e3  # mm in a metre
OF_DISC: dict[str, Kind] = {
    "diameter": "seen", **dict.fromkeys(LENGTHS, "seen"), "draft": "angle", "turn": "turn",
    "low": "level", "high": "level",
}  # fmt: skip
"""Kinds of the numbers of a disc; see `Dimension`."""


@dataclass(frozen=True)
class PillarShape:
    """Shape of a pillar: an outline whose half-width follows a profile.

    outline : of every horizontal cut, for a half-width of 1
    form : section that it comes from
    side : (n, 2) places from the foot, or the end of its fillet, to the top's edge, straight in between
    arc : fillet before these places, or None
    outlines : half-widths of the cuts in a DXF file, by layer
    """

    outline: Outline
    form: Section
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
        return cls(
            outline=pillar.outline,
            form=pillar.form,
            side=np.array(side, dtype=float),
            arc=pillar.arc,
            outlines=outlines,
        )

    @property
    def height(self) -> float:
        return float(self.side[-1, 1])

    @property
    def foot(self) -> float:
        """Half-width at the plate, including the fillet."""
        return max(self.outlines["PILLAR"], self.outlines.get("FILLET", 0.0))

    @property
    def widest(self) -> float:
        """Largest half-width, without the fillet."""
        return max(self.outlines["PILLAR"], float(self.side[:, 0].max()))

    def flank(self, pieces: int) -> Array:
        """(n, 2) the profile from the plate to the top's edge, its fillet in ``pieces`` straight pieces."""
        if self.arc is None:
            return self.side
        return np.concatenate([self.arc.at(np.arange(pieces) / pieces), self.side])

    def is_free_above(self, half_width: float, height: float) -> bool:
        """True if nothing above this height is wider, so that a tool or an extension line reaches it."""
        above = self.side[self.side[:, 1] > height, 0]
        return bool((above <= half_width * (1 + 1e-9)).all())


@dataclass(frozen=True)
class Dimension:
    """A number of the cell, and its position in the drawing.

    name : its path in a study; None for a number that follows from others and is shown for reference
    value : m or rad (mm for a cell in mm)
    kind : "across" and "deep" along the plan's sides; in the section a height ("left" or "right" of it), the
        "width" at a place, the "radius" of the fillet or the "angle" of a side; the "turn", other numbers
        "seen" from above, and the "level" of an end of a disc are only in the list
    low, high : ends of a height
    place : position of the other numbers in the section
    """

    name: str | None
    value: float
    kind: Kind
    low: float = 0.0
    high: float = 0.0
    place: Place = (0.0, 0.0)

    @property
    def is_angle(self) -> bool:
        """True for an angle, in rad; other numbers are lengths."""
        return self.kind in ("angle", "turn")


def dimensions(cell: UnitCell) -> list[Dimension]:
    """Every dimension of a cell, in the cell's unit of length and radians."""
    numbers = [*sides(cell), *heights(cell.thickness, None)]
    if cell.lattice.angle is not None:
        numbers.append(Dimension("cell.angle", cell.lattice.angle, "angle"))
    for at, (number, *_) in cell.pillar_tables.items():
        numbers += heights(cell.thickness, cell.pillars[number], at)[1:]
    for below, disc in cell.discs.items():
        numbers += of_disc(disc, f"cell.{below}")
    return numbers


def sides(cell: UnitCell) -> list[Dimension]:
    """Dimensions of the lattice: its pitch, and the second pitch, or the first one again."""
    others = {name: getattr(cell.lattice, name) for name in ("pitch_y", "pitch_2", "pitch")}
    second = next(name for name, value in others.items() if value is not None)
    return [
        Dimension("cell.pitch", cell.lattice.pitch, "across"),
        Dimension(f"cell.{second}", others[second], "deep"),
    ]


def heights(thickness: float, pillar: Pillar | None, at: str = "cell.pillar") -> list[Dimension]:
    """Dimensions of a section through plate and pillar, which a table of the study gives; thickness first."""
    numbers = [Dimension("cell.thickness", thickness, "left", low=-thickness)]
    if pillar is None:
        return numbers
    body = PillarShape.of(pillar)
    numbers.append(Dimension(f"{at}.diameter", pillar.diameter, "width", place=(pillar.radius, 0.0)))
    numbers.append(Dimension(f"{at}.height", pillar.height, "left", high=pillar.height))
    for name in ("length", "corner_radius", "turn"):
        if (value := getattr(pillar, name)) is not None:
            numbers.append(Dimension(f"{at}.{name}", value, "turn" if name == "turn" else "seen"))
    if pillar.arc is not None:
        width, height = pillar.arc.at(0.75).tolist()
        numbers.append(Dimension(f"{at}.fillet", pillar.fillet, "radius", place=(width, height)))
    if pillar.step is not None:
        step = pillar.step
        numbers.append(Dimension(f"{at}.step.height", step.height, "right", high=step.height))
        place = (0.5 * step.diameter, step.height)
        numbers.append(Dimension(f"{at}.step.diameter", step.diameter, "width", place=place))
    if pillar.draft:
        top, last = body.side[-1].tolist(), len(pillar.stages) - 1
        height = 0.6 * top[1] + 0.4 * pillar.stages[last][0]
        place = (pillar.half_width(height, last), height)
        numbers.append(Dimension(f"{at}.draft", pillar.draft, "angle", place=place))
        numbers.append(Dimension(None, 2 * top[0], "width", place=(top[0], top[1])))
    return numbers


def of_disc(disc: Disc, at: str) -> list[Dimension]:
    """Numbers of a disc, which a table of the study gives."""
    given = {name: getattr(disc, name) for name in OF_DISC}
    return [Dimension(f"{at}.{name}", value, OF_DISC[name]) for name, value in given.items() if value]


def dimensions_of(cell: UnitCell) -> dict[str, float]:
    """Name and value (m, rad) of every dimension of a cell."""
    return {dimension.name: dimension.value for dimension in dimensions(cell) if dimension.name}
