"""Complete gaps along the rows of designs that a study describes."""

from __future__ import annotations

from haptonic.analyses.analysis import KEPT, Analysis, NoOptions
from haptonic.errors import StudyError
from haptonic.results.runner import Runner
from haptonic.results.sweeps import Row, Sweeps, compute_sweeps
from haptonic.study.schema import Description


def check(study: Description, options: NoOptions) -> None:
    """Raise StudyError if the study has no sweep."""
    if not study.sweep_settings:
        raise StudyError(
            argument="sweep",
            given="nothing",
            allowed="at least one [[sweep]] table",
            cause="the study describes a single design",
            next_step='add [[sweep]] with vary = "cell.pillar.diameter / cell.pitch", from, to and steps',
        )


def compute(study: Description, options: NoOptions, runner: Runner) -> Sweeps:
    """Complete gaps of every design; those that could not be computed are left out, and it is said."""
    rows = [
        Row(
            sweep.values,
            [design.cell for design in study.designs(sweep)],
            {
                "expression": sweep.vary,
                "units": sweep.unit,
                "own_value": sweep.expression.value(study.parameters()),
                "carrier_hz": study.carrier,
            },
        )
        for sweep in study.sweep_settings
    ]
    return compute_sweeps(rows, study.bands_settings, inputs=study.inputs(), runner=runner)


ANALYSIS = Analysis(
    name="sweep",
    help="Complete gaps along the study's sweeps.",
    result=Sweeps,
    compute=compute,
    reported=lambda study: NoOptions() if study.sweep_settings else None,
    check=check,
    parallel=True,
    kept=KEPT,
)
