"""Units as instruments write them, such as ``mm/s``, ``(m/s)/V`` or ``g``, converted to SI."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal

from haptonic.units import PREFIXES, TYPOGRAPHIC, to_si

Motion = Literal["displacement", "velocity", "acceleration"]

GRAVITY = 9.80665  # m/s^2, the standard value: sensors give accelerations in g
SI: dict[str, Motion] = {"m": "displacement", "m/s": "velocity", "m/s^2": "acceleration"}
UNITS: dict[Motion, str] = {motion: unit for unit, motion in SI.items()}
ORDER: tuple[Motion, ...] = ("displacement", "velocity", "acceleration")
PREFIX = {name: float(f"1e{power}") for name, power in (PREFIXES | {"p": -12, "c": -2, "u": -6}).items()}
OTHER = {"in": 0.0254, "inch": 0.0254, "ft": 0.3048}

_MOTION = re.compile(
    r"(?:(?P<prefix>[pnuµmc]?)m|(?P<other>inch|in|ft))(?P<per>/s(?:ec)?(?P<squared>\^?2|\*\*2|/s)?)?"
)
_PLAIN = re.compile(r"(?P<prefix>[pnuµmkMG]?)(?P<unit>V|N|A|Pa|W|Hz|s)")
_ANGULAR = re.compile(r"(?P<angle>[kMG]?rad|deg|turn)(?:/s(?:ec)?|\*?s\^?-1)|rpm")


@dataclass(frozen=True)
class UnitLabel:
    """Meaning of a written unit.

    motion : measured motion, or None for other quantities
    unit : in SI, such as "V"; as written if it is unknown
    factor : SI value of one written unit
    """

    motion: Motion | None
    unit: str
    factor: float


@dataclass(frozen=True)
class Ratio:
    """A unit with its numerator and denominator; the denominator's unit is empty if there is none."""

    over: UnitLabel
    under: UnitLabel

    @property
    def factor(self) -> float:
        return self.over.factor / self.under.factor


def label_of(text: str) -> UnitLabel:
    """Meaning of one unit without a denominator: "mm/s", "g", "mV"."""
    plain = re.sub(r"[\s()\[\]]", "", text.translate(TYPOGRAPHIC))
    if plain.upper() in ("", "NONE", "-"):
        return UnitLabel(None, "", 1.0)
    if plain in ("g", "gn", "G"):
        return UnitLabel("acceleration", "m/s^2", GRAVITY)
    match = _MOTION.fullmatch(plain)
    if match:
        power = 0 if not match["per"] else 2 if match["squared"] else 1
        unit = ("m", "m/s", "m/s^2")[power]
        return UnitLabel(
            ORDER[power], unit, OTHER[match["other"]] if match["other"] else PREFIX[match["prefix"]]
        )
    match = _PLAIN.fullmatch(plain)
    if match:
        return UnitLabel(None, match["unit"], PREFIX[match["prefix"]])
    match = _ANGULAR.fullmatch(plain)
    if match:  # an angle per time is a frequency
        per_second = f"1 {match['angle']}/s" if match["angle"] else "1 rpm"
        return UnitLabel(None, "Hz", to_si(per_second, "Hz", "unit"))
    return UnitLabel(None, text.strip(), 1.0)


def ratio_of(text: str) -> Ratio:
    """Meaning of a unit that may contain a denominator: "(m/s)/V", "m/s/V", "mm/s per V"."""
    plain = re.sub(r"\s+per\s+", "/", text.strip())
    bracketed = re.fullmatch(r"\(1/(?P<under>[^()]+)\)\*\(?(?P<over>[^()]+)\)?", re.sub(r"\s", "", plain))
    if bracketed:
        return Ratio(label_of(bracketed["over"]), label_of(bracketed["under"]))
    cuts = [match.start() for match in re.finditer("/", plain)]
    for cut in [len(plain), *reversed(cuts)]:
        over = label_of(plain[:cut])
        if over.motion is not None:
            return Ratio(over, label_of(plain[cut + 1 :]))
    return Ratio(label_of(plain), label_of(""))


def factor_of(text: str, si: str) -> float:
    """Value of a written unit in an SI unit: as instruments write it, or any unit that `to_si` reads.

    Raises
    ------
    HaptonicError : not a unit of this dimension
    """
    label = label_of(text)
    return label.factor if label.unit == si else to_si(f"1 {text}", si, "unit")


def steps(source: Motion, target: Motion) -> int:
    """Number of multiplications by i omega that convert a motion into another."""
    return ORDER.index(target) - ORDER.index(source)
