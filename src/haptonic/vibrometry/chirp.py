"""Drive signals: one period, repeated, so that every frequency line is driven and none leaks."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np

from haptonic.arrays import Array
from haptonic.channels import Channel, delimited, hdf5, wav
from haptonic.errors import HaptonicWarning, ScanError
from haptonic.units import hz_text, in_percent

Kind = Literal["chirp", "multisine"]
DriveUnit = Literal["V", "N"]

KINDS: tuple[Kind, ...] = ("chirp", "multisine")
RING_DOWNS = 3.0  # a record of 3 Q / f lets a resonance fall by exp(-3 pi), 82 dB
NYQUIST_MARGIN = 0.8  # of half the rate: above, converters and their filters bend the spectrum


@dataclass(frozen=True, eq=False)
class Drive:
    """One period of a drive signal.

    samples : (sample,) in ``unit``, its largest value is the amplitude
    sample_rate : Hz
    band : lowest and highest driven frequency, Hz; both are lines
    kind : "chirp" or "multisine"
    warnings : possible faults of a measurement with it
    unit : unit of the samples; N if a force drives the plate
    """

    samples: Array
    sample_rate: float
    band: tuple[float, float]
    kind: Kind
    warnings: tuple[str, ...]
    unit: DriveUnit = "V"

    @property
    def quantity(self) -> str:
        """Quantity of the samples."""
        return "voltage" if self.unit == "V" else "force"

    @property
    def duration(self) -> float:
        """Duration of one period, s."""
        return len(self.samples) / self.sample_rate

    @property
    def line_spacing(self) -> float:
        """Line spacing, Hz."""
        return 1 / self.duration

    @property
    def crest_factor(self) -> float:
        """Largest value over root mean square: 1.41 for a sine; smaller is better."""
        return float(np.abs(self.samples).max() / np.sqrt(np.mean(self.samples**2)))


def drive(
    *,
    low: float,
    high: float,
    sample_rate: float,
    duration: float,
    amplitude: float = 1.0,
    kind: Kind = "chirp",
    quality_factor: float | None = None,
    unit: DriveUnit = "V",
) -> Drive:
    """Make one period of a periodic drive.

    Parameters
    ----------
    low, high : edges of the band, Hz; moved inwards to the nearest lines
    sample_rate : Hz; the period is rounded to whole samples
    duration : duration of one period, s
    amplitude : largest value, in ``unit``
    kind : "chirp" sweeps linearly through the band; "multisine" has lines of equal size in the band and none
        outside, with phases that keep the crest factor low [schroeder1970]
    quality_factor : quality factor of the plate, to check that a ring-down fits into the period

    Raises
    ------
    ScanError : a band that is empty or reaches beyond half the rate, sizes that are not positive
    """
    if kind not in KINDS:
        raise ScanError.unknown("drive.kind", kind, KINDS, "the name is misspelt")
    for name, given in (("sample_rate", sample_rate), ("duration", duration), ("amplitude", amplitude),
                        ("quality_factor", 1.0 if quality_factor is None else quality_factor)):  # fmt: skip
        if not (np.isfinite(given) and given > 0):
            raise _wrong(name, f"{given:g}", "a positive number", "give it in Hz, s or V")
    if not 0 <= low < high <= sample_rate / 2:
        allowed = f"0 <= low < high <= {sample_rate / 2:g} Hz, half the sample rate"
        raise _wrong("band", f"{low:g} to {high:g} Hz", allowed, "lower the band, or raise the sample rate")
    samples = round(duration * sample_rate)
    spacing = sample_rate / samples if samples else np.inf
    first = max(1, int(np.ceil(low / spacing * (1 - 1e-9))))
    last = int(np.floor(high / spacing * (1 + 1e-9)))
    if last <= first:
        allowed = f"at least two lines, {spacing:g} Hz apart, between low and high"
        raise _wrong("duration", f"{duration:g} s", allowed, "make the period longer, or the band wider")
    band = (first * spacing, last * spacing)
    period = _chirp(samples, first, last) if kind == "chirp" else _multisine(samples, first, last)
    notes = _warnings(band, sample_rate, samples / sample_rate, quality_factor)
    for note in notes:
        warnings.warn(note, HaptonicWarning, stacklevel=2)
    scaled = period * (amplitude / np.abs(period).max())
    scaled.setflags(write=False)
    return Drive(
        samples=scaled, sample_rate=float(sample_rate), band=band, kind=kind, warnings=tuple(notes), unit=unit
    )


def drive_notes(signal: Drive, periods: int = 1) -> dict[str, Any]:
    """Notes that a file of samples lacks: rate and band (Hz), unit, full scale, crest factor."""
    return {
        "sample_rate": signal.sample_rate, "low": signal.band[0], "high": signal.band[1],
        "kind": signal.kind, "period_samples": len(signal.samples), "periods": periods, "unit": signal.unit,
        "full_scale": float(np.abs(signal.samples).max()), "crest_factor": signal.crest_factor,
    }  # fmt: skip


def write_drive(signal: Drive, path: Path, *, periods: int = 1) -> None:
    """Write a drive as WAV, CSV or HDF5, by the suffix of the path.

    A WAV file has 16 bits and no unit: its full scale is the largest value, which `drive_notes` gives.
    The others are in the drive's unit. `haptonic.atomic.write_atomically` makes a file whole.

    Raises
    ------
    ScanError : another suffix, or a number of periods below 1
    """
    if periods < 1:
        raise _wrong("periods", str(periods), "1 or more", "give how often the period is repeated")
    samples = np.tile(signal.samples, periods)
    if path.suffix == ".wav":
        if signal.sample_rate != round(signal.sample_rate):
            raise _wrong("sample_rate", f"{signal.sample_rate:g} Hz", "whole Hz in WAV", "use CSV or HDF5")
        wav.write(path, samples, int(signal.sample_rate))
    elif path.suffix == ".csv":
        time = np.arange(len(samples)) / signal.sample_rate
        delimited.write(path, {"time (s)": time, f"{signal.quantity} ({signal.unit})": samples})
    elif path.suffix in (".h5", ".hdf5"):
        notes = {"kind_of_file": "haptonic drive", **drive_notes(signal, periods)}
        hdf5.write(path, [Channel.of(signal.quantity, samples, signal.unit)], notes)
    else:
        given = path.suffix or "no suffix"
        raise _wrong("path", given, ".wav, .csv, .h5 or .hdf5", "choose one of these suffixes")


def _chirp(samples: int, first: int, last: int) -> Array:
    """Linear sweep over the whole period. It is periodic: the phase advances by a whole number of turns."""
    turn = np.arange(samples) / samples
    phase = first * turn + 0.5 * (last - first) * turn**2
    closing = round(0.5 * (first + last)) - 0.5 * (first + last)  # half a turn at most, spread evenly
    return np.asarray(np.sin(2 * np.pi * (phase + closing * turn)))


def _multisine(samples: int, first: int, last: int) -> Array:
    """Lines of equal amplitude with Schroeder's phases, -pi k (k - 1) / n, which spread the group delays."""
    number = np.arange(1, last - first + 2)
    spectrum = np.zeros(samples // 2 + 1, dtype=complex)
    spectrum[first : last + 1] = np.exp(-1j * np.pi * number * (number - 1) / len(number))
    return np.asarray(np.fft.irfft(spectrum, n=samples))


def _warnings(
    band: tuple[float, float], sample_rate: float, duration: float, quality_factor: float | None
) -> list[str]:
    notes = []
    half = sample_rate / 2
    safe = NYQUIST_MARGIN * half
    if band[1] > safe:
        notes.append(
            f"the band reaches {hz_text(band[1], form='g')}, "
            f"{in_percent(band[1] / half)} of half the sample rate "
            f"({hz_text(half, form='g')}): lines there are bent by the converters' filters or folded "
            f"back; stay below {hz_text(safe, form='g')} or sample at "
            f"{hz_text(band[1] / safe * sample_rate, form='g')}"
        )
    if quality_factor is not None:
        needed = RING_DOWNS * quality_factor / band[0]
        if duration < needed:
            notes.append(
                f"the period of {duration * 1e3:g} ms is shorter than {needed * 1e3:.4g} ms, the ring-down "
                f"3 Q / f at {hz_text(band[0], form='g')}: repeat it, and do not record the first period, "
                f"or record a single shot of at least {needed * 1e3:.4g} ms"
            )
    return notes


def _wrong(argument: str, given: str, allowed: str, next_step: str) -> ScanError:
    return ScanError.out_of_range(
        argument=f"drive.{argument}",
        given=given,
        allowed=allowed,
        cause="a value in another unit, or one that was meant for another instrument",
        next_step=next_step,
    )
