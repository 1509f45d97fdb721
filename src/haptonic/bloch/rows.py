"""Condensed rows of a lattice: slabs at any phase along the rows, and decay of waves across them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np

from haptonic.arrays import Array, Complex
from haptonic.bloch.evanescent import Slab, Waves, bloch_waves, decibels
from haptonic.bloch.resolution import Resolution, fitted, meeting
from haptonic.cell import Filler, MeshPlan, Rows, TileShape, UnitCell
from haptonic.cell.tile import MEET
from haptonic.errors import ResourceError
from haptonic.superelement import Superelement, Tiling, condense, condense_solid, steps_between
from haptonic.superelement.tiling import directions
from haptonic.superelement.trace import trace_levels

# Bytes per pair of unknowns on a face: three complex forms on two and a half times as many unknowns, for each
# number of rows of a slab. At 2.5 GB each frequency takes some minutes.
PER_PAIR, MOST_MEMORY = 300, 2.5e9


@dataclass(frozen=True, eq=False)
class CondensedRows:
    """Rows of a lattice in one direction, and plain plate between their faces and straight ones.

    A slab consists of `Rows.reach` rows, the distance of the farthest rows that touch each other.

    rows : one slab of the lattice
    blocks : slabs with 1, 2, ... rows of the lattice and otherwise plain plate; the last is the lattice
    fillers : on the left and on the right of the rows; empty if the faces are straight
    """

    rows: Rows
    blocks: tuple[tuple[Rows, Tiling], ...]
    fillers: tuple[tuple[Filler, Tiling], ...]

    @classmethod
    def of(cls, cell: UnitCell, resolution: Resolution, along: tuple[int, int] = (0, 1)) -> CondensedRows:
        """Mesh and condense each different tile once.

        Raises
        ------
        GeometryError : a direction of zero length, or not the shortest one
        """
        rows = Rows(cell, along)
        blocks, fillers = _periods(rows)
        tiles = list(dict.fromkeys(placed.tile for placed in cell.tiles))
        every = [placed.tile for block in blocks for placed in block.tiles]
        every += [placed.tile for filler in fillers for placed in filler.tiles]
        plain = [tile for tile in dict.fromkeys(every) if tile not in tiles]
        plans = meeting(tiles, [resolution.plan(tile, tile.area / cell.area) for tile in tiles])
        plans += tuple(fitted(resolution.plan(tile, tile.area / cell.area), plans[0]) for tile in plain)

        condensed = {
            tile: _condensed(tile, plan, resolution)
            for tile, plan in zip([*tiles, *plain], plans, strict=True)
        }
        return cls.joined(rows, condensed)

    @classmethod
    def joined(cls, rows: Rows, condensed: Mapping[TileShape, Superelement]) -> CondensedRows:
        """Join condensed tiles, given by tile."""

        def join(period: Rows | Filler) -> Tiling:
            return Tiling.of(period, period.tiles, [condensed[placed.tile] for placed in period.tiles])

        blocks, fillers = _periods(rows)
        return cls(
            rows, tuple((block, join(block)) for block in blocks), tuple((end, join(end)) for end in fillers)
        )

    @property
    def levels(self) -> int:
        """Number of levels of the trace through the thickness."""
        return self.blocks[0][1].joint.levels

    @property
    def plan(self) -> MeshPlan:
        """Mesh plan of the first tile."""
        return self.blocks[0][1].tiles[0].mesh.topology.plan

    @cached_property
    def face(self) -> Array:
        """(n, 2) places of the left face of a slab, sorted along it, m."""
        joint = self.blocks[-1][1].joint
        places = joint.position[np.unique(joint.master)]
        _, same = steps_between(places, places - self._wide, self.rows.vectors)
        return self._ordered(places[same.any(axis=1)])

    @cached_property
    def line(self) -> Array:
        """(n, 2) places of the straight line on the left of the rows, sorted along it, m."""
        if not self.fillers:
            return self.face
        filler, tiling = self.fillers[0]
        places = tiling.joint.position[np.unique(tiling.joint.master)]
        away = np.abs(places @ self.rows.turn[0] - filler.line)
        return self._ordered(places[away < MEET * self.rows.cell.lattice.pitch])

    @property
    def setback(self) -> float:
        """Distance from that line to the average left face of the rows, m; 0 for a straight face."""
        return self.rows.middle - self.fillers[0][0].line if self.fillers else 0.0

    @property
    def harmonics(self) -> int:
        """Number of tangential wavenumbers that the places of the line resolve at their largest distance."""
        wide = np.ptp(self.rows.sides[..., 1], axis=1)
        return int(len(self.face) / len(wide) * self.rows.period / wide.max() + 1e-6)

    @property
    def _wide(self) -> Array:
        """(2,) vector from face to face of a slab, m."""
        return np.asarray(self.rows.reach * self.rows.step)

    def _ordered(self, places: Array) -> Array:
        """Move places into one period, and sort them along it."""
        along = places @ self.rows.turn[1] / self.rows.period
        whole = np.floor(along - along.min() + MEET)
        places, along = places - whole[:, None] * self.rows.vectors, along - whole
        return np.asarray(places[np.argsort(along)])

    def slabs(self, phase: float) -> tuple[Slab, ...]:
        """Slabs of all blocks at a phase (rad) along the rows."""
        return tuple(self._slab(number, phase) for number in range(len(self.blocks)))

    def slab(self, phase: float) -> Slab:
        """Slab of the lattice at a phase (rad) along the rows."""
        return self._slab(-1, phase)

    def _slab(self, number: int, phase: float) -> Slab:
        rows, tiling = self.blocks[number]
        return Slab.of(tiling, phase, self.face, self.face + self._wide, rows.lossy)

    def ends(self, phase: float) -> tuple[Slab, ...]:
        """Slabs of plain plate on the left and on the right of the rows; empty for straight faces."""
        if not self.fillers:
            return ()
        (left, first), (right, last) = self.fillers
        line = self.line + (right.line - left.line) * self.rows.turn[0]
        return (
            Slab.of(first, phase, self.line, self.face, [False] * len(first.tiles)),
            Slab.of(last, phase, self.face, line, [False] * len(last.tiles)),
        )

    def decay(self, waves: Waves) -> float:
        """Decay of the least attenuated wave to the right, dB per row; 0 if it propagates."""
        return decibels(waves) / self.rows.reach

    def exponents(self, waves: Waves, phase: float) -> Complex:
        """(w,) complex exponents from row to row of waves across slabs at a phase along the rows.

        The exponents of a slab allow several values; the motion of places of one face at a distance of one
        row determines the correct value.
        """
        reach, rows = self.rows.reach, self.rows
        if reach == 1:
            return waves.exponent
        whole, same = steps_between(self.face, self.face + rows.step, rows.vectors)
        there, origin = np.nonzero(same)
        motion = waves.displacement.reshape(self.levels, len(self.face), 3, -1)
        turn = np.exp(-1j * phase * whole[there, origin, 0])[:, None, None]
        seen = (motion[:, origin].conj() * motion[:, there] * turn).sum(axis=(0, 1, 2))
        possible = (waves.exponent[:, None] + 2j * np.pi * np.arange(reach)) / reach
        away = np.abs(np.exp(1j * possible.imag) - np.exp(1j * np.angle(seen))[:, None])
        exponents = np.take_along_axis(possible, away.argmin(axis=1)[:, None], axis=1)[:, 0]
        return np.asarray(exponents.real + 1j * np.angle(np.exp(1j * exponents.imag)))


@lru_cache(maxsize=4)
def _condensed(tile: TileShape, plan: MeshPlan, resolution: Resolution) -> Superelement:
    """Condense a tile, cached for rows along another direction with the same tiles."""
    condense_tile = condense if tile.solid is None else condense_solid
    return condense_tile(
        tile, plan, resolution.steps, block=directions(tile, resolution.block), measured=False
    )


def rows_need(rows: Rows, resolution: Resolution) -> tuple[int, float]:
    """Number of unknowns on a face (time per frequency grows with its cube), and memory, bytes.

    Raises
    ------
    ResourceError : slabs need more memory than `MOST_MEMORY`
    """
    plan = resolution.plans(rows.cell)[0]
    size = 3 * trace_levels(plan) * plan.rim_nodes // plan.sides * len(rows.sides)
    memory = PER_PAIR * rows.reach * size**2
    if memory > MOST_MEMORY:
        raise ResourceError.too_large(
            argument=f"{rows.table}.along",
            given=f"{list(rows.along)}",
            allowed=f"rows for which {MOST_MEMORY / 1e9:g} GB are enough",
            cause=f"about {memory / 1e9:.2g} GB would be needed: such a row repeats only after "
            f"{rows.period * 1e3:.3g} mm, and touches the {rows.reach} rows beside it",
            next_step="choose smaller whole numbers, such as [0, 1], or a lower accuracy",
        )
    return size, memory


def _periods(rows: Rows) -> tuple[tuple[Rows, ...], tuple[Filler, ...]]:
    """Slabs with 1, 2, ... rows of the lattice, the last one the rows themselves, and the fillers."""
    parts = tuple(Rows(rows.cell, rows.along, filled) for filled in range(1, rows.reach))
    return (*parts, rows), () if rows.is_straight else (Filler(rows, -1), Filler(rows, 1))


def attenuation(rows: CondensedRows, omega: Array, phases: Array, loss_factor: float = 0.0) -> Array:
    """(frequencies, phases) decay of the least attenuated wave, dB per row; 0 where a wave propagates.

    omega : (frequencies,) rad/s; phases : (phases,) along the rows, rad
    """
    decays = np.empty((len(omega), len(phases)))
    for column, phase in enumerate(phases):
        slab = rows.slab(float(phase))
        for number, at in enumerate(omega):
            right, _ = bloch_waves(slab.at(float(at), loss_factor), float(at))
            decays[number, column] = rows.decay(right)
    return decays
