"""Everything that a study describes in one report, beside reference values if its example brings some."""

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
from haptonic.analyses.needs import has_plate
from haptonic.analyses.options import option
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
WRITTEN = ("bands", "sweep", "layers", "plate", "feel")  # whose files come to lie beside the report

T = TypeVar("T")
PICTURES = 30.0  # s, of a report with a plate, and of the simulated scan and trials


@dataclass(frozen=True)
class ReproduceOptions:
    """What may be chosen."""

    references: Any = option(
        None, "Reference values; by default references/STUDY beside the study.", read=References.read,
        metavar="FILE",
    )  # fmt: skip


@dataclass(frozen=True, eq=False, repr=False)
class Reproduction(Result):
    """All results of a study, and the report made of them."""

    title = "Report"

    parts: Mapping[str, Result]
    results: Results

    @property
    def bands(self) -> Bands:
        """Every study has them."""
        found = self.parts["bands"]
        assert isinstance(found, Bands)
        return found

    @property
    def dataset(self) -> xr.Dataset:
        """That of the bands; the others are in ``parts``."""
        return self.bands.dataset

    @classmethod
    def names(cls, options: Any = None) -> list[Any]:
        return ["report.html", *(name for one in WRITTEN for name in named(one).result.names())]

    def put(self, draft: Path, *_: object) -> None:
        for name in WRITTEN:
            if name in self.parts:
                self.parts[name].put(draft)
        report.write_report(self.results, draft / "report.html")

    def summary(self) -> list[str]:
        """The bands; of a plate the first sentence of each part, the others are in the report."""
        said = [self.parts[name].summary()[0] for name in ("plate", "feel") if name in self.parts]
        return [self.bands.summary()[0], *said] if said else self.bands.summary()

    def tables(self) -> list[Table]:
        return self.bands.tables()

    def remarks(self) -> list[str]:
        return [f"{name}: {text}" for name, one in self.parts.items() for text in one.remarks()]

    def facts(self) -> dict[str, Any]:
        sweeps = self.parts.get("sweep")
        told = {**self.bands.facts(), "seconds": self.results.timings, **(sweeps.facts() if sweeps else {})}
        rows = [asdict(one) for one in self.results.comparisons]
        return told | ({"comparison": rows} if rows else {})

    def located(self, folder: Path) -> dict[str, Any]:
        return {"report": str(folder / "report.html")}


def compute(study: Description, options: ReproduceOptions, runner: Runner) -> Reproduction:
    """Every analysis that belongs into the report of such a study, and what follows from them."""
    references = options.references or References.beside(runner.about)
    started, timings = datetime.now(UTC), dict[str, float]()
    parts: dict[str, Result] = {}
    for one, chosen in _reported(study):
        with _timed(timings, one.name):
            found = _tried(one.name, partial(_answered, one, study, chosen, _of(runner, one)))
        if found is not None:
            parts[one.name] = found
    plate, feel, alarms = parts.get("plate"), parts.get("feel"), dict[str, Alarms]()
    if isinstance(plate, PlateResult):
        with _timed(timings, "simulated scan"):
            made = partial(rescanned, study, plate, store=runner.store, progress=runner.progress)
            scan = _tried("simulated scan", made)
        parts |= {"scan": scan} if scan else {}
    if isinstance(feel, Feel):
        with _timed(timings, "made-up trials"):
            trials = _tried("made-up trials", lambda: _trials(study, feel, runner))
            alarms = _alarms(study) if trials else {}
        if trials:
            known = references.friction if references else {}
            parts["friction"] = replace(trials, published=known)
    varied: list[tuple[Variant, float | None]] = []
    if references is not None:
        with _timed(timings, "variants"):
            varied = [(one, _varied(study, one, runner)) for one in references.variant]
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


def _answered(one: Analysis, study: Description, chosen: Any, runner: Runner) -> Result:
    """The result of an analysis; a cell that it does not support is refused, and its chapter says so."""
    one.need_supported(study, chosen)
    return one.compute(study, chosen, runner)


def _reported(study: Description) -> Iterator[tuple[Analysis, Any]]:
    """The analyses that the report of a study has, with their options."""
    for one in map(named, NAMES):
        if one.reported is not None and (chosen := one.reported(study)) is not None:
            yield one, chosen


def _of(runner: Runner, one: Analysis) -> Runner:
    """The same, telling what it is about."""

    def progress(done: int, planned: int, what: str = "", /) -> None:
        runner.progress(done, planned, f"{one.name}, {what}" if what else one.name)

    return replace(runner, progress=progress)


def _tried(name: str, make: Callable[[], T]) -> T | None:
    """A part of the report, or a warning that says why it is left out; no report is without bands."""
    try:
        return make()
    except HaptonicError as error:
        if name == "bands":
            raise
        warnings.warn(f"no {name}: {error.cause}", HaptonicWarning, stacklevel=2)
        return None


@contextmanager
def _timed(timings: dict[str, float], part: str) -> Iterator[None]:
    """Note the seconds of a part of the run."""
    clock = time.perf_counter()
    yield
    timings[part] = time.perf_counter() - clock


def _trials(study: Description, feel: Feel, runner: Runner) -> FrictionResult:
    """Trials of made-up people on the plate as it is computed, analysed like measured ones."""
    protocol, count = protocol_of(study), study.protocol_settings.participants
    truth = truth_of(study, {name: feel.friction.amplitude(name) for name in feel.friction.regions})
    made = SimulatedFriction(
        experiment=Experiment(truth, protocol, count), study=study.to_toml(), suffix=".h5", per="block"
    )
    with TemporaryDirectory() as name:
        made.put(Path(name), runner.progress)
        return compute_friction(
            Path(name), Sensor(), study.trials, driven=protocol.waveguides[0], progress=runner.progress
        )


def _alarms(study: Description) -> dict[str, Alarms]:
    """How often each test cries wolf in trials like those of the study."""
    section, people = study.protocol_settings, study.participants
    if section.participants < 2:
        return {}
    population = Population(0.0, people.effect_between, people.within, people.between)
    each = section.blocks * section.trials // 4
    return dict(false_alarms(population, section.participants, each, simulations=ALARMS))


def _varied(study: Description, variant: Variant, runner: Runner) -> float | None:
    """The value of a variant; None if it has none, or if the study cannot be changed so."""
    runner.progress(0, 0, variant.label)
    one = named(variant.analysis)
    try:
        found = one.compute(
            changed(study, variant.change, variant.label), one.options(), Runner(runner.store)
        )
    except HaptonicError as error:
        warnings.warn(f"{variant.table}, {variant.label}: {error}", HaptonicWarning, stacklevel=2)
        return None
    value = found_at(found.to_json(), variant.path)
    return float(value) if isinstance(value, int | float) else None


def changed(study: Description, changes: Mapping[str, Any], origin: str) -> Description:
    """One design: a study without sweeps, with what its file gives changed.

    Parameters
    ----------
    changes : new values by key of the file, ``cell.site[2].pillar.height``; whole tables and lists too
    origin : what an error calls the study

    Raises
    ------
    HaptonicError : no such key, or a value that it cannot have
    """
    try:
        return study.with_keys(changes)
    except HaptonicError as error:
        argument = error.argument.replace("study: ", f"{origin}: ", 1)
        raise error.changed(type(error), argument=argument) from None


def cost(study: Description, options: ReproduceOptions) -> Cost:
    """Of every analysis in the report."""
    total = Cost(PICTURES if has_plate(study) else 0.0)
    for one, chosen in _reported(study):
        if one.cost and one.name != "feel":  # the plate is not computed twice
            part = one.cost(study, chosen)
            # no report is without bands; other parts are left out
            total += part if one.name == "bands" else replace(part, refusal=None)
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
