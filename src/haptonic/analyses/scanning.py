"""From a study to the scan of its plate: what an analysis has to know, and a simulated scan as a test."""

from __future__ import annotations

import warnings

import numpy as np

from haptonic.analyses.needs import gap_of_plate, need_carrier, response_settings
from haptonic.arrays import Array
from haptonic.errors import HaptonicWarning, ScanError
from haptonic.fields import unchecked
from haptonic.progress import Progress, silent
from haptonic.response import FrequencyResponse
from haptonic.results.plate.value import PlateResult
from haptonic.results.runner import Runner
from haptonic.results.scan import Estimation, OnPlate, ScanResult, SimulatedScan, compute_scan
from haptonic.store import Store
from haptonic.study.schema import Description
from haptonic.vibrometry import ReadReport, Scan
from haptonic.vibrometry.of_settings import drive_for
from haptonic.vibrometry.settings import ScanSettings

SHIFTED = 0.01  # of the distance of lines, by which a computed line may be off one of a periodic drive


def on_plate(
    study: Description, corners: Array | None = None, *, mirrored: bool = False, store: Store | None = None
) -> OnPlate:
    """What an analysis of a scan has to know of the plate; see `haptonic.results.scan.compute_scan`.

    Parameters
    ----------
    corners, mirrored : see `OnPlate`

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
        corners=corners,
        mirrored=mirrored,
    )


def rescanned(
    study: Description,
    computed: PlateResult,
    *,
    seed: int = 0,
    store: Store | None = None,
    progress: Progress = silent,
) -> ScanResult:
    """What a scan of a plate that was computed would tell: simulated records, analysed like measured ones.

    The drive's period is that whose lines are the computed ones, so nothing of the plate is computed again; a
    line that is off by a hundredth of the lines' distance or less counts as the drive's.

    Parameters
    ----------
    computed : of the same study
    progress : called with the points analysed and their number

    Raises
    ------
    ScanError : lines that no periodic drive has, or a scan of other points than the plate was computed at
    """
    lines = computed.response.frequency
    settings = _periodic(lines, study)
    driven = (round(settings.lowest * settings.record) + np.arange(len(lines))) / settings.record
    response = FrequencyResponse(computed.response.dataset.assign_coords(frequency=driven))
    with warnings.catch_warnings():  # a simulated plate is in its steady state, however short the period
        warnings.filterwarnings("ignore", "the period of", HaptonicWarning)
        signal = drive_for(settings, computed.plate)
    made = SimulatedScan.of(computed.plate, settings, signal, response, gap=computed.gap, seed=seed)
    scan = Scan(made.records, ReadReport("simulated records", "memory", len(made.records.names)))
    on = OnPlate(
        plate=computed.plate,
        scan=settings,
        carrier=computed.carrier,
        gap=computed.gap,
        bands=study.bands_settings,
    )
    return compute_scan(scan, Estimation(), on, store=store or Store.default(), progress=progress)


def _periodic(lines: Array, study: Description) -> ScanSettings:
    """The study's scan with a drive that has these lines, evenly spaced, Hz, at the points of the plate."""
    spacing = float(lines[-1] - lines[0]) / max(len(lines) - 1, 1)
    first = round(lines[0] / spacing) if spacing else 0
    if first < 1 or abs(lines[0] - first * spacing) > SHIFTED * spacing:
        raise ScanError.out_of_range(
            argument="plate.response",
            given=f"{len(lines)} lines from {lines[0]:g} to {lines[-1]:g} Hz",
            allowed="evenly spaced lines at multiples of their distance, as a periodic drive has them",
            cause="the lowest frequency is no multiple of the distance of the lines",
            next_step="choose lowest, highest and points of [plate.response] so that it is",
        )
    rate = np.ceil(max(study.scan_settings.rate, 2 * lines[-1]) / spacing) * spacing
    return unchecked(  # `drive` refuses what no drive has; a scan in earnest has more lines
        study.scan_settings,
        lowest=first * spacing,
        highest=(first + len(lines) - 1) * spacing,
        rate=float(rate),
        record=1 / spacing,
        grid=response_settings(study).grid,
    )
