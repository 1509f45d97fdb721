"""Looking for the design whose gap holds the carrier with the widest margin.

The margin is the distance of the carrier from the nearer edge, as a share of the carrier; negative if the
carrier lies outside. It has kinks wherever one mode takes over from another as the edge, so that a smooth
optimiser would stall. Sequential linear programming does not: every frequency that may become an edge is
replaced by its tangent, and the margin of these is maximised exactly within a step that is trusted.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import NDArray

from haptonic.design.brief import Brief
from haptonic.design.quick import CRITICAL, QuickDesign, Side

Array = NDArray[np.float64]

FIRST_STEP = 0.2  # of the box, in every parameter
LAST_STEP = 4e-3
TRUSTED = 0.3  # share of the promised gain from which a step may be longer the next time
LEAST_GAIN = 2e-4  # promised, of the carrier, for which another step is worth its cost
NUDGE = 1e-3  # of the box, for differences of the limits


@dataclass(frozen=True)
class Visited:
    """A design on the way.

    share : (parameters,) where it lies in the brief's box; band : number of the band below the gap, from 1
    lower, upper : edges, Hz (crossed over if there is no gap); margin : share of the carrier
    """

    share: Array
    band: int
    lower: float
    upper: float
    margin: float


def starting_points(brief: Brief, count: int) -> list[Array]:
    """The brief's own cell and further designs spread evenly over the box (a Sobol sequence), all allowed."""
    rough = scipy.stats.qmc.Sobol(len(brief.bounds), scramble=False).random_base2(
        max(1, int(np.ceil(np.log2(count + 1))))
    )
    return [brief.feasible(point) for point in (brief.share(brief.cell), *rough[1:count])]


def looked_at(brief: Brief, share: Array) -> Visited:
    """A design without derivatives, with the gap that holds the carrier best."""
    lower, upper = QuickDesign.of(brief.at(share), brief.count).edges()
    margins = np.minimum(brief.carrier - lower, upper - brief.carrier) / brief.carrier
    best = int(margins.argmax())
    return Visited(share, best + 1, float(lower[best]), float(upper[best]), float(margins[best]))


def climb(brief: Brief, start: Array, band: int, offset: tuple[float, float], most: int) -> Iterator[Visited]:
    """Ever better designs from a start, each with the gap above one band; ends when no step helps.

    Parameters
    ----------
    offset : Hz, what to add to the coarse model's edges, lower and upper, to get those of a finer one
    most : designs to compute at most
    """
    here, step = brief.feasible(start), FIRST_STEP
    best, sides = _evaluated(brief, here, band, offset)
    yield best
    for _ in range(most - 1):
        ahead, promised = _best_within(brief, best.share, sides, step)
        if promised - best.margin < LEAST_GAIN or step < LAST_STEP:
            return
        tried, sides_there = _evaluated(brief, brief.feasible(ahead), band, offset)
        gain = (tried.margin - best.margin) / (promised - best.margin)
        step *= 1.6 if gain > TRUSTED else 0.35
        if gain > 0:
            best, sides = tried, sides_there
            yield best


def _evaluated(
    brief: Brief, share: Array, band: int, offset: tuple[float, float]
) -> tuple[Visited, tuple[Array, Array]]:
    """A design, and the room (2 CRITICAL,) between the carrier and the critical frequencies with its slopes
    (2 CRITICAL, parameters), both as shares of the carrier."""
    low, high = QuickDesign.of(brief.at(share), brief.count).sides(band, brief.paths)
    span = np.diff(brief.box, axis=1).ravel()

    def seen(side: Side, sign: int, shift: float) -> tuple[Array, Array]:
        room = sign * (side.frequency + shift - brief.carrier) / brief.carrier
        return room, sign * side.slopes * span / brief.carrier

    below, above = seen(low, -1, offset[0]), seen(high, +1, offset[1])
    room = np.concatenate([below[0], above[0]])
    visited = Visited(
        share=share,
        band=band,
        lower=brief.carrier * (1 - float(below[0].min())),
        upper=brief.carrier * (1 + float(above[0].min())),
        margin=float(room.min()),
    )
    assert len(room) == 2 * CRITICAL
    return visited, (room, np.concatenate([below[1], above[1]]))


def _best_within(brief: Brief, here: Array, sides: tuple[Array, Array], step: float) -> tuple[Array, float]:
    """The place that the tangents prefer within a step, and the margin that they promise there."""
    room, slopes = sides
    limits = np.array(list(brief.limits(here).values()))
    nudged = np.eye(len(here)) * np.where(here > 0.5, -NUDGE, NUDGE)[:, None]
    turns = [np.array(list(brief.limits(here + n).values())) - limits for n in nudged]
    bends = np.stack(turns, axis=1) / nudged.sum(axis=1) if len(limits) else np.empty((0, len(here)))
    # unknowns: the step, and the margin t; room + slopes step >= t and limits + bends step >= 0
    rows = np.vstack([
        np.column_stack([-slopes, np.ones(len(room))]),
        np.column_stack([-bends, np.zeros(len(limits))]),
    ])  # fmt: skip
    ceiling = np.concatenate([room, np.maximum(limits, 0.0)])
    bounds = [(max(-step, -x), min(step, 1 - x)) for x in here]
    result = scipy.optimize.linprog(
        np.append(np.zeros(len(here)), -1.0), rows, ceiling, bounds=[*bounds, (None, None)]
    )
    if result.x is None:
        return here, float(room.min())
    return here + result.x[:-1], float(result.x[-1])
