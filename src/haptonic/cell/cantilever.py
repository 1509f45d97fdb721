"""The pillar alone, clamped at its foot: where the lattice's local resonances come from."""

from __future__ import annotations

import numpy as np
import scipy.linalg as la
from numpy.typing import NDArray

from haptonic.cell.geometry import Pillar
from haptonic.cell.quadrature import lobatto
from haptonic.materials import IsotropicMaterial

Array = NDArray[np.float64]

ALPHA = np.array([3.516, 22.03, 61.70])  # equation (3) of the paper
POLYNOMIAL = 24  # order along the pillar; the lowest modes are then exact to rounding


def euler_bernoulli(pillar: Pillar, material: IsotropicMaterial) -> Array:
    """(3,) bending frequencies of a slender cantilever, Hz: equation (3) of the paper.

    ``f_n = alpha_n / (8 pi) * d / h^2 * sqrt(E / rho)``
    """
    slenderness = pillar.diameter / pillar.height**2
    speed = np.sqrt(material.youngs_modulus / material.density)
    return np.asarray(ALPHA / (8 * np.pi) * slenderness * speed)


def timoshenko(pillar: Pillar, material: IsotropicMaterial, count: int = 3) -> Array:
    """(count,) bending frequencies with shear and rotary inertia, Hz.

    One spectral element of the Timoshenko cantilever; the shear coefficient of a circle is that of
    Cowper (1966, doi 10.1115/1.3625046): 6 (1 + nu) / (7 + 6 nu).
    """
    E, nu, rho = material.youngs_modulus, material.poisson_ratio, material.density
    area = np.pi * pillar.radius**2
    second_moment = 0.25 * np.pi * pillar.radius**4
    shear = 6 * (1 + nu) / (7 + 6 * nu) * E / (2 * (1 + nu)) * area
    _, weights, derivative = lobatto(POLYNOMIAL)
    w = np.diag(weights * pillar.height / 2)
    D = derivative * 2 / pillar.height
    deflection = np.hstack([D, -np.eye(POLYNOMIAL + 1)])  # shear strain: slope less rotation
    bending = np.hstack([np.zeros_like(D), D])
    K = shear * deflection.T @ w @ deflection + E * second_moment * bending.T @ w @ bending
    M = la.block_diag(rho * area * w, rho * second_moment * w)
    free = np.setdiff1d(np.arange(len(K)), [0, POLYNOMIAL + 1])  # clamped at the foot
    values = la.eigh(K[np.ix_(free, free)], M[np.ix_(free, free)], eigvals_only=True)
    return np.asarray(np.sqrt(values[:count]) / (2 * np.pi))
