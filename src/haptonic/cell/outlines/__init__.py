"""Outlines of pillars: one file for each section, and the table of their names."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import MISSING, fields
from typing import Any, Literal

from haptonic.cell.outlines.arms import Cross, Snowflake
from haptonic.cell.outlines.ellipse import Ellipse
from haptonic.cell.outlines.outline import Outline, Scaled
from haptonic.cell.outlines.oval import CIRCLE
from haptonic.cell.outlines.points import Corners
from haptonic.cell.outlines.rectangle import Rectangular, Square
from haptonic.cell.outlines.regular import Hexagon, RegularPolygon
from haptonic.cell.outlines.round import Round
from haptonic.cell.outlines.section import Section

__all__ = ["CIRCLE", "NUMBERS", "SECTIONS", "Outline", "Scaled", "Section", "SectionName", "taken_by"]

SectionName = Literal[
    "round", "square", "rectangle", "hexagon", "polygon", "ellipse", "points", "cross", "snowflake"
]
SECTIONS: Mapping[SectionName, type[Section]] = {
    "round": Round,
    "square": Square,
    "rectangle": Rectangular,
    "hexagon": Hexagon,
    "polygon": RegularPolygon,
    "ellipse": Ellipse,
    "points": Corners,
    "cross": Cross,
    "snowflake": Snowflake,
}


def taken_by(section: type[Any]) -> dict[str, bool]:
    """Numbers of a pillar that a section uses, and True for required ones."""
    return {number.name: number.default is MISSING for number in fields(section)}


NUMBERS = tuple(dict.fromkeys(name for section in SECTIONS.values() for name in taken_by(section)))
"""Numbers of a pillar beside its diameter that some section uses."""
