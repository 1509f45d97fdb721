"""The simulated sensor: friction by load sharing, moments of the contact, gauges, files, clicks."""

import csv
from dataclasses import replace

import h5py
import numpy as np
import pandas as pd
import pytest
import scipy.io
import scipy.io.wavfile
from nptdms import TdmsFile

from five_parts import refused
from haptonic.channels import opened
from haptonic.fields import remade
from haptonic.friction.lubrication import Fingertip, Touch, amplitude_for, shared_friction
from haptonic.friction.metronome import END, RATE, START, clicks, write_wav
from haptonic.friction.participants import Participants
from haptonic.friction.protocol import Protocol
from haptonic.friction.simulation import Truth, explaining, film_of, people, recorded, trials
from haptonic.friction.simulation.files import WRITERS
from haptonic.friction.simulation.film import LIGHTEST
from haptonic.friction.simulation.gauges import BITS, RANGE, calibration, voltages
from haptonic.friction.simulation.strokes import ABOVE, OFF_AXIS
from haptonic.friction.trial_list import file_of, write_list

CARRIER = 58.8e3
FORCE = (0.8, 0.4)
AMPLITUDE = {"WG1": 0.95e-6, "WG2": 0.27e-6}
QUIET = Truth(Participants(noise=0.0, bias=0.0, within=0.0, drift=0.0, between=0.0, effect_between=0.0))


@pytest.fixture(scope="module")
def film():
    return film_of(AMPLITUDE, CARRIER, FORCE)


class TestFilm:
    def test_means_are_those_of_drawn_forces(self, film):
        """By Monte Carlo, the model asked at every force itself: 150 draws, three standard errors."""
        drawn = np.maximum(LIGHTEST, 0.8 + 0.4 * np.random.default_rng(0).standard_normal(150))
        amplitude = np.array(list(AMPLITUDE.values()))
        each = np.array(
            [shared_friction(amplitude, Touch(CARRIER, force), Fingertip().values) for force in drawn]
        )
        error = each.std(axis=0) / np.sqrt(len(drawn))
        assert (np.abs(each.mean(axis=0) - list(film.mean.values())) < 3 * error).all()
        for row in (0, 100):
            relative = [film.relative(guide, drawn[row]) * film.mean[guide] for guide in AMPLITUDE]
            assert relative == pytest.approx(each[row], abs=1e-3)

    def test_amplitudes_that_explain_reductions(self):
        """Over the forces of the strokes as asked for; at a single force those of `amplitude_for`."""
        asked = {"WG1": 0.55, "WG2": 0.11}
        fitted = film_of(explaining(asked, CARRIER, FORCE), CARRIER, FORCE)
        assert {guide: 1 - left for guide, left in fitted.mean.items()} == pytest.approx(asked, abs=5e-4)
        steady = explaining(asked, CARRIER, (0.8, 0.0))
        exact = amplitude_for([0.45, 0.89], Touch(CARRIER, 0.8), Fingertip().values)
        assert list(steady.values()) == pytest.approx(list(exact), rel=2e-3)

    def test_without_vibration_nothing_is_removed(self):
        still = film_of({"WG1": 0.0, "WG2": 0.0}, CARRIER, FORCE)
        assert still.mean == pytest.approx({"WG1": 1, "WG2": 1}, abs=1e-9)

    def test_every_stroke_follows_the_model_at_its_own_force(self, film):
        truth = replace(QUIET, remaining=film.mean, film=film)
        rng = np.random.default_rng(1)
        simulated = list(trials(truth, Protocol(2, 10), people(truth, 1, rng), rng))
        assert len({trial.force for trial in simulated}) > 8
        for trial in simulated:
            left = 1.0
            if trial.label.actuation == "on":
                amplitude = AMPLITUDE[trial.label.waveguide]
                left = float(shared_friction(amplitude, Touch(CARRIER, trial.force), Fingertip().values))
            assert trial.friction / truth.people.friction == pytest.approx(left, abs=1e-3)

    def test_what_cannot_be_explained_is_refused(self):
        refused(
            lambda: explaining({"WG1": 1e-6}, CARRIER, FORCE),
            code="out-of-range",
            argument="reduction on WG1",
        )
        refused(
            lambda: film_of({"WG1": 3e-4}, 1e3, FORCE),
            "300 µm",
            code="no-answer",
            argument="amplitude on WG1",
        )
        refused(lambda: film_of({"WG1": 1.0}, CARRIER, FORCE), code="out-of-range", argument="amplitude")
        refused(
            lambda: film_of({"WG1": 1e-6}, CARRIER, (8.0, 0.1)), code="out-of-range", argument="touch.force"
        )


class TestAxes:
    def test_moments_are_those_of_the_contact(self):
        """The centre of pressure, from moments alone, is where the finger is."""
        rng = np.random.default_rng(2)
        for stroke in recorded(QUIET, Protocol(2, 2), people(QUIET, 1, rng), rng):
            fx, fy, fz, tx, ty, tz = stroke.axes
            pressed = fz > 0.1
            along, across = (tx + ABOVE * fy) / fz.clip(1e-9), (ABOVE * fx - ty) / fz.clip(1e-9)
            travelled = stroke.position - stroke.position[0]
            assert np.diff(along[pressed]) == pytest.approx(np.diff(travelled[pressed]), abs=1e-9)
            side = -1 if stroke.trial.label.waveguide == "WG1" else 1
            assert across[pressed] == pytest.approx(side * OFF_AXIS)
            assert tz == pytest.approx(across * fy - along * fx, abs=1e-12)
            assert np.abs(fx).max() < 0.05 * fz.max()
            assert np.abs(along[pressed]).max() < 0.08

    def test_noise_and_friction(self):
        truth = replace(QUIET, people=remade(QUIET.people, noise=0.021, bias=0.3))
        rng = np.random.default_rng(3)
        simulated = list(recorded(truth, Protocol(2, 20), people(truth, 1, rng), rng))
        before = np.concatenate([stroke.axes[:, :200] for stroke in simulated], axis=1)
        assert before[:3].std(axis=1) == pytest.approx(0.021, rel=0.03)
        assert before[:3].mean(axis=1) == pytest.approx([0.06, -0.3, 0.3], abs=1e-3)
        for stroke in simulated[:3]:
            assert stroke.record.normal is not None
            middle = slice(500, 800)
            tangential, normal = (stroke.axes[1] + 0.3)[middle], (stroke.axes[2] - 0.3)[middle]
            assert -tangential.mean() / normal.mean() == pytest.approx(stroke.trial.friction, rel=0.02)


class TestGauges:
    def test_the_calibration_gives_the_forces_back(self):
        """To what half a step of the converter is worth."""
        matrix, rng = calibration(), np.random.default_rng(0)
        axes = np.array([1, 1, 5, 0.02, 0.02, 0.02])[:, None] * rng.uniform(-1, 1, (6, 500))
        loads = matrix @ voltages(axes, matrix)
        half = 0.5 * 2 * RANGE / 2**BITS
        worth = np.abs(matrix).sum(axis=1) * half
        assert (np.abs(loads - axes).max(axis=1) < worth).all()
        assert (np.abs(loads - axes).max(axis=1) > 0.2 * worth).all()
        assert worth[:3].max() < 0.005  # N, well below the noise of 21 mN

    def test_what_is_beyond_the_range_stays_at_its_end(self):
        matrix = calibration()
        load = np.array([0, 0, 1, 0, 0, 0])[:, None]
        assert np.abs(voltages(17 * load, matrix)).max() < RANGE
        far = voltages(300 * load, matrix)
        assert far.max() == pytest.approx(RANGE, abs=1e-3)
        assert voltages(600 * load, matrix).max() == far.max()

    def test_a_sensor_that_sees_all_axes(self):
        scaled = calibration() / np.array([1, 1, 1, 0.007, 0.007, 0.007])[:, None]
        assert np.linalg.cond(scaled) < 10
        assert (calibration() == calibration()).all()


CHANNELS = {"time": np.arange(50) / 1000, "Fz": np.linspace(0, 1, 50), "Tx": np.zeros(50), "G0": np.ones(50)}


class TestFiles:
    def read_csv(self, path):
        table = pd.read_csv(path)
        assert set(table["origin"]) == {"simulated"}
        return {name: table[name].to_numpy() for name in CHANNELS}

    def read_h5(self, path):
        with h5py.File(path) as file:
            assert file.attrs["origin"] == "simulated"
            assert file["Tx"].attrs["units"] == "N m"
            return {name: file[name][:] for name in CHANNELS}

    def read_mat(self, path):
        file = scipy.io.loadmat(path)
        assert file["origin"][0] == "simulated"
        return {name: file[name].ravel() for name in CHANNELS}

    def read_tdms(self, path):
        file = TdmsFile.read(path)
        assert file.properties["origin"] == "simulated"
        group = file.groups()[0]
        assert group["Fz"].properties["unit_string"] == "N"
        assert group["Fz"].time_track() == pytest.approx(CHANNELS["time"])
        return {name: group[name][:] for name in CHANNELS}

    @pytest.mark.parametrize("form", WRITERS)
    def test_every_format_is_read_back_and_marked_as_simulated(self, form, tmp_path):
        path = tmp_path / f"one.{form}"
        WRITERS[form](CHANNELS, path)
        channels = getattr(self, f"read_{form}")(path)
        for name, values in CHANNELS.items():
            assert channels[name] == pytest.approx(values, abs=5e-7)

    def test_the_list_of_trials(self, tmp_path):
        labels = Protocol(2, 4).order(2)
        for per, lasting, files in (("trial", None, 16), ("block", 1.2, 4)):
            path = tmp_path / f"{per}.csv"
            write_list(labels, path, suffix=".h5", per=per, origin="simulated", lasting=lasting)
            rows = list(csv.DictReader(path.read_text("utf-8").splitlines()))
            assert len({row["file"] for row in rows}) == files
            assert [int(row["order"]) for row in rows] == [*range(1, 9)] * 2
            assert {row["origin"] for row in rows} == {"simulated"}
            assert [row["file"] for row in rows] == [file_of(label, ".h5", per) for label in labels]
        assert [float(row["start"]) for row in rows[:4]] == pytest.approx([0, 1.2, 2.4, 3.6])
        assert all(float(row["stop"]) - float(row["start"]) == pytest.approx(1.2) for row in rows)


class TestMetronome:
    def test_clicks_come_when_they_should(self, tmp_path):
        """Read back: a high and a low click, a stroke apart, after every pause."""
        write_wav(clicks(5, 0.9, 1.5), tmp_path / "track.wav")
        rate, track = scipy.io.wavfile.read(tmp_path / "track.wav")
        assert rate == RATE
        assert len(track) / rate == pytest.approx(5 * 2.4 + 1.5)
        loud = np.flatnonzero(np.abs(track.astype(float)) > 0.4 * 2**15)
        onsets = loud[np.concatenate([[True], np.diff(loud) > 0.1 * rate])]
        assert onsets / rate == pytest.approx(
            np.ravel([[1.5 + 2.4 * n, 2.4 + 2.4 * n] for n in range(5)]), abs=1e-3
        )
        for number, onset in enumerate(onsets):
            spectrum = np.abs(np.fft.rfft(track[onset : onset + 800], 16_000))
            assert np.argmax(spectrum) == pytest.approx((START, END)[number % 2], abs=15)
        assert np.abs(track).max() < 2**15 - 1


@pytest.mark.parametrize("kind", WRITERS)
def test_its_files_are_read_and_marked_as_simulated(tmp_path, kind):
    samples = np.arange(12.0)
    WRITERS[kind]({"time": samples / 1000, "Fz": samples, "position": -samples}, tmp_path / f"a.{kind}")
    group = opened(tmp_path / f"a.{kind}").group("")
    assert group.simulated
    assert group["Fz"] == pytest.approx(samples)
