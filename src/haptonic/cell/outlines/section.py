"""Named section of a pillar: its numbers, and the outline that they define.

Lengths are in half-widths along x, which is half the pillar's diameter. The fields of a section are the
numbers of ``[cell.pillar]`` that it uses; a field without a default is required.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from haptonic.cell.outlines.outline import SAME, Outline
from haptonic.cell.outlines.polygon import Polygon
from haptonic.fields import problem


class Section:
    """Protocol of the classes in `SECTIONS`.

    sign, width : text before the pillar's diameter in a drawing, and the workshop's name of this width
    """

    sign: ClassVar[str] = ""
    width: ClassVar[str] = "width"

    def outline(self) -> Outline:
        """The curve, with half-width 1 along x before it is turned; only for numbers that `check` accepts."""
        raise NotImplementedError

    def check(self) -> None:
        """Raise `problem` for numbers that define no such outline."""

    def room(self) -> dict[str, float]:
        """Room left to limits of the section's own numbers, in half-widths, by their names in a design."""
        return {}

    def shear_coefficient(self, poisson_ratio: float) -> float | None:
        """Shear coefficient of a Timoshenko beam (Cowper 1966); None if it has no closed form."""
        return None


@dataclass(frozen=True, kw_only=True)
class Polygonal(Section):
    """A section with straight sides, whose corners may be rounded."""

    corner_radius: float = 0.0
    turn: float = 0.0

    @property
    def sharp(self) -> Polygon:
        """The polygon with sharp corners, not turned."""
        raise NotImplementedError

    def outline(self) -> Outline:
        return self.sharp.rounded(self.corner_radius).turned(self.turn)

    def room(self) -> dict[str, float]:
        return {"corner radius": self.sharp.most_rounding - self.corner_radius} if self.corner_radius else {}

    def check(self) -> None:
        most = self.sharp.most_rounding
        if self.corner_radius > most * (1 + SAME):
            raise problem(
                "out-of-range",
                f"{0.5 * self.corner_radius:.4g} of the diameter",
                f"at most {0.5 * most:.4g} of the diameter for this section",
                "two rounded corners would meet within a side",
                "choose a smaller radius",
                at="corner_radius",
            )
