"""Text of a dimension on a drawing: its value in mm or degrees, with its tolerance if it has one."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from haptonic.cell import Disc, UnitCell
from haptonic.errors import StudyError
from haptonic.workshop.shape import MM, OF_DISC, Dimension, dimensions

MINUS = "\N{MINUS SIGN}"
DECIMALS = 3  # of toleranced lengths in mm
DECIMALS_OF_ANGLES = 2  # of toleranced angles in degrees
ROUNDING = 1e-9  # mm or degrees
FINEST = 4  # decimals of a length without a tolerance, trailing zeros left out; more for short ones
DERIVED = 2  # decimals of a length that follows from others, such as 17.3205...: ISO 2768 has none finer


def checked_tolerances(cell: UnitCell, tolerances: Mapping[str, float]) -> Mapping[str, float]:
    """Check tolerances, and return them: half-widths by the name of the dimension, m or rad.

    Raises
    ------
    StudyError : a tolerance of a dimension that the cell lacks, or one that is not positive
    """
    known = {dimension.name: dimension for dimension in dimensions(cell) if dimension.name}
    for name, half_width in tolerances.items():
        if name not in known:
            cause = "this cell has no such dimension"
            raise StudyError.unknown(f"tolerances.{name}", name, known, cause, next_step="leave it out")
        # a height above the plate may be smaller than its tolerance
        largest = cell.thickness if known[name].kind == "level" else abs(known[name].value)
        if not (math.isfinite(half_width) and 0 < half_width < largest):
            raise StudyError.out_of_range(
                argument=f"tolerances.{name}",
                given=half_width,
                allowed=f"a positive half-width below {largest:.4g} m or rad",
                cause="it is in mm or degrees, or has the wrong sign",
                next_step="give the half-width in m, that of the draft in rad",
            )
    return tolerances


def disc_text(name: str, value: float, at: str, tolerances: Mapping[str, float]) -> str:
    """Text of a number (m or rad) of a disc, whose table has the path ``at``, with its tolerance."""
    dimension = Dimension(f"{at}.{name}", value, OF_DISC[name])
    if not dimension.is_angle:
        dimension = replace(dimension, value=MM * value)
    return text_of(dimension, tolerances.get(f"{at}.{name}"))


def disc_width(disc: Disc, thickness: float, at: str, tolerances: Mapping[str, float]) -> str:
    """Text of the diameter of a disc, of a cone those at its lower and its upper end, with tolerance."""
    return " to ".join(disc_text("diameter", w, at, tolerances) for w in disc.diameters(thickness))


def style_of(dimension: Dimension, half_width: float | None, sign: str = "") -> dict[str, Any]:
    """Style of a DIMENSION entity for a length, such as ⌀3.5 or, by DXF's own tolerance, ⌀3.500 ±0.020.

    half_width : of its tolerance, m; a dimension without a name is shown in brackets, for reference
    """
    if half_width is None:
        form = f"{sign}<>" if dimension.name else f"({sign}<>)"
        places = decimals(dimension.value, FINEST if dimension.name else DECIMALS)
        return {"dimpost": form, "dimdec": places, "dimzin": 8}
    places, deviation = _decimals(half_width * MM, DECIMALS), half_width * MM
    return {
        "dimpost": f"{sign}<> ", "dimtol": 1, "dimtp": deviation, "dimtm": deviation, "dimtfac": 1.0,
        "dimtolj": 1, "dimdec": places, "dimtdec": places, "dimzin": 0, "dimtzin": 0,
    }  # fmt: skip


def text_of(dimension: Dimension, half_width: float | None, sign: str = "") -> str:
    """Text by `style_of` for a length in mm; for an angle its degrees, such as 2.00° ±0.25°."""
    if dimension.is_angle:
        return sign + degrees(dimension.value, half_width)
    style = style_of(dimension, half_width, sign)
    form: str = style["dimpost"]
    value = f"{dimension.value:.{style['dimdec']}f}"
    if half_width is None:
        return form.replace("<>", value.rstrip("0").rstrip("."))
    return form.replace("<>", value) + f"±{style['dimtp']:.{style['dimtdec']}f}"


def decimals(value: float, finest: int) -> int:
    """Number of decimals of a length (mm): ``finest`` if it has no more, else `DERIVED`, and four digits."""
    least = finest if abs(value - round(value, finest)) < ROUNDING else DERIVED
    return max(least, 3 - math.floor(math.log10(abs(value)))) if abs(value) > ROUNDING else least


def _decimals(half_width: float, least: int) -> int:
    """Number of decimals that shows a tolerance, and with which a value is rounded by 5 % of it at most."""
    return max(least, 1 - math.floor(math.log10(half_width) + 1e-9))


def number(length: float, places: int = FINEST) -> str:
    """A length (m) in mm without a tolerance and without trailing zeros."""
    text = f"{length * MM:.{decimals(length * MM, places)}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def degrees(angle: float, half_width: float | None = None) -> str:
    """An angle (rad) in degrees, such as 2° or 2.00° ±0.25°."""
    angle = math.degrees(angle)
    if half_width is None:
        return f"{angle:.3f}".rstrip("0").rstrip(".").replace("-", MINUS) + "°"
    half_width = math.degrees(half_width)
    places = _decimals(half_width, DECIMALS_OF_ANGLES)
    return f"{angle:.{places}f}° ±{half_width:.{places}f}°".replace("-", MINUS)
