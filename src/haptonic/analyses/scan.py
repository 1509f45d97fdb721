"""Analysis of a laser vibrometer scan: responses, maps, contrast, gap, waves and agreement with a model."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields, replace
from pathlib import Path
from typing import Any, Literal

from haptonic.analyses.analysis import Analysis
from haptonic.analyses.costs import size_of
from haptonic.analyses.options import CONTENT, MODEL, POSITION, UnitsOfFile, option, option_of
from haptonic.analyses.runner import Runner
from haptonic.analyses.scanning import (
    Estimation,
    OnPlate,
    PlateInScan,
    compute_scan,
    on_plate,
    registration_of,
)
from haptonic.analyses.support import every_cell
from haptonic.analyses.verdict import compared, cost_of
from haptonic.errors import ScanError, StudyError, shown
from haptonic.paths import source
from haptonic.response import FrequencyResponse, read
from haptonic.results.cost import BASE, Cost
from haptonic.results.scan.reading import ScanReading
from haptonic.results.scan.value import ScanResult
from haptonic.study.loading import load_as
from haptonic.study.schema import Description
from haptonic.units import to_si
from haptonic.vibrometry.readers import Scan, read_scan

PROGRESS = "estimating"  # folder for the state of an estimation, from which it can continue
ANALYSED, BYTE_OF_SCAN = 4.0, 5e-8  # s for maps and pictures; s per byte that is read and estimated
HELD = 4.0  # memory for a file, relative to its size


def names_of(variables: str) -> Mapping[str, str]:
    """Names of arrays by meaning, from a text such as ``response=FRF,x=Xmm``.

    Raises
    ------
    ScanError : a text of another form
    """
    pairs = [item.split("=", 1) for item in variables.split(",")] if variables else []
    if any(len(pair) != 2 or not all(part.strip() for part in pair) for pair in pairs):
        raise ScanError.malformed(
            argument="--variables",
            given=shown(variables),
            allowed="MEANING=NAME, several of them separated by commas",
            cause="an equals sign or a name is missing",
            next_step="write --variables=response=FRF,frequency=f,x=X,y=Y",
        )
    return {meaning.strip(): name.strip() for meaning, name in pairs}


def frequency_or_points(text: str) -> float | str:
    """Read a frequency (Hz), or coordinates of points: lengths with commas between them."""
    return text if "," in text else to_si(text, "Hz", "--at")


@dataclass(frozen=True, kw_only=True)
class ScanOptions(PlateInScan, UnitsOfFile, Estimation):
    """Options: the file and its analysis.

    response : a response in place of a file, in Python only
    """

    path: Path | None = option(
        None, "Scan file, or a folder with one CSV a point.", metavar="PATH", place="before"
    )
    response: FrequencyResponse | None = field(default=None)
    against: Path | None = option(
        None, "Compare with a model: a study; or, after STUDY, its computed response (.nc).",
        metavar="MODEL", topic=MODEL,
    )  # fmt: skip
    at: Any = option(
        None, "Frequency of the operating shape, by default the loudest; or the points of a file without "
        'coordinates, "10 mm, 5 mm; 15 mm, 5 mm".', read=frequency_or_points, metavar="FREQUENCY|X,Y;...",
        topic=POSITION,
    )  # fmt: skip
    model: bool = option(
        False, "Compare with the model of STUDY, computed at the points of the scan.", topic=MODEL
    )
    html: bool = option(False, "Also one interactive HTML page, with the map beside that of the model.")
    unit: str | None = option(
        None, "Unit of responses or records in files that give none; by default m/s/V.", topic=CONTENT
    )
    length_unit: str | None = option(
        None, 'Unit of coordinates in files that give none, such as "mm".', topic=CONTENT
    )
    variables: Any = option(
        None, "Names of arrays, columns or channels by meaning, such as response=FRF,x=X.", read=names_of,
        metavar="MEANING=NAME,...", topic=CONTENT,
    )  # fmt: skip
    reference: str | None = option(None, 'Name and unit of the reference, such as "A1, V".', topic=CONTENT)
    phase_unit: str | None = option(
        None, "Unit of phases in files that give none: rad or deg.", metavar="UNIT", topic=CONTENT
    )
    points_in: Literal["rows", "columns"] | None = option(
        None, "Order of arrays with as many points as frequencies: rows or columns.", metavar="SIDE",
        topic=CONTENT,
    )  # fmt: skip
    simulated: bool = option(False, "The file is of a simulation.", topic=CONTENT)

    @property
    def model_is_a_study(self) -> bool:
        """True if the model is a study, False if it is the response of a study."""
        return self.against is not None and self.against.suffix != ".nc"


def check(study: Description | None, options: ScanOptions) -> None:
    """Refuse a scan without a file, and options that need a study or a plate."""
    if (options.path is None) == (options.response is None):
        raise ScanError.missing(
            argument="path", given="nothing" if options.path is None else "a file and a response",
            allowed="the path of a scan file, or response = a FrequencyResponse",
            cause="both or neither of the two were given",
            next_step='write study.scan(path="measured.uff"), or study.scan(response=response)',
        )  # fmt: skip
    if options.path is not None:
        source(options.path, "scan")
    elif given := [name for name in _about_content() if getattr(options, name)]:
        raise ScanError.conflict(
            argument=given[0], given=f"{shown(str(getattr(options, given[0])))}, together with a response",
            allowed="it with the path of a file",
            cause="a response has its units, points and origin already",
            next_step="leave it out",
        )  # fmt: skip
    against = options.against
    if against and study is None and not options.model_is_a_study:
        raise ScanError.missing(
            argument="--against", given=f"{against}, a response without its study",
            allowed="a study; or the study behind the scan, and here its computed response",
            cause="a response contains neither the regions of the plate nor the parameters to fit",
            next_step=f"haptonic scan PATH STUDY --against {against}",
        )  # fmt: skip
    if options.model_is_a_study and study is not None:
        raise ScanError.conflict(
            argument="--against", given=f"{against}, together with a study",
            allowed="one study, or after a study its computed response (.nc)",
            cause="the study of --against also registers the points to the plate",
            next_step="leave the study behind the scan out",
        )  # fmt: skip
    if options.model and (study is None or against is not None):
        raise ScanError.conflict(
            argument="--model",
            given="no study" if study is None else f"it, together with --against {against}",
            allowed="it together with a study, and without --against",
            cause="--model compares with the model of the study behind the scan",
            next_step="add the study behind the scan, and leave --against out",
        )  # fmt: skip
    if study is None and against is None and (options.corners is not None or options.mirrored):
        raise ScanError.missing(
            argument="--corners" if options.corners is not None else "--mirrored", given="no study",
            allowed="together with the study of a plate",
            cause="a scan can be registered only to the plate of a study",
            next_step="add the study behind the scan",
        )  # fmt: skip


def _about_content() -> list[str]:
    """Names of the options that describe the content of a file."""
    declared = ((item.name, option_of(item)) for item in fields(ScanOptions))
    return [name for name, choice in declared if choice is not None and choice.topic == CONTENT]


def compute(study: Description | None, options: ScanOptions, runner: Runner) -> ScanResult:
    """Analyse a scan, alone or on the plate of a study, and compare it with a model of the plate.

    Raises
    ------
    ScanError : settings that do not fit the scan, or no points left
    StudyError : a study without a plate
    """
    if options.model_is_a_study:
        assert options.against is not None
        study = load_as(options.against, Description)
    computed = read(options.against) if options.against and not options.model_is_a_study else None
    on = None if study is None else _need_plate(study, options, runner)
    state = runner.folder / PROGRESS if runner.folder else None
    runner.progress(0, 0, "reading")
    at = options.at if isinstance(options.at, int | float) else None
    scan = Scan.of(options.response) if options.response else scan_of(options)
    result = compute_scan(scan, options, on, at=at, state=state, store=runner.store, progress=runner.progress)
    verdict = None
    if study is not None and (options.against or options.model):
        verdict = compared(study, result.response, computed, runner)
    return replace(result, verdict=verdict, state=state, interactive=options.html)


def scan_of(options: ScanOptions) -> Scan:
    """Read the file that options name and describe.

    Raises
    ------
    HaptonicError : from `read_scan`
    """
    assert options.path is not None
    return read_scan(
        options.path, unit=options.unit, reference=options.reference,
        origin="simulated" if options.simulated else "measured", length_unit=options.length_unit,
        frequency_unit=options.frequency_unit, variables=options.variables or {},
        phase_unit=options.phase_unit, points_in=options.points_in, estimator=options.estimator,
        at=None if isinstance(options.at, int | float) else options.at,
    )  # fmt: skip


def _need_plate(study: Description, options: ScanOptions, runner: Runner) -> OnPlate:
    """Facts of the study about the scanned plate; raises StudyError for a study without a plate."""
    if study.plate_settings is None:
        raise StudyError.missing(
            argument="plate", given="nothing", allowed="a study with a [plate]",
            cause="the study describes a lattice without a plate",
            next_step="add [plate], or leave the study out to read the scan alone",
        )  # fmt: skip
    return on_plate(study, options, store=runner.store)


def examine(study: Description | None, options: ScanOptions, runner: Runner) -> ScanReading:
    """Reading of a file, and the place of its points on the plate of the study, if it has one.

    Raises
    ------
    HaptonicError : the file cannot be read with these options, or its points are not those of the plate
    """
    runner.progress(0, 0, "reading")
    scan = scan_of(options)
    if study is None or study.plate_settings is None:
        return ScanReading(scan)
    plate = study.mounted_plate()
    return ScanReading(scan, plate, registration_of(scan.points, plate, study.scan_settings, options))


def cost(study: Description | None, options: ScanOptions) -> Cost:
    """Estimated cost of reading the files, and of the comparison with a model."""
    size = 0 if options.path is None else size_of(options.path)
    read = Cost(ANALYSED + BYTE_OF_SCAN * size, BASE + HELD * size)
    if options.model_is_a_study:
        assert options.against is not None
        return read + cost_of(load_as(options.against, Description), computed=False)
    judged = study is not None and (options.against or options.model)
    return read + cost_of(study, computed=False) if study is not None and judged else read


ANALYSIS = Analysis(
    name="scan",
    result=ScanResult,
    compute=compute,
    supports=every_cell,
    cost=cost,
    options=ScanOptions,
    check=check,
    study="optional",
    doing="points",
    kept="finished points are stored; run the same command to continue",
    interactive="html",
    examine=examine,
    tables=("scan",),
)
