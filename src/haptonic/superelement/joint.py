"""Joints of the rims of tiles, within a cell and across its borders."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array, Fields, Ints
from haptonic.cell import Period, PlacedTile, UnitCell
from haptonic.cell.tile import HALF_TURNED, MEET
from haptonic.errors import GeometryError
from haptonic.lattice import Operation


def repeated(position: Array, vectors: Array) -> tuple[Ints, Ints]:
    """Find places (n, 2) that are equal up to translations (d, 2), two of a lattice or one of a ribbon.

    The master of equal places has the least sum of lattice coordinates, then the least second coordinate.

    Returns
    -------
    (n,) number of each place's master, and (n, d) integer translation from the master to the place
    """
    whole, same = steps_between(position, position, vectors)
    order = len(position) * (-2 * len(position) * whole.sum(axis=2) - whole[..., -1])
    rank = np.where(same, order + np.arange(len(position)), np.inf)
    master = rank.argmin(axis=1)
    return master, whole[np.arange(len(position)), master].astype(np.int64)


def steps_between(places: Array, others: Array, vectors: Array) -> tuple[Array, NDArray[np.bool_]]:
    """(n, m, d) rounded translations from the others to the places, and (n, m) True for integer ones."""
    steps: Array = places[:, None] - others
    inverse = np.asarray(np.linalg.pinv(vectors), dtype=np.float64)
    whole: Array = np.round(steps @ inverse)
    pitch = float(np.linalg.norm(vectors, axis=1).max())
    apart = np.linalg.norm(steps - whole @ vectors, axis=2)
    return whole, np.asarray(apart < MEET * pitch)


@dataclass(frozen=True, eq=False)
class Joint:
    """Traces of a period's tiles; the trace of the period contains them one after the other.

    period : a cell, or a period of a ribbon; placed : its tiles; levels : number of levels of all traces
    position : (places,) of all rims, m; ends : number of places up to the end of each tile's rim
    """

    period: Period
    placed: tuple[PlacedTile, ...]
    levels: int
    position: Array
    ends: Ints

    @classmethod
    def of(cls, period: Period, placed: Sequence[PlacedTile], rims: Sequence[Array], levels: int) -> Joint:
        """Join tiles, given the places (n, 3) of their rims in the tiles' axes, m.

        Raises
        ------
        GeometryError : edges do not meet
        """
        places = [tile.points(rim)[:, :2] for tile, rim in zip(placed, rims, strict=True)]
        joint = cls(
            period=period,
            placed=tuple(placed),
            levels=levels,
            position=np.concatenate(places),
            ends=np.cumsum([len(p) for p in places]),
        )
        alone = np.bincount(joint.master)[joint.master] == 1
        starts = np.concatenate([[0], joint.ends])
        for end in period.free_edges:
            edge = slice(starts[end.first], starts[end.beyond])
            there = joint.position[edge]
            alone[edge] &= end.step is not None and ~steps_between(there, there + end.step, period.vectors)[
                1
            ].any(axis=1)
        if alone.any():
            raise GeometryError.mismatch(
                argument="tiles",
                given=f"{alone.sum()} of {len(alone)} places that no other tile has",
                allowed="tiles that cover the plane, edge to edge, with equal nodes on common edges",
                cause="edges of two tiles do not meet, or their meshes differ there",
                next_step="make the tiles fill the period, and give them plans of equal order and blocks",
            )
        return joint

    @property
    def cell(self) -> UnitCell:
        """The period, if it is a cell."""
        assert isinstance(self.period, UnitCell), "a ribbon is not a cell"
        return self.period

    @cached_property
    def _repeated(self) -> tuple[Ints, Ints]:
        return repeated(self.position, self.period.vectors)

    @property
    def master(self) -> Ints:
        """(places,) number of each place's master, see `repeated`."""
        return self._repeated[0]

    @property
    def shift(self) -> Ints:
        """(places, d) integer translation from the master, see `repeated`."""
        return self._repeated[1]

    @property
    def size(self) -> int:
        """Number of unknowns of all traces."""
        return 3 * self.levels * len(self.position)

    @cached_property
    def unknowns(self) -> Ints:
        """(levels, places, 3) numbers of the unknowns."""
        starts = np.concatenate([[0], self.ends])
        pieces = [
            3 * self.levels * start + np.arange(3 * self.levels * count).reshape(self.levels, count, 3)
            for start, count in zip(starts, np.diff(starts), strict=False)
        ]
        return np.concatenate(pieces, axis=1)

    def of_tile(self, number: int) -> slice:
        """Unknowns of one tile's trace."""
        start = self.ends[number - 1] if number else 0
        return slice(3 * self.levels * int(start), 3 * self.levels * int(self.ends[number]))

    def turned(self, number: int, rows: Fields, *, back: bool = False) -> Fields:
        """Transform motions (n, k) of a tile's trace from the tile's axes to the cell's, or back."""
        placed = self.placed[number]
        if not placed.is_turned:
            return rows
        turn = placed.turn.T if back else placed.turn
        return np.asarray(turn @ rows.reshape(-1, 3, rows.shape[1])).reshape(rows.shape)

    def form(self, number: int, own: Array, traces: int) -> Array:
        """Transform a form of a tile, whose first unknowns are its trace, to the cell's axes."""
        if not self.placed[number].is_turned:
            return own
        for _ in range(2):
            own = np.vstack([self.turned(number, own[:traces]), own[traces:]]).T
        return own

    def image(self, operation: Operation) -> JointImage:
        """Action of an operation of the cell on traces."""
        mapped = self.cell.site_map(operation)
        assert mapped is not None, "no symmetry of this cell"
        lattice = self.cell.lattice
        turn = lattice.point_group.turn(operation)
        # position of each place before the operation
        before = (self.position - mapped.move @ lattice.vectors) @ turn[:2, :2]
        whole, same = steps_between(before, self.position, lattice.vectors)
        rank = np.where(same, np.abs(whole).sum(axis=2), np.inf)
        source = rank.argmin(axis=1)
        assert np.isfinite(rank.min(axis=1)).all(), "the operation does not leave the rims as they are"
        twice = mapped.move @ np.array(operation).T + mapped.move
        return JointImage(
            joint=self, turn=turn, source=source, shift=whole[np.arange(len(source)), source], twice=twice
        )


@dataclass(frozen=True, eq=False)
class JointImage:
    """Mirror, glide mirror or half-turn of traces of Bloch waves: ``turn u(g^-1 x)``.

    turn : (3, 3); source : (places,) place whose motion each place has afterwards
    shift : (places, 2) translations between the two; twice : (2,) translation of the operation done twice
    """

    joint: Joint
    turn: Array
    source: Ints
    shift: Array
    twice: Array

    def applied(self, trace: Fields, kappa: Array) -> Fields:
        """Image of (t, k) traces at phases (2,) whose double changes nothing."""
        unknowns = self.joint.unknowns
        phase = np.exp(1j * (self.shift @ kappa + 0.5 * self.twice @ kappa))
        moved = trace[unknowns[:, self.source]] * phase[:, None, None]
        image = np.empty(trace.shape, dtype=complex)
        image[unknowns] = self.turn @ moved
        return image

    def half_turned(self) -> tuple[Ints, Array, Array]:
        """Source (t,) of each unknown's motion, its sign (t,) and its translation (t, 2)."""
        assert np.array_equal(self.turn, HALF_TURNED)
        unknowns = self.joint.unknowns
        source, sign, shift = (
            np.empty(self.joint.size, int),
            np.empty(self.joint.size),
            np.empty((self.joint.size, 2)),
        )
        source[unknowns] = unknowns[:, self.source]
        sign[unknowns] = np.diag(self.turn)
        shift[unknowns] = self.shift[:, None]
        return source, sign, shift
