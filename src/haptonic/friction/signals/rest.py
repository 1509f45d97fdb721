"""Output of a sensor without a finger: the rest before the stroke and after it, and its drift."""

from __future__ import annotations

import numpy as np

from haptonic.arrays import Array, Bools

RETURNED = 0.5  # of the stroke's force: largest distance of an end at rest from the start
QUIET = 3.0  # times the noise at the start, or
QUIET_SHARE = 0.03  # of the force of the stroke: an end with less noise is rest
# A rest at the start without a rest at the end shows a drift but cannot correct it.
TOUCHED = 0.05  # of the stroke's force: the finger has come
BEFORE = 0.025  # s before contact, in which the finger may have begun to press, smeared by the filter
PARTS = 8  # of the rest at the start, whose means scatter about a line
CERTAIN = 12.0  # times its standard error: scatter gives such a slope in one rest of fifty thousand
MATERIAL = 0.02  # of a force: a drift until the middle of the stroke that changes friction


def rest_of(forces: Array, smooth: Array, start: Array, back: Bools, window: int) -> tuple[Array, Bools]:
    """Forces (channel, stroke, sample) that the sensor shows without a finger.

    They are those at the start. If the record ends at rest as well, they are a line from start to end,
    because a sensor drifts while it warms up.

    Parameters
    ----------
    smooth : (stroke, sample) normal force
    start : (channel, stroke) means over the window at the start
    back : (stroke,) True if the normal force returns to its value at the start

    Returns
    -------
    rest, and (stroke,) True if the record ends at rest
    """
    samples = forces.shape[2]
    rest = np.repeat(start[:, :, None], samples, axis=2)
    noise = np.maximum(QUIET * smooth[:, :window].std(axis=1), QUIET_SHARE * np.ptp(smooth, axis=1))
    unsettled = back.copy()
    for part in (window, window // 2, window // 4):
        if part < 2 or samples < 2 * window + part:
            continue
        still = unsettled & (smooth[:, -part:].std(axis=1) <= noise)
        drift = forces[:, :, -part:].mean(axis=2) - start
        middles = 0.5 * (window - 1), samples - 0.5 * (part + 1)
        place = np.clip((np.arange(samples) - middles[0]) / (middles[1] - middles[0]), 0, 1)
        rest += np.where(still[:, None], drift[:, :, None] * place, 0.0)
        unsettled &= ~still
    return rest, np.asarray(back & ~unsettled)


def drifts(forces: Array, smooth: Array, rate: float) -> bool:
    """True if the rest at the start of (channel, sample) forces shows a drift that changes the friction.

    The slope of the rest is extrapolated to the middle of the stroke; it has to be far larger than
    the scatter of the rest explains.

    Parameters
    ----------
    smooth : (sample,) normal force
    """
    departs = np.abs(smooth - smooth[: max(1, round(BEFORE * rate))].mean())
    pressed = np.flatnonzero(departs > TOUCHED * departs.max())
    size = (int(pressed[0]) - round(BEFORE * rate)) // PARTS if pressed.size else 0
    if size < 2:
        return False
    middle = float(np.median(np.flatnonzero(departs > RETURNED * departs.max())))
    place = (np.arange(PARTS) - 0.5 * (PARTS - 1)) * size
    means = forces[:, : PARTS * size].reshape(len(forces), PARTS, size).mean(axis=2)
    slope = means @ place / (place @ place)
    scatter = means - means.mean(axis=1, keepdims=True) - slope[:, None] * place
    error = np.sqrt((scatter**2).sum(axis=1) / (PARTS - 2) / (place @ place))
    reached = np.abs(slope) * (middle - 0.5 * PARTS * size)
    away = np.abs(forces[:, departs > RETURNED * departs.max()] - means.mean(axis=1, keepdims=True))
    return bool(((np.abs(slope) > CERTAIN * error) & (reached > MATERIAL * np.median(away, axis=1))).any())
