"""Tilings: condensed tiles at their positions in one period of a plate or a ribbon, joined edge to edge.

Tiles are coupled by their traces only, so each is condensed separately, and equal tiles once. A cell of one
site is the tiling of a single tile. Unknowns are the traces of all tiles, then the amplitudes of all their
modes; `Joint` identifies equal places of the traces.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from haptonic.arrays import Array, Fields, Ints
from haptonic.cell import HexMesh, MeshPlan, Period, PlacedTile, SurfaceMesh, TileShape, UnitCell
from haptonic.later import linalg as la
from haptonic.lattice import HALF_TURN
from haptonic.superelement.condense import Superelement, condensed
from haptonic.superelement.dynamic import DynamicStiffness, dynamic_stiffness
from haptonic.superelement.folded import FoldedMesh
from haptonic.superelement.joint import Joint
from haptonic.superelement.measures import ENERGIES, Measures
from haptonic.superelement.sections import PillarSections
from haptonic.superelement.solid import SolidBody, condense_solid, solid_body
from haptonic.superelement.substructured import condense_by_parts
from haptonic.superelement.symmetry import THROUGH, folds_of


@dataclass(frozen=True, eq=False)
class Tiling:
    """Condensed tiles of a cell, joined.

    joint : of their rims; tiles : condensed, in the order of the joint
    """

    joint: Joint
    tiles: tuple[Superelement, ...]

    @classmethod
    def of(cls, period: Period, placed: Sequence[PlacedTile], tiles: Sequence[Superelement]) -> Tiling:
        """Join condensed tiles at their positions; the same tile may occur several times.

        Raises
        ------
        GeometryError : edges do not meet
        """
        rims = [tile.mesh.rim_points for tile in tiles]
        levels = {tile.levels for tile in tiles}
        assert len(levels) == 1, "traces of several numbers of levels"
        return cls(Joint.of(period, placed, rims, levels.pop()), tuple(tiles))

    @classmethod
    def single(cls, tile: Superelement) -> Tiling:
        """The tiling of a cell of one site."""
        assert isinstance(tile.cell, UnitCell)
        return cls.of(tile.cell, tile.cell.tiles, [tile])

    @classmethod
    def condensed(
        cls,
        period: Period,
        plans: Sequence[MeshPlan],
        steps: int,
        block: int,
        *,
        measured: bool = True,
        highest: float | None = None,
    ) -> Tiling:
        """Condense the tiles of a period by parts, equal ones once, and join them.

        plans : of each tile; other parameters as for `condense`
        """

        def condense(tile: TileShape, plan: MeshPlan) -> Superelement:
            condense_tile = condense_by_parts if tile.solid is None else condense_solid
            size = directions(tile, block)
            return condense_tile(tile, plan, steps, block=size, measured=measured, highest=highest)

        return cls.of(period, period.tiles, _for_each_tile(period.tiles, plans, condense))

    @property
    def cell(self) -> UnitCell:
        return self.joint.cell

    @property
    def trace_size(self) -> int:
        return self.joint.size

    @property
    def size(self) -> int:
        return self.trace_size + sum(self._modes)

    @property
    def meshes(self) -> tuple[HexMesh | SurfaceMesh, ...]:
        """Meshes of all tiles, one after the other."""
        return tuple(mesh for tile in self.tiles for mesh in tile.meshes)

    @property
    def rim_error(self) -> float:
        """Relative error of frequencies due to the trace, see `MeshPlan.rim_error`."""
        return max(tile.mesh.topology.plan.rim_error for tile in self.tiles)

    @cached_property
    def _modes(self) -> list[int]:
        """Number of modes of each tile."""
        return [tile.size - tile.trace_size for tile in self.tiles]

    @cached_property
    def own(self) -> list[Ints]:
        """For each tile, numbers of the unknowns of its trace, then of its modes."""
        ends = self.trace_size + np.cumsum(self._modes)
        return [
            np.r_[self.joint.of_tile(number), end - count : end]
            for number, (end, count) in enumerate(zip(ends, self._modes, strict=True))
        ]

    def joined(self, forms: Sequence[Array]) -> Array:
        """(n, n) form of the cell from those of its tiles."""
        if len(forms) == 1:
            return self.joint.form(0, forms[0], self.trace_size)
        whole = np.zeros((self.size, self.size))
        for number, (form, numbers, tile) in enumerate(zip(forms, self.own, self.tiles, strict=True)):
            whole[np.ix_(numbers, numbers)] = self.joint.form(number, form, tile.trace_size)
        return whole

    @cached_property
    def stiffness(self) -> Array:
        """(n, n) N/m."""
        return self.joined([tile.stiffness for tile in self.tiles])

    @cached_property
    def mass(self) -> Array:
        """(n, n) kg."""
        return self.joined([tile.mass for tile in self.tiles])

    @cached_property
    def surplus(self) -> Array:
        """(3, n, n) N/m, see `Superelement`."""
        forms = zip(*(tile.surplus for tile in self.tiles), strict=True)
        return np.stack([self.joined(of_tiles) for of_tiles in forms])

    @cached_property
    def truncation(self) -> Array:
        """(n, n) see `Superelement`."""
        return self.joined([tile.truncation for tile in self.tiles])

    @cached_property
    def measures(self) -> Measures | None:
        """Forms that characterise motion, or None if they were not requested."""
        of_tiles = [tile.measures for tile in self.tiles]
        if any(measures is None for measures in of_tiles):
            return None
        forms = {name: self.joined([getattr(measures, name) for measures in of_tiles]) for name in ENERGIES}
        sections = [
            self._spread(number, pillar)
            for number, measures in enumerate(of_tiles)
            if measures is not None
            for pillar in measures.sections
        ]
        return Measures(**forms, sections=tuple(sections))

    def _spread(self, number: int, sections: PillarSections) -> PillarSections:
        """Sections of one tile's pillar on the unknowns of the cell; momenta are in the axes of the tile."""
        traces = self.tiles[number].trace_size
        of_tile = sections.motion.reshape(-1, sections.motion.shape[2]).T
        motion = np.zeros((self.size, of_tile.shape[1]))
        motion[self.own[number]] = np.vstack([self.joint.turned(number, of_tile[:traces]), of_tile[traces:]])
        return PillarSections(
            sections.height,
            sections.mass,
            sections.inertia,
            np.ascontiguousarray(motion.T).reshape(*sections.motion.shape[:2], -1),
        )

    @property
    def points(self) -> Array:
        """(nodes, 3) points of the meshes, one after the other, m."""
        return np.concatenate([
            placed.points(mesh.points)
            for placed, tile in zip(self.joint.placed, self.tiles, strict=True)
            for mesh in tile.meshes
        ])  # fmt: skip

    def linear_subcells(self) -> Ints:
        """(cells, 8) see `HexMesh.linear_subcells`."""
        starts = np.cumsum([0, *(len(mesh.points) for mesh in self.meshes)])
        return np.concatenate([
            start + mesh.linear_subcells() for start, mesh in zip(starts, self.meshes, strict=False)
        ])  # fmt: skip

    def lifted(self, fields: Fields) -> Fields:
        """(nodes, 3, k) displacement on the meshes, one after the other, from (n, k) unknowns."""
        pieces = []
        for number, (tile, numbers) in enumerate(zip(self.tiles, self.own, strict=True)):
            of_tile = fields[numbers]
            trace = self.joint.turned(number, of_tile[: tile.trace_size], back=True)
            pieces.append(
                self.joint.placed[number].turn @ tile.lifted(np.vstack([trace, of_tile[tile.trace_size :]]))
            )
        return np.concatenate(pieces)

    def in_middle_plane(self) -> tuple[Ints, Array] | None:
        """Source of each unknown and its sign for the mirror in the plate's middle plane.

        None if pillars on one face have no image on the other.
        """
        if not all(tile.cell.is_halved for tile in self.tiles):
            return None
        source, unknowns = np.arange(self.size), self.joint.unknowns
        source[unknowns] = unknowns[::-1]
        traces = np.empty(self.trace_size)
        traces[unknowns] = THROUGH
        return source, np.concatenate([traces, *(tile.middle_parity for tile in self.tiles)])

    @property
    def is_centred(self) -> bool:
        """True if half a turn about the normal leaves the cell and its meshes unchanged."""
        meshed_in_blocks = all(tile.cell.solid is None for tile in self.tiles)
        return meshed_in_blocks and HALF_TURN in self.cell.point_group

    def half_turn(self) -> tuple[Ints, Array, Array] | None:
        """Source, sign and translation of each unknown for the half-turn, see `JointImage.half_turned`."""
        if not self.is_centred:
            return None
        image = self.joint.image(HALF_TURN)
        mapped = self.cell.site_map(HALF_TURN)
        assert mapped is not None
        source, sign, shift = ([of_traces] for of_traces in image.half_turned())
        for number, tile in enumerate(self.tiles):
            other, count = int(mapped.image[number]), self._modes[number]
            source.append(self.own[other][self.tiles[other].trace_size :])
            sign.append(tile.half_turn_parity if other == number else np.ones(count))
            shift.append(np.broadcast_to(mapped.shift[number], (count, 2)).astype(float))
        return np.concatenate(source), np.concatenate(sign), np.concatenate(shift)


def _for_each_tile(
    placed: Sequence[PlacedTile], plans: Sequence[MeshPlan], make: Callable[[TileShape, MeshPlan], Any]
) -> list[Any]:
    """Return ``make(tile, plan)`` for each tile, computed once for equal tiles."""
    values: dict[tuple[int, MeshPlan], Any] = {}
    for tile, plan in zip(placed, plans, strict=True):
        if (id(tile.tile), plan) not in values:
            values[id(tile.tile), plan] = make(tile.tile, plan)
    return [values[id(tile.tile), plan] for tile, plan in zip(placed, plans, strict=True)]


def directions(tile: TileShape, block: int) -> int:
    """Size of the blocks of a tile's Krylov space; tiles of one and of two classes get as many in all."""
    return block if tile.solid is not None or folds_of(tile) else 2 * block


@dataclass(frozen=True, eq=False)
class TiledMesh:
    """Folded meshes of a cell's tiles, joined but not condensed."""

    joint: Joint
    meshes: tuple[FoldedMesh, ...]

    @classmethod
    def of(cls, cell: UnitCell, plans: Sequence[MeshPlan]) -> TiledMesh:
        """Mesh the tiles of a cell, each by its plan."""
        meshes: list[FoldedMesh] = _for_each_tile(cell.tiles, plans, FoldedMesh.of)
        rims = [folded.mesh.rim_points for folded in meshes]
        return cls(Joint.of(cell, cell.tiles, rims, meshes[0].levels), tuple(meshes))

    @property
    def cell(self) -> UnitCell:
        return self.joint.cell

    @property
    def plans(self) -> tuple[MeshPlan, ...]:
        return tuple(folded.mesh.topology.plan for folded in self.meshes)

    @property
    def nodal_mass(self) -> Array:
        """(nodes,) mass at the nodes of all meshes, kg."""
        return np.concatenate([folded.nodal_mass for folded in self.meshes])

    def condensed(self, steps: int, block: int, *, measured: bool = True) -> Tiling:
        """Condense these meshes to a tiling; parameters as for `condense`."""
        by_mesh: dict[int, Superelement] = {}
        for folded in self.meshes:
            if id(folded) not in by_mesh:
                size = directions(folded.cell, block)
                by_mesh[id(folded)] = condensed(folded, steps, block=size, measured=measured)
        return Tiling(self.joint, tuple(by_mesh[id(folded)] for folded in self.meshes))

    def dynamic(self, omega: float, loads: Fields | None = None) -> JoinedStiffness:
        """Dynamic stiffness of all traces at an angular frequency; ``loads`` (nodes, 3, k) on nodes, N."""
        ends = np.cumsum([folded.mesh.topology.nodes for folded in self.meshes])
        pieces: list[DynamicStiffness] = []
        for number, mesh in enumerate(self.meshes):
            same = next((n for n in range(number) if self.meshes[n] is mesh), None)
            if loads is None and same is not None:
                pieces.append(pieces[same])
                continue
            loads_of_tile = None
            if loads is not None:
                loads_of_tile = (
                    self.joint.placed[number].turn.T
                    @ loads[ends[number] - mesh.mesh.topology.nodes : ends[number]]
                )
            pieces.append(dynamic_stiffness(mesh, omega, loads_of_tile))
        return JoinedStiffness(self.joint, tuple(pieces))


@dataclass(frozen=True, eq=False)
class SolidMesh:
    """Elements of a cell of a CAD file, not condensed; see `TiledMesh`."""

    joint: Joint
    body: SolidBody

    def dynamic(self, omega: float) -> JoinedStiffness:
        """Dynamic stiffness of the trace at an angular frequency, rad/s."""
        return JoinedStiffness(self.joint, (self.body.dynamic(omega),))


def whole_mesh(cell: UnitCell, plans: Sequence[MeshPlan]) -> TiledMesh | SolidMesh:
    """Mesh a cell without condensation."""
    if cell.solid is None:
        return TiledMesh.of(cell, plans)
    body = solid_body(cell, plans[0])
    return SolidMesh(Joint.of(cell, cell.tiles, [body.mesh.rim_points], plans[0].levels), body)


@dataclass(frozen=True, eq=False)
class JoinedStiffness:
    """Dynamic stiffness of all tiles of a cell on their traces; see `DynamicStiffness`."""

    joint: Joint
    pieces: tuple[DynamicStiffness, ...]

    @property
    def below(self) -> int:
        """Number of eigenvalues of the interiors with clamped traces below this frequency."""
        return sum(piece.below for piece in self.pieces)

    @property
    def matrix(self) -> Array:
        """(t, t) N/m."""
        return self._joined([piece.matrix for piece in self.pieces])

    @property
    def mass(self) -> Array:
        """(t, t) kg."""
        return self._joined([piece.mass for piece in self.pieces])

    @property
    def held(self) -> Fields:
        """(nodes, 3, k) responses to the loads with the traces clamped."""
        return np.concatenate(
            [placed.turn @ piece.held for placed, piece in zip(self.joint.placed, self.pieces, strict=True)]
        )

    @property
    def force(self) -> Fields:
        """(t, k) forces of these loads on the traces."""
        return np.concatenate([self.joint.turned(n, piece.force) for n, piece in enumerate(self.pieces)])

    def lifted(self, trace: Fields) -> Fields:
        """(nodes, 3, k) displacement on the meshes from a trace (t, k) without loads."""
        joint, displacements = self.joint, []
        for number, piece in enumerate(self.pieces):
            of_tile = joint.turned(number, trace[joint.of_tile(number)], back=True)
            displacements.append(joint.placed[number].turn @ piece.lifted(of_tile))
        return np.concatenate(displacements)

    def _joined(self, forms: Sequence[Array]) -> Array:
        joined_forms = [self.joint.form(number, form, len(form)) for number, form in enumerate(forms)]
        return np.asarray(la.block_diag(*joined_forms))
