"""From the content of scan files to all that a scan tells, with the plate of a study or without one."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import scipy

from haptonic.arrays import Array
from haptonic.bloch import Gap
from haptonic.bloch.settings import BandSettings
from haptonic.errors import HaptonicError, ResponseError, ScanError
from haptonic.gate import WORD
from haptonic.later import xarray as xr
from haptonic.plate import Plate
from haptonic.plate.levels import compared, marked_lines
from haptonic.plate.sampling import driven_region, tile_names
from haptonic.progress import Progress, silent
from haptonic.response import FrequencyResponse, average_spectrum
from haptonic.response.measures import sides
from haptonic.results.plain import along
from haptonic.results.scan.value import ScanResult
from haptonic.store import Store
from haptonic.vibrometry import (
    Estimate,
    MeasuredGap,
    ReadReport,
    Registration,
    Scan,
    TimeScan,
    clean_contrast,
    clean_rms,
    estimate,
    register_by_corners,
    register_by_fit,
    warn_if_aliased,
    wavenumber_map,
)
from haptonic.vibrometry.estimation.quality import assessed
from haptonic.vibrometry.estimation.spectra import Estimator, WindowName
from haptonic.vibrometry.guides import guides_of, mirror_beside, without_mode
from haptonic.vibrometry.of_settings import Tiles, plan_for
from haptonic.vibrometry.on_plate import contrast_range, decay_in, lattice_gap
from haptonic.vibrometry.settings import ScanSettings
from haptonic.vibrometry.theory import computed_waves

FAR = 0.5  # of a step of the grid: a worse misfit of a registration is told
SAME_SCALE = 0.05  # by which a registration may scale before it is told


@dataclass(frozen=True)
class Estimation:
    """How records become responses; see `haptonic.vibrometry.estimate`.

    segment : length of one transform, s; None takes the period of the study's drive, or a whole record
    state : folder from which a stopped estimation goes on; repair : flags of points that are replaced
    """

    estimator: Estimator = "H1"
    window: WindowName = "none"
    decay: float | None = None
    segment: float | None = None
    overlap: float = 0.0
    align: bool = False
    state: Path | None = None
    repair: tuple[str, ...] = ()


@dataclass(frozen=True)
class OnPlate:
    """What a study says about a scanned plate.

    carrier : Hz; gap : of its lattice; bands : what is asked of its bands
    corners : (4, 2) of the plate as the scan sees them, from the lower left one anticlockwise, m; else the
        points are fitted to the planned ones
    mirrored : the scan sees the plate from behind
    """

    plate: Plate
    scan: ScanSettings
    carrier: float
    gap: Gap | None
    bands: BandSettings
    corners: Array | None = None
    mirrored: bool = False


def compute_scan(
    scan: Scan,
    how: Estimation,
    on: OnPlate | None,
    *,
    at: float | None = None,
    store: Store,
    progress: Progress = silent,
) -> ScanResult:
    """All that a scan tells.

    Parameters
    ----------
    at : frequency of the operating shape and its animation, Hz; else the loudest
    progress : called with the points done and their number

    Raises
    ------
    ScanError : settings that do not fit the scan, or nothing left of it
    ResponseError : ``at`` is not covered
    """
    found = _estimated(scan, how, on, progress)
    if how.repair:
        found = found.repaired(*how.repair)
    response = found.response
    if at is not None:
        at = float(response.at(at).frequency[0])
    report = _joined(scan.report, found.report)
    data = xr.Dataset({"average": average_spectrum(response)})
    axes = [str(name) for name in response.dataset["direction"].values]
    unseen = [] if "z" in axes else [f"no maps: motions along {', '.join(axes)}, none normal to the plate"]
    plain = ScanResult(
        response=response,
        quality=found.quality,
        report=report,
        averages=found.averages,
        data=data,
        shapes=(),
        undetermined=tuple(unseen),
    )
    if on is None:
        loudest = float(response.frequency[int(data["average"].values.argmax())])
        return replace(plain, shapes=(loudest if at is None else at,))
    registration = _registration(response, on)
    layout = on.plate.layout
    response = _without_path(
        registration.registered(response, {n: Tiles(layout, n) for n in layout.regions}), on
    )
    stands_out, told = _told_on_plate(response, on, data)
    told += unseen
    lattice = lattice_gap(response, on.plate, data)
    edges = None if on.gap is None else (on.gap.lower, on.gap.upper)
    names = [str(name) for name in response.dataset["region"].values]
    marked = marked_lines(on.plate, response.frequency, response.values[..., 0].T, names, on.carrier, edges)
    shapes = tuple(response.frequency[marked].tolist()) if at is None else (at,)
    driven = driven_region(on.plate)
    mirror = mirror_beside(layout, driven) if driven else None
    waves = None
    if layout.cells:
        span = float(response.frequency[0]), float(response.frequency[-1])
        parts = layout, on.bands, span, on.gap, guides_of(layout), mirror
        waves = store.kept({"kind": "waves beside a scan", "of": parts}, lambda: computed_waves(*parts))
        told += without_mode(layout)
        shortest = 2 * np.pi / float(waves["wavenumber"].max())
        warn_if_aliased(_step(response), shortest, f"the flexural wave at {span[1] / 1e3:.4g} kHz")
    if registration.misfit > FAR * _step(response):
        told.append(
            f"points lie {registration.misfit * 1e3:.2g} mm off the planned places: check the registration"
        )
    if abs(registration.scale - 1) > SAME_SCALE:
        told.append(f"lengths were scaled by {registration.scale:.4g} to fit the plate: check their unit")
    outside = sum(name is None for name in tile_names(layout, response.points))
    if outside:
        told.append(f"{outside} points lie beside the plate of the study")
    return replace(
        plain, response=response, shapes=shapes, plate=on.plate, carrier=on.carrier, gap=on.gap,
        measured=stands_out, lattice=lattice, registration=registration, waves=waves, mirror=mirror,
        undetermined=tuple(told),
    )  # fmt: skip


def _joined(read: ReadReport, estimated: ReadReport) -> ReadReport:
    """The report of a file with what was left out of it later."""

    def both(first: tuple[Any, ...], second: tuple[Any, ...]) -> tuple[Any, ...]:
        return tuple(dict.fromkeys((*first, *second)))

    return replace(
        read, points=estimated.points, dropped=both(read.dropped, estimated.dropped),
        remarks=both(read.remarks, estimated.remarks),
    )  # fmt: skip


def _estimated(scan: Scan, how: Estimation, on: OnPlate | None, progress: Progress) -> Estimate:
    """The response of a scan and the quality of its points, estimated where the scan has time records."""
    if isinstance(scan.content, FrequencyResponse):
        response = scan.content
        coherence = response.dataset["coherence"].values if "coherence" in response.dataset else None
        points = response.dataset.sizes["point"]
        median = np.full(points, np.nan) if coherence is None else np.median(coherence, axis=0).astype(float)
        known = json.loads(response.dataset.attrs["inputs"]).get("points")
        names = known if isinstance(known, list) and len(known) == points else range(1, points + 1)
        quality = assessed(tuple(map(str, names)), np.zeros(points), np.zeros(points), median)
        return Estimate(response, quality, scan.report, 0)
    records = scan.records
    segment, band = how.segment, None
    if on is not None:
        fits = on.scan.record * records.sample_rate <= records.samples * (1 + 1e-9)
        segment = on.scan.record if segment is None and fits else segment
        low, high = on.scan.lowest, min(on.scan.highest, 0.5 * records.sample_rate)
        band = (low, high) if low < high else None
    return estimate(
        records,
        estimator=how.estimator, window=how.window, decay=how.decay, overlap=how.overlap, align=how.align,
        segment=None if segment is None else _samples(segment, records), band=band, state=how.state,
        progress=progress, workers=2,
    )  # fmt: skip


def _samples(segment: float, records: TimeScan) -> int:
    return round(segment * records.sample_rate)


def _registration(response: FrequencyResponse, on: OnPlate) -> Registration:
    layout = on.plate.layout
    if on.corners is not None:
        right, top = layout.x[-1], layout.y[-1]
        corners = np.array([[0.0, 0.0], [right, 0.0], [right, top], [0.0, top]])
        return register_by_corners(on.corners, corners, mirrored=on.mirrored)
    return register_by_fit(response.points, plan_for(on.scan, on.plate).points, mirrored=on.mirrored)


def _without_path(response: FrequencyResponse, on: OnPlate) -> FrequencyResponse:
    """The response without delay and low-pass of the instrument that the study gives, taken out once."""
    instrument, old, notes = on.scan.instrument, response.dataset["response"], response.dataset.attrs
    inputs = json.loads(notes["inputs"])
    if "path" in inputs or (not instrument.delay and instrument.bandwidth is None):
        return response
    path = instrument.path(response.frequency).astype(response.values.dtype)
    inputs["path"] = {"delay": instrument.delay, "bandwidth": instrument.bandwidth}
    values = response.values / path[:, None, None]
    values.setflags(write=False)
    made = response.dataset.assign(response=(old.dims, values, old.attrs))
    return FrequencyResponse(made.assign_attrs(inputs=json.dumps(inputs)))


def _told_on_plate(
    response: FrequencyResponse, on: OnPlate, data: xr.Dataset
) -> tuple[MeasuredGap | None, list[str]]:
    """Fill a dataset with what the regions tell; the range of high contrast, and why something could not be
    told."""
    layout, told, driven = on.plate.layout, [], driven_region(on.plate)
    named = {name: clean_rms(response, name) for name in response.regions if name}
    if named:
        data["rms"] = along(named, "region")
    levels = {
        f"{driven} over {words}": clean_contrast(response, *sides(response, driven or "", other))
        for words, other in compared(response, driven)
    }
    if levels:
        data["contrast"] = along({pair: level["level"] for pair, level in levels.items()}, "pair")
        data["error_of_contrast"] = along({pair: level["error"] for pair, level in levels.items()}, "pair")
    for pair, level in levels.items():
        if hidden := int(np.isnan(level["level"].values).sum()):
            told.append(f"noise hides the contrast of {pair} at {hidden} line{'s' if hidden > 1 else ''}")
    waves: dict[str, xr.DataArray] = {}
    for guide in guides_of(layout):
        try:
            waves[guide.region] = wavenumber_map(response, guide.region, guide.along)
        except HaptonicError as error:
            told.append(f"no waves along {guide.region}: {error.given}; {error.cause}")
    if waves:
        data.update(_by_guide(waves))
    if driven is None:
        return None, [*told, "no contrast: the study does not say which region is driven"]
    found = None
    try:
        found = contrast_range(response, on.plate)
    except (ScanError, ResponseError) as error:
        told.append(f"no range of high contrast: {error.given}")
    mirror = mirror_beside(layout, driven)
    if mirror is not None:
        try:
            decay = decay_in(response, mirror)
        except (ScanError, ResponseError) as error:
            told.append(f"no decay: {error.given}")
        else:
            data.update(decay.rename(error="error_of_decay"))
            data.attrs["decay"] = json.dumps(decay.attrs)
    return found, told


def _by_guide(waves: Mapping[str, xr.DataArray]) -> xr.Dataset:
    """Waves along guides, whose wavenumbers are as many as each guide has points; NaN behind them."""
    longest = max(one.sizes["wavenumber"] for one in waves.values())
    lines = next(iter(waves.values()))["frequency"]
    amplitude = np.full((len(waves), len(lines), longest), np.nan)
    wavenumber = np.full((len(waves), longest), np.nan)
    for row, one in enumerate(waves.values()):
        amplitude[row, :, : one.sizes["wavenumber"]] = one.values
        wavenumber[row, : one.sizes["wavenumber"]] = one["wavenumber"].values
    first = next(iter(waves.values()))
    shorter = {WORD: "a shorter guide has fewer wavenumbers"}
    return xr.Dataset(
        {"waves": (("guide", "frequency", "step"), amplitude, {"units": first.attrs["units"], **shorter})},
        coords={
            "guide": np.array(list(waves), dtype=str),
            "frequency": lines,
            "wavenumber": (("guide", "step"), wavenumber, {"units": "rad/m", **shorter}),
        },
    )


def _step(response: FrequencyResponse) -> float:
    """Distance of a point to its nearest neighbour, as most points have it, m."""
    distance, _ = scipy.spatial.cKDTree(response.points).query(response.points, k=2)
    return float(np.median(distance[:, 1]))
