"""The Bloch model of one cell: from sizes to frequencies at any wavevector, each with its error."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import scipy.linalg as la
from numpy.typing import NDArray

from haptonic.bloch.pencil import Pencil, Periodic, bloch_pencil, eigenpairs
from haptonic.bloch.resolution import LADDER, Resolution, check_memory, starting_rung
from haptonic.cell import MeshPlan, UnitCell
from haptonic.errors import ResourceError
from haptonic.superelement import Superelement, condense

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

TRAINING_DIVISIONS = (2, 3, 4, 6)  # of the zone's sides, for the wavevectors that span the small basis
SPARE_MODES = 3  # modes beyond those asked for that go into the small basis
LOST_DIRECTION = 1e-13  # smallest share of the snapshots' inertia that still makes a basis vector
PROJECTION_GOAL = 3e-5  # relative error of a frequency that the small basis may add where it is checked
UNSEEN = 3.0  # by how much that error may be larger at wavevectors that were not checked
ERROR_DIVISIONS = 3  # of the zone's sides, for the wavevectors at which a model's errors are judged
REST = 1e-4  # share of the highest frequency below which a mode counts as a rigid-body motion


@dataclass(frozen=True)
class ReducedCell:
    """A condensed cell in a small basis that serves the whole zone.

    superelement : the condensed cell; periodic : its free unknowns
    pencil : on the small basis; basis : (free unknowns, r)
    omission : pencil of the superelement's omission, as a mass
    projection_error : relative error of a frequency that the basis may add, from wavevectors that did not
        go into it
    """

    superelement: Superelement
    periodic: Periodic
    pencil: Pencil
    basis: Array
    projection_error: float

    @classmethod
    def of(cls, cell: UnitCell, plan: MeshPlan, steps: int, count: int, *, measured: bool) -> ReducedCell:
        superelement = condense(cell, plan, steps, measured=measured)
        full = bloch_pencil(superelement)
        corners, triangles = cell.lattice.zone_triangles(2)
        checks = corners[triangles].mean(axis=1)
        exact = [eigenpairs(full, kappa, count)[0] for kappa in checks]
        for divisions in TRAINING_DIVISIONS:
            training, _ = cell.lattice.zone_triangles(divisions)
            fields = [eigenpairs(full, kappa, count + SPARE_MODES)[1] for kappa in training]
            basis = _common_basis(full, fields)
            small = full.projected(basis)
            error = max(
                float(np.max(eigenpairs(small, kappa, count)[0] / values)) / 2 - 0.5
                for kappa, values in zip(checks, exact, strict=True)
            )
            if error < PROJECTION_GOAL:
                break
        # a few checks cannot vouch for less than what was aimed at
        claimed = max(UNSEEN * error, PROJECTION_GOAL)
        return cls(superelement, Periodic.of(superelement), small, basis, projection_error=claimed)

    def expanded(self, modes: Complex, kappa: Array) -> Complex:
        """(t + m, k) unknowns of the superelement from (r, k) modes of the small pencil."""
        return self.periodic.expanded(self.basis @ modes, kappa)


def _common_basis(pencil: Pencil, fields: list[Complex]) -> Array:
    """(n, r) real basis of unit modal mass (at zero phase) that spans all the complex fields."""
    snapshots = np.hstack([part for field in fields for part in (field.real, field.imag)])
    mass = pencil.mass[0]
    inertia, turn = la.eigh(snapshots.T @ mass @ snapshots)
    kept = inertia > LOST_DIRECTION * inertia[-1]
    return np.asarray(snapshots @ (turn[:, kept] / np.sqrt(inertia[kept])))


@dataclass(frozen=True)
class Solution:
    """Modes at one wavevector, lowest first.

    kappa : (2,) phases, rad
    frequency, error : (k,) Hz; the error bounds the distance to the exact frequency of the model
    fields : (t + m, k) unknowns of the superelement, unit mass
    modes : (r, k) the same in the small basis
    """

    kappa: Array
    frequency: Array
    error: Array
    fields: Complex
    modes: Complex

    def turned(self, turn: Complex) -> Solution:
        """The same with new modes = old modes @ turn, (k, k) unitary among degenerate ones."""
        return replace(self, fields=self.fields @ turn, modes=self.modes @ turn)

    def lowest(self, count: int) -> Solution:
        """The first ``count`` modes."""
        return Solution(
            self.kappa,
            self.frequency[:count],
            self.error[:count],
            self.fields[:, :count],
            self.modes[:, :count],
        )


@dataclass(frozen=True)
class BlochModel:
    """Frequencies, modes and group velocities of a cell at any wavevector.

    cell, resolution : what it was made from; count : how many bands it was made for
    fine : the model that answers; coarse : one order lower, for the error estimate
    """

    cell: UnitCell
    resolution: Resolution
    count: int
    fine: ReducedCell
    coarse: ReducedCell

    @classmethod
    def of(cls, cell: UnitCell, resolution: Resolution, count: int, *, measured: bool = True) -> BlochModel:
        plan = resolution.plan(cell)
        return cls(
            cell,
            resolution,
            count,
            fine=ReducedCell.of(cell, plan, resolution.steps, count, measured=measured),
            coarse=ReducedCell.of(
                cell, plan.with_order(plan.order - 1), resolution.steps, count, measured=False
            ),
        )

    def solve(self, kappa: Array, spare: int = 0) -> Solution:
        """Modes and error estimates at the phases (2,); ``spare`` more than the bands asked for."""
        count = self.count + spare
        values, modes = eigenpairs(self.fine.pencil, kappa, count)
        frequency = _hertz(values)
        fields = self.fine.expanded(modes, kappa)
        coarse = _hertz(eigenpairs(self.coarse.pencil, kappa, count)[0])
        trace = fields[: self.fine.superelement.trace_size]
        omitted = 0.5 * values * _form(self.fine.superelement.omission, trace)
        error = self.resolution.remaining(self.cell) * np.abs(coarse - frequency)
        error += frequency * (np.abs(omitted) + self.fine.projection_error)
        return Solution(kappa, frequency, error, fields, modes)

    @cached_property
    def highest(self) -> float:
        """Frequency of the last band at rest phase, Hz: the yardstick for what is at rest."""
        return float(_hertz(eigenpairs(self.fine.pencil, np.zeros(2), self.count)[0])[-1])

    def gradient(self, kappa: Array, modes: Complex) -> Array:
        """(k, 2) exact derivatives of the frequencies with respect to the phases, Hz/rad.

        ``modes`` are those of the small pencil at ``kappa``, of unit mass; degenerate ones must have been
        turned so that the derivative is diagonal among them. At zero frequency it is not defined: NaN.
        """
        K, _ = self.fine.pencil.at(kappa)
        values = _form(K, modes)
        frequency = _hertz(values)
        slopes = np.empty((len(values), 2))
        for direction in range(2):
            dK, dM = self.fine.pencil.slope(kappa, direction)
            slopes[:, direction] = _form(dK, modes) - values * _form(dM, modes)
        moving = frequency > REST * self.highest
        slopes[~moving] = np.nan
        slopes[moving] /= 8 * np.pi**2 * frequency[moving, None]
        return slopes


def _form(matrix: Array | Complex, fields: Complex) -> Array:
    """(k,) values of a Hermitian form on fields (n, k)."""
    return np.asarray(np.einsum("ik,ik->k", fields.conj(), matrix @ fields).real)


def _hertz(values: Array) -> Array:
    """Frequencies, Hz, from eigenvalues omega^2 that rounding may have left slightly negative."""
    return np.sqrt(np.maximum(values, 0.0)) / (2 * np.pi)


def candidate_models(
    cell: UnitCell, count: int, accuracy: float, resolution: Resolution | None, *, measured: bool
) -> Iterator[BlochModel]:
    """Models of rising cost, from the first that may be accurate enough; the user takes the first that is.

    Parameters
    ----------
    count : bands; accuracy : relative error allowed for a frequency
    resolution : the only one to try, whatever the accuracy
    measured : whether the characters of modes will be asked for

    Raises
    ------
    ResourceError : the memory does not suffice, or all rungs of the ladder were refused
    """
    if resolution is not None:
        check_memory(cell, resolution, accuracy)
        yield BlochModel.of(cell, resolution, count, measured=measured)
        return
    for rung in LADDER[starting_rung(accuracy) :]:
        check_memory(cell, rung, accuracy)
        yield BlochModel.of(cell, rung, count, measured=measured)
    raise ResourceError(
        argument="bands.accuracy",
        given=f"{accuracy:g}",
        allowed="what the finest mesh reaches for this cell",
        cause="its own error estimates stay larger",
        next_step="ask for less accuracy",
    )


def bloch_model(
    cell: UnitCell, count: int, accuracy: float, resolution: Resolution | None = None
) -> BlochModel:
    """The cheapest model whose error estimates stay within an accuracy all over the zone.

    Parameters and errors as in `candidate_models`.
    """
    models = candidate_models(cell, count, accuracy, resolution, measured=True)
    return next(m for m in models if resolution is not None or worst_error(m) <= accuracy)


def worst_error(model: BlochModel) -> float:
    """Largest relative error estimate over a coarse sampling of the irreducible zone, rest left out."""
    wavevectors, _ = model.cell.lattice.zone_triangles(ERROR_DIVISIONS)
    worst = 0.0
    for kappa in wavevectors:
        solution = model.solve(kappa)
        moving = solution.frequency > REST * model.highest
        worst = max(worst, float((solution.error[moving] / solution.frequency[moving]).max()))
    return worst
