"""Parts of a pillar: the corners of its section, its step, the fillet at its foot."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from haptonic.arrays import Array
from haptonic.errors import GeometryError
from haptonic.fields import Quantity, described, needed, size


@described("cell.pillar.point", GeometryError)
class Corner:
    """A corner of a pillar's section, in half diameters from the pillar's axis."""

    x: Annotated[float, Quantity("", at_least=-100.0, at_most=100.0)] = needed(
        "Position in half diameters from the axis.", title="Corner along x", examples=["1"]
    )
    y: Annotated[float, Quantity("", at_least=-100.0, at_most=100.0)] = needed(
        "Position in half diameters from the axis.", title="Corner along y", examples=["0.5"]
    )


@described("cell.pillar.step", GeometryError)
class Step:
    """Step at which a pillar becomes narrower, m. The section above is a scaled copy of that below."""

    diameter: Annotated[float, size(20e-9, 50e-3)] = needed(
        "Diameter that is smaller than below the step by more than 5 %.",
        title="Diameter above the step",
        examples=["2.5 mm"],
    )
    height: Annotated[float, size(10e-9, 100e-3)] = needed(
        "Height above the face of the plate.", title="Height of the step", examples=["10 mm"]
    )


@dataclass(frozen=True)
class Fillet:
    """Arc between the plate's top and the pillar's side, in (half-width, height above the plate), m.

    It touches both. Angles are measured from the direction to the plate, up to ``opening``.
    """

    radius: float
    centre: tuple[float, float]
    opening: float

    def at(self, share: Array | float) -> Array:
        """(..., 2) points of the arc, from the plate (share 0) to the pillar (share 1)."""
        angle = self.opening * np.asarray(share, dtype=float)
        away = np.stack([-np.sin(angle), -np.cos(angle)], axis=-1)
        return np.asarray(self.centre + self.radius * away)
