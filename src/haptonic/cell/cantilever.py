"""Pillar alone, clamped at its foot: source of the lattice's local resonances."""

from __future__ import annotations

import numpy as np

from haptonic.arrays import Array
from haptonic.cell.pillar import Pillar
from haptonic.cell.quadrature import lobatto
from haptonic.later import linalg as la
from haptonic.materials import IsotropicMaterial

ALPHA = np.array([3.516, 22.03, 61.70])  # equation (3) of the paper
EQUAL = 1e-9  # relative; a smaller difference of second moments counts as none
POLYNOMIAL = 24  # order along the pillar; the lowest modes are then exact to rounding


def euler_bernoulli(pillar: Pillar, material: IsotropicMaterial) -> Array:
    """(3,) bending frequencies of a slender cantilever, Hz: equation (3) of the paper.

    ``f_n = alpha_n / (8 pi) * d / h^2 * sqrt(E / rho)``
    """
    slenderness = pillar.diameter / pillar.height**2
    speed = np.sqrt(material.youngs_modulus / material.density)
    return np.asarray(ALPHA / (8 * np.pi) * slenderness * speed)


def timoshenko(pillar: Pillar, material: IsotropicMaterial, count: int = 3) -> Array:
    """(count,) bending frequencies with shear and rotary inertia, Hz, without a fillet.

    The beam has one spectral element of the Timoshenko cantilever for each smooth piece of the side. Shear
    coefficients are those of Cowper (1966, doi 10.1115/1.3625046), see `Section.shear_coefficient`. A section
    without a coefficient, or with different second moments about its axes, has NaN, because no formula exists
    for it.
    """
    E, nu, rho = material.youngs_modulus, material.poisson_ratio, material.density
    shear_coefficient = pillar.form.shear_coefficient(nu)
    places, share = pillar.outline.cubature(2)
    area_of_1, (moment, other) = pillar.outline.area, share @ places**2
    if shear_coefficient is None or abs(moment - other) > EQUAL * moment:
        return np.full(count, np.nan)
    points, weights, derivative = lobatto(POLYNOMIAL)
    nodes = POLYNOMIAL * len(pillar.stages) + 1
    K, M = np.zeros((2, nodes, 2, nodes)), np.zeros((2, nodes, 2, nodes))
    for stage, (low, high, _) in enumerate(pillar.stages):
        along = low + 0.5 * (1 + points) * (high - low)
        width = np.array([pillar.half_width(z, stage) for z in along])
        area, second_moment = area_of_1 * width**2, moment * width**4
        w = weights * (high - low) / 2
        D = derivative * 2 / (high - low)
        shear = shear_coefficient * E / (2 * (1 + nu)) * area
        deflection = np.hstack([D, -np.eye(POLYNOMIAL + 1)])  # shear strain: slope less rotation
        bending = np.hstack([np.zeros_like(D), D])
        stage_stiffness = (
            deflection.T @ np.diag(w * shear) @ deflection
            + bending.T @ np.diag(w * E * second_moment) @ bending
        )
        here = slice(stage * POLYNOMIAL, (stage + 1) * POLYNOMIAL + 1)
        K[:, here, :, here] += stage_stiffness.reshape(2, POLYNOMIAL + 1, 2, POLYNOMIAL + 1)
        inertia = np.stack([rho * area * w, rho * second_moment * w])
        M[:, here, :, here] += np.einsum("cn,cd,nm->cndm", inertia, np.eye(2), np.eye(POLYNOMIAL + 1))
    free = np.setdiff1d(np.arange(2 * nodes), [0, nodes])  # clamped at the foot
    K, M = (A.reshape(2 * nodes, -1)[np.ix_(free, free)] for A in (K, M))
    values = la.eigh(K, M, eigvals_only=True)
    return np.asarray(np.sqrt(values[:count]) / (2 * np.pi))
