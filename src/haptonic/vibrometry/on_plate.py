"""Measures of a plate's response by region and lattice: levels, waves, gap, decay into a mirror."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from haptonic.errors import HaptonicError, ResponseError, ScanError
from haptonic.gate import WORD
from haptonic.later import xarray as xr
from haptonic.plate import Plate
from haptonic.plate.layout.grid import Layout
from haptonic.plate.layout.sampling import driven_region, tile_names
from haptonic.plate.vibration.region_measures import compared
from haptonic.response import FrequencyResponse
from haptonic.response.measures import along, sides
from haptonic.vibrometry.guides import MIRROR, Mirror, guides_of, mirror_beside, strips_of
from haptonic.vibrometry.maps import (
    LatticeGap,
    MeasuredGap,
    clean_contrast,
    clean_rms,
    decay_along,
    gap_edges,
    lattice_decay,
    measured_gap,
    wavenumber_map,
)

# name of all points on lattices during the search for the gap; longer than any name in a study
LATTICE = "the points on the lattices of the plate, all together"


def region_levels(response: FrequencyResponse, driven: str | None) -> tuple[xr.Dataset, list[str]]:
    """``rms`` (region) and, for a driven region, ``contrast`` (pair) with its ``error_of_contrast``, each
    without noise; and sentences on values hidden by noise."""
    data, hides = xr.Dataset(), list[str]()
    named = {name: clean_rms(response, name) for name in response.regions if name}
    if named:
        data["rms"] = along(named, "region")
    levels = {
        pair: clean_contrast(response, *sides(response, *names))
        for pair, names in compared(response, driven).items()
    }
    if levels:
        data["contrast"] = along({pair: level["level"] for pair, level in levels.items()}, "pair")
        data["error_of_contrast"] = along({pair: level["error"] for pair, level in levels.items()}, "pair")
    for pair, level in levels.items():
        if hidden := int(np.isnan(level["level"].values).sum()):
            hides.append(
                f"noise hides the contrast {pair} at {hidden} of {level.sizes['frequency']} frequencies"
            )
    return data, hides


def guide_waves(response: FrequencyResponse, layout: Layout) -> tuple[xr.Dataset, list[str]]:
    """``waves`` (guide, frequency, step) with their ``wavenumber``; and reasons for guides without waves."""
    waves, reasons = dict[str, xr.DataArray](), list[str]()
    for guide in guides_of(layout):
        if guide.region not in response.regions:
            reasons.append(f"no waves along {guide.region}: no point of the scan lies there")
            continue
        try:
            waves[guide.region] = wavenumber_map(response, guide.region, guide.along)
        except HaptonicError as error:
            reasons.append(f"no waves along {guide.region}: {reason_of(error)}")
    return _by_guide(waves) if waves else xr.Dataset(), reasons


def reason_of(error: HaptonicError) -> str:
    """Why a result is missing, in a few words."""
    if error.argument == "region" and error.code == "unknown":
        return f"no point of the scan lies in {error.given}"
    return f"{error.given}; {error.cause}"


def _by_guide(waves: Mapping[str, xr.DataArray]) -> xr.Dataset:
    """Waves of all guides in one dataset; a guide has as many wavenumbers as points, then NaN."""
    longest = max(wave.sizes["wavenumber"] for wave in waves.values())
    lines = next(iter(waves.values()))["frequency"]
    amplitude = np.full((len(waves), len(lines), longest), np.nan)
    wavenumber = np.full((len(waves), longest), np.nan)
    for row, wave in enumerate(waves.values()):
        amplitude[row, :, : wave.sizes["wavenumber"]] = wave.values
        wavenumber[row, : wave.sizes["wavenumber"]] = wave["wavenumber"].values
    first = next(iter(waves.values()))
    shorter = {WORD: "a shorter guide has fewer wavenumbers"}
    return xr.Dataset(
        {"waves": (("guide", "frequency", "step"), amplitude, {"units": first.attrs["units"], **shorter})},
        coords={
            "guide": np.array(list(waves), dtype=str),
            "frequency": lines,
            "wavenumber": (("guide", "step"), wavenumber, {"units": "rad/m", **shorter}),
        },
    )


def lattice_gap(response: FrequencyResponse, plate: Plate, data: xr.Dataset) -> LatticeGap:
    """Edges of the gap of a plate's lattice; the decay of waves in it is added to the dataset."""
    driven = driven_region(plate)
    mirror = mirror_beside(plate.layout, driven) if driven else None
    if mirror is not None and not mirror.symmetric:
        reason = "its rows are not their own mirror images, so reflected waves decay differently"
        return LatticeGap(None, None, (f"no edges of the gap: {reason}",))
    try:
        decay = decay_along(response, strips_of(plate.layout, mirror) if mirror else [])
    except (ScanError, ResponseError) as error:
        return LatticeGap(None, None, (f"no edges of the gap: {reason_of(error)}",))
    data["row_decay"] = decay
    assert mirror is not None
    if mirror.repeat > 1:
        # two plates of eight rows would give lower edges of 54.3 and 56.5 kHz, against the computed 52.4 kHz
        reason = "its rows are offset, and no single wave describes the decay near an edge"
        return LatticeGap(None, None, (f"no edges of the gap: {reason}",))
    return gap_edges(decay, mirror.pitch / mirror.spacing)


def contrast_range(response: FrequencyResponse, plate: Plate) -> MeasuredGap:
    """The range in which the level of the driven region exceeds that of all lattices.

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
    named = _named(response, [MIRROR if is_inside else "" for is_inside in inside])
    return lattice_decay(
        named, MIRROR, depth=mirror.depth, start=mirror.start, pitch=mirror.pitch, inwards=mirror.inwards
    )


def _named(response: FrequencyResponse, names: Sequence[str]) -> FrequencyResponse:
    return FrequencyResponse(response.dataset.assign_coords(region=("point", np.array(names, dtype=str))))
