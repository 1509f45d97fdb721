"""Intervals against the scatter of many fits of a linear model with errors of several kinds."""

from functools import cache

import numpy as np
import pytest
from scipy.stats import binom

from haptonic.updating.intervals import uncertainty

LINES, POINTS, COUNT, SEEDS = 150, 20, 2, 150


@cache
def slopes():
    """(lines, points, 2) like those of resonances, each with a shape of its own."""
    chance = np.random.default_rng(3)
    lines = np.arange(LINES)
    total = np.zeros((LINES, POINTS, COUNT), complex)
    for k in range(COUNT):
        for place in chance.uniform(10, LINES - 10, 5):
            total[..., k] += chance.standard_normal(POINTS) / (((lines - place) / 2)[:, None] + 1j) ** 2
    return total


def correlated(chance, count, share):
    """(count, count) what makes independent numbers alike at neighbouring places."""
    apart = np.abs(np.subtract.outer(np.arange(count), np.arange(count)))
    return np.linalg.cholesky(share**apart)


def errors(kind, seed):
    chance = np.random.default_rng(seed)

    def drawn(*shape):
        return chance.standard_normal(shape) + 1j * chance.standard_normal(shape)

    noise = drawn(LINES, POINTS)
    if kind == "alike along lines":
        return correlated(chance, LINES, 0.8) @ noise
    if kind == "alike among points":
        return noise @ correlated(chance, POINTS, 0.9).T
    if kind == "of the reference":
        response = slopes()[..., 0]
        return 0.3 * noise + 10 * response / np.abs(response).max() * drawn(LINES, 1)
    return noise


def solved(error):
    """Estimates whose truth is zero, and their uncertainty."""
    J = slopes().reshape(-1, COUNT)
    both = np.vstack([J.real, J.imag])
    x = np.linalg.lstsq(both, np.concatenate([error.real.ravel(), error.imag.ravel()]), rcond=None)[0]
    return x, uncertainty(slopes(), (J @ x).reshape(error.shape) - error)


@pytest.mark.parametrize(
    ("kind", "widest"),
    [
        ("independent", 1.1),
        ("alike along lines", 2.5),
        ("alike among points", 1.4),
        ("of the reference", 4.5),
    ],
)
def test_intervals_contain_the_truth_and_follow_the_scatter(kind, widest):
    """Of 150 intervals 95 % should hold zero; fewer than the bound come by chance once in a thousand.

    Where errors are alike, intervals may be wider than they need to be.
    """
    estimates, halves = [], []
    for seed in range(SEEDS):
        x, estimate = solved(errors(kind, seed))
        assert estimate.independent == (kind == "independent")
        estimates.append(x)
        halves.append(estimate.half)
    hits = (np.abs(estimates) <= halves).sum(axis=0)
    assert (hits >= binom.ppf(1e-3, SEEDS, 0.95)).all(), hits
    scatter = 1.96 * np.std(estimates, axis=0)
    ratio = np.median(halves, axis=0) / scatter
    assert (ratio > 0.8).all(), ratio
    assert (ratio < widest).all(), ratio


def test_errors_that_are_alike_count_less():
    effective = {kind: solved(errors(kind, 0))[1].effective for kind in ("independent", "of the reference")}
    assert effective["independent"] == 2 * LINES * POINTS
    assert effective["of the reference"] < 0.1 * effective["independent"]


def test_a_parameter_without_effect_is_not_determined():
    error = errors("independent", 0)
    unmoved = np.concatenate([slopes(), np.zeros((LINES, POINTS, 1))], axis=-1)
    estimate = uncertainty(unmoved, error)
    assert np.isinf(estimate.half).tolist() == [False, False, True]
    assert estimate.half[:2] == pytest.approx(uncertainty(slopes(), error).half, rel=1e-3)


def test_two_parameters_with_the_same_effect_are_not_determined():
    twice = np.concatenate([slopes(), 2 * slopes()[..., :1]], axis=-1)
    estimate = uncertainty(twice, errors("independent", 0))
    assert np.isinf(estimate.half).tolist() == [True, False, True]
    near = twice + 1e-4 * errors("independent", 1)[..., None] * np.array([0, 0, 1.0])
    estimate = uncertainty(near, errors("independent", 0))
    assert estimate.tied(0) == [2]
    assert estimate.tied(2) == [0]
    assert estimate.tied(1) == []


def test_units_of_a_parameter_do_not_matter():
    error = errors("of the reference", 5)
    scale = np.array([1e-9, 1e6])
    assert uncertainty(slopes() * scale, error).half * scale == pytest.approx(
        uncertainty(slopes(), error).half, rel=1e-9
    )
