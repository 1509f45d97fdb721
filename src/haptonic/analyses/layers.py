"""What rows of cells let through between two plain plates, and how waves fade in the lattice."""

from __future__ import annotations

import numpy as np

from haptonic.analyses.analysis import KEPT, Analysis, NoOptions
from haptonic.analyses.needs import has_mirror, need_carrier
from haptonic.bloch.mirrors import Incidence
from haptonic.errors import StudyError
from haptonic.results.layers import Layers, compute_layers
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
    lowest, highest = section.lowest or LOWEST * carrier, section.highest or HIGHEST * carrier
    if lowest >= highest:
        raise StudyError(
            argument="layers.lowest",
            given=format_quantity(lowest, "Hz"),
            allowed=f"less than the highest frequency, {format_quantity(highest, 'Hz')}",
            cause="only one end of the spectrum was given, beyond the other's default",
            next_step="give both layers.lowest and layers.highest",
        )
    found: Layers = compute_layers(
        study.cell, study.asked(), np.linspace(lowest, highest, section.points),
        Incidence(section.angle, section.count, study.cell.material.loss_factor),
        carrier=carrier, inputs=study.inputs(), runner=runner,
    )  # fmt: skip
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
