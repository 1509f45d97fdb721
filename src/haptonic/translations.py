"""Two translations of the plane: the shortest of their lattice, its cell, and the name that it has."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import product

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.fields import SMALLEST, problem

SAME = 1e-9  # relative: lengths, and entries of matrices, that differ by less are equal
# Of the shortest translation: given vectors that differ by less from those of a square, a triangle or a
# rectangle are meant to be these. Four digits of the root of three leave 3e-5.
MEANT = 1e-4
LEAST_SINE = 1e-3  # of the angle between given vectors


def shortest(vectors: Array) -> Array:
    """(2, 2) the shortest two translations that span the same lattice, in the same sense of turning.

    By Lagrange's reduction. Of translations of equal length those that are given stay.
    """
    one, other = vectors
    while True:
        along = float(one @ other / (one @ one))
        if abs(along) > 0.5 + SAME:
            other = other - round(along) * one
        elif other @ other < (1 - SAME) * (one @ one):
            one, other = other, -one
        else:
            return np.array([one, other])


def voronoi_cell(vectors: NDArray[np.floating]) -> tuple[tuple[tuple[int, int], ...], Array]:
    """What lies nearer to the origin than to any other point of a lattice: a polygon of four or six sides.

    vectors : (2, 2) translations, as rows

    Returns
    -------
    the translations across its sides, anticlockwise from the lowest side on, and (sides, 2) its corners, each
    at the beginning of its side
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
        np.linalg.solve(np.stack([one, other]), [one @ one, other @ other])
        for one, other in zip(np.roll(middles, 1, axis=0), middles, strict=True)
    ]
    return tuple(counts[number] for number in order), np.array(corners)


def recognised(vectors: Array) -> dict[str, float | str]:
    """What names the lattice of two translations (2, 2): arguments of `haptonic.lattice.Lattice`.

    Raises
    ------
    PydanticCustomError : a lattice that is turned against the x axis
    """
    found, least = _named(vectors), shortest(vectors)
    is_box = len(voronoi_cell(least)[0]) == 4
    if found is not None and not (is_box and found["lattice"] in ("centred", "oblique")):
        return found
    upright = least if is_box else vectors
    turned = upright @ np.array([upright[0], (-upright[0, 1], upright[0, 0])]).T / np.linalg.norm(upright[0])
    one, other = (vector_text(vector) for vector in turned)
    raise problem(
        "unsupported",
        " and ".join(vector_text(one) for one in vectors),
        "vectors some sum of which lies along x; a square or a rectangle has its sides along x and y",
        "the lattice is turned against the x axis",
        f"write a1 = {one} and a2 = {other}, and turn the axes of a material that has any",
        at="a1",
    )


def _named(vectors: Array) -> dict[str, float | str] | None:
    """See `recognised`; None if no translation lies along x, so that no name stands for the lattice."""
    one, other = shortest(vectors)
    least, area = float(np.linalg.norm(one)), float(abs(np.linalg.det(vectors)))
    counts = np.array(list(product(range(-6, 7), repeat=2)))
    points = np.concatenate([vectors, -vectors, counts @ np.array([one, other])])

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
    PydanticCustomError : one of them missing or of no length, nearly parallel ones, a lattice given twice
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
                "nothing" if vector is None else "a vector of no length",
                "two vectors that span the plane",
                "one alone spans no lattice",
                f'write {key} = ["3.5 mm", "6 mm"], for example',
                at=key,
            )
    vectors = np.array([first, second])
    if abs(np.linalg.det(vectors)) < LEAST_SINE * np.linalg.norm(vectors, axis=1).prod():
        raise problem(
            "out-of-range",
            " and ".join(vector_text(one) for one in vectors),
            f"vectors at an angle whose sine is at least {LEAST_SINE:g}",
            "they are parallel, or nearly, and span no plane",
            "turn one of them away from the other",
            at="a2",
        )


def vector_text(vector: Array) -> str:
    """As a study would give it."""
    return "[{}]".format(", ".join(f'"{round(1e3 * one, 9) + 0.0:.6g} mm"' for one in vector))
