"""Waveguides that fit between two mirrors."""

from __future__ import annotations

from dataclasses import dataclass

from haptonic.analyses.analysis import Analysis, option
from haptonic.analyses.costs import gaps
from haptonic.analyses.layers import SQUARE_FACE
from haptonic.analyses.needs import has_mirror, need_carrier, need_rows
from haptonic.bloch.settings import WaveguideSettings
from haptonic.cell import Rows
from haptonic.errors import StudyError, shown
from haptonic.fields import remade
from haptonic.results.cost import BASE, Cost
from haptonic.results.guides import Guides, closing, compute_guides
from haptonic.results.runner import Runner
from haptonic.study.schema import Description

GUIDES = 2.0  # s, of the guides that are compared


@dataclass(frozen=True)
class WaveguideOptions:
    """What may be chosen."""

    mode: str | None = option(None, "Nodal lines across, intervals along; else the study's.", metavar="MxN")


def chosen_settings(study: Description, options: WaveguideOptions) -> WaveguideSettings:
    """What the study asks for, with the mode that was chosen.

    Raises
    ------
    HaptonicError : no carrier, rows that are none or too dear, ends that no rows close, or a mode that is not
        written like ``0x17``
    """
    need_carrier(study)
    need_rows(study, "waveguide")
    own = study.waveguide_settings
    if own.ends == "mirror":
        closing(Rows(study.cell, own.direction))
    if options.mode is None:
        return own
    try:
        return remade(own, mode=options.mode)
    except StudyError:
        raise StudyError.malformed(
            argument="--mode",
            given=shown(options.mode),
            allowed="nodal lines across, an x, and intervals between nodal lines along, such as 0x17",
            cause="it is not written like that",
            next_step="write it like 0x17",
        ) from None


def compute(study: Description, options: WaveguideOptions, runner: Runner) -> Guides:
    """Width, length and frequency of waveguides whose mode lies in the gap that holds the carrier.

    Raises
    ------
    StudyError : no carrier, no gap that holds it, or no such waveguide
    """
    found: Guides = compute_guides(
        study.cell,
        study.bands_settings,
        chosen_settings(study, options),
        carrier=need_carrier(study),
        inputs=study.inputs(),
        runner=runner,
    )
    return found


def cost(study: Description, options: WaveguideOptions) -> Cost:
    """Of the guides that are compared."""
    on_face, memory = need_rows(study, "waveguide")
    return gaps(study) + Cost(GUIDES * max(1.0, on_face / SQUARE_FACE) ** 2.5, BASE + memory)


ANALYSIS = Analysis(
    name="waveguide",
    result=Guides,
    compute=compute,
    cost=cost,
    reported=lambda study: WaveguideOptions() if has_mirror(study) else None,
    options=WaveguideOptions,
    check=chosen_settings,
)
