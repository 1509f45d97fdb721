"""Residuals of a plate's model against its measured response, and their minimisation.

The logarithm of every unknown number varies between two bounds. The search begins with the average spectrum,
whose peaks may be shifted, continues with the logarithm of the magnitude at every point, and ends with the
complex response, for which it minimises

    sum over lines and points of  |w (i omega)^v u(x) - w d|^2

u is the computed displacement with numbers of logarithms x over their starting values, d the measured
response, w its weight, and v is 1 for a velocity, 0 for a displacement.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
import scipy
from numpy.typing import NDArray

from haptonic.arrays import Array, Complex, Ints
from haptonic.plate import Plate
from haptonic.plate.vibration.parameter_family import Family
from haptonic.updating.parameters import changed, values_of
from haptonic.updating.settings import Unknown

Residual = Callable[[Array], Array]

TRIED = 48  # sets of numbers in the search; the best few are improved
IMPROVED = 3
GOOD = 0.1  # unexplained share of the measured energy below which no other start is improved
SMOOTHED = 0.01  # share of the highest frequency over which average spectra are smoothed
FLOOR = 0.03  # of the median amplitude: smaller magnitudes hardly count
STEP = 1e-5  # of a logarithm, for slopes
SURE = 1e-6  # smallest distance of a coherence from 0 and 1
INWARD = 1e-9  # of a logarithm, smallest distance of a start from the bounds


@dataclass(frozen=True, eq=False)
class MeasuredResponse:
    """Measured response that a plate is fitted to.

    frequency : (lines,) Hz
    points : (points, 2) of the flat face, m
    response : (lines, points) normal displacement, or velocity, per unit of the drives
    velocity : True for a velocity
    weight : (lines, points) of its residuals, proportional to 1 / noise; 0 for data that are left out
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
        """Set the weights from the coherence (lines, points), if it was measured; else equal weights.

        The noise of single values is known too inaccurately for weights: the noise of a line times that of a
        point is used.
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
        """Angular frequency, rad/s."""
        return np.asarray(2 * np.pi * self.frequency)

    @property
    def used(self) -> NDArray[np.bool_]:
        """(points,) True for points with weights."""
        return np.asarray(self.weight.any(axis=0))

    def seen(self, displacement: Complex) -> Complex:
        """(lines, points) computed displacement, m, converted to the measured quantity."""
        return np.asarray(1j * self.omega[:, None] * displacement if self.velocity else displacement)

    def without(self, points: Ints) -> MeasuredResponse:
        """A copy in which some points have no weight."""
        weight = self.weight.copy()
        weight[:, points] = 0.0
        return replace(self, weight=weight)

    def unexplained(self, response: Complex) -> float:
        """Share of the measured energy that another response (lines, points) lacks."""
        used = self.used
        missed = (np.abs(response - self.response)[:, used] ** 2).sum()
        return float(missed / (np.abs(self.response)[:, used] ** 2).sum())


@dataclass(frozen=True, eq=False)
class Space:
    """Unknown numbers of a plate, as logarithms over the values that the plate has."""

    plate: Plate
    unknowns: Sequence[Unknown]

    @property
    def start(self) -> Array:
        """(p,) starting values, SI."""
        values = values_of(self.plate)
        return np.array([values[unknown.parameter] for unknown in self.unknowns])

    @property
    def low(self) -> Array:
        """(p,) lower bounds of the logarithms."""
        return np.asarray(np.log([unknown.low for unknown in self.unknowns] / self.start))

    @property
    def high(self) -> Array:
        """(p,) upper bounds of the logarithms."""
        return np.asarray(np.log([unknown.high for unknown in self.unknowns] / self.start))

    def plate_at(self, x: Array) -> Plate:
        """The plate with numbers of these logarithms."""
        values = (self.start * np.exp(x)).tolist()
        return changed(
            self.plate, dict(zip((unknown.parameter for unknown in self.unknowns), values, strict=True))
        )

    def spread(self, count: int) -> Array:
        """(count, p) logarithms spread evenly between the bounds."""
        sequence = scipy.stats.qmc.Sobol(len(self.unknowns), seed=1)
        drawn = sequence.random(1 << (count - 1).bit_length())[:count]
        return np.asarray(self.low + drawn * (self.high - self.low))


@dataclass(frozen=True, eq=False)
class Match:
    """Comparison of a family of plates with a measurement, for logarithms (p,) of a space.

    defect : (lines, points) error of the family's response, as measured; added to it
    """

    space: Space
    family: Family
    data: MeasuredResponse
    defect: Complex | float = 0.0

    def response(self, x: Array) -> Complex:
        """(lines, points) computed response, as measured."""
        poles = self.family.poles(self.space.plate_at(x))
        return np.asarray(self.data.seen(poles.displacement(self.data.omega)) + self.defect)

    def unexplained(self, x: Array) -> float:
        """Share of the measured energy that the computed response lacks."""
        return self.data.unexplained(self.response(x))

    def misfit(self, x: Array) -> Complex:
        """(lines, points used) weighted residuals."""
        used = self.data.used
        return np.asarray((self.data.weight * (self.response(x) - self.data.response))[:, used])

    def jacobian(self, x: Array) -> Complex:
        """(lines, points used, p) derivatives of the weighted residuals."""
        return np.asarray(_slopes(self.misfit)(x), np.complex128)

    def of_complex(self, x: Array) -> Array:
        residuals = self.misfit(x).ravel()
        return np.concatenate([residuals.real, residuals.imag])

    def of_magnitudes(self, x: Array) -> Array:
        used = self.data.used
        measured = np.abs(self.data.response[:, used])
        floor = FLOOR * float(np.median(measured))
        return np.log(np.hypot(np.abs(self.response(x)[:, used]), floor) / np.hypot(measured, floor)).ravel()

    def of_spectra(self, x: Array) -> Array:
        lines, used = self.data.frequency, self.data.used
        width = SMOOTHED * lines[-1] / float(np.median(np.diff(lines)))
        computed, measured = (
            scipy.ndimage.gaussian_filter1d(
                (np.abs(values[:, used]) ** 2).mean(axis=1), width, mode="nearest"
            )
            for values in (self.response(x), self.data.response)
        )
        return np.asarray(0.5 * np.log(computed / measured))

    def improved(self, residual: Residual, x: Array, loss: str = "linear") -> Array:
        """(p,) minimum of the squares of residuals, from a start."""
        low, high = self.space.low, self.space.high
        minimum = scipy.optimize.least_squares(
            residual, np.clip(x, low + INWARD, high - INWARD), _slopes(residual), (low, high),
            x_scale=high - low, loss=loss, xtol=1e-9, ftol=1e-10, gtol=1e-12, max_nfev=60,
        )  # fmt: skip
        return np.asarray(minimum.x)

    def searched(self) -> Array:
        """(p,) best minimum from many starts."""
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
    """Function of central differences (..., p) of residuals (...)."""

    def of(x: Array) -> NDArray[np.inexact]:
        steps = STEP * np.eye(len(x))
        return np.stack([(residual(x + h) - residual(x - h)) / (2 * STEP) for h in steps], axis=-1)

    return of
