"""Regular polygons."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from haptonic.cell.outlines.polygon import Polygon
from haptonic.cell.outlines.section import Polygonal


@dataclass(frozen=True)
class RegularPolygon(Polygonal):
    """A regular polygon about a circle of the pillar's diameter; before it is turned, a side faces x."""

    sides: int

    @property
    def sharp(self) -> Polygon:
        angle = np.pi * (2 * np.arange(self.sides) - 1) / self.sides
        corner = np.stack([np.cos(angle), np.sin(angle)], axis=1) / np.cos(np.pi / self.sides)
        return Polygon(tuple((float(x), float(y)) for x, y in corner))


@dataclass(frozen=True)
class Hexagon(Polygonal):
    """A regular hexagon with a diameter across its flats."""

    sign, width = "AF ", "width across flats"

    @property
    def sharp(self) -> Polygon:
        return RegularPolygon(6).sharp
