"""Bands, gaps and mode shapes of the unit cell."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from haptonic.analyses.analysis import Analysis
from haptonic.analyses.costs import gaps, meshes
from haptonic.analyses.needs import further_lattices
from haptonic.analyses.options import option
from haptonic.analyses.runner import Runner
from haptonic.analyses.support import every_cell
from haptonic.analyses.turning import BandsTurning
from haptonic.bloch import bands_dataset
from haptonic.bloch.gap_datasets import add_further_gaps
from haptonic.bloch.settings import BandSettings
from haptonic.bloch.wavevectors import wavevector_at
from haptonic.brillouin import IrreducibleZone
from haptonic.cell import UnitCell
from haptonic.fields import unchecked
from haptonic.later import xarray as xr
from haptonic.results.bands import Bands
from haptonic.results.common import stamped
from haptonic.results.cost import Cost
from haptonic.store import Store
from haptonic.study.schema import Description

DIAGRAM, PER_WAVEVECTOR = 1.5, 0.02  # s, of names, shapes and pictures; of ten bands
COUNTED = 1.2  # factor for the exact eigenvalue counts, which need meshes of their own; 1.09 to 1.17 measured
MOVING = 0.03  # s per wavevector, of ten bands, for their modes on the surface of the cell
SURFACE = 6.0  # s, for the whole zone


@dataclass(frozen=True)
class BandsOptions:
    """Options of the bands."""

    surface: bool = option(False, "Contours over the Brillouin zone and the density of states, too.")
    modes_at: str | None = option(
        None,
        'Wavevector of the mode shapes: a corner such as M, "0.3 X-M", or k·a1 and k·a2 in units of pi.',
        metavar="K",
    )
    html: bool = option(False, "Also one interactive HTML page, with every mode moving.")


def check(study: Description, options: BandsOptions) -> None:
    """Raise HaptonicError if ``modes_at`` names no wavevector of the zone, or the path has too few points."""
    study.cell.zone.path(study.bands_settings.points)
    if options.modes_at is not None:
        wavevector_at(study.cell.zone, options.modes_at, "--modes-at")


def compute(study: Description, options: BandsOptions, runner: Runner) -> Bands:
    """Band diagram, gaps and mode shapes; of further lattices of the plate the gaps.

    Raises
    ------
    ResourceError : the accuracy needs more memory than this machine has
    """
    bands = compute_bands(
        study.cell, study.bands_settings, surface=options.surface, inputs=study.inputs(),
        carrier=study.carrier, store=runner.store, modes_at=options.modes_at, moving=options.html,
        first=runner.first,
    )  # fmt: skip
    further = {
        name: runner.gaps(cell, study.bands_settings) for name, cell in further_lattices(study).items()
    }
    return Bands(add_further_gaps(bands.dataset, further))


def compute_bands(
    cell: UnitCell,
    settings: BandSettings,
    *,
    surface: bool,
    inputs: Mapping[str, Any],
    carrier: float | None,
    store: Store,
    modes_at: str | None = None,
    moving: bool = False,
    also: Sequence[float] = (),
    zone: IrreducibleZone | None = None,
    first: Callable[[xr.Dataset], object] | None = None,
) -> Bands:
    """Compute the bands of a cell, or take them from the store.

    Parameters
    ----------
    surface : also sample the whole zone evenly
    modes_at : wavevector of the mode shapes, see `haptonic.bloch.wavevectors`
    moving : also the surface of the cell in every mode of the diagram
    also : positions of further wavevectors on the path, see `IrreducibleZone.path`
    zone : see `bands_dataset`
    inputs : plain values of the inputs, for the attributes of the result
    carrier : Hz, marked in the diagram
    first : see `bands_dataset`
    """
    dataset = store.kept(
        {"kind": "bands", "surface": surface, "modes_at": modes_at, "moving": moving, "cell": cell,
         "settings": settings, "also": tuple(also), "zone": zone},
        lambda: bands_dataset(
            cell, settings, surface=surface, modes_at=modes_at, moving=moving, also=also, zone=zone,
            first=first,
        ),
    )  # fmt: skip
    if carrier is not None:
        dataset.attrs["carrier_hz"] = carrier
    return Bands(stamped(dataset, inputs))


def cost(study: Description, options: BandsOptions) -> Cost:
    """Estimated cost of meshes, diagram and zone."""
    per_wavevector = PER_WAVEVECTOR + (MOVING if options.html else 0.0)
    shown = DIAGRAM + per_wavevector * study.bands_settings.points + (SURFACE if options.surface else 0.0)
    total = meshes(study).times(COUNTED) + Cost(shown)
    for cell in further_lattices(study).values():
        total += gaps(unchecked(study, cell=cell))
    return total


ANALYSIS = Analysis(
    name="bands",
    result=Bands,
    compute=compute,
    supports=every_cell,
    cost=cost,
    check=check,
    reported=lambda study: BandsOptions(surface=True, html=True),
    options=BandsOptions,
    interactive="html",
    turning=BandsTurning,
)
