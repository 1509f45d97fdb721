"""Looking for the design whose gap holds the carrier with the widest margin.

The margin is the distance of the carrier from the nearer edge, as a share of the carrier; negative if the
carrier lies outside. It has kinks wherever one mode takes over from another as the edge, so that a smooth
optimiser would stall. Sequential linear programming does not: every frequency that may become an edge is
replaced by its tangent, and the margin of these is maximised exactly within a step that is trusted.

A climb ends at the nearest summit, and two bands that touch at the carrier are one, of margin zero. So
designs spread over all that is allowed are looked at first, the brief's own being one of them, and climbs
start from open gaps, each from another basin.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import scipy

from haptonic.arrays import Array
from haptonic.design.brief import Brief
from haptonic.design.parameters import HEIGHT
from haptonic.design.quick import CRITICAL, QuickDesign, Side, edges_of

COLUMN = 6  # heights of a foot that are looked at: each costs a third of a new foot
LINES = 64  # heights from which those are chosen
BETWEEN = 12  # heights for which edges are interpolated between two that were looked at
TRIES = 64  # places of the box that are drawn for each column before one is moved to where it is allowed
OPEN = 2e-3  # of the carrier: narrower gaps are bands that touch, seen at too few wavevectors
BEHIND = 10.0  # by which pairs of bands without a gap stand behind all gaps
PULL = 0.5  # how much of a gap's distance from the carrier counts before a climb, which shortens it
DISTINCT = 0.15  # of the box in some parameter, between two starts in the same gap
FIRST_STEP = 0.2  # of the box, in every parameter
LAST_STEP = 4e-3  # of the box: a climb whose steps are shorter has ended
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

    def is_open(self, carrier: float) -> bool:
        """Whether there is a gap at all, and not only bands that touch."""
        return self.upper - self.lower > OPEN * carrier


def promise(lower: Array, upper: Array, pull: float) -> Array:
    """How good gaps between edges (shares of the carrier) are to start from; bands that overlap come last.

    With a ``pull`` of 1 it is the margin of a gap.
    """
    width, away = upper - lower, np.abs(0.5 * (upper + lower) - 1.0)
    return np.where(width > OPEN, 0.5 * width - pull * away, 0.5 * width - away - BEHIND)


@dataclass(frozen=True)
class HeightRow:
    """Edges of designs that differ in the pillars' heights only, or of a single design.

    shares : (designs, parameters); edges : (designs, 2, bands - 1) Hz, as of `edges_of`
    """

    shares: Array
    edges: Array

    @classmethod
    def of(cls, brief: Brief, shares: Array) -> HeightRow:
        """Look at the designs at some places in the box."""
        return cls(shares, np.stack([edges_of(brief.at(share), brief.count) for share in shares]))

    def alone(self) -> list[HeightRow]:
        """Each design as a column of its own."""
        return [HeightRow(s[None], e[None]) for s, e in zip(self.shares, self.edges, strict=True)]

    def finer(self) -> HeightRow:
        """With designs between its own, whose edges are interpolated by their logarithms."""
        own = np.arange(len(self.shares))
        places = np.linspace(0, own[-1], BETWEEN * own[-1] + 1)

        def between(values: Array) -> Array:
            flat = values.reshape(len(own), -1)
            found = [np.interp(places, own, one) for one in flat.T]
            return np.stack(found, axis=1).reshape(len(places), *values.shape[1:])

        return HeightRow(between(self.shares), np.exp(between(np.log(np.maximum(self.edges, 1.0)))))

    def best(self, carrier: float, pull: float = 1.0) -> list[tuple[float, Visited]]:
        """What the best of the designs promises, and that design, for the gap above each band; best first."""
        lower, upper = np.swapaxes(self.edges, 0, 1)
        promises = promise(lower / carrier, upper / carrier, pull)
        margins = np.minimum(carrier - lower, upper - carrier) / carrier
        found = []
        for band, row in enumerate(promises.argmax(axis=0)):
            low, high, margin = (float(values[row, band]) for values in (lower, upper, margins))
            found.append(
                (
                    float(promises[row, band]),
                    Visited(share=self.shares[row], band=band + 1, lower=low, upper=high, margin=margin),
                )
            )
        return sorted(found, key=lambda one: -one[0])


def spread(brief: Brief, count: int, own: Array | None = None) -> list[Array]:
    """About ``count`` allowed designs to look at, as columns of places in the box (designs, parameters).

    ``own``, else the brief's own cell, is in the first; the others are spread evenly (Sobol) over what the
    limits leave.
    """
    own = brief.feasible(brief.share(brief.cell)) if own is None else own
    if count == 1 or not brief.paths:
        return [own[None]]
    if len(brief.paths) == 1 and _heights(brief):
        return [_column(brief, own, count)]
    found = [_column(brief, own, min(COLUMN, count - 1))]
    left = max(count - len(found[0]), 0)
    for share in _drawn(brief, -(-left // (COLUMN if _heights(brief) else 1))):
        column = _column(brief, share, min(left, COLUMN), own=False)
        found.append(column)
        left -= len(column)
    return found


def _drawn(brief: Brief, count: int) -> Iterator[Array]:
    """Evenly spread places with some allowed height; if there are too few, moved to where all is allowed."""
    places = scipy.stats.qmc.Sobol(len(brief.bounds), scramble=False).fast_forward(1)
    tried = places.random(2 ** int(np.ceil(np.log2(max(count, 1) * TRIES))))
    found = 0
    for share in tried:
        if found < count and _allowed(brief, share):
            found += 1
            yield share
    yield from filter(brief.allows, map(brief.feasible, tried[: count - found]))


def _heights(brief: Brief) -> list[int]:
    """Which of the parameters are heights of pillars."""
    return [row for row, path in enumerate(brief.paths) if path.endswith(HEIGHT)]


def _allowed(brief: Brief, share: Array) -> list[Array]:
    """The place itself, or all allowed heights upon the same feet, lowest first; nothing if none is.

    Heights of several pillars grow in proportion.
    """
    rows = _heights(brief)
    if not rows:
        return [share] if brief.allows(share) else []
    (low, high), own = brief.box[rows].T, np.array(brief.values(share))[rows]
    factors = np.geomspace(max(low / own), min(high / own), LINES)
    lines = np.repeat(share[None], LINES, axis=0)
    lines[:, rows] = (factors[:, None] * own - low) / (high - low)
    return [line for line in np.clip(lines, 0.0, 1.0) if brief.allows(line)]


def _column(brief: Brief, share: Array, count: int, *, own: bool = True) -> Array:
    """Some allowed designs with the feet of one place, that place itself among them if it is asked for."""
    allowed, rows = _allowed(brief, share), _heights(brief)
    if not rows or not allowed:
        return share[None]
    found = [allowed[i] for i in sorted(set(np.linspace(0, len(allowed) - 1, count).round().astype(int)))]
    return np.array(sorted(found + [share] * own, key=lambda place: float(place[rows[0]])))


def starts_of(columns: Sequence[HeightRow], carrier: float) -> list[Visited]:
    """Where climbs may start, the most promising first: in every basin that was seen, once."""
    promising = [one for column in columns for one in column.finer().best(carrier, PULL)]
    return distinct([visit for _, visit in sorted(promising, key=lambda one: -one[0])], DISTINCT)


def distinct(visits: Sequence[Visited], apart: float) -> list[Visited]:
    """The visits but for those in the same gap as an earlier one and near it, in shares of the box."""
    chosen: list[Visited] = []
    for visit in visits:
        near = [one for one in chosen if np.abs(visit.share - one.share).max() < apart]
        if all(visit.band != one.band for one in near):
            chosen.append(visit)
    return chosen


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
