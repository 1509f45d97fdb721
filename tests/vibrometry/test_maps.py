"""Maps of simulated fields whose gap, waves and decay are known."""

from __future__ import annotations

import json
import warnings

import numpy as np
import pytest
from hypothesis import given, strategies as st
from scipy.stats import linregress

from five_parts import assert_explained, refusing
from haptonic.errors import HaptonicWarning, ResponseError, ScanError
from haptonic.response import FrequencyResponse
from haptonic.vibrometry import (
    Rectangle,
    Registration,
    RoundRegion,
    lattice_decay,
    measured_gap,
    region_statistics,
    register_by_corners,
    register_by_fit,
    scan_plan,
    warn_if_aliased,
    wavenumber_map,
)

PLATE = Rectangle(0.0, 0.0, 0.140, 0.127)
CORNERS = np.array([[0, 0], [0.14, 0], [0.14, 0.127], [0, 0.127]])


def response_of(values, lines, x, y, **changes) -> FrequencyResponse:
    keywords = {"reference": "A1, V", "origin": "simulated"} | changes
    return FrequencyResponse.of(
        np.asarray(values, dtype=complex)[..., None], frequency=lines, x=x, y=y, **keywords
    )


def moved(points, scale, angle, shift, mirrored=False):
    """What a vibrometer sees of points of the plate: the inverse of a registration."""
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    seen = (points - shift) @ turn / scale
    return seen * [-1, 1] if mirrored else seen


class TestRegistration:
    @given(st.floats(0.1, 10), st.floats(-3, 3), st.floats(-1, 1), st.floats(-1, 1), st.booleans())
    def test_corners_give_the_motion_back(self, scale, angle, dx, dy, mirrored):
        fit = register_by_corners(
            moved(CORNERS, scale, angle, [dx, dy], mirrored), CORNERS, mirrored=mirrored
        )
        assert fit.scale == pytest.approx(scale)
        assert np.exp(1j * fit.angle) == pytest.approx(np.exp(1j * angle))
        assert fit.shift == pytest.approx([dx, dy], abs=1e-9)
        assert fit.misfit < 1e-9
        places = np.array([[0.03, 0.05], [0.1, 0.02]])
        assert fit.of(moved(places, scale, angle, [dx, dy], mirrored)) == pytest.approx(places, abs=1e-9)

    def test_the_misfit_measures_the_scatter(self):
        off = CORNERS + np.array([[1e-3, 0], [-1e-3, 0], [1e-3, 0], [-1e-3, 0]])
        fit = register_by_corners(CORNERS, off, scaled=False)
        # neither a shift nor a turn has a part in this, so all of it is left
        assert fit.misfit == pytest.approx(1e-3)
        assert fit.scale == 1.0

    def test_a_view_from_behind_fits_only_with_the_option(self):
        seen = moved(CORNERS, 1.0, 0.3, [0, 0], mirrored=True)
        assert register_by_corners(seen, CORNERS).misfit > 0.03
        assert register_by_corners(seen, CORNERS, mirrored=True).misfit < 1e-12

    @pytest.mark.parametrize("angle", [0.0, 0.02, -0.4, 0.7])
    @pytest.mark.parametrize("scaled", [True, False])
    def test_best_fit_with_points_missing(self, angle, scaled):
        plan = scan_plan(PLATE, 4e-3, [RoundRegion(0.05, 0.05, 0.02)]).points
        keep = np.random.default_rng(1).random(len(plan)) > 0.03
        scale = 1.03 if scaled else 1.0
        noise = 2e-4 * np.random.default_rng(2).normal(size=plan.shape)
        seen = moved(plan + noise, scale, angle, [0.3, -0.2])[keep]
        fit = register_by_fit(seen, plan, scaled=scaled)
        assert fit.angle == pytest.approx(angle, abs=2e-3)
        assert fit.scale == pytest.approx(scale, abs=2e-3)
        assert fit.of(seen) == pytest.approx(plan[keep], abs=1.5e-3)
        assert fit.misfit == pytest.approx(2e-4 * np.sqrt(2), rel=0.2)

    def test_the_response_moves_and_gets_regions(self):
        plan = scan_plan(PLATE, 8e-3).points
        seen = moved(plan, 1.0, 0.2, [0.1, 0.0])
        response = response_of(np.ones((2, len(plan))), np.array([1.0, 2.0]), *seen.T, title="twin")
        fit = register_by_corners(moved(CORNERS, 1.0, 0.2, [0.1, 0.0]), CORNERS)
        registered = fit.registered(
            response, {"hole": RoundRegion(0.07, 0.06, 0.02), "WG1": Rectangle(0, 0.021, 0.14, 0.032)}
        )
        assert registered.points == pytest.approx(plan, abs=1e-12)
        inside = Rectangle(0, 0.021, 0.14, 0.032).holds(plan)
        hole = RoundRegion(0.07, 0.06, 0.02).holds(plan)
        assert np.array_equal(registered.inside("hole"), hole)
        assert np.array_equal(registered.inside("WG1"), inside & ~hole)
        notes = registered.dataset.attrs
        assert json.loads(notes["inputs"])["registration"]["angle"] == pytest.approx(0.2)
        assert (notes["title"], notes["origin"]) == ("twin", "simulated")

    def test_motions_in_the_plate_are_not_turned(self):
        response = FrequencyResponse.of(
            np.ones((1, 4, 2), complex), frequency=np.array([1.0]), x=CORNERS[:, 0], y=CORNERS[:, 1],
            direction=["x", "z"], reference="A1, V", origin="measured",
        )  # fmt: skip
        fit = register_by_corners(moved(CORNERS, 1.0, 0.2, [0, 0]), CORNERS)
        with pytest.raises(ScanError) as caught:
            fit.registered(response)
        assert_explained(caught.value, "11.46 deg", code="unsupported", argument="registration")

    @pytest.mark.parametrize(
        ("scan", "plate"),
        [
            (CORNERS[:3], CORNERS),
            (CORNERS[:1], CORNERS[:1]),
            (0 * CORNERS, CORNERS),
            (CORNERS, 0 * CORNERS),
            (np.nan * CORNERS, CORNERS),
        ],
    )
    def test_bad_corners(self, scan, plate):
        with pytest.raises(ScanError) as caught:
            register_by_corners(scan, plate)
        assert_explained(caught.value, code="malformed", argument="registration.corners")

    def test_bad_fits(self):
        line = np.column_stack([np.arange(9.0), np.arange(9.0)])
        for scan in (line, CORNERS[:2] + 0.01):
            with refusing(ScanError, "malformed", "registration.fit"):
                register_by_fit(scan, CORNERS)


LINES = np.linspace(40e3, 80e3, 401)
GRID_X, GRID_Y = (g.ravel() for g in np.meshgrid(np.arange(20) * 2e-3, np.arange(10) * 2e-3))
REGION = np.where(GRID_Y < 9e-3, "WG1", "lattice").tolist()


def gapped(lower=52e3, upper=60e3, depth=30.0, slope=300.0, seed=0):
    """The lattice falls silent by ``depth`` dB between the edges, with a transition of width ``slope``."""
    chance = np.random.default_rng(seed)
    rise = (np.tanh((LINES - lower) / slope) - np.tanh((LINES - upper) / slope)) / 2
    silence = 10 ** (-depth * rise / 20)
    shape = chance.normal(size=(2, len(GRID_X)))
    rough = 1 + 0.3 * np.sin(LINES / 400)
    values = rough[:, None] * (shape[0] + 1j * shape[1])
    values = np.where(np.array(REGION) == "lattice", values * silence[:, None], values)
    return response_of(values, LINES, GRID_X, GRID_Y, region=REGION)


class TestGap:
    @pytest.mark.parametrize(("lower", "upper"), [(52e3, 60e3), (45.03e3, 57.77e3)])
    def test_the_edges_are_found_within_their_errors(self, lower, upper):
        gap = measured_gap(gapped(lower, upper), "WG1", "lattice", smoothing=200.0)
        assert abs(gap.lower - lower) < 3 * gap.lower_error
        assert abs(gap.upper - upper) < 3 * gap.upper_error
        assert gap.inside - gap.outside == pytest.approx(30, abs=1.5)
        assert 30 < gap.lower_error < 300
        # tanh goes from a quarter to three quarters of its step within 2 atanh(1/2) widths
        assert gap.lower_transition == pytest.approx(2 * np.arctanh(0.5) * 300, rel=0.2)

    def test_a_sharper_edge_has_a_smaller_error(self):
        sharp, soft = (
            measured_gap(gapped(slope=s), "WG1", "lattice", smoothing=0.0) for s in (100.0, 1500.0)
        )
        assert sharp.upper_error < 0.5 * soft.upper_error

    def test_a_gap_that_is_not_there(self):
        with pytest.raises(ScanError) as caught:
            measured_gap(gapped(depth=2.0), "WG1", "lattice")
        assert_explained(caught.value, code="no-answer", argument="measured_gap")

    def test_a_gap_that_ends_outside_of_the_range(self):
        gap = measured_gap(gapped(lower=70e3, upper=90e3), "WG1", "lattice")
        assert gap.upper == LINES[-1]
        assert gap.lower == pytest.approx(70e3, abs=300)

    def test_refused(self):
        for bad in ({"smoothing": -1.0}, {"smoothing": np.nan}, {"resamples": 1}):
            with pytest.raises(ScanError) as caught:
                measured_gap(gapped(), "WG1", "lattice", **bad)
            assert_explained(caught.value)
        with pytest.raises(ResponseError):
            measured_gap(gapped(), "WG1", "lattic")
        with refusing(ScanError, "out-of-range", "measured_gap", "5 lines"):
            measured_gap(gapped().between(50e3, 50.4e3), "WG1", "lattice")

    def test_statistics_of_regions(self):
        response = gapped()
        statistics = region_statistics(response, 54e3, 58e3)
        amplitude = np.abs(response.between(54e3, 58e3).values[..., 0])
        of_point = np.sqrt((amplitude**2).mean(axis=0))
        mask = np.array(REGION) == "lattice"
        assert statistics.sel(region="lattice")["rms"].item() == pytest.approx(
            np.sqrt((amplitude[:, mask] ** 2).mean())
        )
        assert statistics.sel(region="lattice")["largest"].item() == pytest.approx(of_point[mask].max())
        assert statistics.sel(region="WG1")["mean"].item() == pytest.approx(of_point[~mask].mean())
        assert statistics["points"].values.tolist() == [int((~mask).sum()), int(mask.sum())]
        with refusing(ScanError, "missing", "region"):
            region_statistics(
                response_of(np.ones((1, 2)), np.array([1.0]), np.zeros(2), np.arange(2.0)), 0, 2
            )


class TestWaves:
    x, y = (g.ravel() for g in np.meshgrid(np.arange(71) * 2e-3, np.arange(5) * 2e-3))
    lines = np.linspace(30e3, 80e3, 26)

    def guide(self, speed=700.0, sign=1, keep=None, turned=False):
        k = 2 * np.pi * self.lines / speed
        values = 3 * np.exp(sign * 1j * np.outer(k, self.x)) * np.cos(200 * self.y)
        keep = slice(None) if keep is None else keep
        place = (self.x[keep], self.y[keep])
        region = ["WG1"] * len(place[0])
        return k, response_of(values[:, keep], self.lines, *(place[::-1] if turned else place), region=region)

    @pytest.mark.parametrize("sign", [1, -1])
    @pytest.mark.parametrize("turned", [False, True])
    def test_the_wavenumber_of_a_travelling_wave(self, sign, turned):
        k, response = self.guide(sign=sign, turned=turned)
        spectrum = wavenumber_map(response, "WG1", "y" if turned else "x")
        peaks = spectrum["wavenumber"].values[spectrum.values.argmax(axis=1)]
        # a length of 142 mm, padded four times
        assert peaks == pytest.approx(sign * k, abs=2 * np.pi / (4 * 0.142) / 2 * 1.01)
        rows = np.sqrt((9 * np.cos(200 * np.arange(5) * 2e-3) ** 2).mean())
        assert spectrum.values.max(axis=1) == pytest.approx(np.full(26, rows), rel=0.02)
        assert spectrum.attrs["rows"] == 5

    def test_a_row_with_a_hole_is_left_out(self):
        keep = np.arange(len(self.x)) != 100
        k, response = self.guide(keep=keep)
        spectrum = wavenumber_map(response, "WG1", "x")
        assert (spectrum.attrs["rows"], spectrum.attrs["rows_left_out"]) == (4, 1)
        assert np.isfinite(spectrum.values).all()
        assert spectrum["wavenumber"].values[spectrum.values.argmax(axis=1)] == pytest.approx(k, abs=6)

    def test_no_whole_row(self):
        keep = ~np.isin(np.arange(len(self.x)), [10 + 71 * i for i in range(5)])
        _, response = self.guide(keep=keep)
        with pytest.raises(ScanError) as caught:
            # a column without a point at all is no hole of the rows when the place is not known
            wavenumber_map(response, "WG1", "x")
        assert_explained(caught.value, "0 rows", code="too-few", argument='region "WG1"')
        with refusing(ScanError, "too-few", 'region "WG1"', "5 points along y"):
            wavenumber_map(self.guide()[1], "WG1", "y")

    def test_folded_waves_are_suspected(self):
        # k of 80 kHz at 330 m/s is 1523 rad/m; 2 mm show up to 1571
        _, response = self.guide(speed=330.0)
        with pytest.warns(HaptonicWarning, match="probably aliased"):
            wavenumber_map(response.between(70e3, 80e3), "WG1", "x")

    def test_the_pitch_against_the_wavelength(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            assert not warn_if_aliased(2e-3, 12.6e-3)
            assert not warn_if_aliased(2e-3, 4e-3)
        with pytest.warns(HaptonicWarning, match="more than half of A0"):
            assert warn_if_aliased(7e-3, 12.6e-3, "A0 at 58.8 kHz")


class TestDecay:
    lines = np.array([50e3, 55e3, 60e3])
    x, y = (g.ravel() for g in np.meshgrid(np.arange(11) * 2e-3, np.arange(30) * 2e-3))

    def lattice(self, db=(5.0, 15.0, 0.0), ripple=0.0, inwards=1, seed=1):
        """Weaker by so many dB for each cell of 7 mm, with a structure inside of the cells."""
        chance = np.random.default_rng(seed)
        attenuation = 10 ** (-np.outer(db, self.x / 7e-3) / 20)
        inner = 10 ** (ripple * np.sin(2 * np.pi * self.x / 7e-3) / 20)
        wave = np.exp(1j * 2 * np.pi * chance.random(len(self.x)))
        values = attenuation * inner * wave
        return response_of(
            values, self.lines, 0.021 + inwards * self.x, self.y, region=["lattice"] * len(self.x)
        )

    @pytest.mark.parametrize("inwards", [1, -1])
    def test_an_exact_decay(self, inwards):
        response = self.lattice(inwards=inwards)
        decay = lattice_decay(response, "lattice", depth="x", start=0.021, pitch=7e-3, inwards=inwards)
        assert decay["decay"].values == pytest.approx([5, 15, 0], abs=1e-9)
        assert decay["error"].values.max() < 1e-9
        assert decay["decay"].attrs["units"] == "dB/row"
        assert decay.attrs["depths"] == 11

    def test_the_interval_has_its_nominal_coverage(self):
        held = []
        for seed in range(200):
            chance = np.random.default_rng(seed)
            rough = 10 ** (chance.normal(0, 1, size=(3, 11)) / 20)[:, (self.x / 2e-3).round().astype(int)]
            attenuation = 10 ** (-np.outer((5, 15, 0), self.x / 7e-3) / 20)
            response = response_of(
                attenuation * rough, self.lines, self.x, self.y, region=["lattice"] * len(self.x)
            )
            decay = lattice_decay(response, "lattice", depth="x", start=0.0, pitch=7e-3)
            held += ((decay["low"] < [5, 15, 0]) & (decay["high"] > [5, 15, 0])).values.tolist()
        # 600 trials at 95 %: a standard error of 0.9 %
        assert np.mean(held) == pytest.approx(0.95, abs=0.027)

    def test_slope_and_error_are_those_of_scipy(self):
        response = self.lattice(ripple=4.0)
        decay = lattice_decay(response, "lattice", depth="x", start=0.021, pitch=7e-3)
        row = response.values[:, :11, 0]  # all rows have the same levels
        for line in range(3):
            other = linregress(self.x[:11] / 7e-3, 20 * np.log10(np.abs(row[line])))
            assert decay["decay"].values[line] == pytest.approx(-other.slope, abs=1e-9)
            assert decay["error"].values[line] == pytest.approx(other.stderr)

    def test_structure_in_the_cells_widens_the_interval(self):
        plain, rippled = (
            lattice_decay(self.lattice(ripple=r), "lattice", depth="x", start=0.021, pitch=7e-3)
            for r in (0.0, 6.0)
        )
        assert (rippled["error"] > 0.5).all()
        assert (plain["error"] < 1e-9).all()
        assert (abs(rippled["decay"] - [5, 15, 0]) < 3 * rippled["error"]).all()

    @pytest.mark.parametrize(
        "change",
        [{"start": 1.0}, {"pitch": 0.0}, {"inwards": -1}, {"confidence": 1.0}, {"start": 0.039}],
    )
    def test_refused(self, change):
        settings = {"depth": "x", "start": 0.021, "pitch": 7e-3} | change
        with pytest.raises(ScanError) as caught:
            lattice_decay(self.lattice(), "lattice", **settings)
        assert_explained(caught.value, code="out-of-range")

    def test_silence(self):
        response = response_of(
            np.zeros((1, 4)), np.array([1.0]), np.arange(4.0), np.zeros(4), region=["L"] * 4
        )
        with refusing(ScanError, "out-of-range", "lattice_decay.region", "depths without"):
            lattice_decay(response, "L", depth="x", start=0.0, pitch=1.0)


def test_among_equal_fits_the_smallest_turn():
    """A whole grid looks the same after half a turn."""
    plan = scan_plan(PLATE, 4e-3).points
    fit = register_by_fit(moved(plan, 1.0, 0.03, [0.1, 0.0]), plan)
    assert fit.angle == pytest.approx(0.03, abs=1e-6)


def test_edges_lie_between_the_lines_and_the_widest_range_counts():
    from haptonic.vibrometry.maps.gap import _edges

    lines = np.arange(10.0)
    level = np.array([0.0, 0.0, 9.0, 0.0, 2.0, 8.0, 8.0, 8.0, 4.0, 0.0])
    # from 2 to 8 dB the middle is 5: half of the way from 4 to 5, three quarters of that from 7 to 8
    assert _edges(lines, level, 2.0, 8.0, 0.5) == pytest.approx((4.5, 7.75))
    assert _edges(lines, 0 * level, 2.0, 8.0, 0.5) == (0.0, 0.0)


def test_without_scatter_the_error_is_that_of_lines_and_transition():
    pair = [0, -1]
    response = gapped(slope=800.0)
    pair_of_points = response_of(
        response.values[:, pair, 0], LINES, GRID_X[pair], GRID_Y[pair], region=[REGION[0], REGION[-1]]
    )
    gap = measured_gap(pair_of_points, "WG1", "lattice", smoothing=0.0)
    for error, width in (
        (gap.lower_error, gap.lower_transition),
        (gap.upper_error, gap.upper_transition),
    ):
        assert width > 500
        assert error == pytest.approx(np.sqrt((100.0**2 + width**2) / 12))


@pytest.mark.parametrize(("scale", "doubtful"), [(1.0, False), (1.04, False), (0.2485, True), (1000.0, True)])
def test_a_scale_that_a_wrong_unit_would_cause_gives_a_remark(scale, doubtful):
    registration = Registration(scale=scale, angle=0.0, shift=np.zeros(2), mirrored=False, misfit=0.0)
    assert (len(registration.doubts) == 1) == doubtful
    assert all(f"scaled by {scale:.4g}" in doubt for doubt in registration.doubts)


class TestPartsOfAPlan:
    """Scans that lack rows of their plan, or contain a point beside it."""

    PLAN = scan_plan(PLATE, 4e-3).points

    def test_points_in_the_coordinates_of_the_plate_are_not_moved(self):
        for kept in (self.PLAN[:, 0] > 0.02, self.PLAN[:, 0] < 0.07, self.PLAN[:, 1] < 0.03):
            fit = register_by_fit(self.PLAN[kept], self.PLAN)
            assert (fit.scale, fit.angle, fit.shift.tolist()) == (1.0, 0.0, [0.0, 0.0])
            assert fit.repeats is None
            assert fit.covered == pytest.approx(kept.mean(), abs=0.1)

    @given(st.integers(0, 10**6))
    def test_a_point_beside_the_plate_moves_nothing(self, seed):
        chance = np.random.default_rng(seed)
        shift = chance.uniform(-0.3, 0.3, 2)
        beside = self.PLAN.max(axis=0) + chance.uniform(0.0, 0.2, 2) * [1, 0] + [1e-3, 0.0]
        fit = register_by_fit(moved(np.vstack([self.PLAN, beside]), 1.0, 0.0, shift), self.PLAN)
        assert fit.scale == 1.0
        assert fit.shift == pytest.approx(shift, abs=2e-4)
        assert not fit.doubts

    def test_a_part_with_unknown_origin_gives_a_doubt(self):
        part = self.PLAN[self.PLAN[:, 0] < 0.07]
        fit = register_by_fit(moved(part, 1.0, 0.0, [0.3, 0.2]), self.PLAN)
        assert fit.scale == 1.0
        assert "--corners" in "".join(fit.doubts)
        whole = register_by_fit(moved(self.PLAN, 1.0, 0.0, [0.3, 0.2]), self.PLAN)
        assert not whole.doubts
