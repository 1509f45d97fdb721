"""An elliptical section."""

from __future__ import annotations

from dataclasses import dataclass

from haptonic.cell.outlines.outline import Outline
from haptonic.cell.outlines.oval import Oval
from haptonic.cell.outlines.section import Section


@dataclass(frozen=True)
class Ellipse(Section):
    """An ellipse: before it is turned, the diameter is along x and the length along y."""

    length: float
    turn: float = 0.0

    def outline(self) -> Outline:
        return Oval.of_axes(1.0, self.length, self.turn)
