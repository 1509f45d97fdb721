"""What rows of cells let through between two plain plates, and how waves fade in the lattice."""

from __future__ import annotations

from haptonic.analyses.analysis import KEPT, Analysis, NoOptions
from haptonic.analyses.costs import gaps
from haptonic.analyses.needs import has_mirror, need_carrier, need_rows
from haptonic.bloch.mirrors import MOST_ROWS
from haptonic.results.cost import BASE, Cost
from haptonic.results.layers import Layers, compute_layers
from haptonic.results.runner import Runner
from haptonic.study.schema import Description

MIRROR, SQUARE_FACE = 0.035, 72  # s of a row at a frequency, where so many unknowns are on a face


def check(study: Description, options: NoOptions) -> None:
    """Refuse a study without a carrier, and rows in a direction that is none or costs too much."""
    need_carrier(study)
    need_rows(study)


def compute(study: Description, options: NoOptions, runner: Runner) -> Layers:
    """Spectra of a mirror, and how many rows it needs at the carrier.

    Raises
    ------
    StudyError : no carrier, or no wave that propagates towards the rows
    """
    found: Layers = compute_layers(
        study.cell,
        study.bands_settings,
        study.layers_settings,
        carrier=need_carrier(study),
        inputs=study.inputs(),
        runner=runner,
    )
    return found


def cost(study: Description, options: NoOptions) -> Cost:
    """Of a mirror's spectra."""
    settings = study.layers_settings
    on_face, memory = need_rows(study)
    each = MIRROR * (on_face / SQUARE_FACE) ** 2.5
    return gaps(study) + Cost(each * (settings.count * settings.points + MOST_ROWS), BASE + memory)


ANALYSIS = Analysis(
    name="layers",
    result=Layers,
    compute=compute,
    cost=cost,
    check=check,
    reported=lambda study: NoOptions() if has_mirror(study) else None,
    parallel=True,
    kept=KEPT,
)
