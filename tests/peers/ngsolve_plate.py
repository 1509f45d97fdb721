"""Free vibration of a whole plate with a few pillars with NGSolve: tetrahedra on one OpenCascade solid.

As in `ngsolve_cell`, nothing comes from haptonic; lengths are scaled by the pitch, E and rho are 1.
"""

import ngsolve as ng
import numpy as np
from netgen.occ import Box, Cylinder, OCCGeometry, X, Z, gp_Pnt
from scipy.sparse.linalg import LinearOperator, eigsh

from peers.ngsolve_cell import FOOT_RATIO, PeerCell, _assembled, _direct_solver

SHIFT = -1e-4


def plate_frequencies(cell: PeerCell, size, centres, count, *, order=3, maxh=0.6, layers=2, clamped=False):
    """(count,) lowest frequencies, Hz, of a rectangular plate; six of a free one are about 0.

    layers : of refinement towards the feet of the pillars
    size : (along x, along y), m; centres : (x, y) of the pillars, m; clamped : the face at x = 0 is held
    """
    unit = cell.pitch_x
    thickness, radius, height = cell.thickness / unit, cell.diameter / 2 / unit, cell.height / unit
    solid = Box((0, 0, 0), (size[0] / unit, size[1] / unit, thickness))
    for x, y in centres:
        solid += Cylinder(gp_Pnt(x / unit, y / unit, thickness), Z, r=radius, h=height)
    places = np.array(centres) / unit
    at_foot = [
        edge
        for edge in solid.edges
        if abs(edge.center.z - thickness) < 1e-9
        and np.linalg.norm(places - [edge.center.x, edge.center.y], axis=1).min() < 1e-6
    ]
    assert len(at_foot) == 2 * len(centres), "each edge is listed for either of its faces"
    for edge in at_foot:
        edge.hpref = 1
        edge.maxh = 0.6 * radius
    held = solid.faces.Min(X)
    held.name = "held"
    if clamped:  # where the stress is singular too
        for edge in held.edges:
            edge.maxh = 0.5 * thickness
    mesh = ng.Mesh(
        OCCGeometry(solid).GenerateMesh(maxh=maxh, grading=0.5, curvaturesafety=1.0, parallel_meshing=False)
    )
    if layers:
        mesh.RefineHP(layers, factor=FOOT_RATIO)
    mesh.Curve(order)
    space = ng.VectorH1(mesh, order=order, dirichlet="held" if clamped else "")
    stiffness, mass = _assembled(space, cell.poisson_ratio)
    shifted = stiffness.CreateMatrix()
    shifted.AsVector().data = stiffness.AsVector() - SHIFT * mass.AsVector()
    inverse = shifted.Inverse(space.FreeDofs(), inverse=_direct_solver())
    source, target = stiffness.CreateColVector(), stiffness.CreateColVector()
    free = np.array(list(space.FreeDofs()), dtype=float)

    def operator(matrix):
        def apply(values):
            source.FV().NumPy()[:] = free * values
            target.data = matrix * source
            return free * target.FV().NumPy()

        return LinearOperator((len(source), len(source)), matvec=apply, dtype=float)

    squared = eigsh(
        operator(stiffness),
        k=count,
        M=operator(mass),
        sigma=SHIFT,
        OPinv=operator(inverse),
        v0=free * np.random.default_rng(1).standard_normal(len(source)),
        tol=1e-9,
        return_eigenvectors=False,
    )
    return cell.frequency_unit * np.sqrt(np.maximum(np.sort(squared), 0.0))
