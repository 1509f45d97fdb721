"""Evaluation of a response by region: contrasts, amplitudes below a finger, lines of the maps, resonances."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import AnyComplex, Array, Bools
from haptonic.later import xarray as xr
from haptonic.plate.layout.parts import Plate
from haptonic.plate.layout.sampling import driven_region, points_of
from haptonic.response import FrequencyResponse, contrast, disc_average
from haptonic.response.checks import REST, THE_REST

NEAR = 0.06  # share of a frequency; range for the list of modes and the search for a resonance
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
    """Lines of the maps: below, in and above the gap, each where the driven region vibrates most nearby."""
    if gap is None:
        return np.array([int(np.abs(every - carrier).argmin())])
    there = points_of(regions, driven_region(plate))
    marked = []
    if every[0] <= BELOW * gap[0]:
        marked.append(loudest_within(every, velocity, there, (0.0, gap[0]), BELOW * gap[0]))
    if ((every > gap[0]) & (every < gap[1])).any():
        marked.append(loudest_within(every, velocity, there, gap, carrier))
    if every[-1] >= ABOVE * gap[1]:
        marked.append(loudest_within(every, velocity, there, (gap[1], np.inf), ABOVE * gap[1]))
    return np.array(marked or [int(np.abs(every - carrier).argmin())])


def loudest_within(
    frequency: Array, velocity: AnyComplex, there: Bools, limits: Sequence[float], centre: float
) -> int:
    """Number of the line in a range and near a frequency with the largest vibration of given points.

    velocity : (points, lines); there : (points,) True for these points; the nearest line if none is near
    """
    inside = np.flatnonzero((frequency > limits[0]) & (frequency < limits[1]))
    away = np.abs(frequency[inside] / centre - 1)
    if not (away < NEAR).any():
        return int(inside[away.argmin()])
    loudness = (np.abs(velocity[there][:, inside]) ** 2).mean(axis=0)
    return int(inside[np.where(away < NEAR, loudness, -1.0).argmax()])


def resonance_of(marked: Array, carrier: float, gap: Sequence[float] | None) -> float:
    """Frequency of the map in the gap, or without one of the map nearest to the carrier, Hz."""
    low, high = gap or (0.0, np.inf)
    inside = marked[(marked > low) & (marked < high)]
    return float(min(inside if len(inside) else marked, key=lambda f: abs(f - carrier)))
