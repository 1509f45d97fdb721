"""Linear displacements that tests of elements and of bodies share."""

import numpy as np

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
