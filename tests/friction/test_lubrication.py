"""Load sharing and intermittent contact: stated values, balance of forces, scaling laws, inverses."""

import json
import re

import numpy as np
import pytest
import xarray as xr
from hypothesis import given, settings, strategies as st
from scipy.optimize import brentq

from five_parts import refused
from haptonic.friction.lubrication import (
    Fingertip,
    Margin,
    Touch,
    amplitude_for,
    amplitude_ratio,
    explained,
    intermittent_friction,
    predict,
    quality_limits,
    rise_time,
    sensitivity,
    shared_friction,
    slider_friction,
    time_constant,
)
from haptonic.friction.lubrication.sharing import asperity_pressure, film_pressure, nominal_pressure
from haptonic.response import FrequencyResponse, disc_average

TOUCH = Touch(58.8e3, 0.5, 0.078)
FINGER = Fingertip()
MICRO = 1e-6

amplitudes = st.floats(0.02, 6).map(lambda a: a * MICRO)


def test_skins_that_a_force_presses_flat_are_left_out_of_the_interval():
    """A gap is left if the pressure is below that of the asperities at no gap."""
    touch, amplitude = Touch(45e3, 2.0), xr.DataArray(np.array([0.5, 1.0, 2.0]) * MICRO, dims="amplitude")
    skin = FINGER.sampled(200)
    pressure = 2.0 / (skin["patch_area"] * 4.0 ** skin["area_exponent"])
    flat = pressure >= skin["asperity_pressure"] * np.exp(skin["contact_gap"] / skin["decay_length"])
    predicted = predict(amplitude, touch, FINGER)
    assert 0 < flat.mean() < 0.5
    assert predicted.attrs["pressed_flat"] == pytest.approx(flat.mean())
    assert (predicted["low"] <= predicted["high"]).all()
    assert predict(amplitude, Touch(45e3, 1.0), FINGER).attrs["pressed_flat"] == 0


def test_the_largest_force_is_that_at_which_the_value_has_a_gap():
    error = refused(lambda: shared_friction(1e-6, Touch(45e3, 5.0), FINGER.values), "touch.force")
    largest = float(re.search(r"below (\S+) N", error.allowed)[1])
    assert np.isfinite(shared_friction(1e-6, Touch(45e3, 0.97 * largest), FINGER.values))
    refused(lambda: shared_friction(1e-6, Touch(45e3, 1.05 * largest), FINGER.values), "touch.force")


class TestLoadSharing:
    def test_the_stated_values(self):
        a = np.array([0.1, 0.2, 0.3, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0]) * MICRO
        stated = [0.99, 0.94, 0.88, 0.74, 0.57, 0.43, 0.23, 0.12, 0.06, 0.03]
        assert shared_friction(a, TOUCH, FINGER.values) == pytest.approx(stated, abs=0.0055)

    def test_by_hand_with_a_film_so_wide_that_it_hardly_leaks(self):
        """The closed forms alone: sealed film less the leaking rim, root by another method."""
        values = FINGER.having(film_share=1.0).values
        radius, a = np.sqrt(1e-4 / np.pi), 1.2 * MICRO

        def excess(u):
            e2, sigma = (a / u) ** 2, 12 * 1.81e-5 * 2 * np.pi * 58.8e3 * (radius / u) ** 2 / 101325
            lift = (1 - np.sqrt(2 / sigma)) * 101325 * (np.sqrt((1 + 1.5 * e2) / (1 - e2)) - 1)
            return 5e3 * np.exp(-(u - 4e-6) / 3e-6) + lift - 5e3

        left = np.exp(-(brentq(excess, 1.3e-6, 1e-4, xtol=1e-14) - 4e-6) / 3e-6)
        assert shared_friction(a, TOUCH, values) == pytest.approx(left, rel=0.01)

    @settings(max_examples=30)
    @given(amplitudes, st.floats(0.1, 1.5), st.floats(20e3, 200e3))
    def test_the_inverse_finds_the_amplitude_again(self, amplitude, force, frequency):
        """By another equation: the inverse never solves for the gap."""
        touch = Touch(frequency, force)
        left = shared_friction(amplitude, touch, FINGER.values)
        if left > 1e-6:
            assert amplitude_for(left, touch, FINGER.values) == pytest.approx(amplitude, rel=1e-6)

    @settings(max_examples=30)
    @given(amplitudes, st.floats(0.3, 3))
    def test_lengths_scale(self, amplitude, scale):
        """Everything s times as long, every pressure s^2 times smaller: the same friction."""
        larger = FINGER.having(
            contact_gap=4e-6 * scale, decay_length=3e-6 * scale, patch_area=1e-4 * scale**2
        )
        # the force stays, so all pressures fall, those of asperities and air as well
        pressure = larger.having(asperity_pressure=5e3 / scale**2, ambient_pressure=101325 / scale**2)
        thin = pressure.having(viscosity=1.81e-5 / scale**2)
        expected = shared_friction(amplitude, TOUCH, FINGER.values)
        assert shared_friction(amplitude * scale, TOUCH, thin.values) == pytest.approx(expected, rel=1e-6)

    @given(amplitudes, st.floats(0.5, 2))
    def test_faster_in_thinner_air(self, amplitude, factor):
        """Only the product of frequency and viscosity counts."""
        other = shared_friction(
            amplitude, Touch(58.8e3 * factor), FINGER.having(viscosity=1.81e-5 / factor).values
        )
        assert other == pytest.approx(shared_friction(amplitude, TOUCH, FINGER.values), rel=1e-6)

    @given(st.lists(amplitudes, min_size=2, max_size=6, unique=True), st.floats(0.05, 1))
    def test_more_vibration_less_friction(self, many, share):
        left = shared_friction(np.sort(many), TOUCH, FINGER.having(film_share=share).values)
        assert (np.diff(left[np.isfinite(left)]) <= 1e-9).all()
        assert shared_friction(0.0, TOUCH, FINGER.values) == pytest.approx(1, abs=1e-9)

    def test_the_forces_balance(self):
        left = shared_friction(1e-6, TOUCH, FINGER.values)
        load = nominal_pressure(TOUCH, FINGER.values)
        assert load == pytest.approx(5e3)
        gap = 4e-6 - 3e-6 * np.log(left)
        carried = asperity_pressure(gap, FINGER.values) + film_pressure(gap, 1e-6, TOUCH, FINGER.values)
        assert carried == pytest.approx(load, rel=1e-6)

    def test_speed_plays_no_part_here(self):
        assert shared_friction(1e-6, Touch(58.8e3, speed=0.3), FINGER.values) == shared_friction(
            1e-6, TOUCH, FINGER.values
        )

    def test_a_plate_that_strikes_the_skin_is_not_a_film(self):
        short = FINGER.having(film_share=0.0005)
        left = shared_friction(np.array([1e-7, 5e-6]), TOUCH, short.values)
        assert left[0] == pytest.approx(1, abs=1e-3)
        assert np.isnan(left[1])
        assert np.isnan(amplitude_for(0.1, TOUCH, short.values))

    def test_the_ratio_that_explains_the_prototype(self):
        """Stated: 3.0 to 3.4 for plausible gaps and decays, all with a film as wide as the pad."""
        for gap, decay in ((4e-6, 3e-6), (4e-6, 2.5e-6), (5e-6, 3e-6), (3e-6, 2e-6)):
            finger = FINGER.having(contact_gap=gap, decay_length=decay)
            assert 3.0 < amplitude_ratio(0.55, 0.11, TOUCH, finger.values) < 3.4

    def test_the_film_length_matters_most(self):
        bounds = sensitivity(0.75e-6, TOUCH, FINGER)
        assert list(bounds)[:3] == ["film_share", "contact_gap", "decay_length"]
        assert bounds["film_share"][0] > bounds["film_share"][1]
        assert (
            bounds["contact_gap"][0]
            < shared_friction(0.75e-6, TOUCH, FINGER.values)
            < bounds["contact_gap"][1]
        )
        assert bounds["stiffness_ratio"][0] == bounds["stiffness_ratio"][1]


class TestSpringSlider:
    @pytest.mark.parametrize("beta", [0.02, 0.1, 0.3, 0.7, 0.95, 1.0, 4.0])
    def test_against_a_march_through_the_contact(self, beta):
        """The spring's force step by step, cut where it would exceed what friction holds."""
        theta, step = np.linspace(0, np.pi, 20001, retstep=True)
        force = np.zeros_like(theta)
        for i in range(1, len(theta)):
            force[i] = min(force[i - 1] + beta * step, np.sin(theta[i]))
        mean = np.trapezoid(force, theta) / np.trapezoid(np.sin(theta), theta)
        assert slider_friction(beta) == pytest.approx(mean, abs=2e-4)

    def test_against_the_stated_fit(self):
        beta = np.linspace(1e-3, 1, 1000)
        off = np.abs(slider_friction(beta) - (1 - np.exp(-3.48 * beta**1.149)))
        assert off.max() == pytest.approx(0.038, abs=0.001)

    def test_a_slow_finger_sticks(self):
        """beta theta^2 / 4 over the whole half period."""
        assert slider_friction(1e-4) == pytest.approx(1e-4 * np.pi**2 / 4, rel=1e-3)

    @given(amplitudes, st.floats(0.5, 2))
    def test_only_speed_over_velocity_counts(self, amplitude, factor):
        other = intermittent_friction(amplitude * factor, Touch(58.8e3, speed=0.078 * factor), FINGER.values)
        assert other == pytest.approx(intermittent_friction(amplitude, TOUCH, FINGER.values), rel=1e-9)

    def test_beta_is_the_stated_one(self):
        """0.667 U / (mu a omega) = 0.5."""
        a = 0.6666667 * 0.078 / (0.42 * 2 * np.pi * 58.8e3 * 0.5)
        assert intermittent_friction(a, TOUCH, FINGER.values) == pytest.approx(slider_friction(0.5), rel=1e-6)
        assert intermittent_friction(0.0, TOUCH, FINGER.values) == 1.0


class TestPrediction:
    def test_the_band_contains_both_models(self):
        line = xr.DataArray(np.linspace(0, 3e-6, 13), dims="amplitude")
        prediction = predict(line, TOUCH, FINGER)
        for model in ("load_sharing", "intermittent"):
            assert (prediction[model] >= prediction["low"] - 1e-12).all()
            assert (prediction[model] <= prediction["high"] + 1e-12).all()
            assert (prediction[f"{model}_low"] <= prediction[f"{model}_high"]).all()
        assert prediction["load_sharing"].values == pytest.approx(
            shared_friction(line.values, TOUCH, FINGER.values)
        )
        assert prediction["low"][0] == pytest.approx(1, abs=1e-6)
        assert float(prediction["high"][-1] - prediction["low"][-1]) > 0.3
        for model in ("load_sharing", "intermittent"):
            assert prediction[model].attrs["validity"]

    def test_assumed_values_are_marked(self):
        prediction = predict(xr.DataArray([1e-6], dims="a"), TOUCH, FINGER.having(contact_gap=5e-6))
        marks = {name: entry["mark"] for name, entry in json.loads(prediction.attrs["assumptions"]).items()}
        assert marks["decay_length"] == marks["film_share"] == "assumed"
        assert marks["contact_gap"] == "given"
        assert marks["static_friction"] == "computed"
        assert prediction.attrs["origin"] == "simulated"

    def test_a_map_is_the_line_at_its_points(self):
        many = np.random.default_rng(1).uniform(0, 3e-6, (20, 30))
        whole = predict(xr.DataArray(many, dims=("y", "x")), TOUCH, FINGER)
        few = predict(xr.DataArray(many[3], dims="x"), TOUCH, FINGER)
        assert whole["load_sharing"].dims == ("y", "x")
        expected = shared_friction(many, TOUCH, FINGER.values)
        assert whole["load_sharing"].values == pytest.approx(expected, abs=2e-3)
        for name in ("load_sharing", "intermittent", "low", "high"):
            assert whole[name].values[3] == pytest.approx(few[name].values, abs=2e-3)

    def test_from_the_response_of_a_plate(self):
        """Two halves that move by 10 and 1 nm for each volt, under a finger, at 100 V."""
        x = np.linspace(0, 0.1, 51)
        moved = np.where(x < 0.05, 10e-9, 1e-9).astype(complex)[None, :, None]
        response = FrequencyResponse.of(
            moved, frequency=np.array([58.8e3]), x=x, y=np.zeros(51), reference="A1, V", origin="simulated",
            quantity="displacement",
        )  # fmt: skip
        amplitude = 100 * disc_average(response, 0.01).isel(frequency=0)
        prediction = predict(amplitude, TOUCH, FINGER)["load_sharing"]
        assert prediction.dims == ("point",)
        assert prediction.values[[0, -1]] == pytest.approx(
            shared_friction(np.array([1e-6, 1e-7]), TOUCH, FINGER.values)
        )
        assert prediction.values[0] < prediction.values[25] < prediction.values[-1]
        assert prediction["x"].values == pytest.approx(x)

    def test_the_same_seed_the_same_band(self):
        line = xr.DataArray([0.5e-6, 1e-6], dims="a")
        first, same, other = (predict(line, TOUCH, FINGER, seed=seed)["low"].values for seed in (1, 1, 2))
        assert (first == same).all()
        assert (first != other).all()

    def test_nothing_uncertain_no_band(self):
        sure = FINGER.having(**FINGER.values)
        prediction = predict(xr.DataArray([1e-6], dims="a"), TOUCH, sure)
        assert prediction["load_sharing_low"].values == pytest.approx(prediction["load_sharing_high"].values)

    def test_what_explains_the_prototype(self):
        """A film as wide as the pad: 3 and somewhat more. A short film needs a larger ratio still."""
        wide = FINGER.having(film_share=1.0)
        explanation = explained(0.55, 0.11, TOUCH, wide)
        low, value, high = explanation["ratio"].sel(quantity=["low", "value", "high"]).values
        assert 2.8 < low < value < high < 4.2
        assert explanation.attrs["solved"] == 1.0
        assert explained(0.55, 0.11, TOUCH, FINGER)["ratio"].sel(quantity="high") > high
        back = 1 - shared_friction(explanation["driven"].sel(quantity="value").values, TOUCH, wide.values)
        assert back == pytest.approx(0.55)


class TestPerception:
    def test_the_stated_limits_of_the_quality_factor(self):
        limits = quality_limits(58.8e3)
        assert limits.by_rise == pytest.approx(193, abs=0.5)
        assert limits.by_constant == pytest.approx(425, abs=0.5)

    def test_against_a_resonator_that_builds_up(self):
        """The envelope of a driven resonator, 1 - exp(-t omega / 2 Q), from 10 to 90 %."""
        t = np.linspace(0, 0.05, 500001)
        envelope = 1 - np.exp(-t * 2 * np.pi * 58.8e3 / (2 * 300))
        rise = t[np.searchsorted(envelope, 0.9)] - t[np.searchsorted(envelope, 0.1)]
        assert rise_time(300, 58.8e3) == pytest.approx(rise, rel=1e-3)
        assert time_constant(300, 58.8e3) == pytest.approx(
            t[np.searchsorted(envelope, 1 - 1 / np.e)], rel=1e-3
        )

    def test_the_prototype_is_localised_just_so(self):
        margin = Margin(driven=0.55, idle=0.11)
        assert margin.noticed
        assert margin.localised
        assert margin.stopped == pytest.approx(0.8)
        assert not Margin(0.55, 0.111).localised
        assert not Margin(0.1, 0.05).localised


@pytest.mark.parametrize(
    ("amplitude", "word"),
    [
        (-1e-6, "-1e-06"),
        (1.5, "1.5"),
        (float("nan"), "1 of 1"),
        (1 + 1j, "complex"),
        (np.array([]), "(0,)"),
        (["a"], "<U1"),
        (True, "bool"),
    ],
)
def test_bad_amplitudes_are_refused(amplitude, word):
    refused(
        lambda: shared_friction(amplitude, TOUCH, FINGER.values),
        word,
        code="out-of-range",
        argument="amplitude",
    )
    refused(
        lambda: intermittent_friction(amplitude, TOUCH, FINGER.values),
        word,
        code="out-of-range",
        argument="amplitude",
    )


@pytest.mark.parametrize(
    ("numbers", "code", "given"),
    [
        ({"frequency": 58.8}, "out-of-range", "58.8 Hz"),
        ({"frequency": float("nan")}, "out-of-range", "nan"),
        ({"frequency": "58.8 mm"}, "malformed", "'58.8 mm'"),
        ({"frequency": 58.8e3, "force": 0.0}, "out-of-range", "0 N"),
        ({"frequency": 58.8e3, "force": 500.0}, "out-of-range", "500 N"),
        ({"frequency": 58.8e3, "speed": 78.0}, "out-of-range", "78 m/s"),
        ({"frequency": 58.8e3, "force": True}, "malformed", "True"),
    ],
)
def test_bad_touches_are_refused(numbers, code, given):
    refused(lambda: Touch(**numbers), given, code=code, argument=f"touch.{list(numbers)[-1]}")


@pytest.mark.parametrize(
    ("numbers", "code", "argument"),
    [
        ({"contact_gaps": 1e-6}, "unknown", "touch.skin.contact_gaps"),
        ({"zebra": 1.0}, "unknown", "touch.skin.zebra"),
        ({"contact_gap": 4.0}, "out-of-range", "touch.skin.contact_gap[1]"),
        ({"contact_gap": float("nan")}, "out-of-range", "touch.skin.contact_gap[1]"),
        ({"area_exponent": 0.0}, "out-of-range", "touch.skin.area_exponent[1]"),
    ],
)
def test_bad_fingers_are_refused(numbers, code, argument):
    refused(lambda: FINGER.having(**numbers), code=code, argument=argument)


def test_a_value_outside_of_its_own_uncertainty_is_refused():
    refused(
        lambda: Fingertip(contact_gap=(5e-6, 4e-6, 6e-6)), code="conflict", argument="touch.skin.contact_gap"
    )


def test_other_bad_input_is_refused():
    line = xr.DataArray([1e-6], dims="a")
    refused(lambda: predict(line, TOUCH, FINGER, samples=3), code="too-few", argument="samples")
    refused(
        lambda: predict(line, Touch(58.8e3, 10.0), FINGER),
        "10 N",
        code="out-of-range",
        argument="touch.force",
    )
    refused(lambda: amplitude_for(0.0, TOUCH, FINGER.values), code="out-of-range", argument="friction")
    refused(lambda: amplitude_for(55.0, TOUCH, FINGER.values), "55", code="out-of-range", argument="friction")
    refused(
        lambda: amplitude_for(np.nan, TOUCH, FINGER.values), "nan", code="out-of-range", argument="friction"
    )
    for driven, idle in ((0.11, 0.55), (0.5, 0.5), (55, 11), (0.5, 0.0), (0.5, float("nan"))):
        refused(
            lambda d=driven, i=idle: amplitude_ratio(d, i, TOUCH, FINGER.values),
            code="out-of-range",
            argument="reductions of friction",
        )
    refused(lambda: quality_limits(0.0), code="out-of-range", argument="frequency")
    refused(lambda: quality_limits(58.8e3, -1.0), code="out-of-range", argument="threshold")
    refused(lambda: rise_time(float("inf"), 58.8e3), code="out-of-range", argument="quality_factor")


def test_the_interval_contains_both_models_where_one_of_them_has_none():
    """With a fast and hard stroke some fingers have no film of air at 45 um, and the usual one floats."""
    amplitude = xr.DataArray(np.array([1e-6, 5e-6, 45e-6]), dims="line")
    predicted = predict(amplitude, Touch(60e3, 0.98, 0.5), Fingertip())
    assert np.isnan(predicted["load_sharing_low"].values[-1])
    for name in ("load_sharing", "intermittent"):
        assert (predicted["low"] <= predicted[name]).all()
        assert (predicted[name] <= predicted["high"]).all()
