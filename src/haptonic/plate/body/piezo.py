"""Piezoelectric hexahedra with a quasi-static potential: effect of the electric field inside a patch.

Same points and quadrature as the elastic elements. In Voigt order 11, 22, 33, 23, 13, 12 with engineering
shear, ``T = c^E S - e^T E``, ``D = e S + eps^S E``, ``E = -grad phi`` [ieee176]. Where c^E alone makes the
elastic stiffness K, the rest of the electric enthalpy ``1/2 S c^E S - E e S - 1/2 E eps^S E`` is
``phi A u - 1/2 phi P phi``, so that forces f and charges q on electrodes obey

    K u + A^T phi = f,    A u - P phi = -q.

No charge sits at the inner nodes i. With the free electrode t at the voltage V and the glued one at 0

    (K + A_i^T P_ii^-1 A_i) u = f + d V,    Q = C V + d u,
    d = -A_t^T + A_i^T P_ii^-1 P_it,    C = P_tt - P_ti P_ii^-1 P_it

with A_t, P_it, P_tt summed over the nodes of t. The same d drives and senses: reciprocity.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from haptonic.arrays import Array, Ints
from haptonic.cell.quadrature import lobatto
from haptonic.later import linalg as la
from haptonic.materials import PiezoelectricMaterial


@dataclass(frozen=True)
class ElectricMatrices:
    """Electric matrices of elements of equal orders; an element's unknowns are its nodes in raveled order.

    coupling : (elements, nodes, nodes, 3) A, of potentials (first) and displacements (last two axes), N/V
    permittivity : (elements, nodes, nodes) P of potentials, F
    """

    coupling: Array
    permittivity: Array


def electric_matrices(points: Array, nodes: Ints, material: PiezoelectricMaterial) -> ElectricMatrices:
    """Coupling ``integral of grad phi . e S`` and ``integral of grad phi . eps^S grad phi``.

    Parameters
    ----------
    points : (n, 3) positions of a mesh's nodes, m
    nodes : (elements, n1, n2, n3) node numbers
    material : of the elements, poled along z
    """
    sizes = nodes.shape[1:]
    rules = [lobatto(n - 1) for n in sizes]
    I1, I2, I3 = (np.eye(n) for n in sizes)
    D1, D2, D3 = (derivative for _, _, derivative in rules)
    # (3, points, nodes) local derivatives
    local = np.stack([np.kron(np.kron(D1, I2), I3), np.kron(np.kron(I1, D2), I3),
                      np.kron(np.kron(I1, I2), D3)])  # fmt: skip
    weights = np.einsum("a,b,c->abc", *(w for _, w, _ in rules)).ravel()
    x = points[nodes].reshape(len(nodes), -1, 3)
    jacobian = np.einsum("mqn,xnk->xqkm", local, x, optimize=True)
    volume = np.linalg.det(jacobian) * weights
    assert (volume > 0).all(), "an element is turned inside out"
    gradient = np.einsum("xqmk,mqn->xqkn", np.linalg.inv(jacobian), local, optimize=True)
    permittivity = np.array(material.permittivity)
    return ElectricMatrices(
        coupling=np.einsum(
            "xq,xqan,akl,xqlm->xnmk", volume, gradient, material.coupling_tensor, gradient, optimize=True
        ),
        permittivity=np.einsum(
            "xq,xqan,ab,xqbm->xnm", volume, gradient, permittivity, gradient, optimize=True
        ),
    )


@dataclass(frozen=True, eq=False)
class ElectricPart:
    """Effect of the electric field after elimination of the potentials inside.

    nodes : (m,) numbers of the patch's nodes, ascending
    stiffness : (3 m, 3 m) added to that of c^E, both electrodes at given voltage, N/m
    drive : (3 m,) d, force per volt on the free electrode, N/V
    capacitance : C, of the clamped patch, F
    """

    nodes: Ints
    stiffness: Array
    drive: Array
    capacitance: float


def electric_part(
    points: Array, nodes: Ints, material: PiezoelectricMaterial, glued: Ints, free: Ints
) -> ElectricPart:
    """Assemble a patch's electric matrices and eliminate the potentials between the electrodes.

    Parameters
    ----------
    points, nodes, material : as for `electric_matrices`, of the whole patch
    glued, free : node numbers of the electrode at 0 V and of the one at the voltage
    """
    own, local = np.unique(nodes, return_inverse=True)
    local = local.reshape(len(nodes), -1)
    count = len(own)
    A, P = np.zeros((count, count, 3)), np.zeros((count, count))
    elements = electric_matrices(points, nodes, material)
    for number, coupling, permittivity in zip(local, elements.coupling, elements.permittivity, strict=True):
        A[np.ix_(number, number)] += coupling
        P[np.ix_(number, number)] += permittivity
    top = np.isin(own, free)
    inner = ~top & ~np.isin(own, glued)
    A_t, P_it = A[top].sum(axis=0).ravel(), P[np.ix_(inner, top)].sum(axis=1)
    P_tt = float(P[np.ix_(top, top)].sum())
    if not inner.any():  # linear through the patch
        return ElectricPart(own, np.zeros((3 * count,) * 2), -A_t, P_tt)
    root = la.cholesky(P[np.ix_(inner, inner)], lower=True)
    seen = la.solve_triangular(root, A[inner].reshape(-1, 3 * count), lower=True)
    follows = la.solve_triangular(root, P_it, lower=True)
    return ElectricPart(
        nodes=own,
        stiffness=seen.T @ seen,
        drive=seen.T @ follows - A_t,
        capacitance=P_tt - float(follows @ follows),
    )
