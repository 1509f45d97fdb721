"""MATLAB, TDMS, HDF5 and folders of CSV: what is whole is read, what is not is named."""

from __future__ import annotations

import re
import sys

import h5py
import numpy as np
import pytest
import scipy.io
from nptdms import ChannelObject, GroupObject, RootObject, TdmsWriter
from scans import LINES, VALUES, X, Y, response

from each import each
from five_parts import assert_explained, refusing
from haptonic.channels import opened
from haptonic.errors import HaptonicError, HaptonicWarning, ScanError
from haptonic.response import Reference, write
from haptonic.vibrometry import InMemory, TimeScan, read_scan, write_records

TIME = np.arange(50) / 200e3
RECORDS = np.random.default_rng(5).integers(-30000, 30000, size=(12, 3, 50)).astype(np.int16)
DRIVE = np.random.default_rng(6).integers(-30000, 30000, size=(12, 3, 50)).astype(np.int16)


def time_scan(reference=DRIVE, **changes) -> TimeScan:
    keywords = {"response_scale": 2e-6, "reference_scale": 3e-3, "full_scale": 32767.0, "start": 1e-3,
                "origin": "simulated", "title": "twin"} | changes  # fmt: skip
    names = tuple(f"P{i}" for i in range(12))
    return TimeScan(InMemory(reference, RECORDS), names, X, Y, 3, 50, 200e3, Reference("A1", "V"), **keywords)


def save_v73(path, **arrays) -> None:
    """As MATLAB lays version 7.3 out: HDF5 with reversed axes, complex numbers as pairs."""
    with h5py.File(path, "w", userblock_size=512) as file:
        for name, array in arrays.items():
            value = np.atleast_2d(array).T
            if np.iscomplexobj(value):
                pair = np.empty(value.shape, dtype=[("real", "f8"), ("imag", "f8")])
                pair["real"], pair["imag"] = value.real, value.imag
                value = pair
            file[name] = value
    with path.open("rb+") as file:
        file.write(b"MATLAB 7.3 MAT-file, Platform: GLNXA64".ljust(116))


SAVERS = {"v5": lambda path, **arrays: scipy.io.savemat(path, arrays), "v7.3": save_v73}


@pytest.fixture(params=SAVERS)
def save(request):
    return SAVERS[request.param]


class TestMatlab:
    @pytest.mark.parametrize("turned", [False, True])
    def test_usual_names_are_guessed_and_reported(self, tmp_path, save, turned):
        frf = VALUES if turned else VALUES.T
        save(
            tmp_path / "a.mat", FRF=frf, freq=LINES, X=X * 1e3, Y=Y * 1e3, coh=np.full((8, 12), 0.5), junk=1.0
        )
        scan = read_scan(tmp_path / "a.mat", unit="mm/s/V", length_unit=1e-3, reference="A1, V")
        response = scan.response
        assert response.values[..., 0] == pytest.approx(1e-3 * VALUES)
        assert response.points == pytest.approx(np.column_stack([X, Y]))
        assert response.dataset["coherence"].values == pytest.approx(np.full((8, 12), 0.5))
        assert response.units == "m/s/V"
        assert 'the variable "FRF" was used as response' in scan.report.remarks
        assert 'the variable "junk" was not used' in scan.report.remarks

    def test_named_variables_and_points_in_one_table(self, tmp_path, save):
        save(tmp_path / "a.mat", Q=VALUES, omega=LINES, P=np.column_stack([X, Y, 0 * X]))
        names = {"response": "Q", "frequency": "omega", "points": "P"}
        response = read_scan(tmp_path / "a.mat", variables=names, reference="A1, V").response
        assert response.values[..., 0] == pytest.approx(VALUES)
        assert response.points == pytest.approx(np.column_stack([X, Y]))

    def test_arrays_have_the_shape_that_matlab_shows(self, tmp_path, save):
        table = np.arange(6.0).reshape(2, 3)
        save(tmp_path / "a.mat", a=table, z=table * 1j)
        arrays = opened(tmp_path / "a.mat").group("").channels
        assert np.array_equal(arrays["a"], table)
        assert np.array_equal(arrays["z"], table * 1j)

    @pytest.mark.parametrize(
        ("lengths", "frequencies"),
        [("mm", "kHz"), (1e-3, 1e3), ("cm", "kHz"), ("inch", "MHz"), ("um", "Hz"), (1.0, "Hz")],
    )
    def test_units_are_words_or_numbers(self, tmp_path, save, lengths, frequencies):
        metre = {"mm": 1e3, "cm": 1e2, "inch": 1 / 0.0254, "um": 1e6}.get(lengths, 1 / lengths if lengths in
                (1e-3, 1.0) else 1)  # fmt: skip
        hertz = {"kHz": 1e-3, "MHz": 1e-6, "Hz": 1.0, 1e3: 1e-3}[frequencies]
        save(tmp_path / "a.mat", h=VALUES, f=hertz * LINES, x=metre * X, y=metre * Y)
        scan = read_scan(tmp_path / "a.mat", length_unit=lengths, frequency_unit=frequencies).response
        assert scan.frequency == pytest.approx(LINES)
        assert pytest.approx(np.array([X, Y])) == scan.points.T

    def test_numbers_in_unlikely_units_cause_warnings(self, tmp_path, save):
        save(tmp_path / "a.mat", h=VALUES, f=0.1 * LINES, x=1e4 * X, y=1e4 * Y)
        with pytest.warns(HaptonicWarning) as caught:
            read_scan(tmp_path / "a.mat")
        words = [re.findall(r'(\w+)="(\w+)"', str(warning.message)) for warning in caught]
        assert words == [[("length_unit", "mm")], [("frequency_unit", "kHz")]]
        read_scan(tmp_path / "a.mat", length_unit="m", frequency_unit="Hz")  # asked for: no doubt

    def test_axes_in_different_units_cause_a_warning_and_a_row_of_points_none(self, tmp_path, save):
        save(tmp_path / "a.mat", h=VALUES, f=LINES, x=X, y=1e-3 * Y)
        with pytest.warns(HaptonicWarning, match="along y; check the units of both"):
            read_scan(tmp_path / "a.mat", length_unit="m", frequency_unit="Hz")
        row = np.arange(len(X), dtype=float)
        save(tmp_path / "b.mat", h=VALUES, f=LINES, x=1e-3 * row, y=1e-6 * np.sin(row))
        read_scan(tmp_path / "b.mat", length_unit="m", frequency_unit="Hz")

    @each("unit", ["mmm", "kHz", "", "s", 0.0, -1.0, float("nan")])
    def test_units_that_are_none(self, tmp_path, save, unit):
        save(tmp_path / "a.mat", h=VALUES, f=LINES, x=X, y=Y)
        with pytest.raises(HaptonicError) as caught:
            read_scan(tmp_path / "a.mat", length_unit=unit)
        assert_explained(caught.value, code="malformed", argument="length_unit")

    def test_a_structure(self, tmp_path):
        scipy.io.savemat(tmp_path / "a.mat", {"s": {"h": VALUES.T, "f": LINES}, "x": X, "y": Y})
        names = {"response": "s.h", "frequency": "s.f"}
        assert read_scan(tmp_path / "a.mat", variables=names).response.values[..., 0] == pytest.approx(VALUES)

    @pytest.mark.parametrize("wide", [1, 2])
    def test_time_records(self, tmp_path, save, wide):
        v, drive = RECORDS[:, 0].astype(float), DRIVE[:, 0].astype(float)
        if wide == 2:
            v, drive = v.T, drive.T  # a column for each point
        save(tmp_path / "a.mat", v=v, ref=drive, fs=200e3, x=X, y=Y)
        scan = read_scan(tmp_path / "a.mat", unit="mm/s", reference="A1, V").records
        _, reference, moved = next(scan.chunks(4, start=1))
        assert np.array_equal(moved[:, 0], RECORDS[1:5, 0])
        assert np.array_equal(reference[:, 0], DRIVE[1:5, 0])
        assert (scan.response_scale, scan.sample_rate, scan.samples) == (1e-3, 200e3, 50)

    def test_holes_are_named(self, tmp_path, save):
        values, x = VALUES.T.copy(), X.copy()
        values[3, 2], x[7] = np.nan, np.nan
        save(tmp_path / "a.mat", frf=values, f=LINES, x=x, y=Y)
        scan = read_scan(tmp_path / "a.mat")
        assert scan.report.points == 10
        assert [str(point) for point in scan.report.dropped] == [
            "point 4 (row 4): 1 of its 8 numbers are not finite",
            "point 8 (row 8): no coordinates",
        ]
        assert np.isfinite(scan.response.values).all()

    def test_a_point_of_zeros_was_not_measured(self, tmp_path, save):
        values = VALUES.T.copy()
        values[3] = 0.0
        save(tmp_path / "a.mat", frf=values, f=LINES, x=X, y=Y)
        scan = read_scan(tmp_path / "a.mat")
        assert [str(point) for point in scan.report.dropped] == [
            "point 4 (row 4): all of its numbers are zero"
        ]

    def test_a_line_without_numbers_is_left_out(self, tmp_path, save):
        """Programs write 0 / 0 for a ratio of spectra at 0 Hz."""
        values = VALUES.T.copy()
        values[:, 2] = np.nan
        save(tmp_path / "a.mat", frf=values, f=LINES, x=X, y=Y)
        scan = read_scan(tmp_path / "a.mat")
        assert scan.report.points == len(X)
        assert scan.response.frequency == pytest.approx(np.delete(LINES, 2))
        assert any("1 line without a number" in text for text in scan.report.remarks)

    @pytest.mark.parametrize(
        ("arrays", "words"),
        [
            ({"f": LINES, "x": X, "y": Y}, ["response", "no such variable"]),
            ({"frf": VALUES, "f": LINES}, ["no coordinates"]),
            ({"frf": VALUES, "x": X, "y": Y}, ["neither frequencies nor"]),
            ({"frf": VALUES.real, "f": LINES, "x": X, "y": Y}, ["the phase is missing"]),
            ({"frf": VALUES[:, :9], "f": LINES, "x": X, "y": Y}, ["12 points and 8 lines"]),
            ({"frf": VALUES, "f": LINES, "x": X, "y": Y[:3]}, ["12 and 3 numbers"]),
            ({"v": VALUES.real, "fs": 1e3, "x": X, "y": Y}, ["without the record of the drive"]),
            ({"v": VALUES.real, "ref": LINES[:5], "fs": 1e3, "x": X, "y": Y}, ["12 points"]),
            ({"v": VALUES.real, "ref": LINES, "fs": 0.0, "x": X, "y": Y}, ["sample_rate"]),
        ],
    )
    def test_what_does_not_fit(self, tmp_path, save, arrays, words):
        save(tmp_path / "a.mat", **arrays)
        with pytest.raises(ScanError) as caught:
            read_scan(tmp_path / "a.mat")
        assert_explained(caught.value, *words)

    def test_a_wrong_mapping(self, tmp_path, save):
        save(tmp_path / "a.mat", frf=VALUES, f=LINES, x=X, y=Y)
        with refusing(ScanError, "unknown", "variables.response", 'write "frf"'):
            read_scan(tmp_path / "a.mat", variables={"response": "fr"})
        with refusing(ScanError, "unknown", "variables.respons"):
            read_scan(tmp_path / "a.mat", variables={"respons": "frf"})
        with refusing(ScanError, "malformed", "unit"):
            read_scan(tmp_path / "a.mat", unit="V/V")

    @pytest.mark.parametrize("content", [b"", b"hello", b"MATLAB 5.0 MAT-file" + bytes(200)])
    def test_damaged(self, tmp_path, content):
        (tmp_path / "a.mat").write_bytes(content)
        with pytest.raises(ScanError) as caught:
            read_scan(tmp_path / "a.mat")
        assert_explained(caught.value)
        assert (caught.value.given == "an empty file") == (content == b"")


def save_tdms(path, *, rate=200e3, offset=2e-3, lost=(), short=()) -> None:
    wave = {"wf_increment": 1 / rate, "wf_start_offset": offset}
    parts = [RootObject()]
    for i in range(12):
        place = {} if i in lost else {"x": X[i] * 1e3, "y": Y[i] * 1e3}
        name = f"P{i}"
        count = 40 if i in short else 50
        parts += [
            GroupObject(name, properties=place),
            ChannelObject(name, "laser", RECORDS[i, 0, :count].astype(float), wave | {"unit_string": "mm/s"}),
            ChannelObject(name, "amplifier", DRIVE[i, 0, :count].astype(float), wave | {"unit_string": "mV"}),
        ]
    with TdmsWriter(path) as writer:
        writer.write_segment(parts)


class TestTdms:
    def test_a_scan(self, tmp_path):
        save_tdms(tmp_path / "a.tdms", lost=[3], short=[5])
        scan = read_scan(tmp_path / "a.tdms", length_unit=1e-3)
        records = scan.records
        assert (records.sample_rate, records.start) == (pytest.approx(200e3), 2e-3)
        assert (records.response_scale, records.reference_scale) == (1e-3, 1e-3)
        assert records.reference == Reference("reference", "V")
        keep = [i for i in range(12) if i not in (3, 5)]
        assert records.x == pytest.approx(X[keep])
        _, reference, moved = next(records.chunks(12))
        assert np.array_equal(moved[:, 0], RECORDS[keep, 0])
        assert np.array_equal(reference[:, 0], DRIVE[keep, 0])
        assert [point.what for point in scan.report.dropped] == ["point P3", "point P5"]
        assert "40 samples" in scan.report.dropped[1].reason

    def test_without_the_package(self, tmp_path, monkeypatch):
        save_tdms(tmp_path / "a.tdms")
        monkeypatch.setitem(sys.modules, "nptdms", None)
        with pytest.raises(ScanError) as caught:
            read_scan(tmp_path / "a.tdms")
        assert_explained(caught.value, "haptonic[tdms]", code="not-installed", argument="TDMS file")

    def test_damaged(self, tmp_path):
        (tmp_path / "a.tdms").write_bytes(b"TDSm" + bytes(40))
        with pytest.raises(ScanError) as caught:
            read_scan(tmp_path / "a.tdms")
        assert_explained(caught.value)

    def test_no_point(self, tmp_path):
        save_tdms(tmp_path / "a.tdms", lost=range(12))
        with refusing(ScanError, "missing", "scan", "no properties x and y"):
            read_scan(tmp_path / "a.tdms")


class TestHdf5:
    @pytest.mark.parametrize("shared", [False, True])
    def test_round_trip(self, tmp_path, shared):
        before = time_scan(DRIVE[:1] if shared else DRIVE)
        write_records(before, tmp_path / "a.h5")
        after = read_scan(tmp_path / "a.h5").records
        for name in ("names", "repeats", "samples", "sample_rate", "reference", "motion", "reference_scale",
                     "response_scale", "full_scale", "direction", "start", "origin", "title"):  # fmt: skip
            assert getattr(after, name) == getattr(before, name), name
        assert np.array_equal(after.x, X)
        first, reference, moved = list(after.chunks(5))[1]
        assert (first, moved.dtype) == (5, np.int16)
        assert np.array_equal(moved, RECORDS[5:10])
        assert np.array_equal(reference, DRIVE[:1] if shared else DRIVE[5:10])

    def test_a_scan_that_stopped(self, tmp_path):
        write_records(time_scan(), tmp_path / "a.h5")
        with h5py.File(tmp_path / "a.h5", "r+") as file:
            file["response"].attrs["measured"] = 7
        scan = read_scan(tmp_path / "a.h5")
        assert scan.records.names == tuple(f"P{i}" for i in range(7))
        assert [point.what for point in scan.report.dropped] == [f"point P{i}" for i in range(7, 12)]

    def test_responses_in_netcdf_are_recognised(self, tmp_path):
        write(response(), tmp_path / "a.h5")
        assert np.array_equal(read_scan(tmp_path / "a.h5").response.values, response().values)

    @pytest.mark.parametrize("lost", ["x", "response", "reference", "sample_rate", "motion"])
    def test_a_part_is_missing(self, tmp_path, lost):
        write_records(time_scan(), tmp_path / "a.h5")
        with h5py.File(tmp_path / "a.h5", "r+") as file:
            del (file.attrs if lost in file.attrs else file)[lost]
        with pytest.raises(ScanError) as caught:
            read_scan(tmp_path / "a.h5")
        assert_explained(
            caught.value, "missing or damaged", code="unreadable", argument="file of time records"
        )

    @pytest.mark.parametrize("value", [np.inf, -np.inf, np.nan])
    def test_a_number_of_measured_points_that_is_none(self, tmp_path, value):
        write_records(time_scan(), tmp_path / "a.h5")
        with h5py.File(tmp_path / "a.h5", "r+") as file:
            file["response"].attrs["measured"] = value
        with refusing(ScanError, "unreadable", "file of time records", "missing or damaged"):
            read_scan(tmp_path / "a.h5")

    def test_a_later_form_and_another_motion(self, tmp_path):
        write_records(time_scan(), tmp_path / "a.h5")
        with h5py.File(tmp_path / "a.h5", "r+") as file:
            file.attrs["motion"] = "temperature"
        with refusing(ScanError, "unreadable", "file of time records", "temperature"):
            read_scan(tmp_path / "a.h5")
        with h5py.File(tmp_path / "a.h5", "r+") as file:
            file.attrs["form"] = 2
        with refusing(ScanError, "unreadable", "file of time records", "later haptonic"):
            read_scan(tmp_path / "a.h5")

    def test_cut(self, tmp_path):
        write_records(time_scan(), tmp_path / "a.h5")
        content = (tmp_path / "a.h5").read_bytes()
        (tmp_path / "a.h5").write_bytes(content[: len(content) // 2])
        with pytest.raises(ScanError) as caught:
            read_scan(tmp_path / "a.h5")
        assert_explained(caught.value)


def save_folder(path, head="frequency (Hz),real (mm/s/V),imaginary (mm/s/V),coherence", cells=None):
    path.mkdir()
    rows = ["file, x, y"]
    for i in range(12):
        table = [LINES, 1e3 * VALUES[:, i].real, 1e3 * VALUES[:, i].imag, np.full(8, 0.9)]
        lines = [",".join(repr(float(cell)) for cell in row) for row in zip(*(cells or table), strict=True)]
        (path / f"p{i}.csv").write_text("\n".join([head, *lines]) + "\n")
        rows.append(f"p{i}.csv, {X[i]!r}, {Y[i]!r}".replace("np.float64(", "").replace(")", ""))
    (path / "geometry.csv").write_text("\n".join(rows) + "\n")
    return path


class TestFolder:
    def test_a_scan(self, tmp_path):
        scan = read_scan(save_folder(tmp_path / "scan"), reference="A1, V")
        assert scan.report.complete
        assert scan.response.values[..., 0] == pytest.approx(VALUES)
        assert scan.response.frequency == pytest.approx(LINES)
        assert scan.response.points == pytest.approx(np.column_stack([X, Y]))
        assert scan.response.dataset["coherence"].values == pytest.approx(np.full((8, 12), 0.9))

    def test_amplitude_and_phase_in_khz(self, tmp_path):
        cells = [LINES / 1e3, np.full(8, 2.0), np.full(8, 90.0)]
        path = save_folder(tmp_path / "scan", "freq (kHz),amplitude (m/s),phase_deg", cells)
        response = read_scan(path).response
        assert response.values == pytest.approx(np.full((8, 12, 1), 2j))
        assert response.frequency == pytest.approx(LINES)
        assert response.units == "m/s"

    def test_what_is_broken_is_named(self, tmp_path):
        path = save_folder(tmp_path / "scan")
        (path / "p1.csv").unlink()
        (path / "p2.csv").write_text((path / "p2.csv").read_text()[:-12])
        (path / "p3.csv").write_text("a,b\n1,2\n")
        text = (path / "p4.csv").read_text().splitlines()
        text[3] = "overload," + text[3].partition(",")[2]
        (path / "p4.csv").write_text("\n".join(text))
        (path / "p5.csv").write_text("frequency,real (mm/s/V),imaginary\n")
        (path / "p6.csv").write_text("frequency,real (Pa),imaginary\n1,2,3\n")
        (path / "p7.csv").write_bytes(b"\xff\xfe\x00")
        (path / "stray.csv").write_text("x\n")
        table = (path / "geometry.csv").read_text() + "p0.csv, 1, 1\n../p0.csv, 1, 1\nlost.csv, n/a, 1\n"
        (path / "geometry.csv").write_text(table)
        scan = read_scan(path)
        keep = [0, 8, 9, 10, 11]
        assert scan.response.values[..., 0] == pytest.approx(VALUES[:, keep])
        assert scan.report.missing == ("p1.csv",)
        named = {part.what: part.reason for part in scan.report.dropped}
        assert set(named) == {f"file p{i}.csv" for i in range(2, 8)} | {
            "file stray.csv", "line 14 of geometry.csv", "line 15 of geometry.csv", "point lost.csv"
        }  # fmt: skip
        for what, word in {"file p2.csv": "cut short", "file p3.csv": "no columns", "file p4.csv": "overload",
                           "file p5.csv": "no values", "file p6.csv": "Pa"}.items():  # fmt: skip
            assert word in named[what]

    def test_no_geometry(self, tmp_path):
        with pytest.raises(ScanError) as caught:
            read_scan(tmp_path)
        assert_explained(caught.value, code="missing", argument="folder of a scan")

    def test_nothing_left(self, tmp_path):
        path = save_folder(tmp_path / "scan")
        for i in range(12):
            (path / f"p{i}.csv").write_text("")
        with pytest.raises(ScanError) as caught:
            read_scan(path)
        assert_explained(caught.value, "no line with a number", code="missing", argument="scan")


class TestOtherFiles:
    def test_polytec(self, tmp_path):
        (tmp_path / "a.svd").write_bytes(bytes(100))
        with pytest.raises(ScanError) as caught:
            read_scan(tmp_path / "a.svd")
        assert_explained(caught.value, "Polytec", code="unreadable", argument="path")

    @pytest.mark.parametrize("name", ["a.txt", "a.nc", "a.h5"])
    def test_unknown(self, tmp_path, name):
        (tmp_path / name).write_bytes(b"hello")
        with pytest.raises(ScanError) as caught:
            read_scan(tmp_path / name)
        assert_explained(caught.value, name, code="unreadable")

    def test_nothing_there(self, tmp_path):
        with refusing(ScanError, "not-found", "path", "a.uff"):
            read_scan(tmp_path / "a.uff")


class TestTimeScan:
    @pytest.mark.parametrize("change", [{"response_scale": np.nan}, {"reference_scale": 0.0}])
    def test_impossible_scales(self, change):
        with pytest.raises(ScanError) as caught:
            time_scan(**change)
        assert_explained(caught.value, next(iter(change)), code="out-of-range")

    def test_names_and_places_belong_together(self):
        with refusing(ScanError, "mismatch", "records.names", "12 and 11 coordinates"):
            TimeScan(InMemory(DRIVE, RECORDS), ("a",) * 12, X, Y[:-1], 3, 50, 1.0, Reference("A1", "V"))
