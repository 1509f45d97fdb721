"""What is asked of the bands of a cell."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from haptonic.bloch.resolution import LADDER, Resolution, starting_rung
from haptonic.fields import TOP, Quantity, described

COARSEST = 0.1  # accuracy: bands that are less exact tell nothing of gaps


@described("mesh")
class MeshSettings:
    """For experts: what ``bands.accuracy`` would choose."""

    order: Annotated[int, Field(ge=2, le=10, strict=True)] | None = Field(
        default=None, title="Element order", description="Polynomial order of the elements."
    )
    foot_rings: Annotated[int, Field(ge=0, le=6, strict=True)] | None = Field(
        default=None,
        title="Rings at the foot",
        description="Refinements on either side of the pillar's foot.",
    )


@described("bands")
class BandSettings:
    """How many bands, where, and how exactly."""

    count: Annotated[int, Field(ge=1, le=60, strict=True)] = Field(
        default=10, title="Number of bands", description="Counted from the lowest."
    )
    points: Annotated[int, Field(ge=8, le=10_000, strict=True)] = Field(
        default=66, title="Wavevectors", description="Along the edge of the irreducible zone."
    )
    accuracy: Annotated[float, Quantity("", at_least=1e-6, at_most=COARSEST, typical=(1e-5, 0.05))] = Field(
        default=2e-3,
        title="Accuracy",
        description="Relative, of every frequency up to the last band asked for.",
    )
    mesh: Annotated[MeshSettings, TOP] = Field(
        default=MeshSettings(), title="Mesh", description="For experts; else the accuracy decides."
    )

    @property
    def resolution(self) -> Resolution | None:
        """What the mesh settings say, the rest of it as the accuracy has it; None where they say nothing."""
        order, rings = self.mesh.order, self.mesh.foot_rings
        if order is None and rings is None:
            return None
        rung = LADDER[starting_rung(self.accuracy)]
        return Resolution(
            rung.order if order is None else order,
            rung.foot_rings if rings is None else rings,
            rung.steps,
            rung.block,
        )
