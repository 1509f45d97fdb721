"""Motion of a pillar's sections, by which bending, torsion and axial motion are distinguished."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.cell import HexMesh
from haptonic.later import sparse as sp
from haptonic.superelement.symmetry import Folding


@dataclass(frozen=True)
class PillarSections:
    """Rigid-body part of the motion of each horizontal layer of nodes of the pillar.

    With a pillar on each face, a layer is that of both pillars.

    height : (sections,) above the plate's flat face, m
    mass : (sections,) kg; inertia : (sections,) about the pillar's axis, kg m^2
    motion : (4, sections, t + m) linear forms on the unknowns of a superelement: momentum along x, y, z
        (kg m) and angular momentum about the axis (kg m^2), each per rad/s
    """

    height: Array
    mass: Array
    inertia: Array
    motion: Array

    def energies(self, fields: NDArray[np.complex128]) -> Array:
        """Kinetic energies (3, k) of the pillar's bending, axial and twisting motion.

        ``fields`` is (t + m, k); the result is ``u* M u`` in kg m^2.
        """
        moved = np.abs(self.motion @ fields) ** 2
        along = np.einsum("csk,s->ck", moved[:3], 1.0 / self.mass)
        return np.stack([along[0] + along[1], along[2], np.einsum("sk,s->k", moved[3], 1.0 / self.inertia)])

    def rising(self, fields: NDArray[np.complex128]) -> Array:
        """Kinetic energy (k,) of a pillar whose vertical motion equals that of its foot, in kg m^2."""
        foot = np.abs(self.motion[2, 0] @ fields) / self.mass[0]
        return np.asarray(self.mass.sum() * foot**2)

    def against_foot(self, fields: NDArray[np.complex128]) -> Array:
        """Kinetic energy (k,) of all motions of the pillar relative to its foot, in kg m^2."""
        weight = np.stack([self.mass] * 3 + [self.inertia])[:, :, None]
        moved = (self.motion @ fields) / weight
        return np.asarray((weight * np.abs(moved - moved[:, :1]) ** 2).sum(axis=(0, 1)))

    def bending_nodes(self, fields: NDArray[np.complex128]) -> NDArray[np.int64]:
        """(k,) number of nodes of the bent pillar axis above its foot, as of a cantilever.

        Displacements are relative to the foot, in the direction and phase of the largest motion.
        """
        path = (self.motion[:2] @ fields) / self.mass[:, None]
        path -= path[:, :1]
        # best real profiles: leading singular vectors of (direction and phase) x sections
        rows = np.moveaxis(np.concatenate([path.real, path.imag]), 2, 0)
        profiles = np.linalg.svd(rows, full_matrices=False)[2][:, 0]
        count = np.empty(len(profiles), dtype=np.int64)
        for k, profile in enumerate(profiles):
            strong = profile[np.abs(profile) > 0.02 * np.abs(profile).max()]
            count[k] = int((np.diff(np.sign(strong)) != 0).sum())
        return count


def section_levels(mesh: HexMesh) -> tuple[Array, NDArray[np.int64], NDArray[np.int64]]:
    """Heights of the upper pillar's node levels, and number and level of each of its nodes."""
    starts = mesh.topology.pillar_start
    nodes = np.arange(starts[0], starts[-1])
    level = np.repeat(np.arange(len(starts) - 1), np.diff(starts))
    return mesh.points[starts[:-1], 2], nodes, level


def momentum_forms(mesh: HexMesh, folding: Folding, symmetry_class: int, nodal_mass: Array) -> sp.csr_array:
    """(4 sections, 3 representatives) sparse: momenta from the values of one class, boundary included."""
    heights, nodes, level = section_levels(mesh)
    count = len(heights)
    x, y = mesh.points[nodes, 0], mesh.points[nodes, 1]
    m = mesh.topology.faces * nodal_mass[nodes]  # the image of a pillar on the other face has the same motion
    sign = folding.sign[symmetry_class][nodes].astype(float)
    unknown = 3 * folding.node[nodes]
    entries = [(c, c, m) for c in range(3)] + [(3, 1, m * x), (3, 0, -m * y)]
    rows = np.concatenate([row * count + level for row, _, _ in entries])
    columns = np.concatenate([unknown + c for _, c, _ in entries])
    values = np.concatenate([weight * sign[:, c] for _, c, weight in entries])
    return sp.csr_array((values, (rows, columns)), shape=(4 * count, 3 * len(folding.origin)))


def section_sizes(mesh: HexMesh, nodal_mass: Array) -> Array:
    """(3, sections) height (m), mass (kg) and inertia about the axis (kg m^2) of a mesh's pillar sections."""
    heights, nodes, level = section_levels(mesh)
    m = mesh.topology.faces * nodal_mass[nodes]
    arm = m * (mesh.points[nodes, :2] ** 2).sum(axis=1)
    return np.stack([heights, *(np.bincount(level, weight, minlength=len(heights)) for weight in (m, arm))])
