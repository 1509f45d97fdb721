"""What is asked of the bands of a cell."""

from __future__ import annotations

from dataclasses import dataclass

from haptonic.bloch.resolution import Resolution


@dataclass(frozen=True)
class Asked:
    """What is asked of the bands of a cell; see the table ``[bands]`` of the study file.

    count : bands, from the lowest; points : wavevectors along the edge of the irreducible zone
    accuracy : relative error allowed for every frequency; resolution : overrides what that would choose
    """

    count: int
    points: int
    accuracy: float
    resolution: Resolution | None
