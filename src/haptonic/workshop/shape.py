"""What all workshop files share: where the cells of a plate lie, and the straight part of a pillar's side.

A plate of ``columns`` x ``rows`` cells is centred on the origin; its columns follow the lattice's first
translation. Files are in millimetres, so lengths here are too.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from haptonic.cell import Pillar, UnitCell
from haptonic.errors import GeometryError

Array = NDArray[np.float64]

MM = 1e3  # mm in a metre


def in_mm(cell: UnitCell, columns: int, rows: int) -> UnitCell:
    """The cell with its lengths in mm.

    Raises
    ------
    GeometryError : a number of columns or rows that is not a positive integer
    """
    for name, number in (("columns", columns), ("rows", rows)):
        if isinstance(number, bool) or not isinstance(number, int) or number < 1:
            raise GeometryError(
                argument=name,
                given=number,
                allowed="a positive integer",
                cause="the plate's length was given in place of the number of its cells",
                next_step="count the cells along that side, and give their number",
            )
    assert np.linalg.det(cell.lattice.vectors) > 0, "a1, a2 turn anticlockwise"
    return cell.scaled(MM)


def corner_grid(cell: UnitCell, columns: int, rows: int) -> Array:
    """(columns + 1, rows + 1, 2) corners of the cells of a plate."""
    i, j = np.meshgrid(np.arange(columns + 1) - columns / 2, np.arange(rows + 1) - rows / 2, indexing="ij")
    return np.asarray(np.stack([i, j], axis=-1) @ cell.lattice.vectors)


def centres(cell: UnitCell, columns: int, rows: int) -> Array:
    """(columns * rows, 2) centres of the cells of a plate, column by column."""
    corners = corner_grid(cell, columns, rows)
    return np.asarray(0.5 * (corners[:-1, :-1] + corners[1:, 1:]).reshape(-1, 2))


def plate_outline(cell: UnitCell, columns: int, rows: int) -> Array:
    """(4, 2) corners of a plate, anticlockwise from the lower left one."""
    corners = corner_grid(cell, columns, rows)
    return np.array([corners[0, 0], corners[-1, 0], corners[-1, -1], corners[0, -1]])


def straight_side(pillar: Pillar) -> Array:
    """(n, 2) corners of a pillar's side from the foot, or the end of its fillet, to the top's edge.

    Each is (half-width, height above the plate); the stretches between them are straight.
    """
    first = pillar.arc.at(1.0) if pillar.arc else np.array([pillar.radius, 0.0])
    points = [(float(first[0]), float(first[1]))]
    for stage, (low, high, width) in enumerate(pillar.stages):
        if stage:
            points.append((width, low))
        points.append((pillar.half_width(high, stage), high))
    return np.array(points)
