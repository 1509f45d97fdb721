"""Bands, gaps and mode shapes of the unit cell."""

from __future__ import annotations

from dataclasses import dataclass

from haptonic.analyses.analysis import Analysis, option
from haptonic.bloch.wavevectors import wavevector_at
from haptonic.results.bands import Bands, compute_bands
from haptonic.results.runner import Runner
from haptonic.study.schema import Description


@dataclass(frozen=True)
class BandsOptions:
    """What may be chosen."""

    surface: bool = option(False, "Also contours over the zone and the density of states.")
    modes_at: str | None = option(
        None,
        'Wavevector of the mode shapes: a corner such as M, "0.3 X-M", or two phases over pi.',
        metavar="K",
    )


def check(study: Description, options: BandsOptions) -> None:
    """Raise StudyError if there is no such wavevector."""
    if options.modes_at is not None:
        wavevector_at(study.cell.zone, options.modes_at)


def compute(study: Description, options: BandsOptions, runner: Runner) -> Bands:
    """Band diagram, gaps and mode shapes.

    Raises
    ------
    ResourceError : the accuracy needs more memory than there is
    """
    return compute_bands(
        study.cell, study.bands_settings, surface=options.surface, inputs=study.inputs(),
        carrier=study.carrier, store=runner.store, modes_at=options.modes_at,
    )  # fmt: skip


ANALYSIS = Analysis(
    name="bands",
    result=Bands,
    compute=compute,
    check=check,
    reported=lambda study: BandsOptions(surface=True),
    options=BandsOptions,
)
