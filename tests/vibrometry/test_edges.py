"""Edges of a gap from fields whose decay is prescribed; levels without noise against plain statistics."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import xarray as xr
from hypothesis import given, settings, strategies as st
from test_estimation import LINES as HALVES, recorded

from five_parts import assert_explained
from haptonic.errors import ScanError
from haptonic.gate import passed
from haptonic.response import FrequencyResponse, Reference
from haptonic.vibrometry import (
    Edge,
    InMemory,
    LatticeGap,
    LatticeRows,
    Rectangle,
    TimeScan,
    clean_contrast,
    clean_rms,
    decay_along,
    estimate,
    gap_edges,
)
from haptonic.vibrometry.maps.edges import METHOD
from haptonic.vibrometry.maps.noise import TRUSTED, noise_power, region_power

PITCH, ROWS, CELLS = 7e-3, 3, 12
LINES = np.arange(40e3, 75e3, 100.0)
X, Y = (
    axis.ravel()
    for axis in np.meshgrid(
        np.arange(25) * 2e-3, 1e-3 + np.arange(42) * 2e-3
    )  # the lattice, and plate on both sides
)
STRIP = LatticeRows(
    area=Rectangle(14e-3, 0.0, ROWS * PITCH, CELLS * PITCH),
    depth="x",
    start=14e-3,
    inwards=1,
    pitch=PITCH,
    period=PITCH,
    spacing=PITCH,
    repeat=1,
    rows=ROWS,
)
OFFSET = replace(STRIP, pitch=PITCH / 2, rows=2 * ROWS, repeat=2)
WAVES = np.pi * np.arange(1, CELLS) / CELLS


def exponent(lines, lower, upper, deep=1.6):
    """Exponent of a wave per cell: i k in a band, in the gap a decay that rises from the edges as a root."""
    depth = np.clip((lines - lower) * (upper - lines), 0, None) / (0.25 * (upper - lower)) ** 2
    return np.where(depth > 0, deep * np.minimum(np.sqrt(depth), 1.0) + 0j, 1j * (0.4 + lines / 60e3))


def field(edges, noise=0.0, averages=0, seed=1, reflected=0.4, grain=0.0):
    """Waves of many phases along the rows, and what comes back of them; ``edges`` of a phase, or None.

    grain : by which they differ within a cell of rows half a pitch deep, each offset by half a period
    """
    chance = np.random.default_rng(seed)
    cells = (X - STRIP.start) / PITCH
    values = np.zeros((len(LINES), len(X)), complex)
    for phase in WAVES:
        gap = edges(phase)
        gamma = exponent(LINES, *gap) if gap else 1j * (0.4 + LINES / 60e3)
        amplitude, back = chance.normal(size=(2, len(LINES))) + 1j * chance.normal(size=(2, len(LINES)))
        there = amplitude[:, None] * np.exp(-np.outer(gamma, cells))
        values += (there + reflected * back[:, None] * np.exp(np.outer(gamma, cells - ROWS))) * np.cos(
            phase * Y / PITCH
        )
    values *= 1 + grain * np.cos(2 * np.pi * Y / PITCH) * np.cos(2 * np.pi * cells)
    coherence = None
    if averages:
        scatter = chance.normal(size=(2, averages, *values.shape))
        each = values + noise * (scatter[0] + 1j * scatter[1])
        values = each.mean(axis=0)
        coherence = np.abs(values) ** 2 / (np.abs(each) ** 2).mean(axis=0)
    return FrequencyResponse.of(
        values[..., None], frequency=LINES, x=X, y=Y, reference="A1, V", origin="simulated",
        coherence=coherence, inputs={"estimator": "H1", "averages": averages},
    )  # fmt: skip


def whole(phase):
    return 52e3, 62e3


@pytest.mark.parametrize(
    ("lower", "upper", "beside"),
    [
        (None, Edge(50.4e3, 700.0), True),
        (None, Edge(54.5e3, 700.0), False),
        (None, Edge(60e3, 100.0), False),
        (Edge(66e3, 500.0), None, True),
        (Edge(66e3, 1500.0), None, False),
        (Edge(50e3, 500.0), None, False),
        (Edge(40e3, 100.0), Edge(50e3, 100.0), True),
        (None, None, False),
    ],
)
def test_a_range_that_has_nothing_in_common_with_55_to_65_khz(lower, upper, beside):
    assert LatticeGap(lower, upper, ()).beside(55e3, 65e3) == beside


class TestEdges:
    @pytest.mark.parametrize("gap", [(52e3, 62e3), (47.3e3, 55.9e3)])
    @pytest.mark.parametrize("reflected", [0.0, 1.0])
    def test_both_edges_are_found_where_all_waves_stop(self, gap, reflected):
        edges = gap_edges(decay_along(field(lambda phase: gap, reflected=reflected), [STRIP]))
        assert edges.reasons == ()
        for edge, true in ((edges.lower, gap[0]), (edges.upper, gap[1])):
            assert abs(edge.frequency - true) < edge.error
            # these rise within some hundred hertz: of the error nearly all is that of rows that are few
            assert METHOD * true < edge.error < 1.1 * METHOD * true

    def test_decay_is_as_prescribed_and_zero_in_the_band_despite_reflections(self):
        seen = decay_along(field(whole, reflected=1.0), [STRIP])
        phases = (seen["phase"] > 0.3) & (seen["phase"] < 2.9)
        inside = seen.sel(frequency=slice(55e3, 59e3))[:, phases]
        assert inside.median().item() == pytest.approx(20 * np.log10(np.e) * 1.6, rel=0.03)
        assert seen.sel(frequency=slice(41e3, 50e3))[:, phases].median().item() < 0.5

    @pytest.mark.parametrize("grain", [0.3, 2.0])
    def test_offset_rows_give_the_same_decay(self, grain):
        """Waves of a phase and of 2 pi less it are one wave; from row to row these are of opposite sign."""
        plain = decay_along(field(whole), [STRIP])[:, 1:]
        offset = decay_along(field(whole, grain=grain), [OFFSET])[:, 1:]
        inside = plain.sel(frequency=slice(55e3, 59e3))
        assert float(inside.min()) > 5
        assert 2 * offset.sel(frequency=slice(55e3, 59e3)).values == pytest.approx(inside.values, rel=0.06)

    def test_a_strip_along_the_other_axis_and_backwards_is_the_same(self):
        plain = field(whole)
        turned = FrequencyResponse.of(
            plain.values, frequency=LINES, x=Y, y=-X, reference="A1, V", origin="simulated",
        )  # fmt: skip
        area = Rectangle(0.0, -STRIP.start - ROWS * PITCH, CELLS * PITCH, ROWS * PITCH)
        strip = replace(STRIP, area=area, depth="y", start=-STRIP.start, inwards=-1)
        assert decay_along(turned, [strip]).values == pytest.approx(
            decay_along(plain, [STRIP]).values, abs=1e-6
        )

    @pytest.mark.parametrize("small", [True, False])
    def test_a_gap_for_some_phases_only_is_no_gap(self, small):
        edges = gap_edges(
            decay_along(field(lambda q: (52e3, 62e3) if (q < np.pi / 2) == small else None), [STRIP])
        )
        assert edges.lower is None
        assert edges.upper is None
        assert any(("waves do not decay" if small else "nearly in phase") in text for text in edges.reasons)

    def test_an_edge_beyond_the_lines_is_not_determined(self):
        edges = gap_edges(decay_along(field(lambda phase: (60e3, 90e3)), [STRIP]))
        assert abs(edges.lower.frequency - 60e3) < edges.lower.error
        assert edges.upper is None
        assert "end of the scanned range" in edges.reasons[0]

    def test_noise_is_removed_or_reported(self):
        true = decay_along(field(whole), [STRIP]).sel(frequency=slice(55e3, 59e3))
        loud = field(whole, noise=0.4, averages=8)
        kept = decay_along(loud, [STRIP]).sel(frequency=slice(55e3, 59e3))
        silent = loud.dataset.drop_vars("coherence")
        fooled = decay_along(FrequencyResponse(silent), [STRIP]).sel(frequency=slice(55e3, 59e3))
        off = [float(np.abs(np.nanmedian(decay.values - true.values))) for decay in (kept, fooled)]
        assert off[0] < 0.3 * off[1] > 0.15
        nothing = gap_edges(decay_along(field(whole, noise=300.0, averages=8), [STRIP]))
        assert (nothing.lower, nothing.upper) == (None, None)
        assert "noise" in nothing.reasons[0]

    @pytest.mark.parametrize("deep", [0.8, 1.6])
    def test_rows_half_a_pitch_deep_give_the_same_edges(self, monkeypatch, deep):
        """The same pillars counted in rows of half the depth: half the decay in each, the same gap."""
        prescribed = exponent
        monkeypatch.setitem(globals(), "exponent", lambda lines, *ends: prescribed(lines, *ends, deep))
        seen = field(whole, grain=2.0)
        whole_rows = gap_edges(decay_along(field(whole), [STRIP]))
        half_rows = gap_edges(decay_along(seen, [OFFSET]), 0.5)
        assert whole_rows.reasons == half_rows.reasons == ()
        for expected, edge in ((whole_rows.lower, half_rows.lower), (whole_rows.upper, half_rows.upper)):
            assert edge.frequency == pytest.approx(expected.frequency, rel=1e-3)
        shallow = replace(OFFSET, rows=4)
        with pytest.raises(ScanError) as caught:
            decay_along(seen, [shallow])
        assert_explained(caught.value, "five where each is offset by half a period", code="too-few")

    def test_what_cannot_be_done_is_refused(self):
        two = replace(STRIP, rows=2)
        with pytest.raises(ScanError) as caught:
            decay_along(field(whole), [two])
        assert_explained(caught.value, "fewer than three rows", code="too-few", argument="strips")
        plain = field(whole)
        holes = np.flatnonzero((np.arange(len(X)) % 7 != 3) | (X > 0.05))
        with pytest.raises(ScanError) as caught:
            decay_along(FrequencyResponse(plain.dataset.isel(point=holes)), [STRIP])
        assert_explained(caught.value, "without a missing point", code="too-few", argument="strips")


def noisy(level, repeats=6, points=400, seed=2):
    """Half of the points move twice as much as the others; noise is ``level`` of the smaller motion."""
    chance = np.random.default_rng(seed)
    spectrum = np.zeros(len(HALVES), complex)
    spectrum[100:140] = 1.0
    drive = np.tile(np.fft.irfft(spectrum), (1, repeats, 1))
    size = np.where(np.arange(points) % 2, 2.0, 1.0)[:, None, None]
    moved = size * drive
    rms = np.sqrt(
        (drive**2).mean() * drive.shape[2] / 80
    )  # of noise whose power at a driven line is the drive's
    scan = TimeScan(
        InMemory(drive, moved + level * rms * chance.normal(size=moved.shape)),
        tuple(map(str, range(points))),
        np.arange(points) * 1e-3, np.zeros(points), repeats, drive.shape[2], 200e3, Reference("A1", "V"),
    )  # fmt: skip
    return estimate(scan, band=(10e3, 13.9e3)).response, size[:, 0, 0] > 1.5


class TestNoise:
    @pytest.mark.parametrize("level", [0.0, 3.0, 300.0])
    def test_values_hidden_by_noise_pass_the_gate_with_their_reason(self, level):
        response, loud = noisy(level=level, repeats=3)
        result = passed(clean_contrast(response, loud, ~loud))
        assert np.isnan(result["level"].values).any() == (level > 0)

    def test_its_power_is_the_scatter_of_the_repeats(self):
        """Every record by itself is an estimate; the coherence gives the variance of their mean."""
        chance = np.random.default_rng(4)
        drive = np.tile(chance.normal(size=(1, 1, 2000)), (1, 5, 1))
        moved = np.repeat(drive, 8, axis=0) + 0.5 * chance.normal(size=(8, 5, 2000))
        response = estimate(recorded(drive, moved), band=(1e3, 50e3)).response
        each = (np.fft.rfft(moved, axis=2) / np.fft.rfft(drive, axis=2))[..., 10:501]
        expected = each.var(axis=1, ddof=1).T / 5
        every = np.ones(8, bool)
        assert noise_power(response, every, slice(None), 5) == pytest.approx(expected, rel=1e-8)

    def test_levels_are_right_where_the_plain_ones_are_not(self):
        response, loud = noisy(3.0)
        plain = [
            10 * np.log10((np.abs(response.values[:, mask, 0]) ** 2).mean(axis=1)) for mask in (loud, ~loud)
        ]
        assert np.abs(plain[0] - plain[1] - 20 * np.log10(2)).min() > 1.0
        for mask, true in ((loud, 4.0), (~loud, 1.0)):
            power, error = region_power(response, mask)
            assert np.abs(power / true - 1).max() < 0.6
            assert np.sqrt((((power - true) / error) ** 2).mean()) == pytest.approx(1.0, abs=0.35)
            assert power.mean() == pytest.approx(true, rel=0.05)

    def test_values_left_uncertain_by_noise_are_not_reported(self):
        for level, reported in ((0.1, True), (3.0, False), (300.0, False)):
            response, loud = noisy(level)
            result = clean_contrast(response, loud, ~loud)
            assert np.isfinite(result["level"].values).all() == reported
            assert ((result["error"].values <= TRUSTED) == np.isfinite(result["level"].values)).all()
            if reported:
                assert np.abs(result["level"].values - 20 * np.log10(2)).max() < 0.5

    @given(st.floats(0.01, 1000.0), st.integers(0, 1000))
    @settings(max_examples=10)
    def test_what_noise_hides_is_declared_to_the_gate(self, level, seed):
        """A file of a scan holds these; infinite errors and NaN without a word are refused there."""
        response, loud = noisy(level, points=20, seed=seed)
        region = ("point", np.where(loud, "loud", "quiet"))
        named = FrequencyResponse(response.dataset.assign_coords(region=region))
        passed(clean_contrast(response, loud, ~loud))
        passed(xr.Dataset({"rms": clean_rms(named, "loud")}))

    @given(st.floats(0.01, 1000.0))
    @settings(max_examples=5)
    def test_decay_hidden_by_noise_is_declared_undetermined(self, noise):
        loud = field(lambda phase: (52e3, 62e3), noise=noise, averages=8)
        passed(xr.Dataset({"row_decay": decay_along(loud, [STRIP])}))

    def test_without_averages_a_level_is_taken_as_it_is(self):
        response, loud = noisy(0.1)
        silent = FrequencyResponse(
            response.dataset.drop_vars("coherence").assign_coords(
                region=("point", np.where(loud, "loud", "quiet"))
            )
        )
        expected = np.sqrt((np.abs(silent.values[:, loud, 0]) ** 2).mean(axis=1))
        assert clean_rms(silent, "loud").values == pytest.approx(expected, rel=1e-12)
        assert (clean_contrast(silent, loud, ~loud)["error"].values == 0).all()
