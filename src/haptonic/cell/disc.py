"""Disc: a prism or a cone of a material, or empty, about the axis of a site."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Annotated, ClassVar

import numpy as np
from numpy.typing import NDArray

from haptonic.cell.outlines.outline import SAME
from haptonic.cell.pillar_parts import Corner
from haptonic.cell.sectioned import (
    ARM_WIDTH,
    CORNER_RADIUS,
    CORNERS,
    LENGTH,
    SECTION,
    SIDES,
    TURN,
    ArmWidth,
    CornerRadius,
    GivenSection,
    Sectioned,
    SectionLength,
    SectionSides,
    SectionTurn,
)
from haptonic.errors import GeometryError
from haptonic.fields import Aliases, Quantity, absent, described, meant, needed, problem, setting, size
from haptonic.materials import GIVEN, Material
from haptonic.units import format_quantity

FARTHEST = 100e-3  # m, from the plate's top
STEEPEST = math.radians(60)  # draft: that of the widest usual countersink, of 120 degrees
Side = tuple[tuple[float, float], tuple[float, float]]


@described("cell.disc", GeometryError)
class Disc(Sectioned):
    """A prism about the axis of a site, between two heights, or a cone. All lengths in m, angles in rad.

    A disc replaces the material in its place: discs are added in order, and a later one replaces an earlier
    one where they overlap. An empty disc through the plate is a hole, one of another material an inclusion,
    and one on the plate a pillar; several discs make a coating, a layer of glue or a cap. With a draft the
    disc is a cone: a countersink, or as a short disc a chamfer. Discs whose sides continue each other have
    one border.

    Raises
    ------
    GeometryError : numbers that form no section, an upper end that is not above the lower one, or an empty
        disc with a material
    """

    aliases: ClassVar[Aliases] = {
        **meant(
            "diameter", "radius", "r",
            cause="a disc is given by its diameter, which is twice its radius",
            next_step='write "diameter", with twice the value',
        ),
        **meant("diameter", "d", "width", "side", "w"),
        **meant("section", "shape", "outline", "form", "cross_section"),
        **meant("draft", "taper", "taper_angle", "draft_angle"),
        **meant("low", "from", "bottom", "base"),
        **meant("high", "to", "top"),
        **meant("empty", "void", "hole"),
        **absent(
            "chamfer", "bevel", "countersink",
            cause="a chamfer or a countersink is a disc of its own, with a draft",
            next_step="let this disc end where the chamfer begins; add one of the same diameter with a draft",
        ),
        **absent(
            "height", "depth", "thickness",
            cause="a disc reaches from one height to another, both from the plate's upper face",
            next_step="write low and high",
        ),
    }  # fmt: skip

    diameter: Annotated[float, size(20e-9, 50e-3)] = needed(
        "Width along x at the lower end; of a hexagon or polygon, across its flats. Smaller than the pitch "
        "by more than 2 %.",
        title="Disc diameter",
        examples=["5 mm"],
    )
    low: Annotated[float, Quantity("m", at_least=-FARTHEST, at_most=FARTHEST)] | None = setting(
        None,
        "Height of the lower end above the plate's upper face, negative inside the plate; without it the "
        "lower face.",
        title="Lower end of the disc",
        examples=["-0.5 mm"],
    )
    high: Annotated[float, Quantity("m", at_least=-FARTHEST, at_most=FARTHEST)] | None = setting(
        None,
        "Height of the upper end, counted alike; without it the plate's upper face.",
        title="Upper end of the disc",
        examples=["1 mm"],
    )
    material: Annotated[Material, GIVEN] | None = setting(
        None,
        "A built-in name or its constants; without it the disc is of the plate's material.",
        title="Disc material",
    )
    empty: bool = setting(
        False, "True for a hole: the disc contains no material.", title="Empty disc", strict=True
    )
    draft: Annotated[float, Quantity("rad", at_least=-STEEPEST, at_most=STEEPEST)] = setting(
        0.0,
        "Angle between side and normal; positive is narrower at the upper end.",
        title="Draft of the disc",
    )
    section: GivenSection = SECTION
    length: SectionLength = LENGTH
    arm_width: ArmWidth = ARM_WIDTH
    sides: SectionSides = SIDES
    corner_radius: CornerRadius = CORNER_RADIUS
    turn: SectionTurn = TURN
    point: tuple[Corner, ...] = CORNERS

    def __post_init__(self) -> None:
        self.check_section()
        self.check_sides("draft")
        if self.empty and self.material is not None:
            raise problem(
                "conflict",
                f"an empty disc of {self.material.name}",
                "a material, or empty = true",
                "an empty disc has no material",
                "leave one of the two out",
                at="material",
            )
        high = 0.0 if self.high is None else self.high
        if self.low is not None and not self.low < high:
            raise problem(
                "out-of-range",
                format_quantity(self.low, "m"),
                f"below the upper end, {format_quantity(high, 'm')}",
                "the disc has no thickness; heights count upwards from the plate's upper face",
                "check the units of low and high, or give the upper end of a disc that is above the plate",
                at="low",
            )

    def text(self, thickness: float) -> str:
        """Description of the disc, for a plate of some thickness, m."""
        low, high = (format_quantity(end - thickness, "m") for end in self.ends(thickness))
        solid = "empty" if self.empty else self.material.name if self.material else "of the plate's material"
        width = " to ".join(format_quantity(wide, "m") for wide in self.diameters(thickness))
        return f"{self.section} disc {width} wide from {low} to {high}, {solid}"

    def ends(self, thickness: float) -> tuple[float, float]:
        """Heights of lower and upper end above the plate's lower face, m."""
        low = -thickness if self.low is None else self.low
        return thickness + low, thickness + (self.high or 0.0)

    @property
    def is_in_plate(self) -> bool:
        """True if its lower end is inside the plate, or at its lower face."""
        return self.low is None or self.low < 0

    def side(self, thickness: float) -> Side:
        """Half-width at lower and upper end, and height of each above the plate's lower face, m."""
        low, high = self.ends(thickness)
        return (self.radius, low), (self.radius - (high - low) * math.tan(self.draft), high)

    def diameters(self, thickness: float) -> tuple[float, ...]:
        """Diameter of a prism, or that of a cone at its lower and at its upper end, m."""
        wide = [self.diameter / self.radius * width for width, _ in self.side(thickness)]
        return tuple(wide) if self.draft else (self.diameter,)

    def is_image(self, other: Disc, turn: NDArray[np.float64]) -> bool:
        """True if an orthogonal map (3, 3) that keeps the normal maps the disc to another one."""
        same = (self.low, self.high, self.material, self.empty)
        alike = same == (other.low, other.high, other.material, other.empty)
        alike &= abs(self.radius - other.radius) <= SAME * self.radius and self.draft == other.draft
        return alike and self.keeps_material(turn) and self.outline.image(turn[:2, :2]).is_same(other.outline)

    def scaled(self, factor: float) -> Disc:
        """A copy with every length multiplied by ``factor``."""
        return replace(
            self,
            diameter=self.diameter * factor,
            low=self.low and self.low * factor,
            high=self.high and self.high * factor,
            **self.scaled_numbers(factor),
        )
