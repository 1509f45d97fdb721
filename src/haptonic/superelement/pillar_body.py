"""The body of a pillar, from a little above its foot to its top: a prism, which needs no mesh.

Over its section displacement is a polynomial in x and y, along it one in z: far from the foot, where stress
is singular, it is smooth. A motion is given by its values on Gauss-Lobatto-Legendre levels along the body,
each a sum of polynomials that are orthonormal over the section. In a symmetry class of two mirrors the
polynomials of a component are even or odd in x and y, and there are as many of them whichever it is; with
fewer operations several of these kinds make a class.

Stiffness and mass are those of the prism's own energies, u^T K u = integral of strain : C : strain and
u^T M u = integral of rho |u|^2, integrals over the section times integrals along it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.cell.pillar import Section
from haptonic.cell.quadrature import interpolation, lobatto
from haptonic.later import linalg as la
from haptonic.materials import Material, elasticity_tensor

Parity = tuple[int, int]  # in x and y: 0 even, 1 odd
Kinds = tuple[Parity, ...]  # of the polynomials of a component

PARITIES: tuple[Parity, ...] = ((0, 0), (0, 1), (1, 0), (1, 1))


@dataclass(frozen=True)
class PillarBody:
    """A prism along z.

    low, length : height of its lower end, and how far it reaches from there, m
    half_width : radius, or half the side of a square section, m
    degree : of the polynomials in x^2 and y^2, beside the factors x and y of odd ones
    order : of the polynomials along z; kinds : of polynomials over the section that each component has
    faces : of the plate that it stands on; with two the forms are those of it and of its image together
    """

    low: float
    length: float
    half_width: float
    section: Section
    material: Material
    degree: int
    order: int
    kinds: int
    faces: int

    @property
    def shapes(self) -> int:
        """Number of polynomials of each component over the section."""
        return self.kinds * len(_exponents((0, 0), self.degree))

    @property
    def on_section(self) -> int:
        """Unknowns of one level."""
        return 3 * self.shapes

    def stiffness(self, parities: tuple[Kinds, ...]) -> Array:
        """(u, u) on unknowns (level, polynomial, component), N/m; parities of the three components."""
        tensor = elasticity_tensor(self.material.stiffness)
        _, weights, slopes = lobatto(self.order)
        half = 0.5 * self.length
        along = {  # integrals along z of products of level polynomials and of their slopes
            (False, False): half * np.diag(weights),
            (True, False): slopes.T * weights,
            (False, True): weights[:, None] * slopes,
            (True, True): (slopes.T * weights) @ slopes / half,
        }
        over = _section_forms(self.section, self.degree)
        of_component = [PARITIES.index(parity) for kinds in parities for parity in kinds]
        over = over[np.ix_(of_component, of_component)].reshape(2 * (3, self.kinds) + over.shape[2:])
        scale = self.half_width ** (1.0 - (np.arange(3) < 2))  # a slope over the section is per half-width
        forms = np.einsum("iajb,ikjlabmn,a,b->abkmilnj", tensor, over, scale, scale, optimize=True)
        total = np.zeros((self.order + 1, self.on_section, self.order + 1, self.on_section))
        for (first, second), integral in along.items():
            rows, columns = ([2] if slope else [0, 1] for slope in (first, second))
            section = forms[np.ix_(rows, columns)].sum(axis=(0, 1)).reshape((self.on_section,) * 2)
            total += integral[:, None, :, None] * section[:, None]
        size = (self.order + 1) * self.on_section
        return self.faces * total.reshape(size, size)

    @property
    def _levels(self) -> Array:
        """(levels,) heights, m."""
        return np.asarray(self.low + 0.5 * self.length * (1 + lobatto(self.order)[0]))

    @property
    def _weights(self) -> Array:
        """(levels,) each one's share of the mass per area of the section of half-width 1, kg."""
        per_length = self.faces * self.half_width**2 * self.material.density
        return np.asarray(0.5 * self.length * per_length * lobatto(self.order)[1])

    @cached_property
    def mass(self) -> Array:
        """(u,) lumped on the levels, kg."""
        return np.repeat(self._weights, self.on_section)

    @property
    def sizes(self) -> Array:
        """(3, levels) height (m), mass (kg) and inertia about the axis (kg m^2) of each level's share."""
        area, arm = (_moment(self.section, *powers) for powers in ((0, 0), (2, 0)))
        turning = 2 * self._weights * arm * self.half_width**2
        return np.stack([self._levels, self._weights * area, turning])

    def momenta(self, parities: tuple[Kinds, ...]) -> Array:
        """(4, levels, u) momentum along x, y and z and angular momentum of each level, per unknown."""
        levels = self.order + 1
        section = np.zeros((4, self.shapes, 3))
        for c, kinds in enumerate(parities):
            section[c, :, c] = self._moments(kinds, (0, 0))
        section[3, :, 0] = -self.half_width * self._moments(parities[0], (0, 1))
        section[3, :, 1] = self.half_width * self._moments(parities[1], (1, 0))
        forms = np.einsum("cu,k,kl->cklu", section.reshape(4, -1), self._weights, np.eye(levels))
        return np.asarray(forms.reshape(4, levels, -1))

    def _moments(self, kinds: Kinds, powers: tuple[int, int]) -> Array:
        """(shapes,) integrals over the section of half-width 1 of x^p y^q times the polynomials."""
        found = []
        for parity in kinds:
            monomials = _exponents(parity, self.degree)
            values = [_moment(self.section, p + powers[0], q + powers[1]) for p, q in monomials]
            found.append(np.array(values) @ _orthonormal(self.section, self.degree, parity))
        return np.concatenate(found)

    def over_section(self, kinds: Kinds, x: Array, y: Array) -> Array:
        """(n, shapes) values of the polynomials at points (m) of the section."""
        found = []
        for parity in kinds:
            p, q = np.array(_exponents(parity, self.degree)).T
            powers = (x[:, None] / self.half_width) ** p * (y[:, None] / self.half_width) ** q
            found.append(powers @ _orthonormal(self.section, self.degree, parity))
        return np.hstack(found)

    def on_level(self, parities: tuple[Kinds, ...], x: Array, y: Array) -> Array:
        """(3 n, on_section) displacement at points of a level from its unknowns."""
        values = np.zeros((len(x), 3, self.shapes, 3))
        for c, kinds in enumerate(parities):
            values[:, c, :, c] = self.over_section(kinds, x, y)
        return values.reshape(3 * len(x), self.on_section)

    def displaced(self, parities: tuple[Kinds, ...], points: Array, unknowns: NDArray[Any]) -> NDArray[Any]:
        """(n, 3, k) displacement at points (n, 3), m, of the body from unknowns (u, k)."""
        heights, level = np.unique(points[:, 2], return_inverse=True)
        values = unknowns.reshape(self.order + 1, -1)
        values = (interpolation(self._levels, heights) @ values).reshape(len(heights), self.shapes, 3, -1)
        over = [self.over_section(kinds, points[:, 0], points[:, 1]) for kinds in parities]
        moved = [np.einsum("nm,nmk->nk", over[c], values[level, :, c]) for c in range(3)]
        return np.stack(moved, axis=1)


def _exponents(parity: Parity, degree: int) -> list[tuple[int, int]]:
    """Powers of x and y in the monomials of a parity."""
    return [
        (parity[0] + 2 * (total - b), parity[1] + 2 * b)
        for total in range(degree + 1)
        for b in range(total + 1)
    ]


def _moment(section: Section, p: int, q: int) -> float:
    """Integral of x^p y^q over the section of half-width 1."""
    if p < 0 or q < 0 or p % 2 or q % 2:
        return 0.0
    if section == "square":
        return 4.0 / ((p + 1) * (q + 1))
    angle = math.gamma(0.5 * (p + 1)) * math.gamma(0.5 * (q + 1)) / math.gamma(0.5 * (p + q) + 1)
    return 2.0 * angle / (p + q + 2)


@lru_cache(maxsize=64)
def _orthonormal(section: Section, degree: int, parity: Parity) -> Array:
    """(monomials, shapes) orthonormal polynomials over the section of half-width 1."""
    powers = _exponents(parity, degree)
    gram = np.array([[_moment(section, p + r, q + s) for r, s in powers] for p, q in powers])
    return np.asarray(la.inv(la.cholesky(gram)))


@lru_cache(maxsize=16)
def _section_forms(section: Section, degree: int) -> Array:
    """(parity, parity, 3, 3, shapes, shapes) integrals of products of d/dx, d/dy or the value of shapes."""
    count = len(PARITIES)
    shapes = len(_exponents((0, 0), degree))
    forms = np.empty((count, count, 3, 3, shapes, shapes))
    for first, second in np.ndindex(count, count):
        for a, b in np.ndindex(3, 3):
            monomials = np.array([
                [_product(section, one, a, other, b) for other in _exponents(PARITIES[second], degree)]
                for one in _exponents(PARITIES[first], degree)
            ])  # fmt: skip
            left = _orthonormal(section, degree, PARITIES[first])
            right = _orthonormal(section, degree, PARITIES[second])
            forms[first, second, a, b] = left.T @ monomials @ right
    return forms


def _product(section: Section, one: tuple[int, int], a: int, other: tuple[int, int], b: int) -> float:
    """Integral of the product of two monomials, each differentiated along x (0), y (1) or not at all (2)."""
    (p, q), (r, s) = one, other
    factor = (p, q, 1)[a] * (r, s, 1)[b]
    lowered = [int(a == axis) + int(b == axis) for axis in range(2)]
    return factor * _moment(section, p + r - lowered[0], q + s - lowered[1])
