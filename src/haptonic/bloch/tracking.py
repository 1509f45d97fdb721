"""Bands along the edge of the zone, followed through crossings by their mode shapes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array, Complex, Fields, Ints
from haptonic.bloch.character import characters
from haptonic.bloch.model import BlochModel, Solution
from haptonic.bloch.pencil import Derived, eigenpairs, hertz
from haptonic.bloch.reduced import SPARE_MODES
from haptonic.bloch.symmetry import (
    WAVES,
    clusters,
    corner_labels,
    mirrors_at,
    sorted_by_parity,
    split_groups,
)
from haptonic.bloch.truncation import REST
from haptonic.brillouin import Path
from haptonic.later import csgraph, sparse as sp
from haptonic.superelement import JointImage

STILL = "not defined for a rigid-body motion"  # the group velocity
VELOCITY_ERROR = "estimate of the length of the error of the group velocity"
ALIKE = 0.2  # squared overlap above which two modes at neighbouring wavevectors may be on one branch


@dataclass(frozen=True)
class Diagram:
    """Dispersion along a path; n wavevectors, k bands sorted by frequency.

    frequency, error : (n, k) Hz
    velocity : (n, k, 2) group velocity, m/s; NaN for rigid-body motions, where it is not defined
    parity : (n, k) +1 even, -1 odd under the mirror of the segment, 0 without a mirror
    middle : (n, k) +1 symmetric, -1 antisymmetric about the plate's middle plane, 0 if that is not a mirror
    corner_symmetry : for each corner of the path the labels of its modes, see `corner_labels`
    branch : (n, k) number of the mode's curve
    vertical, pillar_strain, pillar_kinetic, name : (n, k), see `Character`
    fields : (t + m, n k) unknowns of the tiling, unit mass, the bands of each wavevector together
    """

    path: Path
    frequency: Array
    error: Array
    velocity: Array
    parity: Ints
    middle: Ints
    corner_symmetry: tuple[list[str], ...]
    branch: Ints
    vertical: Array
    pillar_strain: Array
    pillar_kinetic: Array
    name: Ints
    fields: Complex


def solved(model: BlochModel, path: Path) -> list[Solution]:
    """Modes along a path, with spare ones, so that the last band does not divide a degenerate pair."""
    return [model.solve(kappa, spare=SPARE_MODES) for kappa in path.kappa]


def diagram(model: BlochModel, path: Path, solutions: Sequence[Solution] | None = None) -> Diagram:
    """Follow the branches along a path through its modes, by default those of `solved`.

    On every segment a mirror leaves the wavevector unchanged; the middle plane of the plate may be another
    one. Modes of opposite parity cross freely, so only modes of equal parity are joined, those with the
    largest overlap of their fields.
    """
    solutions, tiling = solutions or solved(model, path), model.fine.tiling
    count, bands = len(solutions), model.count
    parity, middle = np.zeros((2, count, bands), dtype=np.int64)
    branch = np.zeros((count, bands), dtype=np.int64)
    velocity = np.empty((count, bands, 2))
    followed: list[Complex] = []
    used = 0
    before: tuple[Complex, tuple[Ints, Ints], Ints] | None = None
    for start, stop in pairwise(path.corners):
        between = 0.5 * (path.kappa[start] + path.kappa[stop])
        operations = list(mirrors_at(model.cell.point_group, between).values())
        mirror = tiling.joint.image(operations[0]) if operations else None
        if before is not None:  # at a corner the modes are sorted again, by the next mirror
            before = (before[0], (np.zeros(bands, dtype=np.int64), before[1][1]), before[2])
        for i in range(start, stop + 1):
            solution, signs = split_by_parity(solutions[i], model, mirror)
            parities = signs, model.fine.parity(solution.modes)
            if before is None:
                branches = np.arange(used, used + bands)
                used += bands
            else:
                branches, used = _joined(before, (solution.fields, parities), tiling.mass, used)
            before = (solution.fields, parities, branches)
            (parity[i], middle[i]), branch[i] = parities, branches
            velocity[i] = group_velocity(model, solution)
            if i < stop or stop == path.corners[-1]:
                followed.append(solution.fields)
    fields = np.hstack(followed)
    eigenvalues = np.concatenate([solution.values[:bands] for solution in solutions])
    motion = characters(tiling, fields, eigenvalues)

    def per_mode(values: NDArray[Any]) -> NDArray[Any]:
        return values.reshape(count, bands)

    return Diagram(
        path=path,
        frequency=np.stack([s.frequency[:bands] for s in solutions]),
        error=np.stack([s.error[:bands] for s in solutions]),
        velocity=velocity,
        parity=parity,
        middle=middle,
        corner_symmetry=tuple(_labels(model, solutions[corner]) for corner in path.corners),
        branch=branch,
        vertical=per_mode(motion.vertical),
        pillar_strain=per_mode(motion.pillar_strain),
        pillar_kinetic=per_mode(motion.pillar_kinetic),
        name=per_mode(motion.name),
        fields=fields,
    )


def group_velocity(model: BlochModel, solution: Solution) -> Array:
    """(k, 2) analytic group velocity d omega / d k, m/s.

    ``d omega / d kappa_j = u* (dK/d kappa_j - omega^2 dM/d kappa_j) u / (2 omega)`` for a mode u of unit mass
    (Hellmann and Feynman); with kappa_j = k . a_j the gradient in k is the sum of a_j times these slopes.
    """
    slopes = model.gradient(solution.kappa, solution.values, solution.modes)
    return np.asarray(2 * np.pi * slopes @ model.cell.lattice.vectors)


def group_velocity_error(model: BlochModel, solution: Solution) -> Array:
    """(k,) estimates of the error of the group velocity of each mode, m/s; NaN for rigid-body motions.

    It follows from the difference to the pencil stiffened by the surplus. The relative error of the frequency
    is added, because both scale with the stiffness. If the errors of frequencies overlap, these modes may be
    mixed in the exact solution, so the range of their velocities is added.
    """
    frequency, error, kappa = solution.frequency, solution.error, solution.source.kappa
    stiffened = model.fine.stiffened
    values, modes = eigenpairs(stiffened, kappa, len(frequency))
    apart = frequency[1:] - error[1:] > frequency[:-1] + error[:-1]
    ends = [0, *(int(end) + 1 for end in np.flatnonzero(apart)), len(frequency)]
    groups = [slice(low, high) for low, high in pairwise(ends)]
    vectors, pencils = model.cell.lattice.vectors, (model.fine.pencil, stiffened)
    fine, lower = (
        _velocities(pencil, kappa, *pairs, groups, vectors)
        for pencil, pairs in zip(pencils, ((solution.values, solution.modes), (values, modes)), strict=True)
    )
    moving = frequency > REST * model.highest
    away, mixed = np.abs(lower - fine), np.zeros_like(fine)
    for group in groups:
        away[group], mixed[group] = away[group].max(axis=0), np.ptp(fine[group], axis=0)

    def with_others(of_modes: Array) -> Array:
        return np.asarray(of_modes + np.sqrt((of_modes[moving] ** 2).mean(axis=0)))

    missing, _, _ = model.fine.losses(solution.modes, kappa)
    remaining = missing[moving].sum() / (values - solution.values)[moving].sum()
    errors = remaining * with_others(away) + mixed
    errors += (error / np.maximum(frequency, REST * model.highest))[:, None] * with_others(np.abs(fine))
    return np.where(moving, np.linalg.norm(errors, axis=1), np.nan)


def _velocities(
    pencil: Derived, kappa: Array, values: Array, modes: Fields, groups: Sequence[slice], vectors: Array
) -> Array:
    """(k, 2) group velocities along x and y, m/s, the extreme ones of all combinations of a group."""
    velocity = np.empty((len(values), 2))
    slopes = pencil.slopes(kappa)
    for group in groups:
        of_group, omega = modes[:, group], 2 * np.pi * hertz(values[group]).mean()
        forms = np.stack([
            of_group.conj().T @ (dK @ of_group - values[group].mean() * (dM @ of_group)) for dK, dM in slopes
        ])  # fmt: skip
        for axis in range(2):
            along = np.tensordot(vectors[:, axis], forms, 1)
            velocity[group, axis] = np.linalg.eigvalsh(along) / max(2 * omega, 1.0)
    return velocity


def split_by_parity(
    solution: Solution, model: BlochModel, mirror: JointImage | None
) -> tuple[Solution, Ints]:
    """Combine degenerate modes to definite parity; return the bands and their parities.

    mirror : image of traces in a reflection that leaves the wavevector unchanged; None without one
    """
    if mirror is None:
        return solution.lowest(model.count), np.zeros(model.count, dtype=np.int64)
    trace = solution.fields[: model.fine.tiling.trace_size]
    turn, values = sorted_by_parity(trace, mirror.applied(trace, solution.kappa), _groups(solution, model))
    parity = np.sign(values[: model.count]).astype(np.int64)
    return solution.turned(turn).lowest(model.count), parity


def _groups(solution: Solution, model: BlochModel) -> list[Ints]:
    """Numbers of degenerate modes, separated by parity about the plate's middle plane."""
    return split_groups(clusters(solution.frequency), model.fine.parity(solution.modes))


def _labels(model: BlochModel, solution: Solution) -> list[str]:
    tiling, kappa = model.fine.tiling, solution.kappa
    trace = solution.fields[: tiling.trace_size]
    operations = mirrors_at(model.cell.point_group, kappa)
    images = {name: tiling.joint.image(op).applied(trace, kappa) for name, op in operations.items()}
    labels = corner_labels(trace, images, _groups(solution, model))
    for number, parity in enumerate(model.fine.parity(solution.modes)):
        labels[number] += f", {WAVES[parity]}" if parity else ""
    resting = solution.frequency < REST * model.highest
    return ["translation" if rest else label for label, rest in zip(labels, resting, strict=True)][
        : model.count
    ]


def _joined(
    before: tuple[Complex, tuple[Ints, Ints], Ints],
    now: tuple[Complex, tuple[Ints, Ints]],
    mass: Array,
    used: int,
) -> tuple[Ints, int]:
    """Branch numbers of the modes from those at the previous wavevector; new numbers without a match."""
    old_fields, old_signs, old_branch = before
    fields, signs = now
    weighed = mass @ fields.real + 1j * (mass @ fields.imag)
    overlap = np.abs(old_fields.conj().T @ weighed) ** 2
    for old, new in zip(old_signs, signs, strict=True):
        overlap[(old[:, None] * new) < 0] = 0.0
    # as scipy.optimize.linear_sum_assignment, whose import takes longer than a diagram; squared overlaps are
    # at most 1, and a cost of zero would be no edge
    rows, columns = csgraph.min_weight_full_bipartite_matching(sp.csr_array(2.0 - overlap))
    branch = np.full(fields.shape[1], -1, dtype=np.int64)
    for row, column in zip(rows, columns, strict=True):
        if overlap[row, column] > ALIKE:
            branch[column] = old_branch[row]
    fresh = np.flatnonzero(branch < 0)
    branch[fresh] = used + np.arange(len(fresh))
    return branch, used + len(fresh)
