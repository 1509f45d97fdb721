"""Orientation of a sensor below the plate, from records: sign of the normal force, direction of the stroke.

A finger only presses, so the departure of the normal force from rest gives its sign. Friction opposes the
motion of a sliding finger, so the force in the plane gives the direction of the stroke.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from haptonic.arrays import Array
from haptonic.friction.signals.filters import smoothed
from haptonic.friction.signals.measuring import FEWEST
from haptonic.friction.signals.record import Record
from haptonic.friction.signals.rest import RETURNED, rest_of

AT_REST = 20  # this part of a record, at its start, shows the sensor without a finger
PRESSED = 0.5  # of the largest normal force: the finger presses
STRAIGHT = 0.15  # force across over along the stroke: strokes are not straighter, and the error is 1 %
ASIDE = 0.3  # the same for a single stroke in another direction than its participant's others
LEAST = 0.1  # force across over normal force that shows such a stroke
NOTHING = 0.01  # friction below which the direction is not determined
BEGUN = 0.2  # of the largest tangential force: the finger slides
NOISES = 3.0  # times the largest departure while the sensor rests: above, it is a force
UNLOADED = 5.0  # times the normal force: larger than any friction of a finger
GONE = 0.2  # of the force at the start: the rest after a finger that lay there is lifted


@dataclass(frozen=True)
class Mounting:
    """Orientation of the sensor for a participant.

    sign : 1, or -1 if the normal force falls when the finger presses
    angle : rad, from the named tangential channel to the stroke, towards the other channel in the plane
    """

    sign: float = 1.0
    angle: float = 0.0


def excursion(normal: Array) -> float:
    """Departure of the normal force from rest, N, negative if it falls; 0 if it does not depart."""
    if not normal.size or not np.isfinite(normal).all():
        return 0.0
    part = max(1, len(normal) // AT_REST)
    start, end = float(normal[:part].mean()), float(normal[-part:].mean())
    up, down = float(normal.max()) - start, start - float(normal.min())
    size, far = (up, start + up) if up > down else (-down, start - down)
    # a record that begins with the finger on the plate falls when it is lifted
    lifted = abs(end - start) > 0.5 * abs(size) and abs(far) < GONE * abs(start)
    return 0.0 if lifted else size


def begins_sliding(record: Record) -> bool:
    """True if a tangential force begins before the finger presses, which friction cannot do."""
    across = [] if record.across is None else [record.across]
    channels = np.array([record.normal, record.tangential, *across], dtype=float)
    part = max(2, channels.shape[1] // AT_REST)
    if channels.shape[1] <= FEWEST or not np.isfinite(channels).all():
        return False
    smooth = smoothed(channels, record.rate)
    departs = np.abs(smooth - smooth[:, :part].mean(axis=1, keepdims=True))
    noise = NOISES * float(departs[1:, :part].max())
    slides = np.hypot(departs[1], departs[2]) if len(departs) > 2 else departs[1]
    begun = np.flatnonzero(slides > max(BEGUN * slides.max(), noise))
    if not begun.size or slides.max() < departs[0].max() * NOTHING:
        return False
    return bool(departs[0, begun[0]] < slides[begun[0]] / UNLOADED)


def moments(record: Record) -> Array:
    """(2, 2) mean products of the forces in the plane over the square of the normal force, without noise."""
    if record.across is None:
        return np.zeros((2, 2))
    channels = np.array([record.normal, record.tangential, record.across], dtype=float)[:, None]
    part = max(2, channels.shape[2] // AT_REST)
    if channels.shape[2] <= FEWEST or not np.isfinite(channels).all():
        return np.zeros((2, 2))
    smooth, start = smoothed(channels[0], record.rate), channels[:, :, :part].mean(axis=2)
    departs = np.abs(smooth - start[0][:, None]).max(axis=1)
    back = np.abs(smooth[:, -part:].mean(axis=1) - start[0]) < RETURNED * departs
    rest, _ = rest_of(channels, smooth, start, back, part)
    normal, *plane = (channels - rest)[:, 0]
    forces, normal = np.array(plane), np.abs(normal)
    if not normal.any():
        return np.zeros((2, 2))
    pressed = normal > PRESSED * normal.max()
    rest = forces[:, :part] @ forces[:, :part].T / part
    inside = forces[:, pressed]
    return np.asarray((inside @ inside.T / inside.shape[1] - rest) / np.square(normal[pressed]).mean())


def direction(products: Array) -> float:
    """Direction in which forces with these moments are largest, rad from the tangential channel."""
    return 0.5 * math.atan2(2 * products[0, 1], products[0, 0] - products[1, 1])


def angle_of(products: Array) -> float:
    """Direction of the stroke, rad from the tangential channel; 0 if the channel has nearly all the force."""
    if np.trace(products) < NOTHING**2:
        return 0.0
    angle = direction(products)
    return angle if abs(math.tan(angle)) > STRAIGHT else 0.0


def own_angle(record: Record, usual: float) -> float | None:
    """Direction of a single stroke that departs from ``usual``, rad; None for a usual stroke."""
    products = moments(record)
    along, across = np.array([[math.cos(usual), math.sin(usual)], [-math.sin(usual), math.cos(usual)]])
    beside, ahead = (math.sqrt(max(float(axis @ products @ axis), 0.0)) for axis in (across, along))
    if beside < LEAST or beside < ASIDE * ahead:
        return None
    return direction(products)


def mounting_of(records: Sequence[Record], *, sign: bool, angle: bool) -> Mounting:
    """Orientation of the sensor for a participant's records; ``sign``, ``angle`` : True to estimate it."""
    if not records:
        return Mounting()
    # the median and the majority leave out a stroke that was cut or slipped
    departs = float(np.median([excursion(record.normal) for record in records]))
    usual = angle_of(_agreeing([moments(record) for record in records])) if angle else 0.0
    return Mounting(-1.0 if sign and departs < 0 else 1.0, usual)


def _agreeing(every: Sequence[Array]) -> Array:
    """(2, 2) sum of the moments whose directions agree with the direction nearest to all of them."""
    some = [moment for moment in every if np.trace(moment) > NOTHING**2]
    if not some:
        return np.zeros((2, 2))
    angles = np.array([direction(moment) for moment in some])
    apart = np.abs(np.sin(angles[:, None] - angles))
    near = apart[apart.sum(axis=1).argmin()] < STRAIGHT
    return np.asarray(sum(moment for moment, agrees in zip(some, near, strict=True) if agrees))
