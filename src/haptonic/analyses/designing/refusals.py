"""Why a search has no design to give: what held it back, how close it came, and what would help."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

from haptonic.arrays import Array
from haptonic.bloch import Gap
from haptonic.design.brief import Brief
from haptonic.design.parameters import UNITS
from haptonic.design.search import Visited
from haptonic.errors import HaptonicError, StudyError
from haptonic.units import format_quantity

AT_BOUND = 0.01  # share of a range, or of a limit, from which one counts as reached


def held_back_by(brief: Brief, share: Array) -> list[str]:
    """Bounds and limits that a design has reached, in words; each could be widened or relaxed."""
    values = zip(brief.paths, brief.values(share), share, strict=True)
    reached = [
        f"{path} = {format_quantity(value, UNITS[path])}"
        for path, value, place in values
        if min(place, 1 - place) < AT_BOUND
    ]
    return reached + [
        f"the limit on the {name}" for name, room in brief.limits(share).items() if room < AT_BOUND
    ]


def out_of_reach(
    brief: Brief, best: Gap | None, summits: Sequence[Visited], seen: Sequence[Visited], ends: Sequence[float]
) -> StudyError:
    """How close the search came, and what held it back.

    best : at the accuracy asked for, if there is any; summits : of climbs, the best first
    seen : all designs; ends : Hz, lowest frequency of the last band of those that were looked at
    """
    carrier = brief.carrier
    if best is not None and best.lower < carrier < best.upper:
        lower, upper, *errors = in_khz(best.lower, best.upper, best.lower_error, best.upper_error)
        return StudyError.inaccurate(
            argument="bands.accuracy",
            given=f"edges known to {' and '.join(errors)} kHz only",
            allowed="edges known well enough to say that the carrier lies between them",
            cause=f"the gap {lower} to {upper} kHz holds it by less than that",
            next_step="ask for a finer accuracy, or leave [mesh] out",
        )
    reached = held_back_by(brief, summits[0].share)
    held = f"held back by {', '.join(reached)}" if reached else "inside all bounds and limits"
    above = sum(end <= carrier for end in ends)
    bands = (
        f"; the {brief.count} bands end below it in {above} of {len(ends)} designs looked at" if above else ""
    )
    return StudyError.no_answer(
        argument="carrier",
        given=format_quantity(carrier, "Hz"),
        allowed="a frequency that the gap of some allowed design holds",
        cause=f"{_closest(carrier, best, seen)}; the best design is {held}{bands}",
        next_step=("raise [bands] count, " if above else "")
        + ("widen these bounds, " if reached else "")
        + "vary other parameters, look at more designs ([design] starts and climbs), "
        "or choose another carrier",
    )


def _closest(carrier: float, best: Gap | None, seen: Sequence[Visited]) -> str:
    """How close a gap came, the coarse model being asked only if there is no better one."""
    gaps = [(best.lower, best.upper)] if best is not None else []
    gaps = gaps or [(visit.lower, visit.upper) for visit in seen if visit.is_open(carrier)]
    if not gaps:
        return "no design seen has a gap at all"
    away, edges = min((max(edges[0] - carrier, carrier - edges[1]), edges) for edges in gaps)
    lower, upper, missed = in_khz(*edges, away)
    if away <= 0:
        return f"the gap {lower} to {upper} kHz holds it in the coarse model of the search only"
    return f"the closest gap seen, {lower} to {upper} kHz, misses it by {missed} kHz"


def uncomputed(brief: Brief, summit: Visited, failure: HaptonicError) -> HaptonicError:
    """Designs were seen in the coarse model, and the meshes of none of them fit."""
    values = zip(brief.paths, brief.values(summit.share), strict=True)
    named = ", ".join(f"{path} = {format_quantity(value, UNITS[path])}" for path, value in values)
    lower, upper = in_khz(summit.lower, summit.upper)
    return failure.changed(
        type(failure),
        cause=f"{failure.cause}; of the designs seen none can be computed. The best of them, {named}, has a "
        f"gap from {lower} to {upper} kHz in the coarse model",
    )


def in_khz(*frequencies: float) -> list[str]:
    """Frequencies, Hz, with so many digits that those that differ read so, and none reads as zero."""
    steps = [abs(f) for f in frequencies] + [abs(a - b) for a, b in itertools.combinations(frequencies, 2)]
    steps = [step for step in steps if step]
    digits = min(9, max(2, *(1 - math.floor(math.log10(step / 1e3)) for step in steps))) if steps else 2
    return [f"{frequency / 1e3:.{digits}f}" for frequency in frequencies]
