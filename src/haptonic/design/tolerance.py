"""Probability that a gap contains the carrier when plates and pillars differ.

The two bands next to the gap are fitted, at every wavevector of a sampling of the zone, by a quadratic in all
varying parameters, on fully computed designs of a quasi-random sequence. The edges are the highest and the
lowest of the fits, so that the wavevector of an edge may change. Designs left out of the fit give its error.
Probabilities, indices and the loosest tolerance are computed from the fit.

A number that varies between pillars is treated pillar by pillar: each pillar has the gap of a lattice of
equal pillars, and every one on the plate has to keep the margin. That is stricter than an average over
pillars.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Annotated, Literal

import numpy as np
import scipy
from pydantic import Field

from haptonic.arrays import Array, Bools
from haptonic.design.parameters import FEATURE, OfCell
from haptonic.design.rare import Divided, sobol
from haptonic.fields import FASTEST, Quantity, described, needed, once, problem, setting
from haptonic.units import format_quantity

CUT = 3.0  # standard deviations at which normal spreads are cut off
REACH = 2.0  # the fit is valid for spreads up to this many times those given
DRAWS = 2**14  # of the quasi-random sequence, of edges and of single pillars
PILLAR_DRAWS, PLATE_DRAWS = 2**10, 2**9  # draws of pillars, all for each of fewer draws of the plate
RARE = float(np.log(1e4))  # logarithm of plates among which one that fails is resolved


@described("tolerance.of")
class Spread(OfCell):
    """Variation of a number of the cell between plates, or between pillars."""

    spread: float = needed(
        "Standard deviation of a normal, half-width of a uniform distribution.", examples=["20 um"]
    )
    distribution: Literal["normal", "uniform"] = setting(
        "normal", "Normal ones are cut off at three deviations."
    )
    per: Literal["batch", "pillar"] = setting(
        "batch", "batch: all pillars or discs of a plate vary together; pillar: each varies by itself."
    )

    def __post_init__(self) -> None:
        if not self.spread > 0:
            raise problem(
                "out-of-range",
                format_quantity(self.spread, self.unit),
                "a positive spread",
                "it is zero or has the wrong sign",
                "give a positive one, or leave it out",
                at="spread",
            )
        if self.per == "pillar" and not FEATURE.search(self.parameter):
            raise problem(
                "conflict",
                self.parameter,
                'per = "batch" for a number that is not of a pillar or disc',
                "pillars of one plate have it in common",
                'write per = "batch"',
                at="per",
            )

    @property
    def is_machined(self) -> bool:
        """True for sizes and angles, which depend on the workshop."""
        return self.unit in ("m", "rad")

    @property
    def half_range(self) -> float:
        """Largest deviation, SI."""
        return self.spread * (CUT if self.distribution == "normal" else 1.0)

    @property
    def variance(self) -> float:
        """Variance of the deviation, SI squared."""
        return float(self.frozen.var()) * self.spread**2

    @property
    def frozen(self) -> scipy.stats.rv_continuous:
        """Distribution of the deviation in units of ``spread``."""
        return (
            scipy.stats.truncnorm(-CUT, CUT)
            if self.distribution == "normal"
            else scipy.stats.uniform(-1.0, 2.0)
        )


@described("tolerance", kw_only=True)
class ToleranceSettings:
    """Spreads of the parts, and the share of plates whose gap has to contain the carrier."""

    of: tuple[Spread, ...] = setting(
        (), "Numbers that vary, and by how much.", title="Spreads", max_length=12
    )
    margin: Annotated[float, Quantity("Hz", at_least=0.0, at_most=FASTEST)] = setting(
        0.0, "Least distance of the carrier from the gap's edges."
    )
    confidence: Annotated[float, Quantity("", above=0.0, below=1.0, typical=(0.9, 0.9999))] = setting(
        0.99, "Share of plates that have to keep the margin."
    )
    pillars: Annotated[int, Field(ge=1, le=10**7, strict=True)] = setting(
        180, "Number of pillars on a plate; each has to keep the margin."
    )
    samples: Annotated[int, Field(ge=16, le=4096, strict=True)] = setting(64, "Designs that are computed.")

    def __post_init__(self) -> None:
        once(self.of, "of")


@dataclass(frozen=True)
class Surface:
    """The bands next to a gap as quadratics of deviations in units of the spreads' widths.

    coefficients : (terms, 2, k) Hz, of the band below and the band above at k wavevectors
    doubt : (2,) Hz, rms difference between the edges of designs left out of the fit and their fitted edges
    """

    coefficients: Array
    doubt: Array

    @classmethod
    def fitted(cls, deviations: Array, frequency: Array) -> Surface:
        """Least squares over (n, parameters) deviations and (n, 2, k) frequencies in Hz."""
        terms = _terms(deviations)
        assert len(terms) > terms.shape[1], "too few samples for a quadratic"
        turn, triangle = np.linalg.qr(terms)
        flat = frequency.reshape(len(terms), -1)
        coefficients = np.linalg.solve(triangle, turn.T @ flat)
        leverage = (turn**2).sum(axis=1)
        missed = (flat - terms @ coefficients) / (1 - leverage)[:, None]
        left_out = edges_of((flat - missed).reshape(frequency.shape))
        doubt = np.sqrt(((edges_of(frequency) - left_out) ** 2).mean(axis=0))
        return cls(coefficients.reshape(-1, *frequency.shape[1:]), np.asarray(doubt))

    def at(self, deviations: Array) -> Array:
        """(n, 2) edges, Hz."""
        return edges_of(np.tensordot(_terms(deviations), self.coefficients, axes=1))

    def of_pairs(self, plates: Array, pillars: Array) -> Iterator[Array]:
        """(pillars, 2) edges, Hz, for each of (plates, parameters) deviations plus those of all pillars."""
        count = plates.shape[1]
        i, j = np.triu_indices(count)
        forms = np.zeros((count, count, *self.coefficients.shape[1:]))
        forms[i, j] = self.coefficients[1 + count :]
        slopes = self.coefficients[1 : 1 + count] + np.tensordot(plates, forms + forms.swapaxes(0, 1), axes=1)
        alone = np.tensordot(_terms(plates), self.coefficients, axes=1)
        of_pillars = np.tensordot(_terms(pillars)[:, 1 + count :], self.coefficients[1 + count :], axes=1)
        for plate, slope in zip(alone, slopes, strict=True):
            yield edges_of(plate + np.tensordot(pillars, slope, axes=1) + of_pillars)

    def leading(self, deviations: Array) -> Surface:
        """The same edges with only those bands that are an edge at one of (n, parameters) deviations."""
        frequency = np.tensordot(_terms(deviations), self.coefficients, axes=1)
        kept = np.union1d(frequency[:, 0].argmax(axis=1), frequency[:, 1].argmin(axis=1))
        return Surface(self.coefficients[:, :, kept], self.doubt)


def edges_of(frequency: Array) -> Array:
    """(n, 2) highest frequency of the band below and lowest of the band above, from (n, 2, k)."""
    return np.stack([frequency[:, 0].max(axis=1), frequency[:, 1].min(axis=1)], axis=1)


def terms_needed(parameters: int) -> int:
    """Number of coefficients of a quadratic."""
    return (parameters + 1) * (parameters + 2) // 2


def _terms(deviations: Array) -> Array:
    """(n, terms) constant, linear and quadratic monomials."""
    i, j = np.triu_indices(deviations.shape[1])
    pairs = deviations[:, i] * deviations[:, j]
    return np.column_stack([np.ones(len(deviations)), deviations, pairs])


@dataclass(frozen=True)
class Chances:
    """Probabilities of a fitted gap for a carrier.

    carrier, margin : Hz
    pillars : number on a plate
    narrowed : Hz, by which both edges of the gap are moved inwards, as by their errors
    """

    surface: Surface
    spreads: tuple[Spread, ...]
    carrier: float
    margin: float
    pillars: int
    narrowed: tuple[float, float] = (0.0, 0.0)

    @cached_property
    def _divided(self) -> Divided:
        return Divided([s.frozen for s in self.spreads])

    @cached_property
    def _draws(self) -> Array:
        """(DRAWS, parameters) deviations in units of the widths."""
        return self.drawn(DRAWS)

    def drawn(self, count: int, seed: int = 1) -> Array:
        """(count, parameters) deviations in units of the spreads' widths."""
        places = np.clip(sobol(len(self.spreads), count, seed), 1e-9, 1 - 1e-9)
        return np.column_stack([s.frozen.ppf(p) for s, p in zip(self.spreads, places.T, strict=True)])

    def room(self, deviations: Array) -> Array:
        """(n,) distance of the carrier from the nearer edge, less the margin, Hz."""
        return self._room(self.surface.at(deviations))

    def _room(self, edges: Array) -> Array:
        lower, upper = edges.T
        up, down = self.narrowed
        room = np.minimum(self.carrier - (lower + up), upper - down - self.carrier)
        return np.asarray(room - self.margin)

    def of_one_pillar(self) -> float:
        """Probability that a lattice of any one pillar of any one plate keeps the margin."""
        return replace(self, pillars=1).of_a_plate()

    def of_a_plate(self, scale: float = 1.0) -> float:
        """Probability that all pillars of a plate keep the margin, with machined spreads times ``scale``."""
        scales = np.array([scale if s.is_machined else 1.0 for s in self.spreads])
        by_pillar, pillars = np.array([s.per == "pillar" for s in self.spreads]), self.pillars
        if pillars == 1 or not by_pillar.any():  # all plates are then drawn as single pillars of one plate
            by_pillar, pillars = np.ones_like(by_pillar), 1
        proposals = self._near_failure(scales, by_pillar, pillars)

        def drawn(varied: Bools, count: int, seed: int) -> tuple[Array, Array]:
            if not varied.any():
                return np.zeros((1, len(scales))), np.ones(1)
            own = self._divided.own
            each = [np.where(varied[:, None], proposal, own) for proposal in proposals]
            deviations, weights = self._divided.drawn(each, count, seed)
            return deviations * varied * scales, weights

        own, shares = drawn(~by_pillar, PLATE_DRAWS, 1)
        others, weights = drawn(by_pillar, DRAWS if by_pillar.all() else PILLAR_DRAWS, 2)
        joint = drawn(np.ones_like(by_pillar), PILLAR_DRAWS, 3)[0]
        rooms = map(self._room, self.surface.leading(joint).of_pairs(own, others))
        failing = np.array([np.average(room < 0, weights=weights) for room in rooms])
        with np.errstate(divide="ignore"):
            keeping = np.exp(pillars * np.log1p(-failing))
        return float(np.average(keeping, weights=shares))

    def _near_failure(self, scales: Array, by_pillar: Bools, pillars: int) -> list[Array]:
        """Proposals for draws: the distribution itself, even ones, and ones that lean to either edge.

        They reach the worst pillar of a plate, and that of the worst of as many plates as `RARE` means.
        """
        divided = self._divided
        proposals = [divided.own, divided.even]
        for side, rare in itertools.product((0, 1), (0.0, 0.5 * RARE, RARE)):
            leaning = divided.own
            for _ in range(3):  # the slopes change with the deviations
                means = (leaning * divided.places).sum(axis=1)
                towards = self._slopes(means * scales)[:, side] * scales * (-1 if side else 1)
                leaning = np.where(
                    by_pillar[:, None],
                    divided.leaning(towards * by_pillar, rare + float(np.log(pillars))),
                    divided.leaning(towards * ~by_pillar, rare),
                )
            proposals.append(leaning)
        return proposals

    def _slopes(self, deviations: Array) -> Array:
        """(parameters, 2) derivatives of the edges at (parameters,) deviations, Hz per width."""
        step = 1e-3 * np.eye(len(deviations))
        return (self.surface.at(deviations + step) - self.surface.at(deviations - step)) / 2e-3

    def loosest(self, confidence: float) -> float | None:
        """Largest factor on all machined spreads, up to `REACH`, at which plates keep the margin, or 0.

        None if no spread is machined.
        """
        if not any(s.is_machined for s in self.spreads):
            return None
        if self.of_a_plate(0.0) < confidence:
            return 0.0
        if self.of_a_plate(REACH) >= confidence:
            return REACH
        low, high = 0.0, REACH
        for _ in range(12):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if self.of_a_plate(middle) >= confidence else (low, middle)
        return low

    def deviations(self) -> Array:
        """(2,) standard deviations of the lower and the upper edge, Hz."""
        return np.asarray(self.surface.at(self._draws).std(axis=0))

    def importance(self) -> Array:
        """(parameters, 2) total Sobol indices of the lower and the upper edge (SciPy)."""
        indices = scipy.stats.sobol_indices(
            func=lambda x: self.surface.at(x.T).T, n=2**11, dists=[s.frozen for s in self.spreads], rng=1
        )
        return np.asarray(indices.total_order).reshape(2, -1).T  # SciPy drops the axis of a single parameter


def first_order(slopes: Array, spreads: Sequence[Spread]) -> Array:
    """(parameters, 2) variances of both edges, Hz^2, from their slopes (parameters, 2) in Hz per SI unit."""
    return np.asarray(slopes**2 * np.array([s.variance for s in spreads])[:, None])
