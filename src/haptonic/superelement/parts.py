"""Reduction of the symmetry classes of a mesh by their parts."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.later import linalg as la, sparse as sp
from haptonic.parallel import each
from haptonic.solvers import Solver
from haptonic.superelement.bounded import Bounded, StaticResponse, orthonormal
from haptonic.superelement.class_parts import ROUNDING, ClassPart, parts_of_mesh
from haptonic.superelement.folded import FoldedMesh
from haptonic.superelement.interior import MISSED_BY_BANDS, CraigBampton, reduced
from haptonic.superelement.parallel import with_solver
from haptonic.superelement.standing import standing_motions
from haptonic.superelement.trace import FoldedTrace

Result = TypeVar("Result")

INDEPENDENT = 1e-9  # share of the largest motion of an end below which a motion depends on others


@dataclass(frozen=True)
class PartForms:
    """Matrices of a part before condensation, and its relation to its classes.

    interior : values of the interior stiffness on the part's pattern; body : the other forms
    boundary : for each class, (b, b of the part) transpose of the matrix from the class's boundary to the
        part's
    """

    interior: Array
    body: Bounded
    boundary: dict[int, Array]

    @classmethod
    def of(cls, shared: FoldedMesh, part: ClassPart, ends: Sequence[Array]) -> PartForms:
        """Compute the matrices of a part of a mesh; ``ends`` as for `reduced_by_parts`."""
        folding, first = shared.folding, next(iter(part.fields))
        if part.is_class:
            interior, body = shared.symmetry_class(first, ends[first] if ends else None)
            return cls(interior, body, {first: np.eye(len(body.outer_mass))})
        on_trace = {q: _on_trace(part, shared.traces[q]) for q in part.fields}
        of_trace = {q: _shares(fields, shared.traces[q].images) for q, fields in on_trace.items()}
        # one set of motions of the open ends for all classes of the part
        beyond = folding.interior + shared.traces[first].rim_size
        at_ends = {q: fields[3 * beyond :, part.behind >= beyond] for q, fields in part.fields.items()}
        images = np.repeat(np.bincount(folding.node)[beyond:], 3)
        met = (
            [_shares(of_class, images) @ ends[q] for q, of_class in at_ends.items()]
            if ends
            else [np.zeros((0, 0))] * 2
        )
        motions, size, turn = la.svd(np.hstack(met), full_matrices=False)
        independent = size > INDEPENDENT * size.max(initial=0.0)
        motions, turn = motions[:, independent], (size[:, None] * turn)[independent]
        of_ends = np.split(turn, np.cumsum([share.shape[1] for share in met])[:-1], axis=1)

        interior, body = shared.symmetry_class(first, at_ends[first] @ motions if ends else None)
        boundary = la.block_diag(on_trace[first].toarray(), np.eye(len(turn)))
        if part.gather:
            numbers = {
                q: shared.assembler.assembled(shared.paired, q).unsprung() for q in part.gather if q != first
            }
            numbers[first] = interior
            interior = np.sum([gather @ numbers[q] for q, gather in part.gather.items()], axis=0)
        return cls(
            interior=interior,
            body=Bounded(
                coupling=part.inside[first].T @ body.coupling @ sp.csr_array(boundary),
                outer_stiffness=boundary.T @ body.outer_stiffness @ boundary,
                outer_mass=boundary.T @ body.outer_mass @ boundary,
                mass=part.inside[first].power(2).T @ body.mass,
            ),
            boundary={
                q: la.block_diag(of_trace[q].toarray(), of_end).T
                for q, of_end in zip(part.fields, of_ends, strict=False)
            },
        )


def reduced_by_parts(
    shared: FoldedMesh, ends: Sequence[Array], steps: int, block: int, highest: float | None = None
) -> list[CraigBampton]:
    """Reduce each class of a mesh by its parts.

    ends : for each class the motions of open ends, as for `FoldedMesh.symmetry_class`, or empty
    steps, block : as for a class; each part gets its share of the block
    highest : Hz, up to which few modes suffice; by default all modes are used
    """

    def responded(part: ClassPart, solver: Solver) -> tuple[PartForms, StaticResponse]:
        forms = PartForms.of(shared, part, ends)
        solver.factorise(forms.interior)
        return forms, StaticResponse.of(solver, forms.body)

    def reduced_part(
        part: ClassPart, solver: Solver, forms: PartForms, response: StaticResponse, starts: Array | None
    ) -> dict[int, CraigBampton]:
        of_part = reduced(solver, response, steps, math.ceil(block * part.share), starts)
        if highest is not None:
            of_part = of_part.with_few_modes(highest, MISSED_BY_BANDS)
        if part.is_class:
            return dict.fromkeys(part.fields, of_part)
        return {q: of_part.unfolded(part.inside[q], boundary) for q, boundary in forms.boundary.items()}

    def from_softest(part: ClassPart, solver: Solver) -> dict[int, CraigBampton]:
        return reduced_part(part, solver, *responded(part, solver), None)

    def from_standing(
        part: ClassPart, solver: Solver, forms: PartForms, response: StaticResponse
    ) -> dict[int, CraigBampton]:
        solver.factorise(forms.interior)  # the factors of all parts together need too much memory
        of_classes = [boundary.T @ standing[q] for q, boundary in forms.boundary.items()]
        return reduced_part(part, solver, forms, response, orthonormal(np.hstack(of_classes), response.mass))

    if ends:  # bodies beyond the ends matter more than equal tiles beyond the sides
        parts = for_each_part(shared, from_softest)
    else:
        responses = for_each_part(shared, responded)
        standing = [_standing(shared, q, responses, block) for q in range(shared.folding.classes)]
        parts = for_each_part(shared, from_standing, responses)
    return [
        CraigBampton.together([of_part[q] for of_part in parts if q in of_part])
        for q in range(shared.folding.classes)
    ]


def _standing(
    shared: FoldedMesh, q: int, parts: Sequence[tuple[PartForms, StaticResponse]], count: int
) -> Array:
    """(b, n) motions of the boundary of a class in standing waves, from the responses of its parts."""
    of_class = [(forms.boundary[q], response) for forms, response in parts if q in forms.boundary]
    stiffness = np.sum([onto @ response.stiffness @ onto.T for onto, response in of_class], axis=0)
    mass = np.sum([onto @ response.mass @ onto.T for onto, response in of_class], axis=0)
    return standing_motions(shared.cell, shared.traces[q], stiffness, mass, count)


def for_each_part(
    shared: FoldedMesh, work: Callable[..., Result], given: list[Any] | None = None
) -> list[Result]:
    """Return ``work(part, solver, *given)`` for all parts of a mesh; no two threads share a solver.

    Parts share read-only arrays only. One thread per part is faster than threads inside the linear algebra,
    whose matrices are small here.

    given : further arguments for each part, which are removed because they may need much memory
    """

    def work_with_solver(numbered: tuple[int, ClassPart]) -> Result:
        number, part = numbered
        arguments = ()
        if given is not None:
            arguments, given[number] = given[number], ()
        return with_solver(part.pattern, lambda solver: work(part, solver, *arguments))

    return each(work_with_solver, enumerate(parts_of_mesh(shared)))


def _on_trace(part: ClassPart, trace: FoldedTrace) -> sp.csr_array:
    """(b, n) unknowns of a class's trace from those of a part, as many on each level."""
    level = part.on_rim[trace.symmetry_class]
    every = sp.csr_array(sp.kron(sp.eye_array(trace.own_levels), level))[trace.kept]
    return every[:, abs(every).sum(axis=0) > ROUNDING]  # some components are zero in the middle plane


def _shares(fields: sp.csr_array, images: NDArray[Any]) -> sp.csr_array:
    """(n, m) unknowns of a part from those of its class; ``images`` (m,) number of images of each."""
    weighted = sp.csr_array(fields.multiply(images[:, None]))
    return sp.csr_array((weighted / weighted.multiply(fields).sum(axis=0)).T)
