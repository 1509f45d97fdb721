"""The pillar: a family of bodies that an end mill can leave standing on a plate."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.cell.quadrature import lobatto
from haptonic.errors import GeometryError
from haptonic.fields import LARGEST, Quantity, described, needed, problem, setting, size
from haptonic.materials import GIVEN, Material, is_symmetry

Section = Literal["round", "square"]
Faces = Literal["one", "both"]

LEAST_SHARE = 0.05  # of the width at the foot that the narrowest section keeps
STEEPEST = math.radians(40)  # draft
OUTLINE = 12  # order of the points along a stage: exact for sides of straight lines, and curves of degree 11
USUAL_DRAFT = (0.0, math.radians(10))


@described("cell.pillar.step", GeometryError)
class Step:
    """Where a pillar becomes narrower, m."""

    diameter: Annotated[float, size(50e-6, 50e-3)] = needed(
        "Smaller than below it by more than 5 %.", title="Diameter above the step"
    )
    height: Annotated[float, size(50e-6, 100e-3)] = needed(
        "Above the face of the plate.", title="Height of the step"
    )


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


@described("cell.pillar", GeometryError)
class Pillar:
    """Pillar centred on the cell. All lengths in m, angles in rad.

    Raises
    ------
    GeometryError : sizes that do not make a body
    """

    diameter: Annotated[float, size(50e-6, 50e-3)] = needed(
        "At the foot, its fillet not counted; of a square section the side. "
        "Smaller than the pitch by more than 2 %.",
        title="Pillar diameter",
        examples=["3.5 mm"],
    )
    height: Annotated[float, size(50e-6, 100e-3)] = needed(
        "Above the face of the plate.", title="Pillar height", examples=["14.7 mm"]
    )
    section: Section = setting("round", "Seen from above; the sides of a square lie along the cell's.")
    draft: Annotated[float, Quantity("rad", at_least=-STEEPEST, at_most=STEEPEST, typical=USUAL_DRAFT)] = (
        setting(0.0, "Between side and normal; positive is narrower at the top.", title="Draft angle")
    )
    fillet: Annotated[float, Quantity("m", at_least=0.0, at_most=LARGEST, typical=(0.0, 5e-3))] = setting(
        0.0,
        "At the foot: the corner radius of the end mill; mitred at the corners of a square.",
        title="Fillet radius",
    )
    step: Step | None = setting(None, "Where the pillar becomes narrower, if it does.")
    material: Annotated[Material, GIVEN] | None = setting(
        None,
        "A built-in name or its constants; without it the pillar is of the plate's material.",
        title="Pillar material",
    )

    def __post_init__(self) -> None:
        if self.step is not None:
            self._check_step(self.step)
        if self.narrowest < LEAST_SHARE * self.radius:
            raise problem(
                "out-of-range",
                f"{math.degrees(self.draft):g} deg",
                f"at most {math.degrees(math.atan(self._steepest())):.3g} degrees for these sizes",
                "the sides would meet below the pillar's top",
                "choose a smaller angle, or a lower pillar",
                at="draft",
            )
        if self.step is not None:
            below = 2 * self.half_width(self.step.height, 0)
            if not self.step.diameter < (1 - LEAST_SHARE) * below:
                raise problem(
                    "out-of-range",
                    _mm(self.step.diameter),
                    f"less than {_mm((1 - LEAST_SHARE) * below)}: the part below it is {_mm(below)} wide",
                    "the pillar would be no narrower above the step, which a tool from above cannot cut",
                    "choose a thinner upper part, or leave the step out",
                    at="step.diameter",
                )
        if self.arc is not None:
            ends, room = float(self.arc.at(1.0)[1]), 0.8 * (self.step.height if self.step else self.height)
            if ends > room:
                raise problem(
                    "out-of-range",
                    _mm(self.fillet),
                    f"at most {_mm(room * self.fillet / ends)}",
                    "the arc would reach the end of the pillar's lower part",
                    "choose a smaller radius",
                    at="fillet",
                )

    def _check_step(self, step: Step) -> None:
        """Refuse a step above the top, or one that leaves next to nothing above it."""
        if not step.height < self.height:
            raise problem(
                "out-of-range",
                _mm(step.height),
                f"less than the pillar's height, {_mm(self.height)}",
                "the step lies above the pillar's top",
                "lower the step, or leave it out",
                at="step.height",
            )
        if step.diameter < LEAST_SHARE * self.diameter:
            raise problem(
                "out-of-range",
                _mm(step.diameter),
                f"at least {_mm(LEAST_SHARE * self.diameter)}",
                "above the step next to nothing would be left of the pillar",
                "choose a thicker upper part",
                at="step.diameter",
            )

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

    def has_symmetry(self, turn: NDArray[np.float64]) -> bool:
        """True if an orthogonal map (3, 3) of space that keeps the normal leaves the pillar as it is.

        A pillar of the plate's material has that material's symmetry as well, which the tile checks.
        """
        if self.material is not None and not is_symmetry(self.material.stiffness, turn):
            return False
        return self.section == "round" or not turn[0, 0] * turn[0, 1]

    @cached_property
    def _outline(self) -> Array:
        """(stage, point) half-widths along the height of every stage, m; what follows reads this only.

        At Gauss-Lobatto points: the ends of the stages are among them, and so are bulges and waists between.
        """
        share = 0.5 * (1 + lobatto(OUTLINE)[0])
        return np.array(
            [
                [self.half_width(z, stage) for z in low + (high - low) * share]
                for stage, (low, high, _) in enumerate(self.stages)
            ]
        )

    @property
    def narrowest(self) -> float:
        """Smallest half-width, m."""
        return float(self._outline.min())

    @property
    def broadest(self) -> float:
        """Largest half-width, the fillet not counted, m."""
        return float(self._outline.max())

    @property
    def widest(self) -> float:
        """Largest half-width, the fillet counted, m."""
        return max(self.broadest, self.arc.centre[0] if self.arc else 0.0)

    def gap_to(self, other: Pillar, away: Array) -> float:
        """Width of the narrowest way between this pillar and others, all alike, m.

        Their axes are ``away`` (n, 2) from its own. Fillets are not counted. Negative where two overlap.
        """
        # what touches is a point and a circle about a square, of which either may be but a point, too
        widths = {"square": 0.0, "round": 0.0}
        for one in (self, other):
            widths[one.section] += one.broadest
        beside = np.abs(away) - widths["square"]
        apart = np.linalg.norm(np.maximum(beside, 0.0), axis=1) + np.minimum(beside.max(axis=1), 0.0)
        return float(apart.min() - widths["round"])

    @property
    def is_prism(self) -> bool:
        """Whether all sections above the foot, and its fillet, are one and the same."""
        return self.narrowest == self.broadest

    @property
    def is_cylinder(self) -> bool:
        """True if the pillar is a plain round one, of whatever material."""
        return self == Pillar(self.diameter, self.height, material=self.material)

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
        lengths = np.array([high - low for low, high, _ in self.stages])
        squares = 0.5 * lengths @ (self._outline**2 @ lobatto(OUTLINE)[1])
        return (math.pi if self.section == "round" else 4.0) * (float(squares) + self._fillet_squares())

    def _fillet_squares(self) -> float:
        """Integral over height of what the fillet adds to the square of the half-width, m^3."""
        if self.arc is None:
            return 0.0
        points, weights = np.polynomial.legendre.leggauss(40)
        share = 0.5 * (1 + points)
        width, height = self.arc.at(share).T
        # along the arc dz = r sin(angle) d(angle)
        dz = self.arc.radius * np.sin(self.arc.opening * share) * 0.5 * self.arc.opening * weights
        side = np.array([self.half_width(z, 0) for z in height])
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


def _mm(length: float) -> str:
    return f"{length * 1e3:.4g} mm"
