"""Intermittent contact: a spring-slider that the plate touches during half of every period, without air.

The model belongs to the class of [vezzoli2017]. While plate and skin touch, for half a period, the normal
force is a sine, sin(theta), and the skin moves at the speed U and loads a tangential spring from zero until
it slips. With

    beta = (k_t / k_n) U / (mu a omega)

the friction force is min(beta theta, sin theta) times mu times the largest normal force: stick up to the
theta_s where beta theta_s = sin theta_s, slip beyond, because sin theta decreases while beta theta grows.
Means over the half period give mu' / mu in closed form. ``1 - exp(-3.48 beta^1.149)`` fits it within 0.04.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from haptonic.arrays import Array
from haptonic.friction.lubrication.parameters import Touch, Values
from haptonic.friction.lubrication.sharing import NO_MOTION, checked_amplitude
from haptonic.later import elementwise

VALIDITY = (
    "the plate leaves the skin for half of every period, and no air is left between them; "
    "without effect where beta is 1 or more, that is below the amplitude (k_t/k_n) U / (mu omega)"
)


def slip_number(amplitude: ArrayLike, touch: Touch, values: Values) -> Array:
    """Slip number beta; infinite at rest."""
    moving = np.maximum(checked_amplitude(amplitude), NO_MOTION)
    speed = np.asarray(values["stiffness_ratio"]) * touch.speed
    return np.asarray(speed / (np.asarray(values["static_friction"]) * moving * touch.omega))


def intermittent_friction(amplitude: ArrayLike, touch: Touch, values: Values) -> Array:
    """Friction over that without vibration, mu' / mu.

    Parameters
    ----------
    amplitude : of displacement, zero to peak, m; any shape that broadcasts with the values
    touch : frequency and speed; the force has no effect
    values : of `Fingertip.values` or `Fingertip.sampled`

    Raises
    ------
    FrictionError : amplitudes that are negative, not finite, or larger than 1 mm
    """
    return slider_friction(slip_number(amplitude, touch, values))


def slider_friction(beta: ArrayLike) -> Array:
    """Friction mu' / mu of the spring-slider, (beta theta_s^2 / 2 + 1 + cos theta_s) / 2; 1 for beta >= 1."""
    number = np.minimum(np.asarray(beta, dtype=float), 1.0)
    assert (number > 0).all()
    # sin(theta) / theta falls from 1 to 0 over the half period
    root = elementwise.find_root(lambda theta, b: b - np.sinc(theta / np.pi), (0.0, np.pi), args=(number,))
    slip = np.where(number < 1, root.x, 0.0)
    return np.asarray(0.5 * (0.5 * number * slip**2 + 1 + np.cos(slip)))
