"""Load sharing: asperities of the skin and the film of squeezed air carry the finger together.

The mechanism is that of [wiertlewski2016]; the closure is an assumption: the asperity pressure is exponential
in the gap. The mean gap u solves ``p_a(u) + p_film(u) = F / A``, and friction is the asperities' share of the
load. Both pressures fall with the gap, so there is one equilibrium.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from haptonic.arrays import Array
from haptonic.errors import FrictionError
from haptonic.friction.lubrication import film
from haptonic.friction.lubrication.parameters import Fingertip, Touch, Values
from haptonic.later import elementwise

FILM_ONLY = 1e-9  # of the friction at rest: less than this is treated as none
FAR = 100.0  # times the amplitude: a gap at which the film cannot carry a finger
NO_MOTION = 1e-12  # m: below, the plate counts as at rest


def nominal_pressure(touch: Touch, values: Values) -> Array:
    """Normal force over contact area, Pa; the area is a power of the force, given by its value at 0.5 N."""
    return np.asarray(touch.force / _area(touch, values))


def gap_at_rest(touch: Touch, values: Values) -> Array:
    """Mean gap without vibration, m; not positive where the force presses the asperities flat."""
    return _gap_of_share(1.0, nominal_pressure(touch, values), values)


def check_force(touch: Touch, values: Values) -> None:
    """Raise FrictionError if a force presses the asperities flat, so that no film of air is left."""
    if (gap_at_rest(touch, values) > 0).all():
        return
    flat = np.asarray(values["asperity_pressure"]) * np.exp(
        np.asarray(values["contact_gap"]) / np.asarray(values["decay_length"])
    )
    exponent = np.asarray(values["area_exponent"])
    largest = np.min((flat * values["patch_area"] / 0.5**exponent) ** (1 / (1 - exponent)))
    raise FrictionError.out_of_range(
        argument="touch.force",
        given=f"{touch.force:g} N, {np.max(nominal_pressure(touch, values)):.3g} Pa on the contact",
        allowed=f"below {largest:.2g} N for this skin, so that its asperities leave a gap at rest",
        cause="the force is in another unit, or too large for the asperity law",
        next_step="use a smaller force, or give a larger contact_gap in [touch.skin]",
    )


def film_pressure(gap: ArrayLike, amplitude: ArrayLike, touch: Touch, values: Values) -> Array:
    """Mean overpressure of the film, Pa, at a mean gap not below amplitude / `film.LARGEST_EXCURSION`."""
    length = np.sqrt(_area(touch, values) / np.pi) * values["film_share"]
    ambient = np.asarray(values["ambient_pressure"])
    squeeze = film.squeeze_number(gap, touch.omega, length, values["viscosity"], ambient)
    excursion = np.minimum(np.asarray(amplitude) / np.asarray(gap), film.LARGEST_EXCURSION)
    return np.asarray(ambient * film.efficiency(squeeze, excursion) * film.sealed_overpressure(excursion))


def shared_friction(amplitude: ArrayLike, touch: Touch, values: Values) -> Array:
    """Friction over that without vibration, mu / mu0.

    Parameters
    ----------
    amplitude : of displacement, zero to peak, m; any shape that broadcasts with the values
    touch : frequency and force
    values : of `Fingertip.values` or `Fingertip.sampled`

    Returns
    -------
    1 at rest, falling towards 0; NaN where the plate would strike the skin before the film carries the finger
    (use the model of intermittent contact there)

    Raises
    ------
    FrictionError : amplitudes that are negative, not finite, or larger than 1 mm; a force that leaves no gap
    """
    moving = checked_amplitude(amplitude)
    pressure = nominal_pressure(touch, values)
    shape = np.broadcast_shapes(moving.shape, *(np.shape(value) for value in values.values()))
    check_force(touch, values)
    at_rest = gap_at_rest(touch, values)
    lowest = np.maximum(moving, NO_MOTION) / film.LARGEST_EXCURSION
    highest = _gap_of_share(FILM_ONLY, pressure, values) + FAR * moving + FAR * at_rest
    names = list(values)

    def excess(logarithm: Array, amplitude: Array, *numbers: Array) -> Array:
        given = dict(zip(names, numbers, strict=True))
        gap = np.exp(logarithm)
        load = nominal_pressure(touch, given)
        return asperity_pressure(gap, given) + film_pressure(gap, amplitude, touch, given) - load

    span = np.log(np.broadcast_to(lowest, shape)), np.log(np.broadcast_to(highest, shape))
    arguments = [np.broadcast_to(a, shape) for a in (np.maximum(moving, NO_MOTION), *values.values())]
    root = elementwise.find_root(excess, span, args=tuple(arguments))  # NaN where the sign does not change
    share = asperity_pressure(np.exp(root.x), values) / pressure
    return np.clip(share, 0, 1)


def amplitude_for(friction: ArrayLike, touch: Touch, values: Values) -> Array:
    """The inverse of `shared_friction`: amplitude (m) that leaves this much friction, mu / mu0.

    The friction alone determines the gap; the film has to carry the rest of the load at this gap.

    Returns
    -------
    m; NaN where the film at that gap is too weak

    Raises
    ------
    FrictionError : friction outside of (0, 1]
    """
    left = np.asarray(friction, dtype=float)
    if left.size == 0 or not (np.isfinite(left).all() and (left > 0).all() and (left <= 1).all()):
        raise FrictionError.out_of_range(
            argument="friction",
            given=f"{np.min(left, initial=np.inf):g} to {np.max(left, initial=-np.inf):g}",
            allowed="mu / mu0, above 0 and at most 1",
            cause="a reduction or a percentage was given instead of the friction that is left",
            next_step="a reduction of 55 % leaves 0.45",
        )
    pressure = nominal_pressure(touch, values)
    gap = _gap_of_share(left, pressure, values)
    names = list(values)

    def missing(excursion: Array, gap: Array, left: Array, *numbers: Array) -> Array:
        given = dict(zip(names, numbers, strict=True))
        return film_pressure(gap, excursion * gap, touch, given) - (1 - left) * nominal_pressure(touch, given)

    shape = np.broadcast_shapes(gap.shape, left.shape, *(np.shape(value) for value in values.values()))
    arguments = [np.broadcast_to(a, shape) for a in (gap, left, *values.values())]
    ends = np.zeros(shape), np.full(shape, film.LARGEST_EXCURSION)
    root = elementwise.find_root(missing, ends, args=tuple(arguments))
    return np.asarray(root.x * gap)


def amplitude_ratio(driven: float, idle: float, touch: Touch, values: Values) -> Array:
    """Ratio of the vibration amplitude of the driven region to that of the idle one, from their reductions.

    Parameters
    ----------
    driven, idle : reductions, 0.55 for 55 %; the driven one is larger

    Raises
    ------
    FrictionError : reductions that are not 0 < idle < driven < 1
    """
    if not 0 < idle < driven < 1:
        raise FrictionError.out_of_range(
            argument="reductions of friction",
            given=f"driven {driven:g}, idle {idle:g}",
            allowed="0 < idle < driven < 1",
            cause="they are percentages or in the wrong order, or the idle region shows no reduction at all",
            next_step="give shares such as 0.55 and 0.11; without a reduction there is no ratio",
        )
    return amplitude_for(1 - driven, touch, values) / amplitude_for(1 - idle, touch, values)


def asperity_pressure(gap: ArrayLike, values: Values) -> Array:
    """Pressure that the asperities of the skin carry at a mean gap, Pa: exponential in the gap."""
    distance = (np.asarray(gap) - values["contact_gap"]) / values["decay_length"]
    return np.asarray(values["asperity_pressure"] * np.exp(-distance))


def sensitivity(amplitude: float, touch: Touch, finger: Fingertip) -> dict[str, tuple[float, float]]:
    """Friction, mu / mu0, at either end of every parameter's plausible interval, other parameters fixed.

    Returns
    -------
    name of the parameter -> friction at its low and its high end, the most influential first
    """
    ends = {
        name: tuple(
            float(shared_friction(amplitude, touch, finger.values | {name: end}))
            for end in parameter.plausible
        )
        for name, parameter in finger
    }
    order = sorted(ends, key=lambda name: -abs(ends[name][1] - ends[name][0]))
    return {name: (ends[name][0], ends[name][1]) for name in order}


def checked_amplitude(amplitude: ArrayLike) -> Array:
    """Amplitudes (m) as an array.

    Raises
    ------
    FrictionError : amplitudes that are negative, not finite, or larger than 1 mm
    """
    array = np.asarray(amplitude)
    if array.dtype.kind not in "fi" or not array.size:
        given = f"{array.dtype} of shape {array.shape}"
    elif not np.isfinite(array).all():
        given = f"{np.count_nonzero(~np.isfinite(array))} of {array.size} numbers that are not finite"
    elif array.min() < 0 or array.max() > 1e-3:
        given = f"{array.min():g} to {array.max():g} m"
    else:
        return array.astype(float)
    raise FrictionError.out_of_range(
        argument="amplitude",
        given=given,
        allowed="real amplitudes of displacement in m, from 0 to 1 mm",
        cause="micrometres, a complex response, or a velocity instead of a displacement",
        next_step="take the magnitude of FrequencyResponse.displacement(), in m",
    )


def _area(touch: Touch, values: Values) -> Array:
    return np.asarray(values["patch_area"] * (touch.force / 0.5) ** np.asarray(values["area_exponent"]))


def _gap_of_share(share: ArrayLike, pressure: Array, values: Values) -> Array:
    """Gap at which the asperities carry this share of the load."""
    ratio = np.asarray(share) * pressure / np.asarray(values["asperity_pressure"])
    return np.asarray(values["contact_gap"] - np.asarray(values["decay_length"]) * np.log(ratio))
