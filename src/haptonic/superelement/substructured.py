"""A cell condensed in two steps: its plate with the foot of the pillar, then the pillar's body upon it.

The body needs no mesh, and what stands below it is condensed once for all lengths of the body. Only the
foot sees the singular edge, and it alone needs the fine mesh.
"""

from __future__ import annotations

import hashlib
from collections import OrderedDict
from dataclasses import dataclass, replace
from threading import Lock

import numpy as np

from haptonic.arrays import Array, Fields, Ints
from haptonic.cell import HexMesh, MeshPlan, TileShape, mesh_cell
from haptonic.cell.edges import FOOT_LAYER
from haptonic.cell.topology import Topology, topology_of
from haptonic.later import linalg as la
from haptonic.solvers import Solver, definite
from haptonic.superelement.condense import ClassForm, CondensedClass, Superelement, assembled, condensed
from haptonic.superelement.folded import FoldedMesh
from haptonic.superelement.interior import Bounded, CraigBampton, reduced
from haptonic.superelement.lifting import DiagonalImage, unfolded
from haptonic.superelement.measures import ENERGIES, ClassMeasures
from haptonic.superelement.parallel import KEPT_ENTRIES, for_each_class
from haptonic.superelement.pillar_body import PARITIES, Kinds, PillarBody
from haptonic.superelement.sections import section_sizes
from haptonic.superelement.symmetry import DIAGONAL, Folding, folds_of
from haptonic.superelement.trace import FoldedTrace

LEAST_ORDER, PER_LAYER = 8, 2  # of the polynomials along the body, and what each layer of a mesh adds
FOR_SECTION = 4  # directions in each block of a foot's Krylov space beyond those that a whole cell has
KEPT_FEET = 4  # that wait for the next design with the same


@definite()
def condense_by_parts(
    cell: TileShape, plan: MeshPlan, steps: int = 2, *, block: int = 10, measured: bool = True
) -> Superelement:
    """Condense a cell onto its lateral faces, its pillar's body apart where it is a prism.

    Parameters as for `condense`. On the same plan the two differ by the error that the mesh of the body has
    there. A pillar with draft or a step, or one too short, has no body, and then they are the same.
    """
    mesh = mesh_cell(cell, plan)
    body = pillar_body_of(cell, mesh)
    if body is None:
        return condensed(FoldedMesh.of_mesh(cell, mesh), steps, block=block, measured=measured)
    foot = _foot_below(cell, mesh, body, steps, block, measured)
    joined = {q: _joined(one, body, mesh, foot.through, steps, block) for q, one in foot.classes.items()}
    if foot.images:
        mirror = DiagonalImage.of(cell, mesh.topology, foot.levels)
        joined |= {q: joined[original].mirrored(mirror) for q, original in foot.images.items()}
    sizes = np.hstack([foot.sizes, body.sizes]) if measured else None
    return assembled(cell, mesh, foot.levels, [joined[q] for q in sorted(joined)], sizes)


def pillar_body_of(cell: TileShape, mesh: HexMesh) -> PillarBody | None:
    """The body of a cell's pillar, which starts where the mesh's second layer above the thin ones does."""
    pillar, plan = cell.pillar, mesh.topology.plan
    if pillar is None or not pillar.is_prism or plan.pillar_layers < 2:
        return None
    low = float(mesh.points[_below_body(mesh.topology).level_start[-2], 2])
    if low - cell.thickness < FOOT_LAYER * pillar.diameter * (1 - 1e-9):
        return None
    # polynomials that the nodes of the foot can follow; a square that is twisted warps more than a disc
    degree = plan.order // 2 if pillar.section == "square" else (plan.order + 2) // 3
    return PillarBody(
        low=low,
        length=cell.thickness + pillar.height - low,
        half_width=pillar.radius,
        section=pillar.section,
        material=cell.material,
        degree=degree,
        order=LEAST_ORDER + PER_LAYER * plan.pillar_layers,
        kinds=len(PARITIES) // 2 ** len(folds_of(cell)),
        faces=mesh.topology.faces,
    )


@dataclass(frozen=True)
class _FootClass:
    """One symmetry class of what stands below a body: its boundary is the trace, then the body's section.

    parities : of the polynomials of the displacement's components in this class
    on_top : (3 representatives, s) the highest level's nodes from the section's unknowns
    own : on boundary and modes; measures : the same
    """

    trace: FoldedTrace
    parities: tuple[Kinds, ...]
    on_top: Array
    own: CraigBampton
    measures: ClassMeasures | None


@dataclass(frozen=True)
class _Foot:
    """All that stands below a body, condensed.

    levels, through : as of a `FoldedMesh`; classes : by number
    images : those that are diagonal images of another; sizes : of the pillar's sections below the body
    """

    levels: int
    through: Array
    classes: dict[int, _FootClass]
    images: dict[int, int]
    sizes: Array


_feet: OrderedDict[str, _Foot] = OrderedDict()
_lock = Lock()


def _below_body(whole: Topology) -> Topology:
    return topology_of(replace(whole.plan, pillar_layers=1), mirrored=whole.mirrored)


def _of_foot(whole: Topology, foot: Topology) -> Ints:
    """Numbers of the foot's nodes in the whole mesh: the lowest of all, and their images."""
    upper = np.arange(foot.level_start[-1])
    return np.concatenate([upper, whole.image[upper[foot.level_start[1] :]]]) if foot.mirrored else upper


def _foot_below(
    cell: TileShape, mesh: HexMesh, body: PillarBody, steps: int, block: int, measured: bool
) -> _Foot:
    """The foot of a body, made or found again."""
    topology = _below_body(mesh.topology)
    points = mesh.points[_of_foot(mesh.topology, topology)]
    about = (
        topology.plan,
        topology.mirrored,
        folds_of(cell),
        cell.has_symmetry(DIAGONAL),
        body.section,
        body.degree,
        steps,
        block,
        measured,
    )
    content = [repr(about).encode(), points.tobytes(), cell.material.stiffness.tobytes()]
    key = hashlib.sha256(b"".join(content) + repr(cell.material.density).encode()).hexdigest()
    with _lock:
        if key in _feet:
            _feet.move_to_end(key)
            return _feet[key]
    shared = FoldedMesh.of_mesh(cell, HexMesh(topology, points), open_top=True)

    def work(q: int, solver: Solver) -> tuple[int, _FootClass]:
        return q, _condense_foot(shared, q, solver, body, steps, block, measured)

    foot = _Foot(
        levels=shared.levels,
        through=shared.through,
        classes=dict(for_each_class(shared, work, lambda original: original)),
        images=shared.classes_and_images()[1],
        sizes=section_sizes(shared.mesh, shared.nodal_mass),
    )
    if len(shared.assembler.pattern.indices) <= KEPT_ENTRIES:
        with _lock:
            _feet[key] = foot
            while len(_feet) > KEPT_FEET:
                _feet.popitem(last=False)
    return foot


def _condense_foot(
    shared: FoldedMesh, q: int, solver: Solver, body: PillarBody, steps: int, block: int, measured: bool
) -> _FootClass:
    folding = shared.folding
    parities = _parities(folding, q)
    top = folding.origin[folding.node[shared.mesh.topology.top].min() :]
    x, y, _ = shared.mesh.points[top].T
    values = np.zeros((len(top), 3, body.shapes, 3))
    for c, kinds in enumerate(parities):
        values[:, c, :, c] = body.over_section(kinds, x, y)
    on_top = values.reshape(3 * len(top), body.on_section)
    folded = shared.symmetry_class(q, on_top)
    solver.factorise(folded.interior)
    own = reduced(solver, folded.body, steps, block + FOR_SECTION * body.kinds)
    measures = ClassMeasures.of(shared, q, folded, own, on_top) if measured else None
    return _FootClass(trace=folded.trace, parities=parities, on_top=on_top, own=own, measures=measures)


def _parities(folding: Folding, q: int) -> tuple[Kinds, ...]:
    """Kinds of polynomials of the displacement's components in a class: those with its signs."""
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


def _joined(
    foot: _FootClass, body: PillarBody, mesh: HexMesh, through: Array, steps: int, block: int
) -> CondensedClass:
    """A class of the whole cell: inside are the body's section, the foot's modes, the rest of the body."""
    own, section, modes = foot.own, body.on_section, len(foot.own.values)
    trace, below = len(own.mass) - section, section + modes
    stiff, heavy = body.stiffness(foot.parities), body.mass
    on_trace, on_section = slice(0, trace), slice(trace, None)
    # unknowns in which the mass is 1: the section's and the modes' are coupled by theirs, the others are not
    to_modes = own.to_modes[on_section]
    mass = np.block([[own.mass[on_section, on_section], to_modes], [to_modes.T, np.eye(modes)]])
    mass[:section, :section] += np.diag(heavy[:section])
    turn = la.solve_triangular(la.cholesky(mass, lower=True), np.eye(below), lower=True).T
    light = heavy[section:] ** -0.5
    inside = np.zeros((below + len(light),) * 2)
    at_foot = la.block_diag(own.stiffness[on_section, on_section], np.diag(own.values))
    at_foot[:section, :section] += stiff[:section, :section]
    inside[:below, :below] = turn.T @ at_foot @ turn
    inside[below:, :below] = light[:, None] * (stiff[section:, :section] @ turn[:section])
    inside[:below, below:] = inside[below:, :below].T
    inside[below:, below:] = light[:, None] * stiff[section:, section:] * light
    coupling, mass_coupling = np.zeros((2, len(inside), trace))
    coupling[:below] = turn[:section].T @ own.stiffness[on_section, on_trace]
    between = np.vstack([own.mass[on_section, on_trace], own.to_modes[on_trace].T])
    mass_coupling[:below] = turn.T @ between
    bounded = Bounded(
        coupling=coupling,
        outer_stiffness=own.stiffness[on_trace, on_trace],
        outer_mass=own.mass[on_trace, on_trace],
        mass=np.ones(len(inside)),
        mass_coupling=mass_coupling,
    )
    found = reduced(_Dense(inside), bounded, steps, block)

    def turned_back(fields: Array) -> Array:
        return np.vstack([turn @ fields[:below], light[:, None] * fields[below:]])

    static, dynamic = turned_back(found.static), turned_back(found.modes)
    # boundary and modes of the foot, and unknowns of the body, from the trace and the modes of the whole
    inner = np.hstack([static, dynamic])
    of_foot = np.vstack([np.eye(trace, inner.shape[1]), inner[:below]])
    of_body = np.delete(inner, np.s_[section:below], axis=0)
    part = SubstructuredPart(foot=foot, body=body, mesh=mesh, through=through, static=static, modes=dynamic)
    piece = CondensedClass.of(part, found, _measured(foot, body, stiff, of_foot, of_body))
    truncation = of_foot.T @ own.truncation @ of_foot + found.truncation
    return replace(piece, forms=piece.forms | {"truncation": ClassForm.split(foot.trace, truncation)})


def _measured(
    foot: _FootClass, body: PillarBody, stiff: Array, of_foot: Array, of_body: Array
) -> ClassMeasures | None:
    """Measures of foot and body together."""
    if foot.measures is None:
        return None
    heavy = body.mass[:, None] * of_body
    vertical = np.tile([0.0, 0.0, 1.0], len(heavy) // 3)[:, None]
    of_whole_body = (stiff @ of_body, heavy, vertical * heavy)
    energies = {
        name: of_foot.T @ foot.measures.energies[name] @ of_foot + of_body.T @ moved
        for name, moved in zip(ENERGIES, of_whole_body, strict=True)
    }
    count = of_foot.shape[1]
    momenta = (foot.measures.momenta @ of_foot).reshape(4, -1, count)
    momenta = np.concatenate([momenta, body.momenta(foot.parities) @ of_body], axis=1)
    return ClassMeasures(energies, momenta.reshape(-1, count))


class _Dense:
    """A small stiffness, factorised."""

    def __init__(self, stiffness: Array) -> None:
        self._factor = la.cho_factor(stiffness)

    def solve(self, right: Array) -> Array:
        return np.asarray(la.cho_solve(self._factor, right))


@dataclass(frozen=True)
class SubstructuredPart:
    """How one symmetry class is lifted back, see `haptonic.superelement.lifting.ClassLifting`.

    static : (u, b), modes : (u, m) of section, foot's modes and the rest of the body
    """

    foot: _FootClass
    body: PillarBody
    mesh: HexMesh
    through: Array
    static: Array
    modes: Array
    image: DiagonalImage | None = None

    @property
    def trace(self) -> FoldedTrace:
        return self.foot.trace

    @property
    def count(self) -> int:
        return int(self.modes.shape[1])

    def mirrored(self, mirror: DiagonalImage) -> SubstructuredPart:
        return replace(self, image=mirror)

    def lifted(self, trace: Fields, amplitudes: Fields) -> Fields:
        own = self.trace.fold(self.image.trace.applied(trace) if self.image else trace)
        inner = self.static @ own + self.modes @ amplitudes
        foot, count = self.foot, inner.shape[1]
        section, of_modes, beyond = np.split(inner, np.cumsum([self.body.on_section, len(foot.own.values)]))
        inside = foot.own.static @ np.concatenate([own, section]) + foot.own.modes @ of_modes
        rim, top = self.trace.on_levels(self.through, own), (foot.on_top @ section).reshape(-1, 3, count)
        below = unfolded(self.trace, inside, rim, top)
        whole = self.mesh.topology
        inside_body = np.arange(self.trace.topology.level_start[-1], whole.level_start[-1])
        above = self.body.displaced(
            foot.parities, self.mesh.points[inside_body], np.concatenate([section, beyond])
        )
        field = np.empty((whole.nodes, *above.shape[1:]), dtype=above.dtype)
        field[_of_foot(whole, self.trace.topology)] = below
        field[whole.image[inside_body]] = self.trace.sign_of_image[:, None] * above
        field[inside_body] = above
        return self.image.applied(field) if self.image else field
