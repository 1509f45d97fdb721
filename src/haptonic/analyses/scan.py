"""A scan with a laser vibrometer: responses, maps, contrast, gap, waves; and how well a model fits."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal

from haptonic.analyses.analysis import Analysis
from haptonic.analyses.costs import size_of
from haptonic.analyses.options import UnitsOfFile, option
from haptonic.analyses.runner import Runner
from haptonic.analyses.scanning import Estimation, OnPlate, PlateInScan, compute_scan, on_plate
from haptonic.analyses.support import every_cell
from haptonic.analyses.verdict import compared, cost_of
from haptonic.errors import ScanError, StudyError, shown
from haptonic.paths import source
from haptonic.response import read
from haptonic.results.cost import BASE, Cost
from haptonic.results.scan.value import ScanResult
from haptonic.study.loading import load_as
from haptonic.study.schema import Description
from haptonic.units import to_si
from haptonic.vibrometry import read_scan

PROGRESS = "estimating"  # folder in which an estimation that was stopped goes on
ANALYSED, BYTE_OF_SCAN = 4.0, 5e-8  # s, of maps and pictures; of a byte that is read and estimated
HELD = 4.0  # of a file in memory at once, times its size


def names_of(variables: str) -> Mapping[str, str]:
    """Names of arrays by their meanings, from ``response=FRF,x=Xmm``.

    Raises
    ------
    ScanError : another form
    """
    pairs = [one.split("=", 1) for one in variables.split(",")] if variables else []
    if any(len(pair) != 2 or not all(part.strip() for part in pair) for pair in pairs):
        raise ScanError.malformed(
            argument="--variables",
            given=shown(variables),
            allowed="MEANING=NAME, several of them parted by commas",
            cause="a sign of equality or a name is missing",
            next_step="write --variables=response=FRF,frequency=f,x=X,y=Y",
        )
    return {meaning.strip(): name.strip() for meaning, name in pairs}


def frequency_or_points(text: str) -> float | str:
    """A frequency in Hz, or the places of points: lengths with commas between them."""
    return text if "," in text else to_si(text, "Hz", "--at")


@dataclass(frozen=True, kw_only=True)
class ScanOptions(UnitsOfFile, PlateInScan, Estimation):
    """What is read, and how it is analysed."""

    path: Path = option(help="Scan file, or a folder with one CSV a point.", metavar="PATH", place="before")
    against: Path | None = option(
        None, "Compare with a model: a study; or, after STUDY, its computed response (.nc).",
        metavar="MODEL",
    )  # fmt: skip
    at: Any = option(
        None, "Frequency of the operating shape, else the loudest; or the places of points in a file without "
        'coordinates, "10 mm, 5 mm; 15 mm, 5 mm".', read=frequency_or_points, metavar="FREQUENCY|X,Y;...",
    )  # fmt: skip
    unit: str | None = option(None, "Unit of responses or records in files that give none; by default m/s/V.")
    length_unit: str | None = option(None, 'Unit of coordinates in files that give none, such as "mm".')
    variables: Any = option(
        None, "Names of arrays, columns or channels by meaning, such as response=FRF,x=X.", read=names_of,
        metavar="MEANING=NAME,...",
    )  # fmt: skip
    reference: str | None = option(None, 'Name and unit of the reference, such as "A1, V".')
    phase_unit: str | None = option(
        None, "Unit of phases in files that give none: rad or deg.", metavar="UNIT"
    )
    points_in: Literal["rows", "columns"] | None = option(
        None, "Order of arrays with as many points as frequencies: rows or columns.", metavar="SIDE"
    )
    simulated: bool = option(False, "The file is of a simulation.")

    @property
    def model_is_a_study(self) -> bool:
        """Whether the model that is judged is a study, and not a response that it has given."""
        return self.against is not None and self.against.suffix != ".nc"


def check(study: Description | None, options: ScanOptions) -> None:
    """Refuse a scan that is no file, and what only a study or only a plate could tell."""
    source(options.path, "scan")
    against = options.against
    if against and study is None and not options.model_is_a_study:
        raise ScanError.missing(
            argument="--against", given=f"{against}, a response without its study",
            allowed="a study; or the study behind the scan, and here the response that it has given",
            cause="a response says neither where regions lie nor what may be fitted",
            next_step=f"haptonic scan PATH STUDY --against {against}",
        )  # fmt: skip
    if options.model_is_a_study and study is not None:
        raise ScanError.conflict(
            argument="--against", given=f"{against}, beside a study",
            allowed="one study, or after a study the response (.nc) that it has given",
            cause="the study that is judged also says where on the plate the points lie",
            next_step="leave the study behind the scan out",
        )  # fmt: skip
    if study is None and against is None and (options.corners is not None or options.mirrored):
        raise ScanError.missing(
            argument="--corners" if options.corners is not None else "--mirrored", given="no study",
            allowed="together with the study of a plate",
            cause="a scan is registered to the plate of a study",
            next_step="name the study behind the scan",
        )  # fmt: skip


def compute(study: Description | None, options: ScanOptions, runner: Runner) -> ScanResult:
    """All that a scan tells, alone or on the plate of a study; and a verdict on a model of the plate.

    Raises
    ------
    ScanError : settings that do not fit the scan, or nothing left of it
    StudyError : a study without a plate
    """
    if options.model_is_a_study:
        assert options.against is not None
        study = load_as(options.against, Description)
    computed = read(options.against) if options.against and not options.model_is_a_study else None
    on = None if study is None else _on(study, options, runner)
    state = runner.folder / PROGRESS if runner.folder else None
    runner.progress(0, 0, "reading")
    at = options.at if isinstance(options.at, int | float) else None
    content = read_scan(
        options.path, unit=options.unit, reference=options.reference,
        origin="simulated" if options.simulated else "measured", length_unit=options.length_unit,
        frequency_unit=options.frequency_unit, variables=options.variables or {},
        phase_unit=options.phase_unit, points_in=options.points_in, estimator=options.estimator,
        at=None if at is not None else options.at,
    )  # fmt: skip
    found = compute_scan(
        content, options, on, at=at, state=state, store=runner.store, progress=runner.progress
    )
    verdict = None
    if study is not None and options.against:
        verdict = compared(study, found.response, computed, runner)
    return replace(found, verdict=verdict, state=state)


def _on(study: Description, options: ScanOptions, runner: Runner) -> OnPlate:
    """What the study says of the plate that was scanned."""
    if study.finite_plate is None:
        raise StudyError.missing(
            argument="plate", given="nothing", allowed="a study with a [plate]",
            cause="the study describes a lattice, and no plate that was scanned",
            next_step="add [plate], or leave the study out",
        )  # fmt: skip
    return on_plate(study, options, store=runner.store)


def cost(study: Description | None, options: ScanOptions) -> Cost:
    """Of what is read, and of the verdict on a model."""
    size = size_of(options.path)
    read = Cost(ANALYSED + BYTE_OF_SCAN * size, BASE + HELD * size)
    if options.model_is_a_study:
        assert options.against is not None
        return read + cost_of(load_as(options.against, Description), computed=False)
    return read + cost_of(study, computed=False) if study is not None and options.against else read


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
    kept="the points that were estimated are kept; the same command goes on from there",
)
