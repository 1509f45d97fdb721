"""What every file of a workshop derives from: the shape of a pillar and the numbers that make a cell.

Lengths are in the unit of what they are taken from, millimetres for a `Part`. A place on a pillar is
(half-width, height above the plate's top). A new number of the cell is added here, to `PillarShape.of` and
`dimensions`. Horizontal cuts are outlines (`cell.outlines`): the files follow a new one.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np

from haptonic.arrays import Array
from haptonic.cell import Pillar, UnitCell
from haptonic.cell.outlines import Outline, Section
from haptonic.cell.pillar_parts import Fillet

Place = tuple[float, float]

MM = 1e3  # mm in a metre


@dataclass(frozen=True)
class PillarShape:
    """What stands on every cell: an outline whose half-width follows a profile.

    outline : of every horizontal cut, for a half-width of 1; form : the section that it comes from
    side : (n, 2) places from the foot, or the end of its fillet, to the top's edge, straight in between
    arc : the fillet before them, if there is one
    outlines : half-widths that are cut to, by the layer that a DXF file has them on
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
        "width" at a place, the "radius" of the fillet or the "angle" of a side; the "turn" and what else is
        "seen" from above are in the list alone
    low, high : heights between which it lies, of a height
    place : where it is seen, of all others in the section
    """

    name: str | None
    value: float
    kind: Literal["across", "deep", "left", "right", "width", "radius", "angle", "turn", "seen"]
    low: float = 0.0
    high: float = 0.0
    place: Place = (0.0, 0.0)


def dimensions(cell: UnitCell) -> list[Dimension]:
    """Every dimension of a cell, in the cell's unit of length and radians."""
    found = [*sides(cell), *heights(cell.thickness, None)]
    if cell.lattice.angle is not None:
        found.append(Dimension("cell.angle", cell.lattice.angle, "angle"))
    for at, (number, *_) in cell.pillar_tables.items():
        found += heights(cell.thickness, cell.pillars[number], at)[1:]
    return found


def sides(cell: UnitCell) -> list[Dimension]:
    """Of the lattice: its pitch, and the second one or the pitch again."""
    others = {name: getattr(cell.lattice, name) for name in ("pitch_y", "pitch_2", "pitch")}
    second = next(name for name, value in others.items() if value is not None)
    return [
        Dimension("cell.pitch", cell.lattice.pitch, "across"),
        Dimension(f"cell.{second}", others[second], "deep"),
    ]


def heights(thickness: float, pillar: Pillar | None, at: str = "cell.pillar") -> list[Dimension]:
    """Of a section through plate and pillar, which a table of the study gives; the thickness first."""
    found = [Dimension("cell.thickness", thickness, "left", low=-thickness)]
    if pillar is None:
        return found
    body = PillarShape.of(pillar)
    found.append(Dimension(f"{at}.diameter", pillar.diameter, "width", place=(pillar.radius, 0.0)))
    found.append(Dimension(f"{at}.height", pillar.height, "left", high=pillar.height))
    for name in ("length", "corner_radius", "turn"):
        if (value := getattr(pillar, name)) is not None:
            found.append(Dimension(f"{at}.{name}", value, "turn" if name == "turn" else "seen"))
    if pillar.arc is not None:
        width, height = pillar.arc.at(0.75).tolist()
        found.append(Dimension(f"{at}.fillet", pillar.fillet, "radius", place=(width, height)))
    if pillar.step is not None:
        step = pillar.step
        found.append(Dimension(f"{at}.step.height", step.height, "right", high=step.height))
        place = (0.5 * step.diameter, step.height)
        found.append(Dimension(f"{at}.step.diameter", step.diameter, "width", place=place))
    if pillar.draft:
        top, last = body.side[-1].tolist(), len(pillar.stages) - 1
        height = 0.6 * top[1] + 0.4 * pillar.stages[last][0]
        place = (pillar.half_width(height, last), height)
        found.append(Dimension(f"{at}.draft", pillar.draft, "angle", place=place))
        found.append(Dimension(None, 2 * top[0], "width", place=(top[0], top[1])))
    return found


def dimensions_of(cell: UnitCell) -> dict[str, float]:
    """Name and value (m, rad) of every dimension that makes this cell."""
    return {one.name: one.value for one in dimensions(cell) if one.name}
