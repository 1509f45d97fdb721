"""Properties of ribbon modes: location of the energy, decay into the crystals, nodal lines."""

from __future__ import annotations

import numpy as np

from haptonic.arrays import Array, Bools
from haptonic.bloch.ribbon import RibbonModel, RibbonModes, RibbonPencil
from haptonic.cell import Ribbon

FAINTEST = 1e-18  # share of the energy below which a column contains rounding errors only
LEAST_ON_LINE = 3  # places along the ribbon needed to determine harmonics
HARMONICS = np.arange(-3, 4)
STILL = 0.05  # share of the largest amplitude across the guide below which the sign is not used
NEAR_AND_FAR = 5  # number of rows from which the first, with evanescent waves of all kinds, is left out
OWN_AND_SHARED = 2.0  # distances to the stiffened pencil in an error: its own, and as much for all modes


def within(energy: Array, cells: Bools) -> Array:
    """(k,) share of the energy (k, lines, columns) in some cells (lines, columns)."""
    return np.asarray(energy[:, cells].sum(axis=1) / energy.sum(axis=(1, 2)))


def outermost(ribbon: Ribbon) -> Bools:
    """(lines, columns) first and last column, without a guide; free edges have edge waves."""
    return np.asarray(ribbon.outermost & ~ribbon.guide)


def in_gap(modes: RibbonModes, bulk: Array) -> Bools:
    """(k,) True for modes outside the bulk bands (crystals, bands, 2; Hz) at their phase, errors included.

    Frequencies above the lower edge of the last computed band count as inside, as higher bands are unknown.
    """
    least, most = (modes.frequency - modes.error)[:, None], (modes.frequency + modes.error)[:, None]
    free = np.ones(len(modes.frequency), dtype=bool)
    for bands in bulk:
        below, above = most < bands[:, 0], least > bands[:, 1]
        above[:, -1] = False
        free &= (below | above).all(axis=1)
    return free


def decay(model: RibbonModel, modes: RibbonModes) -> tuple[Array, Array]:
    """(k,) decay of modes away from the guide, dB per row, and estimates of its errors; NaN in a strip.

    Least squares over the columns on each side, without the outermost column, which contains waves reflected
    at the free edge; the smaller value of the two sides. NaN for fewer than two rows. The error follows from
    the distance to the decay in the stiffened pencil, and contains the standard error of the slope.
    """
    energies = modes.energy, modes.stiffened_energy
    (slopes, scatter), (lower, _) = (_slopes(model.ribbon, energy) for energy in energies)
    side = np.where(np.isnan(slopes), np.inf, slopes).argmin(axis=0)[None]
    chosen, other, error = (np.take_along_axis(each, side, axis=0)[0] for each in (slopes, lower, scatter))
    return chosen, OWN_AND_SHARED * modes.remaining * np.abs(chosen - other) + error


def _slopes(ribbon: Ribbon, energy: Array) -> tuple[Array, Array]:
    """(2, k) decay to the left and to the right for energies (k, lines, columns), and its standard errors."""
    guide = np.flatnonzero(ribbon.guide.any(axis=0))
    slopes, scatter = np.full((2, 2, len(energy)), np.nan)
    if not len(guide):
        return slopes, scatter
    energy = energy.sum(axis=1)
    beside = int(ribbon.kind != "edge")  # the columns at an edge between two crystals are the first rows
    sides = range(min(guide) - beside, -1, -1), range(max(guide) + beside, energy.shape[1])
    for side, columns in enumerate(sides):
        rows = np.array(columns, dtype=int)[:-1]
        rows = rows[1:] if len(rows) >= NEAR_AND_FAR else rows
        if len(rows) < 2:
            continue
        share = energy[:, rows] / energy.sum(axis=1, keepdims=True)
        for number, of_rows in enumerate(share):
            there = of_rows > FAINTEST
            if there.sum() > 1:
                line = _fitted(np.flatnonzero(there).astype(float), 10 * np.log10(of_rows[there]))
                slopes[side, number], scatter[side, number] = line
    return slopes, scatter


def _fitted(x: Array, y: Array) -> tuple[float, float]:
    """Fall of the line of least squares, and the standard error of its slope; 0 for two points."""
    slope, level = np.polyfit(x, y, 1)
    spread = ((x - x.mean()) ** 2).sum()
    missed = ((y - slope * x - level) ** 2).sum()
    return -float(slope), float(np.sqrt(missed / max(len(x) - 2, 1) / spread))


def harmonics(ribbon: Ribbon, pencil: RibbonPencil, modes: RibbonModes) -> tuple[Array, Array]:
    """Wavenumbers (k,) rad/m along the guide, and (k,) nodal lines across a plain one, of the normal motion.

    A mode is decomposed into ``exp(i (kappa + 2 pi h) y / period)`` along sides of tiles that are parallel to
    the ribbon, on the flat face; the harmonic with the largest amplitude is used. NaN if tiles have no sides
    along the ribbon, and for several lines, because a guide that varies along the ribbon has no wavenumber.
    """
    if ribbon.more:
        return np.full(len(modes.frequency), np.nan), np.full(len(modes.frequency), np.nan)
    joint = pencil.tiling.joint
    sizes = np.diff(joint.ends, prepend=0)
    carrying = ribbon.guide[0] | (ribbon.kind == "strip")  # a wave of a strip moves all of it
    places = np.flatnonzero(np.repeat(carrying[ribbon.place_of_tile[1]], sizes))
    at = joint.position[places] @ ribbon.turn.T
    motion = modes.fields[joint.unknowns[0, places, 2]]
    close = 1e-6 * ribbon.period
    lines = np.round(at[:, 0] / close).astype(np.int64)
    on_lines: list[Array] = []
    for line in np.unique(lines):
        on = np.flatnonzero(np.abs(lines - line) <= 1)
        y, first = np.unique(np.round(at[on, 1] / close).astype(np.int64), return_index=True)
        if len(y) < LEAST_ON_LINE or np.ptp(y) * close < 0.99 * ribbon.period:
            continue
        y, weight = y * close, np.gradient(y * close)
        waves = np.exp(-1j * np.outer(modes.kappa + 2 * np.pi * HARMONICS, y / ribbon.period)) * weight
        on_lines.append(waves @ motion[on[first]])
    if not on_lines:
        return np.full(len(modes.frequency), np.nan), np.full(len(modes.frequency), np.nan)
    amplitude = np.array(on_lines)  # (lines, harmonics, k)
    strongest = (np.abs(amplitude) ** 2).sum(axis=0).argmax(axis=0)
    wavenumber = np.abs(modes.kappa + 2 * np.pi * HARMONICS[strongest]) / ribbon.period
    across = np.take_along_axis(amplitude, strongest[None, None], axis=1)[:, 0]
    phase = np.take_along_axis(across, np.abs(across).argmax(axis=0)[None], axis=0)
    size = (across * np.exp(-1j * np.angle(phase))).real / np.maximum(np.abs(phase), 1e-300)
    lines_across = np.full(size.shape[1], np.nan)
    for number, profile in enumerate(size.T if ribbon.kind == "guide" else []):
        signs = np.sign(profile[np.abs(profile) > STILL])
        lines_across[number] = (np.diff(signs) != 0).sum()
    return wavenumber, lines_across
