"""Condensation of a unit cell's interior (Craig and Bampton 1968, doi 10.2514/3.4741).

Inside the cell a field is the static response to its trace plus modes that vanish on the trace. With
the unknowns split into trace b and interior i, and a lumped mass,

    u_i = T u_b + Phi q,    K_ii T = -K_ib,    Phi^T M_ii Phi = 1,    Phi^T K_ii Phi = Lambda (diagonal),

    K = [ K_bb + K_bi T   0      ]      M = [ M_bb + T^T M_ii T   T^T M_ii Phi ]
        [ 0               Lambda ]          [ Phi^T M_ii T        1            ]

on (u_b, q), because static responses do no work on fields that vanish on the trace.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from haptonic.arrays import Array, Fields
from haptonic.cell import HexMesh, MeshPlan, SurfaceMesh, TileShape
from haptonic.cell.mesh import trace_shares
from haptonic.cell.quadrature import lobatto
from haptonic.cell.sectors import along_sides
from haptonic.later import sparse as sp
from haptonic.parallel import each
from haptonic.solvers import definite
from haptonic.superelement.folded import FoldedMesh
from haptonic.superelement.interior import CraigBampton
from haptonic.superelement.lifting import ClassLifting, Lifting, lifted
from haptonic.superelement.measures import ENERGIES, ClassMeasures, Measures
from haptonic.superelement.parts import reduced_by_parts
from haptonic.superelement.sections import PillarSections, section_sizes
from haptonic.superelement.surplus import FORMS
from haptonic.superelement.trace import TraceOperation


@dataclass(frozen=True)
class Superelement:
    """Condensed cell. Unknowns: the trace (level, place on the rim, component), then modal amplitudes.

    cell, meshes : the cell and its meshes; the first mesh reaches the lateral faces
    levels : trace nodes through the thickness
    stiffness, mass : (t + m, t + m), N/m and kg
    truncation : (t + m, t + m) form; ``lambda**2 u* truncation u`` is, to first order, the decrease of the
        eigenvalue lambda of a field u of unit mass that the omitted interior fields would cause
    parts : the symmetry classes, in the order of their modes
    measures : forms that characterise motion, or None if they were not requested
    """

    cell: TileShape
    meshes: tuple[HexMesh, ...] | tuple[SurfaceMesh]
    levels: int
    stiffness: Array
    mass: Array
    truncation: Array
    parts: tuple[Lifting, ...]
    measures: Measures | None

    @property
    def mesh(self) -> HexMesh | SurfaceMesh:
        """Mesh of the plate."""
        return self.meshes[0]

    @property
    def trace_size(self) -> int:
        return len(self.parts[0].trace.number)

    @property
    def size(self) -> int:
        return len(self.stiffness)

    @cached_property
    def surplus(self) -> Array:
        """(3, t + m, t + m) N/m, without rigid motions of the cell; see `haptonic.superelement.surplus`.

        Curved elements contain rotations exactly, but in their highest polynomials too: without this
        correction errors of long flexural waves decreased like the wavenumber, and not like the frequency.
        """
        of_parts = each(lambda part: part.surplus, self.parts)
        momenta = self.rigid_motions.T @ self.mass
        amounts = np.linalg.solve(momenta @ self.rigid_motions, momenta)  # of a field in the rigid motions
        whole = np.empty((len(FORMS), self.size, self.size))
        for number, form in enumerate(whole):
            unfolded_form(self.parts, [
                ClassForm.split(forms[number], len(part.trace.kept))
                for forms, part in zip(of_parts, self.parts, strict=True)
            ], form)  # fmt: skip
            of_motions = form @ self.rigid_motions
            shares = of_motions - 0.5 * amounts.T @ (self.rigid_motions.T @ of_motions)
            form -= np.hstack([shares, amounts.T]) @ np.vstack([amounts, shares.T])
        return whole

    @cached_property
    def rigid_motions(self) -> Array:
        """(t + m, 6) translations along and rotations about x, y and z; the cell has no mode in them."""
        places = along_sides(self.cell.corners, trace_shares(self.mesh.topology.plan))
        heights = 0.5 * self.cell.thickness * lobatto(self.levels - 1)[0]
        x, y = np.broadcast_to(places.T[:, None], (2, self.levels, len(places)))
        z = np.broadcast_to(heights[:, None], x.shape)
        still = np.zeros_like(x)
        # (axis, component, level, place)
        rotations = np.array([[still, -z, y], [z, still, -x], [-y, x, still]])
        shifts = np.broadcast_to(np.eye(3)[:, :, None, None], rotations.shape)
        on_trace = np.concatenate([shifts, rotations]).transpose(2, 3, 1, 0).reshape(-1, 6)
        return np.vstack([on_trace, np.zeros((self.size - self.trace_size, 6))])

    @property
    def half_turn_parity(self) -> Array:
        """(m,) +1 for modes that are even in the half-turn about the normal, -1 for odd ones."""
        parity = self.parts[0].trace.folding.parity
        assert parity.shape[1], "a mesh that is not folded has no classes that are even or odd"
        counts = [part.count for part in self.parts]
        return np.repeat(parity.prod(axis=1), counts).astype(float)

    @property
    def middle_parity(self) -> Array:
        """(m,) +1 for modes symmetric about the plate's middle plane, -1 for antisymmetric ones, or 0."""
        middle, counts = self.parts[0].trace.folding.middle, [part.count for part in self.parts]
        return np.repeat(middle, counts).astype(float)

    def projected(self, onto: Array) -> CraigBampton:
        """The body on a boundary (t, b) instead of its trace; its fields are unknowns of this one."""
        t = self.trace_size
        return CraigBampton(
            static=np.vstack([onto, np.zeros((self.size - t, onto.shape[1]))]),
            modes=np.eye(self.size)[:, t:],
            stiffness=onto.T @ self.stiffness[:t, :t] @ onto,
            mass=onto.T @ self.mass[:t, :t] @ onto,
            values=np.diag(self.stiffness)[t:].copy(),
            to_modes=onto.T @ self.mass[:t, t:],
            truncation=_on_boundary(self.truncation, onto),
        )

    def mirror(self, turn: Array) -> TraceOperation:
        """Action on traces of a mirror or the half-turn, given as a map of space (3, 3)."""
        return TraceOperation.of(self.cell, self.mesh.topology, self.levels, turn)

    def lifted(self, fields: Fields) -> Fields:
        """(nodes, 3, k) displacement on the meshes from (t + m, k) unknowns, real or complex."""
        return lifted(self.parts, *np.split(fields, [self.trace_size]))


def _on_boundary(form: Array, onto: Array) -> Array:
    """(b + m, b + m) form on a boundary (t, b) and modes, from one on the trace and modes."""
    t = len(onto)
    side = onto.T @ form[:t, t:]
    return np.block([[onto.T @ form[:t, :t] @ onto, side], [side.T, form[t:, t:]]])


def on_each(form: Fields, fields: Fields) -> Array:
    """(k,) values of a form (n, n), real symmetric or Hermitian, on fields (n, k), real or complex."""
    if np.iscomplexobj(form):
        return np.asarray(np.einsum("ik,ik->k", fields.conj(), form @ fields).real)
    parts = np.hstack([fields.real, fields.imag]) if np.iscomplexobj(fields) else fields
    values = np.einsum("ik,ik->k", parts, form @ parts)
    return np.asarray(values.reshape(-1, fields.shape[1]).sum(axis=0))


def condense(
    cell: TileShape,
    plan: MeshPlan,
    steps: int = 2,
    *,
    block: int = 10,
    measured: bool = True,
    highest: float | None = None,
) -> Superelement:
    """Condense a cell onto its lateral faces.

    Parameters
    ----------
    cell, plan : cell to mesh, and its mesh plan
    steps, block : number and size of the blocks of the Krylov space of interior motions
    measured : whether to compute the forms that characterise motion
    highest : Hz, up to which few interior modes suffice; by default all of the Krylov space are used
    """
    return condensed(FoldedMesh.of(cell, plan), steps, block=block, measured=measured, highest=highest)


@definite()
def condensed(
    shared: FoldedMesh, steps: int, *, block: int, measured: bool, highest: float | None = None
) -> Superelement:
    """Condense a folded mesh; see `condense`."""
    mesh = shared.mesh
    classes, rows = reduced_by_parts(shared, (), steps, block, highest), shared.rows

    def piece(q: int) -> CondensedClass:
        reduced_class = classes[q]
        part = ClassLifting(
            trace=shared.traces[q],
            through=shared.through,
            static=reduced_class.static,
            modes=reduced_class.modes,
            rows=rows,
        )
        return CondensedClass.of(
            part, reduced_class, ClassMeasures.of(shared, q, reduced_class) if measured else None
        )

    sizes = section_sizes(mesh, shared.nodal_mass) if measured else None
    return assembled(shared.cell, (mesh,), shared.levels, each(piece, range(len(classes))), sizes)


def assembled(
    cell: TileShape,
    meshes: tuple[HexMesh, ...] | tuple[SurfaceMesh],
    levels: int,
    pieces: Sequence[CondensedClass],
    sizes: Array | None,
) -> Superelement:
    """Assemble a superelement from its classes; ``sizes`` of the sections if these are measured."""
    measures = None
    if sizes is not None:
        forms = {name: whole(pieces, name) for name in ENERGIES}
        of_trace = np.sum([piece.momenta_of_trace for piece in pieces], axis=0)
        momenta = np.hstack([of_trace, *(piece.momenta_of_modes for piece in pieces)])
        motion = momenta.reshape(4, sizes.shape[1], momenta.shape[1])
        height, mass, inertia = sizes
        sections = (PillarSections(height, mass, inertia, motion),) if len(height) else ()
        measures = Measures(**forms, sections=sections)
    return Superelement(
        cell=cell,
        meshes=meshes,
        levels=levels,
        stiffness=whole(pieces, "stiffness"),
        mass=whole(pieces, "mass"),
        truncation=whole(pieces, "truncation"),
        parts=tuple(piece.part for piece in pieces),
        measures=measures,
    )


def whole(pieces: Sequence[CondensedClass], name: str) -> Array:
    """(t + m, t + m) form of all classes together."""
    return unfolded_form([piece.part for piece in pieces], [piece.forms[name] for piece in pieces])


def unfolded_form(parts: Sequence[Lifting], forms: Sequence[ClassForm], out: Array | None = None) -> Array:
    """(t + m, t + m) form from those of all classes, in the array ``out`` if it is given."""
    spreads = [part.trace.spread for part in parts]
    ends = np.cumsum([spreads[0].shape[0], *(len(form.modal) for form in forms)])
    t, size = ends[0], ends[-1]
    whole = np.empty((size, size)) if out is None else out
    on_classes = [(spread @ form.corner).T for spread, form in zip(spreads, forms, strict=True)]
    whole[:t, :t] = sp.hstack(spreads, format="csr") @ np.vstack(on_classes)
    whole[t:, t:] = 0.0
    for spread, form, start, end in zip(spreads, forms, ends, ends[1:], strict=False):
        whole[:t, start:end] = spread @ form.side
        whole[start:end, start:end] = form.modal
    whole[t:, :t] = whole[:t, t:].T
    return whole


@dataclass(frozen=True)
class ClassForm:
    """Symmetric form of one class.

    corner : on the class's share of the trace; side : between this and the class's modes; modal : on these
    """

    corner: Array
    side: Array
    modal: Array

    @classmethod
    def split(cls, form: Array, count: int) -> ClassForm:
        """Split a form (b + m, b + m); ``count`` is the number b of unknowns of the trace."""
        return cls(form[:count, :count], form[:count, count:], form[count:, count:])


@dataclass(frozen=True)
class CondensedClass:
    """One symmetry class of a superelement.

    forms : by name; momenta_of_trace, momenta_of_modes : (4 sections, t) and (4 sections, m), without
        sections if motion is not measured
    """

    part: Lifting
    forms: dict[str, ClassForm]
    momenta_of_trace: Array
    momenta_of_modes: Array

    @classmethod
    def of(cls, part: Lifting, own: CraigBampton, measured: ClassMeasures | None) -> CondensedClass:
        """Collect the forms of a reduced class, and unfold its momenta."""
        count = len(own.mass)
        # static responses do no work on fields that vanish on the trace
        apart = np.zeros_like(own.to_modes)
        forms = {
            "stiffness": ClassForm(own.stiffness, apart, np.diag(own.values)),
            "mass": ClassForm(own.mass, own.to_modes, np.eye(part.count)),
            "truncation": ClassForm.split(own.truncation, count),
        }
        momenta = np.zeros((0, count + part.count))
        if measured is not None:
            forms |= {name: ClassForm.split(form, count) for name, form in measured.energies.items()}
            momenta = measured.momenta
        return cls(part, forms, part.trace.unfold_rows(momenta[:, :count].T).T, momenta[:, count:])
