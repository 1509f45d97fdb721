"""What a laser vibrometer would record of the study's plate: a simulation, whose truth is known."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Literal

from haptonic.analyses import plate
from haptonic.analyses.analysis import Analysis, option
from haptonic.analyses.costs import gaps, response
from haptonic.analyses.needs import response_settings
from haptonic.analyses.runner import Runner
from haptonic.analyses.scanning import on_plate
from haptonic.analyses.verdict import response_in
from haptonic.plate.settings import ResponseSettings
from haptonic.results.cost import Cost
from haptonic.results.scan.simulated import Kind, SimulatedScan, kind_of
from haptonic.study.schema import Description
from haptonic.vibrometry.of_settings import drive_for, plan_for, response_for

RECORDED = 0.008  # s, of a point that is made up and written


@dataclass(frozen=True)
class SimulateScanOptions:
    """What may be chosen."""

    form: Literal["h5", "nc", "uff", "mat", "csv", "tdms"] = option(
        "h5", "Of the scan's file.", flag="--format"
    )
    time: bool | None = option(None, "Records, or responses; else what the format has.", flag="--time/--frf")
    seed: int = option(0, "Of noise and dropouts.", least=0)
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
    made = SimulatedScan.of(body, settings, signal, response, gap=gap, seed=options.seed)
    return replace(made, form=options.form, kind=options.kind)


def cost(study: Description, options: SimulateScanOptions) -> Cost:
    """Of the plate's response in the band of the drive, if it is not given, and of every point."""
    mounted, asked = study.mounted_plate(), study.scan_settings
    made = Cost(RECORDED * len(plan_for(asked, mounted).points))
    if options.response is not None:
        return made
    lines = ResponseSettings(
        lowest=asked.lowest, highest=asked.highest, points=round(asked.lines), grid=asked.grid
    )
    return response(mounted, lines) + gaps(study) + made


ANALYSIS = Analysis(
    name="simulate scan",
    result=SimulatedScan,
    compute=compute,
    cost=cost,
    options=SimulateScanOptions,
    check=check,
    doing="shifts",
    writes=True,
)
