"""A section given by its corners."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from haptonic.cell.outlines.polygon import Polygon
from haptonic.cell.outlines.section import Polygonal
from haptonic.fields import problem

SHARPEST = 0.35  # rad, 20 degrees: elements in a sharper corner would be slivers
LEAST_WITHIN = 0.05  # of the farthest corner's distance, smallest distance of a side from the axis


class Place(Protocol):
    """A corner, in half-widths."""

    x: float
    y: float


@dataclass(frozen=True)
class Corners(Polygonal):
    """A polygon with every corner in sight of the axis; the corners may be in either order."""

    point: tuple[Place, ...]

    @property
    def sharp(self) -> Polygon:
        places = tuple((place.x, place.y) for place in self.point)
        following = places[1:] + places[:1]
        twice = sum(a * d - b * c for (a, b), (c, d) in zip(places, following, strict=True))
        return Polygon(places if twice > 0 else places[::-1])

    def check(self) -> None:
        if len(self.point) < 3 or not self.sharp.is_star:
            raise problem(
                "out-of-range",
                f"{len(self.point)} corners",
                "three or more, in order, all seen from the axis (0, 0) inside, and none on a straight side",
                "the sides cross, hide others from the axis or pass it on one side",
                "order the points anticlockwise, and count them from the axis",
                at="point",
            )
        sharp = self.sharp
        reach = max(abs(complex(*vertex)) for vertex in sharp.vertices)
        angles = sharp.interior_angles
        if min(angles.min(), 2 * np.pi - angles.max()) < SHARPEST or sharp.inradius < LEAST_WITHIN * reach:
            raise problem(
                "out-of-range",
                "a sharp corner, or a side close to the axis",
                "corners of at least 20 degrees, and sides at a twentieth of the largest half-width from "
                "the axis or farther",
                "elements there would be slivers",
                "move the points, or the axis, or round the section off",
                at="point",
            )
        super().check()
