"""The long way round: whole matrices of a mesh, periodic by projection, with nothing folded or condensed."""

import numpy as np
import scipy.sparse as sp
from scipy.sparse.linalg import eigsh

from haptonic.cell import HexMesh
from haptonic.elements import element_matrices


def dense(matrices):
    """(elements, 3 nodes, 3 nodes) stiffness of single elements from the contributions of their pairs."""
    elements, nodes = matrices.mass.shape
    K = np.zeros((elements, nodes, 3, nodes, 3))
    first, second = matrices.pairs
    for i, j in np.ndindex(3, 3):
        np.add.at(K, (slice(None), first, i, second, j), matrices.stiffness[..., i, j].T)
    return K.reshape(elements, 3 * nodes, 3 * nodes)


def assembled(mesh: HexMesh, *solids):
    """Stiffness (3 nodes, 3 nodes), sparse, and the diagonal (3 nodes,) of the mass.

    solids : materials by the numbers of the mesh's regions, or one for all
    """
    K, mass = sp.csr_array((mesh.unknowns,) * 2), np.zeros(mesh.unknowns)
    regions = [
        (family.nodes[family.region == region], solids[min(region, len(solids) - 1)])
        for family in mesh.topology.families
        for region in np.unique(family.region)
    ]
    for members, solid in regions:
        for start in range(0, len(members), 64):  # a fine mesh would need too much memory at once
            nodes = members[start : start + 64]
            matrices = element_matrices(mesh.points, nodes, solid)
            unknown = 3 * nodes.reshape(len(nodes), -1)[..., None] + np.arange(3)
            first, second = matrices.pairs
            shape = matrices.stiffness.shape
            rows = np.broadcast_to(unknown.swapaxes(0, 1)[first][..., :, None], shape)
            columns = np.broadcast_to(unknown.swapaxes(0, 1)[second][..., None, :], shape)
            entries = (matrices.stiffness.ravel(), (rows.ravel(), columns.ravel()))
            K = K + sp.coo_array(entries, shape=K.shape).tocsr()
            mass += np.bincount(unknown.ravel(), np.repeat(matrices.mass, 3, axis=1).ravel(), mesh.unknowns)
    return K, mass


def partners(points, translations):
    """For each point the number of the one that it repeats, and how many of each translation lie between.

    Found by coordinates alone; the one with the smallest coordinates along the translations is kept.
    """
    unit = np.linalg.norm(translations[0])
    # dual vectors count translations; a point belongs to the half-open cell
    dual = np.linalg.inv(translations)
    fractions = points[:, :2] @ dual
    fractions -= fractions.min(axis=0)
    shift = np.floor(fractions + 1e-9).astype(int)
    home = points.copy()
    home[:, :2] -= shift @ translations
    key = np.round(home / unit * 1e7).astype(np.int64)
    _, first, number = np.unique(key, axis=0, return_index=True, return_inverse=True)
    return number.ravel(), len(first), shift


def periodic_projection(points, translations, kappa, through=None, rim=None):
    """Sparse P with u = P u_free for a Bloch field at the phases ``kappa``.

    With ``through`` (levels of the mesh, levels of the trace) and ``rim`` (levels of the mesh, places)
    the field on the rim is besides a polynomial through the thickness, as in a superelement.
    """
    number, count, shift = partners(points, translations)
    phase = np.exp(1j * (shift @ np.asarray(kappa)))
    P = sp.csr_array((phase, (np.arange(len(points)), number)), shape=(len(points), count))
    if through is not None:
        on_rim = np.unique(number[rim])
        free = np.setdiff1d(np.arange(count), on_rim)
        columns, rows, values = [np.arange(len(free))], [free], [np.ones(len(free))]
        size = len(free)
        heads = sorted(set(number[rim[0]]))  # one for each place that repeats nothing
        place_of = {int(number[rim[0, p]]): p for p in range(rim.shape[1])}
        for head in heads:
            own = number[rim[:, place_of[int(head)]]]
            for level in range(through.shape[1]):
                rows.append(own)
                columns.append(np.full(len(own), size))
                values.append(through[:, level])
                size += 1
        Q = sp.csr_array(
            (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))), shape=(count, size)
        )
        P = P @ Q
    return sp.csr_array(sp.kron(P, sp.eye_array(3)))


def frequencies(K, mass, P, count):
    """(count,) lowest frequencies, Hz, by shift-invert Lanczos on the projected matrices."""
    adjoint = P.conj().T
    stiffness, inertia = sp.csc_array(adjoint @ K @ P), sp.csc_array(adjoint @ sp.diags_array(mass) @ P)
    size = stiffness.shape[0]
    start = np.random.default_rng(1).standard_normal(size).astype(complex)
    unit = np.abs(stiffness.diagonal()).max() / np.abs(inertia.diagonal()).max()
    values = eigsh(
        stiffness, k=count + 2, M=inertia, sigma=-1e-6 * unit, v0=start, tol=1e-12, return_eigenvectors=False
    )
    return np.sqrt(np.maximum(np.sort(values)[:count], 0.0)) / (2 * np.pi)
