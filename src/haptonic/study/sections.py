"""The tables of the study file that hold parameters: declared once, with unit, bounds and usual range."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from haptonic.cell import Pillar
from haptonic.fields import Quantity, Section, problem, size
from haptonic.units import format_quantity


class CellSection(Section):
    """The unit cell of the lattice."""

    lattice: Literal["square", "rectangular"] = Field(
        "square", title="Lattice", description="How the cells repeat in the plane."
    )
    pitch: Annotated[float, size(100e-6, 100e-3)] = Field(
        title="Pitch", description="Period of the lattice; along x for a rectangular one."
    )
    pitch_y: Annotated[float, size(100e-6, 100e-3)] | None = Field(
        None, title="Pitch along y", description="Of a rectangular lattice only."
    )
    thickness: Annotated[float, size(20e-6, 20e-3)] = Field(
        title="Plate thickness", description="Without the pillar."
    )
    pillar: Pillar | None = Field(
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
