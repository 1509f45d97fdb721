"""The same tests for every sparse solver that is installed here."""

import importlib.util
import os
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest
import scipy.sparse as sp
from hypothesis import assume, given, strategies as st

from haptonic import solvers
from haptonic.errors import HaptonicError
from haptonic.solvers import SOLVERS, Pattern, Solver


def installed(name: str):
    module = SOLVERS[name][0]
    missing = module is not None and importlib.util.find_spec(module) is None
    return pytest.param(name, marks=pytest.mark.skipif(missing, reason=f"{module} is not installed"))


every_solver = pytest.mark.parametrize("name", [installed(name) for name in SOLVERS])


def pattern_of(matrix) -> tuple[Pattern, np.ndarray]:
    """Upper triangle, diagonal always present, of a dense symmetric matrix."""
    present = np.triu((matrix != 0) | np.eye(len(matrix), dtype=bool))
    rows, columns = np.nonzero(present)
    starts = np.concatenate([[0], np.cumsum(present.sum(axis=1))])
    return Pattern(starts.astype(np.int32), columns.astype(np.int32)), matrix[rows, columns]


def analysed(name: str, pattern: Pattern) -> Solver:
    return SOLVERS[name][1](pattern)


def symmetric(size, seed, density=0.2):
    rng = np.random.default_rng(seed)
    half = sp.random_array((size, size), density=density, rng=rng, data_sampler=rng.standard_normal)
    return (half + half.T).toarray() + np.diag(rng.standard_normal(size))


def definite(size, seed, density=0.2):
    matrix = symmetric(size, seed, density)
    return matrix + np.diag(1.0 + np.abs(matrix).sum(axis=1))


seeds = st.integers(0, 2**32 - 1)
sizes = st.integers(1, 40)


@every_solver
@given(sizes, seeds, st.integers(1, 7))
def test_solution_of_a_definite_system(name, size, seed, columns):
    matrix = definite(size, seed)
    pattern, data = pattern_of(matrix)
    solver = analysed(name, pattern)
    assert solver.factorise(data) == 0
    right = np.random.default_rng(seed).standard_normal((size, columns))
    given_right = right.copy()
    solution = solver.solve(right)
    assert solution.shape == right.shape
    assert np.abs(matrix @ solution - right).max() < 1e-12 * max(1.0, np.abs(right).max())
    assert np.array_equal(right, given_right)


@every_solver
@given(sizes, seeds)
def test_a_given_order_of_elimination_changes_no_solution_and_no_count(name, size, seed):
    matrix = symmetric(size, seed)
    assume(np.abs(np.linalg.eigvalsh(matrix)).min() > 1e-3)
    pattern, data = pattern_of(matrix)
    order = np.random.default_rng(seed).permutation(size).astype(np.int32)
    solver = analysed(name, replace(pattern, order=order))
    try:
        negative = solver.factorise(data, definite=False)
    except np.linalg.LinAlgError:
        assume(False)
    assert negative == (np.linalg.eigvalsh(matrix) < 0).sum()
    right = np.random.default_rng(seed).standard_normal((size, 3))
    assert np.abs(matrix @ solver.solve(right) - right).max() < 1e-7
    assert np.array_equal(order, np.random.default_rng(seed).permutation(size))


@pytest.mark.parametrize("name", [installed("pardiso")])
def test_pardiso_eliminates_in_the_order_that_is_given(name):
    """An arrow fills in wholly if its head goes first, and not at all if it goes last."""
    size = 60
    arrow = np.diag(np.full(size, 2.0 * size))
    arrow[0] = arrow[:, 0] = 1.0
    arrow[0, 0] = 2.0 * size
    pattern, data = pattern_of(arrow)
    seen = {}
    for head, order in {"first": np.arange(size), "last": np.arange(size)[::-1]}.items():
        solver = analysed(name, replace(pattern, order=order.astype(np.int32)))
        solver._settings[17] = -1  # report the entries of the factor
        solver.factorise(data)
        seen[head] = solver._settings[17]
    assert seen["first"] > 5 * seen["last"]


@every_solver
def test_hundreds_of_right_hand_sides_in_any_memory_order(name):
    matrix = definite(60, 3)
    pattern, data = pattern_of(matrix)
    solver = analysed(name, pattern)
    solver.factorise(data)
    right = np.random.default_rng(4).standard_normal((60, 800))
    exact = np.linalg.solve(matrix, right)
    for layout in (right, np.asfortranarray(right), np.repeat(right, 2, axis=1)[:, ::2]):
        assert np.abs(solver.solve(layout) - exact).max() < 1e-12


@every_solver
def test_new_numbers_on_an_analysed_pattern(name):
    matrix = definite(30, 5)
    pattern, data = pattern_of(matrix)
    solver = analysed(name, pattern)
    right = np.eye(30)
    for factor in (1.0, 3.0, 0.25):
        assert solver.factorise(factor * data) == 0
        assert np.abs(factor * matrix @ solver.solve(right) - right).max() < 1e-12
    values = np.linalg.eigvalsh(matrix)
    middle = 0.5 * (values[9] + values[10])
    shifted = matrix - middle * np.eye(30)
    assert solver.factorise(pattern_of(shifted)[1], definite=False) == 10
    assert np.abs(shifted @ solver.solve(right) - right).max() < 1e-10
    assert solver.factorise(data) == 0  # and back again
    assert np.abs(matrix @ solver.solve(right) - right).max() < 1e-12


@every_solver
@given(sizes, seeds)
def test_inertia_against_dense_eigenvalues(name, size, seed):
    matrix = symmetric(size, seed)
    values = np.linalg.eigvalsh(matrix)
    assume(np.abs(values).min() > 1e-3)
    pattern, data = pattern_of(matrix)
    solver = analysed(name, pattern)
    try:
        negative = solver.factorise(data, definite=False)
    except np.linalg.LinAlgError:
        assert name != "pardiso"  # the others may refuse a pivot, but never count wrongly
        return
    assert negative == (values < 0).sum()
    assert np.abs(matrix @ solver.solve(np.eye(size)) - np.eye(size)).max() < 1e-6


@every_solver
@given(st.integers(2, 40), seeds)
def test_an_indefinite_matrix_is_refused_where_a_definite_one_is_expected(name, size, seed):
    matrix = definite(size, seed, density=1.0)
    matrix[size // 2, size // 2] *= -1.0
    pattern, data = pattern_of(matrix)
    with pytest.raises(np.linalg.LinAlgError):
        analysed(name, pattern).factorise(data)


@every_solver
def test_a_negative_entry_of_a_diagonal_matrix_is_refused(name):
    pattern, data = pattern_of(np.diag([2.0, -3.0, 4.0]))
    solver = analysed(name, pattern)
    with pytest.raises(np.linalg.LinAlgError):
        solver.factorise(data)


@every_solver
def test_a_singular_matrix_is_refused(name):
    matrix = definite(12, 8)
    matrix[5], matrix[:, 5] = 0.0, 0.0
    pattern, data = pattern_of(matrix)
    with pytest.raises(np.linalg.LinAlgError):
        analysed(name, pattern).factorise(data)


@every_solver
def test_a_singular_matrix_is_refused_when_counting(name):
    matrix = definite(12, 8)
    matrix[5], matrix[:, 5] = 0.0, 0.0
    pattern, data = pattern_of(matrix)
    with pytest.raises(np.linalg.LinAlgError):
        analysed(name, pattern).factorise(data, definite=False)


@every_solver
@given(seeds)
def test_numbers_that_are_zero_keep_their_place(name, seed):
    """One analysis serves symmetry classes in which different entries vanish."""
    whole = definite(15, seed, density=0.4)
    pattern, data = pattern_of(whole)
    rows = np.repeat(np.arange(15), np.diff(pattern.indptr))
    lost = (np.random.default_rng(seed).random(len(data)) < 0.5) & (rows != pattern.indices)
    solver = analysed(name, pattern)
    right = np.eye(15)
    for numbers in (np.where(lost, 0.0, data), data, np.where(lost, 0.0, data)):
        solver.factorise(numbers)
        assert pattern.matrix(numbers) @ solver.solve(right) == pytest.approx(right, abs=1e-10)


def test_the_pattern_gives_back_the_whole_matrix():
    matrix = symmetric(20, 1)
    pattern, data = pattern_of(matrix)
    assert pattern.size == 20
    assert np.array_equal(pattern.matrix(data).toarray(), matrix)


def test_the_best_installed_solver_is_chosen(monkeypatch):
    monkeypatch.delenv("HAPTONIC_SOLVER", raising=False)
    order = [name for name in SOLVERS if name in solvers.available()]
    assert solvers.available() == order
    assert order[-1] == "superlu"
    assert solvers.chosen() is SOLVERS[order[0]][1]
    monkeypatch.setattr(importlib.util, "find_spec", lambda module: None)
    assert solvers.available() == ["superlu"]
    assert solvers.chosen() is SOLVERS["superlu"][1]


def test_the_environment_overrides_the_choice(monkeypatch):
    for name in solvers.available():
        monkeypatch.setenv("HAPTONIC_SOLVER", name)
        assert solvers.chosen() is SOLVERS[name][1]
    monkeypatch.setenv("HAPTONIC_SOLVER", "")
    assert solvers.chosen() is SOLVERS[solvers.available()[0]][1]


def test_an_unknown_solver_is_refused_with_the_ones_there_are(monkeypatch):
    monkeypatch.setenv("HAPTONIC_SOLVER", "mumps")
    with pytest.raises(HaptonicError) as caught:
        solvers.chosen()
    assert caught.value.argument == "HAPTONIC_SOLVER"
    assert caught.value.given == "'mumps'"
    assert caught.value.allowed == "one of " + ", ".join(solvers.available())


def test_a_solver_can_be_left_to_the_end_of_the_process():
    """Freeing the factors while the interpreter ends must not crash it."""
    code = (
        "import numpy as np\nfrom haptonic.solvers import Pattern, chosen\n"
        "keep = chosen()(Pattern(np.array([0, 1], dtype=np.int32), np.array([0], dtype=np.int32)))\n"
        "keep.factorise(np.array([2.0]))\nprint(keep.solve(np.array([[4.0]]))[0, 0])\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, env=os.environ, check=True
    )
    assert float(done.stdout) == pytest.approx(2.0)
    assert done.stderr == ""


@every_solver
def test_an_analysis_for_any_sign_serves_definite_matrices_and_refuses_others(name):
    """In this order only the count of signs shows it: the diagonal of the last one is positive."""
    pattern = Pattern(np.array([0, 2, 3], np.int32), np.array([0, 1, 1], np.int32))
    solver = SOLVERS[name][1](pattern)
    assert solver.factorise(np.array([1.0, 0.5, -1.0]), definite=False) == 1
    assert solver.factorise(np.array([2.0, 1.0, 2.0])) == 0
    assert solver.solve(np.array([[3.0], [3.0]])) == pytest.approx(np.ones((2, 1)))
    with pytest.raises(np.linalg.LinAlgError, match="definite"):
        solver.factorise(np.array([1.0, 2.0, 1.0]))
