"""Waves along a ribbon: cells side by side in one direction, repeated along the other."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

import numpy as np

from haptonic.analyses.analysis import Analysis
from haptonic.analyses.costs import meshes
from haptonic.analyses.options import PageOption
from haptonic.analyses.runner import Runner
from haptonic.analyses.support import every_cell
from haptonic.arrays import Array
from haptonic.bloch.candidates import BestModel, best_model
from haptonic.bloch.gaps import gap_at, widest_gap
from haptonic.bloch.ribbon import RibbonModel, bulk_bands
from haptonic.bloch.ribbon_datasets import bulk_dataset, field_dataset, ribbon_dataset
from haptonic.bloch.ribbon_fields import fields_dataset
from haptonic.bloch.settings import HIGHEST, LOWEST, BandSettings
from haptonic.cell import UnitCell
from haptonic.cell.scales import scales
from haptonic.errors import StudyError
from haptonic.later import xarray as xr
from haptonic.parallel import one_thread
from haptonic.results.common import stamped
from haptonic.results.cost import Cost
from haptonic.results.ribbon import RibbonWaves
from haptonic.study.ribbon_tables import RibbonSettings
from haptonic.study.schema import Description
from haptonic.units import format_quantity

BESIDE = 0.15  # search range on either side of a gap, relative to its width
COLUMN = 0.17  # s per column of a ribbon with one tile and wavevector
BULK = 0.2  # s per wavevector of a crystal
COARSER = "a smaller accuracy in [bands] refines it"


def _need_ribbon(study: Description) -> RibbonSettings:
    if study.ribbon_settings is None:
        raise StudyError.missing(
            argument="ribbon",
            allowed="a [ribbon] table with map and tiles",
            cause="the study does not give the cells of the ribbon",
            next_step='add map = "ooooo1111ooooo" to [ribbon], and o = "lattice" and 1 = "guide" to '
            "[ribbon.tiles]",
        )
    return study.ribbon_settings


def check(study: Description, options: PageOption) -> None:
    """Raise StudyError if the study has no ribbon."""
    _need_ribbon(study)


@one_thread()
def compute(study: Description, options: PageOption, runner: Runner) -> RibbonWaves:
    """Projected bands, and the modes of a guide, an edge or a strip.

    With a length in cells, the wavevectors are those of its resonances; a free end adds a quarter of an
    interval to the phase.

    Raises
    ------
    StudyError : no ribbon, or no range of frequencies
    """
    asked, settings = _need_ribbon(study), study.bands_settings
    ribbon, rows = asked.ribbon(study.cell), asked.rows
    crystals = ribbon.crystals
    bests = [best_model(cell, settings) for cell in crystals or ribbon.first[:1]]
    models = [best.model for best in bests]
    resolution = max(
        (model.resolution for model in models), key=lambda mesh: (mesh.order, mesh.foot_rings, mesh.steps)
    )
    low, high = _range(study, crystals, runner)
    kappa = (np.arange(rows) + 0.5) * np.pi / rows if rows else np.linspace(0.0, np.pi, asked.wavevectors)
    runner.progress(0, len(kappa), "wavevectors")
    bulk = np.empty((0, len(kappa), 0, 2))
    if ribbon.has_bulk:
        bulk = np.array([bulk_bands(crystal, ribbon, [float(k) for k in kappa]) for crystal in models])
    model = RibbonModel.of(ribbon, resolution)
    waves = []
    for done, phase in enumerate(kappa):
        runner.progress(done, len(kappa), "wavevectors")
        waves.append(model.solve(float(phase), low, high))
    runner.progress(len(kappa), len(kappa), "wavevectors")
    dataset = ribbon_dataset(model, waves, bulk, rows)
    dataset = dataset.merge(bulk_dataset(kappa, bulk, asked.names))
    dataset.attrs = {
        "range_hz": [low, high],
        "rows": rows or 0,
        "period": ribbon.period,
        **scales(study.cell),
        "kind": ribbon.kind,
        "loss_factor": list(ribbon.first[0].loss_factors),
        "unknowns": len(model.fine.order),
        "mesh": json.dumps([resolution.order, resolution.foot_rings]),
        **accuracy_of(dataset, bulk, bests, settings),
    } | ({"carrier_hz": study.carrier} if study.carrier is not None else {})
    if options.html:
        dataset = dataset.merge(fields_dataset(model, waves))
    result = RibbonWaves(dataset)
    best = result.best
    if best is not None:
        dataset = dataset.merge(field_dataset(model, best, waves))
    return RibbonWaves(stamped(dataset.assign_attrs(result.dataset.attrs), study.inputs()))


def accuracy_of(
    modes: xr.Dataset, bulk: Array, bests: Sequence[BestModel], settings: BandSettings
) -> dict[str, Any]:
    """Attributes on the accuracy of the modes and, if there are bulk bands, of the models that give these."""
    worst = max(bests, key=lambda best: best.model.worst_error)
    largest = float((modes["frequency_error"] / modes["frequency"]).max()) if modes.sizes["mode"] else 0.0
    return worst.attributes(
        settings, max(largest, worst.model.worst_error if bulk.size else 0.0), ("ribbon", COARSER)
    )


def _range(study: Description, crystals: Sequence[UnitCell], runner: Runner) -> tuple[float, float]:
    """Range of frequencies, Hz: as given, otherwise around the gap of the first crystal or the carrier."""
    asked, carrier = _need_ribbon(study), study.carrier
    low, high = asked.lowest, asked.highest
    if low is None or high is None:
        gaps = runner.gaps(crystals[0], study.bands_settings) if crystals else ()
        gap = (gap_at(gaps, carrier) if carrier else None) or widest_gap(gaps)
        if gap is not None:
            ends = gap.lower - BESIDE * gap.width, gap.upper + BESIDE * gap.width
        elif carrier is not None:
            ends = LOWEST * carrier, HIGHEST * carrier
        else:
            raise StudyError.missing(
                argument="ribbon.lowest",
                allowed="the range of frequencies in which modes are sought",
                cause="the lattice has no complete gap and the study no carrier to search around",
                next_step='add lowest = "40 kHz" and highest = "70 kHz" to [ribbon]',
            )
        low, high = low or ends[0], high or ends[1]
    if low >= high:
        raise StudyError.conflict(
            argument="ribbon.lowest",
            given=format_quantity(low, "Hz"),
            allowed=f"less than the highest frequency, {format_quantity(high, 'Hz')}",
            cause="only one end of the range was given, and it lies beyond the default of the other",
            next_step="give both ribbon.lowest and ribbon.highest",
        )
    return low, high


def cost(study: Description, options: PageOption) -> Cost:
    """Estimated cost of the modes of a ribbon at each wavevector, and of the bulk bands of its crystals."""
    section = _need_ribbon(study)
    ribbon = section.ribbon(study.cell)
    tiles = max(len(cell.tiles) for cell in ribbon.cells) * len(ribbon.lines)
    each = Cost(COLUMN * tiles**2 * len(ribbon.first) + BULK * len(ribbon.crystals) * len(ribbon.lines))
    return meshes(study).times(max(1, len(ribbon.cells))) + each.times(section.rows or section.wavevectors)


ANALYSIS = Analysis(
    name="ribbon",
    result=RibbonWaves,
    options=PageOption,
    interactive="html",
    compute=compute,
    supports=every_cell,
    cost=cost,
    check=check,
    reported=lambda study: PageOption(html=True) if study.ribbon_settings else None,
)
