"""Condensation in two steps: the plate with the foot of the pillar, then the body of the pillar on it.

The body needs no mesh, and the foot is condensed once for all lengths of the body. Only the foot contains
the singular edge and needs a fine mesh. The surroundings of a step in the pillar are the foot of a further
body, which is on top of the first body.
"""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from haptonic.arrays import Array, Ints
from haptonic.cell import HexMesh, MeshPlan, TileShape, mesh_cell
from haptonic.cell.edges import FOOT_LAYER
from haptonic.cell.pieces import pieces_of
from haptonic.later import linalg as la
from haptonic.parallel import each
from haptonic.solvers import definite
from haptonic.superelement.condense import Superelement, assembled, condensed
from haptonic.superelement.folded import FoldedMesh
from haptonic.superelement.kept import Kept
from haptonic.superelement.measures import ClassMeasures
from haptonic.superelement.parts import reduced_by_parts
from haptonic.superelement.pillar_body import PARITIES, Kinds, PillarBody
from haptonic.superelement.sections import section_sizes
from haptonic.superelement.stacked import FootClass, Storey, joined
from haptonic.superelement.symmetry import DIAGONAL, Folding, folds_of

# over the section: relative error of a frequency up to 1e-3 with 1, about 1e-5 with 2 (round body)
LEAST_DEGREE = 2
# Polynomials of all kinds over a triangle are orthonormal to 4e-7 with 8, and to 4e-4 with 10, where the
# stiffness of a body was not positive.
MOST_DEGREE = 8
LEAST_ORDER, PER_LAYER = 8, 2  # of the polynomials along the body, and increase per layer of the mesh
FOR_SECTION = 4  # directions in each block of a foot's Krylov space in addition to those of a whole cell
# entries of stiffness of all feet stored for further designs, about 80 bytes each, so 0.4 GB: 10 usual feet
KEPT_FEET = 5e6


@definite()
def condense_by_parts(
    cell: TileShape,
    plan: MeshPlan,
    steps: int = 2,
    *,
    block: int = 10,
    measured: bool = True,
    highest: float | None = None,
) -> Superelement:
    """Condense a cell onto its lateral faces, with prismatic bodies of its pillar treated separately.

    Parameters as for `condense`. On the same plan the two differ by the error of the body's mesh in
    `condense`. They are equal for a pillar with draft or a short pillar, which has no body.
    """
    pieces = pieces_of(cell, plan)
    meshes = [mesh_cell(piece.tile, piece.plan) for piece in pieces]
    bodies = [
        pillar_body_of(piece.tile, mesh, is_cut=number + 1 < len(pieces))
        for number, (piece, mesh) in enumerate(zip(pieces, meshes, strict=True))
    ]
    if bodies[0] is None:
        shared = FoldedMesh.of_mesh(cell, meshes[0])
        return condensed(shared, steps, block=block, measured=measured, highest=highest)
    feet = [
        _foot(piece.tile, mesh, ends, steps, block, measured)
        for piece, mesh, ends in zip(pieces, meshes, pairwise([None, *bodies]), strict=True)
    ]
    storeys = [
        Storey.of(mesh, body, piece.base) for piece, mesh, body in zip(pieces, meshes, bodies, strict=True)
    ]
    classes = each(
        lambda of_class: joined(of_class, storeys, steps, block, highest),
        zip(*(foot.classes for foot in feet), strict=True),
    )
    sizes = (
        [storey.sizes(foot.sizes) for storey, foot in zip(storeys, feet, strict=True)] if measured else None
    )
    whole = tuple(storey.mesh for storey in storeys)
    return assembled(cell, whole, feet[0].levels, classes, np.hstack(sizes) if sizes else None)


def pillar_body_of(tile: TileShape, mesh: HexMesh, *, is_cut: bool = False) -> PillarBody | None:
    """Body of a tile's pillar; it starts at the lower end of the second layer above the thin ones.

    is_cut : whether a further piece is on top; then the tile has a body at any height of its lower end
    """
    pillar, plan = tile.pillar, mesh.topology.plan
    if pillar is None or not pillar.is_prism or plan.pillar_layers < 2:
        return None
    low = float(mesh.points[mesh.topology.foot.level_start[-2], 2])
    if not is_cut and low - tile.thickness < FOOT_LAYER * 2 * pillar.radius * (1 - 1e-9):
        return None
    # polynomials that the nodes of the foot can represent; sections that are not round warp in torsion
    degree = plan.per_quarter // 2 if pillar.outline.warps else (plan.per_quarter + 2) // 3
    if plan.blocks * plan.sides > 4:  # a coarse mesh of four blocks cannot represent so many polynomials
        degree = min(max(degree, LEAST_DEGREE), MOST_DEGREE)
    return PillarBody(
        low=low,
        length=tile.thickness + pillar.height - low,
        half_width=pillar.radius,
        outline=pillar.outline,
        material=tile.pillar_material,
        degree=degree,
        order=LEAST_ORDER + PER_LAYER * plan.pillar_layers,
        kinds=len(PARITIES) // 2 ** len(folds_of(tile)),
        faces=mesh.topology.faces,
    )


@dataclass(frozen=True)
class _Foot:
    """Condensed part below a body, down to the next body or to the plate.

    levels : see `FoldedMesh`; sizes : of the pillar's sections below the body
    entries : number of entries of the interior stiffness
    """

    entries: int
    levels: int
    classes: tuple[FootClass, ...]
    sizes: Array


Ends = tuple[PillarBody | None, PillarBody | None]  # bodies below and above a foot

_feet = Kept[_Foot](KEPT_FEET, lambda foot: foot.entries)


def _foot(tile: TileShape, mesh: HexMesh, ends: Ends, steps: int, block: int, measured: bool) -> _Foot:
    """Condense a foot between two bodies, or return the stored one."""
    topology = mesh.topology.foot if ends[1] else mesh.topology
    points = mesh.points[mesh.topology.of_foot] if ends[1] else mesh.points
    about = (
        topology.plan,
        topology.mirrored,
        topology.free,
        folds_of(tile),
        tile.has_symmetry(DIAGONAL),
        [end and (end.half_width, end.outline, end.degree) for end in ends],
        steps,
        block,
        measured,
    )
    solids = [(solid.density, solid.stiffness.tobytes()) for solid in tile.solids]
    key = hashlib.sha256(repr((about, solids)).encode() + points.tobytes()).hexdigest()
    whole = HexMesh(topology, points)
    return _feet.of(key, lambda: _condensed(tile, whole, ends, steps, block, measured), topology.plan)


def _condensed(tile: TileShape, mesh: HexMesh, ends: Ends, steps: int, block: int, measured: bool) -> _Foot:
    """Condense a foot between two bodies."""
    shared = FoldedMesh.of_mesh(tile, mesh, open_top=ends[1] is not None)
    block += FOR_SECTION * sum(end.kinds for end in ends if end is not None)
    on_ends = [_on_ends(shared, q, ends) for q in range(shared.folding.classes)]
    reduced_classes, rows = reduced_by_parts(shared, on_ends, steps, block), shared.rows

    def foot_class(q: int) -> FootClass:
        return FootClass(
            trace=shared.traces[q],
            parities=_parities(shared.folding, q),
            on_ends=on_ends[q],
            own=reduced_classes[q],
            measures=ClassMeasures.of(shared, q, reduced_classes[q], on_ends[q]) if measured else None,
            through=shared.through,
            rows=rows,
        )

    return _Foot(
        entries=len(shared.assembler.pattern.indices),
        levels=shared.levels,
        classes=tuple(each(foot_class, range(len(reduced_classes)))),
        sizes=section_sizes(shared.mesh, shared.nodal_mass),
    )


def _on_ends(shared: FoldedMesh, q: int, ends: Ends) -> Array:
    """(3 representatives, s) motions of a foot's open ends in a class, from unknowns of the sections."""
    folding, topology = shared.folding, shared.mesh.topology
    levels: tuple[Ints, ...] = (np.arange(topology.level_start[1]), topology.top)
    motions = []
    for end, level in zip(ends, levels, strict=True):
        if end is not None:
            x, y, _ = shared.mesh.points[folding.origin[np.unique(folding.node[level])]].T
            motions.append(end.on_level(_parities(folding, q), x, y))
    return np.asarray(la.block_diag(np.zeros((0, 0)), *motions))


def _parities(folding: Folding, q: int) -> tuple[Kinds, ...]:
    """Kinds of polynomials of each displacement component with the signs of a class."""
    wanted = folding.parity[q][:, None] * folding.component
    return tuple(
        tuple(
            (x, y)
            for x, y in PARITIES
            if all(
                turn[0] ** x * turn[1] ** y == sign
                for turn, sign in zip(folding.component, signs, strict=True)
            )
        )
        for signs in wanted.T
    )
