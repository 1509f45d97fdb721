"""Spectral hexahedra: from a mesh to stiffness and lumped mass.

Nodes and quadrature points coincide (Gauss-Lobatto-Legendre), so the mass matrix is diagonal and most
sums in the stiffness collapse to a single product.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from haptonic.cell import HexMesh
from haptonic.cell.quadrature import lobatto
from haptonic.materials import Material, elasticity_tensor

Array = NDArray[np.float64]

@dataclass(frozen=True)
class ElementMatrices:
    """Per element, with nodes in the order of ``mesh.elements`` raveled.

    stiffness : (elements, nodes, nodes, 3, 3), N/m; the last axes are the two displacement components
    mass : (elements, nodes), kg; the same for each component
    """

    stiffness: Array
    mass: Array


def element_matrices(mesh: HexMesh, material: Material, chosen: NDArray[np.int64]) -> ElementMatrices:
    """Stiffness and lumped mass of some elements of a mesh.

    With local derivatives ``D``, quadrature weights ``w``, the inverse Jacobian ``G`` and elasticity
    ``c``, the stiffness of nodes I, J is the sum over points of ``D_a[q, I] C_ab[q] D_b[q, J]`` where
    ``C_ab = w det(J) G_ak c_ikjl G_bl``. For a = b the points share two indices with both nodes, for
    a != b the sum has a single term.

    Parameters
    ----------
    mesh, material : what to integrate
    chosen : numbers of the elements
    """
    n = mesh.order + 1
    _, w, D = lobatto(mesh.order)
    x = mesh.points[mesh.topology.elements[chosen]]
    jacobian = np.stack(
        [np.einsum("qa,xabck->xqbck", D, x), np.einsum("qb,xabck->xaqck", D, x),
         np.einsum("qc,xabck->xabqk", D, x)], axis=-1,
    )  # fmt: skip
    volume = np.linalg.det(jacobian) * (w[:, None, None] * w[:, None] * w)
    assert (volume > 0).all(), "an element is turned inside out"
    inverse = np.linalg.inv(jacobian)
    tensor = elasticity_tensor(material.stiffness)
    half = np.einsum("xabcmk,ikjl->xabcmijl", inverse, tensor, optimize=True)
    C = np.einsum("xabcmijl,xabcnl,xabc->mnxabcij", half, inverse, volume, optimize=True)

    K = np.zeros((len(chosen), *(n,) * 6, 3, 3))
    same = ("xabcdbcij->xabcdij", "xabcaecij->xabceij", "xabcabfij->xabcfij")
    sums = ("qa,qd,xqbcij->xabcdij", "qb,qe,xaqcij->xabceij", "qc,qf,xabqij->xabcfij")
    for a in range(3):
        np.einsum(same[a], K)[...] += np.einsum(sums[a], D, D, C[a, a], optimize=True)
    pairs = {
        (0, 1): ("xabcdecij->xabcdeij", "da,be,xdbcij->xabcdeij"),
        (0, 2): ("xabcdbfij->xabcdfij", "da,cf,xdbcij->xabcdfij"),
        (1, 2): ("xabcaefij->xabcefij", "eb,cf,xaecij->xabcefij"),
        (1, 0): ("xabcdecij->xabcdeij", "eb,ad,xaecij->xabcdeij"),
        (2, 0): ("xabcdbfij->xabcdfij", "fc,ad,xabfij->xabcdfij"),
        (2, 1): ("xabcaefij->xabcefij", "fc,be,xabfij->xabcefij"),
    }
    for (a, b), (where, what) in pairs.items():
        np.einsum(where, K)[...] += np.einsum(what, D, D, C[a, b], optimize=True)
    return ElementMatrices(
        stiffness=K.reshape(len(chosen), n**3, n**3, 3, 3),
        mass=material.density * volume.reshape(len(chosen), n**3),
    )
