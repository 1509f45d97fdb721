"""From a force record to one coefficient of friction, with all that was left out and why."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import asdict, dataclass
from importlib.metadata import version

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from haptonic.errors import FrictionError
from haptonic.friction.signals.filters import design_frequency, smoothed
from haptonic.friction.signals.record import Label, Record
from haptonic.units import shown

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

SATURATED = 5  # equal samples in a row at the largest force: a channel at its end
FEWEST = 10  # samples of a record that a filter can use
REASONS = (
    "missing numbers",
    "record too short",
    "saturated channel",
    "contact before the stroke",
    "no contact",
    "steady part too short",
    "normal force outside of the rule",
    "speed outside of the rule",
)
"""Why a trial is excluded; the first that applies is named."""


@dataclass(frozen=True)
class Rules:
    """How a trial is processed, and which trials do not count. Declared before the data are seen.

    filter : of `FILTERS`
    bias_window : s at the start, without contact, whose mean is subtracted; 0 for none
    threshold : normal force, N, from which there is contact
    plateau : how far the speed may be from its median over the stroke, as a share of it
    middle : share of the contact that counts where no position was recorded
    steady : shortest time, s, that has to be left
    force, speed : N and m/s, (lowest, highest) mean that a trial may have
    """

    filter: str = "literal"
    bias_window: float = 0.1
    threshold: float = 0.1
    plateau: float = 0.5
    middle: float = 0.6
    steady: float = 0.1
    force: tuple[float, float] = (0.1, 5.0)
    speed: tuple[float, float] = (0.01, 0.5)

    def __post_init__(self) -> None:
        design_frequency(self.filter, 1000.0)
        limits = {"bias_window": (0, 10), "threshold": (1e-3, 10), "plateau": (0.01, 1), "middle": (0.01, 1)}
        for name, (low, high) in (limits | {"steady": (0.01, 60)}).items():
            value = getattr(self, name)
            if isinstance(value, bool) or not isinstance(value, int | float) or not low <= value <= high:
                raise _bad_rule(name, value, f"a number from {low:g} to {high:g}")
        for name in ("force", "speed"):
            pair = getattr(self, name)
            if not (isinstance(pair, tuple) and len(pair) == 2 and 0 <= pair[0] < pair[1]):
                raise _bad_rule(name, pair, "two numbers, the lowest and the highest that count")


def _bad_rule(name: str, value: object, allowed: str) -> FrictionError:
    return FrictionError(
        argument=f"rules.{name}",
        given=shown(value),
        allowed=allowed,
        cause="another unit (ms, mN, per cent), or the limits in the wrong order",
        next_step="give it in s, N, m/s or as a share",
    )


@dataclass(frozen=True)
class Measured:
    """What one stroke says. Numbers that could not be had are NaN.

    mean_of_ratios, ratio_of_means : the two ways to average |tangential| / normal over the steady part
    spread : standard deviation of the ratio over the steady part
    force, speed : means over the steady part, N and m/s
    duration : of the steady part, s
    below_threshold, reversing, off_plateau : shares of the samples left out for that reason
    excluded : one of `REASONS`, or nothing
    """

    mean_of_ratios: float = np.nan
    ratio_of_means: float = np.nan
    spread: float = np.nan
    force: float = np.nan
    speed: float = np.nan
    duration: float = 0.0
    below_threshold: float = np.nan
    reversing: float = np.nan
    off_plateau: float = np.nan
    excluded: str = ""


DEFAULT_RULES = Rules()


def measure(record: Record, rules: Rules = DEFAULT_RULES) -> Measured:
    """Friction of one stroke over its steady part.

    The steady part is where the finger presses and moves in the direction of the stroke at about its median
    speed; without a position, the middle of the contact.

    Raises
    ------
    FrictionError : a sampling rate too low for the filter
    """
    design_frequency(rules.filter, record.rate)
    channels = np.array([record.normal, record.tangential], dtype=float)
    if not np.isfinite(channels).all() or not (record.position is None or np.isfinite(record.position).all()):
        return Measured(excluded="missing numbers")
    if channels.shape[1] < FEWEST:
        return Measured(excluded="record too short")
    if any(_saturated(channel) for channel in channels):
        return Measured(excluded="saturated channel")
    if record.position is not None:
        channels = np.vstack([channels, record.position])
    smooth = smoothed(channels, record.rate)
    forces = smooth[:2] if rules.filter == "literal" else smoothed(channels[:2], record.rate, rules.filter)
    window = round(rules.bias_window * record.rate)
    if window:
        if float(np.ptp(smooth[0, :window])) > rules.threshold:
            return Measured(excluded="contact before the stroke")
        forces = forces - channels[:2, :window].mean(axis=1, keepdims=True)
    normal, tangential = forces
    contact = normal > rules.threshold
    if not contact.any():
        return Measured(below_threshold=1.0, excluded="no contact")
    velocity, forwards, plateau = _motion(smooth[2:], record.rate, tangential, contact, rules)
    steady = contact & forwards & plateau
    found = Measured(
        duration=float(steady.sum() / record.rate),
        below_threshold=float(1 - contact.mean()),
        reversing=float((contact & ~forwards).mean()),
        off_plateau=float((contact & forwards & ~plateau).mean()),
    )
    if found.duration < rules.steady:
        return Measured(**(asdict(found) | {"excluded": "steady part too short"}))
    ratio = np.abs(tangential[steady]) / normal[steady]
    force = float(normal[steady].mean())
    speed = float(np.abs(velocity[steady]).mean())
    excluded = ""
    if not rules.force[0] <= force <= rules.force[1]:
        excluded = "normal force outside of the rule"
    elif record.position is not None and not rules.speed[0] <= speed <= rules.speed[1]:
        excluded = "speed outside of the rule"
    return Measured(
        **(
            asdict(found)
            | {
                "mean_of_ratios": float(ratio.mean()),
                "ratio_of_means": float(np.abs(tangential[steady]).mean() / force),
                "spread": float(ratio.std(ddof=1)),
                "force": force,
                "speed": speed,
                "excluded": excluded,
            }
        )
    )


def measured(records: Iterable[tuple[Label, Record]], rules: Rules = DEFAULT_RULES) -> xr.Dataset:
    """A table of trials from force records, which may come one by one from their files.

    Returns
    -------
    along ``stroke``: the label (``participant``, ``block``, ``trial``, ``waveguide``, ``actuation``), what
    `Measured` holds, and ``friction``, the mean of ratios. Excluded trials are in the table, with the reason
    in ``excluded``; their numbers never enter a statistic.

    Raises
    ------
    FrictionError : no record, two records of one trial, or a sampling rate too low for the filter
    """
    rows = [(label, measure(record, rules)) for label, record in records]
    return tabulated([label for label, _ in rows], [found for _, found in rows], rules)


def tabulated(labels: list[Label], found: list[Measured], rules: Rules) -> xr.Dataset:
    """The table of `measured` from its rows."""
    if not labels:
        raise FrictionError(
            argument="records",
            given="none",
            allowed="at least one record",
            cause="an empty folder or table",
            next_step="choose another folder",
        )
    once = set()
    for label in labels:
        if (label.participant, label.block, label.trial) in once:
            raise FrictionError(
                argument="records",
                given=f"{label} more than once",
                allowed="one record for each trial",
                cause="a file was read twice, or trials are numbered from 1 again within a block",
                next_step="number the trials of a block consecutively",
            )
        once.add((label.participant, label.block, label.trial))
    table = {name: np.array([asdict(label)[name] for label in labels]) for name in asdict(labels[0])}
    table |= {name: np.array([getattr(row, name) for row in found]) for name in asdict(found[0])}
    units = {"force": "N", "speed": "m/s", "duration": "s", "friction": "1"}
    table["friction"] = table["mean_of_ratios"]
    data = {
        name: ("stroke", values, {"units": units[name]} if name in units else {})
        for name, values in table.items()
    }
    attributes = {
        "origin": "measured",
        "rules": json.dumps(asdict(rules)),
        "haptonic_version": version("haptonic"),
    }
    return xr.Dataset(data, attrs=attributes)


def exclusions(trials: xr.Dataset) -> dict[str, int]:
    """How many trials were excluded, for each of `REASONS`, those included."""
    given = [str(reason) for reason in trials["excluded"].values]
    return {reason: given.count(reason) for reason in REASONS}


def _motion(
    position: Array, rate: float, tangential: Array, contact: Mask, rules: Rules
) -> tuple[Array, Mask, Mask]:
    """Velocity, whether it has the direction of the stroke, and whether the speed is steady."""
    if not len(position):
        forwards = np.sign(tangential) == np.sign(np.median(tangential[contact]))
        pressed = np.flatnonzero(contact)
        trimmed = round(0.5 * (1 - rules.middle) * len(pressed))
        plateau = np.zeros_like(contact)
        plateau[pressed[trimmed : len(pressed) - trimmed]] = True
        return np.full(len(contact), np.nan), forwards, plateau
    velocity = np.gradient(position[0], 1 / rate)
    typical = float(np.median(velocity[contact]))
    forwards = velocity * typical > 0
    if forwards[contact].any():
        typical = float(np.median(velocity[contact & forwards]))
    return velocity, forwards, np.abs(velocity - typical) <= rules.plateau * abs(typical)


def _saturated(channel: Array) -> bool:
    """Whether the channel stays at its largest size for several samples in a row."""
    size = np.abs(channel)
    at_end = size == size.max()
    if size.max() == 0 or at_end.sum() < SATURATED:
        return False
    return bool((np.convolve(at_end, np.ones(SATURATED, dtype=int), "valid") == SATURATED).any())
