"""From a study to the scan of its plate: what an analysis has to know, and a twin to test it with."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from haptonic.errors import HaptonicWarning, ScanError
from haptonic.response import FrequencyResponse
from haptonic.results import PlateResult, Runner
from haptonic.results.carrier import gap_around
from haptonic.results.scan import Estimation, OnPlate, ScanQuestion, ScanResult, Twin, compute_scan
from haptonic.store import Store
from haptonic.study.runs import Study
from haptonic.vibrometry import ReadReport, Scan

Array = NDArray[np.float64]

SHIFTED = 0.01  # of the distance of lines, by which a computed line may be off one of a periodic drive


def scanned(
    study: Study, corners: Array | None = None, *, mirrored: bool = False, store: Store | None = None
) -> OnPlate:
    """What an analysis of a scan has to know of the plate; see `haptonic.results.scan.compute_scan`.

    Parameters
    ----------
    corners, mirrored : see `OnPlate`

    Raises
    ------
    StudyError : no [plate], or no carrier
    """
    plate, carrier = study.mounted_plate(), study.need_carrier()
    cells = list(plate.layout.cells.values())
    runner = Runner(store or Store.default())
    gap = gap_around(cells[0], study.asked(), carrier, runner) if cells else None
    if gap is not None and not gap.lower < carrier < gap.upper:
        gap = None
    return OnPlate(plate, study.scan_settings.frozen(), carrier, gap, study.asked(), corners, mirrored)


def twin_scan(
    study: Study,
    *,
    seed: int = 0,
    response: FrequencyResponse | None = None,
    store: Store | None = None,
    on_progress: Callable[[int, int, bool], None] = lambda done, planned, stored: None,
) -> Twin:
    """A scan of the plate in software: a simulation of instrument and plate, whose truth is known.

    Parameters
    ----------
    response : of the plate at the lines of the drive and the points of the plan; else it is computed

    Raises
    ------
    StudyError : no [plate], no carrier, or nothing that drives the plate
    ScanError : settings of [scan] that do not fit together, or a response at other lines or points
    """
    plate, question = study.mounted_plate(), study.scan_settings.frozen()
    signal = question.drive(plate)
    if response is not None:
        gap = scanned(study, store=store).gap
        return Twin.of(plate, question, signal, response, gap=gap, seed=seed)
    section = study.finite_plate
    assert section is not None
    asked = question.of_plate(section.response.tolerance, signal)
    result = study.vibrating(asked=asked, store=store, on_progress=on_progress)
    return Twin.of(plate, question, signal, result.response, gap=result.gap, seed=seed)


def rescanned(
    study: Study,
    computed: PlateResult,
    *,
    seed: int = 0,
    store: Store | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> ScanResult:
    """What a scan of a plate that was computed would tell: a twin's records, analysed like measured ones.

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
    question = _periodic(lines, study)
    driven = (round(question.lowest * question.record) + np.arange(len(lines))) / question.record
    response = FrequencyResponse(computed.response.dataset.assign_coords(frequency=driven))
    with warnings.catch_warnings():  # a twin is in its steady state, however short the period
        warnings.filterwarnings("ignore", "the period of", HaptonicWarning)
        signal = question.drive(computed.plate)
    made = Twin.of(computed.plate, question, signal, response, gap=computed.gap, seed=seed)
    scan = Scan(made.records, ReadReport("simulated records", "memory", len(made.records.names)))
    on = OnPlate(computed.plate, question, computed.carrier, computed.gap, study.asked())
    return compute_scan(scan, Estimation(), on, store=store or Store.default(), progress=progress)


def _periodic(lines: Array, study: Study) -> ScanQuestion:
    """The study's scan with a drive that has these lines, evenly spaced, Hz, at the points of the plate."""
    section = study.finite_plate
    assert section is not None
    spacing = float(lines[-1] - lines[0]) / max(len(lines) - 1, 1)
    first = round(lines[0] / spacing) if spacing else 0
    if first < 1 or abs(lines[0] - first * spacing) > SHIFTED * spacing:
        raise ScanError(
            argument="plate.response",
            given=f"{len(lines)} lines from {lines[0]:g} to {lines[-1]:g} Hz",
            allowed="evenly spaced lines at multiples of their distance, as a periodic drive has them",
            cause="the lowest frequency is no multiple of the distance of the lines",
            next_step="choose lowest, highest and points of [plate.response] so that it is",
        )
    rate = np.ceil(max(study.scan_settings.rate, 2 * lines[-1]) / spacing) * spacing
    return replace(
        study.scan_settings.frozen(), lowest=first * spacing, highest=(first + len(lines) - 1) * spacing,
        rate=float(rate), record=1 / spacing, grid=section.response.grid,
    )  # fmt: skip
