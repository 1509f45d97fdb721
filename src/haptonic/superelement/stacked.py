"""Feet and bodies of a pillar, joined on their sections, reduced, and lifted."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import numpy as np

from haptonic.arrays import Array, Fields, Ints
from haptonic.cell import HexMesh
from haptonic.later import linalg as la
from haptonic.superelement.bounded import Bounded, StaticResponse
from haptonic.superelement.condense import ClassForm, CondensedClass
from haptonic.superelement.interior import MISSED_BY_BANDS, CraigBampton, reduced
from haptonic.superelement.lifting import unfolded, whole_fields
from haptonic.superelement.measures import ENERGIES, ClassMeasures
from haptonic.superelement.pillar_body import Kinds, PillarBody
from haptonic.superelement.surplus import FORMS, NodeRows, surplus_forms
from haptonic.superelement.trace import FoldedTrace


@dataclass(frozen=True)
class FootClass:
    """One symmetry class of a foot; its boundary is the trace, then the sections of adjacent bodies.

    parities : of the polynomials of the displacement's components in this class
    on_ends : (3 representatives, s) motion of its open ends from the unknowns of the sections
    own : reduced foot on boundary and modes; measures : on the same unknowns
    through, rows : see `FoldedMesh`
    """

    trace: FoldedTrace
    parities: tuple[Kinds, ...]
    on_ends: Array
    own: CraigBampton
    measures: ClassMeasures | None
    through: Array
    rows: list[NodeRows]

    @cached_property
    def surplus(self) -> Array:
        """(3, b + m, b + m) N/m; see `haptonic.superelement.surplus`."""
        fields = whole_fields(self.trace, self.through, self.own.static, self.own.modes, self.on_ends)
        return surplus_forms(self.trace.folding, self.trace.symmetry_class, self.rows, fields)


@dataclass(frozen=True)
class Storey:
    """Mesh of a foot with the body on it, in the axes of the cell.

    mesh : includes the body, for pictures
    """

    mesh: HexMesh
    body: PillarBody | None
    base: float

    @classmethod
    def of(cls, mesh: HexMesh, body: PillarBody | None, base: float) -> Storey:
        """Raise a mesh and a body, given in axes that start at a height ``base`` (m), to that height."""
        lifted = HexMesh(mesh.topology, mesh.points + np.array([0.0, 0.0, base])) if base else mesh
        return cls(lifted, body and replace(body, low=body.low + base), base)

    def sizes(self, foot: Array) -> Array:
        """(3, sections) sizes of the foot's sections, given in its axes, and the body's; see `PillarBody`."""
        foot = foot + np.array([[self.base], [0.0], [0.0]])
        return foot if self.body is None else np.hstack([foot, self.body.sizes])

    def lifted(self, foot: FootClass, own: Fields, body: Fields) -> Fields:
        """(nodes, 3, k) displacement from unknowns ``own`` of the foot (boundary, modes) and of the body."""
        whole, count = self.mesh.topology, own.shape[1]
        boundary, modes = np.split(own, [len(foot.own.mass)])
        inside = foot.own.static @ boundary + foot.own.modes @ modes
        rim, ends = np.split(boundary, [len(foot.trace.kept)])
        on_rim = [] if whole.free else [foot.trace.on_levels(foot.through, rim)]
        below = unfolded(foot.trace, inside, *on_rim, (foot.on_ends @ ends).reshape(-1, 3, count))
        if self.body is None:
            return below
        along = np.arange(foot.trace.topology.level_start[-1], whole.level_start[-1])
        above = self.body.displaced(foot.parities, self.mesh.points[along], body)
        field = np.empty((whole.nodes, *above.shape[1:]), dtype=above.dtype)
        field[whole.of_foot] = below
        field[whole.image[along]] = foot.trace.sign_of_image[:, None] * above
        field[along] = above
        return field


@dataclass(frozen=True)
class _Numbers:
    """Numbers of the interior unknowns of a class: first those with coupled masses, then the others.

    feet : for each, its sections and modes; bodies : for each, level by level
    heavy : number of unknowns with coupled masses; size : number of all unknowns
    """

    feet: tuple[Ints, ...]
    bodies: tuple[Ints, ...]
    heavy: int
    size: int

    @classmethod
    def of(cls, feet: Sequence[FootClass], storeys: Sequence[Storey]) -> _Numbers:
        ends = np.cumsum([0, *(foot.on_ends.shape[1] + len(foot.own.values) for foot in feet)])
        of_feet = [np.arange(first, beyond) for first, beyond in pairwise(ends)]
        size, bodies = int(ends[-1]), []
        for number, storey in enumerate(storeys):
            if storey.body is None:
                bodies.append(np.empty(0, dtype=np.int64))
                continue
            section = storey.body.on_section
            top = of_feet[number][: feet[number].on_ends.shape[1]][-section:]
            last = of_feet[number + 1][:section] if number + 1 < len(of_feet) else of_feet[0][:0]
            between = len(storey.body.mass) - len(top) - len(last)
            bodies.append(np.concatenate([top, np.arange(size, size + between), last]))
            size += between
        return cls(tuple(of_feet), tuple(bodies), int(ends[-1]), size)


def joined(
    feet: Sequence[FootClass], storeys: Sequence[Storey], steps: int, block: int, highest: float | None = None
) -> CondensedClass:
    """Reduce a class of the whole cell with sections, modes of feet, and rests of bodies as its interior."""
    foot, numbers = feet[0], _Numbers.of(feet, storeys)
    heavy, trace = numbers.heavy, len(foot.trace.kept)
    stiffness, mass = np.zeros((numbers.size, numbers.size)), np.zeros((heavy, heavy))
    lumped, stiff = np.zeros(numbers.size), []
    for member, place in zip(feet, numbers.feet, strict=True):
        sections = np.s_[len(member.trace.kept) :]
        to_modes = member.own.to_modes[sections]
        square, modes = np.ix_(place, place), len(member.own.values)
        stiffness[square] += la.block_diag(
            member.own.stiffness[sections, sections], np.diag(member.own.values)
        )
        mass[square] += np.block(
            [[member.own.mass[sections, sections], to_modes], [to_modes.T, np.eye(modes)]]
        )
    for member, storey, place in zip(feet, storeys, numbers.bodies, strict=True):
        if storey.body is not None:
            stiff.append(storey.body.stiffness(member.parities))
            stiffness[np.ix_(place, place)] += stiff[-1]
            lumped[place] += storey.body.mass
    # change to unknowns of unit mass; the mass matrix couples those of sections and modes only
    mass[np.diag_indices(heavy)] += lumped[:heavy]
    turn = la.solve_triangular(la.cholesky(mass, lower=True), np.eye(heavy), lower=True).T
    light = lumped[heavy:] ** -0.5
    inside = np.empty_like(stiffness)
    inside[:heavy, :heavy] = turn.T @ stiffness[:heavy, :heavy] @ turn
    inside[heavy:, :heavy] = light[:, None] * (stiffness[heavy:, :heavy] @ turn)
    inside[:heavy, heavy:] = inside[heavy:, :heavy].T
    inside[heavy:, heavy:] = light[:, None] * stiffness[heavy:, heavy:] * light
    coupling, mass_coupling = np.zeros((2, numbers.size, trace))
    on_trace, on_section = np.s_[:trace], np.s_[trace:]
    section = foot.on_ends.shape[1]
    coupling[:heavy] = turn[:section].T @ foot.own.stiffness[on_section, on_trace]
    between = np.vstack([foot.own.mass[on_section, on_trace], foot.own.to_modes[on_trace].T])
    mass_coupling[:heavy] = turn[: len(between)].T @ between
    bounded = Bounded(
        coupling=coupling,
        outer_stiffness=foot.own.stiffness[on_trace, on_trace],
        outer_mass=foot.own.mass[on_trace, on_trace],
        mass=np.ones(numbers.size),
        mass_coupling=mass_coupling,
    )
    solver = _Dense(inside)
    reduced_class = reduced(solver, StaticResponse.of(solver, bounded), steps, block)
    if highest is not None:
        reduced_class = reduced_class.with_few_modes(highest, MISSED_BY_BANDS)
    static, dynamic = (
        np.vstack([turn @ fields[:heavy], light[:, None] * fields[heavy:]])
        for fields in (reduced_class.static, reduced_class.modes)
    )
    part = SubstructuredPart(
        feet=tuple(feet), storeys=tuple(storeys), numbers=numbers, static=static, modes=dynamic
    )
    inner = np.hstack([static, dynamic])
    truncation, measured = reduced_class.truncation, []
    for number, (member, storey) in enumerate(zip(feet, storeys, strict=True)):
        of_foot, of_body = part.members(number, np.eye(trace, inner.shape[1]), inner)
        truncation = truncation + of_foot.T @ member.own.truncation @ of_foot
        if member.measures is not None:
            measured.append(member.measures.on(of_foot))
            if storey.body is not None:
                measured.append(_of_body(storey.body, member.parities, stiff[number], of_body))
    piece = CondensedClass.of(part, reduced_class, ClassMeasures.together(measured) if measured else None)
    return replace(piece, forms=piece.forms | {"truncation": ClassForm.split(truncation, trace)})


def _of_body(body: PillarBody, parities: tuple[Kinds, ...], stiff: Array, fields: Array) -> ClassMeasures:
    """Measures of a body of stiffness ``stiff`` with motions ``fields`` (u, b + m)."""
    heavy = body.mass[:, None] * fields
    vertical = np.tile([0.0, 0.0, 1.0], len(heavy) // 3)[:, None]
    energies = {
        name: fields.T @ moved
        for name, moved in zip(ENERGIES, (stiff @ fields, heavy, vertical * heavy), strict=True)
    }
    momenta = body.momenta(parities) @ fields
    return ClassMeasures(energies, momenta.reshape(-1, fields.shape[1]))


class _Dense:
    """Factorised small stiffness."""

    def __init__(self, stiffness: Array) -> None:
        self._factor = la.cho_factor(stiffness)

    def solve(self, right: Array) -> Array:
        return np.asarray(la.cho_solve(self._factor, right))


@dataclass(frozen=True)
class SubstructuredPart:
    """Lifting of one symmetry class, see `haptonic.superelement.lifting.ClassLifting`.

    static : (u, b), modes : (u, m) values of sections, modes of feet and rests of bodies
    """

    feet: tuple[FootClass, ...]
    storeys: tuple[Storey, ...]
    numbers: _Numbers
    static: Array
    modes: Array

    @property
    def trace(self) -> FoldedTrace:
        return self.feet[0].trace

    @property
    def count(self) -> int:
        return int(self.modes.shape[1])

    @cached_property
    def surplus(self) -> Array:
        trace, inner = len(self.trace.kept), np.hstack([self.static, self.modes])
        surplus = np.zeros((len(FORMS), *(inner.shape[1],) * 2))
        for number, foot in enumerate(self.feet):
            of_foot, _ = self.members(number, np.eye(trace, inner.shape[1]), inner)
            surplus += of_foot.T @ foot.surplus @ of_foot
        return surplus

    def members(self, number: int, trace: Fields, inner: Fields) -> tuple[Fields, Fields]:
        """Boundary and modes of a foot, and unknowns of the body on it, from those of the class."""
        of_foot = inner[self.numbers.feet[number]]
        return np.vstack([trace, of_foot]) if number == 0 else of_foot, inner[self.numbers.bodies[number]]

    def lifted(self, trace: Fields, amplitudes: Fields) -> Fields:
        of_class = self.trace.fold(trace)
        inner = self.static @ of_class + self.modes @ amplitudes
        return np.concatenate([
            storey.lifted(foot, *self.members(number, of_class, inner))
            for number, (foot, storey) in enumerate(zip(self.feet, self.storeys, strict=True))
        ])  # fmt: skip
