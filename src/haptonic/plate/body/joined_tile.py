"""Joining of many equal tiles to one tile with fewer unknowns."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from haptonic.arrays import Array, Fields, Ints
from haptonic.plate.body.skeleton import TraceOrders, traced
from haptonic.plate.body.tile import Tile, Turned
from haptonic.plate.layout.grid import Block
from haptonic.plate.layout.keys import PLATE
from haptonic.superelement import with_all_modes
from haptonic.superelement.interior import MISSED


def joined_tile(
    tile: Tile,
    size: tuple[float, float],
    shape: tuple[int, int],
    orders: TraceOrders,
    highest: float,
    span: tuple[int, int] = (1, 1),
    missed: float = MISSED,
) -> Tile:
    """Join a rectangle of equal tiles to one tile for frequencies up to ``highest`` (Hz).

    Parameters
    ----------
    tile : repeated tile; size : its width and height, m
    shape : number of rows and columns of tiles
    span : rows and columns of each tile itself
    """
    high, wide = span
    rows, columns = shape
    x = np.linspace(0.0, size[0] * columns, wide * columns + 1)
    y = np.linspace(0.0, size[1] * rows, high * rows + 1)
    whole = Block((0, high * rows), (0, wide * columns))
    singles = [
        Block((high * i, high * (i + 1)), (wide * j, wide * (j + 1)))
        for i in range(rows)
        for j in range(columns)
    ]
    (outer, *traces), first_mode = traced(x, y, [whole, *singles], orders)
    modes = len(tile.values)
    unknowns = [
        np.concatenate([trace, first_mode + k * modes + np.arange(modes)]) for k, trace in enumerate(traces)
    ]
    count = first_mode + modes * len(traces)
    stiffness, mass = np.zeros((2, count, count))
    for numbers in unknowns:
        stiffness[np.ix_(numbers, numbers)] += tile.elastic
        mass[np.ix_(numbers, numbers)] += tile.mass
    body = with_all_modes(stiffness, mass, outer).with_few_modes(highest, missed)
    inside = Joined(tile, size, shape, np.stack([body.fields[numbers] for numbers in unknowns]))
    return Tile.plain(body, inside)


def opened_tile(tile: Tile, open_trace: Ints, highest: float, missed: float = MISSED) -> Tile:
    """Condense free unknowns of a tile's trace into the tile, for frequencies up to ``highest`` (Hz).

    open_trace : unknowns of the trace at free edges of the plate, without supports
    """
    assert list(tile.stiffness) == [PLATE]
    closed = np.setdiff1d(np.arange(tile.trace_size), open_trace)
    body = with_all_modes(tile.elastic, tile.mass, closed).with_few_modes(highest, missed)
    return Tile.plain(body, Turned(tile.inside, body.fields))


@dataclass(frozen=True, eq=False)
class Joined:
    """Inside of many equal tiles. basis : (tiles, n of each, unknowns), row by row from the lower left"""

    tile: Tile
    size: tuple[float, float]
    shape: tuple[int, int]
    basis: Array

    @property
    def _corners(self) -> Array:
        """(tiles, 2) lower left corners, m."""
        rows, columns = np.indices(self.shape).reshape(2, -1)
        return np.stack([columns * self.size[0], rows * self.size[1]], axis=-1)

    @property
    def points(self) -> Array:
        own, corners = self.tile.inside.points, self._corners
        shift = np.column_stack([corners, np.zeros(len(corners))])
        return np.asarray((shift[:, None] + own).reshape(-1, 3))

    @property
    def subcells(self) -> Ints:
        own, start = self.tile.inside.subcells, len(self.tile.inside.points)
        return np.concatenate([own + k * start for k in range(len(self.basis))])

    def lifted(self, unknowns: Fields) -> Fields:
        return np.concatenate([self.tile.inside.lifted(own @ unknowns) for own in self.basis])

    def normal_at(self, where: Array) -> Array:
        rows, columns = self.shape
        column = np.clip((where[:, 0] / self.size[0]).astype(np.int64), 0, columns - 1)
        row = np.clip((where[:, 1] / self.size[1]).astype(np.int64), 0, rows - 1)
        number = row * columns + column
        # points on a border lie beyond it after rounding
        local = np.clip(where - self._corners[number], 0.0, self.size)
        own = self.tile.inside.normal_at(local)
        out = np.empty((len(where), self.basis.shape[2]))
        for k in np.unique(number):
            out[number == k] = own[number == k] @ self.basis[k]
        return out
