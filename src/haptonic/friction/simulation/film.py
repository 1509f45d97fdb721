"""Remaining friction at given amplitudes, over the forces with which people press."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import scipy

from haptonic.arrays import Array
from haptonic.errors import FrictionError
from haptonic.friction.lubrication import Fingertip, Touch, shared_friction
from haptonic.units import format_quantity

LIGHTEST = 0.2  # N: smallest force of a participant who follows instructions
WIDEST = 4.0  # standard deviations from the mean force; beyond, the curve is level
FORCES = 41  # of a curve
AMPLITUDES = np.geomspace(0.01e-6, 20e-6, 120)  # m, amplitudes that may explain a reduction
USUAL = Fingertip()
QUANTILES = (np.arange(400) + 0.5) / 400


@dataclass(frozen=True, eq=False)
class Film:
    """mu / mu0 of every waveguide against the normal force of a stroke, by load sharing.

    amplitude : waveguide -> m
    force : (force,) N
    remaining : waveguide -> (force,)
    mean : waveguide -> mu / mu0, mean over the forces with which people press
    """

    amplitude: Mapping[str, float]
    force: Array
    remaining: Mapping[str, Array]
    mean: Mapping[str, float]

    def relative(self, waveguide: str, force: float) -> float:
        """Remaining friction at this force, over its mean."""
        left = np.interp(force, self.force, self.remaining[waveguide])
        return float(left / self.mean[waveguide])


def film_of(
    amplitude: Mapping[str, float],
    frequency: float,
    force: tuple[float, float],
    skin: Fingertip = USUAL,
) -> Film:
    """Remaining friction of every waveguide at its amplitude, against the force.

    Parameters
    ----------
    amplitude : waveguide -> of displacement, zero to peak, m
    frequency : Hz
    force : (mean, standard deviation) over strokes, N; `LIGHTEST` is the smallest force
    skin : the same for all people

    Raises
    ------
    FrictionError : invalid amplitudes, or forces at which no film carries the finger
    """
    forces = _forces(force)
    names = list(amplitude)
    remaining = _shared(np.array([amplitude[name] for name in names], dtype=float), frequency, forces, skin)
    for name, curve in zip(names, remaining.T, strict=True):
        if not np.isfinite(curve).all():
            heaviest = format_quantity(float(forces[np.isnan(curve)].min()), "N")
            raise FrictionError.no_answer(
                argument=f"amplitude on {name}",
                given=f"{format_quantity(amplitude[name], 'm')} at {heaviest}",
                allowed="amplitudes at which a film of air carries the finger, at every force of a stroke",
                cause="the plate would strike the skin before the film carries it",
                next_step="take smaller amplitudes, or a force with less spread",
            )
    weighted = _mean(forces, remaining, force)
    return Film(
        dict(amplitude),
        forces,
        dict(zip(names, remaining.T, strict=True)),
        {name: float(mean) for name, mean in zip(names, weighted, strict=True)},
    )


def explaining(
    reduction: Mapping[str, float],
    frequency: float,
    force: tuple[float, float],
    skin: Fingertip = USUAL,
) -> dict[str, float]:
    """Amplitudes (m) that explain the mean reduction on every waveguide, over the forces of the strokes.

    `haptonic.friction.lubrication.amplitude_for` does so at one force; friction is nonlinear in the force, so
    the mean over strokes differs.

    Raises
    ------
    FrictionError : a reduction that no amplitude explains
    """
    forces = _forces(force)
    left = _mean(forces, _shared(AMPLITUDES, frequency, forces, skin), force)
    solved = np.isfinite(left)
    amplitudes = {}
    for name, share in reduction.items():
        if not left[solved].min(initial=1) <= 1 - share <= left[solved].max(initial=0):
            raise FrictionError.out_of_range(
                argument=f"reduction on {name}",
                given=f"{share:g}",
                allowed=f"{1 - left[solved].max(initial=0):.2g} to {1 - left[solved].min(initial=1):.4g}",
                cause="no amplitude of a plate explains it by load sharing",
                next_step="give a share such as 0.55, or amplitudes",
            )
        logarithm = np.interp(share, 1 - left[solved], np.log(AMPLITUDES[solved]))
        amplitudes[name] = float(np.exp(logarithm))
    return amplitudes


def _forces(force: tuple[float, float]) -> Array:
    mean, spread = force
    return np.linspace(LIGHTEST, max(mean + WIDEST * spread, 1.1 * LIGHTEST), FORCES)


def _shared(amplitude: Array, frequency: float, forces: Array, skin: Fingertip) -> Array:
    """(force, amplitude) mu / mu0."""
    values = skin.values
    return np.array([shared_friction(amplitude, Touch(frequency, float(f)), values) for f in forces])


def _mean(forces: Array, curves: Array, force: tuple[float, float]) -> Array:
    """Mean of curves (force, ...) over the forces with which people press."""
    drawn = np.maximum(LIGHTEST, force[0] + force[1] * scipy.stats.norm.ppf(QUANTILES))
    return np.asarray([np.interp(drawn, forces, curve).mean() for curve in curves.T])
