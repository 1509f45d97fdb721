"""Search for the design whose gap contains the carrier with the widest margin.

The margin is the distance of the carrier from the nearer edge, as a share of the carrier; negative if the
carrier lies outside. It has kinks where another mode becomes the edge, so a smooth optimiser would stall.
Sequential linear programming does not: it replaces every frequency that may become an edge by its tangent,
and maximises the margin of the tangents exactly within a trust region.

A climb ends at the nearest maximum, and two bands that touch at the carrier are such a maximum, of margin
zero. Therefore the search first tries designs spread over all that is allowed, including the brief's own, and
climbs start from open gaps, each in another basin.
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

COLUMN = 6  # heights tried on each foot: each costs a third of a new foot
LINES = 64  # heights from which those are chosen
BETWEEN = 12  # interpolated heights between two computed ones
TRIES = 64  # positions of the box drawn for each column, before one is moved to where it is allowed
OPEN = 2e-3  # of the carrier: narrower gaps are touching bands, sampled at too few wavevectors
BEHIND = 10.0  # penalty that ranks pairs of bands without a gap behind all gaps
PULL = 0.5  # weight of a gap's distance from the carrier before a climb, which shortens it
MORE_CLIMBS = 3  # factor on the number of climbs if none has reached the carrier
DISTINCT = 0.15  # of the box: smallest distance in some parameter between two starts in the same gap
FIRST_STEP = 0.2  # of the box, in every parameter
LAST_STEP = 4e-3  # of the box: a climb with shorter steps ends
TRUSTED = 0.3  # share of the predicted gain from which the next step may be longer
LEAST_GAIN = 2e-4  # of the carrier: a smaller predicted gain is not worth another step
NUDGE = 1e-3  # of the box, for differences of the limits


@dataclass(frozen=True)
class Visited:
    """A design that the search has computed.

    share : (parameters,) position in the brief's box
    band : number of the band below the gap, from 1
    lower, upper : edges, Hz (in reverse order if there is no gap)
    margin : share of the carrier
    """

    share: Array
    band: int
    lower: float
    upper: float
    margin: float

    def is_open(self, carrier: float) -> bool:
        """True if there is a gap, and not only touching bands."""
        return self.upper - self.lower > OPEN * carrier


def promise(lower: Array, upper: Array, pull: float) -> Array:
    """Rank of gaps between edges (shares of the carrier) as starts; overlapping bands come last.

    With a ``pull`` of 1 it is the margin of a gap.
    """
    width, away = upper - lower, np.abs(0.5 * (upper + lower) - 1.0)
    return np.where(width > OPEN, 0.5 * width - pull * away, 0.5 * width - away - BEHIND)


@dataclass(frozen=True)
class HeightRow:
    """Edges of designs that differ only in the heights of the pillars, or of a single design.

    shares : (designs, parameters)
    edges : (designs, 2, bands - 1) Hz, from `edges_of`
    """

    shares: Array
    edges: Array

    @classmethod
    def of(cls, brief: Brief, shares: Array) -> HeightRow:
        """Compute the edges of the designs at some positions in the box."""
        return cls(shares, np.stack([edges_of(brief.at(share), brief.count) for share in shares]))

    def alone(self) -> list[HeightRow]:
        """Split into a row for each design."""
        return [HeightRow(s[None], e[None]) for s, e in zip(self.shares, self.edges, strict=True)]

    def finer(self) -> HeightRow:
        """Add designs between the computed ones, with edges interpolated by their logarithms."""
        numbers = np.arange(len(self.shares))
        places = np.linspace(0, numbers[-1], BETWEEN * numbers[-1] + 1)

        def between(values: Array) -> Array:
            flat = values.reshape(len(numbers), -1)
            columns = [np.interp(places, numbers, column) for column in flat.T]
            return np.stack(columns, axis=1).reshape(len(places), *values.shape[1:])

        return HeightRow(between(self.shares), np.exp(between(np.log(np.maximum(self.edges, 1.0)))))

    def best(self, carrier: float, pull: float = 1.0) -> list[tuple[float, Visited]]:
        """Rank and design of the best start for the gap above each band; best first."""
        lower, upper = np.swapaxes(self.edges, 0, 1)
        promises = promise(lower / carrier, upper / carrier, pull)
        margins = np.minimum(carrier - lower, upper - carrier) / carrier
        starts = []
        for band, row in enumerate(promises.argmax(axis=0)):
            low, high, margin = (float(values[row, band]) for values in (lower, upper, margins))
            starts.append(
                (
                    float(promises[row, band]),
                    Visited(share=self.shares[row], band=band + 1, lower=low, upper=high, margin=margin),
                )
            )
        return sorted(starts, key=lambda start: -start[0])


def spread(brief: Brief, count: int, own: Array | None = None) -> list[Array]:
    """About ``count`` allowed designs to try, as columns of positions in the box (designs, parameters).

    The first column contains ``own``, or else the brief's own cell; the others are spread evenly (Sobol) over
    the allowed part of the box.
    """
    own = brief.feasible(brief.share(brief.cell)) if own is None else own
    if count == 1 or not brief.paths:
        return [own[None]]
    if len(brief.paths) == 1 and _heights(brief):
        return [_column(brief, own, count)]
    columns = [_column(brief, own, min(COLUMN, count - 1))]
    left = max(count - len(columns[0]), 0)
    for share in _drawn(brief, -(-left // (COLUMN if _heights(brief) else 1))):
        column = _column(brief, share, min(left, COLUMN), own=False)
        columns.append(column)
        left -= len(column)
    return columns


def _drawn(brief: Brief, count: int) -> Iterator[Array]:
    """Evenly spread positions with an allowed height; if too few, positions moved to allowed ones."""
    places = scipy.stats.qmc.Sobol(len(brief.bounds), scramble=False).fast_forward(1)
    tried = places.random(2 ** int(np.ceil(np.log2(max(count, 1) * TRIES))))
    accepted = 0
    for share in tried:
        if accepted < count and _allowed(brief, share):
            accepted += 1
            yield share
    yield from filter(brief.allows, map(brief.feasible, tried[: count - accepted]))


def _heights(brief: Brief) -> list[int]:
    """Indices of the parameters that are heights of pillars."""
    return [row for row, path in enumerate(brief.paths) if path.endswith(HEIGHT)]


def _allowed(brief: Brief, share: Array) -> list[Array]:
    """The position itself, or all allowed heights on the same feet, lowest first; may be empty.

    Heights of several pillars grow in proportion.
    """
    rows = _heights(brief)
    if not rows:
        return [share] if brief.allows(share) else []
    (low, high), heights = brief.box[rows].T, np.array(brief.values(share))[rows]
    factors = np.geomspace(max(low / heights), min(high / heights), LINES)
    places = np.repeat(share[None], LINES, axis=0)
    places[:, rows] = (factors[:, None] * heights - low) / (high - low)
    return [place for place in np.clip(places, 0.0, 1.0) if brief.allows(place)]


def _column(brief: Brief, share: Array, count: int, *, own: bool = True) -> Array:
    """Some allowed designs with the feet of one position; with ``own``, the position itself too."""
    allowed, rows = _allowed(brief, share), _heights(brief)
    if not rows or not allowed:
        return share[None]
    chosen = [allowed[i] for i in sorted(set(np.linspace(0, len(allowed) - 1, count).round().astype(int)))]
    return np.array(sorted(chosen + [share] * own, key=lambda place: float(place[rows[0]])))


def starts_of(columns: Sequence[HeightRow], carrier: float) -> list[Visited]:
    """Starts of climbs, the most promising first: one in every basin of the tried designs."""
    promising = [start for column in columns for start in column.finer().best(carrier, PULL)]
    return distinct([visit for _, visit in sorted(promising, key=lambda start: -start[0])], DISTINCT)


def begun_from(starts: Sequence[Visited], carrier: float, climbs: int) -> list[Visited]:
    """Starts of all climbs that a search may need, ``climbs`` at a time, from the starts in their order.

    Bands that overlap come last, as at least ``climbs`` of all: they may part on the way. With a coated disc
    all open starts were bands that touch; from bands that overlapped by 2 % a climb found a gap of 18 %.
    """
    opened = [start for start in starts if start.is_open(carrier)][: MORE_CLIMBS * climbs]
    overlapping = [start for start in starts if not start.is_open(carrier)]
    return opened + overlapping[: max(MORE_CLIMBS * climbs - len(opened), climbs)]


def distinct(visits: Sequence[Visited], apart: float) -> list[Visited]:
    """The visits without those near an earlier one in the same gap; distances in shares of the box."""
    chosen: list[Visited] = []
    for visit in visits:
        near = [other for other in chosen if np.abs(visit.share - other.share).max() < apart]
        if all(visit.band != other.band for other in near):
            chosen.append(visit)
    return chosen


def climb(
    brief: Brief, start: Array, band: int, offset: tuple[float, float], most: int
) -> tuple[list[Visited], bool]:
    """Improve a design step by step for the gap above one band, until no step helps.

    Parameters
    ----------
    offset : Hz, difference of a finer model's edges from the coarse model's, lower and upper
    most : largest number of designs to compute

    Returns
    -------
    the designs, and True if no step helps the last one any more
    """
    here, step = brief.feasible(start), FIRST_STEP
    best, sides = _evaluated(brief, here, band, offset)
    better = [best]
    for left in range(most - 1, -1, -1):
        ahead, predicted = _best_within(brief, best.share, sides, step)
        if predicted - best.margin < LEAST_GAIN or step < LAST_STEP:
            return better, True
        if not left:
            break
        tried, sides_there = _evaluated(brief, brief.feasible(ahead), band, offset)
        gain = (tried.margin - best.margin) / (predicted - best.margin)
        step *= 1.6 if gain > TRUSTED else 0.35
        if gain > 0:
            best, sides = tried, sides_there
            better.append(best)
    return better, False


def _evaluated(
    brief: Brief, share: Array, band: int, offset: tuple[float, float]
) -> tuple[Visited, tuple[Array, Array]]:
    """A design, and the room (2 CRITICAL,) between the carrier and the critical frequencies with its slopes
    (2 CRITICAL, parameters), both as shares of the carrier."""
    quick = QuickDesign.of(brief.at(share), brief.count)
    low, high = quick.sides(band, brief.paths, brief.directions(share))
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
    """The best position within a step by the tangents, and the margin that they predict there."""
    room, slopes = sides
    limits = np.array(list(brief.limits(here).values()))
    nudged = np.eye(len(here)) * np.where(here > 0.5, -NUDGE, NUDGE)[:, None]
    changes = [np.array(list(brief.limits(here + n).values())) - limits for n in nudged]
    gradients = np.stack(changes, axis=1) / nudged.sum(axis=1) if len(limits) else np.empty((0, len(here)))
    # unknowns: the step, and the margin t; room + slopes step >= t and limits + gradients step >= 0
    rows = np.vstack([
        np.column_stack([-slopes, np.ones(len(room))]),
        np.column_stack([-gradients, np.zeros(len(limits))]),
    ])  # fmt: skip
    ceiling = np.concatenate([room, np.maximum(limits, 0.0)])
    bounds = [(max(-step, -x), min(step, 1 - x)) for x in here]
    result = scipy.optimize.linprog(
        np.append(np.zeros(len(here)), -1.0), rows, ceiling, bounds=[*bounds, (None, None)]
    )
    if result.x is None:
        return here, float(room.min())
    return here + result.x[:-1], float(result.x[-1])
