"""Two translations of the plane: reduction to the shortest ones, the cell, and the name of their lattice."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import product

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.fields import SMALLEST, problem

SAME = 1e-9  # relative difference of lengths, and of entries of matrices, that count as equal
# relative to the shortest translation: vectors that differ by less from those of a square, a triangle or a
# rectangle count as these; four digits of the root of three leave 3e-5
MEANT = 1e-4
LEAST_SINE = 1e-3  # sine of the angle between given vectors


def shortest(vectors: Array) -> Array:
    """(2, 2) shortest two translations of the same lattice, with the same orientation.

    Lagrange's reduction; among translations of equal length the given ones are kept.
    """
    first, second = vectors
    while True:
        along = float(first @ second / (first @ first))
        if abs(along) > 0.5 + SAME:
            second = second - round(along) * first
        elif second @ second < (1 - SAME) * (first @ first):
            first, second = second, -first
        else:
            return np.array([first, second])


def voronoi_cell(vectors: NDArray[np.floating]) -> tuple[tuple[tuple[int, int], ...], Array]:
    """Voronoi cell of the origin of a lattice: a polygon of four or six sides.

    vectors : (2, 2) translations, as rows

    Returns
    -------
    the translations across its sides, anticlockwise from the lowest side, and (sides, 2) its corners, each at
    the beginning of its side
    """
    counts = [pair for pair in product(range(-2, 3), repeat=2) if pair != (0, 0)]
    points = np.array(counts) @ vectors
    apart = np.linalg.norm(0.5 * points[:, None] - points, axis=2)
    np.fill_diagonal(apart, np.inf)
    on_border = np.flatnonzero(apart.min(axis=1) > 0.5 * np.linalg.norm(points, axis=1) * (1 + SAME))
    angle = np.arctan2(points[on_border, 1], points[on_border, 0])
    order = on_border[np.argsort((angle + 0.5 * np.pi + SAME) % (2 * np.pi))]
    middles = 0.5 * points[order]
    corners = [
        np.linalg.solve(np.stack([left, right]), [left @ left, right @ right])
        for left, right in zip(np.roll(middles, 1, axis=0), middles, strict=True)
    ]
    return tuple(counts[number] for number in order), np.array(corners)


def recognised(vectors: Array) -> dict[str, float | str]:
    """Arguments of `haptonic.lattice.Lattice` that describe the lattice of two translations (2, 2).

    Raises
    ------
    PydanticCustomError : a lattice that is rotated relative to the x axis
    """
    named, least = _named(vectors), shortest(vectors)
    is_box = len(voronoi_cell(least)[0]) == 4
    if named is not None and not (is_box and named["lattice"] in ("centred", "oblique")):
        return named
    upright = least if is_box else vectors
    turned = upright @ np.array([upright[0], (-upright[0, 1], upright[0, 0])]).T / np.linalg.norm(upright[0])
    first, second = (vector_text(vector) for vector in turned)
    raise problem(
        "unsupported",
        " and ".join(vector_text(vector) for vector in vectors),
        "vectors of which a sum lies along x; a square or a rectangle must have its sides along x and y",
        "the lattice is rotated relative to the x axis",
        f"write a1 = {first} and a2 = {second}, and turn sections, positions of sites and anisotropic "
        "materials with them",
        at="a1",
    )


def _named(vectors: Array) -> dict[str, float | str] | None:
    """Arguments as in `recognised`; None if no translation lies along x, so that the lattice has no name."""
    first, second = shortest(vectors)
    least, area = float(np.linalg.norm(first)), float(abs(np.linalg.det(vectors)))
    counts = np.array(list(product(range(-6, 7), repeat=2)))
    points = np.concatenate([vectors, -vectors, counts @ np.array([first, second])])

    def period(axis: int) -> float | None:
        on = (np.abs(points[:, 1 - axis]) < MEANT * least) & (points[:, axis] > 0.5 * least)
        return float(points[on, axis].min()) if on.any() else None

    across, up = period(0), period(1)
    if across is None:
        return None

    def near(value: float, other: float) -> bool:
        return abs(value - other) < MEANT * other

    if up is not None and near(across * up, area):
        square = near(across, up)
        return {"lattice": "square" if square else "rectangular", "pitch": across} | (
            {} if square else {"pitch_y": up}
        )
    if up is not None and near(across * up, 2 * area):
        triangular = near(up, math.sqrt(3) * across)
        return {"lattice": "triangular" if triangular else "centred", "pitch": across} | (
            {} if triangular else {"pitch_y": up}
        )
    above = points[np.abs(points[:, 1] - area / across) < MEANT * least]
    nearest = above[np.abs(above[:, 0]).argmin()] if len(above) else None
    if nearest is None:
        return None
    length, angle = float(np.linalg.norm(nearest)), math.atan2(nearest[1], nearest[0])
    return {"lattice": "oblique", "pitch": across, "pitch_2": length, "angle": angle}


def check_vectors(
    first: tuple[float, float] | None, second: tuple[float, float] | None, beside: Sequence[str]
) -> None:
    """Refuse two vectors (m) that span no lattice.

    beside : keys of the lattice that are given as well

    Raises
    ------
    PydanticCustomError : a missing vector, a vector of length zero, nearly parallel ones, a lattice given
        twice
    """
    if beside:
        raise problem(
            "conflict",
            f"{' and '.join(beside)} beside a1 or a2",
            "two vectors, or a name with its sizes",
            "the lattice was given twice",
            f"remove {' and '.join(beside)}, or a1 and a2",
            at=beside[0],
        )
    for key, vector in (("a1", first), ("a2", second)):
        if vector is None or math.hypot(*vector) < SMALLEST:
            raise problem(
                "missing" if vector is None else "out-of-range",
                "nothing" if vector is None else "a vector of length zero",
                "two vectors that span the plane",
                "one vector spans no lattice",
                f'write {key} = ["3.5 mm", "6 mm"], for example',
                at=key,
            )
    vectors = np.array([first, second])
    if abs(np.linalg.det(vectors)) < LEAST_SINE * np.linalg.norm(vectors, axis=1).prod():
        raise problem(
            "out-of-range",
            " and ".join(vector_text(vector) for vector in vectors),
            f"vectors at an angle whose sine is at least {LEAST_SINE:g}",
            "they are nearly parallel and span no plane",
            "rotate one of them away from the other",
            at="a2",
        )


def vector_text(vector: Array) -> str:
    """A vector as text for a study file."""
    return "[{}]".format(", ".join(f'"{round(1e3 * part, 9) + 0.0:.6g} mm"' for part in vector))
