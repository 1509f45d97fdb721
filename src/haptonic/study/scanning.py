"""From a study to the scan of its plate: what an analysis has to know, and a twin to test it with."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from haptonic.response import FrequencyResponse
from haptonic.results import Runner
from haptonic.results.carrier import gap_around
from haptonic.results.scan import OnPlate, Twin
from haptonic.store import Store
from haptonic.study.runs import Study

Array = NDArray[np.float64]


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
    plate, carrier = study.plate(), study.need_carrier()
    cells = list(plate.layout.cells.values())
    runner = Runner(store or Store.default())
    gap = gap_around(cells[0], study.asked(), carrier, runner) if cells else None
    if gap is not None and not gap.lower < carrier < gap.upper:
        gap = None
    return OnPlate(plate, study.scan.frozen(), carrier, gap, study.asked(), corners, mirrored)


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
    plate, question = study.plate(), study.scan.frozen()
    signal = question.drive(plate)
    if response is not None:
        gap = scanned(study, store=store).gap
        return Twin.of(plate, question, signal, response, gap=gap, seed=seed)
    section = study.plate_section
    assert section is not None
    asked = question.of_plate(section.response.tolerance, signal)
    result = study.vibrating(asked=asked, store=store, on_progress=on_progress)
    return Twin.of(plate, question, signal, result.response, gap=result.gap, seed=seed)
