"""How a sensor lay below the plate, as records show it: sign of the normal force, direction of the stroke.

A finger only presses, so the normal force counts in the direction in which it departs from rest. Friction
opposes the motion of a finger that slides, so the force in the plane shows the direction of the stroke.
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

AT_REST = 20  # that part of a record, at its start, shows the sensor without a finger
PRESSED = 0.5  # of the largest normal force: the finger presses
STRAIGHT = 0.15  # across the stroke over along it: no finger strokes straighter, and the error is 1 %
ASIDE = 0.3  # the same of a single stroke that goes elsewhere than the others of its participant
LEAST = 0.1  # force across over normal force that shows it
NOTHING = 0.01  # friction below which there is no direction
BEGUN = 0.2  # of the largest tangential force: the finger slides
NOISES = 3.0  # times the largest departure while the sensor rests: a force
UNLOADED = 5.0  # times the normal force: no friction of a finger is as large
GONE = 0.2  # of the force at the start: what is left when a finger that lay there is lifted


@dataclass(frozen=True)
class Mounting:
    """How the sensor lay for a participant.

    sign : 1, or -1 where the normal force falls where the finger presses
    angle : rad, from the named tangential channel to the stroke, towards the other one in the plane
    """

    sign: float = 1.0
    angle: float = 0.0


def excursion(normal: Array) -> float:
    """How far the normal force departs from rest, N, negative where it falls; 0 where nothing is seen."""
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
    """True if a tangential force begins where the finger does not press yet, which friction never does."""
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
    """Direction of the stroke, rad from the tangential channel; 0 where the channel has nearly all of it."""
    if np.trace(products) < NOTHING**2:
        return 0.0
    angle = direction(products)
    return angle if abs(math.tan(angle)) > STRAIGHT else 0.0


def own_angle(record: Record, usual: float) -> float | None:
    """Direction of a single stroke that goes elsewhere than ``usual``, rad; None where it does not."""
    products = moments(record)
    along, across = np.array([[math.cos(usual), math.sin(usual)], [-math.sin(usual), math.cos(usual)]])
    beside, ahead = (math.sqrt(max(float(axis @ products @ axis), 0.0)) for axis in (across, along))
    if beside < LEAST or beside < ASIDE * ahead:
        return None
    return direction(products)


def mounting_of(records: Sequence[Record], *, sign: bool, angle: bool) -> Mounting:
    """How the sensor lay for a participant's records; ``sign`` and ``angle`` : True to look for it."""
    if not records:
        return Mounting()
    # a stroke that was cut or slipped shows something else than the others
    departs = float(np.median([excursion(record.normal) for record in records]))
    usual = angle_of(_agreeing([moments(record) for record in records])) if angle else 0.0
    return Mounting(-1.0 if sign and departs < 0 else 1.0, usual)


def _agreeing(every: Sequence[Array]) -> Array:
    """(2, 2) sum of the moments whose directions agree with that which is nearest to all of them."""
    some = [one for one in every if np.trace(one) > NOTHING**2]
    if not some:
        return np.zeros((2, 2))
    angles = np.array([direction(one) for one in some])
    apart = np.abs(np.sin(angles[:, None] - angles))
    near = apart[apart.sum(axis=1).argmin()] < STRAIGHT
    return np.asarray(sum(one for one, agrees in zip(some, near, strict=True) if agrees))
