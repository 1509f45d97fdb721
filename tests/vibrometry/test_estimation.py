"""Frequency responses from records: a known oscillator, noise with its known bias, and bad records."""

from __future__ import annotations

import json

import numpy as np
import pyFRF
import pytest
import scipy.signal
from hypothesis import given, strategies as st
from scans import X, Y

from five_parts import assert_explained, refusing
from haptonic.errors import ScanError
from haptonic.response import Reference
from haptonic.vibrometry import InMemory, TimeScan, estimate
from haptonic.vibrometry.estimation.quality import clipped_share

RATE, SAMPLES = 200e3, 2000
LINES = np.fft.rfftfreq(SAMPLES, 1 / RATE)
NATURAL, LOSS, GAIN = 2 * np.pi * 20e3, 0.004, 1e5


def mobility(frequency, extra: float = 0.0):
    """Velocity per volt of one oscillator; ``extra`` damps its pole by as much (1/s)."""
    s = 2j * np.pi * frequency + extra
    return GAIN * s / (s**2 + 2 * LOSS * NATURAL * s + NATURAL**2)


def recorded(reference, response, **changes) -> TimeScan:
    points = len(response)
    keywords = {"sample_rate": RATE, "reference": Reference("A1", "V")} | changes
    names = tuple(str(i) for i in range(points))
    return TimeScan(
        InMemory(reference, response), names, X[:points], Y[:points], *response.shape[1:], **keywords
    )


def periodic(repeats=6, points=2, seed=1):
    """A drive of random phases that repeats, and the steady answer of the oscillator to it."""
    chance = np.random.default_rng(seed)
    spectrum = np.exp(2j * np.pi * chance.random((points, repeats, len(LINES))))
    spectrum[..., 0] = spectrum[..., -1] = 0
    drive = np.fft.irfft(spectrum, n=SAMPLES)
    return drive, np.fft.irfft(spectrum * mobility(LINES), n=SAMPLES)


class TestExact:
    @pytest.mark.parametrize("estimator", ["H1", "H2", "Hv"])
    def test_without_noise_all_estimators_give_the_oscillator(self, estimator):
        estimated = estimate(recorded(*periodic()), estimator=estimator, band=(1e3, 90e3))
        expected = mobility(estimated.response.frequency)
        assert estimated.response.values[..., 0] == pytest.approx(np.stack([expected] * 2, axis=1), rel=1e-9)
        assert estimated.response.dataset["coherence"].values.min() > 1 - 1e-9
        assert estimated.response.units == "m/s/V"
        assert (estimated.averages, estimated.quality.flags) == (6, ((), ()))

    def test_band_and_lines_without_a_drive(self):
        estimated = estimate(recorded(*periodic())).response
        # 0 Hz never, and half the rate is not driven here
        assert estimated.frequency == pytest.approx(LINES[1:-1])
        estimated = estimate(recorded(*periodic()), band=(10e3, 30e3))
        assert estimated.response.frequency == pytest.approx(LINES[100:301])
        assert estimated.report.remarks == ()

    def test_scales_and_motions(self):
        drive, moved = periodic()
        plain = estimate(recorded(drive, moved), band=(1e3, 90e3)).response
        scaled = estimate(
            recorded(drive / 2, moved * 5, response_scale=0.2, reference_scale=2.0), band=(1e3, 90e3)
        ).response
        assert scaled.values == pytest.approx(plain.values, rel=1e-12)
        twice = estimate(recorded(drive, moved, motion="acceleration"), band=(1e3, 90e3)).response
        omega = 2 * np.pi * plain.frequency[:, None, None]
        assert twice.values * 1j * omega == pytest.approx(plain.values, rel=1e-12)
        moved_by = estimate(recorded(drive, moved, motion="displacement"), band=(1e3, 90e3)).response
        assert moved_by.dataset.attrs["quantity"] == "displacement"
        assert moved_by.values == pytest.approx(plain.values, rel=1e-12)
        assert plain.displacement().values * 1j * omega == pytest.approx(plain.values, rel=1e-12)

    def test_integers_and_single_precision(self):
        drive, moved = periodic()
        steps = [np.abs(signal).max() / 32000 for signal in (drive, moved)]
        whole = [
            np.rint(signal / step).astype(np.int16)
            for signal, step in zip((drive, moved), steps, strict=True)
        ]
        scan = recorded(*whole, reference_scale=steps[0], response_scale=steps[1], full_scale=32767.0)
        estimated = estimate(scan, band=(15e3, 25e3))
        assert estimated.response.values.dtype == np.complex64
        exact = mobility(estimated.response.frequency)[:, None, None]
        # the noise of 16 bits over 6 averages
        assert np.abs(estimated.response.values - exact).max() < 2e-3 * np.abs(exact).max()

    def test_one_average_has_no_coherence(self):
        drive, moved = periodic(repeats=1)
        estimated = estimate(recorded(drive, moved), band=(1e3, 90e3))
        assert "coherence" not in estimated.response.dataset
        assert "one average only" in estimated.report.remarks[0]

    def test_one_reference_for_all_points(self):
        drive, moved = periodic(points=1)
        estimated = estimate(recorded(drive, np.repeat(moved, 3, axis=0)), band=(1e3, 90e3)).response
        assert estimated.values[:, 2, 0] == pytest.approx(mobility(estimated.frequency), rel=1e-9)

    def test_the_response_of_others(self):
        """Hann, half overlap, random drive: the numbers of scipy.signal."""
        chance = np.random.default_rng(2)
        drive = chance.normal(size=(2, 1, 5000))
        moved = scipy.signal.lfilter([1, 0.3], [1, -1.6, 0.9], drive) + 0.1 * chance.normal(size=drive.shape)
        settings = {"fs": RATE, "nperseg": 500, "noverlap": 250, "window": "hann", "detrend": False}
        _, xx = scipy.signal.welch(drive[:, 0], **settings)
        _, yy = scipy.signal.welch(moved[:, 0], **settings)
        _, xy = scipy.signal.csd(drive[:, 0], moved[:, 0], **settings)
        common = {"window": "hann", "segment": 500, "overlap": 0.5, "band": (400, 99e3)}
        lines = slice(1, 248)
        expected = {"H1": xy / xx, "H2": yy / xy.conj(), "Hv": xy / np.abs(xy) * np.sqrt(yy / xx)}
        for estimator, theirs in expected.items():
            ours = estimate(recorded(drive, moved), estimator=estimator, **common).response
            assert pytest.approx(theirs[:, lines], rel=1e-10) == ours.values[..., 0].T
            _, coherence = scipy.signal.coherence(drive[:, 0], moved[:, 0], **settings)
            assert pytest.approx(coherence[:, lines], rel=1e-10) == ours.dataset["coherence"].values.T

    def noisy_pair(self):
        """Whole periods with noise on both channels."""
        drive, moved = periodic(repeats=12, points=1, seed=7)
        chance = np.random.default_rng(8)
        return [signal + 0.2 * signal.std() * chance.normal(size=signal.shape) for signal in (drive, moved)]

    def of_pyfrf(self, drive, moved, estimator):
        return pyFRF.FRF(
            int(RATE), exc=drive.reshape(1, -1), resp=moved.reshape(1, -1), exc_type="f", resp_type="d",
            window="none", fft_len=SAMPLES, nperseg=SAMPLES, noverlap=0, frf_estimator=estimator,
        )  # fmt: skip

    @pytest.mark.parametrize("estimator", ["H1", "H2"])
    def test_the_response_of_pyfrf(self, estimator):
        drive, moved = self.noisy_pair()
        theirs, band = self.of_pyfrf(drive, moved, estimator), slice(1, SAMPLES // 2)
        response = estimate(recorded(drive, moved), estimator=estimator, band=(LINES[1], LINES[-2])).response
        assert response.frequency == pytest.approx(theirs.get_f_axis()[band])
        assert np.abs(response.values[:, 0, 0] / theirs.get_FRF()[0, 0, band] - 1).max() < 1e-10
        coherence = response.dataset["coherence"].values[:, 0]
        assert np.abs(coherence / theirs.get_coherence()[0, band] - 1).max() < 1e-10
        assert coherence.mean() < 0.95

    def test_the_hv_of_pyfrf(self):
        """Theirs takes both channels for equally noisy in their units, ours in units of equal strength.

        So a line is the same where the units give the channels the same power at that line.
        """
        drive, moved = self.noisy_pair()
        response = estimate(recorded(drive, moved), estimator="Hv", band=(LINES[1], LINES[-2])).response
        h1, h2 = (self.of_pyfrf(drive, moved, name).get_FRF()[0, 0] for name in ("H1", "H2"))
        for line in (3, 30, 99, 100, 101, 170):
            gain = 1 / np.sqrt(np.abs(h1[line] * h2[line]))
            theirs = self.of_pyfrf(drive, gain * moved, "Hv").get_FRF()[0, 0, line] / gain
            assert abs(response.values[line - 1, 0, 0] / theirs - 1) < 1e-10


class TestNoise:
    """With noise on one channel, one estimator is right and the other wrong by the coherence [bendat2010]."""

    def noisy(self, on: str, repeats=400, level=0.5):
        drive, moved = periodic(repeats=repeats, points=1, seed=4)
        chance = np.random.default_rng(5)
        rms = {"response": moved.std(), "reference": drive.std()}[on]
        noise = level * rms * chance.normal(size=drive.shape)
        pair = (drive, moved + noise) if on == "response" else (drive + noise, moved)
        responses = {
            name: estimate(recorded(*pair), estimator=name, band=(18e3, 22e3)).response
            for name in ("H1", "H2", "Hv")
        }
        true = mobility(responses["H1"].frequency)
        ratios = {name: np.abs(response.values[:, 0, 0] / true) for name, response in responses.items()}
        return ratios, responses["H1"].dataset["coherence"].values[:, 0]

    def test_on_the_response(self):
        ratio, coherence = self.noisy("response")
        assert coherence.min() < 0.99
        # 400 averages: the standard error is sqrt((1 - c) / (2 c n))
        error = np.sqrt((1 - coherence) / (2 * coherence * 400))
        assert np.mean(np.abs(ratio["H1"] - 1) < 2 * error) > 0.9
        assert ratio["H2"] == pytest.approx(ratio["H1"] / coherence, rel=1e-9)
        assert ratio["Hv"] == pytest.approx(ratio["H1"] / np.sqrt(coherence), rel=1e-9)
        assert np.mean(ratio["H2"]) > 1.02

    def test_on_the_reference(self):
        ratio, coherence = self.noisy("reference")
        true_coherence = 1 / (1 + 0.25)
        assert np.mean(coherence) == pytest.approx(true_coherence, rel=0.02)
        assert np.mean(ratio["H2"]) == pytest.approx(1, abs=0.01)
        assert np.mean(ratio["H1"]) == pytest.approx(true_coherence, rel=0.02)

    def test_the_error_falls_with_the_root_of_the_averages(self):
        errors = []
        for repeats in (8, 32, 128, 512):
            drive, moved = periodic(repeats=repeats, points=1, seed=repeats)
            moved = moved + 0.3 * moved.std() * np.random.default_rng(repeats).normal(size=moved.shape)
            response = estimate(recorded(drive, moved), band=(5e3, 50e3)).response
            errors.append(
                np.sqrt(np.mean(np.abs(response.values[:, 0, 0] - mobility(response.frequency)) ** 2))
            )
        slope = np.polyfit(np.log([8, 32, 128, 512]), np.log(errors), 1)[0]
        assert slope == pytest.approx(-0.5, abs=0.05)


class TestBursts:
    """A click, and a ring-down that outlasts the record."""

    def ringing(self, delay=0):
        longer = 64 * SAMPLES
        click = np.zeros(longer)
        click[10:13] = (0.5, 1.0, 0.5)
        lines = np.fft.rfftfreq(longer, 1 / RATE)
        answer = np.fft.irfft(np.fft.rfft(click) * mobility(lines), n=longer)
        return tuple(np.roll(signal, delay)[:SAMPLES][None, None] for signal in (click, answer))

    def test_the_exponential_window_moves_the_pole_exactly(self):
        decay = SAMPLES / RATE / 8
        response = estimate(
            recorded(*self.ringing()), window="exponential", decay=decay, band=(5e3, 60e3)
        ).response
        expected = mobility(response.frequency, extra=1 / decay)
        error = np.abs(response.values[:, 0, 0] - expected).max() / np.abs(expected).max()
        assert error < 1e-5  # of the ring-down exp(-13) is left at the end
        plain = estimate(recorded(*self.ringing()), band=(5e3, 60e3)).response
        leaky = np.abs(plain.values[:, 0, 0] - mobility(plain.frequency)).max()
        assert leaky > 5e-3 * np.abs(mobility(plain.frequency)).max()

    def test_alignment_brings_late_records_to_the_first(self):
        decay = SAMPLES / RATE / 8
        pairs = [self.ringing(delay) for delay in (0, 300, 77)]
        drive = np.concatenate([pair[0] for pair in pairs])
        answer = np.concatenate([pair[1] for pair in pairs])
        settings = {"window": "exponential", "decay": decay, "band": (15e3, 25e3)}
        response = estimate(recorded(drive, answer), align=True, **settings).response
        first = response.values[:, 0, 0]
        # around the end comes what was lost before the trigger: nothing but silence
        assert response.values[:, 1, 0] == pytest.approx(first, rel=1e-3)
        assert response.values[:, 2, 0] == pytest.approx(first, rel=1e-3)

    def test_the_lag_is_that_of_the_reference(self):
        from haptonic.vibrometry.estimation.spectra import rolled, shifts

        base = np.random.default_rng(3).normal(size=64)
        late = np.stack([np.roll(base, lag) for lag in (0, 5, -7)])[None]
        assert shifts(late, base).tolist() == [[0, 5, -7]]
        assert np.array_equal(rolled(late, shifts(late, base)), np.broadcast_to(base, (1, 3, 64)))


class TestQuality:
    def scan(self, full_scale=None):
        drive, moved = periodic(points=12, repeats=4)
        moved = moved / np.abs(moved).max()
        moved[1] = np.clip(moved[1], -0.3, 0.3)
        moved[2, 1, 500:600] = moved[2, 1, 500]
        moved[3] += 3 * np.random.default_rng(1).normal(size=moved[3].shape) * moved[3].std()
        moved[4, 0, 7] = np.nan
        moved[5] = 0.0
        return recorded(drive, moved, full_scale=full_scale)

    def test_flags(self):
        estimated = estimate(self.scan(), band=(19e3, 21e3))
        flags = dict(zip(estimated.quality.names, estimated.quality.flags, strict=True))
        assert flags["1"] == ("saturated",)
        assert flags["2"] == ("dropout",)
        assert flags["3"] == ("low coherence",)
        assert all(flags[name] == () for name in ("0", "6", "11"))
        assert [point.what for point in estimated.report.dropped] == ["point 4", "point 5"]
        assert estimated.quality.frozen[2] == pytest.approx(100 / SAMPLES)
        assert estimated.response.dataset.sizes["point"] == 10

    def test_the_full_scale_decides_where_it_is_known(self):
        estimated = estimate(self.scan(full_scale=0.3), band=(19e3, 21e3))
        assert estimated.quality.clipped[1] > 0
        assert "saturated" in estimated.quality.flags[1]
        assert "saturated" not in estimate(self.scan(full_scale=5.0), band=(19e3, 21e3)).quality.flags[1]

    @pytest.mark.parametrize("sign", [1, -1])
    def test_clipping_on_one_side(self, sign):
        record = sign * np.array(
            [[[0.1, 1.0, 1.0, 1.0, -0.2, 0.3, -0.9, 0.2]], [[0.1, 1.0, 0.2, 0.9, 0, 0, 0, 0]]]
        )
        assert clipped_share(record, 1.0).tolist() == [3 / 8, 1 / 8]
        assert clipped_share(record, 1.1).tolist() == [0, 0]
        # without a full scale a single peak is none, three equal ones are
        assert clipped_share(record, None).tolist() == [3 / 8, 0]

    def test_repair_is_marked(self):
        before = estimate(self.scan(), band=(19e3, 21e3))
        after = before.repaired("dropout", "saturated")
        assert json.loads(after.response.dataset.attrs["inputs"])["repaired"] == ["1", "2"]
        assert "2 points repaired" in after.response.dataset.attrs["title"]
        assert after.quality.flags[1] == ("saturated", "repaired")
        assert np.all(after.response.dataset["coherence"].values[:, [1, 2]] == 0)
        untouched = [0, 3, 4, 5, 6, 7, 8, 9]
        assert np.array_equal(after.response.values[:, untouched], before.response.values[:, untouched])
        # all good points move alike here, so their mean is what they do
        assert after.response.values[:, 1] == pytest.approx(before.response.values[:, 0], rel=1e-6)
        assert before.quality.flags[1] == ("saturated",)
        assert before.repaired("repaired") is not None

    def test_repair_refuses(self):
        estimated = estimate(self.scan(), band=(19e3, 21e3))
        with refusing(ScanError, "unknown", "flags", "dropout"):
            estimated.repaired("dropouts")
        drive, moved = periodic(points=4)
        few = estimate(recorded(drive, np.clip(moved, -1e-3, 1e-3)), band=(19e3, 21e3))
        with pytest.raises(ScanError) as caught:
            few.repaired("saturated")
        assert_explained(caught.value, code="too-few", argument="repair")


class TestStream:
    def test_a_stopped_run_goes_on(self, tmp_path):
        class Slow:
            """Counts what is asked of it, and stops at a point."""

            def __init__(self, inner, stop):
                self.inner, self.stop, self.asked = inner, stop, []

            def load(self, start, stop):
                if stop - start > 1 and stop > self.stop:
                    raise KeyboardInterrupt
                self.asked.append((start, stop))
                return self.inner.load(start, stop)

        drive, moved = periodic(points=12)
        whole = estimate(recorded(drive, moved), band=(1e3, 50e3))
        portion = 12 * 2000 * 48.0 * 6 / 4  # three points at a time

        def run(stop):
            from haptonic.vibrometry import estimation

            scan = recorded(drive, moved)
            object.__setattr__(scan, "source", Slow(scan.source, stop))
            with pytest.MonkeyPatch.context() as patch:
                patch.setattr(estimation, "WORKING_MEMORY", portion)
                return estimate(scan, band=(1e3, 50e3), state=tmp_path / "state"), scan.source.asked

        with pytest.raises(KeyboardInterrupt):
            run(stop=8)
        estimated, asked = run(stop=99)
        assert (0, 3) not in asked
        assert (6, 9) in asked
        assert np.array_equal(estimated.response.values, whole.response.values)
        assert estimated.quality.flags == whole.quality.flags
        with pytest.raises(ScanError) as caught:
            estimate(recorded(drive, moved), band=(2e3, 50e3), state=tmp_path / "state")
        assert_explained(caught.value, code="conflict", argument="state")
        with refusing(ScanError, "conflict", "state"):
            estimate(recorded(drive, 2 * moved), band=(1e3, 50e3), state=tmp_path / "state")

    def test_a_folder_of_something_else(self, tmp_path):
        (tmp_path / "thesis.tex").write_text("x")
        with refusing(ScanError, "conflict", "state"):
            estimate(recorded(*periodic()), state=tmp_path)

    def test_progress(self):
        seen = []
        estimate(recorded(*periodic()), band=(1e3, 2e3), progress=lambda done, of: seen.append((done, of)))
        assert seen[-1] == (2, 2)

    @given(st.integers(1, 12), st.integers(1, 3))
    def test_portions_do_not_matter(self, points, size):
        from haptonic.vibrometry import estimation

        drive, moved = periodic(points=points, repeats=2)
        whole = estimate(recorded(drive, moved), band=(19e3, 21e3)).response.values
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(estimation, "WORKING_MEMORY", 48.0 * 2000 * 2 * size)
            values = estimate(recorded(drive, moved), band=(19e3, 21e3)).response.values
        assert np.array_equal(values, whole)


@pytest.mark.parametrize(
    ("settings", "code", "argument", "given"),
    [
        ({"estimator": "H3"}, "unknown", "estimator", "H3"),
        ({"window": "blackman"}, "unknown", "window", "blackman"),
        ({"window": "exponential"}, "conflict", "decay", ""),
        ({"decay": 1.0}, "conflict", "decay", ""),
        ({"window": "exponential", "decay": -1.0}, "conflict", "decay", ""),
        ({"segment": 1}, "out-of-range", "segment", ""),
        ({"segment": SAMPLES + 1}, "out-of-range", "segment", ""),
        ({"overlap": 1.0}, "out-of-range", "overlap", ""),
        ({"band": (20.0, 60.0)}, "out-of-range", "band", ""),
        ({"band": (5e4, 1e4)}, "out-of-range", "band", ""),
        ({"band": (2e5, 3e5)}, "out-of-range", "band", ""),
    ],
)
def test_settings_that_do_not_fit(settings, code, argument, given):
    with pytest.raises(ScanError) as caught:
        estimate(recorded(*periodic()), **settings)
    assert_explained(caught.value, given, code=code, argument=argument)


def test_no_drive_at_all():
    drive, moved = periodic()
    with refusing(ScanError, "out-of-range", "reference"):
        estimate(recorded(0 * drive, moved))
    with refusing(ScanError, "out-of-range", "records"):
        estimate(recorded(drive, 0 * moved))
