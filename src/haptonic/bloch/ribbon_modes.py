"""Properties of ribbon modes: location of the energy, decay into the crystals, nodal lines."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy.special

from haptonic.arrays import Array, Bools, Complex
from haptonic.bloch.face_grid import STEPS, FaceGrid, FlatFace, middles
from haptonic.bloch.ribbon import RibbonModel, RibbonModes
from haptonic.cell import Ribbon

FAINTEST = 1e-18  # share of the energy below which a column contains rounding errors only
HARMONICS = np.arange(-3, 4)
INPLANE = 1e-6  # share of normal motion in the squared amplitude below which a mode has none
STILL = 0.05  # share of the largest amplitude across the guide below which the sign is not used
NEAR_AND_FAR = 5  # number of rows from which the first, with evanescent waves of all kinds, is left out
# Student's interval for the error of a decay. Evanescent waves of several wavelengths beat: falls of 10 to
# 22 dB from row to row have the mean 14.8 dB over 11 rows, where the complex bands give 14.5 dB.
CONFIDENCE = 0.9
ALONE = 2.0  # error of a fall without a second one, as a multiple of it
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
    the distance to the decay in the stiffened pencil, and from how the falls from row to row differ.
    """
    energies = modes.energy, modes.stiffened_energy
    (slopes, scatter), (lower, _) = (_slopes(model.ribbon, energy) for energy in energies)
    side = np.where(np.isnan(slopes), np.inf, slopes).argmin(axis=0)[None]
    chosen, other, error = (np.take_along_axis(each, side, axis=0)[0] for each in (slopes, lower, scatter))
    return chosen, OWN_AND_SHARED * modes.remaining * np.abs(chosen - other) + error


def _slopes(ribbon: Ribbon, energy: Array) -> tuple[Array, Array]:
    """(2, k) decay to the left and to the right for energies (k, lines, columns), and errors of both."""
    guide = np.flatnonzero(ribbon.guide.any(axis=0))
    slopes, scatter = np.full((2, 2, len(energy)), np.nan)
    if not len(guide):
        return slopes, scatter
    energy = energy.sum(axis=1)
    share = energy / energy.sum(axis=1, keepdims=True)
    beside = int(ribbon.kind != "edge")  # the columns at an edge between two crystals are the first rows
    sides = range(min(guide) - beside, -1, -1), range(max(guide) + beside, energy.shape[1])
    for side, columns in enumerate(sides):
        rows = np.array(columns, dtype=int)
        rows = rows[1:] if len(rows) > NEAR_AND_FAR else rows
        for number, of_mode in enumerate(share):
            there = np.logical_and.accumulate(of_mode[rows] > FAINTEST)
            level = 10 * np.log10(of_mode[rows[there]])
            inner = level[: len(rows) - 1]
            if len(inner) > 1:
                # two rows have one fall, and nothing but the outermost shows how falls differ
                falls = -np.diff(level if len(inner) == 2 else inner)
                slopes[side, number] = -np.polyfit(np.arange(len(inner)), inner, 1)[0]
                scatter[side, number] = _mean_error(falls)
    return slopes, scatter


def _mean_error(falls: Array) -> float:
    """Half of Student's interval of the mean."""
    if len(falls) < 2:
        return float(ALONE * np.abs(falls[0]))
    reach = scipy.special.stdtrit(len(falls) - 1, 0.5 + CONFIDENCE / 2)
    return float(reach * falls.std(ddof=1) / np.sqrt(len(falls)))


@dataclass(frozen=True)
class GuideMotion:
    """Motion of a guide, or of a whole strip, on a grid of its flat face.

    A mode is decomposed into ``exp(i (kappa + 2 pi h) y / period)`` along the ribbon.
    """

    model: RibbonModel

    @cached_property
    def face(self) -> FlatFace:
        return FlatFace.of(self.model.fine.tiling, self.model.ribbon.turn)

    @cached_property
    def grid(self) -> FaceGrid:
        """Grid with several points in each column."""
        ribbon, position = self.model.ribbon, self.face.position
        carrying = np.flatnonzero(ribbon.guide[0] | (ribbon.kind == "strip"))  # a wave of a strip moves all
        middle, width = ((values @ ribbon.turn.T)[carrying, 0] for values in (ribbon.origins, ribbon.steps))
        counts = np.ceil(STEPS * np.maximum(width / ribbon.period, 1.0)).astype(int)
        columns = zip(middle - 0.5 * width, width, counts, strict=True)
        across = np.concatenate([middles(*column) for column in columns])
        along = middles(position[:, 1].min(), ribbon.period, STEPS)
        return FaceGrid.of(across, along, position, self.face.triangles, np.array([[0.0, ribbon.period]]))

    def harmonics(self, modes: RibbonModes) -> tuple[Array, Array]:
        """Wavenumbers (k,) rad/m along the guide, and (k,) nodal lines of the normal motion across it.

        Both are those of the harmonic with the largest amplitude. NaN for several lines of cells, because a
        guide that varies along the ribbon has no wavenumber; lines only of a plain guide's normal motion.
        """
        count, ribbon = len(modes.frequency), self.model.ribbon
        wavenumber, lines = np.full((2, count), np.nan)
        if ribbon.more or not count:
            return wavenumber, lines
        motion = self.face.motion(modes.fields).reshape(-1, 3 * count)
        on_grid = self.grid.values(motion, np.array([1j * modes.kappa])).reshape(3, count, -1, STEPS)
        phases = modes.kappa + 2 * np.pi * HARMONICS
        amplitude = on_grid @ np.exp(-1j * np.outer(self.grid.along / ribbon.period, phases))
        strength = (np.abs(amplitude) ** 2).sum(axis=2)  # (3, k, harmonics)
        largest = strength.sum(axis=0).argmax(axis=1)
        wavenumber = np.abs(phases[largest]) / ribbon.period
        if ribbon.kind == "guide":
            for mode, harmonic in enumerate(largest):
                of_mode = strength[:, mode, harmonic]
                if of_mode[2] > INPLANE * of_mode.sum():
                    lines[mode] = _sign_changes(amplitude[2, mode, :, harmonic])
        return wavenumber, lines


def _sign_changes(profile: Complex) -> int:
    """Number of sign changes of a complex profile in phase with its largest value."""
    phase = profile[np.abs(profile).argmax()]
    size = (profile * np.exp(-1j * np.angle(phase))).real
    return int((np.diff(np.sign(size[np.abs(size) > STILL * np.abs(phase)])) != 0).sum())
