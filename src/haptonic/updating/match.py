"""Residuals of a plate against its measured response, and how they are made small.

The logarithm of every unknown number is varied between two bounds. The search begins with the average
spectrum, whose peaks may lie elsewhere, goes on with the logarithm of the magnitude at every point, and ends
with the complex response, for which it makes

    sum over lines and points of  |w (i omega)^v u(x) - w d|^2

least: u is the computed displacement with numbers of logarithms x over their starting values, d what was
measured, w its weight, and v is 1 for a velocity, 0 for a displacement.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
import scipy
from numpy.typing import NDArray

from haptonic.arrays import Array, Complex, Ints
from haptonic.plate import Plate
from haptonic.plate.family import Family
from haptonic.updating.parameters import changed, values_of
from haptonic.updating.settings import Unknown

Residual = Callable[[Array], Array]

TRIED = 48  # sets of numbers of which the best few are improved
IMPROVED = 3
GOOD = 0.1  # share of the measured energy left unexplained, below which no other start is improved
SMOOTHED = 0.01  # share of the highest frequency over which average spectra are smoothed
FLOOR = 0.03  # share of the median amplitude below which magnitudes hardly count
STEP = 1e-5  # of a logarithm, for slopes
SURE = 1e-6  # of a coherence, by which it stays away from 0 and 1
INWARD = 1e-9  # of a logarithm, by which a start lies within the bounds


@dataclass(frozen=True, eq=False)
class MeasuredResponse:
    """What a plate is fitted to.

    frequency : (lines,) Hz; points : (points, 2) of the flat face, m
    response : (lines, points) normal displacement, or velocity, per unit of the drives
    velocity : which of them
    weight : (lines, points) of its residuals, in proportion to 1 / noise; 0 for what does not count
    drives : complex amplitudes by name, V or N
    """

    frequency: Array
    points: Array
    response: Complex
    velocity: bool
    weight: Array
    drives: Mapping[str, complex]

    @classmethod
    def of(
        cls,
        frequency: Array,
        points: Array,
        response: Complex,
        velocity: bool,
        drives: Mapping[str, complex],
        coherence: Array | None = None,
    ) -> MeasuredResponse:
        """With weights from the coherence (lines, points), if it was measured; else all alike.

        The noise of single values is known too badly to weigh them: that of a line times that of a point is
        taken.
        """
        power = np.abs(response) ** 2
        noise = np.full(power.shape, float(power.mean()))
        if coherence is not None:
            square = np.clip(coherence, SURE, 1 - SURE)
            every = power * (1 - square) / square
            noise = np.outer(every.mean(axis=1), every.mean(axis=0)) / every.mean()
        return cls(
            frequency=frequency,
            points=points,
            response=response,
            velocity=velocity,
            weight=1 / np.sqrt(noise),
            drives=drives,
        )

    @property
    def omega(self) -> Array:
        """rad/s"""
        return np.asarray(2 * np.pi * self.frequency)

    @property
    def used(self) -> NDArray[np.bool_]:
        """(points,) those that count."""
        return np.asarray(self.weight.any(axis=0))

    def seen(self, displacement: Complex) -> Complex:
        """(lines, points) computed displacement, m, as what was measured."""
        return np.asarray(1j * self.omega[:, None] * displacement if self.velocity else displacement)

    def without(self, points: Ints) -> MeasuredResponse:
        """Without some points, which get no weight."""
        weight = self.weight.copy()
        weight[:, points] = 0.0
        return replace(self, weight=weight)

    def unexplained(self, response: Complex) -> float:
        """Share of the measured energy that another response (lines, points) does not have."""
        used = self.used
        missed = (np.abs(response - self.response)[:, used] ** 2).sum()
        return float(missed / (np.abs(self.response)[:, used] ** 2).sum())


@dataclass(frozen=True, eq=False)
class Space:
    """Unknown numbers of a plate, which itself has their starting values, as logarithms over these."""

    plate: Plate
    unknowns: Sequence[Unknown]

    @property
    def start(self) -> Array:
        """(p,) SI."""
        values = values_of(self.plate)
        return np.array([values[one.parameter] for one in self.unknowns])

    @property
    def low(self) -> Array:
        """(p,)"""
        return np.asarray(np.log([one.low for one in self.unknowns] / self.start))

    @property
    def high(self) -> Array:
        """(p,)"""
        return np.asarray(np.log([one.high for one in self.unknowns] / self.start))

    def plate_at(self, x: Array) -> Plate:
        """The plate with other numbers."""
        values = (self.start * np.exp(x)).tolist()
        return changed(self.plate, dict(zip((one.parameter for one in self.unknowns), values, strict=True)))

    def spread(self, count: int) -> Array:
        """(count, p) logarithms spread evenly between the bounds."""
        sequence = scipy.stats.qmc.Sobol(len(self.unknowns), seed=1)
        drawn = sequence.random(1 << (count - 1).bit_length())[:count]
        return np.asarray(self.low + drawn * (self.high - self.low))


@dataclass(frozen=True, eq=False)
class Match:
    """A family of plates against a measurement, as functions of the logarithms (p,) of a space.

    defect : (lines, points) what the family's response lacks, as measured
    """

    space: Space
    family: Family
    data: MeasuredResponse
    defect: Complex | float = 0.0

    def response(self, x: Array) -> Complex:
        """(lines, points) as measured."""
        poles = self.family.poles(self.space.plate_at(x))
        return np.asarray(self.data.seen(poles.displacement(self.data.omega)) + self.defect)

    def unexplained(self, x: Array) -> float:
        """Share of the measured energy."""
        return self.data.unexplained(self.response(x))

    def misfit(self, x: Array) -> Complex:
        """(lines, points used) weighted residuals."""
        used = self.data.used
        return np.asarray((self.data.weight * (self.response(x) - self.data.response))[:, used])

    def jacobian(self, x: Array) -> Complex:
        """(lines, points used, p) slopes of these."""
        return np.asarray(_slopes(self.misfit)(x), np.complex128)

    def of_complex(self, x: Array) -> Array:
        found = self.misfit(x).ravel()
        return np.concatenate([found.real, found.imag])

    def of_magnitudes(self, x: Array) -> Array:
        used = self.data.used
        measured = np.abs(self.data.response[:, used])
        floor = FLOOR * float(np.median(measured))
        return np.log(np.hypot(np.abs(self.response(x)[:, used]), floor) / np.hypot(measured, floor)).ravel()

    def of_spectra(self, x: Array) -> Array:
        lines, used = self.data.frequency, self.data.used
        width = SMOOTHED * lines[-1] / float(np.median(np.diff(lines)))
        one, other = (
            scipy.ndimage.gaussian_filter1d(
                (np.abs(values[:, used]) ** 2).mean(axis=1), width, mode="nearest"
            )
            for values in (self.response(x), self.data.response)
        )
        return np.asarray(0.5 * np.log(one / other))

    def improved(self, residual: Residual, x: Array, loss: str = "linear") -> Array:
        """(p,) where the squares of residuals are least, from a start."""
        low, high = self.space.low, self.space.high
        found = scipy.optimize.least_squares(
            residual, np.clip(x, low + INWARD, high - INWARD), _slopes(residual), (low, high),
            x_scale=high - low, loss=loss, xtol=1e-9, ftol=1e-10, gtol=1e-12, max_nfev=60,
        )  # fmt: skip
        return np.asarray(found.x)

    def searched(self) -> Array:
        """(p,) from the best of many starts."""
        tried = [np.zeros(len(self.space.unknowns)), *self.space.spread(TRIED)]
        tried.sort(key=lambda x: float((self.of_spectra(x) ** 2).sum()))
        ends: list[Array] = []
        for x in tried[:IMPROVED]:
            near = self.improved(self.of_magnitudes, x, "soft_l1")
            ends.append(self.improved(self.of_complex, near))
            if self.unexplained(ends[-1]) < GOOD:
                break
        return min(ends, key=self.unexplained)


def _slopes(residual: Callable[[Array], NDArray[np.inexact]]) -> Callable[[Array], NDArray[np.inexact]]:
    """Central differences (..., p) of residuals (...)."""

    def of(x: Array) -> NDArray[np.inexact]:
        steps = STEP * np.eye(len(x))
        return np.stack([(residual(x + h) - residual(x - h)) / (2 * STEP) for h in steps], axis=-1)

    return of
