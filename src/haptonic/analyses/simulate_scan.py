"""What a laser vibrometer would record of the study's plate: a simulation, whose truth is known."""

from __future__ import annotations

import warnings
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np
import scipy

from haptonic.analyses import plate
from haptonic.analyses.analysis import Analysis
from haptonic.analyses.costs import gaps, response
from haptonic.analyses.needs import response_settings
from haptonic.analyses.options import Seeded, option
from haptonic.analyses.runner import Runner
from haptonic.analyses.scanning import Estimation, OnPlate, compute_scan, on_plate
from haptonic.analyses.support import whole_lower_face
from haptonic.analyses.verdict import response_in
from haptonic.arrays import Array
from haptonic.bloch import Gap
from haptonic.errors import HaptonicWarning, ScanError
from haptonic.fields import unchecked
from haptonic.plate import Plate
from haptonic.plate.settings import ResponseSettings
from haptonic.progress import Progress, silent
from haptonic.response import FrequencyResponse
from haptonic.results.cost import Cost
from haptonic.results.plate.value import PlateResult
from haptonic.results.scan import ScanResult
from haptonic.results.scan.simulated import STAGE, Kind, SimulatedScan, kind_of
from haptonic.store import Store
from haptonic.study.schema import Description
from haptonic.vibrometry import ReadReport, Scan, estimate
from haptonic.vibrometry.chirp import Drive
from haptonic.vibrometry.instrument import recorded
from haptonic.vibrometry.of_settings import drive_for, plan_for, response_for
from haptonic.vibrometry.settings import ScanSettings

NEAR = 0.01  # of the grid, within which a point of the plan is one of the response
SHIFTED = 0.01  # of the distance of lines, by which a computed line may be off one of a periodic drive
RECORDED = 0.008  # s, of a point that is made up and written


@dataclass(frozen=True, kw_only=True)
class SimulateScanOptions(Seeded):
    """What may be chosen."""

    form: Literal["h5", "nc", "uff", "mat", "csv", "tdms"] = option(
        "h5", "Format of the scan's file.", flag="--format"
    )
    time: bool | None = option(None, "Records, or responses; else what the format has.", flag="--time/--frf")
    response: Any = option(
        None, "The plate's response, instead of computing it.", read=response_in, flag="--from",
        metavar="FILE",
    )  # fmt: skip

    @property
    def kind(self) -> Kind:
        """Time records or responses."""
        return kind_of(self.form, None if self.time is None else "time" if self.time else "frf")


def check(study: Description, options: SimulateScanOptions) -> None:
    """Refuse a form of file that does not hold what is asked for."""
    _ = options.kind


def compute(study: Description, options: SimulateScanOptions, runner: Runner) -> SimulatedScan:
    """The scan; the plate's response is computed at the lines of the drive, or given at them.

    Raises
    ------
    StudyError : no [plate], no carrier, or nothing that drives the plate
    ScanError : settings of [scan] that do not fit together, or a response at other lines or points
    """
    body, settings = study.mounted_plate(), study.scan_settings
    signal = drive_for(settings, body)
    if options.response is not None:
        gap, response = on_plate(study, store=runner.store).gap, options.response
    else:
        asked = response_for(settings, response_settings(study).tolerance, signal)
        result = plate.compute(study, plate.PlateOptions(settings=asked), runner)
        gap, response = result.gap, result.response
    made = simulated_scan(body, settings, signal, response, gap=gap, seed=options.seed)
    estimated = (
        estimate(made.records, band=signal.band, workers=2).response if options.kind == "frf" else None
    )
    return replace(made, form=options.form, kind=options.kind, estimated=estimated)


def simulated_scan(
    plate: Plate,
    settings: ScanSettings,
    signal: Drive,
    response: FrequencyResponse,
    *,
    gap: Gap | None = None,
    seed: int,
) -> SimulatedScan:
    """The scan of a plate whose response is known at the points of the plan and the lines of the drive.

    Raises
    ------
    ScanError : a response at other points or lines
    """
    plan = plan_for(settings, plate).points
    distance, order = scipy.spatial.cKDTree(response.points).query(plan)
    if distance.max() > NEAR * settings.grid:
        raise ScanError.mismatch(
            argument="response",
            given=f"no point within {distance.max() * 1e3:.3g} mm of a planned one",
            allowed="a response at the points of the scan plan",
            cause="it was computed on another grid, or for another plate",
            next_step="compute it with the grid of [scan], or leave --from out",
        )
    true = FrequencyResponse(response.dataset.isel(point=order))
    if true.dataset.attrs["quantity"] != "velocity":
        true = true.velocity()
    points = true.points + np.array(STAGE)
    moved = FrequencyResponse(
        true.dataset.assign_coords(x=("point", points[:, 0]), y=("point", points[:, 1]))
    )
    records = recorded(moved, signal, settings.instrument, averages=settings.averages, seed=seed)
    return SimulatedScan(
        plate=plate, settings=settings, signal=signal, gap=gap, true=true, records=records, seed=seed
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
    made = simulated_scan(computed.plate, settings, signal, response, gap=computed.gap, seed=seed)
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


def cost(study: Description, options: SimulateScanOptions) -> Cost:
    """Of the plate's response in the band of the drive, if it is not given, and of every point."""
    mounted, asked = study.mounted_plate(), study.scan_settings
    made = Cost(RECORDED * len(plan_for(asked, mounted).points))
    if options.response is not None:
        return made
    lines = ResponseSettings(
        lowest=asked.lowest, highest=asked.highest, points=round(asked.lines), grid=asked.grid
    )
    return response(study, mounted, lines) + gaps(study) + made


ANALYSIS = Analysis(
    name="simulate scan",
    result=SimulatedScan,
    compute=compute,
    supports=whole_lower_face,
    cost=cost,
    options=SimulateScanOptions,
    check=check,
    doing="shifts",
    writes=True,
)
