"""Spectral hexahedra: from a mesh to stiffness and lumped mass.

Nodes and quadrature points coincide (Gauss-Lobatto-Legendre), so the mass matrix is diagonal and most
sums in the stiffness collapse to a single product.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from haptonic.cell.quadrature import lobatto
from haptonic.materials import Material, elasticity_tensor

Array = NDArray[np.float64]


@dataclass(frozen=True)
class ElementMatrices:
    """Per element, with its nodes raveled.

    stiffness : (elements, nodes, nodes, 3, 3), N/m; the last axes are the two displacement components
    mass : (elements, nodes), kg; the same for each component
    """

    stiffness: Array
    mass: Array


def element_matrices(points: Array, nodes: NDArray[np.int64], material: Material) -> ElementMatrices:
    """Stiffness and lumped mass of elements of the same orders.

    With local derivatives ``D``, quadrature weights ``w``, the inverse Jacobian ``G`` and elasticity
    ``c``, the stiffness of nodes I, J is the sum over points of ``D_a[q, I] C_ab[q] D_b[q, J]`` where
    ``C_ab = w det(J) G_ak c_ikjl G_bl``. For a = b the points share two indices with both nodes, for
    a != b the sum has a single term.

    Parameters
    ----------
    points : (n, 3) positions of a mesh's nodes, m
    nodes : (elements, n1, n2, n3) node numbers
    material : what the elements are made of
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

    K = np.zeros((len(nodes), *sizes, *sizes, 3, 3))
    np.einsum("xabcdbcij->xabcdij", K)[...] += np.einsum(
        "qa,qd,xqbcij->xabcdij", D1, D1, C[0, 0], optimize=True
    )
    np.einsum("xabcaecij->xabceij", K)[...] += np.einsum(
        "qb,qe,xaqcij->xabceij", D2, D2, C[1, 1], optimize=True
    )
    np.einsum("xabcabfij->xabcfij", K)[...] += np.einsum(
        "qc,qf,xabqij->xabcfij", D3, D3, C[2, 2], optimize=True
    )
    np.einsum("xabcdecij->xabcdeij", K)[...] += np.einsum(
        "da,be,xdbcij->xabcdeij", D1, D2, C[0, 1], optimize=True
    )
    np.einsum("xabcdbfij->xabcdfij", K)[...] += np.einsum(
        "da,cf,xdbcij->xabcdfij", D1, D3, C[0, 2], optimize=True
    )
    np.einsum("xabcaefij->xabcefij", K)[...] += np.einsum(
        "eb,cf,xaecij->xabcefij", D2, D3, C[1, 2], optimize=True
    )
    np.einsum("xabcdecij->xabcdeij", K)[...] += np.einsum(
        "eb,ad,xaecij->xabcdeij", D2, D1, C[1, 0], optimize=True
    )
    np.einsum("xabcdbfij->xabcdfij", K)[...] += np.einsum(
        "fc,ad,xabfij->xabcdfij", D3, D1, C[2, 0], optimize=True
    )
    np.einsum("xabcaefij->xabcefij", K)[...] += np.einsum(
        "fc,be,xabfij->xabcefij", D3, D2, C[2, 1], optimize=True
    )
    count = nodes[0].size
    return ElementMatrices(
        stiffness=K.reshape(len(nodes), count, count, 3, 3),
        mass=material.density * volume.reshape(len(nodes), count),
    )
