"""One unit cell, its interior condensed once (Craig and Bampton 1968, doi 10.2514/3.4741).

Inside the cell a field is the static answer to its trace, plus modes that have no trace.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import scipy.linalg as la
from numpy.typing import NDArray

from haptonic.cell import HexMesh, MeshPlan, UnitCell
from haptonic.lattice import Operation
from haptonic.solvers import Solver
from haptonic.superelement.folded import FoldedMesh
from haptonic.superelement.interior import interior_modes
from haptonic.superelement.lifting import DiagonalImage, Part, lifted
from haptonic.superelement.parallel import for_each_class
from haptonic.superelement.sections import PillarSections, mirrored_momenta, momentum_forms, pillar_sections
from haptonic.superelement.trace import TraceMirror

Array = NDArray[np.float64]
Fields = NDArray[Any]  # real or complex

SOFT_TRACES = 24  # of each symmetry class, whose inertia the interior's modes have to answer


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

    @property
    def half_turn_parity(self) -> Array:
        """(m,) +1 for modes that the half-turn about the normal leaves alone, -1 for those it turns over."""
        parity = self.parts[0].trace.folding.parity
        assert parity.shape[1] == 2, (
            "without both mirrors the classes are not even or odd under the half-turn"
        )
        counts = [part.modes.shape[1] for part in self.parts]
        return np.repeat(parity.prod(axis=1), counts).astype(float)

    def mirror(self, operation: Operation) -> TraceMirror:
        """How a mirror, or the half-turn, acts on traces."""
        return TraceMirror.of(self.mesh.topology, self.levels, operation)

    def lifted(self, fields: Fields) -> Fields:
        """(nodes, 3, k) displacement on the mesh from (t + m, k) unknowns, real or complex."""
        return lifted(self.parts, *np.split(fields, [self.trace_size]))


def on_each(form: Array, fields: Fields) -> Array:
    """(k,) values of a real quadratic form (n, n) on fields (n, k), real or complex."""
    parts = np.hstack([fields.real, fields.imag]) if np.iscomplexobj(fields) else fields
    values = np.einsum("ik,ik->k", parts, form @ parts)
    return np.asarray(values.reshape(-1, fields.shape[1]).sum(axis=0))


def condense(
    cell: UnitCell, plan: MeshPlan, steps: int = 2, *, block: int = 10, measured: bool = True
) -> Superelement:
    """Condense a cell onto its lateral faces.

    Parameters
    ----------
    cell, plan : what to mesh, and how finely
    steps, block : number and size of the blocks of the Krylov space that stands for the interior's own motion
    measured : also make what characterises motion
    """
    return condensed(FoldedMesh.of(cell, plan), steps, block=block, measured=measured)


def condensed(shared: FoldedMesh, steps: int, *, block: int, measured: bool) -> Superelement:
    """The superelement of a mesh that is folded already; see `condense`."""
    mesh = shared.mesh

    def mirrored(original: _CondensedClass) -> _CondensedClass:
        return original.mirrored(DiagonalImage.of(mesh.topology, shared.levels))

    pieces = for_each_class(
        shared, lambda q, solver: _condense_class(shared, q, solver, steps, block, measured), mirrored
    )

    def whole(name: str) -> Array:
        forms = [piece.forms[name] for piece in pieces]
        corner = np.sum([form.corner for form in forms], axis=0)
        side = np.hstack([form.side for form in forms])
        return np.block([[corner, side], [side.T, la.block_diag(*(form.modal for form in forms))]])

    measures = None
    if measured:
        of_trace = np.sum([piece.momenta_of_trace for piece in pieces], axis=0)
        momenta = np.hstack([of_trace, *(piece.momenta_of_modes for piece in pieces)])
        sections = pillar_sections(mesh, shared.nodal_mass, momenta)
        measures = Measures(whole("pillar_stiffness"), whole("pillar_mass"), whole("vertical_mass"), sections)
    return Superelement(
        cell=shared.cell,
        mesh=mesh,
        levels=shared.levels,
        stiffness=whole("stiffness"),
        mass=whole("mass"),
        omission=np.sum([piece.omission for piece in pieces], axis=0),
        nodal_mass=shared.nodal_mass,
        parts=tuple(piece.part for piece in pieces),
        measures=measures,
    )


@dataclass(frozen=True)
class _Form:
    """Quadratic form of one class: on the whole trace, between this and the class's modes, among these."""

    corner: Array
    side: Array
    modal: Array

    def mirrored(self, mirror: TraceMirror) -> _Form:
        return _Form(mirror.form(self.corner), mirror.applied(self.side), self.modal)


@dataclass(frozen=True)
class _CondensedClass:
    part: Part
    forms: dict[str, _Form]
    omission: Array
    momenta_of_trace: Array
    momenta_of_modes: Array

    def mirrored(self, mirror: DiagonalImage) -> _CondensedClass:
        """The class that consists of this one's mirror images."""
        return _CondensedClass(
            part=replace(self.part, image=mirror),
            forms={name: form.mirrored(mirror.trace) for name, form in self.forms.items()},
            omission=mirror.trace.form(self.omission),
            momenta_of_trace=mirrored_momenta(mirror.trace.applied(self.momenta_of_trace.T).T),
            momenta_of_modes=mirrored_momenta(self.momenta_of_modes),
        )


def _softest(stiffness: Array, mass: Array) -> tuple[Array, Array]:
    """(b, s) the traces that move at the lowest frequencies if the interior just follows, and their dual.

    With M-orthonormal traces W every trace b is ``W (M W)^T b``; of these the first are kept.
    """
    count = min(SOFT_TRACES, len(mass))
    _, soft = la.eigh(stiffness, mass, subset_by_index=(0, count - 1))
    return soft, mass @ soft


def _condense_class(
    shared: FoldedMesh, q: int, solver: Solver, steps: int, block: int, measured: bool
) -> _CondensedClass:
    folded = shared.symmetry_class(q)
    trace = folded.trace
    solver.factorise(folded.interior)
    static = solver.solve(-folded.coupling)
    inertia = folded.mass[:, None] * static
    stiffness = folded.trace_stiffness + folded.coupling.T @ static
    mass = folded.trace_mass + static.T @ inertia
    soft, dual = _softest(stiffness, mass)
    values, modes, dynamic = interior_modes(solver, folded.mass, inertia @ soft, steps, block)
    to_modes = inertia.T @ modes

    def unfolded(corner: Array, side: Array, modal: Array) -> _Form:
        return _Form(trace.unfold_form(corner), trace.unfold_rows(side), modal)

    # static answers do no work on fields without a trace, so stiffness does not couple the two
    forms = {
        "stiffness": unfolded(stiffness, np.zeros_like(to_modes), np.diag(values)),
        "mass": unfolded(mass, to_modes, np.eye(len(values))),
    }
    # inertia of the soft traces' static answers that the modes do not carry, answered by the inverse
    # stiffness
    soft_to_modes = soft.T @ to_modes
    missing = (inertia @ soft).T @ dynamic - (soft_to_modes / values) @ soft_to_modes.T
    omission = dual @ missing @ dual.T
    momenta = momentum_forms(shared.mesh, shared.folding, q, shared.nodal_mass)
    if measured:
        pillar = shared.pillar_stiffness(q)
        in_pillar = (folded.mass * shared.above)[:, None]
        along_z = np.tile([0.0, 0.0, 1.0], len(folded.mass) // 3)
        vertical = (folded.mass * along_z)[:, None]
        on_rim = folded.trace_mass * trace.is_vertical
        for name, on_static, on_modes, at_trace in (
            ("pillar_stiffness", pillar @ static, pillar @ modes, 0.0),
            ("pillar_mass", in_pillar * static, in_pillar * modes, 0.0),
            ("vertical_mass", vertical * static, vertical * modes, on_rim),
        ):
            forms[name] = unfolded(static.T @ on_static + at_trace, static.T @ on_modes, modes.T @ on_modes)
    return _CondensedClass(
        part=Part(trace, shared.through, static, modes),
        forms=forms,
        omission=trace.unfold_form(0.5 * (omission + omission.T)),
        momenta_of_trace=trace.unfold_rows((momenta @ static).T).T,
        momenta_of_modes=momenta @ modes,
    )
