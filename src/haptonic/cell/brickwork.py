"""A lattice laid in rows of bricks: rectangles along x and y, each about one pillar.

A finite plate consists of rectangles, so a lattice whose own tiles are none is cut anew: halfway between its
rows, and in each row halfway between its pillars. What is cut is the same plate; where a row is offset
against the next, bricks lie as in a wall.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from itertools import product

import numpy as np

from haptonic.cell.geometry import LEAST_CLEARANCE, UnitCell
from haptonic.cell.tile import SiteTile
from haptonic.errors import GeometryError
from haptonic.lattice import SAME, Lattice

MOST_TRANSLATIONS = 4  # of either kind, that may lead along x to the next pillar of a row
FINEST = 48  # denominator of a share of a period, up to which it is taken for a fraction
MOST_PIECES = 4  # of a side of a brick; more would be finer than its mesh


@dataclass(frozen=True)
class Brick:
    """A rectangle about a pillar; all but the tile in shares of a `Brickwork`'s period or height.

    left : of its row's first bricks, from 0 to below 1; bottom : from 0
    tile : it about the pillar's axis
    """

    left: Fraction
    bottom: Fraction
    width: Fraction
    height: Fraction
    tile: SiteTile


@dataclass(frozen=True)
class Brickwork:
    """A lattice as bricks.

    period : along x, m; height : of a row of periods, m
    offset : of each row against the one below, in shares of the period
    bricks : of one period, row by row
    """

    period: float
    height: float
    offset: Fraction
    bricks: tuple[Brick, ...]

    @classmethod
    def of(cls, cell: UnitCell) -> Brickwork:
        """The rows of a lattice along x.

        Raises
        ------
        GeometryError : no row of pillars lies along x, rows are offset by another share than a half, a third
            or a quarter, or a pillar crosses the line halfway to the next
        """
        period, height, offset = _rows(cell.lattice)
        standing = [number for number, pillar in enumerate(cell.pillars) if pillar is not None]
        if not standing:
            return cls(period, height, offset, ())
        places = (cell.shares @ cell.lattice.vectors)[standing]
        up = np.array([_share(y / height) for y in places[:, 1]], dtype=object)
        rows = np.floor(up.astype(float) + SAME)
        across = [
            _share(x / period - float(offset) * row) % 1 for x, row in zip(places[:, 0], rows, strict=True)
        ]
        levels: dict[Fraction, list[tuple[Fraction, int]]] = {}
        for one, level, number in zip(across, up % 1, standing, strict=True):
            levels.setdefault(level, []).append((one, number))
        made, origin = [], None
        for level, below, above in _between(sorted(levels)):
            row = dict(levels[level])
            for place, before, after in _between(sorted(row)):
                origin = (before, below) if origin is None else origin
                tile = _tile(cell, row[place], ((place - before) * period, (after - place) * period),
                             ((level - below) * height, (above - level) * height))  # fmt: skip
                made.append(
                    Brick(
                        left=(before - origin[0]) % 1,
                        bottom=below - origin[1],
                        width=after - before,
                        height=above - below,
                        tile=tile,
                    )
                )
        return cls(period, height, offset, tuple(made))

    def left(self, number: int, row: int) -> Fraction:
        """Of a brick in some row of periods, in shares of the period from 0 to below 1."""
        return (self.bricks[number].left + row * self.offset) % 1

    def columns(self, row: int) -> set[Fraction]:
        """Where lines have to lie between the bricks of a row of periods, in shares of the period."""
        starts = {self.left(number, row): brick.width for number, brick in enumerate(self.bricks)}
        return {*starts, *((left + width) % 1 for left, width in starts.items())}

    @property
    def rows(self) -> set[Fraction]:
        """Where lines have to lie between its rows, in shares of the height."""
        return {brick.bottom for brick in self.bricks}


def _share(value: float) -> Fraction:
    """The fraction that a number nearly is, or the number itself."""
    near = Fraction(value).limit_denominator(FINEST)
    return near if abs(float(near) - value) < SAME else Fraction(value)


def _between(places: list[Fraction]) -> list[tuple[Fraction, Fraction, Fraction]]:
    """Every place of a period 1 with the middles between it and its neighbours."""
    before, after = [places[-1] - 1, *places[:-1]], [*places[1:], places[0] + 1]
    around = zip(before, places, after, strict=True)
    return [(one, (low + one) / 2, (one + high) / 2) for low, one, high in around]


def _rows(lattice: Lattice) -> tuple[float, float, Fraction]:
    """Period along x and height of the rows of a lattice, m, and the offset of each against the one below."""
    steps = np.array(list(product(range(-MOST_TRANSLATIONS, MOST_TRANSLATIONS + 1), repeat=2)))
    found = steps @ lattice.vectors
    flat = found[(np.abs(found[:, 1]) < SAME * lattice.pitch) & (found[:, 0] > SAME * lattice.pitch)]
    if not len(flat):
        raise _unsupported(lattice, "no row of its pillars lies along x")
    period = float(flat[:, 0].min())
    height = lattice.area / period
    above = found[np.abs(found[:, 1] - height) < SAME * lattice.pitch]
    offset = _share(float(above[0, 0]) / period) % 1
    if offset.denominator > MOST_PIECES:
        raise _unsupported(lattice, f"its rows are offset by {float(offset):.3g} of their period")
    return period, float(above[0, 1]), offset


def _tile(cell: UnitCell, number: int, x: tuple[float, float], y: tuple[float, float]) -> SiteTile:
    """A rectangle about a pillar, from what lies left and right, below and above of it, m."""
    (left, right), (below, above) = x, y
    corners = ((-left, -below), (right, -below), (right, above), (-left, above))
    pillar = cell.pillars[number]
    assert pillar is not None
    tile = SiteTile(
        outline=corners,
        period=max(left + right, below + above),
        thickness=cell.thickness,
        material=cell.material,
        pillar=pillar,
        faces=cell.faces,
    )
    room = tile.inradius - LEAST_CLEARANCE * cell.lattice.pitch
    if pillar.widest > room:
        at = f"cell.site[{number + 1}].pillar.diameter" if cell.site else "cell.pillar.diameter"
        beyond = 2 * (pillar.widest - pillar.radius)
        raise GeometryError.out_of_range(
            argument=at,
            given=f"{pillar.diameter * 1e3:.4g} mm"
            + (f", and {beyond * 1e3:.4g} mm more where it is widest" if beyond else ""),
            allowed=f"less than {(2 * room - beyond) * 1e3:.4g} mm in a plate",
            cause="a plate is cut halfway between rows of pillars, and this one crosses such a line",
            next_step="choose a thinner pillar or a larger pitch; bands, layers and ribbons have no such "
            "limit",
        )
    return tile


def _unsupported(lattice: Lattice, cause: str) -> GeometryError:
    return GeometryError.unsupported(
        argument="cell.lattice",
        given=lattice.name,
        allowed="a lattice with rows along x for a plate, each offset against the next by nothing, a half, a "
        "third or a quarter of their period",
        cause=cause,
        next_step='write lattice = "triangular", or sizes that meet this; `haptonic ribbon` takes any '
        "lattice",
    )
