"""Spectral hexahedra: stiffness and lumped mass of the elements of a mesh.

Nodes and quadrature points coincide (Gauss-Lobatto-Legendre), so the mass matrix is diagonal and most sums
in the stiffness have a single term.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from haptonic.arrays import Array, Bools, Ints
from haptonic.cell.quadrature import lobatto
from haptonic.materials import Material, elasticity_tensor


@dataclass(frozen=True)
class ElementMatrices:
    """Stiffness and mass of elements of the same orders.

    stiffness : (elements, k, 3, 3) contributions to the stiffness between two nodes, N/m; the last axes are
        the two displacement components
    pairs : (2, k) local numbers of these two nodes, in raveled order; a pair may occur several times
    mass : (elements, nodes), kg; the same for each component
    """

    stiffness: Array
    pairs: Ints
    mass: Array


def element_matrices(points: Array, nodes: Ints, material: Material) -> ElementMatrices:
    """Stiffness and lumped mass of elements of the same orders.

    With local derivatives ``D``, quadrature weights ``w``, the inverse Jacobian ``G`` and elasticity
    ``c``, the stiffness of nodes I, J is the sum over points of ``D_a[q, I] C_ab[q] D_b[q, J]`` where
    ``C_ab = w det(J) G_ak c_ikjl G_bl``. For a = b the points share two indices with both nodes, for
    a != b the sum has a single term. So each term of the sum couples few pairs; only these are stored.

    Parameters
    ----------
    points : (n, 3) positions of a mesh's nodes, m
    nodes : (elements, n1, n2, n3) node numbers
    material : of the elements
    """
    sizes = nodes.shape[1:]
    (_, w1, D1), (_, w2, D2), (_, w3, D3) = (lobatto(n - 1) for n in sizes)
    x = points[nodes]
    jacobian = np.stack(
        [np.einsum("qa,xabck->xqbck", D1, x), np.einsum("qb,xabck->xaqck", D2, x),
         np.einsum("qc,xabck->xabqk", D3, x)], axis=-1,
    )  # fmt: skip
    volume = np.linalg.det(jacobian) * (w1[:, None, None] * w2[:, None] * w3)
    assert (volume > 0).all(), "an element is turned inside out"
    inverse = np.linalg.inv(jacobian)
    tensor = elasticity_tensor(material.stiffness)
    half = np.einsum("xabcmk,ikjl->xabcmijl", inverse, tensor, optimize=True)
    C = np.einsum("xabcmijl,xabcnl,xabc->mnxabcij", half, inverse, volume, optimize=True)
    D = (D1, D2, D3)
    terms = []
    for formulas in TERMS.values():
        sums = [np.einsum(f, D[a], D[b], C[a, b], optimize=True) for (a, b), f in formulas.items()]
        terms.append(sum(sums[1:], start=sums[0]).reshape(len(nodes), -1, 3, 3))
    return ElementMatrices(
        stiffness=np.concatenate(terms, axis=1),
        pairs=coupled_pairs(sizes),
        mass=material.density * volume.reshape(len(nodes), -1),
    )


def matrices_by_region(
    points: Array, nodes: Ints, materials: Sequence[Material], region: Ints | Bools
) -> ElementMatrices:
    """Stiffness and lumped mass of elements of several materials; see `element_matrices`.

    Parameters
    ----------
    materials : of the regions
    region : (elements,) number of each element's material
    """
    if all(solid == materials[0] for solid in materials):
        return element_matrices(points, nodes, materials[0])
    pairs = coupled_pairs(nodes.shape[1:])
    whole = ElementMatrices(
        stiffness=np.empty((len(nodes), pairs.shape[1], 3, 3)),
        pairs=pairs,
        mass=np.empty((len(nodes), nodes[0].size)),
    )
    for number, solid in enumerate(materials):
        members = np.flatnonzero(region == number)
        if len(members):
            part = element_matrices(points, nodes[members], solid)
            whole.stiffness[members], whole.mass[members] = part.stiffness, part.mass
    return whole


# coupled nodes (a, b, c), (d, e, f) with their sums over points, for each pair of derivatives
TERMS = {
    "abc,dbc": {(0, 0): "qa,qd,xqbcij->xabcdij"},
    "abc,aec": {(1, 1): "qb,qe,xaqcij->xabceij"},
    "abc,abf": {(2, 2): "qc,qf,xabqij->xabcfij"},
    "abc,dec": {(0, 1): "da,be,xdbcij->xabcdeij", (1, 0): "eb,ad,xaecij->xabcdeij"},
    "abc,dbf": {(0, 2): "da,cf,xdbcij->xabcdfij", (2, 0): "fc,ad,xabfij->xabcdfij"},
    "abc,aef": {(1, 2): "eb,cf,xaecij->xabcefij", (2, 1): "fc,be,xabfij->xabcefij"},
}


@lru_cache(maxsize=64)
def coupled_pairs(sizes: tuple[int, int, int]) -> Ints:
    """(2, k) local numbers of the two nodes of each contribution to the stiffness of an element."""
    number = np.arange(np.prod(sizes)).reshape(sizes)
    pairs = []
    for ends in TERMS:
        first, second = ends.split(",")
        letters = first + "".join(x for x in second if x not in first)
        shape = [sizes["abcdef".index(x) % 3] for x in letters]
        grid = dict(zip(letters, np.ix_(*map(range, shape)), strict=True))
        both = (number[tuple(grid[x] for x in end)] for end in (first, second))
        pairs.append(np.stack([np.broadcast_to(numbers, shape).ravel() for numbers in both]))
    return np.concatenate(pairs, axis=1)
