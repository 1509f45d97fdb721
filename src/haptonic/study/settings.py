"""The tables of the study file about a mirror and a waveguide."""

from __future__ import annotations

import math
from typing import Annotated, Literal

from pydantic import Field

from haptonic.fields import Frequency, Length, Quantity, ascending, described

CARRIER = Quantity("Hz", at_least=1.0, at_most=1e9, typical=(10e3, 1e6))


@described("layers", kw_only=True)
class LayersSettings:
    """What is asked of a mirror of several rows of cells between two plates."""

    count: Annotated[int, Field(ge=1, le=20, strict=True)] = Field(
        default=6, title="Rows", description="The most that are computed; all fewer ones are as well."
    )
    lowest: Frequency | None = Field(
        default=None, title="Lowest frequency", description="Of the spectrum; else 0.6 of the carrier."
    )
    highest: Frequency | None = Field(
        default=None, title="Highest frequency", description="Of the spectrum; else 1.4 of the carrier."
    )
    points: Annotated[int, Field(ge=2, le=5000, strict=True)] = Field(
        default=161, title="Frequencies", description="In the spectrum, both ends included."
    )
    angle: Annotated[float, Quantity("rad", at_least=0.0, below=0.5 * math.pi, typical=(0.0, 1.5))] = Field(
        default=0.0,
        title="Angle of incidence",
        description="Between the incident wave and the normal of the rows.",
    )

    def __post_init__(self) -> None:
        ascending(self.lowest, self.highest, "spectrum")


@described("waveguide", kw_only=True)
class WaveguideSettings:
    """A strip of plain plate between two mirrors."""

    mode: str = Field(
        default="0x17",
        title="Mode",
        description="Nodal lines across the strip, and intervals between nodal lines along it.",
        pattern=r"^[0-9]{1,2}x[0-9]{1,3}$",
    )
    width: Length | None = Field(
        default=None,
        title="Width",
        description="Of the plain strip; else the one that puts the mode at the carrier.",
    )
    rows: Annotated[int, Field(ge=1, le=1000, strict=True)] | None = Field(
        default=None, title="Length in cells", description="Of the strip; else several are compared."
    )
    ends: Literal["free", "mirror"] = Field(
        default="free",
        title="Ends",
        description="Of the strip: edges of the plate, or closed by the mirror as well.",
    )

    @property
    def nodal_lines(self) -> tuple[int, int]:
        """Nodal lines across, and intervals along."""
        across, along = self.mode.split("x")
        return int(across), int(along)
