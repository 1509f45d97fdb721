"""From time records to frequency responses, a few points at a time."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.channels import Notebook
from haptonic.channels.labels import steps
from haptonic.channels.signals import Samples
from haptonic.errors import ScanError
from haptonic.parallel import streamed
from haptonic.progress import Progress, silent
from haptonic.response import FrequencyResponse
from haptonic.vibrometry.estimation.progress import Growing, growing
from haptonic.vibrometry.estimation.quality import (
    Quality,
    assessed,
    clipped_share,
    frozen_share,
    repaired,
)
from haptonic.vibrometry.estimation.spectra import (
    ESTIMATORS,
    Estimator,
    Real,
    WindowName,
    rolled,
    segmented,
    shifts,
    spectra_of,
    transformed,
    window_of,
)
from haptonic.vibrometry.findings import ReadReport
from haptonic.vibrometry.records import TimeScan

__all__ = ["Estimate", "Quality", "estimate", "repaired", "window_of"]

WORKING_MEMORY = 192e6  # bytes for the transforms of a portion, all at once
EXCITED = 1e-8  # of the largest power of the drive; lines below it count as not driven


@dataclass(frozen=True, eq=False)
class Estimate:
    """A frequency response estimated from records, the quality of its points, and the content left out."""

    response: FrequencyResponse
    quality: Quality
    report: ReadReport
    averages: int

    @classmethod
    def by_instrument(cls, response: FrequencyResponse, report: ReadReport) -> Estimate:
        """An estimate from a response that the instrument computed; only its coherence is known."""
        data, points = response.dataset, response.dataset.sizes["point"]
        median = np.full(points, np.nan)
        if "coherence" in data:
            median = np.median(data["coherence"].values, axis=0).astype(float)
        points_of_file = json.loads(data.attrs["inputs"]).get("points")
        names = (
            points_of_file
            if isinstance(points_of_file, list) and len(points_of_file) == points
            else range(1, points + 1)
        )
        quality = assessed(tuple(map(str, names)), np.zeros(points), np.zeros(points), median)
        return cls(response, quality, report, 0)

    def repaired(self, *flags: str) -> Estimate:
        """A copy in which points with one of these flags are replaced by their neighbours, and marked.

        Raises
        ------
        ScanError : an unknown flag, or too few points without flags
        """
        response, quality = repaired(self.response, self.quality, flags)
        return Estimate(response, quality, self.report, self.averages)


@dataclass(frozen=True)
class _Plan:
    """All settings for the computation of a portion of a given scan."""

    estimator: Estimator
    length: int
    step: int
    lines: slice
    driven_lines: NDArray[np.int64] = field(compare=False)
    window: Real | None = field(compare=False)
    like: Real | None = field(compare=False)
    single: bool
    factor: NDArray[Any] = field(compare=False)


def estimate(
    scan: TimeScan,
    *,
    estimator: Estimator = "H1",
    window: WindowName = "none",
    decay: float | None = None,
    segment: int | None = None,
    overlap: float = 0.0,
    band: tuple[float, float] | None = None,
    align: bool = False,
    state: Path | None = None,
    progress: Progress = silent,
    workers: int = 1,
) -> Estimate:
    """Estimate the frequency responses of all points, read once from the file, a portion at a time.

    Records of 16-bit integers or of single precision are transformed in single precision: its error is far
    below their own noise. Lines that the drive leaves out are left out of the result, with a remark.

    Parameters
    ----------
    estimator : "H1" for noise on the response (a laser's), "H2" for noise on the reference, "Hv" for both
    window : "none" for periodic chirps, "exponential" for bursts, "hann" for random drives, see `window_of`
    decay : of the exponential window, s
    segment : samples of one transform, such as a period of the drive; by default a whole record
    overlap : overlap of consecutive segments, from 0 to below 1
    band : lowest and highest frequency, Hz
    align : shift each record so that its reference starts like that of the very first record
    state : folder in which a stopped estimation is continued
    progress : function of the number of points done and their total
    workers : threads that process portions while the next ones are read

    Returns
    -------
    A velocity or displacement per unit of the reference; it has a coherence if there is more than one
    average.

    Raises
    ------
    ScanError : settings that contradict the records, or no point left
    """
    plan = _planned(scan, estimator, window, decay, segment, overlap, band, align)
    points = len(scan.names)
    lines = np.asarray(np.fft.rfftfreq(plan.length, 1 / scan.sample_rate), dtype=float)
    frequency = lines[plan.lines][plan.driven_lines]
    settings = {
        "estimator": estimator, "window": window, "decay": decay, "segment": plan.length, "overlap": overlap,
        "band": [float(frequency[0]), float(frequency[-1])], "align": align,
    }  # fmt: skip
    key = settings | {"scan": _fingerprint(scan)}
    store = growing((len(frequency), points), plan.single, key, state)
    averages = scan.repeats * ((scan.samples - plan.length) // plan.step + 1)
    size = max(1, int(WORKING_MEMORY / (48.0 * plan.length * averages)))
    try:
        for portion in _computed(scan, plan, size, store.done, workers):
            last = portion.first + len(portion.measures)
            store.response[:, portion.first : last] = portion.response.T
            store.coherence[:, portion.first : last] = portion.coherence.T
            store.measures[portion.first : last] = portion.measures
            store.done = last
            store.keep()
            progress(store.done, points)
    finally:
        store.keep(now=True)
    return _finished(scan, store, plan, frequency, averages, settings)


def _planned(
    scan: TimeScan,
    estimator: Estimator,
    window: WindowName,
    decay: float | None,
    segment: int | None,
    overlap: float,
    band: tuple[float, float] | None,
    align: bool,
) -> _Plan:
    if estimator not in ESTIMATORS:
        raise ScanError.unknown("estimator", estimator, ESTIMATORS, "the name is misspelt")
    length = scan.samples if segment is None else segment
    if not 2 <= length <= scan.samples:
        allowed = f"2 to {scan.samples} samples, the length of a record"
        raise _wrong("segment", f"{length} samples", allowed, "give the samples of one period of the drive")
    if not 0 <= overlap < 1:
        raise _wrong("overlap", f"{overlap:g}", "from 0 to below 1", "give a share, such as 0.5 for half")
    step = max(1, length - int(overlap * length))
    reference, response = scan.load(0, min(8, len(scan.names)))
    low, high = band if band is not None else (0.0, scan.sample_rate / 2)
    frequency = np.fft.rfftfreq(length, 1 / scan.sample_rate)
    # at 0 Hz there is no motion
    first = max(1, int(np.searchsorted(frequency, low * (1 - 1e-9))))
    last = int(np.searchsorted(frequency, high * (1 + 1e-9), side="right"))
    if not first < last:
        allowed = (
            f"a band with at least one of the lines, {frequency[1]:g} Hz apart, up to {frequency[-1]:g} Hz"
        )
        raise _wrong(
            "band", f"{low:g} to {high:g} Hz", allowed, "give both limits in Hz, the lower one first"
        )
    single = all(a.dtype.itemsize <= 2 or a.dtype == np.float32 for a in (reference, response))
    weights = window_of(window, length, scan.sample_rate, decay)
    drive = segmented(reference.astype(np.float64), length, step)
    probe = transformed(drive, None, slice(first, last))
    mean = (np.abs(probe) ** 2).mean(axis=1)
    power = np.where(np.isfinite(mean), mean, 0).max(axis=0)
    driven_lines = np.flatnonzero(power > EXCITED * power.max())
    if not len(driven_lines):
        given = "no signal in the first points' records"
        raise _wrong("reference", given, "a drive with power in the band", "check the reference's cable")
    power_of_i = steps(scan.motion, "displacement" if scan.motion == "displacement" else "velocity")
    scale = scan.response_scale / scan.reference_scale
    factor = scale * (2j * np.pi * frequency[first:last][driven_lines]) ** power_of_i
    like = reference[0, 0].astype(np.float64) if align else None
    return _Plan(
        estimator=estimator,
        length=length,
        step=step,
        lines=slice(first, last),
        driven_lines=driven_lines,
        window=weights,
        like=like,
        single=single,
        factor=factor,
    )


@dataclass(frozen=True, eq=False)
class _Portion:
    """Results of the points from ``first`` on, (point, line) and (point, 3); see `Growing`."""

    first: int
    response: NDArray[Any]
    coherence: NDArray[Any]
    measures: NDArray[np.float64]


def _computed(scan: TimeScan, plan: _Plan, size: int, start: int, workers: int) -> Iterator[_Portion]:
    """Portions in their order; the next one is read while threads process earlier ones."""

    def estimated(portion: tuple[int, Samples, Samples]) -> _Portion:
        return _estimated(*portion, scan.full_scale, plan)

    yield from streamed(estimated, scan.chunks(size, start=start), workers, workers + 1)


def _estimated(
    first: int, reference: Samples, response: Samples, full_scale: float | None, plan: _Plan
) -> _Portion:
    """Estimate a portion point by point: the data of a point fit into the processor's cache for reuse."""
    kind, count = np.float32 if plan.single else np.float64, len(response)
    values = np.empty((count, len(plan.driven_lines)), np.complex64 if plan.single else np.complex128)
    coherence = np.empty(values.shape, kind)
    shared = len(reference) == 1
    x = _transforms(reference.astype(kind), None, plan) if shared and plan.like is None else None
    y: Real = np.empty((1, *response.shape[1:]), kind)
    factor = plan.factor.astype(values.dtype)
    for point in range(count):
        y[0] = response[point]
        drive, lags = x, None
        if drive is None:
            point_reference: Real = reference[0 if shared else point][None].astype(kind)
            lags = None if plan.like is None else shifts(point_reference.astype(np.float64), plan.like)
            drive = _transforms(point_reference, lags, plan)
        spectra = spectra_of(drive, _transforms(y, lags, plan))
        values[point] = spectra.response(plan.estimator)[0, plan.driven_lines] * factor
        coherence[point] = spectra.coherence()[0, plan.driven_lines]
    fine: NDArray[np.bool_] = np.asarray((np.isfinite(values) & np.isfinite(coherence)).all(axis=1))
    median = np.median(np.where(fine[:, None], coherence, 0.0), axis=1)
    measures = np.stack(
        [clipped_share(response, full_scale), frozen_share(response), np.where(fine, median, np.nan)], axis=1
    )
    return _Portion(first, values, coherence, measures)


def _transforms(records: Real, lags: NDArray[np.int64] | None, plan: _Plan) -> NDArray[Any]:
    """(point, segment, line) transforms of records (point, repeat, sample), advanced by their lags."""
    moved = records if lags is None else rolled(records, lags)
    return transformed(segmented(moved, plan.length, plan.step), plan.window, plan.lines)


def _finished(
    scan: TimeScan,
    store: Growing,
    plan: _Plan,
    frequency: NDArray[np.float64],
    averages: int,
    settings: dict[str, Any],
) -> Estimate:
    notes = Notebook(Path(scan.title or "records"), "time records")
    dead = np.isnan(store.measures[:, 2])
    for name in np.array(scan.names)[dead]:
        notes.drop(f"point {name}", "samples that are not finite, or no signal in one of the channels")
    if dead.all():
        given = "no point with a signal in both channels"
        raise _wrong("records", given, "at least one usable point", "check the channels and their order")
    lost = len(range(*plan.lines.indices(plan.length))) - len(frequency)
    if lost:
        notes.remark(f"{lost} lines of the band are not driven and were left out")
    if averages == 1:
        notes.remark("one average only: the coherence has no meaning and was left out")
    everything = not dead.any()
    keep = np.flatnonzero(~dead)
    response = store.response if everything else store.response[:, keep]
    coherence = store.coherence if everything else store.coherence[:, keep]
    names = tuple(np.array(scan.names)[keep].tolist())
    measures = store.measures[keep]
    median = measures[:, 2] if averages > 1 else np.full(len(keep), np.nan)
    frequency_response = FrequencyResponse.of(
        np.asarray(response)[..., None],
        frequency=frequency, x=scan.x[keep], y=scan.y[keep], direction=[scan.direction],
        quantity="displacement" if scan.motion == "displacement" else "velocity",
        reference=scan.reference, origin=scan.origin, title=scan.title,
        coherence=np.asarray(coherence) if averages > 1 else None,
        inputs=settings | {"averages": averages, "points": list(names)},
    )  # fmt: skip
    quality = assessed(names, measures[:, 0], measures[:, 1], median)
    return Estimate(frequency_response, quality, ReadReport.of(notes, len(keep)), averages)


def _fingerprint(scan: TimeScan) -> str:
    """Digest of the scan's form and its first and last point: enough to detect the folder of another scan."""
    digest = hashlib.sha256(repr((scan.names, scan.repeats, scan.samples, scan.sample_rate)).encode())
    for first in sorted({0, len(scan.names) - 1}):
        for samples in scan.load(first, first + 1):
            digest.update(np.ascontiguousarray(samples).tobytes())
    digest.update(np.concatenate([scan.x, scan.y]).tobytes())
    return digest.hexdigest()


def _wrong(argument: str, given: str, allowed: str, next_step: str) -> ScanError:
    return ScanError.out_of_range(
        argument=argument,
        given=given,
        allowed=allowed,
        cause="the settings belong to other records",
        next_step=next_step,
    )
