"""The tables of the study file that hold parameters: declared once, with unit, bounds and usual range."""

from __future__ import annotations

import math
from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field, model_validator

from haptonic.cell import Pillar, Step
from haptonic.materials import INCOMPRESSIBLE, POISSON_BOUNDS, IsotropicMaterial
from haptonic.study.quantity import Quantity, problem
from haptonic.units import format_quantity

SMALLEST, LARGEST = 1e-9, 1e3  # m; below, no continuum; above, no plate that a hand could touch
STEEPEST = math.radians(40)  # draft of a pillar
USUAL_DRAFT = (0.0, math.radians(10))
FREE_SHARE = 0.02  # of the pitch, that a pillar leaves free: what the mesh between two pillars needs


def _length(lowest: float, highest: float) -> Quantity:
    """A size whose typical range is given, m."""
    return Quantity("m", at_least=SMALLEST, at_most=LARGEST, typical=(lowest, highest))


class Section(BaseModel):
    """A table of the study file: immutable, and without keys that it does not know."""

    model_config = ConfigDict(frozen=True, extra="forbid")


class MaterialSection(Section):
    """An isotropic material given by its constants."""

    name: str = Field("material", title="Name", description="Shown in reports.", min_length=1, strict=True)
    youngs_modulus: Annotated[float, Quantity("Pa", at_least=1e3, at_most=1e13, typical=(1e9, 5e11))] = Field(
        title="Young's modulus", description="Stiffness in tension."
    )
    poisson_ratio: Annotated[
        float,
        Quantity(
            "", above=POISSON_BOUNDS[0], below=POISSON_BOUNDS[1], typical=(0.1, 0.45), hint=INCOMPRESSIBLE
        ),
    ] = Field(title="Poisson ratio", description="Sideways contraction over stretch.")
    density: Annotated[float, Quantity("kg/m^3", at_least=1.0, at_most=5e4, typical=(500.0, 23e3))] = Field(
        title="Density", description="Mass per volume."
    )
    loss_factor: Annotated[float, Quantity("", at_least=0.0, below=1.0, typical=(0.0, 0.2))] = Field(
        0.0, title="Loss factor", description="Imaginary over real part of the stiffness; about 1 / Q."
    )
    source: str = Field("", title="Source", description="Where the constants come from.", strict=True)

    def frozen(self) -> IsotropicMaterial:
        """The material as the core computes with it."""
        return IsotropicMaterial(**self.model_dump())


class StepSection(Section):
    """Where the pillar becomes narrower."""

    diameter: Annotated[float, _length(50e-6, 50e-3)] = Field(
        title="Diameter above the step", description="Smaller than below it by more than 5 %."
    )
    height: Annotated[float, _length(50e-6, 100e-3)] = Field(
        title="Height of the step", description="Above the face of the plate."
    )

    def frozen(self) -> Step:
        """The step as the core computes with it."""
        return Step(self.diameter, self.height)


class PillarSection(Section):
    """The pillar on each cell."""

    diameter: Annotated[float, _length(50e-6, 50e-3)] = Field(
        title="Pillar diameter",
        description="At the foot, its fillet not counted; of a square section the side. "
        "Smaller than the pitch by more than 2 %.",
    )
    height: Annotated[float, _length(50e-6, 100e-3)] = Field(
        title="Pillar height", description="Above the face of the plate."
    )
    section: Literal["round", "square"] = Field(
        "round", title="Section", description="Seen from above; the sides of a square lie along the cell's."
    )
    draft: Annotated[float, Quantity("rad", at_least=-STEEPEST, at_most=STEEPEST, typical=USUAL_DRAFT)] = (
        Field(
            0.0, title="Draft angle", description="Between side and normal; positive is narrower at the top."
        )
    )
    fillet: Annotated[float, Quantity("m", at_least=0.0, at_most=LARGEST, typical=(0.0, 5e-3))] = Field(
        0.0, title="Fillet radius", description="At the foot: the corner radius of the end mill."
    )
    step: StepSection | None = Field(
        None, title="Step", description="Where the pillar becomes narrower, if it does."
    )

    def frozen(self) -> Pillar:
        """The pillar as the core computes with it."""
        step = self.step.frozen() if self.step else None
        return Pillar(self.diameter, self.height, self.section, self.draft, self.fillet, step)


class CellSection(Section):
    """The unit cell of the lattice."""

    lattice: Literal["square", "rectangular"] = Field(
        "square", title="Lattice", description="How the cells repeat in the plane."
    )
    pitch: Annotated[float, _length(100e-6, 100e-3)] = Field(
        title="Pitch", description="Period of the lattice; along x for a rectangular one."
    )
    pitch_y: Annotated[float, _length(100e-6, 100e-3)] | None = Field(
        None, title="Pitch along y", description="Of a rectangular lattice only."
    )
    thickness: Annotated[float, _length(20e-6, 20e-3)] = Field(
        title="Plate thickness", description="Without the pillar."
    )
    pillar: PillarSection | None = Field(
        None, title="Pillar", description="Without this table the cell is a piece of plain plate."
    )

    @model_validator(mode="after")
    def _fits(self) -> CellSection:
        if (self.lattice == "rectangular") != (self.pitch_y is not None):
            missing = self.pitch_y is None
            raise problem(
                "nothing" if missing else format_quantity(self.pitch_y or 0.0, "m"),
                "pitch_y for a rectangular lattice, and for no other",
                "the second period was left out"
                if missing
                else f"a {self.lattice} lattice has one period only",
                'add pitch_y = "7 mm"' if missing else 'remove pitch_y, or write lattice = "rectangular"',
                at="pitch_y",
            )
        room = min(self.pitch, self.pitch_y or self.pitch) - FREE_SHARE * self.pitch
        if self.pillar and self.pillar.diameter >= room:
            widest = format_quantity(room, "m")
            raise problem(
                format_quantity(self.pillar.diameter, "m"),
                f"less than {widest}, so that 2 % of the pitch stays free",
                "the pillar is wider than the cell, or nearly so",
                "choose a thinner pillar or a larger pitch",
                at="pillar.diameter",
            )
        return self


class BandsSection(Section):
    """What is asked of the band diagram."""

    count: Annotated[int, Field(ge=1, le=60, strict=True)] = Field(
        10, title="Number of bands", description="Counted from the lowest."
    )
    points: Annotated[int, Field(ge=8, le=10_000, strict=True)] = Field(
        66, title="Wavevectors", description="Along the edge of the irreducible zone."
    )
    accuracy: Annotated[float, Quantity("", at_least=1e-6, at_most=0.1, typical=(1e-5, 0.05))] = Field(
        2e-3, title="Accuracy", description="Relative, of every frequency up to the last band asked for."
    )


class MeshSection(Section):
    """For experts: what ``bands.accuracy`` would choose."""

    order: Annotated[int, Field(ge=2, le=10, strict=True)] | None = Field(
        None, title="Element order", description="Polynomial order of the elements."
    )
    foot_rings: Annotated[int, Field(ge=0, le=6, strict=True)] | None = Field(
        None, title="Rings at the foot", description="Refinements on either side of the pillar's foot."
    )
