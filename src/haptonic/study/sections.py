"""The tables of the study file that hold parameters: declared once, with unit, bounds and usual range."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from haptonic.fields import Quantity, described

CARRIER = Quantity("Hz", at_least=1.0, at_most=1e9, typical=(10e3, 1e6))


@described("bands", kw_only=True)
class BandsSection:
    """What is asked of the band diagram."""

    count: Annotated[int, Field(ge=1, le=60, strict=True)] = Field(
        default=10, title="Number of bands", description="Counted from the lowest."
    )
    points: Annotated[int, Field(ge=8, le=10_000, strict=True)] = Field(
        default=66, title="Wavevectors", description="Along the edge of the irreducible zone."
    )
    accuracy: Annotated[float, Quantity("", at_least=1e-6, at_most=0.1, typical=(1e-5, 0.05))] = Field(
        default=2e-3,
        title="Accuracy",
        description="Relative, of every frequency up to the last band asked for.",
    )


@described("mesh", kw_only=True)
class MeshSection:
    """For experts: what ``bands.accuracy`` would choose."""

    order: Annotated[int, Field(ge=2, le=10, strict=True)] | None = Field(
        default=None, title="Element order", description="Polynomial order of the elements."
    )
    foot_rings: Annotated[int, Field(ge=0, le=6, strict=True)] | None = Field(
        default=None,
        title="Rings at the foot",
        description="Refinements on either side of the pillar's foot.",
    )
