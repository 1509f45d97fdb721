"""Reduction of a body to its boundary: static responses, and a Krylov space of K^-1 M inside."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from haptonic.arrays import Array, Fields, Ints
from haptonic.later import linalg as la, sparse as sp
from haptonic.superelement.bounded import Factorised, StaticResponse, orthonormal

# Number of motions of the boundary whose inertia the interior modes must balance, beyond the number of
# directions. With 24 for any number of directions, errors of 25 bands were up to ten times the estimate.
SOFT_TRACES = 4
# Motions per direction of a block from which the blocks start, for any number of blocks: the space of more
# steps then contains that of fewer. With as many as directions in all blocks, a further step removed 5 % of
# an error instead of 40 %.
STARTS_PER_DIRECTION = 2
DEPENDENT = 1e-13  # share of the largest inertia below which a direction depends on others
EXTRA = 3  # random directions in addition, for modes with little motion near the trace
# If there are few modes: all up to this multiple of the highest frequency are used, others by their response
# at these shares of its square.
EXACT, SAMPLED = 1.5, (0.3, 0.55, 0.8, 1.0)
# Share of the energy norm of a response that few modes may miss; errors are its square. Those of bands are
# part of the truncation: of steel in epoxy in aluminium it was 4.1e-4 with modes for 3e-2, 1.7e-4 with 1.5e-2
# and 1.6e-4 with 1e-2, and the pencil had 543, 576 and 612 unknowns.
MISSED, MISSED_BY_BANDS = 1e-2, 1.5e-2


@dataclass(frozen=True)
class CraigBampton:
    """Body reduced to static responses to its boundary and some interior modes (Craig and Bampton).

    static : (n, b), modes : (n, m) fields inside
    stiffness, mass : (b, b) for the static response of the interior
    values : (m,) eigenvalues, (rad/s)^2; to_modes : (b, m) mass between static responses and modes
    truncation : (b + m, b + m) effect of the omitted fields, see `Superelement`
    """

    static: Array
    modes: Array
    stiffness: Array
    mass: Array
    values: Array
    to_modes: Array
    truncation: Array

    def unfolded(self, inside: sp.csr_array, boundary: Array) -> CraigBampton:
        """Express this part in the unknowns of the body that contains it, with other parts at rest.

        inside : (n, n of the part) fields of the body from those of the part
        boundary : (b, b of the part) transpose of the matrix from the body's boundary to the part's
        """
        spread = la.block_diag(boundary, np.eye(len(self.values)))
        return CraigBampton(
            static=inside @ (self.static @ boundary.T),
            modes=inside @ self.modes,
            stiffness=boundary @ self.stiffness @ boundary.T,
            mass=boundary @ self.mass @ boundary.T,
            values=self.values,
            to_modes=boundary @ self.to_modes,
            truncation=spread @ self.truncation @ spread.T,
        )

    @property
    def fields(self) -> Array:
        """(n, b + m) fields of all unknowns of the reduced body."""
        return np.hstack([self.static, self.modes])

    def with_few_modes(self, highest: float, missed: float = MISSED) -> CraigBampton:
        """Reduce the modes to few that suffice up to a frequency, Hz; see `few_modes`.

        ``truncation`` then includes the omitted modes: to first order, like every omitted field, they would
        lower an eigenvalue by the work of the inertia on their static response.
        """
        few = few_modes(self.stiffness, self.mass, self.values, self.to_modes, highest, missed)
        values = np.einsum("mk,m,mk->k", few, self.values, few)
        kept = la.block_diag(np.eye(len(self.mass)), few)
        forces = np.vstack([self.to_modes, few.T])
        of_few = forces @ few
        missing = (forces / self.values) @ forces.T - (of_few / values) @ of_few.T
        return CraigBampton(
            static=self.static,
            modes=self.modes @ few,
            stiffness=self.stiffness,
            mass=self.mass,
            values=values,
            to_modes=self.to_modes @ few,
            truncation=kept.T @ self.truncation @ kept + 0.5 * (missing + missing.T),
        )

    @classmethod
    def together(cls, parts: Sequence[CraigBampton]) -> CraigBampton:
        """Join uncoupled parts of a body, all on the boundary of the body."""
        if len(parts) == 1:
            return parts[0]
        count = len(parts[0].mass)
        corner, sides, modal = (
            [part.truncation[rows, columns] for part in parts]
            for rows, columns in (np.s_[:count, :count], np.s_[:count, count:], np.s_[count:, count:])
        )
        side = np.hstack(sides)
        return cls(
            static=np.sum([part.static for part in parts], axis=0),
            modes=np.hstack([part.modes for part in parts]),
            stiffness=np.sum([part.stiffness for part in parts], axis=0),
            mass=np.sum([part.mass for part in parts], axis=0),
            values=np.concatenate([part.values for part in parts]),
            to_modes=np.hstack([part.to_modes for part in parts]),
            truncation=np.block([[np.sum(corner, axis=0), side], [side.T, la.block_diag(*modal)]]),
        )


def reduced(
    solver: Factorised, response: StaticResponse, steps: int, block: int, starts: Array | None = None
) -> CraigBampton:
    """Reduce a body whose interior stiffness ``solver`` has factorised; see `interior_modes`.

    The modes Phi do not balance the whole inertia F inside. To first order in the remaining force, the
    eigenvalue lambda of a field u of unit mass is too high by the work of that force on its response,

        lambda - lambda_exact = lambda^2 u* Omega u,    Omega = F^T (K_ii^-1 - Phi Lambda^-1 Phi^T) F,

    with ``F = M_ii [T, Phi]``. Only the static responses T to ``starts``
    and to the softest motions of the boundary enter Omega.

    starts : (b, s) motions of the boundary, orthonormal in its mass, from whose responses the Krylov space
        starts; by default, and without columns, the softest
    """
    body, static, stiffness, mass = response.body, response.static, response.stiffness, response.mass
    # a motion b is W (M W)^T b for all orthonormal motions W
    soft = response.softest(SOFT_TRACES + steps * block)
    among = SOFT_TRACES + STARTS_PER_DIRECTION * block
    if starts is not None and starts.shape[1]:
        block = among = starts.shape[1]
        beside = orthonormal(soft - starts @ (starts.T @ (mass @ soft)), mass)
        soft = np.hstack([starts, beside])
    dual = mass @ soft
    force = body.inertia(static @ soft)
    if body.mass_coupling is not None:
        force += body.mass_coupling @ soft
    if isinstance(body.mass, np.ndarray):
        values, modes, dynamic, moved = interior_modes(solver, body.mass, force, steps, block, among)
    else:
        values, modes, dynamic, moved = consistent_modes(solver, body.mass, force, steps, block, among)
    moving = body.inertia(modes)
    to_modes = static.T @ moving
    if body.mass_coupling is not None:
        to_modes += body.mass_coupling.T @ modes
    # work of the inertia of soft motions and modes on its static response, without the share of the modes
    to_all = np.vstack([soft.T @ to_modes, np.eye(len(values))])
    work = np.block([[form.T @ answer for answer in (dynamic, moved)] for form in (force, moving)])
    missing = work - (to_all / values) @ to_all.T
    spread = la.block_diag(dual, np.eye(len(values)))
    truncation = spread @ missing @ spread.T
    truncation = 0.5 * (truncation + truncation.T)
    return CraigBampton(
        static=static,
        modes=modes,
        stiffness=stiffness,
        mass=mass,
        values=values,
        to_modes=to_modes,
        truncation=truncation,
    )


def with_all_modes(stiffness: Array, mass: Array, outer: Ints) -> CraigBampton:
    """Reduce a body (n, n) without loss; ``outer`` are the numbers of the unknowns on its boundary."""
    inner = np.setdiff1d(np.arange(len(mass)), outer)
    inside = np.ix_(inner, inner)
    static, modes = np.zeros((len(mass), len(outer))), np.zeros((len(mass), len(inner)))
    static[outer, np.arange(len(outer))] = 1.0
    static[inner] = -la.cho_solve(la.cho_factor(stiffness[inside]), stiffness[np.ix_(inner, outer)])
    values, modes[inner] = la.eigh(stiffness[inside], mass[inside])
    heavy = mass @ static
    return CraigBampton(
        static=static,
        modes=modes,
        stiffness=static.T @ stiffness @ static,
        mass=static.T @ heavy,
        values=values,
        to_modes=heavy.T @ modes,
        truncation=np.zeros_like(mass),
    )


def consistent_modes(
    solver: Factorised, mass: sp.csr_array, inertia: Array, steps: int, block: int, among: int
) -> tuple[Array, Array, Array, Array]:
    """Compute `interior_modes` for a mass (n, n) that is not diagonal."""
    random = mass @ np.random.default_rng(0).standard_normal((mass.shape[0], EXTRA))
    dynamic, extra = np.split(solver.solve(np.hstack([inertia, random])), [inertia.shape[1]], axis=1)
    starts = dynamic[:, :among]
    _, turn = la.eigh(starts.T @ (mass @ starts))
    new = np.hstack([starts @ turn[:, -block:], extra])
    basis = np.empty((len(new), 0))
    for _ in range(steps):
        for _ in range(2):  # one pass of Gram and Schmidt is not enough
            new = new - basis @ (basis.T @ (mass @ new))
            new = new @ _unit_mass(new.T @ (mass @ new))
        basis = np.hstack([basis, new])
        new = solver.solve(mass @ new)
    forces = mass @ basis
    fields = solver.solve(forces)
    turn = _unit_mass(fields.T @ (mass @ fields))
    values, mixed = la.eigh(turn.T @ (fields.T @ forces) @ turn)
    modes = fields @ (turn @ mixed)
    return values, modes, dynamic, solver.solve(mass @ modes)


def _unit_mass(form: Array) -> Array:
    """(n, k) combinations of n fields whose mass is a form (n, n): orthonormal, without dependent ones."""
    weights, turn = la.eigh(form)
    independent = weights > DEPENDENT * weights[-1]
    return np.asarray(turn[:, independent] / np.sqrt(weights[independent]))


def orthonormal_beside(blocks: Sequence[Fields], new: Fields) -> Fields:
    """(n, k) orthonormal fields that span ``new`` (n, k) without the directions of orthonormal ``blocks``."""
    for _ in range(2):  # one pass of Gram and Schmidt is not enough
        for block in blocks:
            new = new - block @ (block.conj().T @ new)
        new = la.qr(new, mode="economic")[0]
    return new


def interior_modes(
    solver: Factorised, mass: Array, inertia: Array, steps: int, block: int, among: int
) -> tuple[Array, Array, Array, Array]:
    """Compute Rayleigh-Ritz modes of the interior on a short Krylov space.

    The space is ``span(A X, ..., A^steps X)`` with ``A = K^-1 M`` and X the main directions of ``A T``, the
    response to the inertia of the softest static responses T. The dynamic response to the trace is the series
    ``(1 + omega^2 A + omega^4 A^2 + ...) T``. The space approximates it to several orders in frequency with
    far fewer vectors than exact modes. All its Ritz modes are used, converged or not.

    Parameters
    ----------
    solver : solver with the factorised stiffness K
    mass : (n,) diagonal mass M
    inertia : (n, b) M times static responses, in ascending order of stiffness
    steps : number of blocks of the space; block : directions of each
    among : number of the first columns of the inertia among whose responses these directions are

    Returns
    -------
    values : (m,) eigenvalues, (rad/s)^2, ascending, never below the exact ones
    modes : (n, m) with unit modal mass
    dynamic : (n, b) K^-1 ``inertia``; moved : (n, m) K^-1 M ``modes``
    """
    root = np.sqrt(mass)[:, None]
    random = mass[:, None] * np.random.default_rng(0).standard_normal((len(mass), EXTRA))
    answers = solver.solve(np.hstack([inertia, random]))
    dynamic, extra = np.split(answers, [inertia.shape[1]], axis=1)
    starts = root * dynamic[:, :among]
    _, turn = la.eigh(starts.T @ starts)
    new = np.hstack([starts @ turn[:, -block:], root * extra])
    blocks: list[Array] = []
    answers_to: list[Array] = []
    for _ in range(steps):
        new = orthonormal_beside(blocks, new)
        blocks.append(new)
        answers_to.append(solver.solve(root * new))
        new = root * answers_to[-1]
    fields = np.hstack(answers_to)
    answers_to.clear()  # arrays as large as this one are freed where they have served
    moving = root * fields
    form = np.vstack([old.T @ moving for old in blocks])
    blocks.clear()
    # a small interior has fewer unknowns than the blocks have directions
    basis = _unit_mass(moving.T @ moving)
    del moving
    values, turn = la.eigh(basis.T @ form @ basis)
    of_modes = basis @ turn
    modes = fields @ of_modes
    # signs that do not depend on rounding, for later random start vectors in terms of these modes
    sign = np.where(random[:, 0] @ modes < 0, -1.0, 1.0)
    modes *= sign
    # K^-1 M maps the fields of all blocks but the last into the space
    further = fields @ form
    further[:, -new.shape[1] :] = solver.solve(root * new)
    return values, modes, dynamic, further @ (of_modes * sign)


def few_modes(
    stiffness: Array,
    mass: Array,
    values: Array,
    coupling: Array,
    highest: float,
    missed: float,
) -> Array:
    """Compute few modes for the response to a smooth trace up to a highest frequency.

    Modes of the band itself are used as they are. The response of the others, of eigenvalues lambda, to a
    motion u of the trace is, at ``s = omega^2``, ``q = s C^T u / (lambda - s)``, C being their mass coupling
    to the trace. Its main directions are used (proper orthogonal decomposition), the eigenvectors of

        G = sum over s of  g_s g_s^T * (s^2 C^T W^-1 C),    g_s = sqrt(lambda) / (lambda - s),

    where * is entry by entry. The factor sqrt(lambda) measures responses by their strain energy, and
    ``W = K + omega_max^2 M`` of the trace weights motions of equal energy equally.

    Parameters
    ----------
    stiffness, mass : (t, t) of the trace
    values : (m,) eigenvalues of modes of unit mass; coupling : (t, m) their mass coupling to the trace
    highest : Hz; missed : see `MISSED`

    Returns
    -------
    (m, few), orthonormal in mass and orthogonal in stiffness
    """
    top = (2 * np.pi * highest) ** 2
    near = values < EXACT**2 * top
    weights = np.sqrt(values)
    unit_energy = la.cholesky(stiffness + top * mass)
    coupled = la.solve_triangular(unit_energy, coupling, trans=1).T
    gains = np.zeros((len(values), len(values)))  # a frequency only scales rows of the coupling
    for share in SAMPLED:
        gain = share * top * weights / (values - share * top)
        gains += np.outer(gain, gain)
    gram = gains * (coupled @ coupled.T)
    gram[near] = gram[:, near] = 0.0
    sizes, left = la.eigh(gram)
    few = left[:, sizes > missed**2] / weights[:, None]
    basis = np.hstack([np.eye(len(values))[:, near], few])
    _, turn = la.eigh(basis.T @ (values[:, None] * basis), basis.T @ basis)
    return np.asarray(basis @ turn)
