"""What a dimension reads on a drawing: its value in mm or degrees, with its tolerance if it has one."""

from __future__ import annotations

import math
from collections.abc import Mapping

from haptonic.cell import UnitCell
from haptonic.errors import StudyError, nearest

MINUS = "\N{MINUS SIGN}"
DECIMALS = 3  # of toleranced lengths in mm
DECIMALS_OF_ANGLES = 2  # of toleranced angles in degrees


def dimensions_of(cell: UnitCell) -> dict[str, float]:
    """Name and value (m, rad) of every dimension that makes this cell."""
    sides = [math.hypot(*side) for side in (cell.lattice.a1, cell.lattice.a2)]
    values = {"cell.pitch": sides[0], "cell.thickness": cell.thickness}
    if cell.lattice.name != "square":
        values["cell.pitch_y"] = sides[1]
    if cell.pillar is not None:
        pillar = cell.pillar
        values |= {"cell.pillar.diameter": pillar.diameter, "cell.pillar.height": pillar.height}
        if pillar.draft:
            values["cell.pillar.draft"] = pillar.draft
        if pillar.fillet:
            values["cell.pillar.fillet"] = pillar.fillet
        if pillar.step is not None:
            values["cell.pillar.step.diameter"] = pillar.step.diameter
            values["cell.pillar.step.height"] = pillar.step.height
    return values


def dimension_texts(cell: UnitCell, tolerances: Mapping[str, float]) -> dict[str, str]:
    """Text of every dimension, such as ``3.500 ± 0.020``.

    Parameters
    ----------
    tolerances : half-widths by the name of the dimension, m or rad

    Raises
    ------
    StudyError : a tolerance of what the cell does not have, or one that is not positive
    """
    values = dimensions_of(cell)
    for name, half_width in tolerances.items():
        if name not in values:
            guess = nearest(name, values)
            raise StudyError(
                argument=f"tolerances.{name}",
                given=half_width,
                allowed=f"one of {', '.join(values)}",
                cause="this cell has no such dimension",
                next_step=f'write "{guess}"' if guess else "leave it out",
            )
        if not (math.isfinite(half_width) and 0 < half_width < abs(values[name])):
            raise StudyError(
                argument=f"tolerances.{name}",
                given=half_width,
                allowed=f"a positive half-width below the dimension itself, {abs(values[name]):.4g} m or rad",
                cause="it is in mm or degrees, or has the wrong sign",
                next_step="give the half-width in m, that of the draft in rad",
            )
    return {name: _text(name, value, tolerances.get(name)) for name, value in values.items()}


def number(length: float, decimals: int = 4) -> str:
    """A length (m) in mm without a tolerance and without trailing zeros."""
    return f"{length * 1e3:.{decimals}f}".rstrip("0").rstrip(".")


def degrees(angle: float) -> str:
    """An angle without a tolerance."""
    return f"{math.degrees(angle):.3f}".rstrip("0").rstrip(".").replace("-", MINUS) + "°"


def _text(name: str, value: float, half_width: float | None) -> str:
    is_angle = name.endswith("draft")
    if half_width is None:
        return degrees(value) if is_angle else number(value)
    value, half_width = (
        (math.degrees(value), math.degrees(half_width)) if is_angle else (value * 1e3, half_width * 1e3)
    )
    least = DECIMALS_OF_ANGLES if is_angle else DECIMALS
    decimals = max(least, -math.floor(math.log10(half_width) + 1e-9))  # a fine tolerance is not shown as 0
    unit = "°" if is_angle else ""
    return f"{value:.{decimals}f}{unit} ± {half_width:.{decimals}f}{unit}".replace("-", MINUS)
