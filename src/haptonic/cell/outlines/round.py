"""A round section."""

from __future__ import annotations

from dataclasses import dataclass

from haptonic.cell.outlines.outline import Outline
from haptonic.cell.outlines.oval import CIRCLE
from haptonic.cell.outlines.section import Section


@dataclass(frozen=True)
class Round(Section):
    """A circle."""

    sign, width = "⌀", "diameter"

    def outline(self) -> Outline:
        return CIRCLE

    def shear_coefficient(self, poisson_ratio: float) -> float:
        return 6 * (1 + poisson_ratio) / (7 + 6 * poisson_ratio)
