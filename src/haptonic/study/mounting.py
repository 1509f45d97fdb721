"""The tables of the study file about what holds a plate and what drives it."""

from __future__ import annotations

import math
from typing import Annotated, Literal

from pydantic import Field

from haptonic.fields import LARGEST, Name, Quantity, described, problem, size
from haptonic.plate.layout import Side
from haptonic.units import format_quantity

SIDES: tuple[Side, ...] = ("left", "right", "bottom", "top")


Hold = Literal["free", "clamped", "simple", "spring"]


Position = Annotated[float, Quantity("m", at_least=-LARGEST, at_most=LARGEST)]
Width = Annotated[float, size(100e-6, 100e-3)]
PatchThickness = Annotated[float, size(20e-6, 10e-3)]
BondThickness = Annotated[float, size(0.5e-6, 1e-3)]
Phase = Annotated[float, Quantity("rad", at_least=-2 * math.pi, at_most=2 * math.pi)]
Bed = Annotated[float, Quantity("N/m^3", above=0.0, at_most=1e20, typical=(1e6, 1e16))]
Loss = Annotated[float, Quantity("", at_least=0.0, below=1.0, typical=(0.0, 0.5))]


@described("plate.edges", kw_only=True)
class EdgesSection:
    """What holds the outer side faces of the plate, by the direction in which they look."""

    left: Hold = Field(default="free", title="Left edge", description="What holds the faces that look left.")
    right: Hold = Field(
        default="free",
        title="Right edge",
        description="What holds the faces that look right.",
    )
    bottom: Hold = Field(
        default="free",
        title="Bottom edge",
        description="What holds the faces that look down.",
    )
    top: Hold = Field(default="free", title="Top edge", description="What holds the faces that look up.")
    spring: Bed | None = Field(
        default=None,
        title="Springs of the edges",
        description='Stiffness per area of every edge on a "spring".',
    )
    loss_factor: Loss = Field(
        default=0.0,
        title="Loss of the edges' springs",
        description="Imaginary over real part of their stiffness.",
    )

    def __post_init__(self) -> None:
        on_springs = [side for side in SIDES if getattr(self, side) == "spring"]
        if on_springs and self.spring is None:
            raise problem(
                "nothing", f"a stiffness per area, because {on_springs[0]} is on a spring",
                "the stiffness was left out", 'add spring = "1e12 N/m^3"', at="spring",
            )  # fmt: skip
        if self.spring is not None and not on_springs:
            raise problem(
                format_quantity(self.spring, "N/m^3"), 'a stiffness only where some edge is on a "spring"',
                "no edge is", 'write left = "spring", or leave spring out', at="spring",
            )  # fmt: skip
        _belongs_to_springs(self)


def _belongs_to_springs(section: EdgesSection | ClampSection) -> None:
    if section.loss_factor and section.spring is None:
        raise problem(
            format_quantity(section.loss_factor, ""), "a loss factor only where there are springs",
            "what is clamped does not move, so it loses nothing", "leave it out, or give a spring",
            at="loss_factor",
        )  # fmt: skip


@described("plate.clamp", kw_only=True)
class ClampSection:
    """What holds the plate at the four corners of the rectangle around it."""

    corners: Annotated[float, size(100e-6, 100e-3)] = Field(
        title="Held length", description="Of each side face, from the corner on."
    )
    spring: Bed | None = Field(
        default=None,
        title="Springs of the corners",
        description="Stiffness per area; else the corners are clamped.",
    )
    loss_factor: Loss = Field(
        default=0.0,
        title="Loss of the corners' springs",
        description="Imaginary over real part of their stiffness.",
    )

    def __post_init__(self) -> None:
        _belongs_to_springs(self)


@described("plate.actuator.bond", kw_only=True)
class BondSection:
    """The glue below an actuator."""

    thickness: BondThickness = Field(title="Thickness of the bond", description="Of the layer of glue.")
    material: Name = Field(title="Material of the bond", description="A built-in one.")


@described("plate.actuator", kw_only=True)
class ActuatorSection:
    """A piezoelectric patch on the face that carries the pillars."""

    name: Name = Field(title="Name", description="Shown in results.")
    region: Name = Field(title="Region", description="Of plain plate, that the whole patch lies on.")
    centre: tuple[Position, Position] = Field(
        title="Centre", description="From the lower left corner of the smallest rectangle around the region."
    )
    size: tuple[Width, Width, PatchThickness] = Field(
        title="Size", description="Along x, along y, and its thickness."
    )
    material: Name = Field(title="Material", description="A built-in piezoelectric one, poled along z.")
    bond: BondSection | None = Field(
        default=None, title="Bond", description="Without this table the patch is one with the plate."
    )
    voltage: Annotated[float, Quantity("V", at_least=0.0, at_most=1e5, typical=(0.0, 1e3))] = Field(
        default=1.0, title="Voltage", description="Amplitude between the electrodes on its two faces."
    )
    phase: Phase = Field(default=0.0, title="Phase", description="Of the voltage.")

    def __post_init__(self) -> None:
        *sides, thickness = self.size
        if thickness > min(sides):
            raise problem(
                format_quantity(thickness, "m"),
                f"at most its shorter side, {format_quantity(min(sides), 'm')}",
                "the sizes are in another order, or this is a stack, which has more than two electrodes",
                "write size = [along x, along y, thickness]", at="size",
            )  # fmt: skip


@described("plate.force", kw_only=True)
class ForceSection:
    """A force normal to the flat face."""

    name: Name = Field(title="Name", description="Shown in results.")
    region: Name = Field(title="Region", description="Or lattice, that all of the force lies on.")
    centre: tuple[Position, Position] = Field(
        title="Centre", description="From the lower left corner of the smallest rectangle around the region."
    )
    size: tuple[Width, Width] | None = Field(
        default=None, title="Size", description="Along x and along y; else the force acts at a point."
    )
    force: Annotated[float, Quantity("N", at_least=0.0, at_most=1e6, typical=(0.0, 100.0))] = Field(
        default=1.0, title="Force", description="Amplitude of its total."
    )
    phase: Phase = Field(default=0.0, title="Phase", description="Of the force.")


@described("plate.finger", kw_only=True)
class FingerSection:
    """A finger on the flat face: a mass on a spring and a damper, spread over a disc."""

    region: Name = Field(title="Region", description="Or lattice, from whose corner its centre counts.")
    centre: tuple[Position, Position] = Field(
        title="Centre", description="From the lower left corner of the smallest rectangle around the region."
    )
    diameter: Annotated[float, size(1e-3, 40e-3)] = Field(
        default=10e-3, title="Diameter", description="Of the disc that it touches."
    )
    mass: Annotated[float, Quantity("kg", above=0.0, at_most=1e3, typical=(1e-5, 1.0))] | None = Field(
        default=None,
        title="Mass",
        description="That vibrates with the pad; else spring and damper end at rest.",
    )
    stiffness: Annotated[float, Quantity("N/m", at_least=0.0, at_most=1e12, typical=(0.0, 1e6))] = Field(
        default=0.0, title="Stiffness of the pad", description="Of the whole disc."
    )
    damping: Annotated[float, Quantity("N s/m", at_least=0.0, at_most=1e9, typical=(0.0, 1e3))] = Field(
        default=0.0, title="Damping of the pad", description="Of the whole disc."
    )

    def __post_init__(self) -> None:
        if self.stiffness == 0 and self.damping == 0:
            raise problem(
                "neither stiffness nor damping", "at least one of them above zero",
                "nothing ties the finger to the plate", 'add damping = "10 N s/m", or remove the finger',
                at="damping",
            )  # fmt: skip
