"""Meaning of a channel from its name, in several languages: Fz, F_z, Force Z (N), Kraft_z."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field

FORCE = (
    "force", "kraft", "fuerza", "forza", "kracht", "força", "forca", "effort", "load", "last", "f",
)  # fmt: skip
FILLERS = {
    "in", "the", "of", "on", "am", "an", "direction", "dir", "axis", "axes", "achse", "component", "comp",
    "komponente", "richtung", "axe", "eje", "sensor",
}  # fmt: skip
UNITS = {
    "n": "N", "mn": "mN", "kn": "kN", "cn": "cN", "gf": "gf", "kgf": "kgf", "lbf": "lbf", "ozf": "ozf",
    "v": "V", "mv": "mV", "m": "m", "mm": "mm", "cm": "cm", "um": "um", "s": "s", "sec": "s", "ms": "ms",
    "us": "us", "seconds": "s", "newton": "N", "newtons": "N",
}  # fmt: skip
NORMAL = ("normal", "norm", "normale", "normaal", "normales")
TANGENTIAL = (
    "tangential", "tang", "tangent", "tangentiale", "tangentielle", "tangencial", "tangenziale", "shear",
    "scher", "lateral", "schub",
)  # fmt: skip
FRICTION = ("friction", "reib", "reibungs", "frottement", "rozamiento", "attrito", "wrijvings")
POSITION = {
    "position", "pos", "finger position", "finger", "weg", "posición", "posicion", "posizione", "positie",
}  # fmt: skip
TIME = {
    "time", "t", "timestamp", "times", "time stamp", "elapsed time", "elapsed", "clock", "zeit",
    "zeitstempel", "uhrzeit", "temps", "tiempo", "tempo", "tijd", "time of day", "date time", "datetime",
}  # fmt: skip
_WORD = re.compile(r"[A-ZÀ-Þ]?[a-zà-ÿ]+|[A-ZÀ-Þ]+(?![a-zà-ÿ])|[µμ]?[A-Za-zÀ-ÿ]+|\d+")
_UNIT = re.compile(r"(?P<name>.*\w)[\s_\-.]+(?P<unit>[A-Za-z]+)")
_FORCES = "|".join(FORCE)
_AXIS = re.compile(rf"(?:{_FORCES})([xyz])|([xyz])(?:{_FORCES})")
_NORMAL = re.compile(rf"(?:{_FORCES})?(?:{'|'.join(NORMAL)})(?:{_FORCES})?|fn|(?:force|kraft)n")
_TANGENTIAL = re.compile(
    rf"(?:{_FORCES})?(?:{'|'.join(TANGENTIAL)})(?:{_FORCES})?|ft|(?:force|kraft)t"
    rf"|(?:{'|'.join(FRICTION)})(?:{_FORCES})|(?:{_FORCES})(?:{'|'.join(FRICTION)})"
)


@dataclass(frozen=True)
class Names:
    """Names of channels by their meaning; several names of one meaning are ambiguous.

    axes : by "x", "y", "z"
    """

    normal: list[str] = field(default_factory=list)
    tangential: list[str] = field(default_factory=list)
    position: list[str] = field(default_factory=list)
    time: list[str] = field(default_factory=list)
    axes: dict[str, list[str]] = field(default_factory=lambda: {"x": [], "y": [], "z": []})

    @classmethod
    def of(cls, names: Iterable[str]) -> Names:
        """Select the names whose meaning is usual."""
        by_meaning = cls()
        for name in names:
            words, _ = split(name)
            joined, spaced = "".join(words), " ".join(words)
            if match := _AXIS.fullmatch(joined):
                by_meaning.axes[match[1] or match[2]].append(name)
            elif _NORMAL.fullmatch(joined):
                by_meaning.normal.append(name)
            elif _TANGENTIAL.fullmatch(joined):
                by_meaning.tangential.append(name)
            elif spaced in POSITION:
                by_meaning.position.append(name)
            elif spaced in TIME or joined in TIME:
                by_meaning.time.append(name)
        return by_meaning


def split(name: str) -> tuple[list[str], str]:
    """Words of a name in small letters, and the unit at its end, as in "Fz_mN"; "" without a unit."""
    unit = ""
    if (ending := _UNIT.fullmatch(name.strip())) and ending["unit"].casefold() in UNITS:
        name, unit = ending["name"], UNITS[ending["unit"].casefold()]
    words = [word.casefold() for word in _WORD.findall(name)]
    return [word for word in words if word not in FILLERS] or words, unit


def plain(name: str) -> str:
    """A name without capitals, separators and unit, for comparison with other names."""
    return "".join(split(name)[0])
