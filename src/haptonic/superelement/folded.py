"""The matrices of a cell before condensation, one symmetry class after the other."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy.sparse as sp
from numpy.typing import NDArray

from haptonic.cell import HexMesh, MeshPlan, UnitCell, mesh_cell
from haptonic.cell.quadrature import interpolation, lobatto
from haptonic.elements import element_matrices
from haptonic.lattice import DIAGONAL, Operation
from haptonic.superelement.assembly import Assembler, assembler_of
from haptonic.superelement.symmetry import COMPONENT_SIGNS, Folding, fold
from haptonic.superelement.trace import FoldedTrace, trace_levels

Array = NDArray[np.float64]


@dataclass(frozen=True)
class FoldedCell:
    """One symmetry class of a cell; interior unknowns are (representative, component).

    trace : the class's share of the trace
    interior : numbers of the interior stiffness on the pattern of the classes
    coupling : (3 interior, b) stiffness between interior and trace
    trace_stiffness, trace_mass : (b, b)
    mass : (3 interior,) lumped, 0 where the class forces a component to vanish
    """

    trace: FoldedTrace
    interior: Array
    coupling: Array
    trace_stiffness: Array
    trace_mass: Array
    mass: Array


def mirrors_of(cell: UnitCell) -> tuple[Operation, ...]:
    """The mirrors x -> -x and y -> -y that the cell has."""
    return tuple(mirror for mirror in COMPONENT_SIGNS if mirror in cell.lattice.point_group)


def through_levels(cell: UnitCell, mesh: HexMesh, levels: int) -> Array:
    """(plate levels, levels) values on the mesh's levels at the cell's sides from those on the trace's."""
    levels_at = 0.5 * cell.thickness * (1 + lobatto(levels - 1)[0])
    return interpolation(levels_at, mesh.points[mesh.topology.rim[:, 0], 2])


@dataclass(frozen=True)
class FoldedMesh:
    """What the symmetry classes of a cell share.

    levels : trace nodes through the thickness; through : (plate levels, levels) from these to the mesh's
    paired : (pairs, 9) stiffness between pairs of nodes, see `Assembler`
    representative_mass, nodal_mass : lumped mass of the folded and of the whole mesh, kg
    """

    cell: UnitCell
    mesh: HexMesh
    levels: int
    assembler: Assembler
    paired: Array
    through: Array
    representative_mass: Array
    nodal_mass: Array

    @classmethod
    def of(cls, cell: UnitCell, plan: MeshPlan) -> FoldedMesh:
        """Mesh a cell and fold it along its mirrors."""
        mesh, levels = mesh_cell(cell, plan), trace_levels(plan)
        topology = mesh.topology
        folding = fold(topology, mirrors_of(cell))
        elements, mass = [], np.zeros(len(folding.origin))
        for family, picked, weight in zip(topology.families, folding.chosen, folding.weight, strict=True):
            nodes = family.nodes[picked]
            matrices = element_matrices(mesh.points, nodes, cell.material)
            own = (matrices.mass * weight[:, None]).ravel()
            mass += np.bincount(folding.node[nodes].ravel(), own, minlength=len(mass))
            elements.append(matrices)
        assembler = assembler_of(topology, folding)
        return cls(
            cell=cell,
            mesh=mesh,
            levels=levels,
            assembler=assembler,
            paired=assembler.paired(tuple(elements)),
            through=through_levels(cell, mesh, levels),
            representative_mass=mass,
            nodal_mass=(mass / np.bincount(folding.node))[folding.node],
        )

    @property
    def folding(self) -> Folding:
        return self.assembler.folding

    def classes_and_images(self) -> tuple[list[int], dict[int, int]]:
        """Symmetry classes to compute, and those that are images of another in the diagonal of a square."""
        parity = [tuple(int(sign) for sign in signs) for signs in self.folding.parity]
        images = {}
        if DIAGONAL in self.cell.lattice.point_group and len(parity) == 4:
            images[parity.index((-1, 1))] = parity.index((1, -1))
        return [q for q in range(len(parity)) if q not in images], images

    def symmetry_class(self, q: int) -> FoldedCell:
        """The matrices of one class."""
        folding, through = self.folding, self.through
        trace = FoldedTrace(self.mesh.topology, folding, q, self.levels)
        stiffness = self.assembler.assembled(self.paired, q)
        shape = (len(through), trace.places, 3)
        coupling = np.tensordot(through.T, stiffness.coupling().reshape(-1, *shape), axes=(1, 1))
        rim = stiffness.boundary().reshape(*shape, *shape)
        rim = np.einsum("lk,lpcmqd,mj->kpcjqd", through, rim, through, optimize=True)
        rim_mass = self.representative_mass[folding.interior :].reshape(shape[:2])
        weights = np.einsum("lk,lp,lj->kpj", through, rim_mass, through)
        inertia = np.einsum("kpj,pq,cd->kpcjqd", weights, np.eye(trace.places), np.eye(3))
        size = self.levels * trace.places * 3
        own = np.ix_(trace.kept, trace.kept)
        alive = folding.sign[q][folding.origin[: folding.interior]] != 0
        return FoldedCell(
            trace=trace,
            interior=stiffness.interior(),
            coupling=np.moveaxis(coupling, 0, 1).reshape(-1, size)[:, trace.kept],
            trace_stiffness=rim.reshape(size, size)[own],
            trace_mass=inertia.reshape(size, size)[own],
            mass=(self.representative_mass[: folding.interior, None] * alive).ravel(),
        )

    def pillar_stiffness(self, q: int) -> sp.csr_array:
        """The pillar's share of the interior stiffness of one class; it reaches no lateral face."""
        assembler = self.assembler
        return assembler.pattern.matrix(assembler.assembled_pillar(self.paired, q).unsprung())

    @cached_property
    def above(self) -> Array:
        """(3 interior,) 1 for unknowns above the plate's top."""
        heights = self.mesh.points[self.folding.origin[: self.folding.interior], 2]
        top = self.mesh.points[self.mesh.topology.rim[-1, 0], 2]
        return np.repeat(heights > top, 3).astype(float)
