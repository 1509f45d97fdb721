"""Condensation of solids from a CAD file.

The matrices come from `haptonic.foreign.solids`: curved tetrahedra, prisms and hexahedra of one order, with a
consistent mass matrix. Displacements of their lateral faces are polynomials, like those of a tile meshed in
blocks, so neighbours need not have equal meshes there.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import numpy as np

from haptonic.arrays import Array, Bools, Fields, Ints
from haptonic.cell import MeshPlan, SurfaceMesh, TileShape, UnitCell
from haptonic.cell.mesh import trace_shares
from haptonic.cell.quadrature import lobatto
from haptonic.cell.sectors import along_sides
from haptonic.cell.topology import topology_of
from haptonic.later import sparse as sp
from haptonic.solvers import Pattern, Solver, chosen, definite
from haptonic.superelement.bounded import Bounded, StaticResponse
from haptonic.superelement.condense import CondensedClass, Superelement, assembled
from haptonic.superelement.dynamic import DynamicStiffness
from haptonic.superelement.interior import MISSED_BY_BANDS, reduced
from haptonic.superelement.measures import ENERGIES, ClassMeasures
from haptonic.superelement.standing import standing_motions
from haptonic.superelement.surplus import beyond_at_edge
from haptonic.superelement.symmetry import fold, fold_rim
from haptonic.superelement.trace import FoldedTrace

# Away from edges, energies of the degrees of tetrahedra fall more slowly from the highest degree on than up
# to it, by at most this factor. With 3, 5 and 10, the least ratio of estimate and error at order 3 is 0.9,
# 1.4 and 2.9 for a hole; with 5, it is 0.9 for a neck of 0.4 mm between two holes.
SLOWER = 10.0
CLASSES = 4  # of most tiles meshed in blocks; a tile without classes gets as many directions in all
NO_SECTIONS = np.zeros((3, 0))  # height, mass and inertia of pillar sections; a file's solids have none


@dataclass(frozen=True, eq=False)
class SurfaceLifting:
    """Lifting of a tile without symmetry to its surface.

    of_trace : (3 points, t); of_modes : (3 points, m)
    surplus : (3, t + m, t + m) N/m; see `haptonic.superelement.surplus`
    """

    trace: FoldedTrace
    of_trace: Array
    of_modes: Array
    surplus: Array

    @property
    def count(self) -> int:
        """Number of modes."""
        return int(self.of_modes.shape[1])

    def lifted(self, trace: Fields, amplitudes: Fields) -> Fields:
        """(points, 3, k) displacement from a trace (t, k) and modal amplitudes (m, k)."""
        moved = self.of_trace @ trace + self.of_modes @ amplitudes
        return np.asarray(moved.reshape(-1, 3, moved.shape[1]))


@dataclass(frozen=True, eq=False)
class SolidBody:
    """Matrices of the elements of a tile; unknowns are (component, scalar unknown).

    stiffness, mass : sparse, N/m and kg; above : share of the mass beyond the plate's faces
    inner, outer : numbers of the unknowns inside and on the lateral faces
    degree : of the polynomial of each unknown; lower ones than the elements' order - 2 count as this degree
    near : stiffness of the elements near singular edges, N/m
    on_sides : (outer, t) motion of the lateral faces from the trace (level, place, component)
    shown : (3 points, 3 n) displacement at the points of the surface
    """

    tile: TileShape
    plan: MeshPlan
    stiffness: sp.csr_array
    mass: sp.csr_array
    above: sp.csr_array
    inner: Ints
    outer: Ints
    degree: Ints
    near: sp.csr_array
    on_sides: Array
    shown: sp.csr_array
    mesh: SurfaceMesh

    @classmethod
    def of(cls, tile: TileShape, plan: MeshPlan) -> SolidBody:
        """Assemble the solids of a tile.

        Raises
        ------
        GeometryError, ChannelError, ResourceError : as for `haptonic.cell.UnitCell.solid_period`
        """
        assert isinstance(tile, UnitCell)
        assert tile.solid is not None
        solids = [tile.solid.material_of(name, tile.material) for name in tile.solid_period.names]
        assembly = tile.solid.ask(
            "assembled",
            tile.corners,
            tile.vectors,
            tile.thickness,
            order=plan.upward,
            rings=plan.foot_rings + 1,
            stiffness=np.array([solid.stiffness for solid in solids]),
            density=np.array([solid.density for solid in solids]),
            along=0.5 * (1 + lobatto(plan.order)[0]),
            upward=0.5 * (1 + lobatto(plan.levels - 1)[0]),
            inside=0.5 * (1 + lobatto(plan.upward)[0]),
        )
        count = int(assembly["unknowns"])
        outer = (np.arange(3)[:, None] * count + assembly["lateral"]).ravel()
        mass = _sparse(assembly["mass"])
        used = mass.diagonal() > 0.0  # a mesh may have points outside all elements
        inner = np.setdiff1d(np.flatnonzero(np.tile(used, 3)), outer)
        trace = assembly["trace"]
        shown = assembly["shown"]
        of_points = sp.csr_array(
            (shown["values"], (shown["rows"], shown["columns"])), shape=(len(assembly["points"]), count)
        )
        topology = topology_of(plan)
        rim = along_sides(tile.corners, trace_shares(plan))
        mesh = SurfaceMesh(
            points=assembly["points"],
            cells=assembly["cells"],
            lower=assembly["lower"],
            rim_points=np.column_stack([rim, np.zeros(len(rim))]),
            unknowns=3 * count,
            topology=topology,
        )
        return cls(
            tile=tile,
            plan=plan,
            stiffness=_sparse(assembly["stiffness"]),
            mass=sp.csr_array(sp.kron(sp.eye_array(3), mass, format="csr")),
            above=_sparse(assembly["above"]),
            inner=inner,
            outer=outer,
            degree=np.tile(assembly["degree"], 3),
            near=_sparse(assembly["near"] or assembly["stiffness"]),
            on_sides=np.einsum("nt,ij->intj", trace, np.eye(3)).reshape(3 * len(trace), -1),
            shown=_by_point(of_points),
            mesh=mesh,
        )

    @cached_property
    def trace(self) -> FoldedTrace:
        """Trace of a tile without symmetry."""
        topology = self.mesh.topology
        return FoldedTrace(
            topology=topology,
            folding=fold(topology, ()),
            rim=fold_rim(topology, ()),
            symmetry_class=0,
            levels=self.plan.levels,
        )

    @cached_property
    def _inside(self) -> tuple[Pattern, Array, Array]:
        """Pattern of the inner unknowns, and values of stiffness and mass on it."""
        stiffness, mass = (
            sp.csr_array(sp.triu(form[self.inner][:, self.inner])) for form in (self.stiffness, self.mass)
        )
        places = []
        for form in (stiffness, mass):
            form.sort_indices()
            rows = np.repeat(np.arange(form.shape[0]), np.diff(form.indptr))
            places.append(rows * form.shape[0] + form.indices)
        where = np.searchsorted(*places)
        assert (places[0][where] == places[1]).all(), "a mass between unknowns without stiffness"
        inertia = np.zeros_like(stiffness.data)
        inertia[where] = mass.data
        pattern = Pattern(stiffness.indptr.astype(np.int32), stiffness.indices.astype(np.int32))
        return pattern, stiffness.data, inertia

    @cached_property
    def bounded(self) -> Bounded:
        """The forms of the inside and of the lateral faces, without the stiffness of the inside."""
        sides = self.on_sides
        coupling = self.stiffness[self.inner][:, self.outer] @ sides
        crossed = self.mass[self.inner][:, self.outer] @ sides
        return Bounded(
            coupling=coupling,
            outer_stiffness=sides.T @ (self.stiffness[self.outer][:, self.outer] @ sides),
            outer_mass=sides.T @ (self.mass[self.outer][:, self.outer] @ sides),
            mass=sp.csr_array(self.mass[self.inner][:, self.inner]),
            mass_coupling=crossed,
        )

    def factorised(self, shift: float = 0.0) -> tuple[Solver, int]:
        """Factorise K - shift M inside; return the solver and the number of eigenvalues below the shift.

        shift : (rad/s)^2
        """
        pattern, stiffness, mass = self._inside
        solver: Solver = chosen()(pattern)
        below = solver.factorise(stiffness - shift * mass, definite=shift == 0.0)
        return solver, below

    def whole(self, inside: Array, sides: Array) -> Array:
        """(3 n, k) field from inner unknowns (inner, k) and the trace (t, k)."""
        fields = np.zeros((self.mass.shape[0], inside.shape[1]))
        fields[self.inner], fields[self.outer] = inside, self.on_sides @ sides
        return fields

    def surplus(self, fields: Array) -> Array:
        """(3, k, k) forms of `haptonic.superelement.surplus` on fields (3 n, k), N/m."""
        order = self.plan.upward
        near, away = self._energies(self.degree == order, fields)
        if order < 3:  # the degree before contains rigid motions
            return np.stack([beyond_at_edge(order) * (near + away), *np.zeros((2, *near.shape))])
        _, before = self._energies(self.degree == order - 1, fields)
        return np.stack([beyond_at_edge(order) * near, away, before / SLOWER])

    def _energies(self, members: Bools, fields: Array) -> Array:
        """(2, k, k) energies of some unknowns in fields (3 n, k): near singular edges, and elsewhere, N/m."""
        moved, numbers = fields[members], np.flatnonzero(members)
        near, whole = (moved.T @ (form[numbers][:, numbers] @ moved) for form in (self.near, self.stiffness))
        return np.stack([near, whole - near])

    def dynamic(self, omega: float) -> DynamicStiffness:
        """Dynamic stiffness of the trace at an angular frequency (rad/s), without any reduced model."""
        solver, below = self.factorised(omega**2)
        body = self.bounded
        assert body.mass_coupling is not None
        shifted = body.coupling - omega**2 * body.mass_coupling
        inside = solver.solve(-shifted)
        return DynamicStiffness(
            omega=omega,
            below=below,
            matrix=body.outer_stiffness - omega**2 * body.outer_mass + shifted.T @ inside,
            mass=body.mass_with(inside),
            parts=(),
            held=np.zeros((0, 3, 0)),
            force=np.zeros((self.on_sides.shape[1], 0)),
        )


@lru_cache(maxsize=1)
def solid_body(tile: TileShape, plan: MeshPlan) -> SolidBody:
    """Matrices of a tile on a plan, for counts; only the last is cached, as it may need gigabytes."""
    return SolidBody.of(tile, plan)


@definite()
def condense_solid(
    tile: TileShape,
    plan: MeshPlan,
    steps: int,
    *,
    block: int,
    measured: bool,
    highest: float | None = None,
) -> Superelement:
    """Condense the solids of a CAD file onto their lateral faces; parameters as for `condense`.

    They have no classes; their single Krylov space has ``CLASSES`` times ``block`` directions.
    """
    body = SolidBody.of(tile, plan)
    solver, _ = body.factorised()
    response = StaticResponse.of(solver, body.bounded)
    starts = standing_motions(tile, body.trace, response.stiffness, response.mass, CLASSES * block)
    reduced_body = reduced(solver, response, steps, CLASSES * block, starts)
    if highest is not None:
        reduced_body = reduced_body.with_few_modes(highest, MISSED_BY_BANDS)
    of_trace = body.whole(reduced_body.static, np.eye(body.on_sides.shape[1]))
    of_modes = body.whole(reduced_body.modes, np.zeros((body.on_sides.shape[1], reduced_body.modes.shape[1])))
    fields = np.hstack([of_trace, of_modes])
    lifting = SurfaceLifting(
        trace=body.trace,
        of_trace=body.shown @ of_trace,
        of_modes=body.shown @ of_modes,
        surplus=body.surplus(fields),
    )
    piece = CondensedClass.of(lifting, reduced_body, _measures(body, fields) if measured else None)
    return assembled(tile, (body.mesh,), plan.levels, [piece], NO_SECTIONS if measured else None)


def _measures(body: SolidBody, fields: Array) -> ClassMeasures:
    """Shares of kinetic energy beyond the plate's faces and along z; the share of strain energy is 0."""
    moved = fields.reshape(3, -1, fields.shape[1])
    above = sum(component.T @ (body.above @ component) for component in moved)
    scalar = body.mass[: moved.shape[1]][:, : moved.shape[1]]
    vertical = moved[2].T @ (scalar @ moved[2])
    energies = dict(zip(ENERGIES, (np.zeros_like(vertical), above, vertical), strict=True))
    return ClassMeasures(energies, momenta=np.zeros((0, fields.shape[1])))


def _sparse(parts: dict[str, Any]) -> sp.csr_array:
    count = len(parts["starts"]) - 1
    return sp.csr_array((parts["values"], parts["columns"], parts["starts"]), shape=(count, count))


def _by_point(of_points: sp.csr_array) -> sp.csr_array:
    """(3 points, 3 n) all components at each point, one after the other, from (component, unknown)."""
    points = of_points.shape[0]
    blocks = sp.kron(sp.eye_array(3), of_points, format="csr")
    return sp.csr_array(blocks[np.arange(3 * points).reshape(3, points).T.ravel()])
