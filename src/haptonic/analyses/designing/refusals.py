"""Reasons why a search found no design: the bounds it reached, the closest gap, and advice."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

from haptonic.arrays import Array
from haptonic.bloch import Gap
from haptonic.design.brief import Brief
from haptonic.design.search import Visited
from haptonic.errors import HaptonicError, StudyError
from haptonic.units import format_quantity

AT_BOUND = 0.01  # share of a range, or of a limit; closer than this a bound counts as reached


def held_back_by(brief: Brief, share: Array) -> list[str]:
    """Bounds and limits that a design has reached, as texts; each could be widened or relaxed."""
    values = zip(brief.paths, brief.values(share), share, strict=True)
    reached = [
        f"{path} = {format_quantity(value, brief.links.unit(path))}"
        for path, value, place in values
        if min(place, 1 - place) < AT_BOUND
    ]
    return reached + [
        f"the limit on the {name}" for name, room in brief.limits(share).items() if room < AT_BOUND
    ]


def out_of_reach(
    brief: Brief, best: Gap | None, summits: Sequence[Visited], seen: Sequence[Visited], ends: Sequence[float]
) -> StudyError:
    """Error of a search without a result, with the closest gap and the bounds that it reached.

    best : gap at the required accuracy, if any; summits : ends of climbs, the best first
    seen : all designs; ends : Hz, lowest frequency of the last band of each design
    """
    carrier = brief.carrier
    if best is not None and best.lower < carrier < best.upper:
        lower, upper, *errors = in_khz(best.lower, best.upper, best.lower_error, best.upper_error)
        return StudyError.inaccurate(
            argument="bands.accuracy",
            given=f"edges with errors of {' and '.join(errors)} kHz",
            allowed="edges exact enough to show that the carrier lies between them",
            cause=f"the carrier lies in the gap {lower} to {upper} kHz, but closer to an edge than its error",
            next_step="choose a finer accuracy, or leave [mesh] out",
        )
    reached = held_back_by(brief, summits[0].share)
    limited = f"limited by {', '.join(reached)}" if reached else "inside all bounds and limits"
    above = sum(end <= carrier for end in ends)
    bands = (
        f"; the {brief.count} bands end below it in {above} of {len(ends)} examined designs" if above else ""
    )
    return StudyError.no_answer(
        argument="carrier",
        given=format_quantity(carrier, "Hz"),
        allowed="a frequency in the gap of an allowed design",
        cause=f"{_closest(carrier, best, seen)}; the best design is {limited}{bands}",
        next_step=("raise [bands] count, " if above else "")
        + ("widen these bounds, " if reached else "")
        + "vary other parameters, examine more designs ([design] starts and climbs), "
        "or choose another carrier",
    )


def _closest(carrier: float, best: Gap | None, seen: Sequence[Visited]) -> str:
    """Text on the closest gap; uses the coarse model only if no gap was computed accurately."""
    gaps = [best.edges] if best is not None else []
    gaps = gaps or [(visit.lower, visit.upper) for visit in seen if visit.is_open(carrier)]
    if not gaps:
        return "no examined design has a gap"
    away, edges = min((max(edges[0] - carrier, carrier - edges[1]), edges) for edges in gaps)
    lower, upper, missed = in_khz(*edges, away)
    if away <= 0:
        return f"the gap {lower} to {upper} kHz contains it only in the coarse model of the search"
    return f"the closest gap, {lower} to {upper} kHz, misses it by {missed} kHz"


def uncomputed(brief: Brief, summit: Visited, failure: HaptonicError) -> HaptonicError:
    """Error if the coarse model has gaps, but none of their designs has a mesh within the limits."""
    values = zip(brief.paths, brief.values(summit.share), strict=True)
    named = ", ".join(f"{path} = {format_quantity(value, brief.links.unit(path))}" for path, value in values)
    lower, upper = in_khz(summit.lower, summit.upper)
    return failure.changed(
        type(failure),
        cause=f"{failure.cause}; none of the examined designs can be computed. The best one, {named}, has "
        f"a gap from {lower} to {upper} kHz in the coarse model",
    )


def in_khz(*frequencies: float) -> list[str]:
    """Frequencies (Hz) in kHz, with enough digits to show that they differ and are not zero."""
    steps = [abs(f) for f in frequencies] + [abs(a - b) for a, b in itertools.combinations(frequencies, 2)]
    steps = [step for step in steps if step]
    digits = min(9, max(2, *(1 - math.floor(math.log10(step / 1e3)) for step in steps))) if steps else 2
    return [f"{frequency / 1e3:.{digits}f}" for frequency in frequencies]
