"""Force records of strokes with a known friction: six axes of a sensor below the plate, and the position."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy
from numpy.random import Generator

from haptonic.arrays import Array
from haptonic.friction.protocol import Protocol
from haptonic.friction.signals import Label, Record
from haptonic.friction.simulation.truth import Person, Trial, Truth, people, trials

RATE = 1000.0  # Hz
BEFORE, AFTER = 0.2, 0.1  # s without contact
TOUCHDOWN = 0.08  # s
UNEVEN = 0.08  # force and speed wander by this share of themselves within a stroke
WANDERING = 0.99  # correlation of the wandering from one sample to the next: some 0.1 s
SIDEWAYS = 0.03  # force across the stroke over normal force: no stroke is quite straight
OFF_AXIS, ABOVE = 0.027, 0.006  # m: from the sensor's axis to a waveguide's, and up to the flat face
NOISY_LEVER = 0.008  # m: noise of the torques over that of the forces

AXES = ("Fx", "Fy", "Fz", "Tx", "Ty", "Tz")


@dataclass(frozen=True, eq=False)
class Stroke:
    """Record of one stroke by a six-axis sensor below the plate.

    trial : with the friction of the stroke
    axes : (6, samples) `AXES`, N and N m; Fz is positive when the finger presses
    position : (samples,) m along the stroke
    """

    trial: Trial
    axes: Array
    position: Array

    @property
    def record(self) -> Record:
        """Normal and tangential force alone."""
        return Record(normal=self.axes[2], tangential=self.axes[1], rate=RATE, position=self.position)


@dataclass(frozen=True)
class Experiment:
    """Strokes of simulated people; equal experiments have equal strokes, to the last digit.

    truth, protocol : true properties of the people, and the order of their trials
    participants : number of people
    seed : of all random draws
    """

    truth: Truth
    protocol: Protocol
    participants: int
    seed: int = 0

    @property
    def labels(self) -> list[Label]:
        """Every trial in its order."""
        return self.protocol.order(self.participants)

    @cached_property
    def people(self) -> list[Person]:
        """The people drawn with ``seed``."""
        return people(self.truth, self.participants, np.random.default_rng(self.seed))

    def strokes(self) -> Iterator[Stroke]:
        """Records of the sensor, one by one: those of a participant fill some 20 MB.

        Raises
        ------
        FrictionError : no participant, or a waveguide that is not in the truth
        """
        rng = np.random.default_rng(self.seed)
        return recorded(self.truth, self.protocol, people(self.truth, self.participants, rng), rng)


def strokes(
    truth: Truth, protocol: Protocol, participants: int, seed: int = 0
) -> Iterator[tuple[Label, Record, float]]:
    """Force records of an experiment, one by one, each with its true coefficient of friction.

    Raises
    ------
    FrictionError : no participant, or a waveguide that is not in the truth
    """
    for stroke in Experiment(truth, protocol, participants, seed).strokes():
        yield stroke.trial.label, stroke.record, stroke.trial.friction


def recorded(truth: Truth, protocol: Protocol, group: list[Person], rng: Generator) -> Iterator[Stroke]:
    """Records of the sensor for every stroke of these people, one by one.

    Raises
    ------
    FrictionError : no people, or a waveguide that is not in the truth
    """
    for trial in trials(truth, protocol, group, rng):
        driven = trial.label.waveguide == protocol.waveguides[0]
        yield _stroke(truth, trial, -OFF_AXIS if driven else OFF_AXIS, rng)


def samples_of(truth: Truth) -> int:
    """Number of samples in the record of a stroke."""
    return round((BEFORE + truth.contact + AFTER) * RATE)


def _stroke(truth: Truth, trial: Trial, across: float, rng: Generator) -> Stroke:
    time = np.arange(samples_of(truth)) / RATE
    since, until = time - BEFORE, BEFORE + truth.contact - time
    pressing = np.clip(np.minimum(since, until) / TOUCHDOWN, 0, 1)
    moving = np.clip(np.minimum(since - TOUCHDOWN, until - TOUCHDOWN) / TOUCHDOWN, 0, 1)
    normal = trial.force * pressing * (1 + _wandering(len(time), rng))
    velocity = trial.speed * moving * (1 + _wandering(len(time), rng))
    position = np.cumsum(velocity) / RATE
    # a finger at rest has less tangential force than friction would allow
    tangential = -trial.friction * normal * np.clip(velocity / (0.1 * trial.speed), 0, 1)
    sideways = SIDEWAYS * normal * (1 + _wandering(len(time), rng))
    along = position - 0.5 * trial.speed * truth.contact
    axes = np.array(
        [
            sideways,
            tangential,
            normal,
            along * normal - ABOVE * tangential,
            ABOVE * sideways - across * normal,
            across * tangential - along * sideways,
        ]
    )
    scale = truth.people.bias * np.array([0.2, -1, 1, NOISY_LEVER, -NOISY_LEVER, NOISY_LEVER])
    noise = truth.people.noise * np.array([1, 1, 1, NOISY_LEVER, NOISY_LEVER, NOISY_LEVER])
    axes += scale[:, None] + noise[:, None] * rng.standard_normal(axes.shape)
    return Stroke(trial, axes, position)


def _wandering(samples: int, rng: Generator) -> Array:
    """A slow random change, by `UNEVEN` on average."""
    white = rng.standard_normal(samples) * UNEVEN * math.sqrt(1 - WANDERING**2)
    return np.asarray(scipy.signal.lfilter([1.0], [1.0, -WANDERING], white))
