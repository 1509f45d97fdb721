"""Modes of a ribbon within a range of frequencies, each with an error estimate.

The crystals next to a guide, or on both sides of an edge between two crystals, have bulk bands. At a fixed
phase along the ribbon these cover intervals of frequency for all phases across. Modes between them are
localised at the guide or the edge and decay into the crystals.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from haptonic.arrays import Array, Complex, Ints
from haptonic.bloch.chain import BlockChain, eigenpairs_within
from haptonic.bloch.model import BlochModel
from haptonic.bloch.pencil import Periodic, change_in_hertz, error_in_hertz, hertz
from haptonic.bloch.resolution import Resolution
from haptonic.bloch.truncation import interior_error
from haptonic.cell import Ribbon
from haptonic.later import sparse as sp
from haptonic.superelement import Superelement, Tiling, definite, missing_energy, on_each

ACROSS = 33  # phases across, at which bulk bands are sampled
WIDER = 0.03  # share of a frequency, first search range in the stiffened pencil
LEAST = 1e-3  # share of the lowest frequency; only rigid motions lie below


@dataclass(frozen=True)
class RibbonPencil:
    """Stiffness and mass of one period of a ribbon in blocks, by columns from left to right.

    periodic : relation of free unknowns to all; order : (n,) free unknowns in the order of their blocks
    own, off : diagonal blocks and blocks to the next; for each step 0 and 1, and for ``off`` -1, of the phase
        factor exp(i step kappa), stiffness and mass (2, n, m)
    """

    tiling: Tiling
    periodic: Periodic
    order: Ints
    own: tuple[dict[int, Array], ...]
    off: tuple[dict[int, Array], ...]

    @classmethod
    def of(cls, ribbon: Ribbon, tiling: Tiling, *, stiffened: bool = False) -> RibbonPencil:
        """Assign each free unknown to the block of its first column.

        stiffened : whether the surplus of tiles is added to their stiffness
        """
        periodic = Periodic.of(tiling)
        column = np.full(len(periodic.free), len(ribbon.first))
        for unknowns, number in zip(tiling.own, ribbon.place_of_tile[1], strict=True):
            np.minimum.at(column, periodic.number[unknowns], number)
        block = column // ribbon.reach
        order = np.argsort(block, kind="stable")
        sizes = np.bincount(block)
        place = np.empty(len(order), dtype=np.int64)
        place[order] = np.concatenate([np.arange(size) for size in sizes])
        diagonal: list[dict[int, Array]] = [{} for _ in sizes]
        beside: list[dict[int, Array]] = [{} for _ in sizes[1:]]
        for number, unknowns in enumerate(tiling.own):
            tile = tiling.tiles[number]
            stiffness = tile.stiffness + tile.surplus[:2].sum(axis=0) if stiffened else tile.stiffness
            forms = [tiling.joint.form(number, form, tile.trace_size) for form in (stiffness, tile.mass)]
            free, shift = periodic.number[unknowns], periodic.shift[unknowns, 0]
            groups = {
                (int(g), int(s)): np.flatnonzero((block[free] == g) & (shift == s))
                for g in np.unique(block[free])
                for s in np.unique(shift[block[free] == g])
            }
            for (g, s), rows in groups.items():
                for (h, t), columns in groups.items():
                    if h < g or (h == g and t < s):
                        continue  # adjoint of the opposite block
                    assert h <= g + 1, "tiles touch columns beyond the next block"
                    by_step = diagonal[g] if h == g else beside[g]
                    total = by_step.setdefault(t - s, np.zeros((2, sizes[g], sizes[h])))
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
            total: Complex = sum(factors[s] * block[which] for s, block in parts.items())
            return total

        def hermitian(parts: dict[int, Array], which: int) -> Complex:
            still = 0.0 if slope else parts[0][which]
            moved = {s: block for s, block in parts.items() if s}
            half = summed(moved, which) if moved else np.zeros_like(parts[0][which], dtype=complex)
            return np.asarray(still + half + half.conj().T)

        stiffness, mass = (
            BlockChain(
                tuple(hermitian(blocks, which) for blocks in self.own),
                tuple(summed(blocks, which) for blocks in self.off),
            )
            for which in (0, 1)
        )
        return stiffness, mass

    def slope(self, kappa: float, values: Array, modes: Complex) -> Array:
        """(k,) derivatives (Hz/rad) of the frequencies of modes (n, k) with respect to the phase."""
        stiffer, heavier = self.at(kappa, slope=True)
        slope = np.einsum("nk,nk->k", modes.conj(), stiffer.times(modes)).real
        slope -= values * np.einsum("nk,nk->k", modes.conj(), heavier.times(modes)).real
        return change_in_hertz(slope, hertz(values))

    def expanded(self, modes: Complex, kappa: float) -> Complex:
        """(t + m, k) unknowns of the tiling from modes (n, k) in the order of the blocks."""
        free = np.empty_like(modes)
        free[self.order] = modes
        return self.periodic.expanded(free, np.array([kappa]))


def _spread(places: Ints, size: int) -> sp.csr_array:
    """(size, n) sparse matrix that adds entries of equal places."""
    count = len(places)
    return sp.csr_array((np.ones(count), (places, np.arange(count))), shape=(size, count))


@dataclass(frozen=True)
class RibbonModes:
    """Modes of a ribbon at one phase along it, lowest first.

    kappa : rad; frequency, error : (k,) Hz; the error bounds the distance to the exact frequency
    slope, slope_error : (k,) derivatives of the frequency with respect to the phase, Hz/rad; the error is an
        estimate from the slopes of the stiffened pencil
    fields : (t + m, k) unknowns of the tiling, unit mass
    energy, stiffened_energy : (k, lines, columns) energy of each cell, and in the stiffened pencil
    remaining : errors of the frequencies as a multiple of their distances to the stiffened pencil
    """

    kappa: float
    frequency: Array
    error: Array
    slope: Array
    slope_error: Array
    fields: Complex
    energy: Array
    stiffened_energy: Array
    remaining: float


@dataclass(frozen=True)
class RibbonModel:
    """Modes of a ribbon at any phase along it.

    fine : pencil
    stiffened : the same with the surplus as additional stiffness, whose modes differ about as those of orders
        one lower, for errors of group velocity and decay
    """

    ribbon: Ribbon
    resolution: Resolution
    fine: RibbonPencil
    stiffened: RibbonPencil

    @classmethod
    @definite()
    def of(cls, ribbon: Ribbon, resolution: Resolution) -> RibbonModel:
        """Condense each different tile, and join them."""
        tiling = Tiling.condensed(
            ribbon, resolution.plans(ribbon), resolution.steps, resolution.block, measured=False
        )
        fine, stiffened = (RibbonPencil.of(ribbon, tiling, stiffened=which) for which in (False, True))
        return cls(ribbon, resolution, fine, stiffened)

    def frequencies(self, kappa: float, low: float, high: float) -> Array:
        """(k,) frequencies of all modes between two frequencies, Hz, without fields and errors."""
        _, values, _ = eigenpairs_within(*self.fine.at(kappa), *_squares(low, high))
        return hertz(values)

    def solve(self, kappa: float, low: float, high: float) -> RibbonModes:
        """Compute all modes between two frequencies (Hz) at a phase (rad) along the ribbon."""
        below, values, modes = eigenpairs_within(*self.fine.at(kappa), *_squares(low, high))
        frequency, fields = hertz(values), self.fine.expanded(modes, kappa)
        if not len(frequency):
            none, nowhere = np.empty(0), np.empty((0, *self.ribbon.guide.shape))
            return RibbonModes(
                kappa=kappa,
                frequency=none,
                error=none,
                slope=none,
                slope_error=none,
                fields=fields,
                energy=nowhere,
                stiffened_energy=nowhere,
                remaining=0.0,
            )
        stiff_values, stiff_modes = self._of_ranks(kappa, low, high, below, len(frequency))
        surplus = (self._summed(self.fine, _surplus(number), fields).sum(axis=(1, 2)) for number in range(3))
        error = error_in_hertz(missing_energy(*surplus), frequency)
        remaining = _root_mean_square(error) / _root_mean_square(hertz(stiff_values) - frequency)
        left_out = self._summed(self.fine, lambda tile: tile.truncation, fields).sum(axis=(1, 2))
        error += interior_error(values, left_out)
        slope = self.fine.slope(kappa, values, modes)
        apart = np.abs(self.stiffened.slope(kappa, stiff_values, stiff_modes) - slope)
        # as of a frequency, and the relative error of the frequency, because both scale with the stiffness
        slope_error = remaining * (apart + _root_mean_square(apart))
        return RibbonModes(
            kappa=kappa,
            frequency=frequency,
            error=error,
            slope=slope,
            slope_error=slope_error + error / frequency * np.abs(slope),
            fields=fields,
            energy=self._summed(self.fine, lambda tile: tile.mass, fields),
            stiffened_energy=self._summed(
                self.stiffened, lambda tile: tile.mass, self.stiffened.expanded(stiff_modes, kappa)
            ),
            remaining=remaining,
        )

    def _of_ranks(
        self, kappa: float, low: float, high: float, below: int, count: int
    ) -> tuple[Array, Complex]:
        """Eigenvalues (count,) and modes (n, count) of the stiffened pencil, by rank from ``below`` on."""
        pencil, below_low, above_high = self.stiffened.at(kappa), WIDER, WIDER
        while True:
            ends = _squares(max(1 - below_low, LEAST) * low, (1 + above_high) * high)
            first, values, modes = eigenpairs_within(*pencil, *ends)
            if first <= below and first + len(values) >= below + count:
                chosen = slice(below - first, below - first + count)
                return values[chosen], modes[:, chosen]
            below_low *= 2 if first > below else 1
            above_high *= 2 if first + len(values) < below + count else 1

    def _summed(
        self, pencil: RibbonPencil, form_of: Callable[[Superelement], Array], fields: Complex
    ) -> Array:
        """(k, lines, columns) values of a form of the tiles on fields (t + m, k), by cell."""
        tiling = pencil.tiling
        values = np.zeros((*self.ribbon.guide.shape, fields.shape[1]))
        places = self.ribbon.place_of_tile.T
        for number, (unknowns, (line, column)) in enumerate(zip(tiling.own, places, strict=True)):
            tile = tiling.tiles[number]
            of_tile = fields[unknowns]
            trace = tiling.joint.turned(number, of_tile[: tile.trace_size], back=True)
            values[line, column] += on_each(
                form_of(tile), np.concatenate([trace, of_tile[tile.trace_size :]])
            )
        return np.moveaxis(values, -1, 0)


def _surplus(number: int) -> Callable[[Superelement], Array]:
    return lambda tile: np.asarray(tile.surplus[number])


def _root_mean_square(values: Array) -> float:
    return float(np.sqrt((values**2).mean()))


def _squares(low: float, high: float) -> tuple[float, float]:
    return (2 * np.pi * low) ** 2, (2 * np.pi * high) ** 2


def bulk_bands(model: BlochModel, ribbon: Ribbon, kappa: Sequence[float]) -> Array:
    """(kappa, bands, 2) Hz, lowest and highest frequency of each bulk band at phases along a ribbon.

    `ACROSS` phases across are sampled; an edge between them may lie slightly farther out.
    """
    across = np.linspace(-np.pi, np.pi, ACROSS)
    frequencies = np.array([
        [model.frequencies(phases) for phases in ribbon.phases(along, across)] for along in kappa
    ])  # fmt: skip
    return np.stack([frequencies.min(axis=1), frequencies.max(axis=1)], axis=-1)
