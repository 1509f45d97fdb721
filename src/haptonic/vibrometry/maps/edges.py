"""The edges of a lattice's gap, from how waves of every phase fade in its rows."""

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
from haptonic.vibrometry.maps.noise import HIDDEN, averages_of, noise_power
from haptonic.vibrometry.maps.waves import Axis
from haptonic.vibrometry.planning import Rectangle

# Spacings of pillars: three rows of a triangular lattice are 2.8 deep. In four of half a pitch, 2.1 deep, an
# upper edge was told 5 kHz below the computed one.
LEAST_DEPTH = 2.5
DEGREE = 5  # of the splines across the rows
PLACES = 8  # in a row, at which neighbouring rows are compared
MARGIN = 2.5  # steps of the grid beside a strip that the splines use
AVERAGED = 5e-3  # of a frequency, width over which lines are averaged
LOUD = 4.0  # times the noise: what is weaker is not used
LINES = 256  # that are transformed at a time

HEARD = 0.5  # of the phases at a line, and of the lines beside an edge, that have to be louder than noise
# dB from a pillar to the next, wherever rows are, as measured on square lattices
FADES = 4.0  # above which waves of large phase count as decaying; in a band 0.5 to 3 were found
STOPPED = 1.5  # above which those of small phase do, which reach farther; in a band 0.3 to 1
BESIDE = 0.06  # of a frequency, on either side of an edge, over which what fades and what passes is averaged
NARROWEST = 0.02  # of a frequency; a narrower range is not looked at
METHOD = 0.012  # of an edge, its standard error by rows that are few: that of six plates, see docs/scan.md


@dataclass(frozen=True)
class LatticeRows:
    """Rows of a lattice, one behind the other.

    area : of all of them; depth : axis across the rows; start : where the first one begins, m
    inwards : -1 towards smaller coordinates; pitch : of rows; period : of the cells along them, m
    spacing : of pillars, the root of the area that one has, m
    repeat : rows from one to the next that lies straight behind it: 2 where each is offset by half a period
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
    """Frequency and standard error, Hz."""

    frequency: Hertz
    error: Hertz

    def __str__(self) -> str:
        return hz_text(self.frequency, form=".2f", error=self.error)


@dataclass(frozen=True)
class LatticeGap:
    """Edges of a gap; None for one that the scan does not tell, and then a reason that says why."""

    lower: Edge | None
    upper: Edge | None
    reasons: tuple[str, ...]

    def beside(self, lower: float, upper: float) -> bool:
        """Whether an edge that was found shows that it has nothing in common with another range, Hz."""
        return (self.upper is not None and self.upper.frequency + self.upper.error < lower) or (
            self.lower is not None and self.lower.frequency - self.lower.error > upper
        )


def decay_along(response: FrequencyResponse, strips: Sequence[LatticeRows]) -> xr.DataArray:
    """By how much waves of a phase fade from row to row, whatever is reflected.

    A wave of phase q along the strip and its reflection give rows u that lie straight behind each other
    u[n-1] + u[n+1] = 2 cos(k) u[n] at equal places in the cell. cos(k) is the fit to all places, rows,
    strips and lines nearby, and |Im k| tells how it fades: zero in a band, also where the strip resonates. If
    several waves of a phase matter it is something between theirs.

    Where rows are offset by half a period, a mirror turns a wave of phase pi that is multiplied by m from row
    to row into one multiplied by -m: as large, with 2 cos(k) of the other sign, of which nothing is left on
    average. Every other row has m^2 of both.

    Parameters
    ----------
    strips : of one lattice; those with fewer than three rows straight behind each other are left out

    Returns
    -------
    (frequency, phase) dB per row, phase from 0 to pi; NaN where noise hides it

    Raises
    ------
    ScanError : no strip that is deep enough
    ResponseError : points that are not on a regular grid
    """
    usable = [
        strip
        for strip in strips
        # a wave and its reflection need three rows to be told apart
        if strip.rows > 2 * strip.repeat and strip.rows * strip.pitch >= LEAST_DEPTH * strip.spacing
    ]
    if not usable:
        raise ScanError.too_few(
            argument="strips", given="fewer than three rows of a lattice, one straight behind the other",
            allowed="three rows or more, five where each is offset by half a period against the next",
            cause="so few rows cannot tell a wave that fades from one that is reflected",
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
    weight = (energy - noise).sum(axis=1, keepdims=True)  # resonances would outshine the lines between them
    weight = np.divide(1.0, weight, out=np.zeros_like(weight), where=weight > 0)
    product, energy, noise = (_averaged(lines, one * weight) for one in (product, energy, noise))
    clean = energy - noise
    cosine = np.divide(product, clean, out=np.full(product.shape, np.nan + 0j), where=clean > LOUD * noise)
    multiplier = cosine + np.sqrt(cosine**2 - 1)
    return xr.DataArray(
        20 / usable[0].repeat * np.abs(np.log10(np.abs(multiplier))),
        dims=("frequency", "phase"),
        coords={"frequency": response.dataset["frequency"], "phase": ("phase", phases, {"units": "rad"})},
        attrs={"units": "dB/row"} | HIDDEN, name="decay",
    )  # fmt: skip


def gap_edges(fades: xr.DataArray, depth: float = 1.0) -> LatticeGap:
    """Edges of the widest range in which waves with phases of more than a quarter turn fade.

    An edge counts if a band lies beside it and waves of smaller phase stop there as well: else it may be
    that of a gap for some directions only, and the complete one ends elsewhere.

    Parameters
    ----------
    fades : see `decay_along`; depth : of a row, in spacings of pillars
    """
    lines = np.asarray(fades["frequency"].values, float)
    large = fades["phase"].values > np.pi / 2
    most, others = (_mean_of_heard(fades.values[:, one] / depth) for one in (large, ~large))
    if np.isnan(most).all() or np.isnan(others).all():
        return LatticeGap(None, None, ("no edges of the gap: noise hides the waves in the lattice",))
    heard = np.isfinite(most) & np.isfinite(others)
    most, others = (np.interp(lines, lines[heard], one[heard]) for one in (most, others))
    stops = np.concatenate([[False], most > FADES, [False]])
    change = np.flatnonzero(np.diff(stops.astype(int)))
    starts, ends = change[::2], change[1::2] - 1
    if not len(starts):
        return LatticeGap(None, None, ("nowhere do waves fade in the lattice",))
    widest = int((lines[ends] - lines[starts]).argmax())
    first, last = int(starts[widest]), int(ends[widest])
    if lines[last] - lines[first] < NARROWEST * lines[first]:
        return LatticeGap(None, None, ("nowhere do waves fade in the lattice over a wide range",))
    lower = _edge(lines, most, others, heard, first)
    upper = _edge(-lines[::-1], most[::-1], others[::-1], heard[::-1], len(lines) - 1 - last)
    found = [edge if isinstance(edge, Edge) else None for edge in (lower, upper)]
    reasons = [f"no {name} edge: {edge}" for name, edge in (("lower", lower), ("upper", upper))
               if isinstance(edge, str)]  # fmt: skip
    if found[1] is not None:
        found[1] = Edge(-found[1].frequency, found[1].error)
    return LatticeGap(found[0], found[1], tuple(reasons))


def _mean_of_heard(fades: Array) -> Array:
    """(frequency,) means over the phases (frequency, phase) that noise does not hide, if enough are left."""
    there = np.isfinite(fades)
    total, count = np.where(there, fades, 0.0).sum(axis=1), there.sum(axis=1)
    return np.where(count >= HEARD * fades.shape[1], total / np.maximum(count, 1), np.nan)


def _edge(lines: Array, most: Array, others: Array, heard: Bools, first: int) -> Edge | str:
    """The edge below a line from which on waves fade; or why it is none. Lines may be negative, ascending."""
    if first == 0:
        return (
            "waves of large phase fade up to the end of the scanned range; where the others begin to pass, "
            "few rows do not show"
        )
    beside = BESIDE * abs(lines[first])
    outside = (lines < lines[first]) & (lines > lines[first] - beside)
    inside = (lines >= lines[first]) & (lines < lines[first] + beside)
    if min(heard[outside].mean(), heard[inside].mean()) < HEARD:
        return "noise hides the waves there"
    if most[outside].mean() > 0.75 * FADES:
        return "no band lies beside it"
    if others[inside].mean() < max(STOPPED, 2 * others[outside].mean()):
        return "nothing changes there for waves nearly in phase along the rows, or too few rows hide it"
    at, early, late = (_crossing(lines, most, first, share * FADES) for share in (1.0, 0.5, 1.5))
    widths = [0.5 * (late - early), AVERAGED * at / np.sqrt(12), (lines[1] - lines[0]) / np.sqrt(12)]
    return Edge(at, float(np.hypot(METHOD * at, np.linalg.norm(widths))))


def _crossing(lines: Array, level: Array, first: int, threshold: float) -> float:
    """Where a level passes a threshold, the last time before a line or the first time after it."""
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
    """Sums over places and rows, (line, phase): conj(u[n]) (u[n-1] + u[n+1]), 2 |u[n]|^2, and its noise."""
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
    heard = _noise(part, strip.depth, along, whole)
    inner = slice(strip.repeat, -strip.repeat)
    for start in range(0, len(whole), LINES):
        lines = slice(start, start + LINES)
        seen = spline @ (whole.values[lines] @ waves)
        rows = seen.reshape(len(seen), strip.rows, PLACES, 2, len(phases))
        middle, sides = rows[:, inner], rows[:, : -2 * strip.repeat] + rows[:, 2 * strip.repeat :]
        product[lines] = (middle.conj() * sides).sum(axis=(1, 2, 3))
        energy[lines] = 2 * (np.abs(middle) ** 2).sum(axis=(1, 2, 3))
        if heard is not None:
            power = spline**2 @ (heard[lines] @ np.abs(waves) ** 2)
            each = power.reshape(rows.shape)[:, inner]
            noise[lines] = 2 * each.sum(axis=(1, 2, 3))
    return product, energy, noise


def _near(response: FrequencyResponse, strip: LatticeRows) -> NDArray[np.int64]:
    """Points on a strip and a little beside it, which the splines need."""
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
    """(frequency, depth, along) motion along z, without places at which a point is missing.

    Raises
    ------
    ScanError : too little is left
    """
    grid = part.grid().sel(direction="z").transpose("frequency", depth, along)
    there = np.isfinite(grid.values[0])
    whole = grid.isel({along: np.flatnonzero(there.all(axis=0))})
    if whole.sizes[depth] <= DEGREE or whole.sizes[along] < 0.7 * grid.sizes[along]:
        raise ScanError.too_few(
            argument="strips", given=f"{whole.sizes[along]} of {grid.sizes[along]} places along the rows "
            f"without a missing point, {whole.sizes[depth]} across them",
            allowed=f"70 % of the places, and more than {DEGREE} across the rows",
            cause="points were dropped, or the grid is coarse", next_step="repair the points, or scan again",
        )  # fmt: skip
    return whole


def _noise(part: FrequencyResponse, depth: Axis, along: Axis, whole: xr.DataArray) -> Array | None:
    """(frequency, depth, along) mean square of the noise at the same places; None if it is not known."""
    if not (averages := averages_of(part)):
        return None
    everywhere = np.ones(part.dataset.sizes["point"], dtype=bool)
    power = noise_power(part, everywhere, slice(None), averages)
    data = part.dataset.isel(direction=[0]).assign_coords(direction=["z"])
    values = power[..., None].astype(np.complex64)
    grid = FrequencyResponse(data.assign(response=(("frequency", "point", "direction"), values))).grid()
    ordered = grid.sel(direction="z").transpose("frequency", depth, along)
    return np.asarray(ordered.sel({along: whole[along]}).values.real, dtype=float)


def _averaged(lines: Array, values: NDArray[Any]) -> NDArray[Any]:
    """Means over lines nearby, each as heavy as the others."""
    first = np.searchsorted(lines, lines * (1 - 0.5 * AVERAGED), side="left")
    last = np.searchsorted(lines, lines * (1 + 0.5 * AVERAGED), side="right")
    return np.stack([values[a:b].mean(axis=0) for a, b in zip(first, last, strict=True)])
