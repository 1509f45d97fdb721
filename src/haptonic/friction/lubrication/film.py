"""Mean overpressure of the film of air that a vibrating plate squeezes below a fingertip.

The model is a rigid disc of radius R at the mean gap u; the gap is u (1 + e cos tau). The compressible,
isothermal Reynolds equation, with gap H, radius and pressure P made dimensionless and psi = P H, is

    H(tau) / 2  laplacian(psi^2) = sigma  d psi / d tau,     psi = H at the rim,

because H depends on time alone. It is solved for the periodic state by collocation, Fourier in time and even
Chebyshev polynomials along the radius, with Newton's method. As the mean over a period of the right side
vanishes, <H psi^2> is harmonic, hence the same everywhere: 1 + 1.5 e^2. Where the air cannot flow (sigma
large) psi is constant in time, and the mean pressure follows in closed form, `sealed_overpressure`. The
`efficiency` is the ratio of the mean overpressure over the disc to this limit; `write_table` computes it once
and writes ``film.csv``.
"""

from __future__ import annotations

from functools import cache
from importlib.resources import files
from pathlib import Path

import numpy as np
import scipy
from numpy.typing import ArrayLike

from haptonic.arrays import Array

SQUEEZE_NUMBERS = np.geomspace(0.01, 1000.0, 36)  # of the table
EXCURSIONS = np.array([0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.75, 0.8, 0.85, 0.9, 0.925, 0.95])
LARGEST_EXCURSION = float(EXCURSIONS[-1])  # beyond, the plate nearly touches the skin: no longer a film
RADIAL, INSTANTS = 20, 65  # collocation points; errors below 1e-4, see the tests
NEWTON_STEPS, NEWTON_TOLERANCE = 30, 1e-10  # of psi, which is about one
QUADRATURE = 60  # points along the radius, for the small-amplitude theory


def squeeze_number(
    gap: ArrayLike, omega: float, length: ArrayLike, viscosity: ArrayLike, ambient: ArrayLike
) -> Array:
    """12 eta omega R^2 / (p0 u^2): how much faster the plate moves than the air can escape.

    Parameters
    ----------
    gap : mean gap u, m
    omega : rad/s
    length : radius R of the film, m
    viscosity : eta, Pa s
    ambient : p0, Pa
    """
    ratio = np.asarray(length, dtype=float) / np.asarray(gap)
    return np.asarray(12 * omega * np.asarray(viscosity) * ratio**2 / np.asarray(ambient))


def sealed_overpressure(excursion: ArrayLike) -> Array:
    """Mean overpressure of a film that cannot leak, isothermal, over the ambient pressure.

    sqrt((1 + 1.5 e^2) / (1 - e^2)) - 1, e the excursion ratio, amplitude over mean gap.
    """
    square = np.asarray(excursion, dtype=float) ** 2
    return np.asarray(np.expm1(0.5 * (np.log1p(1.5 * square) - np.log1p(-square))))


def efficiency(squeeze: ArrayLike, excursion: ArrayLike) -> Array:
    """Mean overpressure of the leaking film over that of the sealed one, from the table.

    Beyond the ends of the table, the deficit 1 - efficiency falls as 1 / sqrt(sigma), and the efficiency
    falls as sigma^2. The latter is too low for large excursions, where it is negligible anyway.

    Parameters
    ----------
    squeeze : squeeze number, positive
    excursion : 0 to `LARGEST_EXCURSION`; any shape that broadcasts with ``squeeze``
    """
    sigma, e = np.broadcast_arrays(np.asarray(squeeze, dtype=float), np.asarray(excursion, dtype=float))
    assert (sigma > 0).all()
    assert ((e >= 0) & (e <= LARGEST_EXCURSION)).all()
    low, high = SQUEEZE_NUMBERS[[0, -1]]
    inside = np.exp(_table().ev(np.log(np.clip(sigma, low, high)), e**2))
    leaking = 1 - (1 - inside) * np.sqrt(high / np.maximum(sigma, high))
    return np.asarray(leaking * np.minimum(sigma / low, 1.0) ** 2)


def small_amplitude_efficiency(squeeze: float) -> float:
    """Limit of `efficiency` for zero excursion, from the Reynolds equation to second order.

    To first order psi - H turns with f = I0(q r) / I0(q), q^2 = i sigma; the mean pressure of second order is
    5/4 - Re f - |f|^2 / 4, of which 5/4 is the sealed film.
    """
    q = np.sqrt(1j * squeeze)
    nodes, weights = np.polynomial.legendre.leggauss(QUADRATURE)
    radius = np.sqrt(0.5 * (nodes + 1))
    f = scipy.special.ive(0, q * radius) / scipy.special.ive(0, q) * np.exp(-(1 - radius) * q.real)
    pressure = 1.25 - f.real - 0.25 * np.abs(f) ** 2
    return float(weights @ pressure / 2 / 1.25)


def solved(squeeze: float, excursion: float, radial: int = RADIAL, instants: int = INSTANTS) -> Array:
    """Solve for psi = P H of the periodic film.

    Parameters
    ----------
    squeeze : squeeze number, positive
    excursion : above 0 and below 1
    radial, instants : collocation points; an odd number of instants

    Returns
    -------
    (radial, instants) at `radii` and the instants 2 pi j / instants
    """
    laplacian = _laplacian(radial)
    derivative = _time_derivative(instants)
    gap = gaps(excursion, instants)
    inner, rim = laplacian[1:, 1:], laplacian[1:, :1]
    psi = np.full((radial - 1, instants), np.sqrt(1 + 1.5 * excursion**2))
    size = psi.size
    drift = squeeze * np.einsum("ik,ab->iakb", np.eye(radial - 1), derivative)
    for _ in range(NEWTON_STEPS):
        residual = 0.5 * gap * (inner @ psi**2 + rim * gap**2) - squeeze * psi @ derivative.T
        slope = np.einsum("ik,ka,ab->iakb", inner, psi, np.diag(gap)) - drift
        step = np.linalg.solve(slope.reshape(size, size), residual.ravel()).reshape(psi.shape)
        psi -= step
        if np.abs(step).max() < NEWTON_TOLERANCE:
            return np.vstack([gap, psi])
    raise AssertionError(f"no periodic film at sigma = {squeeze}, e = {excursion}")


def solved_efficiency(
    squeeze: float, excursion: float, radial: int = RADIAL, instants: int = INSTANTS
) -> float:
    """`efficiency` computed without the table."""
    if excursion == 0:
        return small_amplitude_efficiency(squeeze)
    psi = solved(squeeze, excursion, radial, instants)
    pressure = (psi / gaps(excursion, instants)).mean(axis=1)
    coefficients = np.linalg.solve(_even_chebyshev(radii(radial), radial), pressure)
    nodes, weights = np.polynomial.legendre.leggauss(radial + 4)
    disc = _even_chebyshev(np.sqrt(0.5 * (nodes + 1)), radial) @ coefficients
    return float((weights @ disc / 2 - 1) / sealed_overpressure(excursion))


def gaps(excursion: float, instants: int) -> Array:
    """(instants,) dimensionless gap over one period."""
    return np.asarray(1 + excursion * np.cos(2 * np.pi * np.arange(instants) / instants))


def radii(radial: int) -> Array:
    """(radial,) radii from the rim at 1 inwards, without the centre."""
    return np.asarray(np.cos(np.pi * np.arange(radial) / (2 * radial - 1)))


def write_table(path: Path) -> None:
    """Solve for every entry of the table (some minutes) and write it."""
    rows = [[solved_efficiency(s, e) for e in EXCURSIONS] for s in SQUEEZE_NUMBERS]
    head = "efficiency of the film: a row for each of SQUEEZE_NUMBERS, a column for each of EXCURSIONS"
    np.savetxt(path, rows, fmt="%.7g", delimiter=",", header=head)


@cache
def _table() -> scipy.interpolate.RectBivariateSpline:
    text = (files(__package__) / "film.csv").read_text("utf-8")
    values = np.loadtxt(text.splitlines(), delimiter=",")
    return scipy.interpolate.RectBivariateSpline(np.log(SQUEEZE_NUMBERS), EXCURSIONS**2, np.log(values))


def _even_chebyshev(radius: Array, terms: int) -> Array:
    """(radius, terms) Chebyshev polynomials of even order, as polynomials in 2 r^2 - 1."""
    return np.asarray(np.polynomial.chebyshev.chebvander(2 * radius**2 - 1, terms - 1))


def _laplacian(radial: int) -> Array:
    """(radial, radial) d^2/dr^2 + (1/r) d/dr on even functions at `radii`.

    It is the differentiation matrix of Chebyshev points on the whole diameter, folded at the centre.
    """
    last = 2 * radial - 1
    x = np.cos(np.pi * np.arange(last + 1) / last)
    sign = (-1.0) ** np.arange(last + 1) * np.r_[2, np.ones(last - 1), 2]
    once = np.outer(sign, 1 / sign) / (x[:, None] - x + np.eye(last + 1))
    once -= np.diag(once.sum(axis=1))
    twice = once @ once

    def folded(matrix: Array) -> Array:
        return np.asarray(matrix[:radial, :radial] + matrix[:radial, : -radial - 1 : -1])

    return folded(twice) + folded(once) / x[:radial, None]


def _time_derivative(instants: int) -> Array:
    """(instants, instants) derivative of a trigonometric polynomial at equidistant instants."""
    assert instants % 2
    apart = np.subtract.outer(np.arange(instants), np.arange(instants))
    half = np.sin(np.pi * apart / instants) + np.eye(instants)
    return np.where(apart == 0, 0.0, 0.5 * (-1.0) ** np.abs(apart) / half)
