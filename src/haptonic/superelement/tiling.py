"""A tiling: condensed tiles in their places in one period of a plate or a ribbon, joined edge to edge.

Tiles meet in their traces alone, so each is condensed by itself, and equal ones once. A cell of one site is
the tiling of a single tile. Unknowns are the traces of all tiles, then the amplitudes of all their modes;
`Joint` says which traces are one.
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

CLASSES = 4  # of most tiles: one without classes gets as many directions in all


@dataclass(frozen=True, eq=False)
class Tiling:
    """Condensed tiles of a cell, joined.

    joint : where their rims meet; tiles : condensed, in the order of the joint's
    """

    joint: Joint
    tiles: tuple[Superelement, ...]

    @classmethod
    def of(cls, period: Period, placed: Sequence[PlacedTile], tiles: Sequence[Superelement]) -> Tiling:
        """Join condensed tiles in their places; each its own, or the same several times.

        Raises
        ------
        GeometryError : edges that do not meet
        """
        rims = [tile.mesh.rim_points for tile in tiles]
        levels = {one.levels for one in tiles}
        assert len(levels) == 1, "traces of several numbers of levels"
        return cls(Joint.of(period, placed, rims, levels.pop()), tuple(tiles))

    @classmethod
    def single(cls, tile: Superelement) -> Tiling:
        """The tiling of a cell of one site."""
        assert isinstance(tile.cell, UnitCell)
        return cls.of(tile.cell, tile.cell.tiles, [tile])

    @classmethod
    def condensed(
        cls, period: Period, plans: Sequence[MeshPlan], steps: int, block: int, *, measured: bool = True
    ) -> Tiling:
        """Condense the tiles of a period by parts, equal ones once, and join them.

        plans : of each tile; parameters else as for `condense`
        """

        def condense(tile: TileShape, plan: MeshPlan) -> Superelement:
            way = condense_by_parts if tile.solid is None else condense_solid
            return way(tile, plan, steps, block=directions(tile, block), measured=measured)

        return cls.of(period, period.tiles, _each(period.tiles, plans, condense))

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
        """Of all tiles, one after the other."""
        return tuple(mesh for one in self.tiles for mesh in one.meshes)

    @cached_property
    def _modes(self) -> list[int]:
        """Number of modes of each tile."""
        return [one.size - one.trace_size for one in self.tiles]

    @cached_property
    def own(self) -> list[Ints]:
        """Numbers of the unknowns of each tile: of its trace, then of its modes."""
        ends = self.trace_size + np.cumsum(self._modes)
        return [
            np.r_[self.joint.of_tile(number), end - count : end]
            for number, (end, count) in enumerate(zip(ends, self._modes, strict=True))
        ]

    def joined(self, forms: Sequence[Array]) -> Array:
        """(n, n) a form of the cell from those of its tiles."""
        if len(forms) == 1:
            return self.joint.form(0, forms[0], self.trace_size)
        whole = np.zeros((self.size, self.size))
        for number, (form, own, tile) in enumerate(zip(forms, self.own, self.tiles, strict=True)):
            whole[np.ix_(own, own)] = self.joint.form(number, form, tile.trace_size)
        return whole

    @cached_property
    def stiffness(self) -> Array:
        """(n, n) N/m."""
        return self.joined([one.stiffness for one in self.tiles])

    @cached_property
    def mass(self) -> Array:
        """(n, n) kg."""
        return self.joined([one.mass for one in self.tiles])

    @cached_property
    def truncation(self) -> Array:
        """(n, n) see `Superelement`."""
        return self.joined([one.truncation for one in self.tiles])

    @cached_property
    def measures(self) -> Measures | None:
        """What characterises motion, if it was asked for."""
        found = [one.measures for one in self.tiles]
        if any(one is None for one in found):
            return None
        forms = {name: self.joined([getattr(one, name) for one in found]) for name in ENERGIES}
        sections = [
            self._spread(number, one)
            for number, measures in enumerate(found)
            if measures is not None
            for one in measures.sections
        ]
        return Measures(**forms, sections=tuple(sections))

    def _spread(self, number: int, sections: PillarSections) -> PillarSections:
        """Sections of one tile's pillar on the unknowns of the cell; momenta stay in the tile's own axes."""
        traces = self.tiles[number].trace_size
        own = sections.motion.reshape(-1, sections.motion.shape[2]).T
        motion = np.zeros((self.size, own.shape[1]))
        motion[self.own[number]] = np.vstack([self.joint.turned(number, own[:traces]), own[traces:]])
        return PillarSections(
            sections.height,
            sections.mass,
            sections.inertia,
            np.ascontiguousarray(motion.T).reshape(*sections.motion.shape[:2], -1),
        )

    @property
    def points(self) -> Array:
        """(nodes, 3) of the meshes, one after the other, m."""
        return np.concatenate([
            placed.points(mesh.points)
            for placed, one in zip(self.joint.placed, self.tiles, strict=True)
            for mesh in one.meshes
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
        for number, (tile, own) in enumerate(zip(self.tiles, self.own, strict=True)):
            mine = fields[own]
            trace = self.joint.turned(number, mine[: tile.trace_size], back=True)
            pieces.append(
                self.joint.placed[number].turn @ tile.lifted(np.vstack([trace, mine[tile.trace_size :]]))
            )
        return np.concatenate(pieces)

    def in_middle_plane(self) -> tuple[Ints, Array] | None:
        """What the mirror in the plate's middle plane takes each unknown from, and its sign.

        None where pillars on one face have no image on the other.
        """
        if not all(one.cell.is_mirrored for one in self.tiles):
            return None
        source, unknowns = np.arange(self.size), self.joint.unknowns
        source[unknowns] = unknowns[::-1]
        traces = np.empty(self.trace_size)
        traces[unknowns] = THROUGH
        return source, np.concatenate([traces, *(one.middle_parity for one in self.tiles)])

    @property
    def is_centred(self) -> bool:
        """Whether half a turn about the normal leaves the cell and its meshes as they are."""
        meshed_in_blocks = all(tile.cell.solid is None for tile in self.tiles)
        return meshed_in_blocks and HALF_TURN in self.cell.point_group

    def half_turn(self) -> tuple[Ints, Array, Array] | None:
        """What half a turn about the normal takes each unknown from, see `JointImage.half_turned`."""
        if not self.is_centred:
            return None
        image = self.joint.image(HALF_TURN)
        mapped = self.cell.site_map(HALF_TURN)
        assert mapped is not None
        source, sign, shift = ([one] for one in image.half_turned())
        for number, tile in enumerate(self.tiles):
            other, count = int(mapped.image[number]), self._modes[number]
            source.append(self.own[other][self.tiles[other].trace_size :])
            sign.append(tile.half_turn_parity if other == number else np.ones(count))
            shift.append(np.broadcast_to(mapped.shift[number], (count, 2)).astype(float))
        return np.concatenate(source), np.concatenate(sign), np.concatenate(shift)


def _each(
    placed: Sequence[PlacedTile], plans: Sequence[MeshPlan], made: Callable[[TileShape, MeshPlan], Any]
) -> list[Any]:
    """``made(tile, plan)`` for each tile; equal ones share it."""
    kept: dict[tuple[int, MeshPlan], Any] = {}
    for one, plan in zip(placed, plans, strict=True):
        if (id(one.tile), plan) not in kept:
            kept[id(one.tile), plan] = made(one.tile, plan)
    return [kept[id(one.tile), plan] for one, plan in zip(placed, plans, strict=True)]


def directions(tile: TileShape, block: int) -> int:
    """Size of the blocks of a tile's Krylov space: one symmetry class gets as many in all as two do."""
    if tile.solid is not None:
        return CLASSES * block
    return block if folds_of(tile) else 2 * block


@dataclass(frozen=True, eq=False)
class TiledMesh:
    """The folded meshes of a cell's tiles, joined: nothing of them is condensed yet."""

    joint: Joint
    meshes: tuple[FoldedMesh, ...]

    @classmethod
    def of(cls, cell: UnitCell, plans: Sequence[MeshPlan]) -> TiledMesh:
        """Mesh the tiles of a cell, each by its plan."""
        meshes: list[FoldedMesh] = _each(cell.tiles, plans, FoldedMesh.of)
        rims = [folded.mesh.rim_points for folded in meshes]
        return cls(Joint.of(cell, cell.tiles, rims, meshes[0].levels), tuple(meshes))

    @property
    def cell(self) -> UnitCell:
        return self.joint.cell

    @property
    def plans(self) -> tuple[MeshPlan, ...]:
        return tuple(one.mesh.topology.plan for one in self.meshes)

    @property
    def nodal_mass(self) -> Array:
        """(nodes,) kg, of all meshes."""
        return np.concatenate([one.nodal_mass for one in self.meshes])

    def condensed(self, steps: int, block: int, *, measured: bool = True) -> Tiling:
        """The tiling of these meshes; parameters as for `condense`."""
        made: dict[int, Superelement] = {}
        for one in self.meshes:
            if id(one) not in made:
                size = directions(one.cell, block)
                made[id(one)] = condensed(one, steps, block=size, measured=measured)
        return Tiling(self.joint, tuple(made[id(one)] for one in self.meshes))

    def dynamic(self, omega: float, loads: Fields | None = None) -> JoinedStiffness:
        """What all traces feel at an angular frequency; ``loads`` (nodes, 3, k) act on the nodes, N."""
        ends = np.cumsum([one.mesh.topology.nodes for one in self.meshes])
        pieces: list[DynamicStiffness] = []
        for number, mesh in enumerate(self.meshes):
            same = next((n for n in range(number) if self.meshes[n] is mesh), None)
            if loads is None and same is not None:
                pieces.append(pieces[same])
                continue
            own = None
            if loads is not None:
                own = (
                    self.joint.placed[number].turn.T
                    @ loads[ends[number] - mesh.mesh.topology.nodes : ends[number]]
                )
            pieces.append(dynamic_stiffness(mesh, omega, own))
        return JoinedStiffness(self.joint, tuple(pieces))


@dataclass(frozen=True, eq=False)
class SolidMesh:
    """The elements of a cell of a CAD file: nothing of them is condensed yet; see `TiledMesh`."""

    joint: Joint
    body: SolidBody

    def dynamic(self, omega: float) -> JoinedStiffness:
        """What the trace feels at an angular frequency, rad/s."""
        return JoinedStiffness(self.joint, (self.body.dynamic(omega),))


def whole_mesh(cell: UnitCell, plans: Sequence[MeshPlan]) -> TiledMesh | SolidMesh:
    """The meshes of a cell before condensation."""
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
        """Eigenvalues of the insides with their traces held below this frequency."""
        return sum(one.below for one in self.pieces)

    @property
    def matrix(self) -> Array:
        """(t, t) N/m."""
        return self._joined([one.matrix for one in self.pieces])

    @property
    def mass(self) -> Array:
        """(t, t) kg."""
        return self._joined([one.mass for one in self.pieces])

    @property
    def held(self) -> Fields:
        """(nodes, 3, k) answers to the loads with the traces held."""
        return np.concatenate(
            [one.turn @ piece.held for one, piece in zip(self.joint.placed, self.pieces, strict=True)]
        )

    @property
    def force(self) -> Fields:
        """(t, k) what these add to the traces' loads."""
        return np.concatenate([self.joint.turned(n, one.force) for n, one in enumerate(self.pieces)])

    def lifted(self, trace: Fields) -> Fields:
        """(nodes, 3, k) displacement on the meshes from a trace (t, k) without loads."""
        joint, found = self.joint, []
        for number, piece in enumerate(self.pieces):
            own = joint.turned(number, trace[joint.of_tile(number)], back=True)
            found.append(joint.placed[number].turn @ piece.lifted(own))
        return np.concatenate(found)

    def _joined(self, forms: Sequence[Array]) -> Array:
        own = [self.joint.form(number, form, len(form)) for number, form in enumerate(forms)]
        return np.asarray(la.block_diag(*own))
