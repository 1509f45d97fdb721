"""Numbers of arrays and columns in SI units, by the unit in the file or from the user."""

from __future__ import annotations

import math
from typing import Literal

import numpy as np

from haptonic.arrays import Array, Complex
from haptonic.channels import Channel, Notebook
from haptonic.channels.labels import Ratio, label_of, ratio_of
from haptonic.errors import ScanError
from haptonic.vibrometry.readers.mapped import IMPLIED, Mapped, plain

UNIT = "m/s/V"  # of responses, if neither the file nor the user gives one
DEGREE = math.pi / 180
ANGLES = {
    "rad": 1.0, "radian": 1.0, "radians": 1.0, "mrad": 1e-3, "deg": DEGREE, "degree": DEGREE,
    "degrees": DEGREE, "°": DEGREE, "º": DEGREE, "turn": 2 * math.pi,
}  # fmt: skip
PER_SECOND = {
    "hz": 1.0, "khz": 1e3, "ghz": 1e9, "1/s": 1.0, "s^-1": 1.0, "s-1": 1.0, "hertz": 1.0, "kilohertz": 1e3,
    "rad/s": 0.5 / math.pi, "rad/sec": 0.5 / math.pi, "krad/s": 500 / math.pi, "rpm": 1 / 60, "1/min": 1 / 60,
}  # fmt: skip
# Phases up to this size without a unit may be radians: 90 rad are 14 turns, more than an unwrapped scan has.
# In degrees, a single resonance changes the phase by 180.
EITHER = 90.0


class UnfitError(Exception):
    """An array, or a file of a point, that cannot be used; the text gives the reason."""


def numbers(channel: Channel, order: Literal["C", "F"] = "C") -> Array:
    """All numbers of a column, or of an array along one axis.

    Parameters
    ----------
    order : of the axes of an array: "F" if the first one is the fastest

    Raises
    ------
    UnfitError : the array contains text or complex numbers
    """
    if channel.kind == "complex":
        raise UnfitError(f"{channel.name} contains complex numbers, not real ones")
    try:
        return np.asarray(channel, dtype=float).ravel(order)
    except (TypeError, ValueError) as error:
        raise UnfitError(f"a cell of {channel.name} is not a number ({error})") from None


def frequency_factor(unit: str, how: Mapped, notes: Notebook | None = None) -> float:
    """Value of the unit of frequencies in Hz, from the file or else from the user.

    Raises
    ------
    UnfitError : not a unit of frequency, or a unit that contradicts the user's
    """
    written = label_of(unit)
    if not unit.strip():
        if how.frequency_unit is None and notes is not None:
            notes.remark("frequencies without a unit were read in Hz")
        return how.frequency_unit or 1.0
    short = unit.strip().casefold().replace(" ", "").replace("·", "")
    factor = written.factor if written.unit == "Hz" else PER_SECOND.get(short)
    if factor is None:
        raise UnfitError(f'"{unit}" is no unit of frequency')
    if how.frequency_unit is not None and not math.isclose(factor, how.frequency_unit, rel_tol=1e-6):
        raise UnfitError(f'its frequencies are in "{unit}", and another unit was given')
    return factor


def length_factor(unit: str, how: Mapped, notes: Notebook) -> float:
    """Value of the unit of coordinates in m, from the user or else from the file.

    Raises
    ------
    UnfitError : not a unit of length
    """
    written = label_of(unit)
    if how.length_unit is not None:
        if written.unit == "m" and not math.isclose(written.factor, how.length_unit, rel_tol=1e-6):
            notes.remark(f'coordinates in "{unit}" were read in units of {how.length_unit:g} m, as requested')
        return how.length_unit
    if written.unit and written.unit != "m":
        raise UnfitError(f'"{unit}" is no unit of length')
    if not unit.strip():
        notes.remark("coordinates without a unit were read in m")
    return written.factor


def phase_factor(channel: Channel, largest: float, how: Mapped, notes: Notebook) -> float:
    """Value of the unit of phases in rad, from the file or the user, else degrees for large phases.

    Parameters
    ----------
    largest : largest absolute phase of all points

    Raises
    ------
    UnfitError : not a unit of angle, or a unit that contradicts the user's
    ScanError : no unit, and phases that may be radians or degrees
    """
    unit = channel.unit.strip().casefold()
    if unit:
        factor = ANGLES.get(unit)
        if factor is None:
            raise UnfitError(f'"{channel.unit}" of the phase is no unit of angle')
        if how.phase_unit is not None and not math.isclose(factor, how.phase_unit, rel_tol=1e-6):
            raise UnfitError(f'its phases are in "{channel.unit}", and another unit was given')
        return factor
    if how.phase_unit is not None:
        return how.phase_unit
    if largest <= EITHER:
        raise ScanError.missing(
            argument="phase_unit",
            given=f"phases without a unit, up to {largest:.4g}",
            allowed="rad or deg, as an option or in brackets behind the name: phase (rad)",
            cause="these numbers may be radians or degrees",
            next_step='give the unit: read_scan(path, phase_unit="rad"), or "deg"',
            command=f"haptonic scan {how.path} --phase-unit rad (or deg)",
        )
    notes.remark("phases without a unit were read in degrees")
    return DEGREE


def largest_of(values: Array) -> float:
    """Largest absolute value of the finite numbers, or 0."""
    return float(np.abs(values[np.isfinite(values)]).max(initial=0.0))


def response_unit(channels: list[Channel], how: Mapped, notes: Notebook, written: str = "") -> Ratio:
    """Unit of a response: from its channels, else from the file (``written``), the user, or its name.

    Raises
    ------
    UnfitError : a unit of another quantity, or two units
    """
    units = {ratio_of(channel.unit) for channel in channels if channel.unit.strip()}
    if len(units) > 1:
        raise UnfitError(f"units {' and '.join(channel.unit for channel in channels)} of one response")
    name = plain(channels[0].name)
    implied = next((unit for word, unit in IMPLIED.items() if word in name), "")
    text = next((c.unit for c in channels if c.unit.strip()), "") or written or how.unit or implied
    if implied and text == implied:
        notes.remark(f'the name "{channels[0].name}" was read as a response in {implied}')
    ratio = ratio_of(text or UNIT)
    if ratio.over.motion is None and text == how.unit:
        raise ScanError.malformed(
            argument="unit",
            given=f'"{text}"',
            allowed='a unit of displacement, velocity or acceleration, such as "mm/s/V"',
            cause="the unit is that of the sensor's voltage, or misspelt",
            next_step="give the unit after the vibrometer's sensitivity was applied",
        )
    if ratio.over.motion is None:
        raise UnfitError(f'"{text}" is no displacement, velocity or acceleration')
    if not text:
        notes.remark(f"the file gives no unit of the responses: {UNIT} was used")
    return ratio


def of_amplitude(amplitude: Array, phase: Array, unit: str) -> Complex:
    """Complex response from its amplitude and its phase in rad.

    Raises
    ------
    UnfitError : decibels with an unknown reference value
    """
    if unit.strip().casefold().startswith("db"):
        raise UnfitError("an amplitude in decibels, whose reference value is not given")
    if np.nanmin(amplitude, initial=0.0) < 0:
        raise UnfitError("amplitudes below zero: they are perhaps in decibels")
    return np.asarray(amplitude * np.exp(1j * phase))


def share_factor(unit: str) -> float:
    """Factor of a coherence in this unit: 0.01 for percent."""
    return 0.01 if unit.strip() in ("%", "percent") else 1.0
