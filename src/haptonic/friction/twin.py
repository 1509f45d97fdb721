"""A made-up experiment: force records of strokes with a known friction, to test the analysis with.

Everything that comes from here is labelled as simulated.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray
from scipy.signal import lfilter

from haptonic.errors import FrictionError
from haptonic.friction.protocol import Protocol
from haptonic.friction.signals import Label, Record
from haptonic.units import shown

Array = NDArray[np.float64]

RATE = 1000.0  # Hz
STROKE = 0.9  # s in contact
BEFORE, AFTER = 0.2, 0.1  # s without
TOUCHDOWN = 0.08  # s
UNEVEN = 0.08  # force and speed wander by this share of themselves within a stroke
WANDERING = 0.99  # correlation of the wandering from one sample to the next: some 0.1 s
SLOWEST = 0.03  # m/s, and
LIGHTEST = 0.2  # N: what a participant who follows instructions does not fall below


@dataclass(frozen=True)
class Truth:
    """What is true of the made-up participants.

    friction : with the vibration off, mean over people
    remaining : waveguide -> mu / mu0 with the vibration on, in the population
    between : standard deviation of friction between people, as a share
    effect_between : standard deviation of the reduction between people (of a reduction of 0.55, say)
    within : standard deviation of friction from trial to trial, as a share; 0.22 gives the differences of 180
        pairs on the idle waveguide an interval as wide as the published one, 0.04 [daunizeau-haptics]
    drift : change of friction over the whole session, as a share: moisture, fatigue
    noise : of the force sensor, N rms
    force, speed : (mean, standard deviation) over trials, N and m/s
    bias : of the sensor, N
    """

    friction: float = 0.42
    remaining: Mapping[str, float] = field(
        default_factory=lambda: MappingProxyType({"WG1": 0.45, "WG2": 0.89})
    )
    between: float = 0.15
    effect_between: float = 0.05
    within: float = 0.22
    drift: float = 0.1
    noise: float = 0.021
    force: tuple[float, float] = (0.8, 0.4)
    speed: tuple[float, float] = (0.078, 0.013)
    bias: float = 0.3

    def __post_init__(self) -> None:
        for name in ("between", "effect_between", "within", "noise"):
            value = getattr(self, name)
            if not (math.isfinite(value) and 0 <= value <= 1):
                raise _untrue(name, value, "0 to 1")
        if not 0 < self.friction <= 5:
            raise _untrue("friction", self.friction, "above 0, at most 5")
        for guide, left in self.remaining.items():
            if not 0 < left <= 1:
                raise _untrue(f"remaining.{guide}", left, "mu / mu0, above 0 and at most 1")


def _untrue(name: str, value: object, allowed: str) -> FrictionError:
    return FrictionError(
        argument=f"twin.{name}",
        given=shown(value),
        allowed=allowed,
        cause="a percentage, or another unit",
        next_step="give shares, such as 0.45 for a reduction of 55 %",
    )


def strokes(
    truth: Truth, protocol: Protocol, participants: int, seed: int = 0
) -> Iterator[tuple[Label, Record, float]]:
    """Force records of an experiment, one by one, each with the coefficient of friction that made it.

    Raises
    ------
    FrictionError : no participant, or a waveguide of which the truth says nothing
    """
    rng = np.random.default_rng(seed)
    for label, friction in coefficients(truth, protocol, participants, rng):
        yield label, _stroke(truth, friction, rng), friction


def coefficients(
    truth: Truth, protocol: Protocol, participants: int, rng: Generator
) -> Iterator[tuple[Label, float]]:
    """The true coefficient of friction of every trial, without force records: enough to test statistics.

    Raises
    ------
    FrictionError : no participant, or a waveguide of which the truth says nothing
    """
    labels = protocol.order(participants)
    for guide in {label.waveguide for label in labels} - set(truth.remaining):
        raise _untrue("remaining", dict(truth.remaining), f"one number for each waveguide, also for {guide}")
    session = protocol.blocks * protocol.trials
    person = ""
    level, place = 0.0, 0
    left: dict[str, float] = {}
    for label in labels:
        if label.participant != person:
            person, place = label.participant, 0
            level = truth.friction * _positive_factor(truth.between, rng)
            left = {
                guide: float(np.clip(mean + truth.effect_between * rng.standard_normal(), 0.01, 2))
                for guide, mean in truth.remaining.items()
            }
        moved = 1 + truth.drift * (place / session - 0.5)
        place += 1
        on = left[label.waveguide] if label.actuation == "on" else 1.0
        yield label, level * moved * on * _positive_factor(truth.within, rng)


def _positive_factor(spread: float, rng: Generator) -> float:
    """A log-normal factor with mean 1 and this standard deviation."""
    width = math.sqrt(math.log1p(spread**2))
    return math.exp(width * float(rng.standard_normal()) - width**2 / 2)


def _stroke(truth: Truth, friction: float, rng: Generator) -> Record:
    force = max(LIGHTEST, truth.force[0] + truth.force[1] * float(rng.standard_normal()))
    speed = max(SLOWEST, truth.speed[0] + truth.speed[1] * float(rng.standard_normal()))
    time = np.arange(round((BEFORE + STROKE + AFTER) * RATE)) / RATE
    since, until = time - BEFORE, BEFORE + STROKE - time
    pressing = np.clip(np.minimum(since, until) / TOUCHDOWN, 0, 1)
    moving = np.clip(np.minimum(since - TOUCHDOWN, until - TOUCHDOWN) / TOUCHDOWN, 0, 1)
    normal = force * pressing * (1 + _wandering(len(time), rng))
    velocity = speed * moving * (1 + _wandering(len(time), rng))
    # at rest the finger holds by less than friction would allow
    tangential = friction * normal * np.clip(velocity / (0.1 * speed), 0, 1)
    noise = truth.noise * rng.standard_normal((2, len(time)))
    return Record(
        normal=normal + noise[0] + truth.bias,
        tangential=-tangential + noise[1] - truth.bias,
        rate=RATE,
        position=np.cumsum(velocity) / RATE,
    )


def _wandering(samples: int, rng: Generator) -> Array:
    """A slow random change, by `UNEVEN` on average."""
    white = rng.standard_normal(samples) * UNEVEN * math.sqrt(1 - WANDERING**2)
    return np.asarray(lfilter([1.0], [1.0, -WANDERING], white))
