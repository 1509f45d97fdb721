"""What the interior adds to the static answers: a Krylov space of K^-1 M with the trace held at zero."""

from __future__ import annotations

import numpy as np
import scipy.linalg as la
from numpy.typing import NDArray

from haptonic.solvers import Solver

Array = NDArray[np.float64]

DEPENDENT = 1e-13  # share of the largest inertia below which a direction repeats others
EXTRA = 3  # random ones beside them, for modes that hardly touch the trace


def interior_modes(
    solver: Solver, mass: Array, inertia: Array, steps: int, block: int
) -> tuple[Array, Array, Array]:
    """Rayleigh-Ritz modes of the interior on a short Krylov space.

    The space starts with what the inertia of the static answers excites most. It therefore holds the
    dynamic answer to the trace to several orders in frequency, which far fewer vectors do than exact
    modes would; all its Ritz modes are kept, converged or not.

    Parameters
    ----------
    solver : has factorised the stiffness K
    mass : (n,) lumped mass M
    inertia : (n, b) M times static answers
    steps : blocks of the space; block : directions that each takes on from the static answers' inertia

    Returns
    -------
    values : (m,) eigenvalues, (rad/s)^2, ascending, never below the exact ones
    modes : (n, m) with unit modal mass
    dynamic : (n, b) K^-1 ``inertia``
    """
    root = np.sqrt(mass)[:, None]
    random = mass[:, None] * np.random.default_rng(0).standard_normal((len(mass), EXTRA))
    answers = solver.solve(np.hstack([inertia, random]))
    dynamic, extra = np.split(answers, [inertia.shape[1]], axis=1)
    scaled = root * dynamic
    _, turn = la.eigh(scaled.T @ scaled)
    new = np.hstack([scaled @ turn[:, -block:], root * extra])
    blocks: list[Array] = []
    answers_to: list[Array] = []
    for _ in range(steps):
        for _ in range(2):  # one pass of Gram and Schmidt is not enough
            for old in blocks:
                new = new - old @ (old.T @ new)
            new = np.asarray(la.qr(new, mode="economic")[0])
        blocks.append(new)
        answers_to.append(solver.solve(root * new))
        new = root * answers_to[-1]
    fields = np.hstack(answers_to)
    moving = root * fields
    # a small interior has not room for all the blocks
    weights, turn = la.eigh(moving.T @ moving)
    kept = weights > DEPENDENT * weights[-1]
    basis = turn[:, kept] / np.sqrt(weights[kept])
    values, turn = la.eigh(basis.T @ (np.hstack(blocks).T @ moving) @ basis)
    return values, fields @ (basis @ turn), dynamic
