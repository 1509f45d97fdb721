"""Analysis of the content of scan files, with the plate of a study or without one."""

from __future__ import annotations

import json
import re
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from haptonic.analyses.needs import need_carrier
from haptonic.analyses.options import DURATION, POSITION, option
from haptonic.analyses.plate_needs import gap_of_plate
from haptonic.analyses.runner import Runner
from haptonic.arrays import Array
from haptonic.bloch import Gap
from haptonic.bloch.settings import BandSettings
from haptonic.errors import ResponseError, ScanError
from haptonic.later import xarray as xr
from haptonic.names import counted
from haptonic.plate import Layout, Plate
from haptonic.plate.layout.sampling import driven_region, driven_regions, tile_names
from haptonic.plate.vibration.region_measures import marked_lines
from haptonic.progress import Progress, silent
from haptonic.response import FrequencyResponse, average_spectrum
from haptonic.results.scan import ScanResult
from haptonic.store import Store
from haptonic.study.schema import Description
from haptonic.units import hz_text, to_si
from haptonic.vibrometry import (
    Estimate,
    MeasuredGap,
    Registration,
    Scan,
    estimate,
    register_by_corners,
    register_by_fit,
    warn_if_aliased,
)
from haptonic.vibrometry.estimation.quality import check_flags
from haptonic.vibrometry.estimation.spectra import Estimator, WindowName
from haptonic.vibrometry.guides import Mirror, guides_of, mirror_beside, without_mode
from haptonic.vibrometry.maps.waves import grid_step
from haptonic.vibrometry.of_settings import Tiles, plan_for
from haptonic.vibrometry.on_plate import (
    contrast_range,
    decay_in,
    guide_waves,
    lattice_gap,
    reason_of,
    region_levels,
)
from haptonic.vibrometry.settings import ScanSettings
from haptonic.vibrometry.theory import computed_waves

LOUDER = 6.0  # dB, by which a region that is not driven may vibrate more than the driven one
FAR = 0.5  # registration misfit relative to the step of the grid; a larger misfit gives a remark


def flags_of(text: str) -> tuple[str, ...]:
    """Read flags of points, separated by commas.

    Raises
    ------
    ScanError : an unknown flag
    """
    names = tuple(name for part in text.split(",") if (name := part.strip()))
    check_flags(names)
    return names


@dataclass(frozen=True)
class Estimation:
    """Options for estimating responses from records; see `haptonic.vibrometry.estimate`.

    segment : length of one transform, s; None for the period of the study's drive, or a whole record
    repair : flags of points that are replaced
    """

    estimator: Estimator = option("H1", "Estimator; H1 suits noise on the response, such as a laser's.")
    window: WindowName = option(
        "none", "Window: none for periodic chirps, exponential for bursts, hann for noise."
    )
    decay: float | None = option(
        None, 'Decay time of the exponential window, such as "5 ms".', quantity=DURATION, metavar="TIME"
    )
    segment: float | None = option(
        None,
        "Length of a transform; by default the study's period, or a record.",
        quantity=DURATION,
        metavar="TIME",
    )
    overlap: float = option(0.0, "Overlap of segments, from 0 to below 1.")
    align: bool = option(False, "Align records by their reference.")
    repair: tuple[str, ...] = option(
        (),
        'Replace points with these flags, such as "dropout,saturated"; they stay marked.',
        read=flags_of,
        metavar="FLAGS",
    )


def corners_of(text: str) -> Array:
    """Read four corners, written as eight numbers and a unit.

    Raises
    ------
    ScanError : a text of another form
    """
    *numbers, unit = re.split(r"[\s,;]+", text.strip()) or [""]
    if len(numbers) != 8:
        raise ScanError.malformed(
            argument="--corners",
            given=f'"{text}"',
            allowed='eight numbers and a unit of length, such as "0 0 127 0 127 140 0 140 mm"',
            cause="a number or the unit is missing",
            next_step="give x and y of the four corners, from the lower left one anticlockwise",
        )
    return np.array([to_si(f"{number} {unit}", "m", "--corners") for number in numbers]).reshape(4, 2)


@dataclass(frozen=True, kw_only=True)
class PlateInScan:
    """Options for the position of the plate in the scan.

    corners : (4, 2) of the plate, m; by default the points are fitted to the planned ones
    """

    corners: Any = option(
        None, "The plate's corners in the coordinates of the scan, from the lower left anticlockwise: "
        '"0 0 127 0 127 140 0 140 mm".', read=corners_of, metavar="PLACES", topic=POSITION,
    )  # fmt: skip
    mirrored: bool = option(False, "The scan shows the plate's map from behind.", topic=POSITION)


@dataclass(frozen=True)
class OnPlate:
    """Facts of a study about a scanned plate.

    carrier : Hz; gap : of its lattice; bands : settings of its bands; seen : its position in the scan
    """

    plate: Plate
    scan: ScanSettings
    carrier: float
    gap: Gap | None
    bands: BandSettings
    seen: PlateInScan = PlateInScan()


def on_plate(study: Description, seen: PlateInScan = PlateInScan(), *, store: Store | None = None) -> OnPlate:
    """Facts of a study that the analysis of a scan needs; see `compute_scan`.

    Parameters
    ----------
    seen : position of the plate in the scan

    Raises
    ------
    StudyError : no [plate], or no carrier
    """
    plate, carrier = study.mounted_plate(), need_carrier(study)
    gap = gap_of_plate(study, plate, carrier, Runner(store or Store.default()))
    return OnPlate(
        plate=plate,
        scan=study.scan_settings,
        carrier=carrier,
        gap=gap,
        bands=study.bands_settings,
        seen=seen,
    )


def compute_scan(
    scan: Scan,
    how: Estimation,
    on: OnPlate | None,
    *,
    at: float | None = None,
    state: Path | None = None,
    store: Store,
    progress: Progress = silent,
) -> ScanResult:
    """Analyse a scan.

    Parameters
    ----------
    at : frequency of the operating shape and its animation, Hz; by default the loudest one
    state : folder from which an interrupted estimation continues
    progress : called with the points done and their number

    Raises
    ------
    ScanError : settings that do not fit the scan, or no points left
    ResponseError : ``at`` is outside the measured range
    """
    estimated = _estimated(scan, how, on, state, progress)
    if how.repair:
        estimated = estimated.repaired(*how.repair)
    response = estimated.response
    if at is not None:
        at = float(response.at(at).frequency[0])
    report = scan.report.followed_by(estimated.report)
    data = xr.Dataset({"average": average_spectrum(response)})
    axes = [str(name) for name in response.dataset["direction"].values]
    unseen = [] if "z" in axes else [f"no maps: motion only along {', '.join(axes)}, not normal to the plate"]
    plain = ScanResult(
        response=response,
        quality=estimated.quality,
        report=report,
        averages=estimated.averages,
        data=data,
        shapes=(),
        undetermined=tuple(unseen),
    )
    if on is None:
        loudest = float(response.frequency[int(data["average"].values.argmax())])
        return replace(plain, shapes=(loudest if at is None else at,))
    registration = registration_of(response.points, on.plate, on.scan, on.seen)
    layout = on.plate.layout
    response = on.scan.instrument.taken_out(
        registration.registered(response, {n: Tiles(layout, n) for n in layout.regions})
    )
    driven = driven_region(on.plate)
    mirror = mirror_beside(layout, driven) if driven else None
    remarks = []
    for part, reasons in (region_levels(response, driven), guide_waves(response, layout)):
        data.update(part)
        remarks += reasons
    stands_out, reasons = _beside_lattice(response, on.plate, mirror, data)
    remarks += [*reasons, *unseen]
    lattice = lattice_gap(response, on.plate, data)
    edges = on.gap.edges if on.gap else None
    names = [str(name) for name in response.dataset["region"].values]
    marked = marked_lines(on.plate, response.frequency, response.values[..., 0].T, names, on.carrier, edges)
    shapes = tuple(response.frequency[marked].tolist()) if at is None else (at,)
    waves = _waves(response, on, mirror, store)
    remarks += [] if waves is None else without_mode(layout)
    remarks += _doubts_of_places(response, registration, layout)
    if driven and len(driven_regions(on.plate)) == 1:
        remarks += _doubts_of_orientation(data, driven)
    return replace(
        plain, response=response, shapes=shapes, plate=on.plate, carrier=on.carrier, gap=on.gap,
        measured=stands_out, lattice=lattice, registration=registration, waves=waves, mirror=mirror,
        undetermined=tuple(remarks),
    )  # fmt: skip


def _estimated(
    scan: Scan, how: Estimation, on: OnPlate | None, state: Path | None, progress: Progress
) -> Estimate:
    """Response of a scan and quality of its points, estimated if the scan contains time records."""
    if isinstance(scan.content, FrequencyResponse):
        return Estimate.by_instrument(scan.content, scan.report)
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
        segment=None if segment is None else round(segment * records.sample_rate), band=band, state=state,
        progress=progress, workers=2,
    )  # fmt: skip


def registration_of(points: Array, plate: Plate, settings: ScanSettings, seen: PlateInScan) -> Registration:
    """Transformation of the points of a scan to the plate, by the corners or else by a fit to the plan.

    Raises
    ------
    ScanError : points that cannot be those of the plate
    """
    if seen.corners is not None:
        right, top = plate.layout.x[-1], plate.layout.y[-1]
        corners = np.array([[0.0, 0.0], [right, 0.0], [right, top], [0.0, top]])
        return register_by_corners(seen.corners, corners, mirrored=seen.mirrored)
    return register_by_fit(points, plan_for(settings, plate).points, mirrored=seen.mirrored)


def _waves(
    response: FrequencyResponse, on: OnPlate, mirror: Mirror | None, store: Store
) -> xr.Dataset | None:
    """Computed waves of the plate in the band of a scan; None for a plate without a lattice.

    It warns if the points are too far apart for the shortest of these waves.
    """
    layout = on.plate.layout
    if not layout.cells:
        return None
    span = float(response.frequency[0]), float(response.frequency[-1])
    parts = layout, on.bands, span, on.gap, guides_of(layout), mirror
    waves = store.kept({"kind": "waves beside a scan", "of": parts}, lambda: computed_waves(*parts))
    shortest = 2 * np.pi / float(waves["wavenumber"].max())
    warn_if_aliased(grid_step(response), shortest, f"the flexural wave at {hz_text(span[1], form='.4g')}")
    return waves


def _doubts_of_places(response: FrequencyResponse, registration: Registration, layout: Layout) -> list[str]:
    """Remarks on points that do not fit the plate of the study."""
    remarks = []
    if registration.misfit > FAR * grid_step(response):
        remarks.append(
            f"the points lie {registration.misfit * 1e3:.2g} mm from the planned ones: check the registration"
        )
    remarks += registration.doubts
    outside = sum(name is None for name in tile_names(layout, response.points))
    if outside:
        lie = "lies" if outside == 1 else "lie"
        remarks.append(f"{counted(outside, 'point')} {lie} outside the plate of the study")
    return remarks


def _doubts_of_orientation(data: xr.Dataset, driven: str) -> list[str]:
    """Remark on a region that vibrates more than the only driven one, as in a scan that is turned around.

    The outline of most plates is the same after half a turn, so that the places cannot show it.
    """
    if "rms" not in data or driven not in data["region"].values:
        return []
    levels = data["rms"].where(data["rms"] > 0)
    # of all frequencies, because in the gap the difference is largest and the sum is that of the resonances
    excess = 20 * xr.apply_ufunc(np.log10, levels / levels.sel(region=driven))
    means = excess.mean("frequency").fillna(-np.inf)
    most, loudest = max(zip(means.values.tolist(), means["region"].values.tolist(), strict=True))
    if most < LOUDER:
        return []
    return [
        f"{loudest} vibrates {most:.0f} dB more on average than {driven}, the driven region; if the scan is "
        "turned around or mirrored, give the corners of the plate in it (--corners, --mirrored)"
    ]


def _beside_lattice(
    response: FrequencyResponse, plate: Plate, mirror: Mirror | None, data: xr.Dataset
) -> tuple[MeasuredGap | None, list[str]]:
    """Frequency range with high contrast of the driven region; also adds the decay to the dataset.

    Returns
    -------
    the range, None without one, and the reasons for missing results
    """
    if driven_region(plate) is None:
        return None, ["no contrast: the study does not name the driven region"]
    contrast, reasons = None, []
    try:
        contrast = contrast_range(response, plate)
    except (ScanError, ResponseError) as error:
        reasons.append(f"no range of high contrast: {reason_of(error)}")
    if mirror is not None:
        try:
            decay = decay_in(response, mirror)
        except (ScanError, ResponseError) as error:
            reasons.append(f"no decay: {reason_of(error)}")
        else:
            data.update(decay.rename(error="error_of_decay"))
            data.attrs["decay"] = json.dumps(decay.attrs)
    return contrast, reasons
