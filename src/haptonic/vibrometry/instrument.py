"""Simulated vibrometer: records that a real one would give of a known response; all marked as simulated."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Annotated

import numpy as np
import scipy
from numpy.typing import NDArray
from pydantic import Field

from haptonic.arrays import AnyComplex, Array
from haptonic.channels.signals import Samples
from haptonic.errors import ScanError
from haptonic.fields import Frequency, Quantity, described, setting
from haptonic.response import FrequencyResponse
from haptonic.vibrometry.chirp import Drive
from haptonic.vibrometry.records import TimeScan

Velocity = Annotated[float, Quantity("m/s", above=0.0, at_most=1e3, typical=(1e-7, 10.0))]

SAME = 1e-6  # of the line spacing: largest difference between lines of drive and response
HEADROOM = 1.25  # of the default range, over the largest velocity
LOST = (0.03, 0.12)  # of a record, shortest and longest dropout
PORTION = 32e6  # bytes in memory at a time during the search for the largest velocity


@described("scan", kw_only=True)
class Instrument:
    """Effect of a vibrometer and its converter on a velocity. Its noise is white."""

    bits: Annotated[int, Field(ge=4, le=32, strict=True)] = setting(
        16, "Bits of the converter that records the vibrometer."
    )
    noise: Annotated[float, Quantity("m/s", at_least=0.0, at_most=1e3, typical=(0.0, 1e-2))] = setting(
        5e-5, "Noise of the vibrometer, root mean square of the samples."
    )
    full_scale: Velocity | None = setting(
        None, "Largest velocity of the vibrometer; by default 1.25 of the velocity.", title="Range"
    )
    dropouts: Annotated[float, Quantity("", at_least=0.0, below=1.0, typical=(0.0, 0.1))] = setting(
        0.005, "Share of points at which the laser loses the surface."
    )
    delay: Annotated[float, Quantity("s", at_least=0.0, at_most=1.0, typical=(0.0, 1e-3))] = setting(
        0.0, "Delay of the vibrometer behind the drive; the analysis removes it."
    )
    bandwidth: Frequency | None = setting(
        None, "-3 dB of its first-order low-pass; the analysis takes it out."
    )

    def path(self, frequency: Array) -> NDArray[np.complex128]:
        """(frequency,) factor of delay and low-pass on a velocity."""
        through: NDArray[np.complex128] = np.exp(-2j * np.pi * frequency * self.delay)
        return (
            through if self.bandwidth is None else np.asarray(through / (1 + 1j * frequency / self.bandwidth))
        )

    def taken_out(self, response: FrequencyResponse) -> FrequencyResponse:
        """The response without delay and low-pass; a second call changes nothing."""
        old, notes = response.dataset["response"], response.dataset.attrs
        inputs = json.loads(notes["inputs"])
        if "path" in inputs or (not self.delay and self.bandwidth is None):
            return response
        path = self.path(response.frequency).astype(response.values.dtype)
        inputs["path"] = {"delay": self.delay, "bandwidth": self.bandwidth}
        values = response.values / path[:, None, None]
        values.setflags(write=False)
        corrected = response.dataset.assign(response=(old.dims, values, old.attrs))
        return FrequencyResponse(corrected.assign_attrs(inputs=json.dumps(inputs)))


def lines_of(signal: Drive) -> Array:
    """Driven lines within the band of a drive, both edges included, Hz."""
    members = _members(signal)
    return np.asarray(np.arange(members.start, members.stop) * signal.line_spacing)


def recorded(
    response: FrequencyResponse, signal: Drive, instrument: Instrument, *, averages: int, seed: int
) -> TimeScan:
    """Simulate time records of a steady state: after some periods of a periodic drive a plate is periodic.

    Only the response is in memory: records are computed on reading, and are the same each time. The drive's
    record is that of an ideal channel, the same for all points.

    Parameters
    ----------
    response : velocity along z at the driven lines, per V (or N) of the drive
    averages : periods at each point
    seed : seed of noise and dropouts

    Raises
    ------
    ScanError : the response is not at the lines of the drive
    """
    lines = lines_of(signal)
    same = len(lines) == len(response.frequency)
    if not same or np.abs(response.frequency - lines).max() > SAME * signal.line_spacing:
        computed = response.frequency
        raise ScanError.mismatch(
            argument="response",
            given=f"{len(computed)} lines from {computed[0]:g} to {computed[-1]:g} Hz",
            allowed=f"{len(lines)} lines from {lines[0]:g} to {lines[-1]:g} Hz, those of the drive",
            cause="the response was computed for another drive",
            next_step="compute it at these lines, or change record, lowest and highest of the scan",
        )
    notes, points = response.dataset.attrs, response.points
    spectrum = scipy.fft.rfft(signal.samples)[_members(signal)] * instrument.path(lines)
    values = response.values[:, :, list(response.dataset["direction"].values).index("z")]
    largest = 2.0 ** (instrument.bits - 1) - 1
    kind = np.int16 if instrument.bits <= 16 else np.int32
    size = max(1, int(PORTION / (8.0 * len(signal.samples))))
    full = instrument.full_scale or HEADROOM * max(
        float(np.abs(_moved(values[:, i : i + size], spectrum, signal)).max())
        for i in range(0, len(points), size)
    )
    drive_scale = float(np.abs(signal.samples).max()) / largest
    reference = np.rint(signal.samples / drive_scale).astype(kind)
    source = _Simulated(
        values=values, spectrum=spectrum, signal=signal, instrument=instrument, averages=averages,
        seed=seed, scale=full / largest, largest=largest,
        reference=np.tile(reference, (1, averages, 1)),
    )  # fmt: skip
    return TimeScan(
        source=source, names=tuple(str(i + 1) for i in range(len(points))), x=points[:, 0].copy(),
        y=points[:, 1].copy(),
        repeats=averages, samples=len(signal.samples), sample_rate=signal.sample_rate,
        reference=response.reference,
        motion="displacement" if notes["quantity"] == "displacement" else "velocity",
        reference_scale=drive_scale, response_scale=full / largest, full_scale=largest,
        origin="simulated", title=f"simulated scan, seed {seed}",
    )  # fmt: skip


@dataclass(frozen=True, eq=False)
class _Simulated:
    """Source of simulated records. values : (line, point); spectrum : (line,) of drive and path."""

    values: AnyComplex
    spectrum: AnyComplex
    signal: Drive
    instrument: Instrument
    averages: int
    seed: int
    scale: float
    largest: float
    reference: Samples

    def load(self, start: int, stop: int) -> tuple[Samples, Samples]:
        moved = _moved(self.values[:, start:stop], self.spectrum, self.signal) / np.float32(self.scale)
        count, samples = moved.shape
        records = np.empty((count, self.averages, samples), self.reference.dtype)
        for row, point in enumerate(range(start, start + count)):
            # one for each point: any order of reading is possible
            chance = np.random.default_rng([self.seed, point])
            noise = chance.standard_normal((self.averages, samples), dtype=np.float32)
            seen = moved[row] + np.float32(self.instrument.noise / self.scale) * noise
            if chance.random() < self.instrument.dropouts:
                length = int(chance.uniform(*LOST) * samples)
                begin = int(chance.integers(0, samples - length))
                where = int(chance.integers(self.averages))
                seen[where, begin : begin + length] = seen[where, begin]
            records[row] = np.rint(np.clip(seen, -self.largest, self.largest))
        return self.reference, records


def _members(signal: Drive) -> slice:
    first, last = (round(edge * signal.duration) for edge in signal.band)
    return slice(first, last + 1)


def _moved(values: AnyComplex, spectrum: AnyComplex, signal: Drive) -> NDArray[np.float32]:
    """(point, sample) one period of the velocity, m/s."""
    samples = len(signal.samples)
    whole = np.zeros((values.shape[1], samples // 2 + 1), dtype=np.complex64)
    whole[:, _members(signal)] = (values * spectrum[:, None]).T
    return np.asarray(scipy.fft.irfft(whole, n=samples, axis=1), dtype=np.float32)
