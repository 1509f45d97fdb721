"""Requirements of a plate, each with a colour and its reason."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from haptonic.bloch import Gap
from haptonic.friction.lubrication import CUE_THRESHOLD, WEBER_FRACTION
from haptonic.friction.lubrication.on_plate import Reduction
from haptonic.names import listed
from haptonic.plots.text import gap_text
from haptonic.units import hz_text, in_percent

FAR = 2.0  # reduction that a driven region should reach, relative to the smallest noticeable one
Colour = Literal["green", "amber", "red"]


@dataclass(frozen=True)
class Requirement:
    """One requirement of a plate. what : the requirement; reason : the numbers behind the colour"""

    colour: Colour
    what: str
    reason: str


def requirements(
    reductions: Mapping[str, Reduction],
    driven: Collection[str],
    rise: float,
    constant: float,
    in_gap: Requirement,
) -> list[Requirement]:
    """Requirements of each region, of the rise time of the vibration, and of the gap.

    Parameters
    ----------
    driven : regions whose friction a drive should reduce; that of the others should not change
    rise, constant : 10 to 90 % rise time and time constant with a finger on the driven region, s; NaN if no
        mode is near the frequency
    in_gap : from `drive_in_gap`
    """
    regions = [
        _driven(name, felt) if name in driven else _idle(name, felt) for name, felt in reductions.items()
    ]
    return [*regions, _time(rise, constant), in_gap]


def _driven(name: str, felt: Reduction) -> Requirement:
    wanted = FAR * WEBER_FRACTION
    colour: Colour = "green" if felt.low >= wanted else "amber" if felt.value >= wanted else "red"
    return Requirement(
        colour, f"{name} is felt clearly", f"reduction {felt}, wanted {in_percent(wanted)} or more"
    )


def _idle(name: str, felt: Reduction) -> Requirement:
    colour: Colour = (
        "green" if felt.high <= WEBER_FRACTION else "amber" if felt.value <= WEBER_FRACTION else "red"
    )
    return Requirement(
        colour, f"{name} is not felt", f"reduction {felt}, wanted {in_percent(WEBER_FRACTION)} or less"
    )


def _time(rise: float, constant: float) -> Requirement:
    what = "the vibration builds up in time"
    if math.isnan(rise):
        return Requirement("amber", what, "not determined: no mode near the frequency of the drive")
    colour: Colour = "green" if rise <= CUE_THRESHOLD else "amber" if constant <= CUE_THRESHOLD else "red"
    reason = f"10 to 90 % in {_milliseconds(rise)}, time constant {_milliseconds(constant)}"
    wanted = f"wanted {_milliseconds(CUE_THRESHOLD)} or less"
    return Requirement(colour, what, f"{reason}, {wanted}")


def drive_in_gap(frequency: float, gap: Gap | None, without: Sequence[str] = ()) -> Requirement:
    """Requirement that the drive frequency (Hz) lies in a gap.

    gap : the one around it, if any; without : lattices without one, if others have one
    """
    if gap is None:
        of = f" of {listed(without)}" if without else ""
        reason = f"no gap{of} contains it by more than its errors"
        return Requirement("red", "the drive lies in a band gap", reason)
    return Requirement(
        "green" if gap.holds(frequency) else "red",
        "the drive lies in a band gap",
        f"{hz_text(frequency, form='.2f')}, gap {gap_text(gap)}",
    )


def _milliseconds(time: float) -> str:
    return f"{1e3 * time:.1f} ms"
