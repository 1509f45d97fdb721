"""How well data tell parameters: confidence intervals, also where errors of neighbouring data are alike.

With residuals e and a Jacobian J, independent errors give the covariance ``s^2 (J^T J)^-1``. Whether errors
are independent shows in the singular values of the residuals as a matrix of lines and points: those of
independent ones end at a known edge (Marchenko and Pastur). Errors of a model, or of a reference channel, are
alike at many points and lines. Then scores, the products of Jacobian and residuals summed over the points of
a line, tell by how much they add up (the sandwich estimate of regression), and only as many count as there
are lines that matter.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy

from haptonic.arrays import Array, Complex

QUANTILE = 0.975  # on either side of a 95 % interval
EDGE = 1.1  # of the largest singular value of independent errors, beyond which they are not independent
ALIKE = 0.2  # correlation of scores some lines apart above which they count together
FEWEST = 2.0  # degrees of freedom at least
SINGULAR = 1e-7  # share of the largest singular value, below which a direction changes nothing
PART = 0.1  # of a parameter in such a direction, above which it is not told
TOLD = 0.95  # correlation of two estimates above which only their combination is told
TINY = np.finfo(float).tiny


@dataclass(frozen=True, eq=False)
class Uncertainty:
    """What data tell of parameters.

    half : (p,) half widths of 95 % intervals; infinite where the data tell nothing
    correlation : (p, p) of the estimates
    independent : whether the residuals look independent
    data : real numbers fitted; effective : independent ones that would give intervals as wide
    """

    half: Array
    correlation: Array
    independent: bool
    data: int
    effective: float

    def tied(self, number: int) -> list[int]:
        """Other parameters of which only a combination with this one is told."""
        row = np.abs(self.correlation[number])
        return [k for k in range(len(row)) if k != number and row[k] > TOLD]


def uncertainty(jacobian: Complex, residual: Complex) -> Uncertainty:
    """What a fit tells at its minimum.

    Parameters
    ----------
    jacobian : (lines, points, p) slopes of the residuals with the parameters
    residual : (lines, points) weighted so that independent errors have about the same size
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
        lines = 1 / np.maximum((weight**2).sum(axis=0), TINY)  # that matter, for each parameter
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
    """Lines over which scores (lines, p) are alike, each parameter counted alike."""
    unit = scores / np.maximum(np.linalg.norm(scores, axis=0), TINY)
    for lag in range(1, len(unit) // 4):
        if float((unit[lag:] * unit[:-lag]).sum(axis=0).mean()) < ALIKE:
            return lag - 1
    return len(unit) // 4


def _summed(scores: Array, reach: int) -> Array:
    """(p, p) covariance of the sum of scores (lines, p) that are alike over some lines."""
    total = scores.T @ scores
    width = 3 * reach + 1  # weights that fall linearly keep the sum positive, and have to reach far for it
    for lag in range(1, min(width, len(scores))):
        product = scores[lag:].T @ scores[:-lag]
        total = total + (1 - lag / width) * (product + product.T)
    return np.asarray(total)
