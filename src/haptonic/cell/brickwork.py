"""A lattice as rows of bricks: rectangles along x and y, each about one pillar.

A finite plate consists of rectangles, so a lattice with other tiles is divided differently: halfway between
its rows, and in each row halfway between its pillars. The plate is the same; if a row is offset against the
next, bricks lie as in a wall. Rows lie along x, or along y if that leaves pillars more room.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np

from haptonic.cell.checks import LEAST_CLEARANCE
from haptonic.cell.directed import along_axis
from haptonic.cell.geometry import UnitCell
from haptonic.cell.rows import Rows
from haptonic.cell.sectors import unmeshed
from haptonic.cell.tile import SiteTile, TileShape
from haptonic.errors import GeometryError
from haptonic.translations import SAME

FINEST = 48  # largest denominator of a share of a period that counts as a fraction
MOST_PIECES = 4  # of a side of a brick; more would be finer than its mesh
Steps = tuple[tuple[float, ...], tuple[float, ...]]  # between lines along x and along y, m
Distances = tuple[float, float]  # from a pillar to either end of its brick, m


@dataclass(frozen=True)
class Brick:
    """A rectangle about a pillar; all but the tile in shares of its `Brickwork`'s width and height.

    left, bottom : position in the first period, from 0 to below 1
    tile : tile about the pillar's axis, or about the middle of a file's solids
    number : index of the site
    """

    left: Fraction
    bottom: Fraction
    width: Fraction
    height: Fraction
    tile: TileShape
    number: int


@dataclass(frozen=True)
class Brickwork:
    """A lattice as bricks.

    width, height : of the repeated rectangle, m: the period of its rows, and the distance of their repetition
    offset : of the repetition above, to the right, in shares of the width; and of the one on the right,
        upwards, in shares of the height. One of them is 0
    bricks : of one period, row by row
    """

    width: float
    height: float
    offset: tuple[Fraction, Fraction]
    bricks: tuple[Brick, ...]

    @classmethod
    def of(cls, cell: UnitCell) -> Brickwork:
        """Divide a lattice, with rows along the axis that leaves pillars more room; along x for equal room.

        Raises
        ------
        GeometryError : no row of pillars lies along an axis, the offset of rows is not zero, a half, a third
            or a quarter, or a pillar crosses the line halfway to the next
        """
        if cell.solid is not None:
            return cls._of_solids(cell)
        possible, refused = [], []
        for axis in (0, 1):
            try:
                possible.append(cls._along(cell, axis))
            except GeometryError as error:
                refused.append(error)
        if not possible:
            raise refused[0]
        work = max(possible, key=lambda brickwork: round(brickwork.room / cell.lattice.pitch, 9))
        for brick in work.bricks:
            _check_room(cell, brick)
        return work

    @classmethod
    def _of_solids(cls, cell: UnitCell) -> Brickwork:
        """A lattice of a file's solids, each period of it a brick."""
        if not cell.lattice.is_rectangular:
            raise GeometryError.unsupported(
                argument="cell.lattice",
                given=cell.lattice.name,
                allowed="a square or rectangular lattice, for a plate of cells from a CAD file or mesh",
                cause="a plate consists of rectangles, and these cells are none",
                next_step='draw a rectangle of several pillars and write lattice = "rectangular", or compute '
                "layers or a ribbon",
            )
        width, height = np.diag(cell.lattice.vectors).tolist()
        start, end = Fraction(0), Fraction(1)
        brick = Brick(left=start, bottom=start, width=end, height=end, tile=cell, number=0)
        return cls(width, height, (start, start), (brick,))

    @classmethod
    def _along(cls, cell: UnitCell, axis: int) -> Brickwork:
        """Divide with rows along an axis, without a check of the room."""
        along = along_axis(cell.lattice, axis)
        if along is None:
            raise _unsupported(cell, f"no row of its pillars lies along {'xy'[axis]}")
        rows = Rows(cell, along)
        shift, height = rows.step[[axis, 1 - axis]] * np.sign(rows.step[1 - axis])
        size = rows.period, float(height)
        offset = _share(float(shift) / rows.period) % 1
        if offset.denominator > MOST_PIECES:
            raise _unsupported(cell, f"its rows are offset by {float(offset):.3g} of their period")
        bricks = _bricks(cell, axis, size, offset)
        if axis == 0:
            return cls(*size, (offset, Fraction(0)), bricks)
        turned = (
            replace(brick, left=brick.bottom, bottom=brick.left, width=brick.height, height=brick.width)
            for brick in bricks
        )
        return cls(size[1], size[0], (Fraction(0), offset), tuple(turned))

    @property
    def room(self) -> float:
        """Smallest distance from a pillar's axis to the nearest side of its brick, m."""
        return min((brick.tile.inradius for brick in self.bricks), default=0.0)

    def left(self, number: int, row: int) -> Fraction:
        """Left end of a brick in some row of periods, in shares of the width from 0 to below 1."""
        return (self.bricks[number].left + row * self.offset[0]) % 1

    def bottom(self, number: int, column: int) -> Fraction:
        """Lower end of a brick in some column of periods, in shares of the height from 0 to below 1."""
        return (self.bricks[number].bottom + column * self.offset[1]) % 1

    def columns(self, row: int) -> set[Fraction]:
        """Positions of lines between the bricks of a row of periods, in shares of the width."""
        starts = [(self.left(number, row), brick.width) for number, brick in enumerate(self.bricks)]
        return {end % 1 for start, width in starts for end in (start, start + width)}

    def rows(self, column: int) -> set[Fraction]:
        """Positions of lines between the bricks of a column of periods, in shares of the height."""
        starts = [(self.bottom(number, column), brick.height) for number, brick in enumerate(self.bricks)]
        return {end % 1 for start, height in starts for end in (start, start + height)}


def _share(value: float) -> Fraction:
    """The simple fraction nearly equal to a number, or the number itself."""
    near = Fraction(value).limit_denominator(FINEST)
    return near if abs(float(near) - value) < SAME else Fraction(value)


def _between(places: list[Fraction]) -> list[tuple[Fraction, Fraction, Fraction]]:
    """Every position in a period of 1, with the middles between it and its neighbours."""
    before = [*(place - 1 for place in places[-1:]), *places[:-1]]
    after = [*places[1:], *(place + 1 for place in places[:1])]
    around = zip(before, places, after, strict=True)
    return [(place, (low + place) / 2, (place + high) / 2) for low, place, high in around]


def _bricks(cell: UnitCell, axis: int, size: tuple[float, float], offset: Fraction) -> tuple[Brick, ...]:
    """Bricks of rows along an axis, treated as x; ``size`` : period and distance of the rows, m."""
    period, height = size
    standing = [number for number, feature in enumerate(cell.features) if feature is not None]
    levels: dict[Fraction, list[tuple[Fraction, int]]] = {}
    for number in standing:
        place = cell.shares[number] @ cell.lattice.vectors
        up = _share(float(place[1 - axis]) / height)
        along = _share(float(place[axis]) / period - float(offset) * int(np.floor(float(up) + SAME))) % 1
        levels.setdefault(up % 1, []).append((along, number))
    bricks, origin = [], None
    for level, below, above in _between(sorted(levels)):
        row = dict(levels[level])
        for place, before, after in _between(sorted(row)):
            origin = (before, below) if origin is None else origin
            left_and_right = (float(place - before) * period, float(after - place) * period)
            up_and_down = (float(level - below) * height, float(above - level) * height)
            tile = _tile(
                cell,
                row[place],
                *((left_and_right, up_and_down) if axis == 0 else (up_and_down, left_and_right)),
            )
            bricks.append(
                Brick(
                    left=(before - origin[0]) % 1,
                    bottom=below - origin[1],
                    width=after - before,
                    height=above - below,
                    tile=tile,
                    number=row[place],
                )
            )
    return tuple(bricks)


def _tile(cell: UnitCell, number: int, x: Distances, y: Distances) -> SiteTile:
    """A rectangle about a pillar, from the distances to its left and right, lower and upper side."""
    (left, right), (below, above) = x, y
    corners = ((-left, -below), (right, -below), (right, above), (-left, above))
    extent = max(left + right, below + above)
    return SiteTile(
        outline=corners,
        period=extent,
        thickness=cell.thickness,
        material=cell.material,
        site_feature=cell.features[number],
        faces=cell.faces,
    )


def _check_room(cell: UnitCell, brick: Brick) -> None:
    """Refuse a pillar or disc that crosses the line halfway to the next one."""
    feature = brick.tile.feature
    assert feature is not None
    table = f"{cell.table_of(brick.number)}{feature.table}"
    room = brick.tile.room_beside(LEAST_CLEARANCE * cell.lattice.pitch)
    if feature.widest > room:
        per_half = feature.diameter / feature.radius
        beyond = per_half * (feature.widest - feature.radius)
        raise GeometryError.out_of_range(
            argument=f"{table}.diameter",
            given=f"{feature.diameter * 1e3:.4g} mm"
            + (f", and {beyond * 1e3:.4g} mm more where it is widest" if beyond else ""),
            allowed=f"less than {(per_half * room - beyond) * 1e3:.4g} mm in a plate",
            cause="a plate is cut halfway between rows of pillars, and this one crosses such a line",
            next_step=f"choose a thinner {feature.noun} or a larger pitch; bands, layers and ribbons have no "
            "such limit",
        )
    if (parts := unmeshed(brick.tile)) is not None:
        raise GeometryError.unsupported(argument=f"{table}.section", **parts)


def _unsupported(cell: UnitCell, cause: str) -> GeometryError:
    return GeometryError.unsupported(
        argument="cell.lattice",
        given=cell.lattice.name,
        allowed="a lattice with rows along x or y for a plate, each offset against the next by nothing, a "
        "half, a third or a quarter of their period",
        cause=cause,
        next_step='write lattice = "triangular", or sizes that meet this; `haptonic ribbon` takes any '
        "lattice",
    )


def equal_pieces(steps: Steps) -> int:
    """Number of equal pieces of a brick's side in a mesh that meets all lines between tiles.

    Raises
    ------
    GeometryError : more than `MOST_PIECES` are needed
    """
    shares = [share for along in steps for share in np.cumsum(along) / sum(along)]
    count = math.lcm(*(Fraction(float(share)).limit_denominator(FINEST).denominator for share in shares))
    if count > MOST_PIECES:
        raise GeometryError.unsupported(
            argument="plate.map",
            given=f"a lattice with lines between its tiles at {count}ths of a side",
            allowed=f"lines at a half, at thirds or at quarters (at most {MOST_PIECES} equal pieces)",
            cause="lines halfway between the pillars of a row do not meet those of the next row, or of "
            "another lattice in the same columns",
            next_step="move the sites to places such as 1/2 or 1/4 of the period, or draw lattices in their "
            "own columns and rows",
        )
    return count
