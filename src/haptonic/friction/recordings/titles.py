"""Titles that sensor programs write above their tables: counts for a unit of force, unit, sampling rate."""

from __future__ import annotations

import re
from dataclasses import dataclass

from haptonic.channels import Group
from haptonic.channels.delimited import TITLES

_NUMBER = r"(\d[\d.]*(?:[eE][+-]?\d+)?)"
_COUNTS = re.compile(
    rf"counts?\s*(?:per|/)\s*(?:unit\s*)?(?:force|newton|(?P<unit>m?N|lbf|gf|kgf))\b\D{{0,4}}{_NUMBER}",
    re.IGNORECASE,
)
_UNIT = re.compile(r"force\s*units?\"?\s*[:=,;]\s*\"?(\w+)", re.IGNORECASE)
_RATE = re.compile(
    rf"(?:sampl\w*|scan|acquisition|abtast)\s*-?(?:rate|frequency|freq|frequenz)\D{{0,4}}{_NUMBER}\s*(k?hz)?",
    re.IGNORECASE,
)


@dataclass(frozen=True)
class TitleScale:
    """counts : for one unit of force; unit : of the forces, "" if not given; rate : Hz, None if not given"""

    counts: float = 1.0
    unit: str = ""
    rate: float | None = None


def scale_of(channels: Group) -> TitleScale:
    """Scale and rate in the titles above a table."""
    text = "\n".join(channels.properties.get(TITLES, ()))
    counts, unit, rate = _COUNTS.search(text), _UNIT.search(text), _RATE.search(text)
    hertz = float(rate[1]) * (1e3 if (rate[2] or "").casefold() == "khz" else 1.0) if rate else 0.0
    return TitleScale(
        counts=float(counts[2]) or 1.0 if counts else 1.0,
        unit=(counts["unit"] or "" if counts else "") or (unit[1] if unit else ""),
        rate=hertz or None,
    )
