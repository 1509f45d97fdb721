"""What rows of cells let through between two plain plates, and how waves fade in the lattice."""

from __future__ import annotations

from haptonic.analyses.analysis import KEPT, Analysis, NoOptions
from haptonic.analyses.needs import has_mirror, need_carrier
from haptonic.bloch.mirrors import Incidence
from haptonic.errors import StudyError
from haptonic.results.layers import Layers, Question, compute_layers
from haptonic.results.runner import Runner
from haptonic.study.schema import Description
from haptonic.units import format_quantity

LOWEST, HIGHEST = 0.6, 1.4  # of the carrier: ends of the spectrum where the study gives none


def compute(study: Description, options: NoOptions, runner: Runner) -> Layers:
    """Spectra of a mirror, and how many rows it needs at the carrier.

    Raises
    ------
    StudyError : no carrier, or no wave that propagates towards the rows
    """
    section, carrier = study.layers_settings, need_carrier(study)
    question = Question(
        lowest=section.lowest or LOWEST * carrier,
        highest=section.highest or HIGHEST * carrier,
        points=section.points,
        incidence=Incidence(section.angle, section.count, study.cell.material.loss_factor),
    )
    if question.lowest >= question.highest:
        raise StudyError(
            argument="layers.lowest",
            given=format_quantity(question.lowest, "Hz"),
            allowed=f"less than the highest frequency, {format_quantity(question.highest, 'Hz')}",
            cause="only one end of the spectrum was given, beyond the other's default",
            next_step="give both layers.lowest and layers.highest",
        )
    found: Layers = compute_layers(
        study.cell, study.bands_settings, question, carrier=carrier, inputs=study.inputs(), runner=runner
    )
    return found


ANALYSIS = Analysis(
    name="layers",
    help="What rows of cells let through between two plain plates, and how many of them the carrier needs.",
    result=Layers,
    compute=compute,
    reported=lambda study: NoOptions() if has_mirror(study) else None,
    parallel=True,
    kept=KEPT,
)
