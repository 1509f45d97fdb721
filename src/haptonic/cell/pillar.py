"""The pillar: a family of bodies that an end mill can leave standing on a plate."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from haptonic.errors import GeometryError

Array = NDArray[np.float64]
Section = Literal["round", "square"]

SECTIONS: tuple[Section, ...] = ("round", "square")
LEAST_SHARE = 0.05  # of the width at the foot that the narrowest section keeps


@dataclass(frozen=True)
class Step:
    """Where a pillar becomes narrower: ``height`` above the plate's top, ``diameter`` from there on, m."""

    diameter: float
    height: float


@dataclass(frozen=True)
class Fillet:
    """The arc between the plate's top and the pillar's side, in (half-width, height above the plate), m.

    It touches both. Angles count from the direction to the plate, up to ``opening``.
    """

    radius: float
    centre: tuple[float, float]
    opening: float

    def at(self, share: Array | float) -> Array:
        """(..., 2) points of the arc, from the plate (share 0) to the pillar (share 1)."""
        angle = self.opening * np.asarray(share, dtype=float)
        away = np.stack([-np.sin(angle), -np.cos(angle)], axis=-1)
        return np.asarray(self.centre + self.radius * away)


@dataclass(frozen=True)
class Pillar:
    """Pillar centred on the cell. All lengths in m, angles in rad.

    diameter : at the foot, the fillet not counted; of a square section its side
    height : above the plate's top
    section : "round", or "square" with sides along the cell's
    draft : angle between side and normal; a positive one makes the pillar narrower towards its top
    fillet : radius of the arc at the foot, 0 for a sharp edge; a square section has it mitred at the corners
    step : where the pillar becomes narrower at once, if it does

    Raises
    ------
    GeometryError : sizes that do not make a body
    """

    diameter: float
    height: float
    section: Section = "round"
    draft: float = 0.0
    fillet: float = 0.0
    step: Step | None = None

    def __post_init__(self) -> None:
        for problem in self._problems():
            raise problem

    @property
    def radius(self) -> float:
        """Half the width at the foot, the fillet not counted, m."""
        return 0.5 * self.diameter

    @property
    def stages(self) -> tuple[tuple[float, float, float], ...]:
        """(low, high, half-width at its lower end) of each smooth piece of the side, m above the plate."""
        if self.step is None:
            return ((0.0, self.height, self.radius),)
        middle = self.step.height
        return ((0.0, middle, self.radius), (middle, self.height, 0.5 * self.step.diameter))

    def half_width(self, height: float, stage: int) -> float:
        """Half the width of a stage's side, continued as a straight line, at a height above the plate, m."""
        low, _, width = self.stages[stage]
        return width - (height - low) * math.tan(self.draft)

    @property
    def narrowest(self) -> float:
        """Smallest half-width, m."""
        ends = [self.half_width(z, k) for k, (low, high, _) in enumerate(self.stages) for z in (low, high)]
        return min(ends)

    @property
    def widest(self) -> float:
        """Largest half-width, the fillet counted, m."""
        ends = [self.half_width(z, k) for k, (low, high, _) in enumerate(self.stages) for z in (low, high)]
        return max(*ends, self.arc.centre[0] if self.arc else 0.0)

    @property
    def is_cylinder(self) -> bool:
        """Whether the pillar is a plain round one."""
        return self == Pillar(self.diameter, self.height)

    @cached_property
    def arc(self) -> Fillet | None:
        """The fillet, if there is one."""
        if not self.fillet:
            return None
        cosine, slope = math.cos(self.draft), math.tan(self.draft)
        reach = self.radius + self.fillet * (1 / cosine - slope)
        return Fillet(self.fillet, (reach, self.fillet), 0.5 * math.pi - self.draft)

    @property
    def volume(self) -> float:
        """m^3, the fillet counted."""
        share = math.pi if self.section == "round" else 4.0
        total = 0.0
        for stage, (low, high, _) in enumerate(self.stages):
            a, b = self.half_width(low, stage), self.half_width(high, stage)
            total += share * (high - low) * (a * a + a * b + b * b) / 3
        return total + share * self._fillet_squares()

    def _fillet_squares(self) -> float:
        """Integral over height of what the fillet adds to the square of the half-width, m^3."""
        if self.arc is None:
            return 0.0
        points, weights = np.polynomial.legendre.leggauss(40)
        share = 0.5 * (1 + points)
        width, height = self.arc.at(share).T
        # along the arc dz = r sin(angle) d(angle)
        dz = self.arc.radius * np.sin(self.arc.opening * share) * 0.5 * self.arc.opening * weights
        side = self.radius - height * math.tan(self.draft)
        return float(((width**2 - side**2) * dz).sum())

    def scaled(self, factor: float) -> Pillar:
        """The same pillar with every length multiplied by ``factor``."""
        step = self.step and Step(self.step.diameter * factor, self.step.height * factor)
        return replace(
            self,
            diameter=self.diameter * factor,
            height=self.height * factor,
            fillet=self.fillet * factor,
            step=step,
        )

    def _steepest(self) -> float:
        """Largest slope of the sides, inwards, that leaves something of each part, and a step at the step."""
        least = LEAST_SHARE * self.radius
        slopes = [(width - least) / (high - low) for low, high, width in self.stages]
        if self.step is not None:
            slopes.append((self.radius - 0.5 * self.step.diameter / (1 - LEAST_SHARE)) / self.step.height)
        return min(slopes)

    def _problems(self) -> Iterator[GeometryError]:
        sizes = {"diameter": self.diameter, "height": self.height}
        if self.step is not None:
            sizes |= {"step.diameter": self.step.diameter, "step.height": self.step.height}
        yield from (_size_error(name, value) for name, value in sizes.items() if not _is_size(value))
        if self.section not in SECTIONS:
            yield _error(
                "section", self.section, 'one of "round" and "square"', "the name is misspelt",
                "choose one of the two",
            )  # fmt: skip
        if not math.isfinite(self.draft) or abs(self.draft) > math.radians(45):
            yield _error(
                "draft", f"{math.degrees(self.draft):g} deg", "between -45 and 45 degrees",
                "the angle is counted from the plate, or has the wrong unit",
                "give the angle between the pillar's side and the normal of the plate",
            )  # fmt: skip
        if not (math.isfinite(self.fillet) and self.fillet >= 0):
            yield _error(
                "fillet", f"{self.fillet} m", "a radius, or 0 for a sharp edge", "it has the wrong sign",
                "give a positive radius",
            )  # fmt: skip
        if self.step is not None and not self.step.height < self.height:
            yield _error(
                "step.height", _mm(self.step.height), f"less than the pillar's height, {_mm(self.height)}",
                "the step lies above the pillar's top", "lower the step, or leave it out",
            )  # fmt: skip
        if self.step is not None and 0.5 * self.step.diameter < LEAST_SHARE * self.radius:
            yield _error(
                "step.diameter", _mm(self.step.diameter), f"at least {_mm(LEAST_SHARE * self.diameter)}",
                "above the step next to nothing would be left of the pillar", "choose a thicker upper part",
            )  # fmt: skip
        if self.narrowest < LEAST_SHARE * self.radius:
            yield _error(
                "draft", f"{math.degrees(self.draft):g} deg",
                f"at most {math.degrees(math.atan(self._steepest())):.3g} degrees for these sizes",
                "the sides would meet below the pillar's top", "choose a smaller angle, or a lower pillar",
            )  # fmt: skip
        if self.step is not None and not 0.5 * self.step.diameter < (1 - LEAST_SHARE) * self.half_width(
            self.step.height, 0
        ):
            below = 2 * self.half_width(self.step.height, 0)
            yield _error(
                "step.diameter", _mm(self.step.diameter),
                f"less than {_mm((1 - LEAST_SHARE) * below)}: the pillar is {_mm(below)} wide below the step",
                "the pillar would be no narrower above the step, which a tool from above cannot cut",
                "choose a thinner upper part, or leave the step out",
            )  # fmt: skip
        if self.arc is not None:
            ends = float(self.arc.at(1.0)[1])
            room = self.step.height if self.step else self.height
            if ends > 0.8 * room:
                yield _error(
                    "fillet", _mm(self.fillet), f"at most {_mm(0.8 * room * self.fillet / ends)}",
                    "the arc would reach the end of the pillar's lower part",
                    "choose a smaller radius",
                )  # fmt: skip


def _is_size(value: float) -> bool:
    return math.isfinite(value) and value > 0


def _size_error(name: str, value: float) -> GeometryError:
    return _error(
        name, f"{value} m", "a positive length", "a size was left at zero or has the wrong sign",
        "give a positive length",
    )  # fmt: skip


def _error(name: str, given: str, allowed: str, cause: str, next_step: str) -> GeometryError:
    return GeometryError(
        argument=f"cell.pillar.{name}", given=given, allowed=allowed, cause=cause, next_step=next_step
    )


def _mm(length: float) -> str:
    return f"{length * 1e3:.4g} mm"
