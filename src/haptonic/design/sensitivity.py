"""Exact derivatives of frequencies with respect to everything that can be changed in a cell.

For a mode u of unit mass and eigenvalue L = omega^2 the derivative with respect to a parameter is
``u* (K' - L M') u``. Sizes move the nodes of the mesh. With their velocity V (m per unit of the parameter)
the derivative of the discrete energies is, point by point of the quadrature,

    [s(u): grad u] div V - 2 s(u): (grad u grad V)     and     density |u|^2 div V,

because K and M depend on the nodes through the Jacobian at these points alone. The trace may have fewer
levels than the mesh; the map between the two changes with the sizes as well, which adds ``2 v* (K - L M) u``
with the change v of the displacement at the lateral faces.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.bloch.exact import ExactModes
from haptonic.cell import HexMesh, mesh_cell
from haptonic.cell.quadrature import lobatto
from haptonic.design.parameters import UNITS, values_of
from haptonic.materials import IsotropicMaterial, Material, elasticity_tensor
from haptonic.superelement import FoldedMesh, through_levels

Array = NDArray[np.float64]
Fields = NDArray[Any]  # real or complex

STEP = 1e-5  # of differences of the nodes' positions, relative to the parameter's scale


@dataclass(frozen=True)
class Sensitivity:
    """How the frequency of degenerate modes changes with the numbers of a cell.

    frequency : Hz
    slopes : by path, (k,) Hz per SI unit, ascending: as the parameter grows degenerate modes part, each with
        its own slope
    """

    frequency: float
    slopes: dict[str, Array]


def sensitivity(shared: FoldedMesh, modes: ExactModes, paths: Sequence[str] | None = None) -> Sensitivity:
    """Derivatives of the frequency of exact modes with respect to parameters, by default all of them."""
    chosen = list(values_of(shared.cell)) if paths is None else paths
    derivatives = eigenvalue_derivatives(
        shared, modes.fields, modes.trace, np.array([modes.omega**2]), chosen
    )
    per_hertz = 1.0 / (4 * np.pi * modes.omega)  # L = (2 pi f)^2
    slopes = {path: np.linalg.eigvalsh(form) * per_hertz for path, form in derivatives.items()}
    return Sensitivity(modes.omega / (2 * np.pi), slopes)


def eigenvalue_derivatives(
    shared: FoldedMesh, fields: Fields, trace: Fields, values: Array, paths: Sequence[str]
) -> dict[str, Fields]:
    """``u_i* (K' - L_j M') u_j`` by path, (k, k) each in (rad/s)^2 per SI unit.

    The diagonal holds the derivatives of the eigenvalues; between degenerate modes the whole block counts.

    Parameters
    ----------
    shared : the mesh
    fields : (nodes, 3, k) modes of unit mass; trace : (t, k) the unknowns behind their sides
    values : (k,) their eigenvalues L, (rad/s)^2, or (1,) for all alike
    """
    energies = _Energies.of(shared.mesh, shared.cell.material, fields, values)
    found = {}
    for path in paths:
        if path.startswith("material."):
            found[path] = energies.by_material(path.removeprefix("material."), shared.cell.material)
        else:
            velocity, of_trace = _velocities(shared, path)
            found[path] = energies.by_motion(velocity)
            if np.abs(of_trace).max() > 0:
                found[path] = found[path] + energies.by_displacement(_on_rim(shared, of_trace, trace))
    return found


def _velocities(shared: FoldedMesh, path: str) -> tuple[Array, Array]:
    """Of the nodes (nodes, 3) and of the map from the trace to the mesh's levels, per unit of a parameter.

    Differences of smooth closed formulas, good to ten digits.
    """
    cell, plan = shared.cell, shared.mesh.topology.plan
    here = values_of(cell)[path]
    step = STEP * (1.0 if UNITS[path] == "rad" else here)
    meshes = []
    for sign in (1, -1):
        cell_there = cell.with_numbers({path: here + sign * step})
        mesh = mesh_cell(cell_there, plan)
        meshes.append((mesh.points, through_levels(cell_there, mesh, shared.levels)))
    (ahead, map_ahead), (behind, map_behind) = meshes
    return (ahead - behind) / (2 * step), (map_ahead - map_behind) / (2 * step)


def _on_rim(shared: FoldedMesh, of_trace: Array, trace: Fields) -> Fields:
    """(nodes, 3, k) displacement that follows from a change of the map from the trace to the rim."""
    rim = shared.mesh.topology.rim
    moved = np.zeros((shared.mesh.topology.nodes, 3, trace.shape[1]), dtype=complex)
    moved[rim] = np.tensordot(of_trace, trace.reshape(shared.levels, rim.shape[1], 3, -1), axes=1)
    return moved


@dataclass(frozen=True)
class _Energies:
    """Modes seen at the quadrature points of every family of elements: (points, 3, 3, k) gradients, stresses
    times volume, (points, 3, k) momenta (density times volume times displacement)."""

    frames: tuple[_Frame, ...]
    fields: Fields
    gradient: tuple[Fields, ...]
    stress: tuple[Fields, ...]
    momentum: tuple[Fields, ...]
    values: Array

    @classmethod
    def of(cls, mesh: HexMesh, material: Material, fields: Fields, values: Array) -> _Energies:
        frames = tuple(_Frame.of(mesh.points, family.nodes) for family in mesh.topology.families)
        tensor = elasticity_tensor(material.stiffness)
        gradient = tuple(frame.gradient(fields) for frame in frames)
        return cls(
            frames=frames,
            fields=fields,
            gradient=gradient,
            stress=tuple(_stress(tensor, g, f) for g, f in zip(gradient, frames, strict=True)),
            momentum=tuple(
                material.density * f.volume[:, None, None] * fields[f.nodes.ravel()] for f in frames
            ),
            values=values,
        )

    def by_motion(self, velocity: Array) -> Fields:
        """Derivative with respect to a motion of the nodes with a velocity (nodes, 3)."""
        total = np.zeros((self.fields.shape[2],) * 2, dtype=complex)
        for frame, g, s, p in zip(self.frames, self.gradient, self.stress, self.momentum, strict=True):
            slope = frame.gradient(velocity[:, :, None])[..., 0]
            growth = np.trace(slope, axis1=1, axis2=2)
            turned = np.einsum("pcik,pij->pcjk", g, slope)
            across = _product(turned, s)
            total += _product(growth[:, None, None, None] * g, s) - across - across.conj().T
            moved = self.fields[frame.nodes.ravel()]
            total -= self.values * _product(growth[:, None, None] * moved, p)
        return total

    def by_displacement(self, change: Fields) -> Fields:
        """Derivative with respect to a change (nodes, 3, k) of the modes' own values."""
        total = np.zeros((self.fields.shape[2],) * 2, dtype=complex)
        for frame, s, p in zip(self.frames, self.stress, self.momentum, strict=True):
            moved = change[frame.nodes.ravel()]
            total += _product(frame.gradient(change), s) - self.values * _product(moved, p)
        return total + total.conj().T

    def by_material(self, name: str, material: Material) -> Fields:
        """Derivative with respect to a constant of the material."""
        unit = np.eye(self.fields.shape[2], dtype=complex)
        if name == "density":
            return np.asarray(-self.values / material.density * unit)
        assert isinstance(material, IsotropicMaterial)
        if name == "youngs_modulus":
            return np.asarray(self.values / material.youngs_modulus * unit)
        tensor = elasticity_tensor(_poisson_slope(material))
        pairs = zip(self.frames, self.gradient, strict=True)
        return np.asarray(sum(_product(g, _stress(tensor, g, frame)) for frame, g in pairs))


@dataclass(frozen=True)
class _Frame:
    """Geometry of one family of elements at all its points, elements one after the other.

    nodes : (elements, n1, n2, n3); inverse : (points, 3, 3) d(local)/d(space), first axis of space
    volume : (points,) of each point's share, m^3
    """

    nodes: NDArray[np.int64]
    inverse: Array
    volume: Array

    @classmethod
    def of(cls, points: Array, nodes: NDArray[np.int64]) -> _Frame:
        jacobian = _local_slopes(points[:, :, None], nodes)[..., 0]  # (points, local, space)
        weights = [lobatto(n - 1)[1] for n in nodes.shape[1:]]
        share = np.einsum("a,b,c->abc", *weights).ravel()
        volume = np.linalg.det(jacobian) * np.tile(share, len(nodes))
        return cls(nodes, np.linalg.inv(jacobian), volume)

    def gradient(self, fields: Fields) -> Fields:
        """(points, 3, 3, k) of fields (nodes, 3, k): component, then direction."""
        return np.asarray(np.einsum("pia,pack->pcik", self.inverse, _local_slopes(fields, self.nodes)))


def _local_slopes(fields: Fields, nodes: NDArray[np.int64]) -> Fields:
    """(points, 3 local, 3, k) derivatives of fields (nodes, 3, k) along the elements' own axes."""
    inside = fields[nodes]
    D1, D2, D3 = (lobatto(n - 1)[2] for n in nodes.shape[1:])
    slopes = np.stack(
        [
            np.einsum("qa,xabcik->xqbcik", D1, inside),
            np.einsum("qb,xabcik->xaqcik", D2, inside),
            np.einsum("qc,xabcik->xabqik", D3, inside),
        ],
        axis=4,
    )
    return np.asarray(slopes.reshape(-1, 3, *fields.shape[1:]))


def _stress(tensor: Array, gradient: Fields, frame: _Frame) -> Fields:
    stress = np.einsum("iajb,pjbk->piak", tensor, gradient)
    return np.asarray(frame.volume[:, None, None, None] * stress)


def _product(left: Fields, right: Fields) -> Fields:
    """(k, k) sums of conj(left_i) right_j over everything but the last axis."""
    return np.asarray(left.reshape(-1, left.shape[-1]).conj().T @ right.reshape(-1, right.shape[-1]))


def _poisson_slope(material: IsotropicMaterial) -> Array:
    """(6, 6) derivative of the stiffness with respect to Poisson's ratio, Pa."""
    E, nu = material.youngs_modulus, material.poisson_ratio
    lame = E * (1 + 2 * nu**2) / ((1 + nu) * (1 - 2 * nu)) ** 2
    slope = np.diag(-E / (2 * (1 + nu) ** 2) * np.array([2.0, 2, 2, 1, 1, 1]))
    slope[:3, :3] += lame
    return slope
