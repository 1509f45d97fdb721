"""Plan of a study: its sizes and the cost of each command, without computing anything."""

from __future__ import annotations

from collections import Counter

from haptonic.analyses import NAMES, named
from haptonic.analyses.analysis import Analysis
from haptonic.analyses.options import NoOptions
from haptonic.analyses.runner import Runner
from haptonic.analyses.support import every_cell
from haptonic.errors import HaptonicError
from haptonic.results.cost import Cost
from haptonic.results.plan import StudyPlan
from haptonic.study.named import expressions_of
from haptonic.study.plating import plate_of
from haptonic.study.schema import Description


def compute(study: Description, options: NoOptions, runner: Runner) -> StudyPlan:
    """Sizes of the study, its plate if it has one, and the estimated cost of every command that applies."""
    settings = study.plate_settings
    plate = plate_of(settings, study.cell) if settings else None
    letters = Counter(name for row in settings.grid for name in row if name) if settings else {}
    every = ((name, named(name)) for name in NAMES)
    costs = {
        name: _cost(analysis, study)
        for name, analysis in every
        if analysis.cost and analysis.is_planned(study)
    }
    return StudyPlan(
        study=study.title,
        carrier=study.carrier,
        cell=study.cell,
        plate=plate,
        costs=costs,
        inputs=study.inputs(),
        tiles=letters,
        parameters=study.named_parameters,
        expressions=expressions_of(study),
    )


def _cost(analysis: Analysis, study: Description) -> Cost:
    """Estimated cost of an analysis, or the error with which it refuses the study."""
    assert analysis.cost is not None
    options = analysis.options()
    try:
        analysis.admit(study, options)
    except HaptonicError as refusal:
        return Cost(0.0, refusal=refusal)
    return analysis.cost(study, options)


ANALYSIS = Analysis(
    name="plan",
    result=StudyPlan,
    compute=compute,
    supports=every_cell,
    doing="drawing",
    watches=True,
)
