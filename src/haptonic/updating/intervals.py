"""Confidence intervals of fitted parameters, also if errors of neighbouring data are correlated.

With residuals e and a Jacobian J, independent errors give the covariance ``s^2 (J^T J)^-1``. The singular
values of the residuals as a matrix of lines and points show whether errors are independent: those of
independent errors end at a known edge (Marchenko and Pastur). Errors of a model, or of a reference channel,
are correlated over many points and lines. Then the scores, products of Jacobian and residuals summed over the
points of a line, give their sum (the sandwich estimate of regression), and the degrees of freedom are the
number of lines that matter.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy

from haptonic.arrays import Array, Complex

QUANTILE = 0.975  # on either side of a 95 % interval
EDGE = 1.1  # times the largest singular value of independent errors; above it, errors are correlated
ALIKE = 0.2  # correlation of scores some lines apart, above which these lines count as one
FEWEST = 2.0  # degrees of freedom at least
SINGULAR = 1e-7  # of the largest singular value: in directions below it, the residuals do not change
PART = 0.1  # largest part of such a direction in a determined parameter
TIED = 0.95  # correlation of two estimates above which only their combination is determined
TINY = np.finfo(float).tiny


@dataclass(frozen=True, eq=False)
class Uncertainty:
    """Uncertainty of fitted parameters.

    half : (p,) half widths of 95 % intervals; infinite for undetermined parameters
    correlation : (p, p) of the estimates
    independent : True if the residuals look independent
    data : number of fitted real numbers
    effective : number of independent data that would give equally wide intervals
    """

    half: Array
    correlation: Array
    independent: bool
    data: int
    effective: float

    def tied(self, number: int) -> list[int]:
        """Other parameters that are determined only in combination with this one."""
        row = np.abs(self.correlation[number])
        return [k for k in range(len(row)) if k != number and row[k] > TIED]


def uncertainty(jacobian: Complex, residual: Complex) -> Uncertainty:
    """Uncertainty of the parameters at the minimum of a fit.

    Parameters
    ----------
    jacobian : (lines, points, p) derivatives of the residuals by the parameters
    residual : (lines, points) weighted so that independent errors have about equal sizes
    """
    count = jacobian.shape[2]
    scale = np.maximum(np.linalg.norm(jacobian.reshape(-1, count), axis=0), TINY)
    unit = jacobian / scale
    flat = unit.reshape(-1, count)
    values, turn = np.linalg.eigh((flat.conj().T @ flat).real)
    lost = values < SINGULAR**2 * values[-1]
    inverse = (turn[:, ~lost] / values[~lost]) @ turn[:, ~lost].T
    data = 2 * residual.size
    spread = float((np.abs(residual) ** 2).sum()) / max(data - count, 1)  # of a real or imaginary part
    plain = scipy.stats.norm.ppf(QUANTILE) * np.sqrt(spread * np.diag(inverse))
    half, independent = plain, _independent(residual)
    if not independent:
        scores = np.einsum("lpk,lp->lk", unit.conj(), residual).real
        weight = (np.abs(unit) ** 2).sum(axis=1)
        lines = 1 / np.maximum((weight**2).sum(axis=0), TINY)  # number of lines that matter, by parameter
        reach = _reach(scores)
        freedom = np.maximum(lines / (reach + 1) - count, FEWEST)
        variance = np.diag(inverse @ _summed(scores, reach) @ inverse) * (1 + count / freedom)
        half = np.maximum(plain, scipy.stats.t.ppf(QUANTILE, freedom) * np.sqrt(variance))
    size = np.sqrt(np.maximum(np.diag(inverse), TINY))
    effective = data * float(((plain / np.maximum(half, TINY)) ** 2)[plain > 0].min(initial=1.0))
    half = half / scale
    half[(np.abs(turn[:, lost]) > PART).any(axis=1)] = np.inf
    return Uncertainty(
        half=half,
        correlation=inverse / np.outer(size, size),
        independent=independent,
        data=data,
        effective=effective,
    )


def _independent(residual: Complex) -> bool:
    lines, points = residual.shape
    edge = (np.sqrt(lines) + np.sqrt(points)) * np.sqrt((np.abs(residual) ** 2).mean())
    return bool(np.linalg.norm(residual, 2) <= EDGE * edge)


def _reach(scores: Array) -> int:
    """Number of lines over which scores (lines, p) are correlated, with equal weight of the parameters."""
    unit = scores / np.maximum(np.linalg.norm(scores, axis=0), TINY)
    for lag in range(1, len(unit) // 4):
        if float((unit[lag:] * unit[:-lag]).sum(axis=0).mean()) < ALIKE:
            return lag - 1
    return len(unit) // 4


def _summed(scores: Array, reach: int) -> Array:
    """(p, p) covariance of the sum of scores (lines, p) that are correlated over some lines."""
    total = scores.T @ scores
    width = 3 * reach + 1  # linear weights keep the sum positive, and need a wide window
    for lag in range(1, min(width, len(scores))):
        product = scores[lag:].T @ scores[:-lag]
        total = total + (1 - lag / width) * (product + product.T)
    return np.asarray(total)
