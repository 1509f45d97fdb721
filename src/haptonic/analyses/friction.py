"""Coefficients of friction from force records, and what they prove."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from haptonic.analyses.analysis import Analysis, option
from haptonic.analyses.costs import size_of
from haptonic.paths import source
from haptonic.plate.sampling import driven_region
from haptonic.results.cost import Cost
from haptonic.results.friction import FrictionResult, compute_friction
from haptonic.results.references import References
from haptonic.results.runner import Runner
from haptonic.study.loading import load_trials_as
from haptonic.study.schema import Description
from haptonic.study.trial_tables import TrialSettings

STUDY = "study.toml"  # beside the trials
TESTED, BYTE_OF_TRIALS = 4.0, 6e-8  # s, of statistics and pictures; of a byte that is read and filtered


@dataclass(frozen=True)
class FrictionOptions:
    """What is read, and how it is processed."""

    path: Path = option(
        help="Folder with trials.csv, or a single table of all samples.", metavar="PATH", place="before"
    )
    study: Path | None = option(None, "Its [trials] decides; else study.toml in the folder.", metavar="FILE")
    references: Any = option(
        None,
        "Reference values that stand beside these in the pictures.",
        read=References.read,
        metavar="FILE",
    )


def check(study: None, options: FrictionOptions) -> None:
    """Refuse what is no folder of trials."""
    source(options.path, "folder of trials")


def compute(study: None, options: FrictionOptions, runner: Runner) -> FrictionResult:
    """All trials, measured, and what they prove.

    Raises
    ------
    ResourceError : no such file or folder
    FrictionError : a table that is wrong, no trial that counts, or no waveguide of that name
    """
    path = options.path
    section, whole = _asked(path, options.study)
    driven = driven_region(whole.mounted_plate()) if whole is not None and whole.finite_plate else None
    found = compute_friction(
        path, section.sensor, section, section.exclude, driven=section.driven or driven,
        workers=runner.workers, progress=runner.progress,
    )  # fmt: skip
    return replace(found, published=options.references.friction if options.references else {})


def _asked(path: Path, study: Path | None) -> tuple[TrialSettings, Description | None]:
    beside = path / STUDY
    if study is None and not beside.is_file():
        return TrialSettings(), None
    return load_trials_as(study or beside, Description)


def cost(study: None, options: FrictionOptions) -> Cost:
    """Of what is read."""
    return Cost(TESTED + BYTE_OF_TRIALS * size_of(options.path))


ANALYSIS = Analysis(
    name="friction",
    result=FrictionResult,
    compute=compute,
    cost=cost,
    options=FrictionOptions,
    check=check,
    study="none",
    parallel=True,
    doing="trials",
)
