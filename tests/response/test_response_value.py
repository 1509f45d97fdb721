"""The frequency response as a value: what it holds, its parts, conversions, grid, and what it refuses."""

import json
from importlib.metadata import version

import numpy as np
import pytest
from hypothesis import given, strategies as st
from waves import LINES, X, Y, numbers, response_of_waves

from each import each
from five_parts import refusing
from haptonic.errors import ResponseError


def test_it_lists_its_content():
    response = response_of_waves(coherence=np.full((6, 20), 0.5))
    data = response.dataset
    assert data["response"].dims == ("frequency", "point", "direction")
    assert data["coherence"].dims == ("frequency", "point")
    assert (response.units, data["frequency"].units, data["x"].units, data["y"].units) == (
        "m/s/V", "Hz", "m", "m"
    )  # fmt: skip
    assert data.attrs["quantity"] == "velocity"
    assert data.attrs["reference"] == "A1, V"
    assert data.attrs["origin"] == "simulated"
    assert json.loads(data.attrs["inputs"]) == {"plate": {"loss_factor": 0.002}}
    assert data.attrs["haptonic_version"] == version("haptonic")
    assert response.regions == ("WG1", "WG2")
    assert list(data["direction"].values) == ["z"]


@pytest.mark.parametrize(
    ("quantity", "reference", "units"),
    [("velocity", "F1, N", "m/s/N"), ("displacement", "A1, V", "m/V"), ("velocity", "", "m/s")],
)
def test_units_follow_quantity_and_reference(quantity, reference, units):
    assert response_of_waves(quantity=quantity, reference=reference).units == units


def test_arrays_are_neither_copied_nor_open_to_changes():
    values = numbers((6, 20, 1))
    response = response_of_waves(response=values)
    assert np.shares_memory(response.values, values)
    for part in (response, response.at(40e3), response.of_region("WG1"), response.displacement()):
        for name in ("response", "x"):
            with pytest.raises(ValueError, match="read-only"):
                part.dataset[name].values[0] = 0
    values[0] = 0  # the caller's own array is not locked


class TestLines:
    @pytest.mark.parametrize(("asked", "line"), [(0, 0), (9.9e3, 0), (10.1e3, 1), (59e3, 3), (100e3, 5)])
    def test_the_nearest_line(self, asked, line):
        part = response_of_waves().at(asked)
        assert part.frequency == pytest.approx([LINES[line]])
        assert np.array_equal(part.values, response_of_waves().values[line : line + 1])

    @pytest.mark.parametrize("asked", [-1.0, 100.1e3, np.nan])
    def test_nothing_outside_of_the_range(self, asked):
        with refusing(ResponseError, "out-of-range", "frequency"):
            response_of_waves().at(asked)

    def test_between_includes_both_ends(self):
        part = response_of_waves().between(20e3, 60e3)
        assert part.frequency == pytest.approx([20e3, 40e3, 60e3])
        assert np.array_equal(part.values, response_of_waves().values[1:4])
        assert response_of_waves().between(40e3, 40e3).frequency == pytest.approx([40e3])

    def test_between_survives_rounding_of_its_ends(self):
        """A line at 0.1 + 0.2 is asked for as 0.3, and the other way round."""
        lines = np.array([0.1, 0.1 + 0.2, 0.7])
        assert len(response_of_waves(frequency=lines).between(0.1, 0.3).frequency) == 2
        assert len(response_of_waves(frequency=lines).between(np.nextafter(0.1, 1), 0.7).frequency) == 3

    @pytest.mark.parametrize("limits", [(41e3, 59e3), (60e3, 20e3), (101e3, 200e3), (np.nan, 60e3)])
    def test_between_refuses_to_be_empty(self, limits):
        with refusing(ResponseError, "no-answer", "between"):
            response_of_waves().between(*limits)


class TestRegions:
    def test_the_points_of_a_region(self):
        response = response_of_waves(coherence=np.linspace(0, 1, 120).reshape(6, 20))
        part = response.of_region("WG1")
        assert part.dataset["x"].values == pytest.approx(np.zeros(4))
        assert part.dataset["y"].values == pytest.approx(Y)
        assert np.array_equal(part.values, response.values[:, ::5])
        assert np.array_equal(part.dataset["coherence"], response.dataset["coherence"][:, ::5])

    def test_a_misspelt_region_is_guessed(self):
        with refusing(ResponseError, "unknown", "region", 'write "WG1"'):
            response_of_waves().of_region("WG 1")

    @pytest.mark.parametrize("name", ["", "WG1"])
    def test_no_regions(self, name):
        with refusing(ResponseError, "unknown", "region"):
            response_of_waves(region=None).of_region(name)


class TestConversion:
    def test_velocity_is_i_omega_times_displacement(self):
        """u = sin(omega t), the real part of -i exp(i omega t), moves with omega cos(omega t)."""
        frequency = np.array([1.0, 50e3])
        still = np.full((2, 20, 1), -1j)
        moved = response_of_waves(response=still, frequency=frequency, quantity="displacement").velocity()
        assert moved.values[:, 0, 0] == pytest.approx(2 * np.pi * frequency)
        assert moved.units == "m/s/V"
        assert moved.dataset.attrs["quantity"] == "velocity"
        assert "velocity" in moved.dataset["response"].attrs["long_name"]

    @pytest.mark.parametrize("precision", [np.complex64, np.complex128])
    def test_there_and_back(self, precision):
        response = response_of_waves(response=numbers((6, 20, 1), precision=precision))
        there = response.displacement()
        assert there.units == "m/V"
        assert there.values.dtype == precision
        assert there.frequency == pytest.approx(LINES[1:]), "none at 0 Hz"
        back = there.velocity()
        assert back.values.dtype == precision
        np.testing.assert_allclose(back.values, response.values[1:], rtol=10 * np.finfo(precision).eps)

    def test_what_is_so_already_stays(self):
        response = response_of_waves()
        assert response.velocity() is response
        there = response.displacement()
        assert there.displacement() is there

    def test_a_response_at_0_hz_alone_has_no_displacement(self):
        with refusing(ResponseError, "malformed", "response.frequency"):
            response_of_waves().at(0).displacement()


class TestGrid:
    def test_points_are_where_they_belong(self):
        response = response_of_waves()
        grid = response.grid()
        assert grid.dims == ("frequency", "direction", "y", "x")
        assert grid["x"].values == pytest.approx(X)
        assert grid["y"].values == pytest.approx(Y)
        for number, (x, y) in enumerate(response.points):
            there = grid.sel(x=x, y=y, method="nearest", direction="z")
            assert np.array_equal(there, response.values[:, number, 0])
        assert grid.attrs["units"] == "m/s/V"

    @given(st.data())
    def test_holes_shuffles_and_small_errors_of_position(self, data):
        """Every point is found again, whatever is missing and in whatever order; rows 0 and 1 stay."""
        x, y = np.meshgrid(np.arange(6), np.arange(5))
        corner = (x < 2) & (y < 2)
        kept = corner | np.array(data.draw(st.lists(st.booleans(), min_size=30, max_size=30))).reshape(5, 6)
        order = np.array(data.draw(st.permutations(range(int(kept.sum())))))
        scale = data.draw(st.floats(1e-6, 10.0))
        random = np.random.default_rng(data.draw(st.integers(0, 99)))
        shaken = [scale * (along[kept][order] + random.uniform(-8e-5, 8e-5, len(order))) for along in (x, y)]
        response = response_of_waves(x=shaken[0], y=shaken[1], region=None)
        grid = response.grid()[:, 0].values
        assert np.isfinite(grid[0]).sum() == len(order)
        placed = grid[:, y[kept][order], x[kept][order]]
        assert np.array_equal(placed, response.values[:, :, 0])

    def test_one_row_and_one_point(self):
        assert response_of_waves(x=X, y=np.zeros(5), region=None).grid().shape == (6, 1, 1, 5)
        assert response_of_waves(x=X[:1], y=Y[:1], region=None).grid().shape == (6, 1, 1, 1)
        rounded = Y[0] + np.array([0, 1, -1, 2, 0]) * 1e-15
        assert response_of_waves(x=X, y=rounded, region=None).grid().shape == (6, 1, 1, 5)

    def test_points_beside_a_grid_are_refused(self):
        with refusing(ResponseError, "unsupported", "x of the points"):
            response_of_waves(x=np.array([0, 2, 4, 6, 7.2]), y=np.zeros(5), region=None).grid()
        with refusing(ResponseError, "unsupported", "y of the points"):
            response_of_waves(x=np.zeros(5), y=np.array([0, 1, 2.4, 3, 4]), region=None).grid()

    def test_two_points_on_one_place_are_refused(self):
        with refusing(ResponseError, "repeated", "points", "2 points at x = 2 mm, y = 0 mm"):
            response_of_waves(x=np.array([0, 2e-3, 2e-3]), y=np.zeros(3), region=None).grid()


WRONG = {
    "quantity": ({"quantity": "velosity"}, "unknown", "response.quantity"),
    "origin": ({"origin": "guessed"}, "unknown", "response.origin"),
    "direction": ({"direction": ["n"]}, "malformed", "response.direction"),
    "direction as text": ({"direction": "z"}, "malformed", "response.direction"),
    "no direction": ({"direction": []}, "malformed", "response.direction"),
    "direction twice": ({"direction": ["z", "z"]}, "malformed", "response.direction"),
    "no unit": ({"reference": "A1"}, "malformed", "response.reference"),
    "no name": ({"reference": ", V"}, "malformed", "response.reference"),
    "descending": ({"frequency": LINES[::-1]}, "malformed", "response.frequency"),
    "repeated": ({"frequency": LINES[[0, 1, 1, 2, 3, 4]]}, "malformed", "response.frequency"),
    "negative": ({"frequency": LINES - 1}, "malformed", "response.frequency"),
    "infinite": ({"frequency": np.array([0, np.inf])}, "malformed", "response.frequency"),
    "no line": ({"frequency": np.empty(0)}, "malformed", "response.frequency"),
    "lines of integers": ({"frequency": np.arange(6)}, "malformed", "response.frequency"),
    "nowhere": ({"x": np.full(20, np.nan)}, "malformed", "response.x"),
    "no point": ({"x": np.empty(0)}, "malformed", "response.x"),
    "axes of a grid": ({"x": X, "y": Y}, "mismatch", "response.y"),
    "real": ({"response": np.ones((6, 20, 1))}, "malformed", "response.response"),
    "no axis of directions": ({"response": numbers((6, 20))}, "malformed", "response.response"),
    "axes exchanged": ({"response": numbers((20, 6, 1))}, "malformed", "response.response"),
    "not a number": ({"response": np.full((6, 20, 1), np.nan + 0j)}, "malformed", "response.response"),
    "coherence of another shape": ({"coherence": np.ones(20)}, "malformed", "response.coherence"),
    "coherence in per cent": ({"coherence": np.full((6, 20), 99.0)}, "out-of-range", "response.coherence"),
    "negative coherence": ({"coherence": np.full((6, 20), -0.1)}, "out-of-range", "response.coherence"),
    "coherence not a number": ({"coherence": np.full((6, 20), np.nan)}, "malformed", "response.coherence"),
    "regions, not names of points": ({"region": ["WG1", "WG2"]}, "mismatch", "response.region"),
    "region as text": ({"region": "abcdefghijklmnopqrst"}, "mismatch", "response.region"),
    "reserved": ({"region": ["rest"] * 20}, "conflict", "response.region"),
    "reserved in words": ({"region": ["the rest"] * 20}, "conflict", "response.region"),
}


@each("name", WRONG)
def test_bad_input_is_refused(name):
    changes, code, argument = WRONG[name]
    with refusing(ResponseError, code, argument):
        response_of_waves(**changes)
