"""Body of a pillar, from a little above its foot to its top: a prism, which needs no mesh.

The displacement is a polynomial in x and y over the section, and in z along the body, because it is smooth
away from the foot with its stress singularity. A motion is given by its values on Gauss-Lobatto-Legendre
levels along the body, each a sum of polynomials that are orthonormal over the section. In a symmetry class of
two mirrors the polynomials of a component are even or odd in x and y, and equal in number for each of these
kinds; with fewer operations a class contains several kinds.

Stiffness and mass follow from the energies of the prism, u^T K u = integral of strain : C : strain and
u^T M u = integral of rho |u|^2, integrals over the section times integrals along it.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.cell.outlines import Outline
from haptonic.cell.quadrature import interpolation, lobatto
from haptonic.later import linalg as la
from haptonic.materials import Material, elasticity_tensor

Parity = tuple[int, int]  # in x and y: 0 even, 1 odd
Kinds = tuple[Parity, ...]  # kinds of polynomials of a component

PARITIES: tuple[Parity, ...] = ((0, 0), (0, 1), (1, 0), (1, 1))


@dataclass(frozen=True)
class PillarBody:
    """A prism along z.

    low, length : height of its lower end, and its length from there, m
    half_width : smallest half-width of the section, m; outline : of the section, scaled to half-width 1
    degree : of the polynomials in x^2 and y^2, without the factors x and y of odd ones
    order : of the polynomials along z; kinds : number of kinds of polynomials over the section per component
    faces : number of faces of the plate with a pillar; for two the forms include the image of the body
    """

    low: float
    length: float
    half_width: float
    outline: Outline
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
        """Number of unknowns of one level."""
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
        over = np.array([
            [_section_forms(self.outline, self.degree, first, second) for second in parities]
            for first in parities
        ])  # fmt: skip
        scale = self.half_width ** (1.0 - (np.arange(3) < 2))  # a slope over the section is per half-width
        forms = np.einsum("iajb,ijabmn,a,b->abminj", tensor, over, scale, scale, optimize=True)
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
        """(levels,) share of each level in the mass per area of the section of half-width 1, kg."""
        per_length = self.faces * self.half_width**2 * self.material.density
        return np.asarray(0.5 * self.length * per_length * lobatto(self.order)[1])

    @cached_property
    def mass(self) -> Array:
        """(u,) mass lumped on the levels, kg."""
        return np.repeat(self._weights, self.on_section)

    @property
    def sizes(self) -> Array:
        """(3, levels) height (m), mass (kg) and inertia about the axis (kg m^2) of each level."""
        points, weights = self.outline.cubature(2)
        turning = self._weights * (weights @ points**2).sum() * self.half_width**2
        return np.stack([self._levels, self._weights * weights.sum(), turning])

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
        points, weights = _inside(self.outline, self.degree)
        values = _polynomials(self.outline, self.degree, kinds).at(points)
        return np.asarray((weights * _monomials(points, np.array([powers]))[:, 0]) @ values)

    def over_section(self, kinds: Kinds, x: Array, y: Array) -> Array:
        """(n, shapes) values of the polynomials at points (m) of the section."""
        points = np.stack([x, y], axis=1) / self.half_width
        return _polynomials(self.outline, self.degree, kinds).at(points)

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


@dataclass(frozen=True)
class _Polynomials:
    """Polynomials of some parities that are together orthonormal over the inside of an outline.

    powers : (monomials, 2) of x and y; combined : (monomials, shapes) coefficients of the polynomials
    """

    outline: Outline
    powers: NDArray[np.int64]
    combined: Array

    @classmethod
    def of(cls, outline: Outline, degree: int, kinds: Kinds) -> _Polynomials:
        powers = np.array([power for parity in kinds for power in _exponents(parity, degree)])
        points, weights = _inside(outline, degree)
        values = np.sqrt(weights)[:, None] * _monomials(points, powers)
        # scaled columns: monomials of high powers are small or large
        size = np.linalg.norm(values, axis=0)
        triangle = np.linalg.qr(values / size, mode="r")
        triangle *= np.sign(np.diag(triangle))[:, None]
        return cls(outline, powers, la.inv(triangle) / size[:, None])

    def at(self, points: Array, derivative: int = 2) -> Array:
        """(n, shapes) values at points (n, 2), or derivatives along x (0) or y (1)."""
        if derivative == 2:
            return np.asarray(_monomials(points, self.powers) @ self.combined)
        lowered = np.maximum(self.powers - np.eye(2, dtype=np.int64)[derivative], 0)
        return np.asarray(_monomials(points, lowered) * self.powers[:, derivative] @ self.combined)


def _monomials(points: Array, powers: NDArray[np.int64]) -> Array:
    """(n, monomials) values at points (n, 2)."""
    return np.asarray(points[:, :1] ** powers[:, 0] * points[:, 1:] ** powers[:, 1])


def _inside(outline: Outline, degree: int) -> tuple[Array, Array]:
    """Points and weights of integrals over an outline's inside, exact for products of two polynomials."""
    return outline.cubature(2 * (2 * degree + 2))


_polynomials = lru_cache(maxsize=256)(_Polynomials.of)


@lru_cache(maxsize=256)
def _section_forms(outline: Outline, degree: int, first: Kinds, second: Kinds) -> Array:
    """(3, 3, shapes, shapes) integrals of products of d/dx, d/dy or the value of polynomials of two kinds."""
    points, weights = _inside(outline, degree)
    left, right = (
        np.stack([_polynomials(outline, degree, kinds).at(points, axis) for axis in range(3)])
        for kinds in (first, second)
    )
    return np.asarray(np.einsum("n,anm,bnl->abml", weights, left, right, optimize=True))
