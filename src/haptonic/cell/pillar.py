"""Pillar: a family of bodies that an end mill can produce on a plate."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cached_property
from typing import Annotated, ClassVar, Literal

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.cell.outlines import SECTIONS, Scaled, taken_by
from haptonic.cell.outlines.outline import SAME
from haptonic.cell.pillar_parts import Corner, Fillet, Step
from haptonic.cell.quadrature import lobatto
from haptonic.cell.sectioned import (
    CORNER_RADIUS,
    CORNERS,
    LENGTH,
    SECTION,
    SIDES,
    TURN,
    CornerRadius,
    GivenSection,
    Sectioned,
    SectionLength,
    SectionSides,
    SectionTurn,
)
from haptonic.errors import GeometryError
from haptonic.fields import (
    LARGEST,
    Aliases,
    Quantity,
    absent,
    described,
    meant,
    needed,
    problem,
    setting,
    size,
)
from haptonic.materials import GIVEN, Material
from haptonic.units import format_quantity

Faces = Literal["one", "both"]

LEAST_SHARE = 0.05  # smallest width of a section, relative to the width at the foot
STEEPEST = math.radians(40)  # draft
ALONG_STAGE = 12  # order of the points along a stage: exact for straight sides, and curves of degree 11
USUAL_DRAFT = (0.0, math.radians(10))


@described("cell.pillar", GeometryError)
class Pillar(Sectioned):
    """Pillar at the centre of the cell. All lengths in m, angles in rad.

    Raises
    ------
    GeometryError : sizes that do not form a body
    """

    noun: ClassVar[str] = "pillar"
    table: ClassVar[str] = "pillar"
    aliases: ClassVar[Aliases] = {
        **meant(
            "diameter", "radius", "r",
            cause="a pillar is given by its diameter, which is twice its radius",
            next_step='write "diameter", with twice the value',
        ),
        **meant("diameter", "d", "width", "side", "w", "diameter_bottom"),
        **meant("height", "h", "pillar_height"),
        **meant("section", "shape", "outline", "form", "cross_section"),
        **meant("draft", "taper", "taper_angle", "draft_angle"),
        **absent(
            "density", "youngs_modulus", "poisson_ratio",
            cause="a pillar has a material, and the material has these constants",
            next_step="write them into a [cell.pillar.material] table, or give material a built-in name",
        ),
        **absent(
            "chamfer", "bevel",
            cause="a pillar has no such number; a chamfer is a short disc with a draft",
            next_step="give shaft and chamfer as two [[cell.disc]] tables in place of the pillar",
        ),
        **absent(
            "coating",
            cause="a pillar consists of one material; coated ones are stacks of discs",
            next_step="give core and coating as [[cell.disc]] tables in place of the pillar",
        ),
        **absent(
            "glue", "bond", "adhesive", "glue_thickness", "bond_thickness",
            cause="a pillar is one piece with the plate; pillars on glue are stacks of discs",
            next_step="give the glue and the pillar as two [[cell.disc]] tables in place of the pillar",
        ),
        **absent(
            "hole", "bore", "inner_diameter", "hollow",
            cause="pillars are solid; hollow ones are stacks of discs",
            next_step="give them as two [[cell.disc]] tables, the second with empty = true",
        ),
    }  # fmt: skip

    diameter: Annotated[float, size(20e-9, 50e-3)] = needed(
        "Diameter at the foot without the fillet; width along x of other sections, across flats of a hexagon "
        "or polygon. Smaller than the pitch by more than 2 %.",
        title="Pillar diameter",
        examples=["3.5 mm"],
    )
    height: Annotated[float, size(10e-9, 100e-3)] = needed(
        "Height above the face of the plate.", title="Pillar height", examples=["14.7 mm"]
    )
    section: GivenSection = SECTION
    draft: Annotated[float, Quantity("rad", at_least=-STEEPEST, at_most=STEEPEST, typical=USUAL_DRAFT)] = (
        setting(0.0, "Angle between side and normal; positive is narrower at the top.", title="Draft angle")
    )
    fillet: Annotated[float, Quantity("m", at_least=0.0, at_most=LARGEST, typical=(0.0, 5e-3))] = setting(
        0.0,
        "Radius at the foot, the corner radius of the end mill; mitred at the corners of a square.",
        title="Fillet radius",
    )
    step: Step | None = setting(None, "Step above which the pillar is narrower; by default none.")
    length: SectionLength = LENGTH
    sides: SectionSides = SIDES
    corner_radius: CornerRadius = CORNER_RADIUS
    turn: SectionTurn = TURN
    point: tuple[Corner, ...] = CORNERS
    material: Annotated[Material, GIVEN] | None = setting(
        None,
        "A built-in name or its constants; without it the pillar is of the plate's material.",
        title="Pillar material",
    )

    def __post_init__(self) -> None:
        has_arms = "arm_width" in taken_by(SECTIONS[self.section])
        if not has_arms:
            self.check_section()
        if has_arms or not self.outline.is_convex:
            raise problem(
                "unsupported",
                f"a pillar whose section is {self.section} and bends inwards",
                "a convex section; discs may have others",
                "the mesh of a pillar is not refined towards upright edges",
                "give it as a [[cell.disc]] with the same numbers, and its height as high",
                at="section",
            )
        self.check_sides("draft", "fillet")
        if self.material is not None and self.fillet:
            # No mesh is graded towards the fillet's rim, where the materials meet: errors of steel on
            # aluminium were up to six times the estimate.
            raise problem(
                "conflict",
                f"a fillet of {format_quantity(self.fillet, 'm')} on a pillar of {self.material.name}",
                "a fillet on a pillar of the plate's material, or a pillar of another one without",
                "a fillet is cut from the block that both are milled from",
                "leave out the fillet, or the pillar's material",
                at="fillet",
            )
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
            below = 2 * self.half_width(self.step.height, 0) / self._least
            if not self.step.diameter < (1 - LEAST_SHARE) * below:
                most, wide = (format_quantity(width, "m") for width in ((1 - LEAST_SHARE) * below, below))
                raise problem(
                    "out-of-range",
                    format_quantity(self.step.diameter, "m"),
                    f"less than {most}: the part below it is {wide} wide",
                    "the pillar would be no narrower above the step, which a tool from above cannot cut",
                    "choose a thinner upper part, or leave the step out",
                    at="step.diameter",
                )
        if self.arc is not None:
            ends, room = float(self.arc.at(1.0)[1]), 0.8 * (self.step.height if self.step else self.height)
            if ends > room:
                raise problem(
                    "out-of-range",
                    format_quantity(self.fillet, "m"),
                    f"at most {format_quantity(room * self.fillet / ends, 'm')}",
                    "the arc would reach the end of the pillar's lower part",
                    "choose a smaller radius",
                    at="fillet",
                )

    def _check_step(self, step: Step) -> None:
        """Refuse a step above the top, or one that leaves almost nothing above it."""
        if not step.height < self.height:
            raise problem(
                "out-of-range",
                format_quantity(step.height, "m"),
                f"less than the pillar's height, {format_quantity(self.height, 'm')}",
                "the step lies above the pillar's top",
                "lower the step, or leave it out",
                at="step.height",
            )
        if step.diameter < LEAST_SHARE * self.diameter:
            raise problem(
                "out-of-range",
                format_quantity(step.diameter, "m"),
                f"at least {format_quantity(LEAST_SHARE * self.diameter, 'm')}",
                "almost nothing of the pillar would be left above the step",
                "choose a thicker upper part",
                at="step.diameter",
            )

    @property
    def stages(self) -> tuple[tuple[float, float, float], ...]:
        """(low, high, half-width at its lower end) of each smooth piece of the side, m above the plate."""
        if self.step is None:
            return ((0.0, self.height, self.radius),)
        middle = self.step.height
        return ((0.0, middle, self.radius), (middle, self.height, 0.5 * self.step.diameter * self._least))

    def half_width(self, height: float, stage: int) -> float:
        """Smallest half-width of a stage, its side continued straight, at a height above the plate, m."""
        low, _, width = self.stages[stage]
        return width - (height - low) * math.tan(self.draft)

    def has_symmetry(self, turn: NDArray[np.float64]) -> bool:
        """True if an orthogonal map (3, 3) of space that keeps the normal leaves the pillar unchanged."""
        return self.keeps_material(turn) and self.outline.has_symmetry(turn[:2, :2])

    def is_image(self, other: object, turn: NDArray[np.float64]) -> bool:
        """True if an orthogonal map (3, 3) that keeps the normal maps the pillar to another one."""
        if not isinstance(other, Pillar):
            return False
        if len(self.stages) != len(other.stages) or self.material != other.material:
            return False
        own_sizes, other_sizes = (np.array([*np.ravel(p.stages), p.draft, p.fillet]) for p in (self, other))
        alike = self == other or bool((np.abs(own_sizes - other_sizes) <= SAME * np.abs(own_sizes)).all())
        return alike and self.keeps_material(turn) and self.outline.image(turn[:2, :2]).is_same(other.outline)

    @cached_property
    def _outline(self) -> Array:
        """(stage, point) half-widths along the height of every stage, m; the properties below use only these.

        The points are Gauss-Lobatto points: they include the ends of the stages, and bulges and waists
        between.
        """
        share = 0.5 * (1 + lobatto(ALONG_STAGE)[0])
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
        """Largest half-width, without the fillet, m."""
        return float(self._outline.max())

    @property
    def widest(self) -> float:
        """Largest half-width, including the fillet, m."""
        return max(self.broadest, self.arc.centre[0] if self.arc else 0.0)

    @property
    def solids(self) -> tuple[Material, ...]:
        """The pillar's own material, if it has one."""
        return (self.material,) if self.material is not None else ()

    @property
    def borders(self) -> tuple[Scaled]:
        """The section at its widest place."""
        return (Scaled(self.outline, self.widest),)

    @property
    def is_prism(self) -> bool:
        """True if all sections above the foot and its fillet are equal."""
        return self.narrowest == self.broadest

    @property
    def is_cylinder(self) -> bool:
        """True for a plain round pillar of any material."""
        return self == Pillar(self.diameter, self.height, material=self.material)

    @cached_property
    def arc(self) -> Fillet | None:
        """The fillet, or None."""
        if not self.fillet:
            return None
        cosine, slope = math.cos(self.draft), math.tan(self.draft)
        reach = self.radius + self.fillet * (1 / cosine - slope)
        return Fillet(self.fillet, (reach, self.fillet), 0.5 * math.pi - self.draft)

    @property
    def volume(self) -> float:
        """Volume including the fillet, m^3."""
        lengths = np.array([high - low for low, high, _ in self.stages])
        squares = 0.5 * lengths @ (self._outline**2 @ lobatto(ALONG_STAGE)[1])
        return self.outline.area * (float(squares) + self._fillet_squares())

    def _fillet_squares(self) -> float:
        """Integral over height of the increase of the squared half-width by the fillet, m^3."""
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
        """A copy with every length multiplied by ``factor``."""
        step = self.step and Step(self.step.diameter * factor, self.step.height * factor)
        return replace(
            self,
            diameter=self.diameter * factor,
            height=self.height * factor,
            fillet=self.fillet * factor,
            step=step,
            **self.scaled_numbers(factor),
        )

    @property
    def above_step(self) -> Pillar:
        """The part above the step, as a pillar with upright sides."""
        assert self.step is not None
        share = self.step.diameter / self.diameter
        return replace(
            self,
            diameter=self.step.diameter,
            height=self.height - self.step.height,
            draft=0.0,
            fillet=0.0,
            step=None,
            **self.scaled_numbers(share),
        )

    def _steepest(self) -> float:
        """Largest inward slope of the sides that leaves something of each part, and a ledge at the step."""
        least = LEAST_SHARE * self.radius
        slopes = [(width - least) / (high - low) for low, high, width in self.stages]
        if self.step is not None:
            slopes.append((self.radius - self.stages[1][2] / (1 - LEAST_SHARE)) / self.step.height)
        return min(slopes)
