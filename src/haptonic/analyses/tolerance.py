"""How sure the gap is to hold the carrier on plates that are not alike."""

from __future__ import annotations

from haptonic.analyses.analysis import KEPT, Analysis, NoOptions
from haptonic.analyses.needs import need_carrier
from haptonic.errors import StudyError
from haptonic.results.runner import Runner
from haptonic.results.tolerance import Tolerance, compute_tolerance
from haptonic.study.schema import Description


def compute(study: Description, options: NoOptions, runner: Runner) -> Tolerance:
    """Chances, what they depend on, and the loosest machining that keeps them.

    Raises
    ------
    StudyError : no carrier, no spreads, or a gap that does not hold the carrier as drawn
    """
    section = study.tolerance_settings
    if not section.of:
        raise StudyError(
            argument="tolerance.of",
            given="nothing",
            allowed="at least one [[tolerance.of]] table with parameter and spread",
            cause="the study does not say what differs",
            next_step='add [[tolerance.of]] with parameter = "cell.pillar.diameter", spread = "20 um"',
        )
    return compute_tolerance(
        study.cell,
        study.bands_settings,
        section.of,
        carrier=need_carrier(study),
        margin=section.margin,
        confidence=section.confidence,
        pillars=section.pillars,
        count=section.samples,
        inputs=study.inputs(),
        runner=runner,
    )


ANALYSIS = Analysis(
    name="tolerance",
    help="The chance that the gap holds the carrier, the size that matters most, and the loosest tolerances.",
    result=Tolerance,
    compute=compute,
    parallel=True,
    kept=KEPT,
)
