"""Wavevectors from text: a corner, a position between two corners, or two phases."""

from __future__ import annotations

import re

import numpy as np

from haptonic.arrays import Array
from haptonic.brillouin import IrreducibleZone
from haptonic.errors import StudyError, shown

GAMMA = {"G": "Γ", "GAMMA": "Γ", "Γ": "Γ"}
_NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)"
_PHASES = re.compile(rf"\s*({_NUMBER})(?:\s*,\s*|\s+)({_NUMBER})\s*")
_BETWEEN = re.compile(rf"\s*(?:(?P<share>{_NUMBER})\s+(?:of\s+)?)?(?P<start>\S+?)-(?P<stop>\S+)\s*")
LARGEST = 2.0  # of phases over pi: twice the zone


def wavevector_at(zone: IrreducibleZone, text: str, argument: str = "modes_at") -> tuple[Array, str]:
    """The (2,) phases k . a1 and k . a2, rad, and the name of a wavevector.

    Parameters
    ----------
    text : a corner, ``M``; a share of the path between two, ``0.3 X-M``; the middle, ``X-M``; or both phases
        over pi, ``0.5, 0.25``
    argument : name in errors

    Raises
    ------
    StudyError : text of another form
    """
    corners = zone.corner_phases

    def corner(name: str) -> str | None:
        name = GAMMA.get(name.upper(), name.upper().replace("'", "\N{PRIME}"))
        return name if name in corners else None

    if match := _PHASES.fullmatch(text):
        first, second = float(match[1]), float(match[2])
        if max(abs(first), abs(second)) <= LARGEST:
            return np.pi * np.array([first, second]), f"k·a = ({first:g} π, {second:g} π)"
    elif (name := corner(text.strip())) is not None:
        return corners[name].copy(), name
    elif match := _BETWEEN.fullmatch(text):
        start, stop, share = corner(match["start"]), corner(match["stop"]), float(match["share"] or 0.5)
        if start and stop and 0 <= share <= 1:
            kappa = (1 - share) * corners[start] + share * corners[stop]
            return kappa, f"{'middle' if share == 0.5 else f'{share:g}'} of {start}-{stop}"
    labels = list(corners)
    raise StudyError.malformed(
        argument=argument,
        given=shown(text),
        allowed=f'a corner ({", ".join(labels)}), a share between two ("0.3 {labels[0]}-{labels[1]}") or the '
        f'phases k.a1 and k.a2 over pi, at most {LARGEST:g} ("0.5, 0.25")',
        cause="the text is not a wavevector of this lattice",
        next_step=f"write {labels[-1]}, or leave it out for the middle of {labels[1]}-{labels[2]}",
    )
