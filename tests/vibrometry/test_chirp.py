"""Drive signals and scan plans."""

from __future__ import annotations

import warnings

import h5py
import numpy as np
import pytest
import scipy.io.wavfile
from hypothesis import given, strategies as st

from five_parts import assert_explained, refusing
from haptonic.errors import HaptonicWarning, ScanError
from haptonic.vibrometry import Rectangle, RoundRegion, drive, drive_notes, scan_plan, write_drive

USUAL = {"low": 20e3, "high": 70e3, "sample_rate": 250e3, "duration": 8e-3}


@pytest.mark.parametrize("kind", ["chirp", "multisine"])
class TestSignals:
    def test_the_power_lies_in_the_band(self, kind):
        signal = drive(**USUAL, kind=kind, amplitude=60.0)
        power = np.abs(np.fft.rfft(signal.samples)) ** 2
        lines = np.fft.rfftfreq(len(signal.samples), 1 / 250e3)
        inside = (lines >= 20e3 - 1) & (lines <= 70e3 + 1)
        share = power[inside].sum() / power.sum()
        assert share > (1 - 1e-12 if kind == "multisine" else 0.98)
        if kind == "multisine":
            assert np.ptp(power[inside]) < 1e-9 * power.max()
        else:  # no line of the middle of a sweep is lost
            middle = (lines >= 22e3) & (lines <= 68e3)
            assert power[middle].min() > 0.25 * np.median(power[inside])
        assert signal.band == (20e3, 70e3)
        assert np.abs(signal.samples).max() == pytest.approx(60.0)
        assert (signal.line_spacing, len(signal.samples)) == (125.0, 2000)
        assert signal.warnings == ()

    def test_it_closes_on_itself(self, kind):
        """From the last sample to the first the signal goes on as smoothly as anywhere else."""
        for samples in (2000, 2001, 1999):
            signal = drive(**USUAL | {"duration": samples / 250e3}, kind=kind).samples
            twice = np.tile(signal, 2)
            bend = np.abs(np.diff(twice, 2))
            assert bend[samples - 3 : samples + 2].max() <= bend[: samples - 3].max() * (1 + 1e-9)

            if kind == "chirp":  # whole turns: it comes up to zero from below and goes on above
                assert signal[-1] < signal[0] == 0 < signal[1]

    def test_the_crest_factor_is_low(self, kind):
        crest = drive(**USUAL, kind=kind).crest_factor
        assert crest == pytest.approx(np.sqrt(2), rel=0.01) if kind == "chirp" else crest < 2.0
        # lines in phase would be a click of crest factor sqrt(2 n)
        assert crest < 0.1 * np.sqrt(2 * 401)

    def test_the_paper_s_band_reaches_half_the_rate(self, kind):
        with pytest.warns(HaptonicWarning, match="half the sample rate"):
            signal = drive(low=0, high=100e3, sample_rate=200e3, duration=0.05, kind=kind)
        assert "250 kHz" in signal.warnings[0]

    def test_a_period_shorter_than_the_ring_down(self, kind):
        with pytest.warns(HaptonicWarning, match="3 Q / f"):
            signal = drive(**USUAL, quality_factor=500.0, kind=kind)
        # 3 x 500 / 20 kHz is 75 ms
        assert "a single shot of at least 75 ms" in signal.warnings[0]
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            drive(**USUAL | {"duration": 0.0751}, quality_factor=500.0, kind=kind)


@given(st.floats(100, 40e3), st.floats(1.1, 2.0), st.integers(300, 3000))
def test_the_band_stays_within_what_was_asked(low, ratio, samples):
    signal = drive(low=low, high=low * ratio + 2000, sample_rate=250e3, duration=samples / 250e3)
    assert signal.band[0] >= low * (1 - 1e-8)
    assert signal.band[1] <= (low * ratio + 2000) * (1 + 1e-8)
    assert signal.band[0] - signal.line_spacing < low


@pytest.mark.parametrize(
    ("change", "code", "argument"),
    [
        ({"high": 130e3}, "out-of-range", "drive.band"),
        ({"low": 80e3}, "out-of-range", "drive.band"),
        ({"low": -1.0}, "out-of-range", "drive.band"),
        ({"low": float("nan")}, "out-of-range", "drive.band"),
        ({"duration": 1e-5}, "out-of-range", "drive.duration"),
        ({"duration": 1e-9}, "out-of-range", "drive.duration"),
        ({"duration": 0.0}, "out-of-range", "drive.duration"),
        ({"amplitude": -1.0}, "out-of-range", "drive.amplitude"),
        ({"sample_rate": float("inf")}, "out-of-range", "drive.sample_rate"),
        ({"quality_factor": 0.0}, "out-of-range", "drive.quality_factor"),
        ({"kind": "chrip"}, "unknown", "drive.kind"),
    ],
)
def test_signals_that_cannot_be(change, code, argument):
    with pytest.raises(ScanError) as caught:
        drive(**USUAL | change)
    assert_explained(caught.value, code=code, argument=argument)


class TestFiles:
    signal = drive(**USUAL, amplitude=60.0)

    def test_wav(self, tmp_path):
        write_drive(self.signal, tmp_path / "a.wav", periods=3)
        rate, samples = scipy.io.wavfile.read(tmp_path / "a.wav")
        notes = drive_notes(self.signal, 3)
        assert (rate, samples.dtype, len(samples)) == (250000, np.int16, 6000)
        volts = samples[2000:4000] / 32767 * notes["full_scale"]
        assert volts == pytest.approx(self.signal.samples, abs=60 / 32767)
        assert notes["unit"] == "V"

    def test_csv(self, tmp_path):
        write_drive(self.signal, tmp_path / "a.csv")
        table = np.loadtxt(tmp_path / "a.csv", delimiter=",", skiprows=1)
        assert np.array_equal(table[:, 1], self.signal.samples)
        assert np.array_equal(table[:, 0], np.arange(2000) / 250e3)

    def test_hdf5(self, tmp_path):
        write_drive(self.signal, tmp_path / "a.h5", periods=2)
        with h5py.File(tmp_path / "a.h5") as file:
            assert np.array_equal(file["voltage"][2000:], self.signal.samples)
            assert (file.attrs["periods"], file.attrs["sample_rate"]) == (2, 250e3)

    def test_what_cannot_be_written(self, tmp_path):
        with refusing(ScanError, "out-of-range", "drive.path"):
            write_drive(self.signal, tmp_path / "a.mp3")
        with refusing(ScanError, "out-of-range", "drive.periods"):
            write_drive(self.signal, tmp_path / "a.csv", periods=0)
        odd = drive(low=1e3, high=8e3, sample_rate=22050.5, duration=0.01)
        with refusing(ScanError, "out-of-range", "drive.sample_rate"):
            write_drive(odd, tmp_path / "a.wav")


PLATE = Rectangle(0.0, 0.0, 0.140, 0.127)


class TestPlan:
    def test_the_papers_grid(self):
        plan = scan_plan(PLATE, 2e-3)
        # 71 x 64 points, "about 4500"
        assert len(plan.points) == 71 * 64
        assert plan.travel == pytest.approx(2e-3 * (71 * 64 - 1))
        assert plan.points.mean(axis=0) == pytest.approx([0.070, 0.0635])

    @given(
        st.lists(
            st.one_of(
                st.builds(RoundRegion, st.floats(0, 0.14), st.floats(0, 0.12), st.floats(1e-3, 0.05)),
                st.builds(
                    Rectangle,
                    st.floats(0, 0.1),
                    st.floats(0, 0.1),
                    st.floats(1e-3, 0.1),
                    st.floats(1e-3, 0.1),
                ),
            ),
            max_size=5,
        )
    )
    def test_every_point_once_and_none_excluded(self, excluded):
        whole = scan_plan(PLATE, 5e-3)
        plan = scan_plan(PLATE, 5e-3, excluded)
        for region in excluded:
            assert not region.holds(plan.points).any()
        both = np.vstack([plan.points, plan.left_out])
        assert len(np.unique(np.rint(both * 1e9), axis=0)) == len(both) == len(whole.points)
        for place in plan.left_out:
            assert any(region.holds(place[None]).any() for region in excluded)

    def test_the_way_is_much_shorter_than_row_by_row(self):
        pillars = [
            RoundRegion(7e-3 * (i + 0.5), 7e-3 * (j + 0.5), 3.5e-3) for i in range(20) for j in range(3)
        ]
        plan = scan_plan(PLATE, 2e-3, pillars)
        assert len(plan.left_out) > 100
        sorted_points = plan.points[np.lexsort(plan.points.T)]
        assert plan.travel < 0.6 * np.linalg.norm(np.diff(sorted_points, axis=0), axis=1).sum()

    def test_along_the_longer_side(self):
        tall = scan_plan(Rectangle(0, 0, 0.01, 0.05), 5e-3)
        assert np.all(tall.points[:11, 0] == tall.points[0, 0])
        assert np.diff(tall.points[:11, 1]) == pytest.approx(np.full(10, 5e-3))

    @pytest.mark.parametrize(
        ("area", "step", "excluded", "code", "argument", "given"),
        [
            (PLATE, 0.0, [], "out-of-range", "scan_plan.step", ""),
            (PLATE, float("nan"), [], "out-of-range", "scan_plan.step", ""),
            (Rectangle(0, 0, -1, 1), 2e-3, [], "out-of-range", "scan_plan.area.width", ""),
            (PLATE, 2e-3, [PLATE], "out-of-range", "scan_plan.excluded", "1 regions"),
        ],
    )
    def test_refused(self, area, step, excluded, code, argument, given):
        with pytest.raises(ScanError) as caught:
            scan_plan(area, step, excluded)
        assert_explained(caught.value, given, code=code, argument=argument)


def test_a_disc_has_its_rim_and_nothing_beyond():
    disc = RoundRegion(1.0, 2.0, 0.5)
    points = np.array([[1.25, 2.0], [1.0, 1.75], [1.2501, 2.0], [1.2, 2.2]])
    assert disc.holds(points).tolist() == [True, True, False, False]
