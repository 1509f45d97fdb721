"""What the response of a plate tells of its lattices: gap, range of high contrast, decay into a mirror."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from haptonic.errors import ResponseError, ScanError
from haptonic.later import xarray as xr
from haptonic.plate import Plate
from haptonic.plate.sampling import driven_region, tile_names
from haptonic.response import FrequencyResponse
from haptonic.vibrometry.guides import MIRROR, Mirror, mirror_beside, strips_of
from haptonic.vibrometry.maps import (
    LatticeGap,
    MeasuredGap,
    decay_along,
    gap_edges,
    lattice_decay,
    measured_gap,
)

# name of all points on lattices while the gap is looked for; longer than any name of a study
LATTICE = "the points on the lattices of the plate, all together"


def lattice_gap(response: FrequencyResponse, plate: Plate, data: xr.Dataset) -> LatticeGap:
    """Edges of the gap of a plate's lattice; how waves fade in it goes into the dataset."""
    driven = driven_region(plate)
    mirror = mirror_beside(plate.layout, driven) if driven else None
    if mirror is not None and not mirror.symmetric:
        reason = "what its rows reflect fades otherwise, for they are no images of themselves"
        return LatticeGap(None, None, (f"no edges of the gap: {reason}",))
    try:
        fades = decay_along(response, strips_of(plate.layout, mirror) if mirror else [])
    except (ScanError, ResponseError) as error:
        return LatticeGap(None, None, (f"no edges of the gap: {error.given}",))
    data["fading"] = fades
    return gap_edges(fades)


def contrast_range(response: FrequencyResponse, plate: Plate) -> MeasuredGap:
    """The range in which the driven region of a plate stands out from all its lattices.

    Raises
    ------
    ScanError : no driven region, or no such range
    ResponseError : no point in one of them
    """
    driven = driven_region(plate)
    if driven is None:
        raise ScanError.missing(
            argument="plate.actuator", given="no driven region", allowed="a drive on a region of plain plate",
            cause="the drive lies on the lattice", next_step="add a drive to a region",
        )  # fmt: skip
    layout = plate.layout
    names = [LATTICE if name in layout.cells else name or "" for name in tile_names(layout, response.points)]
    return measured_gap(_named(response, names), driven, LATTICE)


def decay_in(response: FrequencyResponse, mirror: Mirror) -> xr.Dataset:
    """Decay of a response through a mirror; see `haptonic.vibrometry.lattice_decay`."""
    inside = mirror.area.holds(response.points)
    named = _named(response, [MIRROR if one else "" for one in inside])
    return lattice_decay(
        named, MIRROR, depth=mirror.depth, start=mirror.start, pitch=mirror.pitch, inwards=mirror.inwards
    )


def _named(response: FrequencyResponse, names: Sequence[str]) -> FrequencyResponse:
    return FrequencyResponse(response.dataset.assign_coords(region=("point", np.array(names, dtype=str))))
