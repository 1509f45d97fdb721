"""Width, length and frequency of waveguides between two mirrors."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass

import numpy as np

from haptonic.analyses.analysis import Analysis
from haptonic.analyses.costs import gaps
from haptonic.analyses.layers import SQUARE_FACE
from haptonic.analyses.needs import has_mirror, need_carrier, need_rows
from haptonic.analyses.options import PageOption, option
from haptonic.analyses.runner import Runner
from haptonic.analyses.support import every_cell
from haptonic.bloch.candidates import best_model
from haptonic.bloch.gaps import need_gap_at
from haptonic.bloch.guide_fields import guides_dataset
from haptonic.bloch.layers import plain_plate
from haptonic.bloch.mirrors import condensed_rows, opposite_rows
from haptonic.bloch.plate_waves import mirror_across
from haptonic.bloch.settings import WaveguideSettings
from haptonic.bloch.waveguides import closing, strip_of, strips_dataset
from haptonic.cell import Rows
from haptonic.cell.scales import scales
from haptonic.errors import StudyError, shown
from haptonic.fields import remade
from haptonic.materials import is_symmetry
from haptonic.parallel import one_thread
from haptonic.results.common import stamped
from haptonic.results.cost import BASE, Cost
from haptonic.results.guides import Guides
from haptonic.study.schema import Description

MOST_LENGTHS = 6  # number of compared lengths of waveguides
GUIDES = 2.0  # s, for the compared waveguides


@dataclass(frozen=True)
class WaveguideOptions(PageOption):
    """Options of the waveguide."""

    mode: str | None = option(
        None, "Nodal lines across, intervals along; by default the study's.", metavar="MxN"
    )


def chosen_settings(study: Description, options: WaveguideOptions) -> WaveguideSettings:
    """Settings of the study, with the mode of the options.

    Raises
    ------
    HaptonicError : no carrier, rows in an impossible or too expensive direction, ends that no rows close, or
        a mode that is not written like ``0x17``
    """
    need_carrier(study)
    need_rows(study, "waveguide")
    settings = study.waveguide_settings
    rows = Rows(study.cell, settings.direction)
    if settings.ends == "mirror":
        closing(rows)
    _need_equal_sides(rows, settings)
    if options.mode is None:
        return settings
    try:
        return remade(settings, mode=options.mode)
    except StudyError:
        raise StudyError.malformed(
            argument="--mode",
            given=shown(options.mode),
            allowed="nodal lines across, an x, and intervals between nodal lines along, such as 0x17",
            cause="the text has another form",
            next_step="write the mode like 0x17",
        ) from None


def _need_equal_sides(rows: Rows, settings: WaveguideSettings) -> None:
    """Refuse a plate and ends whose two sides differ."""
    cell, (across, along) = rows.cell, rows.turn
    if not is_symmetry(cell.material.stiffness, mirror_across(across)):
        raise StudyError.unsupported(
            argument="material.turn",
            given=f"a plate of {cell.material.name}",
            allowed="a plate in which the direction across the strip is an axis of symmetry",
            cause="waves to both sides of this strip differ; its modes are computed from equal ones",
            next_step="turn the crystal, or compute the strip as a ribbon: `haptonic ribbon`",
        )
    if settings.ends == "mirror" and not rows.is_reversible(along):
        raise StudyError.unsupported(
            argument="waveguide.ends",
            given="mirror",
            allowed="a cell that a mirror or a half turn reverses along the strip, or free ends",
            cause="the crystals at the two ends reflect waves with different phases",
            next_step='write ends = "free", or another direction along',
        )


@one_thread()
def compute(study: Description, options: WaveguideOptions, runner: Runner) -> Guides:
    """Width, length and frequency of waveguides whose mode lies in the gap that contains the carrier.

    Raises
    ------
    StudyError : no carrier, no gap that contains it, or no such waveguide
    """
    cell, settings, carrier = study.cell, study.bands_settings, need_carrier(study)
    waveguide = chosen_settings(study, options)
    gap = need_gap_at(runner.gaps(cell, settings), carrier)
    best = best_model(cell, settings)
    resolution, share = best.model.resolution, best.model.worst_error
    lattice = condensed_rows(cell, resolution, waveguide.direction)
    opposite = opposite_rows(cell, resolution, waveguide.direction)
    closed_by = None
    if waveguide.ends == "mirror":
        closed_by = condensed_rows(cell, resolution, closing(lattice.rows))
    across, along = waveguide.nodal_lines
    period = lattice.rows.period
    wavenumber = plain_plate(lattice).wavenumber(2 * np.pi * carrier, 0.0, "A0")
    assert wavenumber is not None
    shortest = max(1, int((along + 0.5) * np.pi / (wavenumber * period)))
    lengths = [waveguide.rows] if waveguide.rows else range(shortest, shortest + MOST_LENGTHS + 1)
    strips, refusal = [], None
    for count in lengths:
        try:
            strips.append(strip_of(lattice, gap, carrier, waveguide, count, closed_by, share, opposite))
        except StudyError as error:
            refusal = error
    if not strips:
        assert refusal is not None
        if refusal.argument == "layers.angle":  # the waves of the mode are too short for the mesh
            raise refusal.changed(
                StudyError, argument="--mode" if options.mode else "waveguide.mode",
                next_step="choose fewer intervals along, or a longer waveguide",
            )  # fmt: skip
        raise refusal
    dataset = strips_dataset(strips)
    if options.html and opposite is None:
        dataset = dataset.merge(guides_dataset(lattice, [strip.mode for strip in strips]))
    dataset.attrs = {
        "carrier_hz": carrier,
        "relative_frequency_error": share,
        "mode": f"{across}x{along}",
        "ends": waveguide.ends,
        "period": period,
        "equal_sides": int(opposite is None),
        "gap": list(gap.edges),
        "mesh": json.dumps(asdict(lattice.plan)),
        **scales(cell),
        **best.attributes(settings, share),
    }
    return Guides(
        carrier=carrier,
        gap=gap,
        across=across,
        along=along,
        ends=waveguide.ends,
        strips=tuple(strips),
        dataset=stamped(dataset, study.inputs()),
    )


def cost(study: Description, options: WaveguideOptions) -> Cost:
    """Estimated cost of the compared waveguides."""
    on_face, memory = need_rows(study, "waveguide")
    return gaps(study) + Cost(GUIDES * max(1.0, on_face / SQUARE_FACE) ** 2.5, BASE + memory)


ANALYSIS = Analysis(
    name="waveguide",
    result=Guides,
    compute=compute,
    supports=every_cell,
    cost=cost,
    reported=lambda study: WaveguideOptions(html=True) if has_mirror(study) else None,
    interactive="html",
    options=WaveguideOptions,
    check=chosen_settings,
)
