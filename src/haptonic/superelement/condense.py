"""One unit cell, its interior condensed once (Craig and Bampton 1968, doi 10.2514/3.4741).

Inside the cell a field is the static answer to its trace, plus modes that have no trace.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import scipy.linalg as la
from numpy.typing import NDArray

from haptonic.cell import HexMesh, MeshPlan, UnitCell, mesh_cell
from haptonic.solvers import Solver
from haptonic.superelement.folded import FoldedCell, FoldedMesh
from haptonic.superelement.interior import interior_modes
from haptonic.superelement.parallel import for_each_class
from haptonic.superelement.sections import PillarSections, momentum_forms, pillar_sections
from haptonic.superelement.trace import FoldedTrace

Array = NDArray[np.float64]
Fields = NDArray[Any]  # real or complex


@dataclass(frozen=True)
class Part:
    """How one symmetry class is lifted back: static answers (3 interior, b) and modes (3 interior, m)."""

    trace: FoldedTrace
    through: Array
    static: Array
    modes: Array

    def lifted(self, trace: Fields, amplitudes: Fields) -> Fields:
        """(nodes, 3, k) displacement from a whole trace (t, k) and the class's modal amplitudes (m, k)."""
        own = self.trace.fold(trace)
        inside = self.static @ own + self.modes @ amplitudes
        rim = self.trace.on_levels(self.through, own)
        values = np.concatenate([inside.reshape(-1, 3, own.shape[1]), rim])
        folding = self.trace.folding
        return np.asarray(folding.sign[self.trace.symmetry_class][:, :, None] * values[folding.node])


@dataclass(frozen=True)
class Measures:
    """Quadratic forms (t + m, t + m) and linear ones that say what kind of motion a field is.

    pillar_stiffness, pillar_mass : the pillar's shares; vertical_mass : the share of motion along z
    sections : how the pillar moves
    """

    pillar_stiffness: Array
    pillar_mass: Array
    vertical_mass: Array
    sections: PillarSections


@dataclass(frozen=True)
class Superelement:
    """Condensed cell. Unknowns: the trace (level, place on the rim, component), then modal amplitudes.

    cell, mesh : what it was made from
    levels : trace nodes through the thickness
    stiffness, mass : (t + m, t + m), N/m and kg
    omission : (t, t) such that ``lambda**2 b* omission b`` is, to first order, what the interior fields
        that were left out would take off the eigenvalue lambda of a field with trace b and unit mass
    nodal_mass : (nodes,) lumped mass of the mesh, kg
    parts : the symmetry classes, in the order of their modes
    measures : what characterises motion, if it was asked for
    """

    cell: UnitCell
    mesh: HexMesh
    levels: int
    stiffness: Array
    mass: Array
    omission: Array
    nodal_mass: Array
    parts: tuple[Part, ...]
    measures: Measures | None

    @property
    def trace_size(self) -> int:
        return len(self.omission)

    @property
    def size(self) -> int:
        return len(self.stiffness)

    def lifted(self, fields: Fields) -> Fields:
        """(nodes, 3, k) displacement on the mesh from (t + m, k) unknowns, real or complex."""
        trace, amplitudes = np.split(fields, [self.trace_size])
        ends = np.cumsum([part.modes.shape[1] for part in self.parts])
        shares = np.split(amplitudes, ends[:-1])
        pieces = (part.lifted(trace, share) for part, share in zip(self.parts, shares, strict=True))
        return np.asarray(sum(pieces))


def condense(cell: UnitCell, plan: MeshPlan, steps: int = 2, *, measured: bool = True) -> Superelement:
    """Condense a cell onto its lateral faces.

    Parameters
    ----------
    cell, plan : what to mesh, and how finely
    steps : blocks of the Krylov space that stands for the interior's own motion
    measured : also make what characterises motion
    """
    mesh = mesh_cell(cell, plan)
    shared = FoldedMesh.of(cell, mesh, plan.order + 1)
    pieces = for_each_class(shared, lambda q, solver: _condense_class(shared, q, solver, steps, measured))
    layouts = [piece.part.trace for piece in pieces]

    def on_trace(own: list[Array]) -> Array:
        pairs = zip(layouts, own, strict=True)
        return np.asarray(np.sum([layout.unfold_form(form) for layout, form in pairs], axis=0))

    def whole(name: str) -> Array:
        forms = [piece.forms[name] for piece in pieces]
        corner = on_trace([f.corner for f in forms])
        side = np.hstack([layout.unfold_rows(f.side) for layout, f in zip(layouts, forms, strict=True)])
        return np.block([[corner, side], [side.T, la.block_diag(*(f.modal for f in forms))]])

    measures = None
    if measured:
        of_trace = np.sum([p.part.trace.unfold_rows(p.momenta_of_trace.T) for p in pieces], axis=0)
        momenta = np.hstack([of_trace.T, *(p.momenta_of_modes for p in pieces)])
        sections = pillar_sections(mesh, shared.nodal_mass, momenta)
        measures = Measures(whole("pillar_stiffness"), whole("pillar_mass"), whole("vertical_mass"), sections)
    return Superelement(
        cell=cell,
        mesh=mesh,
        levels=shared.levels,
        stiffness=whole("stiffness"),
        mass=whole("mass"),
        omission=on_trace([p.omission for p in pieces]),
        nodal_mass=shared.nodal_mass,
        parts=tuple(piece.part for piece in pieces),
        measures=measures,
    )


@dataclass(frozen=True)
class _Form:
    """Quadratic form of one class: among own trace unknowns, between these and modes, among modes."""

    corner: Array
    side: Array
    modal: Array


@dataclass(frozen=True)
class _CondensedClass:
    part: Part
    forms: dict[str, _Form]
    omission: Array
    momenta_of_trace: Array
    momenta_of_modes: Array


def _condense_class(
    shared: FoldedMesh, q: int, solver: Solver, steps: int, measured: bool
) -> _CondensedClass:
    folded = shared.symmetry_class(q)
    mass = folded.mass[:, None]
    solver.factorise(folded.interior)
    static = solver.solve(-folded.coupling)
    inertia = mass * static
    values, modes, dynamic = interior_modes(solver, folded.mass, inertia, steps)
    to_modes = inertia.T @ modes
    # static answers do no work on fields without a trace, so stiffness does not couple the two
    forms = {
        "stiffness": _Form(
            folded.trace_stiffness + folded.coupling.T @ static, np.zeros_like(to_modes), np.diag(values)
        ),
        "mass": _Form(folded.trace_mass + static.T @ inertia, to_modes, np.eye(len(values))),
    }
    # inertia of the static answers that the modes do not carry, answered by the inverse stiffness
    omission = inertia.T @ dynamic - (to_modes / values) @ to_modes.T
    part = Part(folded.trace, shared.through, static, modes)
    momenta = momentum_forms(shared.mesh, shared.folding, q, shared.nodal_mass)
    if measured:
        forms |= _measuring_forms(shared, q, folded, static, modes)
    return _CondensedClass(part, forms, 0.5 * (omission + omission.T), momenta @ static, momenta @ modes)


def _measuring_forms(
    shared: FoldedMesh, q: int, folded: FoldedCell, static: Array, modes: Array
) -> dict[str, _Form]:
    def form(on_static: Array, on_modes: Array) -> _Form:
        return _Form(static.T @ on_static, static.T @ on_modes, modes.T @ on_modes)

    pillar = shared.pillar_stiffness(q)
    in_pillar = (folded.mass * shared.above)[:, None]
    along_z = np.tile([0.0, 0.0, 1.0], len(folded.mass) // 3)
    vertical = (folded.mass * along_z)[:, None]
    moving = form(vertical * static, vertical * modes)
    on_rim = folded.trace_mass * folded.trace.is_vertical
    return {
        "pillar_stiffness": form(pillar @ static, pillar @ modes),
        "pillar_mass": form(in_pillar * static, in_pillar * modes),
        "vertical_mass": _Form(moving.corner + on_rim, moving.side, moving.modal),
    }
