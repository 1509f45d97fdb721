"""Bands, gaps and mode shapes of the unit cell."""

from __future__ import annotations

from dataclasses import dataclass

from haptonic.analyses.analysis import Analysis, option
from haptonic.results.bands import Bands, compute_bands
from haptonic.results.runner import Runner
from haptonic.study.schema import Description


@dataclass(frozen=True)
class BandsOptions:
    """What may be chosen."""

    surface: bool = option(False, "Also contours over the zone and the density of states.")


def compute(study: Description, options: BandsOptions, runner: Runner) -> Bands:
    """Band diagram, gaps and mode shapes.

    Raises
    ------
    ResourceError : the accuracy needs more memory than there is
    """
    return compute_bands(
        study.cell, study.bands_settings, surface=options.surface, inputs=study.inputs(),
        carrier=study.carrier, store=runner.store,
    )  # fmt: skip


ANALYSIS = Analysis(
    name="bands",
    result=Bands,
    compute=compute,
    reported=lambda study: BandsOptions(surface=True),
    options=BandsOptions,
)
