"""Insertion loss of rows of cells between two plain plates, and decay of waves in the lattice."""

from __future__ import annotations

import json
from dataclasses import asdict, replace

import numpy as np

from haptonic.analyses.analysis import KEPT, Analysis
from haptonic.analyses.costs import gaps
from haptonic.analyses.needs import has_mirror, need_carrier, need_rows
from haptonic.analyses.options import PageOption
from haptonic.analyses.runner import Runner
from haptonic.analyses.support import one_loss_factor
from haptonic.arrays import Array
from haptonic.bloch import Resolution
from haptonic.bloch.candidates import best_model
from haptonic.bloch.evanescent import bloch_waves
from haptonic.bloch.gaps import gap_at, widest_gap
from haptonic.bloch.mirrors import (
    MOST_ROWS,
    Incidence,
    at_carrier,
    carrier_dataset,
    condensed_rows,
    error_if_moved,
    loss_at_carrier,
    mirror_dataset,
    scattering_at,
)
from haptonic.cell import UnitCell
from haptonic.cell.scales import scales
from haptonic.errors import StudyError
from haptonic.jobs import Task
from haptonic.later import xarray as xr
from haptonic.parallel import one_thread
from haptonic.results.common import stamped
from haptonic.results.cost import BASE, Cost
from haptonic.results.layers import Layers
from haptonic.study.schema import Description

CHUNK = 12  # frequencies of one task
MIRROR, SQUARE_FACE = 0.035, 72  # s per row and frequency, for this number of unknowns on a face


def check(study: Description, options: PageOption) -> None:
    """Refuse a study without a carrier, and rows in an impossible or too expensive direction."""
    need_carrier(study)
    need_rows(study)


@one_thread()
def compute(study: Description, options: PageOption, runner: Runner) -> Layers:
    """Spectra of a mirror in chunks of frequencies, and the number of rows that it needs at the carrier.

    Raises
    ------
    StudyError : no carrier, ends of the spectrum in the wrong order, a cell without a pillar, or no wave
        that propagates towards the rows at the carrier
    """
    cell, settings, layers = study.cell, study.bands_settings, study.layers_settings
    carrier = need_carrier(study)
    if not cell.has_features:
        raise StudyError.missing(
            argument="cell.pillar",
            allowed="a cell with a pillar or discs",
            cause="rows of plain plate between two plain plates reflect nothing",
            next_step="add a [cell.pillar] table, or [[cell.disc]] tables",
        )
    frequencies = layers.frequencies(carrier)
    incidence = Incidence(layers.angle, layers.count, cell.material.loss_factor)
    gaps = runner.gaps(cell, settings)
    gap = gap_at(gaps, carrier) or widest_gap(gaps)
    best = best_model(cell, settings)
    resolution = best.model.resolution
    chunks = np.array_split(frequencies, -(-len(frequencies) // CHUNK))
    along = layers.direction
    fixed = {"incidence": incidence, "cell": cell, "resolution": resolution, "along": along}
    fixed |= {"fields": True} if options.html else {}
    tasks = [
        Task(
            {"kind": "mirror", "frequency": chunk, **fixed},
            (cell, resolution, along, chunk, incidence, options.html),
        )
        for chunk in chunks
    ]
    pieces = runner.run(spectra, tasks, 1)
    spectrum = xr.concat(pieces, "frequency", data_vars="minimal", coords="minimal")
    rows = condensed_rows(cell, resolution, along)
    transmission = at_carrier(rows, carrier, incidence)
    lossless = at_carrier(rows, carrier, replace(incidence, loss_factor=0.0))
    share, slab = best.model.worst_error, rows.slab(0.0)
    # that the lattice's frequencies move by their error is as if the carrier moved the other way
    moved, many = [carrier * (1 + by) for by in (-share, share)], replace(incidence, layers=MOST_ROWS)
    around = [carrier_dataset(s) for s in (transmission, *(scattering_at(rows, at, many) for at in moved))]
    decay, *decays = (
        rows.decay(bloch_waves(slab.at(omega), omega)[0]) for omega in 2 * np.pi * np.array([carrier, *moved])
    )
    dataset = spectrum.merge(around[0])
    loss, *losses = (loss_at_carrier(each) for each in around)
    dataset["carrier_loss_error"] = loss.copy(data=error_if_moved(loss.values, losses, share))
    dataset.attrs = {
        "carrier_hz": carrier,
        "relative_frequency_error": share,
        "carrier_attenuation_db": decay,
        "carrier_attenuation_error_db": float(error_if_moved(np.array(decay), decays, share)),
        "energy_balance": max(float(np.abs(result.dissipated).max()) for result in lossless.values()),
        "angle": incidence.angle,
        "along": list(along),
        "loss_factor": incidence.loss_factor,
        "gap": list(gap.edges) if gap else [],
        "mesh": json.dumps(asdict(rows.plan)),
        **scales(cell),
        **best.attributes(settings, share),
    }
    return Layers(gap, stamped(dataset, study.inputs()), interactive=options.html)


def spectra(
    argument: tuple[UnitCell, Resolution, tuple[int, int], Array, Incidence, bool],
) -> xr.Dataset:
    """Spectra at a few frequencies; the function of a worker."""
    cell, resolution, along, frequency, incidence, fields = argument
    return mirror_dataset(condensed_rows(cell, resolution, along), frequency, incidence, fields)


def cost(study: Description, options: PageOption) -> Cost:
    """Estimated cost of the spectra of a mirror."""
    settings = study.layers_settings
    on_face, memory = need_rows(study)
    each = MIRROR * (on_face / SQUARE_FACE) ** 2.5
    return gaps(study) + Cost(each * (settings.count * settings.points + MOST_ROWS), BASE + memory)


ANALYSIS = Analysis(
    name="layers",
    result=Layers,
    compute=compute,
    supports=one_loss_factor,
    options=PageOption,
    cost=cost,
    check=check,
    reported=lambda study: PageOption(html=True) if has_mirror(study) else None,
    parallel=True,
    interactive="html",
    kept=KEPT,
)
