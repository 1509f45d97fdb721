"""Division of a tile whose pillar has a step, into plate with foot and the part about the step.

Each is graded towards its own edge only. Between them the pillar is a prism, which needs no mesh.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from haptonic.arrays import Array
from haptonic.cell.edges import between_edges, bridges
from haptonic.cell.orders import layers_along
from haptonic.cell.pillar import Faces, Pillar
from haptonic.cell.plan import MeshPlan
from haptonic.cell.tile import TileShape
from haptonic.materials import Material


@dataclass(frozen=True, eq=False)
class Piece(TileShape):
    """A tile with another pillar, or the part of its pillar about a step, as a tile of its own.

    whole : tile that it is a piece of
    """

    whole: TileShape
    thickness: float
    pillar: Pillar
    free_width: float | None = None

    @property
    def material(self) -> Material:  # type: ignore[override]
        return self.whole.material

    @property
    def faces(self) -> Faces:  # type: ignore[override]
        return self.whole.faces

    @property
    def above(self) -> TileShape:
        return self.whole

    @property
    def corners(self) -> Array:
        return self.whole.corners

    @property
    def extent(self) -> float:
        return self.whole.extent

    @property
    def inradius(self) -> float:
        return self.whole.inradius if self.free_width is None else self.free_width

    @property
    def room(self) -> float:
        return self.whole.room if self.free_width is None else self.free_width

    def has_symmetry(self, turn: Array) -> bool:
        return self.whole.has_symmetry(turn)


@dataclass(frozen=True)
class Meshed:
    """Part with a mesh of its own: a tile, its plan, and the height of its lower end, m."""

    tile: TileShape
    plan: MeshPlan
    base: float = 0.0

    def without_body(self) -> Meshed:
        """A copy up to where a pillar that is a prism needs no mesh."""
        if self.tile.pillar is None or not self.tile.pillar.is_prism:
            return self
        return replace(self, plan=self.plan.foot)

    def boundary(self, levels: int) -> int:
        """Unknowns of a trace of some levels; either end of a pillar's piece counts as about one level."""
        if self.tile.free_width is not None:
            return 3 * 2 * self.plan.around
        return 3 * levels * self.plan.rim_nodes


def pieces_of(tile: TileShape, plan: MeshPlan) -> tuple[Meshed, ...]:
    """Meshed parts of a tile on a plan, from below: the tile itself, or two pieces of it."""
    pillar, prism = tile.pillar, between_edges(tile)
    if prism is None:
        return (Meshed(tile, plan),)
    assert pillar is not None
    assert pillar.step is not None
    cut, step = prism[1], pillar.step.height
    lower = Piece(tile, tile.thickness, replace(pillar, height=cut, step=None))
    upper = Piece(tile, step - cut, pillar.above_step, pillar.radius)
    along = max(plan.upward, plan.thin)
    shared = replace(plan, step_layers=0, step_rings=0, along=along)
    return (
        Meshed(lower, _fitted(shared, lower)),
        Meshed(upper, _fitted(replace(shared, plate_layers=1, upward=along), upper), tile.thickness + cut),
    )


def _fitted(plan: MeshPlan, piece: Piece) -> MeshPlan:
    """The plan with the elements that lead away from the edge of a piece, and along it."""
    layers, rings = layers_along(piece.pillar)[0], bridges(piece, plan.foot_rings)
    return replace(plan, pillar_layers=layers, bridges=rings)
