"""How the finite plate vibrates."""

from __future__ import annotations

from dataclasses import dataclass, field

from haptonic.analyses.analysis import Analysis, option
from haptonic.analyses.costs import gaps, response
from haptonic.analyses.needs import fineness, gap_of_plate, has_plate, need_carrier, response_settings
from haptonic.plate.sampling import check_grid
from haptonic.plate.settings import ResponseSettings
from haptonic.plate.sweep import check_cost
from haptonic.results.cost import Cost
from haptonic.results.plate.compute import compute_plate
from haptonic.results.plate.value import PlateResult
from haptonic.results.runner import Runner
from haptonic.study.schema import Description


@dataclass(frozen=True)
class PlateOptions:
    """What may be chosen.

    settings : other lines and points than those of [plate.response], in Python only
    """

    at: float | None = option(None, 'One frequency only, such as "58.8 kHz".', unit="Hz", metavar="FREQUENCY")
    settings: ResponseSettings | None = field(default=None)


def check(study: Description, options: PlateOptions) -> None:
    """Raise StudyError if the study has no plate."""
    study.mounted_plate()


def compute(study: Description, options: PlateOptions, runner: Runner) -> PlateResult:
    """How the plate answers its drives over the band of [plate.response], or at a single frequency.

    Raises
    ------
    StudyError : no [plate], no carrier, or nothing that drives the plate
    ResourceError : a grid or a plate that this machine cannot hold, found before anything is computed
    """
    plate, at = study.mounted_plate(), options.at
    carrier = need_carrier(study) if at is None else at
    settings = options.settings or response_settings(study)
    if at is not None:
        settings = settings.single(at)
    check_cost(plate, settings.highest, single=at is not None)
    place = "plate.response.grid" if options.settings is None else "scan.grid"
    check_grid(plate, settings.grid, settings.points, place)
    return compute_plate(
        plate,
        settings,
        carrier=carrier,
        gap=gap_of_plate(study, plate, carrier, runner) if at is None else None,
        inputs=study.inputs(),
        store=runner.store,
        fineness=fineness(study),
        progress=runner.progress,
    )


def cost(study: Description, options: PlateOptions) -> Cost:
    """Of a plate's response, and of its lattice's gap."""
    plate, settings = study.mounted_plate(), response_settings(study)
    if options.at is not None:
        return response(plate, settings.single(options.at))
    return gaps(study) + response(plate, settings)


ANALYSIS = Analysis(
    name="plate",
    result=PlateResult,
    compute=compute,
    cost=cost,
    reported=lambda study: PlateOptions() if has_plate(study) else None,
    options=PlateOptions,
    check=check,
    doing="shifts",
)
