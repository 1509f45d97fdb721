"""Measured gap: the range in which the lattice is quiet and the driven region is not."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array, Bools
from haptonic.errors import ScanError
from haptonic.later import xarray as xr
from haptonic.response import FrequencyResponse
from haptonic.response.measures import power_contrast, squares
from haptonic.units import Hertz, In

LEAST_STEP = 6.0  # dB, smallest rise of the contrast that counts as a gap
LINES = 256  # that are converted to double precision at a time
QUARTERS = (0.25, 0.75)  # of the step: ends of the edge's transition


@dataclass(frozen=True)
class MeasuredGap:
    """Edges of a gap, Hz, and their accuracy.

    lower, upper : frequencies at which the contrast is midway between its levels outside and inside
    lower_error, upper_error : standard errors: scatter over the points (bootstrap), spacing of the lines, and
        the width of the transition
    lower_transition, upper_transition : widths in which the contrast rises from 25 to 75 % of its step
    outside, inside : levels of the contrast, dB
    """

    lower: Hertz
    upper: Hertz
    lower_error: Hertz
    upper_error: Hertz
    lower_transition: Hertz
    upper_transition: Hertz
    outside: Annotated[float, In("dB")]
    inside: Annotated[float, In("dB")]


def measured_gap(
    response: FrequencyResponse,
    over: str,
    lattice: str,
    *,
    smoothing: float = 1e3,
    resamples: int = 200,
    seed: int = 0,
) -> MeasuredGap:
    """Find the widest range in which a region vibrates much more than the lattice.

    Single resonances make the contrast rough, so energies are averaged over ``smoothing`` first. The level
    inside is the 90th percentile of the contrast, the level outside its 25th percentile: a gap that fills
    more than three quarters of the lines, or less than a tenth, is not found.

    Parameters
    ----------
    over, lattice : names of regions
    smoothing : width of the average over frequency, Hz
    resamples : number of resamples of the points, for the scatter
    seed : seed of the resampling

    Raises
    ------
    ScanError : the contrast rises by less than 6 dB
    ResponseError : no point in one of the regions
    """
    lines = response.frequency
    if not (np.isfinite(smoothing) and smoothing >= 0 and len(lines) >= 8 and resamples >= 2):
        raise ScanError.out_of_range(
            argument="measured_gap",
            given=f"smoothing {smoothing:g} Hz, {len(lines)} lines, {resamples} resamples",
            allowed="a smoothing of zero or more, at least eight lines and two resamples",
            cause="the response was cut to a few lines",
            next_step="give the response over the whole range, gap and surroundings",
        )
    ends = lines - smoothing / 2, lines + smoothing / 2
    energies = [
        window_means(lines, _energy(response, response.inside(name)), *ends) for name in (over, lattice)
    ]
    above, below = energies
    level = _contrast(above.mean(axis=1), below.mean(axis=1))
    outside, inside = (float(np.percentile(level, share)) for share in (25, 90))
    if inside - outside < LEAST_STEP:
        raise ScanError.no_answer(
            argument="measured_gap",
            given=f"a contrast of {over} over {lattice} between {outside:.3g} and {inside:.3g} dB",
            allowed=f"one that rises by {LEAST_STEP:g} dB or more",
            cause="the gap lies outside of the measured range or fills it, the lattice has few rows, or "
            "noise hides its low level",
            next_step="look at the contrast against frequency; measure a wider range, with more averages",
        )
    edges = _edges(lines, level, outside, inside, 0.5)
    wide, narrow = (_edges(lines, level, outside, inside, share) for share in QUARTERS)
    transition = [max(0.0, narrow[0] - wide[0]), max(0.0, wide[1] - narrow[1])]
    chance = np.random.default_rng(seed)
    above, below = (energy @ _drawn(energy.shape[1], resamples, chance) for energy in energies)
    drawn = [
        _edges(lines, _contrast(above[:, i], below[:, i]), outside, inside, 0.5) for i in range(resamples)
    ]
    scatter = np.std(np.array(drawn), axis=0)
    spacing = float(np.median(np.diff(lines)))
    error = [
        float(np.sqrt(s**2 + spacing**2 / 12 + t**2 / 12)) for s, t in zip(scatter, transition, strict=True)
    ]
    return MeasuredGap(
        lower=edges[0], upper=edges[1], lower_error=error[0], upper_error=error[1],
        lower_transition=transition[0], upper_transition=transition[1], outside=outside, inside=inside,
    )  # fmt: skip


def region_statistics(response: FrequencyResponse, low: float, high: float) -> xr.Dataset:
    """Root mean square, mean and largest amplitude of each region over a band, and its number of points.

    Raises
    ------
    ResponseError : no line in the band
    ScanError : no regions
    """
    part = response.between(low, high)
    if not part.regions:
        raise ScanError.missing(
            argument="region",
            given="points without regions",
            allowed="points that lie in named regions",
            cause="the scan was not registered to the plate",
            next_step="register it first: register_by_corners(...).registered(response, regions)",
        )
    amplitude = np.linalg.norm(part.values.astype(np.complex128), axis=2)
    of_point = np.sqrt((amplitude**2).mean(axis=0))
    masks = {name: part.inside(name) for name in part.regions}
    unit = {"units": part.units}
    rows = {
        "rms": [float(np.sqrt((of_point[m] ** 2).mean())) for m in masks.values()],
        "mean": [float(of_point[m].mean()) for m in masks.values()],
        "largest": [float(of_point[m].max()) for m in masks.values()],
    }
    columns = {name: ("region", np.array(values), unit) for name, values in rows.items()}
    counts = ("region", np.array([int(m.sum()) for m in masks.values()]))
    return xr.Dataset(
        columns | {"points": counts}, coords={"region": list(masks)}, attrs={"band": [low, high]}
    )


def _contrast(above: Array, below: Array) -> Array:
    """Contrast, finite even where a level is zero, so that percentiles exist."""
    tiny = np.finfo(float).tiny
    return power_contrast(np.maximum(above, tiny), np.maximum(below, tiny))


def _energy(response: FrequencyResponse, mask: Bools) -> Array:
    """(line, point) squared amplitude at some points, a few lines at a time."""
    values = response.values
    return np.concatenate([squares(values[i : i + LINES, mask]) for i in range(0, len(values), LINES)])


def _drawn(points: int, resamples: int, chance: np.random.Generator) -> Array:
    """(point, resample) weights of points drawn with replacement, as many as there are."""
    counts = [np.bincount(chance.integers(0, points, points), minlength=points) for _ in range(resamples)]
    return np.array(counts, dtype=float).T / points


def window_means(lines: Array, values: NDArray[Any], low: Array, high: Array) -> NDArray[Any]:
    """Mean of the values at the lines in each window, from its ``low`` to its ``high`` end."""
    first, last = np.searchsorted(lines, low, side="left"), np.searchsorted(lines, high, side="right")
    # windows one by one: differences of running sums would lose values far below the largest one
    return np.stack([values[a:b].mean(axis=0) for a, b in zip(first, last, strict=True)])


def widest_range(lines: Array, chosen: Bools) -> tuple[int, int] | None:
    """Numbers of the first and the last of the chosen lines in their widest range; None without any."""
    change = np.flatnonzero(np.diff(np.concatenate([[False], chosen, [False]]).astype(int)))
    starts, stops = change[::2], change[1::2] - 1
    if not len(starts):
        return None
    widest = int((lines[stops] - lines[starts]).argmax())
    return int(starts[widest]), int(stops[widest])


def _edges(lines: Array, level: Array, outside: float, inside: float, share: float) -> tuple[float, float]:
    """Ends of the widest range above a threshold, interpolated between the lines."""
    threshold = outside + share * (inside - outside)
    widest = widest_range(lines, level > threshold)
    if widest is None:
        peak = float(lines[level.argmax()])
        return peak, peak
    start, stop = widest
    lower, upper = float(lines[start]), float(lines[stop])
    if start > 0:
        lower = float(np.interp(threshold, level[start - 1 : start + 1], lines[start - 1 : start + 1]))
    if stop < len(lines) - 1:
        upper = float(np.interp(-threshold, -level[stop : stop + 2], lines[stop : stop + 2]))
    return lower, upper
