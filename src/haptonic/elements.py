"""Spectral hexahedra: stiffness and lumped mass of the elements of a mesh.

Nodes and quadrature points coincide (Gauss-Lobatto-Legendre), so the mass matrix is diagonal, and a
derivative at a point has the nodes of one line through it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import product

import numpy as np

from haptonic.arrays import Array, Bools, Ints
from haptonic.cell.quadrature import lobatto
from haptonic.later import sparse as sp
from haptonic.materials import Material, elasticity_tensor


@dataclass(frozen=True)
class ElementMatrices:
    """Stiffness and mass of elements of the same orders.

    stiffness : (k, elements, 3, 3) between the two nodes of k pairs, N/m; the last axes are the two
        displacement components. The nodes of all other pairs are not coupled
    pairs : (2, k) local numbers of these two nodes, in raveled order
    mass : (elements, nodes), kg; the same for each component
    moduli : (3, 3, n1, n2, n3, elements, 3, 3) N m, such that twice the strain energy is the sum of
        ``D_a u . moduli[a, b] D_b u`` over the local axes a, b and the nodes
    """

    stiffness: Array
    pairs: Ints
    mass: Array
    moduli: Array


def element_matrices(points: Array, nodes: Ints, material: Material) -> ElementMatrices:
    """Stiffness and lumped mass of elements of the same orders.

    With local derivatives ``D``, quadrature weights ``w``, the inverse Jacobian ``G`` and elasticity
    ``c``, the stiffness of nodes I, J is the sum over points q of ``D_a[q, I] C_ab[q] D_b[q, J]`` where
    ``C_ab = w det(J) G_ak c_ikjl G_bl``.

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
    moduli = np.einsum("xabcmijl,xabcnl,xabc->mnabcxij", half, inverse, volume, optimize=True)
    pairs, derivatives = coupled_pairs(sizes)
    stiffness = derivatives @ moduli.reshape(derivatives.shape[1], -1)
    return ElementMatrices(
        stiffness=stiffness.reshape(-1, len(nodes), 3, 3),
        pairs=pairs,
        mass=material.density * volume.reshape(len(nodes), -1),
        moduli=moduli,
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
    pairs, _ = coupled_pairs(nodes.shape[1:])
    whole = ElementMatrices(
        stiffness=np.empty((pairs.shape[1], len(nodes), 3, 3)),
        pairs=pairs,
        mass=np.empty((len(nodes), nodes[0].size)),
        moduli=np.empty((3, 3, *nodes.shape[1:], len(nodes), 3, 3)),
    )
    for number, solid in enumerate(materials):
        members = np.flatnonzero(region == number)
        if len(members):
            part = element_matrices(points, nodes[members], solid)
            whole.stiffness[:, members], whole.mass[members] = part.stiffness, part.mass
            whole.moduli[..., members, :, :] = part.moduli
    return whole


@lru_cache(maxsize=64)
def coupled_pairs(sizes: tuple[int, int, int]) -> tuple[Ints, sp.csr_array]:
    """Pairs of nodes that an element couples: local numbers (2, k), and products of derivatives (k, 9 nodes).

    The products times `ElementMatrices.moduli`, raveled by axes and nodes, are the stiffness.
    """
    every = products([derivative(sizes, axis) for axis in range(3)])
    coupled = np.flatnonzero(np.diff(every.indptr))
    return np.stack(np.divmod(coupled, math.prod(sizes))), every[coupled]


Sums = tuple[Ints, Array]  # (n, k) nodes and their factors in a sum at each of n nodes


def derivative(sizes: tuple[int, ...], axis: int) -> Sums:
    """Derivative along a local axis at the nodes of a grid, a sum over the line through each node."""
    lines = np.moveaxis(np.arange(math.prod(sizes)).reshape(sizes), axis, -1)
    nodes = np.empty((lines.size, sizes[axis]), dtype=int)
    factors = np.empty(nodes.shape)
    nodes[lines], factors[lines] = lines[..., None, :], lobatto(sizes[axis] - 1)[2]
    return nodes, factors


def products(sums: Sequence[Sums]) -> sp.csr_array:
    """(n^2, s^2 n) products of the factors of two nodes in two of s sums at a node.

    Rows are pairs of nodes; columns are pairs of sums, each with the n nodes at which they are formed.
    """
    count, rows, columns, values = len(sums[0][0]), [], [], []
    for number, ((first, a), (second, b)) in enumerate(product(sums, repeat=2)):
        row = first[:, :, None] * count + second[:, None, :]
        rows.append(row.ravel())
        columns.append(np.repeat(number * count + np.arange(count), row[0].size))
        values.append((a[:, :, None] * b[:, None, :]).ravel())
    entries = (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns)))
    return sp.csr_array(entries, shape=(count**2, len(sums) ** 2 * count))
