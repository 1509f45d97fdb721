"""What tests of bodies share: fields with a known strain, a patch, solutions without supports."""

import numpy as np
import scipy.sparse as sp
from scipy.sparse.linalg import splu

from haptonic.plate.parts import Actuator

SHEARED = [(1, 2), (0, 2), (0, 1)]


def unit_strains(points):
    """(6, 3 nodes) linear displacements with unit engineering strain 11, 22, 33, 23, 13, 12."""
    fields = np.zeros((6, *points.shape))
    for i in range(3):
        fields[i, :, i] = points[:, i]
        a, b = SHEARED[i]
        fields[3 + i, :, a] = points[:, b]  # not symmetric: the rotation in it must cost nothing
    return fields.reshape(6, -1)


def rigid_motions(points):
    """(6, 3 nodes) translations, then rotations about the axes."""
    motions = np.zeros((6, *points.shape))
    for i in range(3):
        motions[i, :, i] = 1.0
        motions[3 + i] = np.cross(np.eye(3)[i], points)
    return motions.reshape(6, -1)


def patch(material, size=(11.5e-3, 8e-3, 0.7e-3), centre=(0.0, 0.0), bond=None, name="A"):
    return Actuator(name, centre, size, material, bond)


def total(body):
    """The whole stiffness, all electrodes at given voltage."""
    return sp.csc_array(sum(body.stiffness.values()))


def settled(K, forces):
    """(3 nodes,) displacement under forces in balance; what rigid motion goes with it is arbitrary."""
    stiff = K + sp.diags_array(1e-9 * K.diagonal())
    solve = splu(sp.csc_array(stiff), permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True}).solve
    u = solve(forces)
    for _ in range(3):  # the springs hold back what strains, too, but little: iterate it away
        u = u + solve(forces - K @ u)
    return u
