"""Coefficients of friction from force records, and tests of their reduction."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from haptonic.analyses.analysis import Analysis
from haptonic.analyses.costs import size_of
from haptonic.analyses.options import option
from haptonic.analyses.runner import Runner
from haptonic.analyses.support import no_cell
from haptonic.errors import ResourceError
from haptonic.friction.recordings import TABLE, Exclusion, Sensor, analysed, understood
from haptonic.friction.recordings.draft import drafted
from haptonic.friction.signals import Rules
from haptonic.friction.statistics.summary import summary
from haptonic.paths import source
from haptonic.plate.layout.sampling import driven_region
from haptonic.progress import Progress, silent
from haptonic.results.cost import Cost
from haptonic.results.friction import FrictionResult
from haptonic.results.references import References
from haptonic.results.simulated_trials import STUDY
from haptonic.results.trial_draft import TrialDraft
from haptonic.results.trials_reading import TrialsReading
from haptonic.study.loading import load_trials_as, trials_in
from haptonic.study.schema import Description
from haptonic.study.trial_tables import TrialSettings

TESTED, BYTE_OF_TRIALS = 4.0, 6e-8  # s for statistics and pictures; s per byte that is read and filtered


@dataclass(frozen=True)
class FrictionOptions:
    """Options: the records and how they are processed.

    settings : in place of those of a file, in Python only: a pair of `TrialSettings` and the study that they
        belong to, or None
    """

    path: Path = option(
        help="Folder with trials.csv, or a single table of all samples.", metavar="PATH", place="before"
    )
    study: Path | None = option(
        None, "Study whose [trials] applies; by default study.toml in the folder.", metavar="FILE"
    )
    html: bool = option(False, "Also one interactive HTML page of the estimates.")
    settings: Any = field(default=None)
    draft: bool = option(False, "Write trials.csv from the names of the files in the folder; nothing else.")
    references: Any = option(
        None,
        "Reference values to show in the pictures.",
        read=References.read,
        is_path=True,
        metavar="FILE",
    )


def check(study: None, options: FrictionOptions) -> None:
    """Raise ResourceError if the folder of trials does not exist."""
    source(options.path, "folder of trials")


def compute(study: None, options: FrictionOptions, runner: Runner) -> FrictionResult | TrialDraft:
    """Measure all trials and test the reductions; with ``draft`` write a draft of the table of trials.

    Raises
    ------
    ResourceError : the file or folder does not exist
    FrictionError : a faulty table, no valid trial, or an unknown waveguide
    """
    path = options.path
    if options.draft:
        return _drafted(path)
    section, whole = _settings(options)
    driven = driven_region(whole.mounted_plate()) if whole is not None and whole.plate_settings else None
    result = compute_friction(
        path, section.sensor, section, section.exclude, driven=section.driven, of_plate=driven,
        workers=runner.workers, progress=runner.progress,
    )  # fmt: skip
    published = options.references.friction if options.references else {}
    return replace(result, published=published, interactive=options.html)


def compute_friction(
    path: Path | str,
    sensor: Sensor,
    rules: Rules,
    excluded: Sequence[Exclusion] = (),
    *,
    driven: str | None = None,
    of_plate: str | None = None,
    workers: int = 0,
    progress: Progress = silent,
) -> FrictionResult:
    """Read and measure all trials, and test the reductions.

    Parameters
    ----------
    path : a folder with ``trials.csv``, or a single table; see `haptonic.friction.recordings.analysed`
    driven : waveguide that carries the vibration; by default ``of_plate``, the driven region of a plate, or
        that with the largest reduction

    Raises
    ------
    ResourceError : the file or folder does not exist
    FrictionError : a faulty table, no valid trial, or an unknown waveguide
    """
    path = source(path, "folder of trials")
    read = analysed(path, sensor, rules, excluded, workers=workers, progress=progress)
    doubts = read.doubts
    if driven is None and of_plate is not None:
        if of_plate in read.trials["waveguide"].values:
            driven = of_plate
        else:
            largest = (
                "the waveguide with the largest reduction counts as driven; [trials] driven names another"
            )
            doubts = (*doubts, f"no trial was on {of_plate}, the driven region of the plate: {largest}")
    return FrictionResult(
        source=path,
        sensor=sensor,
        rules=rules,
        trials=read.trials,
        guessed=read.remarks,
        doubts=doubts,
        found=summary(read.trials, driven),
    )


def _drafted(folder: Path) -> TrialDraft:
    result = TrialDraft(folder, drafted(folder))
    try:
        result.save()
    except OSError as error:
        raise ResourceError.unwritable(
            argument="--draft",
            given=folder / TABLE,
            allowed="a folder in which you may write, without a table of trials",
            cause=error.strerror or type(error).__name__,
            next_step="choose another folder, or change its permissions",
        ) from error
    return result


def _settings(options: FrictionOptions) -> tuple[TrialSettings, Description | None]:
    if options.settings is not None:
        given: tuple[TrialSettings, Description | None] = options.settings
        return given
    beside = options.path / STUDY
    if options.study is None and not beside.is_file():
        return TrialSettings(), None
    return load_trials_as(options.study or beside, Description)


def examine(study: None, options: FrictionOptions, runner: Runner) -> TrialsReading | TrialDraft:
    """Reading of the table of trials and of the first records, or the table that can be drafted.

    Raises
    ------
    HaptonicError : a faulty table, or channels that cannot be found
    """
    if options.draft:
        return TrialDraft(options.path, drafted(options.path), saved=False)
    section, _ = _settings(options)
    return TrialsReading(understood(options.path, section.sensor))


def cost(study: None, options: FrictionOptions) -> Cost:
    """Estimated cost, from the size of the files."""
    return Cost(TESTED + BYTE_OF_TRIALS * size_of(options.path))


ANALYSIS = Analysis(
    name="friction",
    result=FrictionResult,
    compute=compute,
    supports=no_cell,
    cost=cost,
    options=FrictionOptions,
    check=check,
    study="none",
    parallel=True,
    doing="trials",
    interactive="html",
    examine=examine,
    study_option="study",
    settings=lambda text, folder: {"settings": trials_in(text, Description, folder)},
    tables=("trials",),
)
