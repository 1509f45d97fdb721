"""Surplus of fields: the energy of their highest polynomials, which estimates the error of their mesh.

In each element a displacement is a sum of products of hierarchical polynomials of the three local axes: the
ends and integrated Legendre polynomials, which vanish at both ends and are orthogonal in the energy of a bar.
The surplus of a field is the strain energy of its part with the highest polynomial along an axis, summed over
axes and elements. From it follows the energy that the mesh lacks, which is the error of the eigenvalue of a
mode of unit mass. Near an edge where stress grows as r^(a - 1), the energy of the polynomials of degree k
falls as k^(-4 a - 1) (Babuska and Suri 1994, doi 10.1137/1036141), so those beyond the degree p have the
energy of the last one times

    sum over k > p of (p / k)^(4 a + 1)  =  p / (4 a) * (1 + 1 / (2 p))^(-4 a)   (midpoint rule).

Away from edges the energies fall faster. Those beyond are at most that of the last degree if each degree at
least halves them, which is assumed through the plate and across the rings of discs. The Legendre coefficients
of a wave exp(i x s), with s from -1 to 1, are spherical Bessel functions of x. If the order p is at least x,
each degree has less than (p / (2 p + 1))^2 < 1/4 of the energy of the one before, and those beyond have at
most a third of that of the last degree. This is assumed for outlines without corners: around discs, also
along their edges, and in all directions about a pillar without a fillet on a plate that is not thin. Along an
axis on which an element is its own image in a mirror, a mode has even or odd polynomials only: the highest of
a kind is among the two highest, and the one before is two orders lower. The energy falls by about the same
ratio from one to the next, so that ratio is used for those beyond.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.polynomial import legendre

from haptonic.arrays import Array, Bools, Ints
from haptonic.cell import TileShape, Topology
from haptonic.cell.quadrature import lobatto
from haptonic.elements import derivative, products
from haptonic.later import sparse as sp
from haptonic.superelement.symmetry import Folding


@lru_cache(maxsize=256)
def polynomial(order: int, degree: int) -> tuple[Array, Array]:
    """Values (order + 1,) of a polynomial at the nodes, and its share in values (order + 1,) there."""
    values = legendre.legvander(lobatto(order)[0], order)
    values[:, 2:] -= values[:, :-2].copy()
    share: Array = np.linalg.inv(values)[degree]
    return values[:, degree].astype(np.float64), share


# Exponent a at a re-entrant edge of 270 degrees (Williams 1952, doi 10.1115/1.4010553)
EDGE = 0.5445
# Energy beyond a degree as a multiple of that of this degree, away from edges. On square and triangular
# lattices with ten drawn pillars, estimates with `WAVES` are 1.7 to 3 times the errors at order 4, with
# `SMOOTH` 3 to 5 times. For five plates with holes at order 3, those with `WAVES` are down to 0.6 times the
# errors, with `SMOOTH` at least 1.3 times. Beside a fillet in a narrow neck, those with `WAVES` are 0.8 times
# the errors, and for twenty bands of a pillar on a plate of 0.04 pitches they are equal to them.
SMOOTH, WAVES = 1.0, 1 / 3
AROUND = 1  # axis of elements along the rings
# Energy beyond the highest polynomials in elements that are not their own images; in the others, and in those
# of a CAD file away from edges, energy of the highest of each kind, and of those before
FORMS = ("beyond", "highest_of_kind", "before")


def missing_energy(beyond: Array, of_kind: Array, before: Array) -> Array:
    """Estimate the energy that a mesh lacks from the values of `FORMS`, each (k,) of k modes."""
    falls = before > np.maximum(of_kind, 0.0)  # energies of rigid motions may be negative by rounding
    ratio = np.divide(of_kind, before, out=np.ones_like(of_kind), where=falls)
    return np.asarray(beyond + ratio * of_kind)


def beyond_at_edge(degree: int) -> float:
    """Energy beyond a degree as a multiple of that of this degree, in an element at a re-entrant edge."""
    return float(degree / (4 * EDGE) * (1 + 0.5 / degree) ** (-4 * EDGE))


def resolves_waves(tile: TileShape) -> bool:
    """True if energies fall like those of waves: around discs, and in all directions about a pillar."""
    if tile.pillar is not None:
        corners = tile.pillar.outline.corners
        return not (tile.pillar.fillet or tile.is_thin or len(corners))
    return tile.stack is not None and not tile.stack.has_corners


def energy_beyond(tile: TileShape, axis: int, degree: int, near: Bools) -> Array:
    """(elements,) energy beyond a degree along an axis as a multiple of that of this degree.

    near : (elements,) True for elements at edges where stress is singular
    """
    if not resolves_waves(tile):
        return np.where(near, beyond_at_edge(degree), SMOOTH)
    if axis == AROUND:
        return np.full(near.shape, WAVES)
    return np.where(near, beyond_at_edge(degree), SMOOTH if tile.pillar is None else WAVES)


@dataclass(frozen=True)
class NodeRows:
    """Rows of nodes along an axis of some elements, each of which moves by one polynomial.

    form : number of the form in `FORMS` that they contribute to
    nodes : (elements, m, n) of each row; degree : of the polynomial
    stiffness : (elements, 3 m, 3 m) between the rows, images included, N/m
    """

    form: int
    nodes: Ints
    degree: int
    stiffness: Array


@lru_cache(maxsize=64)
def at_singular_edges(topology: Topology, solids: tuple[int, ...]) -> Bools:
    """(nodes,) True for corners of elements on edges where stress is singular.

    These are re-entrant edges, and edges where interfaces meet a surface or have a corner.

    solids : number of the material of each region
    """
    corners = np.concatenate([
        family.nodes[np.ix_(np.arange(len(family)), *([0, size - 1] for size in family.nodes.shape[1:]))]
        for family in topology.families
    ])  # fmt: skip
    material = np.array(solids)[np.concatenate([family.region for family in topology.families]).astype(int)]
    faces = np.concatenate([np.moveaxis(corners, axis, 1).reshape(-1, 2, 2) for axis in (1, 2, 3)])
    _, place, times = np.unique(
        np.sort(faces.reshape(-1, 4), axis=1), axis=0, return_inverse=True, return_counts=True
    )
    edges, place_of_edge = np.unique(_edges(corners), axis=0, return_inverse=True)
    edge_of_element = place_of_edge.reshape(3, len(corners), 4)
    around = np.stack([
        np.bincount(edge_of_element[:, material == solid].ravel(), minlength=len(edges))
        for solid in set(solids)
    ])  # fmt: skip
    outer = {tuple(edge) for edge in _edges(faces[times[place.ravel()] == 1])}
    on_surface = np.array([tuple(edge) in outer for edge in edges])
    several = (around > 0).sum(axis=0) > 1
    # elements around an edge: three leave a re-entrant one, two and two meet at a flat interface
    outside, inside = several | (around.sum(axis=0) > 2), several & (around % 2 == 1).any(axis=0)
    singular = np.where(on_surface, outside, inside)
    at_edge = np.zeros(topology.nodes, dtype=bool)
    at_edge[edges[singular]] = True
    return at_edge


def _edges(corners: Ints) -> Ints:
    """(edges, 2) corners of the edges of elements (n, 2, 2, 2) or faces (n, 2, 2), by their axes."""
    along = [np.moveaxis(corners, axis, -1).reshape(-1, 2) for axis in range(1, corners.ndim)]
    return np.sort(np.concatenate(along), axis=1)


def highest_rows(
    tile: TileShape, topology: Topology, folding: Folding, moduli: Sequence[Array]
) -> list[NodeRows]:
    """Rows that move by the highest polynomials; ``moduli`` of each family, see `ElementMatrices`."""
    rows = []
    singular = at_singular_edges(topology, tuple(tile.solids.index(solid) for solid in tile.solids))
    if tile.stack is not None and tile.stack.has_corners:  # along upright edges, which touch most elements
        singular = np.ones_like(singular)
    for family, chosen, weight, of_family in zip(
        topology.families, folding.chosen, folding.weight, moduli, strict=True
    ):
        nodes = family.nodes[chosen]
        representative, sizes = folding.node[nodes], nodes.shape[1:]
        near = np.asarray(singular[nodes].any(axis=(1, 2, 3)))
        for axis, size in enumerate(sizes):
            is_image = (representative == np.flip(representative, axis + 1)).all(axis=(1, 2, 3))
            choices = [
                (0, 1, ~is_image),
                (1, 1, is_image),
                (1, 2, is_image),
                (2, 3, is_image),
                (2, 4, is_image),
            ]
            for form, lower, members in choices:
                degree = size - lower
                if degree < 2 or not members.any():  # elements of order one have no such polynomials
                    continue
                factor = weight[members]
                if form == 0:
                    factor = factor * energy_beyond(tile, axis, degree, near[members])
                along = np.moveaxis(nodes[members], axis + 1, -1).reshape(len(factor), -1, size)
                stiffness = _row_stiffness(
                    of_family[..., members, :, :] * factor[:, None, None], axis, degree
                )
                rows.append(NodeRows(form=form, nodes=along, degree=degree, stiffness=stiffness))
    return rows


def _row_stiffness(moduli: Array, axis: int, degree: int) -> Array:
    """(elements, 3 m, 3 m) stiffness of elements between rows of nodes along an axis, see `NodeRows`."""
    order = [axis, *(other for other in range(3) if other != axis)]
    along, *across = (moduli.shape[2 + other] for other in order)
    values = polynomial(along - 1, degree)[0]
    factors = np.stack([lobatto(along - 1)[2] @ values, values, values])
    # (a, b, row, element, i, j): sums over the nodes of each row
    of_rows = np.einsum(
        "aq,bq,abqyzxij->abyzxij", factors, factors, np.moveaxis(moduli[np.ix_(order, order)], 2 + axis, 2)
    )
    between, m = _products_across(tuple(across)), math.prod(across)
    stiffness = (between @ of_rows.reshape(9 * m, -1)).reshape(m, m, -1, 3, 3)
    return np.asarray(stiffness.transpose(2, 0, 3, 1, 4).reshape(-1, 3 * m, 3 * m))


@lru_cache(maxsize=64)
def _products_across(sizes: tuple[int, int]) -> sp.csr_array:
    """(m^2, 9 m) products of the derivatives of two rows at all m rows, without the factors along a row."""
    m = math.prod(sizes)
    return products([(np.arange(m)[:, None], np.ones((m, 1))), derivative(sizes, 0), derivative(sizes, 1)])


def surplus_forms(folding: Folding, q: int, rows: list[NodeRows], fields: Array) -> Array:
    """(3, k, k) `FORMS` on fields (3 representatives, k) of a symmetry class, N/m."""
    forms = np.zeros((len(FORMS), *(fields.shape[1],) * 2))
    unknown = 3 * folding.node[:, None] + np.arange(3)
    sign = folding.sign[q].astype(float)
    for of_axis in rows:
        share = polynomial(of_axis.nodes.shape[-1] - 1, of_axis.degree)[1]
        # amplitudes of the polynomial, ordered by element, row and component
        numbers = np.moveaxis(unknown[of_axis.nodes], -1, -2)
        values = np.moveaxis(sign[of_axis.nodes], -1, -2) * share
        starts = np.arange(0, numbers.size + 1, len(share))
        amplitude_of = sp.csr_array(
            (values.ravel(), numbers.ravel(), starts), shape=(len(starts) - 1, len(fields))
        )
        amplitudes = np.asarray(amplitude_of @ fields)
        by_element = amplitudes.reshape(len(of_axis.nodes), -1, fields.shape[1])
        forces = np.matmul(of_axis.stiffness, by_element).reshape(amplitudes.shape)
        forms[of_axis.form] += amplitudes.T @ forces
    return forms
