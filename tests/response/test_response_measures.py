"""Measures of likeness and of localisation: closed forms, invariances, bounds."""

import numpy as np
import pytest
from hypothesis import given, strategies as st
from waves import LINES, X, Y, numbers, response_of_waves

from five_parts import refusing
from haptonic.errors import ResponseError
from haptonic.response import average_spectrum, cmif, contrast, disc_average, frac, mac, rms

seeds = st.integers(0, 10**6)
factors = st.complex_numbers(min_magnitude=1e-200, max_magnitude=1e200, allow_nan=False, allow_infinity=False)


class TestMac:
    def test_shapes_at_an_angle(self):
        """Two real shapes that enclose an angle have the square of its cosine."""
        angle = np.array([0.0, 0.3, 1.2, np.pi / 2])
        turned = np.column_stack([np.cos(angle), np.sin(angle)])
        assert mac(turned[:1], turned) == pytest.approx(np.cos(angle)[None] ** 2)

    def test_a_travelling_and_a_standing_one(self):
        """exp(-ikx) has half of its energy in cos(kx), and none in the wave that comes back."""
        phase = 2 * np.pi * np.arange(16) / 16
        there, standing = np.exp(-1j * phase)[None], np.cos(phase)[None]
        assert mac(there, standing) == pytest.approx(np.array([[0.5]]))
        assert mac(there, there.conj()) == pytest.approx(np.array([[0.0]]), abs=1e-30)

    @given(seeds, factors, factors)
    def test_neither_size_nor_phase_counts(self, seed, factor, other_factor):
        a, b = numbers((3, 7), seed), numbers((2, 7), seed + 1)
        assert mac(factor * a, other_factor * b) == pytest.approx(mac(a, b), rel=1e-9, abs=1e-12)

    @given(seeds, st.integers(1, 6))
    def test_between_0_and_1_unity_on_itself_and_symmetric(self, seed, points):
        a, b = numbers((3, points), seed), numbers((4, points), seed + 1)
        criterion = mac(a, b)
        assert criterion.shape == (3, 4)
        assert criterion.min() >= 0
        assert criterion.max() <= 1
        assert np.diag(mac(a, a)) == pytest.approx(np.ones(3))
        assert mac(b, a) == pytest.approx(criterion.T)

    @given(seeds)
    def test_a_rotation_of_all_shapes_changes_nothing(self, seed):
        a, b = numbers((3, 5), seed), numbers((2, 5), seed + 1)
        unitary = np.linalg.qr(numbers((5, 5), seed + 2))[0]
        assert mac(a @ unitary, b @ unitary) == pytest.approx(mac(a, b))

    def test_other_points_are_refused(self):
        with refusing(ResponseError, "mismatch", "shapes", "(3, 7) and (2, 8)"):
            mac(numbers((3, 7)), numbers((2, 8)))
        with refusing(ResponseError, "mismatch", "shapes"):
            mac(numbers((7,)), numbers((2, 7)))

    def test_a_shape_that_is_zero_is_refused(self):
        with refusing(ResponseError, "no-answer", "shape", "1 of 2"):
            mac(np.array([[1.0, 2.0], [0.0, 0.0]]), np.ones((1, 2)))


class TestFrac:
    @given(seeds)
    def test_it_is_the_mac_of_the_lines_at_every_point(self, seed):
        a, b = numbers((6, 4), seed), numbers((6, 4), seed + 1)
        assert frac(a, b) == pytest.approx(np.diag(mac(a.T, b.T)))

    def test_a_delay_is_seen_and_a_factor_is_not(self):
        """Eight lines over one turn of phase: orthogonal; over half a turn: 2 / (8 sin(pi/16)) squared."""
        a = numbers((8, 2))
        assert frac(a, np.array([2.0, -3j]) * a) == pytest.approx([1.0, 1.0])
        flat = np.ones((8, 1), dtype=complex)
        turn = np.exp(2j * np.pi * np.arange(8) / 8)[:, None]
        assert frac(flat, turn) == pytest.approx([0.0], abs=1e-30)
        half = np.exp(1j * np.pi * np.arange(8) / 8)[:, None]
        assert frac(flat, half) == pytest.approx([(1 / (8 * np.sin(np.pi / 16))) ** 2])

    def test_other_lines_are_refused(self):
        with refusing(ResponseError, "mismatch", "shapes"):
            frac(numbers((6, 4)), numbers((5, 4)))
        with refusing(ResponseError, "no-answer", "shape"):
            frac(np.zeros((6, 4)), numbers((6, 4)))


class TestRegions:
    def test_rms_of_a_sine_is_its_amplitude_over_the_root_of_two(self):
        """Over whole periods; the amplitude rises with the line."""
        x = np.arange(32) / 32
        shape = (1 + LINES[:, None] / 100e3) * np.sin(2 * np.pi * 3 * x) * np.exp(0.7j)
        response = response_of_waves(response=shape[..., None], x=x, y=np.zeros(32), region=["WG1"] * 32)
        spectrum = rms(response, "WG1")
        assert spectrum.values == pytest.approx((1 + LINES / 100e3) / np.sqrt(2))
        assert spectrum["frequency"].values == pytest.approx(LINES)
        assert spectrum.attrs["units"] == "m/s/V"
        assert average_spectrum(response).values == pytest.approx(spectrum.values)

    def test_rms_of_a_region_is_that_of_its_points(self):
        response = response_of_waves()
        for name in response.regions:
            alone = response.of_region(name)
            assert rms(response, name).values == pytest.approx(average_spectrum(alone).values)
            by_hand = np.sqrt((np.abs(alone.values[:, :, 0]) ** 2).mean(axis=1))
            assert rms(response, name).values == pytest.approx(by_hand)

    def test_directions_count_as_the_length_of_a_vector(self):
        values = np.broadcast_to(np.array([1.0, 2.0j, -2.0]), (6, 20, 3)).copy()
        assert average_spectrum(
            response_of_waves(response=values, direction=["x", "y", "z"])
        ).values == pytest.approx(np.full(6, 3.0))

    @pytest.mark.parametrize("size", [1e-30, 1e25])
    def test_single_precision_is_enough(self, size):
        values = np.full((6, 20, 1), size, dtype=np.complex64)
        assert average_spectrum(response_of_waves(response=values)).values == pytest.approx(
            np.full(6, size), rel=1e-6
        )

    def test_contrast_of_a_tenth_is_20_db(self):
        where = response_of_waves().dataset["region"].values
        values = np.where(where == "WG1", 10.0, np.where(where == "WG2", 1.0, 0.1))[None, :, None]
        response = response_of_waves(response=np.broadcast_to(values + 0j, (6, 20, 1)).copy())
        assert contrast(response, "WG1", "WG2").values == pytest.approx(np.full(6, 20.0))
        assert contrast(response, "WG1", "WG2").attrs["units"] == "dB"
        rest = np.sqrt((8 * 1.0 + 8 * 0.01) / 16)
        assert contrast(response, "WG1", "rest").values == pytest.approx(np.full(6, 20 * np.log10(10 / rest)))

    @given(seeds, st.complex_numbers(min_magnitude=1e-100, max_magnitude=1e100))
    def test_contrast_is_antisymmetric_and_blind_to_one_factor(self, seed, factor):
        values = numbers((6, 20, 1), seed)
        response = response_of_waves(response=values)
        for pair in (("WG1", "WG2"), ("WG2", "rest")):
            there, back = contrast(response, *pair), contrast(response, *pair[::-1])
            assert there.values == pytest.approx(-back.values)
            assert contrast(response_of_waves(response=factor * values), *pair).values == pytest.approx(
                there.values, abs=1e-6
            )

    def test_a_region_that_does_not_move(self):
        where = response_of_waves().dataset["region"].values == "WG2"
        values = np.broadcast_to(np.where(where, 0j, 1 + 0j)[None, :, None], (6, 20, 1)).copy()
        assert (contrast(response_of_waves(response=values), "WG1", "WG2").values == np.inf).all()

    def test_no_points_in_the_rest(self):
        with refusing(ResponseError, "missing", "region", '"rest"'):
            contrast(response_of_waves(region=["WG1"] * 20), "WG1", "rest")

    @pytest.mark.parametrize("pair", [("WG1", "WG3"), ("WG3", "WG1"), ("rest", "rest"), ("WG3", "rest")])
    def test_unknown_regions_are_refused(self, pair):
        with refusing(ResponseError, "unknown", "region"):
            contrast(response_of_waves(), *pair)
        with refusing(ResponseError, "unknown", "region"):
            rms(response_of_waves(), "WG3")


class TestDisc:
    def test_an_even_amplitude_stays(self):
        values = np.full((6, 20, 1), 3.0) * np.exp(1j * np.arange(20))[:, None]
        average = disc_average(response_of_waves(response=values), 5e-3)
        assert average.dims == ("frequency", "point")
        assert average.values == pytest.approx(np.full((6, 20), 3.0))
        assert average.attrs["units"] == "m/s/V"
        assert list(average["region"].values) == list(response_of_waves().dataset["region"].values)

    @given(seeds, st.floats(1e-3, 12e-3))
    def test_it_is_the_mean_square_of_the_points_in_reach(self, seed, diameter):
        response = response_of_waves(response=numbers((6, 20, 1), seed))
        average = disc_average(response, diameter).values
        for number, centre in enumerate(response.points):
            near = np.hypot(*(response.points - centre).T) <= diameter / 2 * (1 + 1e-12)
            by_hand = np.sqrt((np.abs(response.values[:, near, 0]) ** 2).mean(axis=1))
            assert average[:, number] == pytest.approx(by_hand)

    def test_lobes_of_opposite_sign_do_not_cancel(self):
        """A wide disc over a standing wave sees its amplitude over the root of two, at every place."""
        side = np.arange(60) * 1e-3
        x, y = (along.ravel() for along in np.meshgrid(side, side))
        wave = np.broadcast_to(np.cos(2 * np.pi * x / 8e-3)[None, :, None] + 0j, (1, 3600, 1))
        response = response_of_waves(response=wave.copy(), frequency=np.array([58e3]), x=x, y=y, region=None)
        average = disc_average(response, 20e-3).values[0]
        inner = (np.abs(x - 0.03) < 0.01) & (np.abs(y - 0.03) < 0.01)
        assert average[inner] == pytest.approx(np.full(inner.sum(), 2**-0.5), rel=0.05)

    def test_the_rim_belongs_to_the_disc(self):
        """The middle point of a row of five reaches its neighbours at 2 mm with a disc of just 4 mm."""
        values = np.array([1.0, 0, 0, 0, 0]) + 0j
        response = response_of_waves(
            response=np.broadcast_to(values[None, :, None], (6, 5, 1)).copy(),
            x=X, y=np.full(5, Y[0]), region=None,
        )  # fmt: skip
        assert disc_average(response, 4e-3).values[0] == pytest.approx(
            [np.sqrt(1 / 2), np.sqrt(1 / 3), 0, 0, 0]
        )
        assert disc_average(response, 3.9e-3).values[0] == pytest.approx([1, 0, 0, 0, 0])

    @pytest.mark.parametrize("diameter", [0.0, -1e-3, np.nan, np.inf])
    def test_a_disc_has_a_size(self, diameter):
        with refusing(ResponseError, "out-of-range", "diameter"):
            disc_average(response_of_waves(), diameter)


class TestCmif:
    def test_one_reference_gives_the_sum_of_squares(self):
        response = response_of_waves()
        values = cmif([response])
        assert values.dims == ("frequency", "value")
        assert values.values[:, 0] == pytest.approx((np.abs(response.values) ** 2).sum(axis=(1, 2)))
        assert values.values[:, 0] == pytest.approx(20 * average_spectrum(response).values ** 2)
        assert values.attrs["units"] == "(m/s/V)^2"

    @given(seeds)
    def test_they_are_the_eigenvalues_of_the_gram_matrix(self, seed):
        pair = [response_of_waves(response=numbers((6, 20, 1), seed + k)) for k in range(2)]
        matrix = np.stack([r.values[:, :, 0] for r in pair], axis=-1)
        gram = matrix.conj().transpose(0, 2, 1) @ matrix
        assert cmif(pair).values == pytest.approx(np.linalg.eigvalsh(gram)[:, ::-1])

    def test_two_modes_in_one_peak_are_distinguished_from_one(self):
        """Two references that see one mode alike leave one value; two modes leave two."""
        bending, torsion = numbers((1, 20), 1), numbers((1, 20), 2)
        force = np.ones((6, 1))
        alike = [response_of_waves(response=(force * factor * bending)[..., None]) for factor in (1.0, 0.3j)]
        assert (cmif(alike).values[:, 1] < 1e-25 * cmif(alike).values[:, 0]).all()
        both = [response_of_waves(response=(force * shape)[..., None]) for shape in (bending, torsion)]
        assert (cmif(both).values[:, 1] > 0.1 * cmif(both).values[:, 0]).all()

    def test_responses_that_do_not_fit_are_refused(self):
        with refusing(ResponseError, "mismatch", "responses", "none"):
            cmif([])
        with refusing(ResponseError, "mismatch", "responses"):
            cmif([response_of_waves(), response_of_waves().between(0, 40e3)])
