"""Exact derivatives of frequencies with respect to all variable numbers of a cell.

For a mode u of unit mass and eigenvalue L = omega^2 the derivative with respect to a parameter is
``u* (K' - L M') u``. Sizes move the nodes of the mesh. With their velocity V (m per unit of the parameter)
the derivative of the discrete energies is, point by point of the quadrature,

    [s(u): grad u] div V - 2 s(u): (grad u grad V)     and     density |u|^2 div V,

because K and M depend on the nodes only through the Jacobian at these points. The trace may have fewer levels
than the mesh; the map between the two changes with the sizes as well, which adds ``2 v* (K - L M) u`` with
the change v of the displacement at the lateral faces.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array, Fields
from haptonic.bloch.exact import ExactModes
from haptonic.cell import HexMesh, PlacedTile, TileShape, UnitCell, mesh_cell
from haptonic.cell.mesh import along_rim
from haptonic.cell.quadrature import lobatto
from haptonic.cell.sectors import sectors
from haptonic.cell.stack import Stack
from haptonic.design.discs import with_shared
from haptonic.design.parameters import UNITS, values_of
from haptonic.errors import GeometryError
from haptonic.fields import unchecked
from haptonic.materials import IsotropicMaterial, Material, elasticity_tensor
from haptonic.superelement import FoldedMesh, TiledMesh, through_levels

MATERIAL = "material."  # in a path, before the name of a constant of a material
SAME_BLOCKS = 1e-2  # of a piece of an outline: largest shift of the ends of blocks between two meshes
Directions = Mapping[str, Mapping[str, float]]
"""By the name of a parameter, derivatives of numbers of the cell with respect to it."""
STEP = 1e-5  # of differences of the nodes' positions, relative to the parameter's scale


@dataclass(frozen=True)
class Sensitivity:
    """Derivatives of the frequency of degenerate modes with respect to numbers of a cell.

    frequency : Hz
    slopes : by path, (k,) Hz per SI unit, ascending: degenerate modes split as the parameter grows, each with
        its own slope
    """

    frequency: float
    slopes: dict[str, Array]


def sensitivity(
    shared: TiledMesh, modes: ExactModes, paths: Sequence[str] | None = None,
    directions: Directions = MappingProxyType({}),
) -> Sensitivity:  # fmt: skip
    """Derivatives of the frequency of exact modes with respect to parameters, by default all of them."""
    chosen = list(values_of(shared.cell)) if paths is None else paths
    derivatives = eigenvalue_derivatives(
        shared, modes.fields, modes.trace, np.array([modes.omega**2]), chosen, directions
    )
    per_hertz = 1.0 / (4 * np.pi * modes.omega)  # L = (2 pi f)^2
    slopes = {path: np.linalg.eigvalsh(form) * per_hertz for path, form in derivatives.items()}
    return Sensitivity(modes.omega / (2 * np.pi), slopes)


def eigenvalue_derivatives(
    shared: TiledMesh, fields: Fields, trace: Fields, values: Array, paths: Sequence[str],
    directions: Directions = MappingProxyType({}),
) -> dict[str, Fields]:  # fmt: skip
    """``u_i* (K' - L_j M') u_j`` by path, (k, k) each in (rad/s)^2 per SI unit.

    The diagonal contains the derivatives of the eigenvalues; for degenerate modes the whole block matters.

    Parameters
    ----------
    shared : the meshes of the tiles
    fields : (nodes, 3, k) modes of unit mass
    trace : (t, k) the unknowns on their sides
    values : (k,) their eigenvalues L, (rad/s)^2, or (1,) if all are equal
    paths : numbers of the cell, or names of ``directions``
    directions : by name, derivatives of several numbers of the cell with respect to one parameter
    """
    joint, start, cell = shared.joint, 0, shared.cell
    derivatives = {path: np.zeros((fields.shape[2],) * 2, dtype=complex) for path in paths}
    moving = {
        path: directions[path] if path in directions
        else {path: 1.0} if MATERIAL in path
        else with_shared(cell, {path: 1.0})
        for path in paths
    }  # fmt: skip
    sizes = {
        path: {at: slope for at, slope in numbers.items() if MATERIAL not in at}
        for path, numbers in moving.items()
    }
    cells_beside = {path: _beside(cell, path, numbers) for path, numbers in sizes.items() if numbers}
    for number, mesh in enumerate(shared.meshes):
        end = start + mesh.mesh.topology.nodes
        tile_fields = joint.placed[number].turn.T @ fields[start:end]
        tile_trace = joint.turned(number, trace[joint.of_tile(number)], back=True)
        energies = _Energies.of(mesh.mesh, mesh.cell, tile_fields, values)
        for path in paths:
            form = np.zeros_like(derivatives[path])
            for (constant, region), slope in _constants(cell, number, moving[path]).items():
                form = form + slope * energies.by_constant(constant, {region})
            if path in cells_beside:
                velocity, of_trace = _velocities(mesh, joint.placed[number], number, *cells_beside[path])
                form = form + energies.by_motion(velocity)
                if np.abs(of_trace).max() > 0:
                    form = form + energies.by_displacement(_on_rim(mesh, of_trace, tile_trace))
            derivatives[path] = derivatives[path] + form
        start = end
    return derivatives


def _constants(cell: UnitCell, number: int, moving: Mapping[str, float]) -> dict[tuple[str, int], float]:
    """Slopes of the constants of materials in a tile, by constant and region; regions share a material."""
    slopes: dict[tuple[str, int], float] = {}
    for path, slope in moving.items():
        if MATERIAL in path:
            table, _, constant = path.rpartition(".")
            slopes |= {(constant, region): slope for region in _regions(cell, number, table)}
    return slopes


def _regions(cell: UnitCell, number: int, table: str) -> set[int]:
    """Numbers of the regions of a tile, see `TileShape.solids`, whose material is in a table of the study."""
    feature, below = cell.features[number], cell.table_of(number)
    if isinstance(feature, Stack):
        of_disc = {
            f"{below}disc[{n}].material": disc.material for n, disc in enumerate(feature.discs, start=1)
        }
        own = {at: 1 + feature.solids.index(solid) for at, solid in of_disc.items() if solid is not None}
    else:
        own = {f"{below}pillar.material": 1} if feature is not None and feature.material is not None else {}
    if table == "material":
        return {0} if isinstance(feature, Stack) or own else {0, 1}
    return {own[table]} if table in own else set()


def _beside(cell: UnitCell, path: str, moving: Mapping[str, float]) -> tuple[UnitCell, UnitCell, float]:
    """Cells with a slightly larger and a slightly smaller parameter, and the difference of the two.

    ``moving`` : sizes and angles of the cell that change with the parameter, with their derivatives

    Raises
    ------
    GeometryError : one of them is not possible, for example because four tiles no longer meet in a point
    """
    here = cell.numbers()
    step = STEP / max(
        abs(slope) / (1.0 if UNITS[at] == "rad" else abs(here[at])) for at, slope in moving.items()
    )
    try:
        ahead, behind = (
            cell.with_numbers({at: here[at] + sign * step * slope for at, slope in moving.items()})
            for sign in (1, -1)
        )
    except GeometryError as error:
        raise GeometryError.conflict(
            argument=path,
            given=error.given,
            allowed=f"a number that can be a little larger and smaller; {error.allowed}",
            cause=f"it has no slope: {error.cause}",
            next_step="leave it out, or move the design away from this limit by a hundredth",
        ) from None
    return ahead, behind, 2 * step


def _velocities(
    shared: FoldedMesh, placed: PlacedTile, number: int, ahead: UnitCell, behind: UnitCell, apart: float
) -> tuple[Array, Array]:
    """Derivatives of the nodes (nodes, 3) of a tile, and of the map from its trace to its levels.

    They are differences of smooth closed formulas, accurate to ten digits; the tile keeps its axes.
    """
    plan = shared.mesh.topology.plan
    meshes, ends = [], list[Array]()
    for cell in (ahead, behind):
        tile = cell.tile_like(number, placed)
        assert len(tile.corners) == plan.sides, "a tile keeps its sides"
        mesh = mesh_cell(tile, plan)
        meshes.append((mesh.points, through_levels(tile, mesh, shared.levels)))
        ends.append(np.concatenate([around.place for around in sectors(tile, plan.blocks, plan.thin_around)]))
    (here, map_ahead), (there, map_behind) = meshes
    if np.abs(ends[0] - ends[1]).max() > SAME_BLOCKS:
        raise GeometryError.unsupported(
            argument="cell.pillar.section" if tile.stack is None else "cell.disc.section",
            given="a size near which the mesh changes its blocks",
            allowed="a design around which one mesh can be followed",
            cause="the corners of the section are equally near to two ends of blocks",
            next_step="change the size by a hundredth, or vary it in a [[sweep]]",
        )
    return (here - there) / apart, (map_ahead - map_behind) / apart


def _on_rim(shared: FoldedMesh, of_trace: Array, trace: Fields) -> Fields:
    """(nodes, 3, k) displacement from a change of the map from the trace to the rim."""
    topology = shared.mesh.topology
    moved = np.zeros((topology.nodes, 3, trace.shape[1]), dtype=complex)
    on_levels = np.tensordot(of_trace, trace.reshape(shared.levels, topology.plan.rim_nodes, 3, -1), axes=1)
    on_nodes = np.tensordot(along_rim(topology.plan), on_levels, axes=(1, 1))
    moved[topology.rim] = on_nodes.swapaxes(0, 1)
    return moved


@dataclass(frozen=True)
class _Energies:
    """Modes at the quadrature points of every family of elements, each region separately.

    gradient : (points, 3, 3, k)
    stress : the same, times volume
    momentum : (points, 3, k) density times volume times displacement

    solids : material of each part
    regions : number of this material, see `TileShape.solids`
    """

    frames: tuple[_Frame, ...]
    solids: tuple[Material, ...]
    regions: tuple[int, ...]
    fields: Fields
    gradient: tuple[Fields, ...]
    stress: tuple[Fields, ...]
    momentum: tuple[Fields, ...]
    values: Array

    @classmethod
    def of(cls, mesh: HexMesh, tile: TileShape, fields: Fields, values: Array) -> _Energies:
        parts = [
            (family.nodes[family.region == region], int(region))
            for family in mesh.topology.families
            for region in np.unique(family.region)
        ]
        frames = tuple(_Frame.of(mesh.points, nodes) for nodes, _ in parts)
        solids = tuple(tile.solids[region] for _, region in parts)
        gradient = tuple(frame.gradient(fields) for frame in frames)
        return cls(
            frames=frames,
            solids=solids,
            regions=tuple(region for _, region in parts),
            fields=fields,
            gradient=gradient,
            stress=tuple(
                _stress(elasticity_tensor(solid.stiffness), g, frame)
                for solid, g, frame in zip(solids, gradient, frames, strict=True)
            ),
            momentum=tuple(
                solid.density * frame.volume[:, None, None] * fields[frame.nodes.ravel()]
                for solid, frame in zip(solids, frames, strict=True)
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

    def by_constant(self, constant: str, regions: set[int]) -> Fields:
        """Derivative with respect to a constant of the material of some regions."""
        total = np.zeros((self.fields.shape[2],) * 2, dtype=complex)
        for part, (frame, solid) in enumerate(zip(self.frames, self.solids, strict=True)):
            if self.regions[part] not in regions:
                continue
            if constant == "density":
                moved = self.fields[frame.nodes.ravel()]
                total -= self.values * _product(moved, self.momentum[part]) / solid.density
            else:
                gradient = self.gradient[part]
                tensor = elasticity_tensor(_stiffness_slope(solid, constant))
                total += _product(gradient, _stress(tensor, gradient, frame))
        return total


@dataclass(frozen=True)
class _Frame:
    """Geometry of one family of elements at all its points, elements one after the other.

    nodes : (elements, n1, n2, n3)
    inverse : (points, 3, 3) d(local)/d(space), first axis of space
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
    """(k, k) sums of conj(left_i) right_j over all axes but the last."""
    return np.asarray(left.reshape(-1, left.shape[-1]).conj().T @ right.reshape(-1, right.shape[-1]))


def _stiffness_slope(solid: Material, constant: str) -> Array:
    """(6, 6) derivative of the stiffness with respect to a constant, Pa per unit of the constant."""
    if isinstance(solid, IsotropicMaterial) and constant == "poisson_ratio":
        return _poisson_slope(solid)
    stiffness = solid.stiffness  # linear in every other constant, so that any difference is exact
    step = float(stiffness.max())
    changed = unchecked(solid, **{constant: getattr(solid, constant) + step})
    return (changed.stiffness - stiffness) / step


def _poisson_slope(material: IsotropicMaterial) -> Array:
    """(6, 6) derivative of the stiffness with respect to Poisson's ratio, Pa."""
    E, nu = material.youngs_modulus, material.poisson_ratio
    lame = E * (1 + 2 * nu**2) / ((1 + nu) * (1 - 2 * nu)) ** 2
    slope = np.diag(-E / (2 * (1 + nu) ** 2) * np.array([2.0, 2, 2, 1, 1, 1]))
    slope[:3, :3] += lame
    return slope
