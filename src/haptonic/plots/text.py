"""Numbers and names as people read them on an axis or in a table."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, Literal

from haptonic.names import visible
from haptonic.units import frequency_scale, uncertain

if TYPE_CHECKING:
    from haptonic.bloch import Gap
    from haptonic.vibrometry import MeasuredGap

WavevectorUnit = Literal["rad/m", "pi/a"]

LONGEST_NAME = 12  # letters of a name in a picture
LETTER = 0.56  # width of a letter over the size of the type
_PREFIXED = {0: "", 3: "m", 6: "µ", 9: "n", 12: "p"}  # by the power of ten by which they divide
_SCALED = {"m": ("mm", 1e3), "Hz": ("kHz", 1e-3), "Pa": ("GPa", 1e-9), "rad": ("deg", 180 / math.pi)}
_PROPERLY = {
    "material.youngs_modulus": "Young's modulus",
    "material.poisson_ratio": "Poisson ratio",
    "cell.pitch_y": "pitch along y",
    "cell.pitch_2": "second pitch",
}
_PROPER = re.compile(rf"\b(?:{'|'.join(map(re.escape, _PROPERLY))})\b")
_OF_SITE = re.compile(r"\bcell\.site\[(\d*)\]\.([\w.\[\]]*\w)")
_OF_DISC = re.compile(r"\bdisc\[(\d*)\]\.")


def uncertain_hertz(frequency: float, error: float) -> str:
    """``52.51 ± 0.05 kHz``: a frequency and the bound of its error, Hz; see `uncertain`."""
    unit, scale = frequency_scale(frequency)
    return f"{uncertain(frequency * scale, error * scale)} {unit}"


def band_text(lower: float, lower_error: float, upper: float, upper_error: float) -> str:
    """``52.51 ± 0.05 to 60.223 ± 0.012 kHz``: both ends of a band with the bounds of their errors, Hz."""
    unit, scale = frequency_scale(lower, upper)
    ends = ((lower, lower_error), (upper, upper_error))
    return f"{' to '.join(uncertain(end * scale, error * scale) for end, error in ends)} {unit}"


def gap_text(gap: Gap | MeasuredGap) -> str:
    """``52.51 ± 0.05 to 60.223 ± 0.012 kHz``: both edges of a gap with the bounds of their errors."""
    return band_text(gap.lower, gap.lower_error, gap.upper, gap.upper_error)


def label(name: str) -> str:
    """A name for a legend, which would leave out one that begins with "_"."""
    shown = visible(name)
    return f"\N{ZERO WIDTH SPACE}{shown}" if shown.startswith("_") else shown


def short(name: str) -> str:
    """A name for a place in a picture: of a long one the beginning and the end, where names differ."""
    shown = label(name)
    half = (LONGEST_NAME - 1) // 2
    return shown if len(shown) <= LONGEST_NAME else f"{shown[:half].rstrip()}…{shown[-half:].lstrip()}"


def readable(expression: str) -> str:
    """A swept expression in words: ``cell.pillar.diameter / cell.pitch`` is ``pillar diameter / pitch``."""
    expression = _OF_SITE.sub(r"\2 of site \1", expression)
    plain = re.sub(
        r"\b(?:cell|material|parameters)\.", "", _PROPER.sub(lambda name: _PROPERLY[name[0]], expression)
    )
    plain = _OF_DISC.sub(lambda disc: f"disc {disc[1]} " if disc[1] else "disc ", plain)
    return re.sub(r"(?<=[A-Za-z])[._](?=[A-Za-z])", " ", plain)


def scaled_unit(unit: str) -> tuple[str, float]:
    """The unit of a drawing as text, and the factor of SI values."""
    if unit in ("", "1"):
        return "dimensionless", 1.0
    return _SCALED.get(unit, (unit, 1.0))


def absolute(units: str, largest: float, drive: float | None) -> tuple[str, float]:
    """The unit in which a vibration is drawn, and the factor of SI values.

    Parameters
    ----------
    units : of a response, such as "m/s/V"; largest : its largest value in these
    drive : amplitude of the drive by which it is divided, if known: then the vibration itself is drawn
    """
    moving = "m/s" if units.startswith("m/s") else "m"
    factor = 1.0 if drive is None else drive
    beyond = units.removeprefix(moving) if drive is None else ""
    unit, scale = prefixed(largest * factor, moving)
    return f"{unit}{beyond}", factor * scale


def prefixed(largest: float, unit: str) -> tuple[str, float]:
    """The unit with the prefix that suits values up to ``largest``, and the factor of the values."""
    power = next((power for power in _PREFIXED if largest * 10.0**power >= 1), max(_PREFIXED))
    return f"{_PREFIXED[power]}{unit}", 10.0**power


def driven(units: str, drive: float | None) -> str:
    """Text for the amplitude of the drive of a response with these units; empty if it is not known."""
    return "" if drive is None else f" at {drive:g} {units.rpartition('/')[2]}"


def in_pi(phase: float) -> str:
    """A phase (rad) as a person writes it."""
    share = round(phase / math.pi, 2)
    return {0.0: "0", 1.0: "π"}.get(share, f"{share:g} π")


def minus(text: str) -> str:
    """The text of a number with the sign that is as wide as a plus."""
    return text.replace("-", "\N{MINUS SIGN}")
