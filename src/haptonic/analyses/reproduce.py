"""Report of everything that a study describes, compared with reference values if they exist."""

from __future__ import annotations

import time
import warnings
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import asdict, dataclass, replace
from datetime import UTC, datetime
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, TypeVar

from haptonic import report
from haptonic.analyses import NAMES, named
from haptonic.analyses.analysis import KEPT, Analysis
from haptonic.analyses.experiments import protocol_of, truth_of
from haptonic.analyses.friction import compute_friction
from haptonic.analyses.options import option
from haptonic.analyses.plate_needs import has_plate
from haptonic.analyses.runner import Runner
from haptonic.analyses.simulate_scan import rescanned
from haptonic.analyses.support import made_of_parts
from haptonic.errors import HaptonicError, HaptonicWarning
from haptonic.friction.recordings import Sensor
from haptonic.friction.simulation import Experiment
from haptonic.friction.statistics import Alarms, Population, false_alarms
from haptonic.later import xarray as xr
from haptonic.report import Results
from haptonic.results.bands import Bands
from haptonic.results.cost import Cost
from haptonic.results.feel.value import Feel
from haptonic.results.friction import FrictionResult
from haptonic.results.plate.value import PlateResult
from haptonic.results.references import References, Variant, found_at
from haptonic.results.result import Result
from haptonic.results.simulated_trials import SimulatedFriction
from haptonic.results.table import Table
from haptonic.study.schema import Description

ALARMS = 400  # simulated experiments without an effect
WRITTEN = ("bands", "sweep", "layers", "plate", "feel")  # parts whose files are written beside the report

T = TypeVar("T")
PICTURES = 30.0  # s, for a report with a plate, and for simulated scan and trials


@dataclass(frozen=True)
class ReproduceOptions:
    """Options of the report."""

    references: Any = option(
        None, "Reference values; by default references/STUDY beside the study.", read=References.read,
        is_path=True, metavar="FILE",
    )  # fmt: skip


@dataclass(frozen=True, eq=False, repr=False)
class Reproduction(Result):
    """All results of a study, and their report."""

    title = "Report"

    parts: Mapping[str, Result]
    results: Results

    @property
    def bands(self) -> Bands:
        """The bands, which every study has."""
        bands = self.parts["bands"]
        assert isinstance(bands, Bands)
        return bands

    @property
    def dataset(self) -> xr.Dataset:
        """Dataset of the bands; those of the other results are in ``parts``."""
        return self.bands.dataset

    @classmethod
    def names(cls, options: Any = None) -> list[Any]:
        return ["report.html", *(name for part in WRITTEN for name in named(part).result.names())]

    def put(self, draft: Path, *_: object) -> None:
        for name in WRITTEN:
            if name in self.parts:
                self.parts[name].put(draft)
        report.write_report(self.results, draft / "report.html")

    def summary(self) -> list[str]:
        """Bands; for a plate the first sentence of each part, because the report contains the others."""
        plate = [self.parts[name].summary()[0] for name in ("plate", "feel") if name in self.parts]
        return [self.bands.summary()[0], *plate] if plate else self.bands.summary()

    def tables(self) -> list[Table]:
        return self.bands.tables()

    def remarks(self) -> list[str]:
        return [f"{name}: {text}" for name, part in self.parts.items() for text in part.remarks()]

    def facts(self) -> dict[str, Any]:
        sweeps = self.parts.get("sweep")
        facts = {**self.bands.facts(), "seconds": self.results.timings, **(sweeps.facts() if sweeps else {})}
        rows = [asdict(row) for row in self.results.comparisons]
        return facts | ({"comparison": rows} if rows else {})

    def located(self, folder: Path) -> dict[str, Any]:
        return {"report": str(folder / "report.html")}


def compute(study: Description, options: ReproduceOptions, runner: Runner) -> Reproduction:
    """Run every analysis of the study's report, and the simulated measurements that follow from them."""
    references = options.references or References.beside(runner.about)
    started, timings = datetime.now(UTC), dict[str, float]()
    parts: dict[str, Result] = {}
    for analysis, chosen in _reported(study):
        with _timed(timings, analysis.name):
            result = _try_part(analysis.name, partial(_compute, analysis, study, chosen, runner))
        if result is not None:
            parts[analysis.name] = result
    plate, feel, alarms = parts.get("plate"), parts.get("feel"), dict[str, Alarms]()
    if isinstance(plate, PlateResult):
        with _timed(timings, "simulated scan"):
            scanning = partial(rescanned, study, plate, store=runner.store, progress=runner.progress)
            scan = _try_part("simulated scan", scanning)
        parts |= {"scan": scan} if scan else {}
    if isinstance(feel, Feel):
        with _timed(timings, "simulated trials"):
            trials = _try_part("simulated trials", lambda: _trials(study, feel, runner))
            alarms = _alarms(study) if trials else {}
        if trials:
            published = references.friction if references else {}
            parts["friction"] = replace(trials, published=published)
    varied: list[tuple[Variant, float | None]] = []
    if references is not None:
        with _timed(timings, "variants"):
            varied = [(variant, _vary(study, variant, runner)) for variant in references.variant]
    results = Results(
        study,
        parts,
        alarms=alarms,
        references=references,
        variants=tuple(varied),
        timings=timings,
        started=started,
    )
    return Reproduction(parts, results)


def _compute(analysis: Analysis, study: Description, chosen: Any, runner: Runner) -> Result:
    """Compute an analysis, with its name in the progress.

    An unsupported cell is refused, and the chapter of the report gives the reason.
    """

    def progress(done: int, planned: int, what: str = "", /) -> None:
        runner.progress(done, planned, f"{analysis.name}, {what}" if what else analysis.name)

    analysis.need_supported(study, chosen)
    return analysis.answer(study, chosen, replace(runner, progress=progress))


def _reported(study: Description) -> Iterator[tuple[Analysis, Any]]:
    """Analyses in the report of a study, with their options."""
    for analysis in map(named, NAMES):
        if analysis.reported is not None and (chosen := analysis.reported(study)) is not None:
            yield analysis, chosen


def _try_part(name: str, make: Callable[[], T]) -> T | None:
    """Compute a part of the report; if it fails, warn with the reason. Only the bands are required."""
    try:
        return make()
    except HaptonicError as error:
        if name == "bands":
            raise
        warnings.warn(f"the report has no {name}: {error.cause}", HaptonicWarning, stacklevel=2)
        return None


@contextmanager
def _timed(timings: dict[str, float], part: str) -> Iterator[None]:
    """Note the seconds of a part of the run."""
    clock = time.perf_counter()
    yield
    timings[part] = time.perf_counter() - clock


def _trials(study: Description, feel: Feel, runner: Runner) -> FrictionResult:
    """Simulate trials on the computed plate, and analyse them like measured ones."""
    protocol, count = protocol_of(study), study.protocol_settings.participants
    truth = truth_of(study, {name: feel.friction.amplitude(name) for name in feel.friction.regions})
    simulated = SimulatedFriction(
        experiment=Experiment(truth, protocol, count), study=study.to_toml(), suffix=".h5", per="block"
    )
    with TemporaryDirectory() as name:
        simulated.put(Path(name), runner.progress)
        return compute_friction(
            Path(name), Sensor(), study.trials, driven=protocol.waveguides[0], progress=runner.progress
        )


def _alarms(study: Description) -> dict[str, Alarms]:
    """False-alarm rate of each test in trials like those of the study."""
    section, people = study.protocol_settings, study.participants
    if section.participants < 2:
        return {}
    population = Population(0.0, people.effect_between, people.within, people.between)
    each = section.blocks * section.trials // 4
    return dict(false_alarms(population, section.participants, each, simulations=ALARMS))


def _vary(study: Description, variant: Variant, runner: Runner) -> float | None:
    """Value of a variant; None if the result lacks it, or if the study cannot be changed in this way."""
    runner.progress(0, 0, variant.label)
    analysis = named(variant.analysis)
    try:
        result = analysis.compute(
            changed(study, variant.change, variant.label), analysis.options(), Runner(runner.store)
        )
    except HaptonicError as error:
        warnings.warn(f"{variant.table}, {variant.label}: {error}", HaptonicWarning, stacklevel=2)
        return None
    value = found_at(result.to_json(), variant.path)
    return float(value) if isinstance(value, int | float) else None


def changed(study: Description, changes: Mapping[str, Any], origin: str) -> Description:
    """A study with changed values and without sweeps.

    Parameters
    ----------
    changes : new values by key of the file, ``cell.site[2].pillar.height``; also whole tables and lists
    origin : name of the study in error messages

    Raises
    ------
    HaptonicError : an unknown key, or a value that is not allowed
    """
    try:
        return study.with_keys(changes)
    except HaptonicError as error:
        argument = error.argument.replace("study: ", f"{origin}: ", 1)
        raise error.changed(type(error), argument=argument) from None


def cost(study: Description, options: ReproduceOptions) -> Cost:
    """Estimated cost of every analysis in the report."""
    total = Cost(PICTURES if has_plate(study) else 0.0)
    for analysis, chosen in _reported(study):
        if analysis.cost and analysis.name != "feel":  # the plate is not computed twice
            part = analysis.cost(study, chosen)
            # a report requires the bands; other parts are left out if they are refused
            total += part if analysis.name == "bands" else replace(part, refusal=None)
    return total


ANALYSIS = Analysis(
    name="reproduce",
    result=Reproduction,
    compute=compute,
    supports=made_of_parts,
    cost=cost,
    planned=lambda study: True,
    options=ReproduceOptions,
    parallel=True,
    doing="report",
    kept=KEPT,
    folder="report",
    writes=True,
)
