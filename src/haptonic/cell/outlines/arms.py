"""Sections of straight arms that cross on the axis: crosses and snowflakes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from haptonic.cell.outlines.polygon import Polygon
from haptonic.cell.outlines.section import Polygonal
from haptonic.fields import problem

THINNEST = 0.05  # of the span, smallest width of an arm: elements in a thinner one would be slivers
LEAST_NOTCH = 0.05  # of half the span, smallest depth of the notches between arms


@dataclass(frozen=True)
class Cross(Polygonal):
    """Four arms: before it is turned, one lies along x, and the diameter is the span of two of them."""

    arm_width: float

    arms: ClassVar[int] = 4
    width: ClassVar[str] = "span"

    @property
    def sharp(self) -> Polygon:
        along = 2 * np.pi * np.arange(self.arms) / self.arms
        notch = self.arm_width / np.sin(np.pi / self.arms)
        ends = np.exp(1j * along)[:, None] * [1 - 1j * self.arm_width, 1 + 1j * self.arm_width]
        inner = notch * np.exp(1j * (along + np.pi / self.arms))
        corners = np.column_stack([ends, inner]).ravel()
        return Polygon(tuple((float(corner.real), float(corner.imag)) for corner in corners))

    def check(self) -> None:
        most = (1 - LEAST_NOTCH) * np.tan(np.pi / self.arms)
        if not THINNEST <= self.arm_width <= most:
            raise problem(
                "out-of-range",
                f"{self.arm_width:.4g} of the diameter",
                f"{THINNEST:g} to {most:.3g} of the diameter for {self.arms} arms",
                "the arms are as thin as slivers, or so wide that they leave no notch between them",
                "change arm_width; for a section without notches write square or hexagon",
                at="arm_width",
            )
        super().check()

    def room(self) -> dict[str, float]:
        return super().room() | {
            "arm width": self.arm_width - THINNEST,
            "notch": (1 - LEAST_NOTCH) * np.tan(np.pi / self.arms) - self.arm_width,
        }


@dataclass(frozen=True)
class Snowflake(Cross):
    """Six arms, as in slabs of silicon with snowflake-shaped holes; otherwise like a cross."""

    arms: ClassVar[int] = 6
