"""Gauss-Lobatto-Legendre points against exact integrals and polynomials."""

from math import factorial

import numpy as np
import pytest
from hypothesis import given, strategies as st
from scipy.special import roots_jacobi

from each import each
from haptonic.cell.quadrature import interpolation, lobatto

ORDERS = range(1, 17)
orders = st.integers(1, 16)
coefficients = st.lists(st.floats(-1, 1), min_size=17, max_size=17)


@each("order", ORDERS)
def test_inner_points_are_those_of_jacobi_polynomials(order):
    points, _, _ = lobatto(order)
    assert points[[0, -1]].tolist() == [-1.0, 1.0]
    inner = roots_jacobi(order - 1, 1, 1)[0] if order > 1 else []  # P_n' is a Jacobi polynomial
    assert points[1:-1] == pytest.approx(inner, abs=1e-14)
    assert (np.diff(points) > 0).all()


@each("order", ORDERS)
def test_weights_are_exact_up_to_degree_2_order_less_1(order):
    points, weights, _ = lobatto(order)
    for degree in range(2 * order):
        exact = (1 - (-1) ** (degree + 1)) / (degree + 1)
        assert weights @ points**degree == pytest.approx(exact, abs=1e-14)


@pytest.mark.parametrize("order", range(1, 9))
def test_the_first_degree_that_is_missed_has_the_textbook_error(order):
    points, weights, _ = lobatto(order)
    missed = weights @ points ** (2 * order) - 2 / (2 * order + 1)
    n = order + 1  # remainder of the n-point rule for x^(2n-2), e.g. Abramowitz and Stegun 25.4.32
    remainder = n * (n - 1) ** 3 * 2 ** (2 * n - 1) * factorial(n - 2) ** 4
    remainder /= (2 * n - 1) * factorial(2 * n - 2) ** 3 / factorial(2 * n - 2)
    assert missed == pytest.approx(remainder, rel=1e-6)


@given(orders, coefficients)
def test_derivative_is_exact_on_polynomials(order, coefficient):
    points, _, derivative = lobatto(order)
    polynomial = np.polynomial.Polynomial(coefficient[: order + 1])
    assert derivative @ polynomial(points) == pytest.approx(polynomial.deriv()(points), abs=1e-10)


@given(orders, coefficients, st.lists(st.floats(-1, 1), min_size=1, max_size=8))
def test_interpolation_is_exact_on_polynomials(order, coefficient, targets):
    points, _, _ = lobatto(order)
    targets = np.array([*targets, points[0], points[order // 2], points[-1] - 1e-13])
    polynomial = np.polynomial.Polynomial(coefficient[: order + 1])
    assert interpolation(points, targets) @ polynomial(points) == pytest.approx(
        polynomial(targets), abs=1e-11
    )


@given(orders)
def test_interpolation_returns_the_nodes_themselves(order):
    points, _, _ = lobatto(order)
    assert np.array_equal(interpolation(points, points), np.eye(order + 1))


def test_the_shared_arrays_cannot_be_changed_by_a_caller():
    for array in lobatto(3):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0.0
