"""Scans from the outside: the drive, a simulated scan in every form, whose truth the analysis has to find."""

from __future__ import annotations

import csv
import json
from itertools import product

import h5py
import numpy as np
import pytest
import scipy.io
import scipy.io.wavfile
import xarray as xr
from matplotlib.text import Text

from daily import daily
from five_parts import assert_five_parts, refused
from haptonic.analyses import scanning
from haptonic.analyses.scanning import Estimation, OnPlate, compute_scan
from haptonic.errors import HaptonicWarning
from haptonic.fields import remade, with_numbers
from haptonic.response import FrequencyResponse, read, write
from haptonic.results import write_files
from haptonic.results.scan import SimulatedScan
from haptonic.store import Store
from haptonic.study import loads
from haptonic.vibrometry import ReadReport, Scan, TimeScan, estimate, estimation, read_scan
from haptonic.vibrometry.of_settings import drive_for, plan_for, response_for
from tiny_scan import TINY

PLACES = {
    "h5": "scan.h5",
    "nc": "scan.nc",
    "uff": "scan.uff",
    "mat": "scan.mat",
    "csv": "scan",
    "tdms": "scan.tdms",
}
CHIRP = {"drive.wav", "drive.csv", "drive.h5", "drive.json", "scan_plan.csv",
         *(f"{name}.{kind}" for name in ("signal", "scan-plan") for kind in ("svg", "png"))}  # fmt: skip
PICTURES = ("average", "maps", "quality", "contrast", "velocity", "decay", "waves-WG1", "waves-WG2")
SCAN = {"response.nc", "scan.nc", "points.csv", "shape.gif",
        *(f"{name}.{kind}" for name in PICTURES for kind in ("svg", "png"))}  # fmt: skip

pytestmark = [
    pytest.mark.filterwarnings("ignore:the period of:haptonic.errors.HaptonicWarning"),
    pytest.mark.usefixtures("empty_pictures"),
]


@pytest.fixture(scope="module")
def tiny(tmp_path_factory):
    path = tmp_path_factory.mktemp("tiny") / "tiny.toml"
    path.write_text(TINY, "utf-8")
    return path


@pytest.fixture(scope="module")
def study():
    return loads(TINY)


@pytest.fixture(scope="module")
def store(store_folder):
    return Store(store_folder)


@pytest.fixture(scope="module")
def truth(study, store):
    """The plate's response at the points and lines of the scan."""
    with pytest.warns(HaptonicWarning, match="ring-down"):
        asked = response_for(study.scan_settings, 1e-3, drive_for(study.scan_settings, study.mounted_plate()))
    return study.plate(settings=asked, store=store).response


@pytest.fixture(scope="module")
def answer(truth, tmp_path_factory):
    path = tmp_path_factory.mktemp("answer") / "response.nc"
    write(truth, path)
    return path


@pytest.fixture(scope="module")
def on(study, store) -> OnPlate:
    return scanning.on_plate(study, store=store)


@pytest.fixture(scope="module")
def recorded(study, truth, store, tmp_path_factory):
    """A folder with a simulated scan in HDF5."""
    out = tmp_path_factory.mktemp("twin")
    with pytest.warns(HaptonicWarning, match="ring-down"):
        simulated = study.simulate_scan(seed=3, response=truth, store=store)
    write_files(out, simulated.files, overwrite=False)
    return out


class TestResponseInMemory:
    def test_it_is_analysed_as_its_file_is(self, study, truth, answer, store):
        of_file, of_value = study.scan(path=answer, store=store), study.scan(response=truth, store=store)
        assert np.array_equal(of_value.response.values, of_file.response.values)
        assert set(of_value.contrasts) == set(of_file.contrasts)
        for name, level in of_file.contrasts.items():
            np.testing.assert_allclose(of_value.contrasts[name], level, rtol=1e-5)
        assert of_value.report.path == "a response"

    @pytest.mark.parametrize("option", [{"unit": "mm/s/V"}, {"simulated": True}], ids=str)
    def test_an_option_of_files_is_refused(self, study, truth, option):
        refused(lambda: study.scan(response=truth, **option), code="conflict", argument=next(iter(option)))

    @pytest.mark.parametrize("both", [False, True])
    def test_a_file_or_a_response_is_needed_not_both(self, study, truth, answer, both):
        given = {"path": answer, "response": truth} if both else {}
        refused(lambda: study.scan(**given), "response=response", code="missing", argument="path")


def deviation(result, truth: dict) -> float:
    """Largest error of a contrast at any line, dB."""
    assert result.response.frequency == pytest.approx(truth["frequency_hz"], rel=1e-5)
    return max(
        float(np.nanmax(np.abs(result.contrasts[name].values - np.array(level))))
        for name, level in truth["contrast_db"].items()
    )


def hidden(result) -> float:
    """Share of lines at which noise hides a contrast."""
    return float(np.mean([np.isnan(level.values).mean() for level in result.contrasts.values()]))


def assert_same_range(measured, truth: dict) -> None:
    for edge in ("lower", "upper"):
        assert abs(getattr(measured, edge) - truth["contrast_range"][edge]) <= getattr(
            measured, f"{edge}_error"
        )


class TestChirp:
    def test_it_writes_the_drive_and_the_plan(self, inside, tiny, tmp_path):
        ran = inside("chirp", tiny, "--out", tmp_path / "out", "--json")
        assert ran.code == 0, ran.err
        assert {path.name for path in (tmp_path / "out").iterdir()} == CHIRP
        rate, samples = scipy.io.wavfile.read(tmp_path / "out" / "drive.wav")
        notes = json.loads((tmp_path / "out" / "drive.json").read_text())
        assert (rate, len(samples), notes["full_scale"]) == (200_000, 600, 60.0)
        with (tmp_path / "out" / "scan_plan.csv").open() as text:
            rows = list(csv.reader(text))
        assert rows[0] == ["point", "x (m)", "y (m)"]
        places = np.array(rows[1:], dtype=float)[:, 1:]
        assert ran.json["plan"]["points"] == len(places)
        # 28 x 10 squares of 56 x 21 mm; a clamp hides the points at 1, 3, 5 and at 1.05, 3.15 mm
        near = np.minimum(places, np.array([56e-3, 21e-3]) - places)
        assert not (near <= 5e-3).all(axis=1).any()
        assert ran.json["plan"]["left_out"] == 280 - len(places) == 4 * 3 * 2
        assert "ring-down" in ran.json["warnings"][0]

    def test_the_band_of_the_paper_reaches_half_the_rate(self, inside, tiny, tmp_path):
        path = tmp_path / "paper.toml"
        path.write_text(TINY.replace('highest = "80 kHz"', 'highest = "100 kHz"'), "utf-8")
        ran = inside("chirp", path, "--json")
        assert any("half the sample rate" in text for text in ran.json["warnings"])

    def test_a_plate_that_a_force_drives_has_a_drive_in_newtons(self, inside, tmp_path, empty_pictures):
        start, end = TINY.index("[[plate.actuator]]"), TINY.index("[scan]")
        force = '[[plate.force]]\nname = "F1"\nregion = "WG1"\ncentre = ["7 mm", "9 mm"]\nforce = "2 N"\n\n'
        path, out = tmp_path / "forced.toml", tmp_path / "out"
        path.write_text(TINY[:start] + force + TINY[end:], "utf-8")
        ran = inside("chirp", path, "--tables", "--out", out)
        assert ran.code == 0, ran.err
        assert "2 N" in ran.out
        assert (out / "drive.csv").read_text().startswith("time (s),force (N)\n")
        notes = json.loads((out / "drive.json").read_text())
        assert (notes["unit"], notes["full_scale"]) == ("N", 2.0)
        with h5py.File(out / "drive.h5") as file:
            assert np.abs(file["force"][:]).max() == 2.0
        assert "force (N)" in [text.get_text() for text in empty_pictures["signal"].findobj(Text)]

    @pytest.mark.parametrize(
        ("phase", "advice"),
        [
            ("0 deg", "drive it by the same signal, 0.5 times as large"),
            ("180 deg", "0.5 times as large and inverted"),
            ("60 deg", 'write voltage = "0 V" in the study of the scan'),
        ],
    )
    def test_it_names_its_drive_and_those_that_only_the_model_has(self, inside, tmp_path, phase, advice):
        start, end = TINY.index("[[plate.actuator]]"), TINY.index("[scan]")
        first = TINY[start:end]
        same = first.replace("A1", "A2").replace("WG1", "WG2").replace("60 V", f'30 V"\nphase = "{phase}')
        other = '[[plate.force]]\nname = "F1"\ncentre = ["7 mm", "9 mm"]\ncarrier = "70 kHz"\n\n'
        path, out = tmp_path / "two.toml", tmp_path / "out"
        path.write_text(TINY[:end] + same + other + TINY[end:], "utf-8")
        ran = inside("chirp", path, "--json", "--out", out)
        assert ran.code == 0, ran.err
        (remark,) = [text for text in ran.json["warnings"] if "the signal is for" in text]
        assert remark.startswith("the signal is for 'A1' alone, and the model of the scan also drives 'A2'")
        assert advice in remark
        assert json.loads((out / "drive.json").read_text())["drive"] == ran.json["drive"] == "A1"

    def test_without_a_plate_there_is_no_plan(self, inside, tmp_path):
        path = tmp_path / "cell.toml"
        path.write_text(TINY[: TINY.index("[plate]")], "utf-8")
        ran = inside("chirp", path, "--out", tmp_path / "out")
        assert ran.code == 0, ran.err
        assert not (tmp_path / "out" / "scan_plan.csv").exists()

    @pytest.mark.parametrize(
        ("old", "new", "code", "argument"),
        [
            ('lowest = "30 kHz"', 'lowest = "90 kHz"', "conflict", "scan.highest"),
            ('rate = "200 kHz"', 'rate = "100 kHz"', "out-of-range", "scan.highest"),
            ('record = "3 ms"', 'record = "3 us"', "out-of-range", "scan.record"),
            ("averages = 2", 'skip = "WG3"', "unknown", "scan.skip"),
            ("averages = 2", 'skip = "WG1, WG2, lattice"', "out-of-range", "excluded"),
            ("averages = 2", "averages = 0", "out-of-range", "scan.averages"),
            ("averages = 2", "avrages = 2", "unknown", "scan.avrages"),
        ],
    )
    def test_it_refuses(self, inside, tmp_path, old, new, code, argument):
        path = tmp_path / "bad.toml"
        path.write_text(TINY.replace(old, new), "utf-8")
        assert_five_parts(inside("chirp", path, "--json"), code=code, argument=argument)

    def test_a_region_is_skipped(self, study):
        both = study.scan_settings
        half = remade(study.scan_settings, skip="WG2")
        layout = study.mounted_plate().layout
        everywhere, some = (plan_for(question, study.mounted_plate()).points for question in (both, half))
        inside = (some[:, 0] > layout.x[5]) & (some[:, 0] < layout.x[7])
        assert not inside.any()
        assert (
            len(some) == len(everywhere) + 24 - 7 * 10
        )  # the clamps' points are back, seven columns are not


class TestTwin:
    @pytest.mark.parametrize(
        ("form", "kind"),
        daily(
            [
                *product(("uff", "mat"), ("time", "frf")),
                ("h5", "time"),
                ("tdms", "time"),
                ("csv", "frf"),
                ("nc", "frf"),
            ],
            ("h5", "time"),
            ("mat", "frf"),
            ("uff", "time"),
        ),
    )
    def test_the_analysis_of_every_form_finds_the_truth(
        self, inside, tiny, answer, on, store, tmp_path, form, kind
    ):
        ran = inside(
            "simulate",
            "scan",
            tiny,
            "--from",
            answer,
            "--out",
            tmp_path,
            "--format",
            form,
            f"--{kind}",
            "--json",
        )
        assert ran.code == 0, ran.err
        truth = json.loads((tmp_path / "truth.json").read_text())
        scan = read_scan(
            tmp_path / PLACES[form], unit="m/s" if kind == "time" else "m/s/V", reference="A1, V"
        )
        assert scan.report.complete
        result = compute_scan(scan, Estimation(), on, store=store)
        assert result.origin == truth["origin"] == "simulated"
        assert result.response.dataset.sizes["point"] == truth["points"]
        assert deviation(result, truth) < 0.5
        assert_same_range(result.measured, truth)

    def test_the_truth_is_found_with_any_seed(self, study, truth, on, store):
        for seed in range(3):
            with pytest.warns(HaptonicWarning, match="ring-down"):
                simulated = study.simulate_scan(seed=seed, response=truth, store=store)
            known = simulated.truth()
            result = compute_scan(_as_scan(simulated), Estimation(), on, store=store)
            assert 0 < deviation(result, known) < 0.5, seed
            assert_same_range(result.measured, known)

    def test_a_noisy_vibrometer_hides_levels_and_reported_ones_are_right(self, study, truth, on, store):
        shares = []
        for noise in (5e-5, 2e-3, 8e-3):
            loud = with_numbers(study, {"scan.noise": noise})
            with pytest.warns(HaptonicWarning, match="ring-down"):
                simulated = loud.simulate_scan(response=truth, store=store)
            result = compute_scan(_as_scan(simulated), Estimation(), on, store=store)
            assert deviation(result, simulated.truth()) < 0.5
            shares.append(hidden(result))
            assert any("noise hides the contrast" in text for text in result.undetermined) == (shares[-1] > 0)
        assert shares[0] < 0.05 < shares[1] < shares[2]

    def test_a_scan_turned_around_gives_a_doubt(self, truth, on, store):
        """The outline of the plate is the same after half a turn."""
        x, y = truth.points.T
        turned = FrequencyResponse.of(
            truth.values, frequency=truth.frequency, x=-x, y=-y, reference="A1, V", origin="simulated"
        )
        for response, is_doubtful in ((truth, False), (turned, True)):
            report = ReadReport("simulated", "memory", len(x))
            result = compute_scan(Scan(response, report), Estimation(), on, store=store)
            assert any("turned around" in text for text in result.undetermined) == is_doubtful

    def test_the_path_is_taken_out(self, study, truth, on, store):
        """Delay and low-pass of the study leave no trace in the response."""
        with pytest.warns(HaptonicWarning, match="ring-down"):
            simulated = study.simulate_scan(response=truth, store=store)
        result = compute_scan(_as_scan(simulated), Estimation(), on, store=store)
        true = simulated.true.values
        error = np.abs(result.response.values - true).max() / np.abs(true).max()
        seen = (
            np.abs(estimate(simulated.records, band=simulated.signal.band).response.values - true).max()
            / np.abs(true).max()
        )
        assert error < 0.02 < 0.3 < seen

    def test_its_truth_is_that_of_the_plate(self, study, truth, recorded):
        known = json.loads((recorded / "truth.json").read_text())
        points = np.arange(known["points"])
        assert known["origin"] == "simulated"
        assert known["seed"] == 3
        # contrast by hand, of the points that are scanned
        plan = plan_for(study.scan_settings, study.mounted_plate()).points
        name = {
            tuple(np.round(p, 6)): str(r)
            for p, r in zip(truth.points, truth.dataset["region"].values, strict=True)
        }
        values = {tuple(np.round(p, 6)): truth.values[:, i, 0] for i, p in enumerate(truth.points)}
        energy = {
            region: np.mean([np.abs(values[tuple(np.round(p, 6))].astype(complex)) ** 2
                             for p in plan if name[tuple(np.round(p, 6))] == region], axis=0)
            for region in ("WG1", "WG2")
        }  # fmt: skip
        expected = 10 * np.log10(energy["WG1"] / energy["WG2"])
        assert known["contrast_db"]["WG1 over WG2"] == pytest.approx(expected, abs=1e-4)
        assert len(points) == len(plan)

    @pytest.mark.parametrize(
        ("options", "code", "argument"),
        [
            (("--format", "nc", "--time"), "conflict", "--format"),
            (("--format", "tdms", "--frf"), "conflict", "--format"),
            (("--from", "nothing.nc"), "not-found", "file of a frequency response"),
        ],
    )
    def test_it_refuses(self, inside, tiny, tmp_path, options, code, argument):
        assert_five_parts(
            inside("simulate", "scan", tiny, "--out", tmp_path, *options), code=code, argument=argument
        )

    def test_it_refuses_a_response_of_another_scan(self, inside, tmp_path, answer):
        other = tmp_path / "other.toml"
        for old, new, word in (
            ('record = "3 ms"', 'record = "4 ms"', "lines"),
            ("averages", 'grid = "3 mm"\naverages', "grid"),
        ):
            other.write_text(TINY.replace(old, new), "utf-8")
            assert_five_parts(
                inside("simulate", "scan", other, "--from", answer, "--out", tmp_path / "out"),
                word,
                code="mismatch",
                argument="response",
            )

    def test_it_does_not_replace_a_scan(self, inside, tiny, answer, recorded):
        assert_five_parts(
            inside("simulate", "scan", tiny, "--from", answer, "--out", recorded),
            "scan.h5",
            code="repeated",
            argument="output file",
        )


class TestScan:
    def test_scan_writes_its_files_and_prints_its_results(self, inside, tiny, recorded, tmp_path):
        out = tmp_path / "out"
        ran = inside("scan", recorded / "scan.h5", tiny, "--tables", "--out", out)
        assert ran.code == 0, ran.err
        assert {path.name for path in out.iterdir()} == SCAN
        for words in (
            "256 points",
            "simulated",
            "Registered",
            "Gap in the scan (experimental)",
            "WG1 over WG2",
            "decay",
        ):
            assert words in ran.out, words
        assert read(out / "response.nc").dataset.attrs["origin"] == "simulated"
        data = xr.load_dataset(out / "scan.nc", engine="h5netcdf")
        assert data.attrs["origin"] == "simulated"
        assert {"average", "rms", "contrast", "waves", "decay"} <= set(data)
        with (out / "points.csv").open() as text:
            rows = list(csv.DictReader(text))
        assert {row["origin"] for row in rows} == {"simulated"}
        assert_five_parts(
            inside("scan", recorded / "scan.h5", tiny, "--out", out),
            "response.nc",
            code="repeated",
            argument="output file",
        )

    def test_without_a_study_it_does_what_needs_no_plate(self, inside, recorded, tmp_path):
        ran = inside("scan", recorded / "scan.h5", "--segment", "3 ms", "--out", tmp_path / "out", "--json",
                     "--at", "60 kHz")  # fmt: skip
        assert ran.code == 0, ran.err
        assert ran.json["registration"] is None
        assert ran.json["shapes"][0]["frequency_hz"] == pytest.approx(60e3)
        assert (tmp_path / "out" / "maps.png").exists()
        assert not (tmp_path / "out" / "contrast.png").exists()

    def test_corners_register_as_well(self, inside, tiny, recorded):
        # the stage has the plate's corner at 12 and 7 mm
        corners = "12 7 68 7 68 28 12 28 mm"
        ran = inside("scan", recorded / "scan.h5", tiny, "--json", "--corners", corners)
        assert ran.code == 0, ran.err
        registration = ran.json["registration"]
        assert registration["shift_m"] == pytest.approx([-12e-3, -7e-3])
        assert registration["misfit_m"] < 1e-9
        fitted = inside("scan", recorded / "scan.h5", tiny, "--json").json
        assert fitted["registration"]["shift_m"] == pytest.approx([-12e-3, -7e-3], abs=1e-6)
        assert fitted["contrast_range"] == pytest.approx(ran.json["contrast_range"])
        # two rows of cells do not distinguish a wave that decays from one that is reflected
        assert fitted["experimental_gap"]["lower"] is fitted["experimental_gap"]["upper"] is None
        assert "fewer than three rows" in fitted["experimental_gap"]["reasons"][0]

    def test_a_turned_stage_has_maps_on_the_plate(self, study, store):
        """Rows of the stage run askew over the plate; its maps show the points where they were."""
        turn, corner = np.exp(1j * np.radians(5.0)), 12e-3 + 7e-3j
        stage = np.add.outer(1j * np.arange(0, 40e-3, 1e-3), np.arange(0, 75e-3, 1e-3)).ravel()
        place = (stage - corner) * turn.conjugate()  # on the plate
        on = (place.real > 0) & (place.real < 56e-3) & (place.imag > 0) & (place.imag < 21e-3)
        lines = np.arange(50e3, 70e3, 500.0)
        louder = np.where((place.real > 7e-3) & (place.real < 21e-3), 1.0, 0.1)[on]
        seen = FrequencyResponse.of(
            (louder * np.ones((len(lines), 1)))[..., None] + 0j, frequency=lines, x=stage.real[on],
            y=stage.imag[on], reference="A1, V", origin="simulated",
        )  # fmt: skip
        corners = corner + turn * np.array([0, 56e-3, 56e-3 + 21e-3j, 21e-3j])
        seen_at = scanning.PlateInScan(corners=np.stack([corners.real, corners.imag], axis=1))
        of = scanning.on_plate(study, seen_at, store=store)
        report = ReadReport("simulated", "memory", len(seen.points))
        result = compute_scan(Scan(seen, report), Estimation(), of, store=store)
        assert result.registration.angle == pytest.approx(np.radians(-5.0))
        assert any(
            "no waves along WG1" in text and "is turned against" in text for text in result.undetermined
        )
        assert result.mapped
        image = result.figures["maps"].axes[0].images[0]
        left, right, _, _ = image.get_extent()
        shown = image.get_array() / image.norm.vmax
        columns = shown.shape[1]
        x = left + (right - left) * (np.arange(columns) + 0.5) / columns
        assert shown[:, (x > 8) & (x < 20)].min() == pytest.approx(1.0)
        assert shown[:, (x < 6) | (x > 22)].max() == pytest.approx(0.1)

    def test_an_estimation_goes_on(self, inside, tiny, recorded, on, store, tmp_path, monkeypatch):
        out = tmp_path / "out"
        monkeypatch.setattr(estimation, "WORKING_MEMORY", 48.0 * 600 * 2 * 50)  # fifty points at a time
        read = TimeScan.chunks
        stop = [200]
        seen = []

        def stops(scan, size, start=0):
            for first, *records in read(scan, size, start):
                if first == stop[0]:
                    raise KeyboardInterrupt
                seen.append(first)
                yield first, *records

        monkeypatch.setattr(TimeScan, "chunks", stops)
        ran = inside("scan", recorded / "scan.h5", tiny, "--out", out)
        assert (ran.code, seen) == (130, [0, 50, 100, 150])
        assert "run the same command to continue" in ran.err
        assert [path.name for path in out.iterdir()] == ["estimating"]
        done = json.loads((out / "estimating" / "progress.json").read_text())["done"]
        assert done >= 100  # what the two threads had in hand may be lost
        scan = read_scan(recorded / "scan.h5")
        stop[0] = -1
        again = compute_scan(scan, Estimation(), on, state=out / "estimating", store=store)
        assert seen[4:] == list(range(done, 256, 50))
        at_once = compute_scan(scan, Estimation(), on, store=store)
        assert np.array_equal(again.response.values, at_once.response.values)

    def test_bad_points_are_replaced_and_marked(self, study, truth, on, store):
        lost = with_numbers(study, {"scan.dropouts": 0.1})
        with pytest.warns(HaptonicWarning, match="ring-down"):
            simulated = lost.simulate_scan(seed=1, response=truth, store=store)
        plain = compute_scan(_as_scan(simulated), Estimation(), on, store=store)
        mended = compute_scan(_as_scan(simulated), Estimation(repair=("dropout",)), on, store=store)
        assert plain.flags["repaired"] == 0
        assert mended.flags["repaired"] == plain.flags["dropout"] > 10
        assert "repaired" in mended.response.dataset.attrs["title"]

    @pytest.mark.parametrize(
        ("arguments", "code", "argument", "given"),
        [
            (("nothing.h5",), "not-found", "path", "nothing.h5"),
            (("SCAN", "--corners", "0 0 1 1 mm"), "malformed", "--corners", ""),
            (("SCAN", "STUDY", "--corners", "0 0 1 1 mm"), "malformed", "--corners", ""),
            (("SCAN", "STUDY", "--corners", "0 0 1 0 1 1 0 1 kg"), "malformed", "--corners", ""),
            (("SCAN", "--mirrored"), "missing", "--mirrored", ""),
            (("SCAN", "--repair", "dropuot"), "unknown", "flags", "dropuot"),
            (("SCAN", "--at", "3 mm"), "malformed", "--at", ""),
            (("SCAN", "--at", "3 MHz"), "out-of-range", "frequency", "3e+06 Hz"),
            (("SCAN", "--segment", "3 s"), "out-of-range", "segment", ""),
            (("SCAN", "--window", "exponential"), "conflict", "decay", ""),
            (("SCAN", "--overlap", "1.5"), "out-of-range", "overlap", ""),
            (("SCAN", "CELL"), "missing", "plate", ""),
        ],
    )
    def test_it_refuses(self, inside, tiny, recorded, tmp_path, arguments, code, argument, given):
        cell = tmp_path / "cell.toml"
        cell.write_text(TINY[: TINY.index("[plate]")], "utf-8")
        known = {"SCAN": recorded / "scan.h5", "STUDY": tiny, "CELL": cell}
        assert_five_parts(
            inside("scan", *(known.get(arg, arg) for arg in arguments), "--json"),
            given,
            code=code,
            argument=argument,
        )

    def test_a_scan_of_another_plate_is_reported(self, inside, tiny, tmp_path, recorded):
        other = tmp_path / "other.toml"
        other.write_text(TINY.replace("rows = 3", "rows = 9"), "utf-8")
        ran = inside("scan", recorded / "scan.h5", other, "--json")
        messages = [*ran.json.get("remarks", []), str(ran.json.get("error", ""))]
        assert any("or another plate" in text for text in messages)


def _as_scan(simulated: SimulatedScan):
    """The records of a simulated scan as a file would give them."""
    return Scan(simulated.records, ReadReport("twin", "memory", len(simulated.records.names)))


@pytest.fixture(scope="module")
def own(tmp_path_factory):
    """A MATLAB file with names and units of its own, and what it holds."""
    path = tmp_path_factory.mktemp("own") / "own.mat"
    kilohertz = np.linspace(40.0, 75.0, 71)
    x, y = (axis.ravel() for axis in np.meshgrid(np.linspace(8.0, 62.0, 6), np.linspace(4.0, 30.0, 4)))
    peak = 1j * kilohertz / (52.0**2 * (1 + 0.01j) - kilohertz**2)
    response = np.sin(np.pi * x / 70.0)[:, None] * peak
    scipy.io.savemat(path, {"FRF": response, "fkHz": kilohertz, "Xmm": x, "Ymm": y})
    return path, response, x, y


class TestOwnNames:
    """A MATLAB file of somebody who has names and units of their own."""

    ASKED = ("--variables", "response=FRF, frequency=fkHz,x=Xmm,y=Ymm")
    UNITS = ("--frequency-unit", "kHz", "--length-unit", "mm")

    def test_names_and_units_are_taken_as_they_are_given(self, inside, own, tmp_path):
        path, values, x, y = own
        out = tmp_path / "out"
        ran = inside("scan", path, *self.ASKED, *self.UNITS, "--tables", "--out", out)
        assert ran.code == 0, ran.err
        assert "24 points (none flagged), 71 frequencies from 40 to 75 kHz, measured." in ran.out
        assert "52.000" in ran.out
        assert "warning" not in ran.err
        response = read(out / "response.nc")
        assert response.frequency[[0, -1]] == pytest.approx([40e3, 75e3])
        assert response.points == pytest.approx(1e-3 * np.column_stack([x, y]))
        assert pytest.approx(values) == response.values[..., 0].T
        assert response.units == "m/s/V"
        results = inside("scan", path, *self.ASKED, *self.UNITS, "--json").json
        assert (results["band_hz"], results["points"], results["units"]) == ([40e3, 75e3], 24, "m/s/V")
        assert results["shapes"][0]["frequency_hz"] == pytest.approx(52e3)
        assert results["warnings"] == []

    def test_a_warning_about_numbers_without_a_unit_names_the_options(self, inside, own):
        results = inside("scan", own[0], *self.ASKED, "--json").json
        assert results["band_hz"] == [40.0, 75.0]
        lengths, frequencies = results["warnings"]
        assert "54 m wide" in lengths
        assert "--length-unit mm" in lengths
        assert "up to 75 Hz" in frequencies
        assert "--frequency-unit kHz" in frequencies

    @pytest.mark.parametrize(
        ("options", "code", "argument", "given"),
        [
            ((), "mismatch", "own.mat: frequency", "Xmm (number, 1 x 24)"),
            (("--variables", "response=FRX"), "unknown", "variables.response", "FRX"),
            (("--variables", "answer=FRF"), "unknown", "variables.answer", ""),
            (("--variables", "response"), "malformed", "--variables", ""),
            (("--variables", "response=FRF,"), "malformed", "--variables", ""),
            ((*ASKED, "--frequency-unit", "mm"), "malformed", "frequency_unit", ""),
        ],
    )
    def test_what_does_not_name_a_variable_or_a_unit_is_refused(
        self, inside, own, options, code, argument, given
    ):
        assert_five_parts(inside("scan", own[0], *options, "--json"), given, code=code, argument=argument)
