"""Directions of a lattice: period along a direction, and translation across it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Annotated

import numpy as np

from haptonic.arrays import Array
from haptonic.errors import GeometryError
from haptonic.fields import Quantity, problem, setting
from haptonic.lattice import Lattice
from haptonic.translations import SAME

Translations = Annotated[float, Quantity("", at_least=-20, at_most=20)]
MOST_CROSSING = 20  # translations, the largest number in a study
Along = tuple[Translations, Translations]  # as in a study


class Directed:
    """Repetition along a direction of a lattice.

    along : numbers of the lattice's two translations in one period, such as (0, 1)
    """

    along: tuple[int, int]

    @property
    def translations(self) -> Array:
        """(2, 2) translations of the lattice, m."""
        raise NotImplementedError

    @cached_property
    def across(self) -> tuple[int, int]:
        """Numbers of translations from a column, or a row, to the next on the right: the shortest ones."""
        m, n = self.along
        x, y = _bezout(m, n)  # m x + n y = 1
        step = np.array([y, -x])  # of determinant n y + m x = 1 with (m, n)
        span, period = step @ self.translations, self.way
        shortest = step - round(float(span @ period / (period @ period)) - SAME) * np.array(self.along)
        return int(shortest[0]), int(shortest[1])

    @cached_property
    def crossing(self) -> tuple[int, int] | None:
        """Numbers of translations at a right angle to the period; None if they are too large."""
        return _balanced(self.translations @ self.way, self.period**2)

    @property
    def way(self) -> Array:
        """(2,) translation of one period, m."""
        return np.asarray(np.array(self.along) @ self.translations)

    @property
    def vectors(self) -> Array:
        """(1, 2) translation of one period, m."""
        return np.asarray(self.way[None])

    @property
    def period(self) -> float:
        """Length of the period, m."""
        return float(np.linalg.norm(self.vectors))

    @cached_property
    def turn(self) -> Array:
        """(2, 2) rotation to axes in which the period lies along y."""
        x, y = self.way / np.linalg.norm(self.way)
        return np.array([[y, -x], [x, y]])

    def phases(self, along: float, across: Array) -> Array:
        """(n, 2) phases (k.a1, k.a2) from those of the period (rad) and of the translation across (n,)."""
        both = np.column_stack([np.full(len(across), along), across])
        return np.asarray(np.linalg.solve(np.array([self.along, self.across], dtype=float), both.T).T)


def along_axis(lattice: Lattice, axis: int) -> tuple[int, int] | None:
    """Smallest numbers of translations of a lattice along x (0) or y (1); None if they are too large."""
    numbers = _balanced(lattice.vectors[:, 1 - axis], lattice.pitch)
    if numbers is None:
        return None
    m, n = numbers
    return (m, n) if (np.array(numbers) @ lattice.vectors)[axis] > 0 else (-m, -n)


def _balanced(parts: Array, yardstick: float) -> tuple[int, int] | None:
    """Small integers m and n without a common divisor, with m first + n second = 0 for two parts, or None."""
    larger = int(np.abs(parts).argmax())
    near = Fraction(-float(parts[1 - larger] / parts[larger])).limit_denominator(MOST_CROSSING)
    numbers = (near.numerator, near.denominator) if larger == 0 else (near.denominator, near.numerator)
    return numbers if abs(float(np.array(numbers) @ parts)) <= SAME * yardstick else None


def check_along(along: tuple[int, int], table: str, what: str) -> None:
    """Raise GeometryError unless a period is a shortest one; ``what`` repeats, in a table of the study."""
    if math.gcd(*along) != 1:
        raise GeometryError.out_of_range(
            argument=f"{table}.along",
            given=f"{list(along)}",
            allowed="two whole numbers without a common divisor",
            cause=f"{what} repeats after a part of that" if any(along) else "that is no direction",
            next_step="write along = [0, 1] for the second translation of the lattice",
        )


@dataclass(frozen=True, kw_only=True)
class DirectionSettings:
    """Direction of the lattice along which something repeats, in a study; tables inherit it."""

    along: Along = setting(  # noqa: RUF009 - a declaration for the described tables
        (0.0, 1.0),
        "Period in numbers of the lattice's two translations; [0, 1] is along y in rectangles. A "
        "ribbon or rows lie along it; waves of `layers` cross the rows.",
        title="Direction",
    )

    def __post_init__(self) -> None:
        if any(number != round(number) for number in self.along):
            raise problem(
                "malformed",
                f"{list(self.along)}",
                "two whole numbers, such as [0, 1]",
                "lattices repeat after whole translations",
                "write along = [0, 1]",
                at="along",
            )

    @property
    def direction(self) -> tuple[int, int]:
        """Numbers of translations of the lattice in one period."""
        return round(self.along[0]), round(self.along[1])


def _bezout(m: int, n: int) -> tuple[int, int]:
    """(x, y) with m x + n y = 1, for integers without a common divisor (extended Euclid)."""
    if n == 0:
        return m, 0  # m is 1 or -1
    x, y = _bezout(n, m % n)
    return y, x - (m // n) * y
