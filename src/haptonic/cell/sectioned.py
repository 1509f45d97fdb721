"""Common part of pillars and discs: a section about an axis, given by a name and numbers."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cached_property
from typing import Annotated, Any, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from haptonic.cell.outlines import NUMBERS, SECTIONS, Outline, Scaled, Section, SectionName, taken_by
from haptonic.cell.pillar_parts import Corner
from haptonic.fields import LARGEST, Quantity, Synonyms, problem, setting, size
from haptonic.materials import Material, is_symmetry
from haptonic.units import format_quantity

MOST_CORNERS = 24  # of a section
LEAST_LENGTH, MOST_LENGTH = 20e-9, 50e-3  # m
# declarations of the numbers of a section, shared by the classes with a section
GivenSection = Annotated[SectionName, Synonyms(circle="round", circular="round")]
SECTION = setting("round", "Section seen from above. Before the turn, sides of a square lie along x and y.")
SectionLength = Annotated[float, size(LEAST_LENGTH, MOST_LENGTH)] | None
LENGTH = setting(
    None, "Width of a rectangle or an ellipse along y.", title="Length of the section", examples=["5 mm"]
)
ArmWidth = Annotated[float, size(LEAST_LENGTH, MOST_LENGTH)] | None
ARM_WIDTH = setting(
    None, "Width of each arm of a cross or a snowflake.", title="Width of the arms", examples=["1 mm"]
)
SectionSides = Annotated[int, Field(ge=3, le=MOST_CORNERS)] | None
SIDES = setting(None, "Number of sides of a regular polygon.", title="Number of sides")
CornerRadius = Annotated[float, Quantity("m", at_least=0.0, at_most=LARGEST)] | None
CORNER_RADIUS = setting(
    None, "Radius of rounded corners, seen from above; without it they are sharp.", examples=["0.5 mm"]
)
SectionTurn = Annotated[float, Quantity("rad", at_least=-math.pi, at_most=math.pi)] | None
TURN = setting(
    None, "Angle by which the section is turned anticlockwise.", title="Turn of the section",
    examples=["45 deg"],
)  # fmt: skip
CORNERS = setting(
    (),
    'Corners of the section "points", in order, each visible from the axis.',
    title="Corners of the section",
    max_length=MOST_CORNERS,
)


LENGTHS = ("length", "arm_width", "corner_radius")  # numbers of a section beside its diameter, in m


class Sectioned:
    """A prism, solid or empty, with one section about an axis; subclasses declare these numbers.

    diameter : width of the section along x, m; see `haptonic.cell.outlines` for the other numbers
    """

    diameter: float
    section: SectionName
    length: float | None
    arm_width: float | None = None  # discs declare it; sections of pillars bend inwards nowhere
    sides: int | None
    corner_radius: float | None
    turn: float | None
    point: tuple[Corner, ...]
    material: Material | None

    def check_section(self) -> None:
        """Refuse numbers that do not belong to the section, or form no outline."""
        takes = taken_by(SECTIONS[self.section])
        for name in NUMBERS:
            given = getattr(self, name)
            having = [other for other, kind in SECTIONS.items() if name in taken_by(kind)]
            allowed = f"{name} for a section that is {', '.join(having[:-1])} or {having[-1]}"
            allowed = allowed if len(having) > 1 else f"{name} for the section {having[0]}"
            if takes.get(name) and not given:
                cause = "it was left out, or is empty"
                raise problem("missing", "nothing", allowed, cause, f"give {name}", at=name)
            if given and name not in takes:
                raise problem(
                    "conflict",
                    f"{len(given)} corners"
                    if name == "point"
                    else format_quantity(given, "m" if name in LENGTHS else ""),
                    f"{allowed}, and for no other",
                    f"a section that is {self.section} is given without it",
                    f'remove {name}, or write section = "{having[0]}"',
                    at=name,
                )
        self.form.check()

    def check_sides(self, *names: str) -> None:
        """Refuse a draft or a fillet that the section cannot have."""
        for name in names:
            if getattr(self, name) and not self.outline.is_tangential:
                raise problem(
                    "unsupported",
                    f"{name} on a section that is {self.section}",
                    "none on a section whose sides are not equally far from the axis, or rounded",
                    "its outline would change its shape with the height",
                    f"remove {name}, or take a round, square, hexagon or polygon section with sharp corners",
                    at=name,
                )

    @cached_property
    def form(self) -> Section:
        """The section with its numbers: lengths per diameter, radii per half diameter."""
        per_half = {"length": 1.0, "arm_width": 1.0, "corner_radius": 2.0}
        numbers: dict[str, Any] = {}
        for name in taken_by(SECTIONS[self.section]):
            if (given := getattr(self, name)) is not None:
                numbers[name] = per_half[name] * given / self.diameter if name in per_half else given
        return SECTIONS[self.section](**numbers)

    @cached_property
    def _least(self) -> float:
        """Smallest half-width of the section, in half diameters."""
        return self.form.outline().inradius

    @cached_property
    def outline(self) -> Outline:
        """Outline of every section, scaled to a smallest half-width of 1."""
        outline = self.form.outline()
        return outline if self._least == 1.0 else outline.scaled(1 / self._least)

    @property
    def radius(self) -> float:
        """Smallest half-width at the foot, without the fillet, m."""
        return 0.5 * self.diameter * self._least

    def turned(self, angle: float) -> Self:
        """A copy turned anticlockwise about its axis, rad; itself if the rotation leaves it unchanged."""
        cosine, sine = math.cos(angle), math.sin(angle)
        if self.outline.has_symmetry(np.array([[cosine, -sine], [sine, cosine]])):
            return self
        whole = (self.turn or 0.0) + angle
        copy: Self = replace(self, turn=math.remainder(whole, 2 * math.pi))  # type: ignore[type-var]
        return copy

    @property
    def widest(self) -> float:
        """Largest half-width of its sections, in the direction of the smallest half-width, m."""
        return self.radius

    @property
    def broadest(self) -> float:
        """Like `widest`, without a fillet, m."""
        return self.radius

    @property
    def raised(self) -> Scaled:
        """Its widest section, without a fillet."""
        return Scaled(self.outline, self.broadest)

    def has_symmetry(self, turn: NDArray[np.float64]) -> bool:
        """True if an orthogonal map (3, 3) of space that keeps the normal leaves it unchanged."""
        return self.outline.has_symmetry(turn[:2, :2])

    def keeps_material(self, turn: NDArray[np.float64]) -> bool:
        """True if a map leaves its own material unchanged; the tile checks the plate's material."""
        return self.material is None or is_symmetry(self.material.stiffness, turn)

    def scaled_numbers(self, factor: float) -> dict[str, Any]:
        """Lengths of the section beside the diameter, multiplied by a factor."""
        return {name: given * factor for name in LENGTHS
                if (given := getattr(self, name)) is not None}  # fmt: skip
