"""What tests of bodies share: fields with a known strain, a patch, solutions without supports."""

import numpy as np
import scipy.sparse as sp
from scipy.sparse.linalg import splu

from haptonic.plate.layout.parts import Actuator


def patch(material, size=(11.5e-3, 8e-3, 0.7e-3), centre=(0.0, 0.0), bond=None, name="A"):
    return Actuator(name, centre, size, material, bond)


def total(body):
    """The whole stiffness, all electrodes at given voltage."""
    return sp.csc_array(sum(body.stiffness.values()))


def settled(body, forces, also_held=()):
    """(3 nodes,) displacement under forces in balance; six components of three far points are held at 0.

    also_held : numbers of more components that vanish
    """
    points, K = body.points, total(body)
    low, high = points.min(axis=0), points.max(axis=0)
    corners = [low, (high[0], low[1], low[2]), (low[0], high[1], low[2])]
    origin, right, back = (np.linalg.norm(points - corner, axis=1).argmin() for corner in corners)
    held = [3 * origin, 3 * origin + 1, 3 * origin + 2, 3 * right + 1, 3 * right + 2, 3 * back + 2]
    free = np.setdiff1d(np.arange(K.shape[0]), [*held, *also_held])
    u = np.zeros(K.shape[0])
    u[free] = factorised(K[free][:, free]).solve(forces[free])
    return u


def factorised(K):
    """SciPy's LU of a definite matrix, in the order that suits a symmetric one."""
    return splu(sp.csc_array(K), permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True})
