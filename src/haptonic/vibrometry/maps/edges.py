"""Edges of a lattice's gap, from the decay of waves of every phase in its rows.

Experimental: the thresholds were measured on square lattices, and upper edges are seldom determined.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
import scipy
from numpy.typing import NDArray

from haptonic.arrays import Array, Bools, Complex
from haptonic.errors import ScanError
from haptonic.later import xarray as xr
from haptonic.response import FrequencyResponse
from haptonic.units import Hertz, hz_text
from haptonic.vibrometry.maps.gap import widest_range, window_means
from haptonic.vibrometry.maps.noise import HIDDEN, averages_of, noise_power
from haptonic.vibrometry.maps.waves import Axis
from haptonic.vibrometry.planning import Rectangle

# Spacings of pillars: three rows of a triangular lattice are 2.8 deep. With four rows of half a pitch, 2.1
# deep, the upper edge was 5 kHz below the computed one.
LEAST_DEPTH = 2.5
DEGREE = 5  # of the splines across the rows
PLACES = 8  # positions in a row at which neighbouring rows are compared
MARGIN = 2.5  # steps of the grid beside a strip that the splines need
AVERAGED = 5e-3  # relative width in frequency over which lines are averaged
LOUD = 4.0  # times the noise: weaker signals are not used
LINES = 256  # that are transformed at a time

HEARD = 0.5  # of the phases at a line, and of the lines beside an edge, that have to exceed the noise
# Thresholds in dB from a pillar to the next, measured on square lattices
FADES = 4.0  # waves of large phase above it count as decaying; in a band 0.5 to 3 were measured
STOPPED = 1.5  # the same for waves of small phase, which reach farther; in a band 0.3 to 1 were measured
BESIDE = 0.06  # of a frequency, width on either side of an edge over which decay is averaged
NARROWEST = 0.02  # of a frequency; narrower ranges are ignored
METHOD = 0.012  # of an edge, standard error because of few rows: that of six plates, see docs/scan.md


@dataclass(frozen=True)
class LatticeRows:
    """Rows of a lattice, one behind the other.

    area : rectangle around all rows
    depth : axis across the rows
    start : position of the front of the first row, m
    inwards : 1, or -1 if the rows follow towards smaller coordinates
    pitch : distance of rows, m
    period : of the cells along the rows, m
    spacing : of pillars, the root of the area of each, m
    repeat : number of rows to the next row straight behind a row: 2 if each is offset by half a period
    """

    area: Rectangle
    depth: Axis
    start: float
    inwards: Literal[1, -1]
    pitch: float
    period: float
    spacing: float
    repeat: int
    rows: int


@dataclass(frozen=True)
class Edge:
    """Frequency and standard error of an edge, Hz."""

    frequency: Hertz
    error: Hertz

    def __str__(self) -> str:
        return hz_text(self.frequency, form=".2f", error=self.error)


@dataclass(frozen=True)
class LatticeGap:
    """Experimental edges of a gap; None for an undetermined edge, with a sentence that gives the reason."""

    lower: Edge | None
    upper: Edge | None
    reasons: tuple[str, ...]

    def beside(self, lower: float, upper: float) -> bool:
        """True if an edge shows that the gap does not overlap another range, Hz."""
        return (self.upper is not None and self.upper.frequency + self.upper.error < lower) or (
            self.lower is not None and self.lower.frequency - self.lower.error > upper
        )


def decay_along(response: FrequencyResponse, strips: Sequence[LatticeRows]) -> xr.DataArray:
    """Decay of waves of each phase from row to row, independent of reflections.

    For a wave of phase q along the strip and its reflection, rows u that lie straight behind each other
    satisfy u[n-1] + u[n+1] = 2 cos(k) u[n] at equal positions in the cell. cos(k) is fitted to all positions,
    rows, strips and nearby lines, and |Im k| is the decay: zero in a band, even if the strip resonates. If
    several waves of a phase contribute, the result lies between their values.

    If rows are offset by half a period, a mirror turns a wave of phase pi with the factor m from row to row
    into a wave with the factor -m and equal amplitude: 2 cos(k) changes sign, and its average vanishes. Over
    every second row, both waves have the factor m^2.

    Parameters
    ----------
    strips : strips of one lattice; those with fewer than three rows straight behind each other are left out

    Returns
    -------
    (frequency, phase) dB per row, phase from 0 to pi; NaN where noise hides it

    Raises
    ------
    ScanError : no strip is deep enough
    ResponseError : points that are not on a regular grid
    """
    usable = [
        strip
        for strip in strips
        # three rows are the least that distinguish a wave from its reflection
        if strip.rows > 2 * strip.repeat and strip.rows * strip.pitch >= LEAST_DEPTH * strip.spacing
    ]
    if not usable:
        raise ScanError.too_few(
            argument="strips", given="fewer than three rows of a lattice, one straight behind the other",
            allowed="three rows or more, five where each is offset by half a period against the next",
            cause="with so few rows, decay cannot be distinguished from reflection",
            next_step="compare contrast and decay with the computed gap, or build a plate with more rows",
        )  # fmt: skip
    count = max(2, min(round(_length(strip) / strip.period) for strip in usable))
    phases = np.linspace(0, np.pi, count + 1)
    lines = response.frequency
    product: NDArray[Any] = np.zeros((len(lines), count + 1), complex)
    energy, noise = (np.zeros(product.shape) for _ in range(2))
    for strip in usable:
        for total, part in zip((product, energy, noise), _compared(response, strip, phases), strict=True):
            total += part
    weight = (energy - noise).sum(axis=1, keepdims=True)  # else resonances outweigh the lines between them
    weight = np.divide(1.0, weight, out=np.zeros_like(weight), where=weight > 0)
    ends = lines * (1 - 0.5 * AVERAGED), lines * (1 + 0.5 * AVERAGED)
    product, energy, noise = (
        window_means(lines, total * weight, *ends) for total in (product, energy, noise)
    )
    clean = energy - noise
    cosine = np.divide(product, clean, out=np.full(product.shape, np.nan + 0j), where=clean > LOUD * noise)
    multiplier = cosine + np.sqrt(cosine**2 - 1)
    return xr.DataArray(
        20 / usable[0].repeat * np.abs(np.log10(np.abs(multiplier))),
        dims=("frequency", "phase"),
        coords={"frequency": response.dataset["frequency"], "phase": ("phase", phases, {"units": "rad"})},
        attrs={"units": "dB/row"} | HIDDEN, name="decay",
    )  # fmt: skip


def gap_edges(decays: xr.DataArray, depth: float = 1.0) -> LatticeGap:
    """Edges of the widest range in which waves decay whose phases exceed a quarter turn; experimental.

    An edge counts if a band is next to it and waves of smaller phase stop there as well. Otherwise it may be
    the edge of a gap for some directions only, and the complete gap may end elsewhere.

    Parameters
    ----------
    decays : see `decay_along`
    depth : depth of a row, in spacings of pillars
    """
    lines = np.asarray(decays["frequency"].values, float)
    large = decays["phase"].values > np.pi / 2
    most, others = (_mean_of_heard(decays.values[:, phases] / depth) for phases in (large, ~large))
    if np.isnan(most).all() or np.isnan(others).all():
        return LatticeGap(None, None, ("no edges of the gap: noise hides the waves in the lattice",))
    heard = np.isfinite(most) & np.isfinite(others)
    most, others = (np.interp(lines, lines[heard], decay[heard]) for decay in (most, others))
    widest = widest_range(lines, most > FADES)
    if widest is None:
        return LatticeGap(None, None, ("no edges of the gap: waves do not decay in the lattice",))
    first, last = widest
    if lines[last] - lines[first] < NARROWEST * lines[first]:
        return LatticeGap(None, None, ("no edges of the gap: waves decay in a narrow range only",))
    lower = _edge(lines, most, others, heard, first)
    upper = _edge(-lines[::-1], most[::-1], others[::-1], heard[::-1], len(lines) - 1 - last)
    edges = [edge if isinstance(edge, Edge) else None for edge in (lower, upper)]
    reasons = [f"{name} edge not determined: {edge}" for name, edge in (("lower", lower), ("upper", upper))
               if isinstance(edge, str)]  # fmt: skip
    if edges[1] is not None:
        edges[1] = Edge(-edges[1].frequency, edges[1].error)
    return LatticeGap(edges[0], edges[1], tuple(reasons))


def _mean_of_heard(decays: Array) -> Array:
    """(frequency,) means over the phases (frequency, phase) above the noise; NaN if they are too few."""
    heard = np.isfinite(decays)
    total, count = np.where(heard, decays, 0.0).sum(axis=1), heard.sum(axis=1)
    return np.where(count >= HEARD * decays.shape[1], total / np.maximum(count, 1), np.nan)


def _edge(lines: Array, most: Array, others: Array, heard: Bools, first: int) -> Edge | str:
    """Edge at which decay begins on ascending lines (negative ones allowed), or why it is undetermined."""
    if first == 0:
        return (
            "waves of large phase decay up to the end of the scanned range, and a few rows do not show where "
            "the other waves begin to pass"
        )
    beside = BESIDE * abs(lines[first])
    outside = (lines < lines[first]) & (lines > lines[first] - beside)
    inside = (lines >= lines[first]) & (lines < lines[first] + beside)
    if min(heard[outside].mean(), heard[inside].mean()) < HEARD:
        return "noise hides the waves near it"
    if most[outside].mean() > 0.75 * FADES:
        return "the lattice has no band next to it in the scan"
    if others[inside].mean() < max(STOPPED, 2 * others[outside].mean()):
        return "waves nearly in phase along the rows do not change there, or too few rows hide their change"
    at, early, late = (_crossing(lines, most, first, share * FADES) for share in (1.0, 0.5, 1.5))
    widths = [0.5 * (late - early), AVERAGED * at / np.sqrt(12), (lines[1] - lines[0]) / np.sqrt(12)]
    return Edge(at, float(np.hypot(METHOD * at, np.linalg.norm(widths))))


def _crossing(lines: Array, level: Array, first: int, threshold: float) -> float:
    """Frequency at which a level crosses a threshold: last before a line, or else first after it."""
    above = level[first:] >= threshold
    stop = first + int(above.argmax()) if above.any() else len(level) - 1
    while stop > 0 and level[stop - 1] >= threshold:
        stop -= 1
    if stop == 0:
        return float(lines[0])
    return float(np.interp(threshold, level[stop - 1 : stop + 1], lines[stop - 1 : stop + 1]))


def _length(strip: LatticeRows) -> float:
    return strip.area.height if strip.depth == "x" else strip.area.width


def _compared(response: FrequencyResponse, strip: LatticeRows, phases: Array) -> tuple[Complex, Array, Array]:
    """Sums over positions and rows, (line, phase): conj(u[n]) (u[n-1] + u[n+1]), 2 |u[n]|^2, its noise."""
    along: Axis = "y" if strip.depth == "x" else "x"
    points = _near(response, strip)
    part = FrequencyResponse(response.dataset.isel(point=points))
    whole = _complete(part, strip.depth, along)
    across, place = whole[strip.depth].values, whole[along].values
    begin = strip.area.y if along == "y" else strip.area.x
    hann = np.sin(np.pi * (place - begin) / _length(strip)) ** 2
    turns = np.outer(place, np.concatenate([phases, -phases]) / strip.period)
    waves = hann[:, None] * np.exp(1j * turns)
    row = (np.arange(PLACES) + 0.5) / PLACES + np.arange(strip.rows)[:, None]
    at = strip.start + strip.inwards * strip.pitch * row.ravel()
    order = np.argsort(across)
    spline = scipy.interpolate.make_interp_spline(across[order], np.eye(len(across))[order], k=DEGREE)(at)
    product = np.zeros((len(whole), len(phases)), complex)
    energy, noise = np.zeros((2, len(whole), len(phases)))
    noise_at_points = _noise(part, strip.depth, along, whole)
    inner = slice(strip.repeat, -strip.repeat)
    for start in range(0, len(whole), LINES):
        lines = slice(start, start + LINES)
        seen = spline @ (whole.values[lines] @ waves)
        rows = seen.reshape(len(seen), strip.rows, PLACES, 2, len(phases))
        middle, sides = rows[:, inner], rows[:, : -2 * strip.repeat] + rows[:, 2 * strip.repeat :]
        product[lines] = (middle.conj() * sides).sum(axis=(1, 2, 3))
        energy[lines] = 2 * (np.abs(middle) ** 2).sum(axis=(1, 2, 3))
        if noise_at_points is not None:
            power = spline**2 @ (noise_at_points[lines] @ np.abs(waves) ** 2)
            each = power.reshape(rows.shape)[:, inner]
            noise[lines] = 2 * each.sum(axis=(1, 2, 3))
    return product, energy, noise


def _near(response: FrequencyResponse, strip: LatticeRows) -> NDArray[np.int64]:
    """Points on a strip and in a margin beside it, which the splines need."""
    points, area = response.points, strip.area
    column = 0 if strip.depth == "x" else 1
    places = np.unique(np.round(points[:, column], 9))
    steps = np.diff(places)
    margin = MARGIN * float(np.median(steps[steps > 0.1 * steps.max()])) if len(steps) else 0.0
    wider = (
        Rectangle(area.x - margin, area.y, area.width + 2 * margin, area.height)
        if strip.depth == "x"
        else Rectangle(area.x, area.y - margin, area.width, area.height + 2 * margin)
    )
    return np.flatnonzero(wider.holds(points))


def _complete(part: FrequencyResponse, depth: Axis, along: Axis) -> xr.DataArray:
    """(frequency, depth, along) motion along z, without positions at which a point is missing.

    Raises
    ------
    ScanError : too few points are left
    """
    grid = part.grid().sel(direction="z").transpose("frequency", depth, along)
    present = np.isfinite(grid.values[0])
    whole = grid.isel({along: np.flatnonzero(present.all(axis=0))})
    if whole.sizes[depth] <= DEGREE or whole.sizes[along] < 0.7 * grid.sizes[along]:
        raise ScanError.too_few(
            argument="strips", given=f"{whole.sizes[along]} of {grid.sizes[along]} places along the rows "
            f"without a missing point, {whole.sizes[depth]} across them",
            allowed=f"70 % of the places, and more than {DEGREE} across the rows",
            cause="points were dropped, or the grid is coarse", next_step="repair the points, or scan again",
        )  # fmt: skip
    return whole


def _noise(part: FrequencyResponse, depth: Axis, along: Axis, whole: xr.DataArray) -> Array | None:
    """(frequency, depth, along) mean square of the noise at the same positions; None if it is unknown."""
    if not (averages := averages_of(part)):
        return None
    everywhere = np.ones(part.dataset.sizes["point"], dtype=bool)
    power = noise_power(part, everywhere, slice(None), averages)
    data = part.dataset.isel(direction=[0]).assign_coords(direction=["z"])
    values = power[..., None].astype(np.complex64)
    grid = FrequencyResponse(data.assign(response=(("frequency", "point", "direction"), values))).grid()
    ordered = grid.sel(direction="z").transpose("frequency", depth, along)
    return np.asarray(ordered.sel({along: whole[along]}).values.real, dtype=float)
