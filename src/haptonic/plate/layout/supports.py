"""Supports of a plate at edges and corners: free, clamped, simply supported or on springs."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Annotated, Literal

from haptonic.fields import Quantity, described, needed, problem, setting, size
from haptonic.plate.layout.grid import Side
from haptonic.units import format_quantity

SIDES: tuple[Side, ...] = ("left", "right", "bottom", "top")
Held = Literal["left", "right", "bottom", "top", "corners"]
Hold = Literal["clamped", "simple", "spring"]
WORDS: Mapping[Hold, str] = MappingProxyType(
    {"clamped": "clamped", "simple": "simple support", "spring": "elastic foundation"}
)
EdgeHold = Literal["free", "clamped", "simple", "spring"]
FoundationStiffness = Annotated[float, Quantity("N/m^3", above=0.0, at_most=1e20, typical=(1e6, 1e16))]
Loss = Annotated[float, Quantity("", at_least=0.0, below=1.0, typical=(0.0, 0.5))]


@dataclass(frozen=True)
class Support:
    """Support of the plate at its outer side faces.

    where : faces on one side, or their parts next to the corners of the map
    hold : "clamped" no motion; "simple" no motion along the face (hard simple support), normal motion free;
        "spring" an elastic foundation
    length : of the supported part of each face from the corner on, m; only for "corners"
    stiffness : of the foundation, per area of side face and alike in all directions, N/m^3; only for "spring"
    loss_factor : of the foundation
    """

    where: Held
    hold: Hold
    length: float | None = None
    stiffness: float | None = None
    loss_factor: float = 0.0


@described("plate.edges", kw_only=True)
class Edges:
    """Supports of the outer side faces of the plate, by their direction."""

    left: EdgeHold = setting("free", "Support of the side faces that point left.", title="Left edge")
    right: EdgeHold = setting("free", "Support of the side faces that point right.", title="Right edge")
    bottom: EdgeHold = setting("free", "Support of the side faces that point down.", title="Bottom edge")
    top: EdgeHold = setting("free", "Support of the side faces that point up.", title="Top edge")
    spring: FoundationStiffness | None = setting(
        None, 'Stiffness per area of every edge on a "spring".', title="Springs of the edges"
    )
    loss_factor: Loss = setting(
        0.0, "Imaginary over real part of their stiffness.", title="Loss of the edges' springs"
    )

    def __post_init__(self) -> None:
        on_springs = [side for side in SIDES if getattr(self, side) == "spring"]
        if on_springs and self.spring is None:
            raise problem(
                "missing",
                "nothing", f"a stiffness per area, because {on_springs[0]} is on a spring",
                "the stiffness was left out", 'add spring = "1e12 N/m^3"', at="spring",
            )  # fmt: skip
        if self.spring is not None and not on_springs:
            raise problem(
                "conflict",
                format_quantity(self.spring, "N/m^3"), 'a stiffness only where some edge is on a "spring"',
                "no edge is", 'write left = "spring", or leave spring out', at="spring",
            )  # fmt: skip
        _belongs_to_springs(self)

    @property
    def supports(self) -> tuple[Support, ...]:
        """Support of each side that is not free."""
        supports = []
        for side in SIDES:
            hold: EdgeHold = getattr(self, side)
            if hold == "spring":
                supports.append(Support(side, hold, stiffness=self.spring, loss_factor=self.loss_factor))
            elif hold != "free":
                supports.append(Support(side, hold))
        return tuple(supports)


@described("plate.clamp", kw_only=True)
class Clamp:
    """Support of the plate at the four corners of the rectangle around it."""

    corners: Annotated[float, size(100e-9, 100e-3)] = needed(
        "Clamped length of each side face, from the corner on.", title="Clamped length"
    )
    spring: FoundationStiffness | None = setting(
        None, "Stiffness per area; else the corners are clamped.", title="Springs of the corners"
    )
    loss_factor: Loss = setting(
        0.0, "Imaginary over real part of their stiffness.", title="Loss of the corners' springs"
    )

    def __post_init__(self) -> None:
        _belongs_to_springs(self)

    @property
    def support(self) -> Support:
        """Support of the corners with these settings."""
        if self.spring is None:
            return Support("corners", "clamped", length=self.corners)
        return Support(
            where="corners",
            hold="spring",
            length=self.corners,
            stiffness=self.spring,
            loss_factor=self.loss_factor,
        )


def _belongs_to_springs(held: Edges | Clamp) -> None:
    if held.loss_factor and held.spring is None:
        raise problem(
            "conflict",
            format_quantity(held.loss_factor, ""), "a loss factor only where there are springs",
            "a clamped edge does not move, so it has no losses", "leave it out, or give a spring",
            at="loss_factor",
        )  # fmt: skip
