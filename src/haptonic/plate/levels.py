"""Evaluation of a response by region: contrasts, amplitudes below a finger, lines of the maps."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import AnyComplex, Array
from haptonic.later import xarray as xr
from haptonic.plate.parts import Plate
from haptonic.plate.sampling import driven_region, loudest_within, points_of
from haptonic.response import FrequencyResponse, contrast, disc_average
from haptonic.response.checks import REST, THE_REST

FINGER = 10e-3  # m, width of the disc over which a finger averages
BELOW, ABOVE = 0.76, 1.25  # of the gap's edges, for the maps below and above it


def contrasts(response: FrequencyResponse, driven: str | None) -> dict[str, xr.DataArray]:
    """Contrast of a region against others and against all the rest, dB."""
    return {pair: contrast(response, *names) for pair, names in compared(response, driven).items()}


def compared(response: FrequencyResponse, driven: str | None) -> dict[str, tuple[str, str]]:
    """Pairs of regions compared with a driven region, by title; names as for `contrast`."""
    if driven is None or driven not in response.regions:
        return {}
    others = {name: name for name in response.regions if name != driven}
    if not response.inside(driven).all():
        others[THE_REST] = REST
    return {f"{driven} over {text}": (driven, name) for text, name in others.items()}


def below_finger(response: FrequencyResponse) -> dict[str, xr.DataArray]:
    """Amplitude below a finger where it is largest in each region, per unit of the reference."""
    moved = response.displacement()
    amplitude = disc_average(moved, FINGER)
    return {
        name: amplitude[:, response.inside(name)].max("point").assign_attrs(units=moved.units)
        for name in response.regions if name
    }  # fmt: skip


def marked_lines(
    plate: Plate,
    every: Array,
    velocity: AnyComplex,
    regions: list[str],
    carrier: float,
    gap: Sequence[float] | None,
) -> NDArray[np.int64]:
    """Lines of the maps: below, in and above the gap; in it where the driven region resonates most."""
    if gap is None:
        return np.array([int(np.abs(every - carrier).argmin())])
    there = points_of(regions, driven_region(plate))
    marked = []
    if every[0] <= BELOW * gap[0]:
        marked.append(int(np.abs(every - BELOW * gap[0]).argmin()))
    if ((every > gap[0]) & (every < gap[1])).any():
        marked.append(loudest_within(every, velocity, there, gap, carrier))
    if every[-1] >= ABOVE * gap[1]:
        marked.append(int(np.abs(every - ABOVE * gap[1]).argmin()))
    return np.array(marked or [int(np.abs(every - carrier).argmin())])
