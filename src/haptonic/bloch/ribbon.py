"""Waves along a ribbon: all its modes within a range of frequencies, each with its error.

The crystals beside a guide, or on either side of where two of them meet, have bulk bands; at a fixed phase
along the ribbon these cover intervals of frequency, whatever the phase across. What the ribbon has between
them is held by the guide, or by the edge, and fades into the crystals.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from haptonic.arrays import Array, Complex, Ints
from haptonic.bloch.chain import BlockChain, eigenpairs_within
from haptonic.bloch.model import BlochModel, interior_error
from haptonic.bloch.pencil import Periodic, hertz
from haptonic.bloch.resolution import Resolution
from haptonic.cell import Ribbon
from haptonic.later import sparse as sp
from haptonic.superelement import Tiling, definite, on_each

ACROSS = 33  # phases across, at which bulk bands are sampled
WIDER = 0.03  # of a frequency: how far off it may be at the next lower orders, to begin with
LEAST = 1e-3  # of the lowest frequency: only rigid motions lie below that


@dataclass(frozen=True)
class RibbonPencil:
    """Stiffness and mass of one period of a ribbon in blocks, by columns from left to right.

    blocks : (n,) of the free unknowns, in the order of their columns; periodic : how they stand for all
    own, off : by block and by step, of phases exp(i step kappa), 0 and 1 and for ``off`` -1 as well:
        stiffness and mass (2, n, m)
    """

    tiling: Tiling
    periodic: Periodic
    order: Ints
    own: tuple[dict[int, Array], ...]
    off: tuple[dict[int, Array], ...]

    @classmethod
    def of(cls, ribbon: Ribbon, tiling: Tiling) -> RibbonPencil:
        """A free unknown goes to the block of the first column that has it."""
        periodic = Periodic.of(tiling)
        column = np.full(len(periodic.free), len(ribbon.first))
        for own, number in zip(tiling.own, ribbon.place_of_tile[1], strict=True):
            np.minimum.at(column, periodic.number[own], number)
        block = column // ribbon.reach
        order = np.argsort(block, kind="stable")
        sizes = np.bincount(block)
        place = np.empty(len(order), dtype=np.int64)
        place[order] = np.concatenate([np.arange(size) for size in sizes])
        diagonal: list[dict[int, Array]] = [{} for _ in sizes]
        beside: list[dict[int, Array]] = [{} for _ in sizes[1:]]
        for number, own in enumerate(tiling.own):
            tile = tiling.tiles[number]
            forms = [tiling.joint.form(number, one, tile.trace_size) for one in (tile.stiffness, tile.mass)]
            free, shift = periodic.number[own], periodic.shift[own, 0]
            groups = {
                (int(g), int(s)): np.flatnonzero((block[free] == g) & (shift == s))
                for g in np.unique(block[free])
                for s in np.unique(shift[block[free] == g])
            }
            for (g, s), rows in groups.items():
                for (h, t), columns in groups.items():
                    if h < g or (h == g and t < s):
                        continue  # the adjoint of its opposite
                    assert h <= g + 1, "tiles that touch farther columns than their own tell"
                    kept = diagonal[g] if h == g else beside[g]
                    total = kept.setdefault(t - s, np.zeros((2, sizes[g], sizes[h])))
                    left, right = (
                        _spread(place[free[rows]], sizes[g]),
                        _spread(place[free[columns]], sizes[h]),
                    )
                    for which, form in enumerate(forms):
                        total[which] += left @ (right @ form[np.ix_(rows, columns)].T).T
        return cls(tiling=tiling, periodic=periodic, order=order, own=tuple(diagonal), off=tuple(beside))

    def at(self, kappa: float, slope: bool = False) -> tuple[BlockChain, BlockChain]:
        """Stiffness and mass at a phase (rad) along the ribbon, or their derivatives with respect to it."""

        def summed(parts: dict[int, Array], which: int) -> Complex:
            factors = {s: np.exp(1j * s * kappa) * (1j * s if slope else 1.0) for s in parts}
            found: Complex = sum(factors[s] * one[which] for s, one in parts.items())
            return found

        def hermitian(parts: dict[int, Array], which: int) -> Complex:
            still = 0.0 if slope else parts[0][which]
            moved = {s: one for s, one in parts.items() if s}
            half = summed(moved, which) if moved else np.zeros_like(parts[0][which], dtype=complex)
            return np.asarray(still + half + half.conj().T)

        stiffness, mass = (
            BlockChain(
                tuple(hermitian(one, which) for one in self.own),
                tuple(summed(one, which) for one in self.off),
            )
            for which in (0, 1)
        )
        return stiffness, mass

    def expanded(self, modes: Complex, kappa: float) -> Complex:
        """(t + m, k) unknowns of the tiling from modes (n, k) in the order of the blocks."""
        free = np.empty_like(modes)
        free[self.order] = modes
        return self.periodic.expanded(free, np.array([kappa]))


def _spread(places: Ints, size: int) -> sp.csr_array:
    """(size, n) sparse, which adds up what belongs to one place."""
    count = len(places)
    return sp.csr_array((np.ones(count), (places, np.arange(count))), shape=(size, count))


@dataclass(frozen=True)
class RibbonModes:
    """Modes of a ribbon at one phase along it, lowest first.

    kappa : rad; frequency, error : (k,) Hz; the error bounds the distance to the exact frequency
    slope : (k,) derivatives of the frequency with respect to the phase, Hz/rad
    fields : (t + m, k) unknowns of the tiling, unit mass
    energy : (k, lines, columns) share of each cell in the energy
    """

    kappa: float
    frequency: Array
    error: Array
    slope: Array
    fields: Complex
    energy: Array


@dataclass(frozen=True)
class RibbonModel:
    """Modes of a ribbon at any phase along it.

    fine : the model that answers; coarse : of lower orders, for the error estimate
    """

    ribbon: Ribbon
    resolution: Resolution
    fine: RibbonPencil
    coarse: RibbonPencil

    @classmethod
    @definite()
    def of(cls, ribbon: Ribbon, resolution: Resolution) -> RibbonModel:
        """Condense each different tile once for either, and join them."""
        steps, block = resolution.steps, resolution.block
        fine, coarse = (
            RibbonPencil.of(ribbon, Tiling.condensed(ribbon, plans, steps, block, measured=False))
            for plans in (resolution.plans(ribbon), resolution.lowered(ribbon))
        )
        return cls(ribbon, resolution, fine, coarse)

    def frequencies(self, kappa: float, low: float, high: float) -> Array:
        """(k,) Hz of all modes between two frequencies, without anything else."""
        _, values, _ = eigenpairs_within(*self.fine.at(kappa), *_squares(low, high))
        return hertz(values)

    def solve(self, kappa: float, low: float, high: float) -> RibbonModes:
        """All modes between two frequencies (Hz) at a phase (rad) along the ribbon."""
        below, values, modes = eigenpairs_within(*self.fine.at(kappa), *_squares(low, high))
        frequency, fields = hertz(values), self.fine.expanded(modes, kappa)
        if not len(frequency):
            none = np.empty(0)
            return RibbonModes(
                kappa=kappa,
                frequency=none,
                error=none,
                slope=none,
                fields=fields,
                energy=np.empty((0, *self.ribbon.guide.shape)),
            )
        distance = np.abs(self._lower(kappa, low, high, below, len(frequency)) - frequency)
        every = np.ones(len(frequency), dtype=bool)
        error = self.resolution.estimate(self.ribbon, frequency, distance, every)
        error += interior_error(values, self._summed("truncation", fields).sum(axis=(1, 2)))
        stiffer, heavier = self.fine.at(kappa, slope=True)
        slope = np.einsum("nk,nk->k", modes.conj(), stiffer.times(modes)).real
        slope -= values * np.einsum("nk,nk->k", modes.conj(), heavier.times(modes)).real
        return RibbonModes(
            kappa=kappa,
            frequency=frequency,
            error=error,
            slope=slope / (8 * np.pi**2 * frequency),
            fields=fields,
            energy=self._summed("mass", fields),
        )

    def _lower(self, kappa: float, low: float, high: float, below: int, count: int) -> Array:
        """(count,) Hz, modes of the lower orders by their rank among all, the first of them ``below``."""
        pencil, below_low, above_high = self.coarse.at(kappa), WIDER, WIDER
        while True:
            ends = _squares(max(1 - below_low, LEAST) * low, (1 + above_high) * high)
            first, values, _ = eigenpairs_within(*pencil, *ends)
            if first <= below and first + len(values) >= below + count:
                return hertz(values[below - first : below - first + count])
            below_low *= 2 if first > below else 1
            above_high *= 2 if first + len(values) < below + count else 1

    def _summed(self, form: str, fields: Complex) -> Array:
        """(k, lines, columns) what the tiles' forms are on fields (t + m, k), by cell."""
        tiling = self.fine.tiling
        found = np.zeros((*self.ribbon.guide.shape, fields.shape[1]))
        places = self.ribbon.place_of_tile.T
        for number, (own, (line, column)) in enumerate(zip(tiling.own, places, strict=True)):
            tile = tiling.tiles[number]
            mine = fields[own]
            trace = tiling.joint.turned(number, mine[: tile.trace_size], back=True)
            found[line, column] += on_each(
                getattr(tile, form), np.concatenate([trace, mine[tile.trace_size :]])
            )
        return np.moveaxis(found, -1, 0)


def _squares(low: float, high: float) -> tuple[float, float]:
    return (2 * np.pi * low) ** 2, (2 * np.pi * high) ** 2


def bulk_bands(model: BlochModel, ribbon: Ribbon, kappa: Sequence[float]) -> Array:
    """(kappa, bands, 2) Hz, lowest and highest frequency of each bulk band at phases along a ribbon.

    Of the phases across `ACROSS` are looked at, so that an edge between them may lie a little farther out.
    """
    across = np.linspace(-np.pi, np.pi, ACROSS)
    found = np.array([
        [model.frequencies(one) for one in ribbon.phases(along, across)] for along in kappa
    ])  # fmt: skip
    return np.stack([found.min(axis=1), found.max(axis=1)], axis=-1)
