"""Simulated records of a laser vibrometer on the study's plate, with known truth."""

from __future__ import annotations

import warnings
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np
import scipy

from haptonic.analyses import plate
from haptonic.analyses.analysis import Analysis
from haptonic.analyses.costs import gaps
from haptonic.analyses.options import Seeded, option
from haptonic.analyses.plate_needs import response, response_settings
from haptonic.analyses.runner import Runner
from haptonic.analyses.scanning import Estimation, OnPlate, compute_scan, on_plate
from haptonic.analyses.support import whole_lower_face
from haptonic.analyses.verdict import response_in
from haptonic.arrays import Array
from haptonic.bloch import Gap
from haptonic.errors import HaptonicWarning, ScanError
from haptonic.fields import unchecked
from haptonic.plate import Plate
from haptonic.plate.vibration.settings import ResponseSettings
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

NEAR = 0.01  # of the grid; a planned point has a point of the response within this distance
SHIFTED = 0.01  # of the line spacing; a computed frequency may differ from a drive's by this much
RECORDED = 0.008  # s per point that is simulated and written


@dataclass(frozen=True, kw_only=True)
class SimulateScanOptions(Seeded):
    """Options of the simulation."""

    form: Literal["h5", "nc", "uff", "mat", "csv", "tdms"] = option(
        "h5", "Format of the scan's file.", flag="--format"
    )
    time: bool | None = option(
        None, "Records or responses; by default those usual for the format.", flag="--time/--frf"
    )
    response: Any = option(
        None, "The plate's response, instead of computing it.", read=response_in, is_path=True, flag="--from",
        metavar="FILE",
    )  # fmt: skip

    @property
    def kind(self) -> Kind:
        """Content of the file: time records or responses."""
        return kind_of(self.form, None if self.time is None else "time" if self.time else "frf")


def check(study: Description, options: SimulateScanOptions) -> None:
    """Refuse a format that cannot contain records, or responses, as chosen."""
    _ = options.kind


def compute(study: Description, options: SimulateScanOptions, runner: Runner) -> SimulatedScan:
    """Simulate a scan; the response of the plate is computed at the frequencies of the drive, or given.

    Raises
    ------
    StudyError : no [plate], no carrier, or no drive
    ScanError : settings of [scan] that contradict each other, or a response at other frequencies or points
    """
    body, settings = study.mounted_plate(), study.scan_settings
    signal = drive_for(settings, body)
    if options.response is not None:
        gap, response = on_plate(study, store=runner.store).gap, options.response
    else:
        asked = response_for(settings, response_settings(study).tolerance, signal)
        result = plate.compute(study, plate.PlateOptions(settings=asked), runner)
        gap, response = result.gap, result.response
    simulated = simulated_scan(body, settings, signal, response, gap=gap, seed=options.seed)
    estimated = (
        estimate(simulated.records, band=signal.band, workers=2).response if options.kind == "frf" else None
    )
    return replace(simulated, form=options.form, kind=options.kind, estimated=estimated)


def simulated_scan(
    plate: Plate,
    settings: ScanSettings,
    signal: Drive,
    response: FrequencyResponse,
    *,
    gap: Gap | None = None,
    seed: int,
) -> SimulatedScan:
    """Scan of a plate whose response is known at the points of the plan and the frequencies of the drive.

    Raises
    ------
    ScanError : a response at other points or frequencies
    """
    plan = plan_for(settings, plate).points
    distance, order = scipy.spatial.cKDTree(response.points).query(plan)
    if distance.max() > NEAR * settings.grid:
        raise ScanError.mismatch(
            argument="response",
            given=f"no point within {distance.max() * 1e3:.3g} mm of a planned point",
            allowed="a response at the points of the scan plan",
            cause="the response was computed on another grid, or for another plate",
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
    """Simulate a scan of a computed plate and analyse it like a measured one.

    The period of the drive is chosen so that its frequencies are the computed ones; the plate is not computed
    again. A computed frequency may differ from that of the drive by 1 % of the line spacing.

    Parameters
    ----------
    computed : plate of the same study
    progress : called with the points analysed and their number

    Raises
    ------
    ScanError : frequencies that no periodic drive has, or a scan at other points than the computed ones
    """
    lines = computed.response.frequency
    settings = _periodic(lines, study)
    driven = (round(settings.lowest * settings.record) + np.arange(len(lines))) / settings.record
    response = FrequencyResponse(computed.response.dataset.assign_coords(frequency=driven))
    # the drive follows from the computed frequencies, and a simulated plate is in its steady state
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", HaptonicWarning)
        signal = drive_for(settings, computed.plate)
    simulated = simulated_scan(computed.plate, settings, signal, response, gap=computed.gap, seed=seed)
    scan = Scan(simulated.records, ReadReport("simulated records", "memory", len(simulated.records.names)))
    on = OnPlate(
        plate=computed.plate,
        scan=settings,
        carrier=computed.carrier,
        gap=computed.gap,
        bands=study.bands_settings,
    )
    return compute_scan(scan, Estimation(), on, store=store or Store.default(), progress=progress)


def _periodic(lines: Array, study: Description) -> ScanSettings:
    """The study's [scan] with a drive at these evenly spaced frequencies (Hz) and the points of the plate."""
    spacing = float(lines[-1] - lines[0]) / max(len(lines) - 1, 1)
    first = round(lines[0] / spacing) if spacing else 0
    if first < 1 or abs(lines[0] - first * spacing) > SHIFTED * spacing:
        raise ScanError.out_of_range(
            argument="plate.response",
            given=f"{len(lines)} frequencies from {lines[0]:g} to {lines[-1]:g} Hz",
            allowed="evenly spaced frequencies at multiples of their spacing, as in a periodic drive",
            cause="the lowest frequency is not a multiple of the spacing",
            next_step="choose lowest, highest and points of [plate.response] accordingly",
        )
    rate = np.ceil(max(study.scan_settings.rate, 2 * lines[-1]) / spacing) * spacing
    return unchecked(  # `drive` checks the frequencies; their number may be below that of a real scan
        study.scan_settings,
        lowest=first * spacing,
        highest=(first + len(lines) - 1) * spacing,
        rate=float(rate),
        record=1 / spacing,
        grid=response_settings(study).grid,
    )


def cost(study: Description, options: SimulateScanOptions) -> Cost:
    """Estimated cost of the plate's response in the band of the drive, if not given, and of every point."""
    mounted, asked = study.mounted_plate(), study.scan_settings
    points = Cost(RECORDED * len(plan_for(asked, mounted).points))
    if options.response is not None:
        return points
    lines = ResponseSettings(
        lowest=asked.lowest, highest=asked.highest, points=round(asked.lines), grid=asked.grid
    )
    return response(study, mounted, lines) + gaps(study) + points


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
