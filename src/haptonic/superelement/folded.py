"""Matrices of a cell before condensation, by symmetry class."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from haptonic.arrays import Array, Bools
from haptonic.cell import HexMesh, MeshPlan, TileShape, mesh_cell
from haptonic.cell.quadrature import interpolation, lobatto
from haptonic.elements import matrices_by_region
from haptonic.later import linalg as la, sparse as sp
from haptonic.superelement.assembly import Assembler, assembler_of
from haptonic.superelement.bounded import Bounded
from haptonic.superelement.surplus import NodeRows, highest_rows
from haptonic.superelement.symmetry import Folding, fold, fold_rim, folds_of
from haptonic.superelement.trace import FoldedTrace, trace_levels


def through_levels(cell: TileShape, mesh: HexMesh, levels: int) -> Array:
    """(plate levels, levels) interpolation from the levels of the trace to those of the mesh at its sides."""
    if mesh.topology.free:
        return np.zeros((mesh.topology.plan.plate_levels, levels))
    levels_at = 0.5 * cell.thickness * (1 + lobatto(levels - 1)[0])
    return interpolation(levels_at, mesh.points[mesh.topology.rim[:, 0], 2])


@dataclass(frozen=True)
class FoldedMesh:
    """Mesh and matrices that the symmetry classes of a cell share.

    levels : trace nodes through the thickness
    through : (plate levels, levels) interpolation from these to the levels of the mesh
    paired : (pairs, 9) stiffness between pairs of nodes, see `Assembler`
    moduli : of the folded elements of each family, see `ElementMatrices`
    representative_mass, nodal_mass : lumped mass of the folded and the whole mesh, kg
    """

    cell: TileShape
    mesh: HexMesh
    levels: int
    assembler: Assembler
    paired: Array
    moduli: tuple[Array, ...]
    through: Array
    representative_mass: Array
    nodal_mass: Array

    @classmethod
    def of(cls, cell: TileShape, plan: MeshPlan) -> FoldedMesh:
        """Mesh a cell and fold it along its mirrors."""
        return cls.of_mesh(cell, mesh_cell(cell, plan))

    @classmethod
    def of_mesh(cls, cell: TileShape, mesh: HexMesh, *, open_top: bool = False) -> FoldedMesh:
        """Fold a mesh; ``open_top`` if another part will be joined to its top."""
        levels = trace_levels(mesh.topology.plan)
        topology = mesh.topology
        folding = fold(topology, folds_of(cell), open_top=open_top)
        elements, mass = [], np.zeros(len(folding.origin))
        for family, picked, weight in zip(topology.families, folding.chosen, folding.weight, strict=True):
            nodes = family.nodes[picked]
            matrices = matrices_by_region(mesh.points, nodes, cell.solids, family.region[picked])
            masses = (matrices.mass * weight[:, None]).ravel()
            mass += np.bincount(folding.node[nodes].ravel(), masses, minlength=len(mass))
            elements.append(matrices)
        assembler = assembler_of(topology, folding)
        return cls(
            cell=cell,
            mesh=mesh,
            levels=levels,
            assembler=assembler,
            paired=assembler.paired(tuple(elements)),
            moduli=tuple(matrices.moduli for matrices in elements),
            through=through_levels(cell, mesh, levels),
            representative_mass=mass,
            nodal_mass=(mass / np.bincount(folding.node))[folding.node],
        )

    @property
    def folding(self) -> Folding:
        return self.assembler.folding

    @cached_property
    def rows(self) -> list[NodeRows]:
        """Rows of nodes that move by the highest polynomials."""
        return highest_rows(self.cell, self.mesh.topology, self.folding, self.moduli)

    @property
    def rim(self) -> Folding:
        """Folded places of the trace."""
        return fold_rim(self.mesh.topology, folds_of(self.cell))

    @cached_property
    def traces(self) -> tuple[FoldedTrace, ...]:
        """Share of each class in the trace."""
        classes = range(self.folding.classes)
        return tuple(
            FoldedTrace(
                topology=self.mesh.topology,
                folding=self.folding,
                rim=self.rim,
                symmetry_class=q,
                levels=self.levels,
            )
            for q in classes
        )

    def rim_motion(self, q: int) -> Array:
        """(3 rim, b) motion of the representatives on the rim for the class's unknowns of the trace."""
        trace = self.traces[q]
        motion = trace.on_levels(self.through, np.eye(len(trace.kept)))
        return motion.reshape(3 * trace.rim_size, len(trace.kept))

    def symmetry_class(self, q: int, on_ends: Array | None = None) -> tuple[Array, Bounded]:
        """Values of one class's interior stiffness on the pattern of the classes, and its other forms.

        Interior unknowns are (representative, component); the boundary is the trace, then the open ends. The
        mass of a component that is zero in the class is 0.

        ``on_ends`` (3 representatives, s) contains the motions of open ends.
        """
        folding, motion = self.folding, self.rim_motion(q)
        motion = motion if on_ends is None else la.block_diag(motion, on_ends)
        stiffness = self.assembler.assembled(self.paired, q)
        mass = np.repeat(self.representative_mass[folding.interior :], 3)
        alive = folding.sign[q][folding.origin[: folding.interior]] != 0
        body = Bounded(
            coupling=stiffness.coupling() @ sp.csr_array(motion),
            outer_stiffness=motion.T @ (stiffness.boundary() @ motion),
            outer_mass=motion.T @ (mass[:, None] * motion),
            mass=(self.representative_mass[: folding.interior, None] * alive).ravel(),
        )
        return stiffness.interior(), body

    def pillar_stiffness(self, q: int) -> sp.csr_array:
        """(3 representatives, 3 representatives) pillar's share of the stiffness of one class."""
        return self.assembler.assembled_pillar(self.paired, q)

    @cached_property
    def above(self) -> Bools:
        """(3 representatives,) True for unknowns above the plate's top."""
        if self.mesh.topology.free:
            return np.ones(3 * len(self.folding.origin), dtype=bool)
        heights = self.mesh.points[self.folding.origin, 2]
        return np.repeat(heights > self.mesh.points[self.mesh.topology.rim[-1, 0], 2], 3)
