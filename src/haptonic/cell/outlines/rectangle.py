"""Square and rectangular sections."""

from __future__ import annotations

from dataclasses import dataclass

from haptonic.cell.outlines.polygon import Polygon
from haptonic.cell.outlines.section import Polygonal


@dataclass(frozen=True)
class Rectangular(Polygonal):
    """A rectangle: before it is turned, the diameter is its side along x, the length that along y."""

    length: float

    @property
    def sharp(self) -> Polygon:
        y = self.length
        return Polygon(((1.0, -y), (1.0, y), (-1.0, y), (-1.0, -y)))

    def shear_coefficient(self, poisson_ratio: float) -> float | None:
        return None if self.corner_radius else 10 * (1 + poisson_ratio) / (12 + 11 * poisson_ratio)


@dataclass(frozen=True)
class Square(Polygonal):
    """A square with the diameter as its side."""

    sign = "□"

    @property
    def sharp(self) -> Polygon:
        return Rectangular(1.0).sharp

    def shear_coefficient(self, poisson_ratio: float) -> float | None:
        return Rectangular(1.0, corner_radius=self.corner_radius).shear_coefficient(poisson_ratio)
