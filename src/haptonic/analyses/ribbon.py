"""Waves along a ribbon: cells side by side in one direction, repeated along the other."""

from __future__ import annotations

from haptonic.analyses.analysis import Analysis, NoOptions
from haptonic.analyses.costs import meshes
from haptonic.errors import StudyError
from haptonic.results.cost import Cost
from haptonic.results.ribbon import RibbonWaves, compute_ribbon
from haptonic.results.runner import Runner
from haptonic.study.ribbon_tables import RibbonSettings
from haptonic.study.schema import Description

COLUMN, BULK = 0.17, 0.2  # s of a column of a ribbon at a wavevector, where it has one tile; of a crystal


def _needed(study: Description) -> RibbonSettings:
    if study.ribbon_settings is None:
        raise StudyError.missing(
            argument="ribbon",
            allowed="a [ribbon] table with map and tiles",
            cause="the study does not say what lies side by side",
            next_step='add map = "ooooo1111ooooo" to [ribbon], and o = "lattice" and 1 = "guide" to '
            "[ribbon.tiles]",
        )
    return study.ribbon_settings


def check(study: Description, options: NoOptions) -> None:
    """Raise StudyError if the study has no ribbon."""
    _needed(study)


def compute(study: Description, options: NoOptions, runner: Runner) -> RibbonWaves:
    """Projected bands, and the modes that a guide or an edge holds.

    Raises
    ------
    StudyError : no ribbon, or nothing says at which frequencies to look
    """
    asked = _needed(study)
    found: RibbonWaves = compute_ribbon(
        asked.ribbon(study.cell),
        asked.names,
        study.bands_settings,
        points=asked.wavevectors,
        rows=asked.rows,
        between=(asked.lowest, asked.highest),
        carrier=study.carrier,
        inputs=study.inputs(),
        runner=runner,
    )
    return found


def cost(study: Description, options: NoOptions) -> Cost:
    """Of the modes of a ribbon at each wavevector, and of the bulk bands of its crystals."""
    section = _needed(study)
    made = section.ribbon(study.cell)
    tiles = max(len(cell.tiles) for cell in made.cells) * len(made.lines)
    each = Cost(COLUMN * tiles**2 * len(made.first) + BULK * len(made.crystals) * len(made.lines))
    return meshes(study).times(max(1, len(made.cells))) + each.times(section.rows or section.wavevectors)


ANALYSIS = Analysis(
    name="ribbon",
    result=RibbonWaves,
    compute=compute,
    cost=cost,
    check=check,
    reported=lambda study: NoOptions() if study.ribbon_settings else None,
)
