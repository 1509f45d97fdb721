"""Quasi-random draws of independent numbers, most of them where something fails, with their weights.

The cumulative probability of every number is divided into intervals, which are fine at both ends. Draws come
from a mixture of proposals. A proposal changes the probabilities of the intervals, not the distribution
inside them, so the weight of a draw is an exact ratio of probabilities, however far in the tail it lies.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import scipy

from haptonic.arrays import Array

_TAIL = np.geomspace(1e-12, 0.5, 60)
ENDS = np.concatenate([[0.0], _TAIL, 1 - _TAIL[-2::-1], [1.0]])  # of the intervals, cumulative probabilities
OWN = np.diff(ENDS)  # probabilities of the intervals
LEANS = np.geomspace(1e-3, 1e13, 120)  # lengths of a direction among which the one for a rate lies


class Divided:
    """Independent bounded distributions, each divided into the same intervals of cumulative probability.

    A proposal is an array (numbers, intervals) of probabilities.
    """

    def __init__(self, distributions: Sequence[scipy.stats.rv_continuous]) -> None:
        self.distributions = tuple(distributions)
        ends = np.array([distribution.ppf(ENDS) for distribution in distributions])
        self.places = 0.5 * (ends[:, 1:] + ends[:, :-1])
        """(numbers, intervals) middles of the intervals."""
        self.own = np.broadcast_to(OWN, self.places.shape)
        """Proposal that is the distribution itself."""
        self.even = np.diff(ends) / (ends[:, -1:] - ends[:, :1])
        """Proposal that fills the ranges evenly."""

    def leaning(self, direction: Array, rate: float) -> Array:
        """Proposal with the probabilities times ``exp(length * direction * deviation)``.

        Parameters
        ----------
        direction : (numbers,), zero for numbers that keep their distribution
        rate : relative entropy of the proposal: its draws are about as rare as ``exp(-rate)``
        """
        largest = np.abs(direction).max(initial=0.0)
        if largest == 0 or rate == 0:
            return self.own
        towards = (direction / largest)[:, None] * self.places

        def leant(lengths: Array) -> Array:
            powers = np.multiply.outer(lengths, towards)
            shares = OWN * np.exp(powers - powers.max(axis=-1, keepdims=True))
            return np.asarray(shares / shares.sum(axis=-1, keepdims=True))

        shares = leant(LEANS)
        rates = scipy.special.rel_entr(shares, OWN).sum(axis=(1, 2))
        return leant(np.exp(np.interp(np.log(rate), np.log(rates), np.log(LEANS))))

    def drawn(self, proposals: Sequence[Array], count: int, seed: int) -> tuple[Array, Array]:
        """(count, numbers) deviations, equally many from each proposal, and (count,) weights of mean one.

        Averages with the weights are those of the distributions.
        """
        each = count // len(proposals)
        points = sobol(len(self.distributions), count, seed)
        places, chosen = np.empty_like(points), np.empty(points.shape, dtype=int)
        for part, shares in enumerate(proposals):
            rows = slice(part * each, (part + 1) * each)
            for number, ends in enumerate(np.cumsum(shares, axis=1)):
                ends = np.concatenate([[0.0], ends / ends[-1]])
                chosen[rows, number] = np.clip(
                    np.searchsorted(ends, points[rows, number]) - 1, 0, len(OWN) - 1
                )
                places[rows, number] = np.interp(points[rows, number], ends, ENDS)
        with np.errstate(divide="ignore"):
            ratios = np.log(np.array(proposals) / OWN)  # (proposals, numbers, intervals)
        powers = np.take_along_axis(ratios, chosen.T[None], axis=2).sum(axis=1)
        weights = np.exp(-scipy.special.logsumexp(powers, axis=0, b=1 / len(proposals)))
        deviations = [d.ppf(p) for d, p in zip(self.distributions, places.T, strict=True)]
        return np.column_stack(deviations), weights


def sobol(parameters: int, count: int, seed: int = 0) -> Array:
    """(count, parameters) points of the unit cube."""
    power = int(np.ceil(np.log2(count)))
    return np.asarray(scipy.stats.qmc.Sobol(parameters, rng=seed).random_base2(power)[:count])
