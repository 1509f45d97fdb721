"""What a scan file leaves open: taken and listed, or asked for with the option that answers."""

from __future__ import annotations

import warnings

import h5py
import numpy as np
import pytest
from scans import LINES, VALUES, X, Y, curve, nodes, response, uff, units

from five_parts import refused
from haptonic.channels import wav
from haptonic.errors import HaptonicError
from haptonic.response import read, write
from haptonic.vibrometry import read_scan
from haptonic.vibrometry.exports import write_mat
from pace import within


def folder(path, head, rows, lines=3, below=""):
    path.mkdir(exist_ok=True)
    (path / "geometry.csv").write_text("file,x [mm],y [mm]\np1.csv,1,2\np2.csv,2,2\n")
    for name in ("p1.csv", "p2.csv"):
        text = [",".join(head), *([below] if below else []), *(",".join(map(str, row)) for row in rows)]
        (path / name).write_text("\n".join(text) + "\n")
    return path


class TestFolders:
    @pytest.mark.parametrize("beside", ["truth.json", "report.html", ".hidden"])
    def test_a_folder_with_one_scan_is_that_scan(self, tmp_path, beside):
        write(response(), tmp_path / "scan.nc")
        (tmp_path / beside).write_text("{}")
        assert np.array_equal(read_scan(tmp_path).response.values, response().values)

    def test_a_folder_with_several_scans_asks_for_one(self, tmp_path):
        write(response(), tmp_path / "a.nc")
        write_mat(response(), tmp_path / "b.mat")
        error = refused(lambda: read_scan(tmp_path), "a.nc, b.mat", code="conflict", argument="path")
        assert error.for_command().next_step == f"haptonic scan {tmp_path / 'a.nc'}"
        assert "read_scan(" in error.next_step

    def test_a_recording_is_called_what_it_is(self, tmp_path):
        wav.write(tmp_path / "a.wav", np.arange(10.0), 1000)
        refused(lambda: read_scan(tmp_path / "a.wav"), "a WAV file", code="unreadable", argument="path")


class TestUnits:
    ROWS = ((40000, 1.0, 1.5), (41000, 2.0, -1.5), (42000, 1.0, 0.5))

    def test_a_phase_without_a_unit_that_may_be_radians_is_asked_for(self, tmp_path):
        path = folder(tmp_path / "scan", ["frequency [Hz]", "amplitude [m/s/V]", "phase"], self.ROWS)
        error = refused(lambda: read_scan(path), code="missing", argument="phase_unit")
        assert "--phase-unit rad" in error.command
        value = read_scan(path, phase_unit="rad").response.values[0, 0, 0]
        assert value == pytest.approx(np.exp(1.5j))

    @pytest.mark.parametrize(
        "head",
        [
            ["frequency [furlong]", "real [m/s/V]", "imaginary"],
            ["frequency [Hz]", "real [m/s/V]", "imaginary [mm/s/V]"],
            ["frequency [Hz]", "amplitude [dB]", "phase [deg]"],
            ["frequency [Hz]", "amplitude [m/s/V]", "phase [mm]"],
        ],
    )
    def test_units_that_do_not_fit_are_refused(self, tmp_path, head):
        path = folder(tmp_path / "scan", head, self.ROWS)
        refused(lambda: read_scan(path), code="missing", argument="scan")

    def test_a_frequency_twice_with_other_values_is_a_fault(self, tmp_path):
        rows = [(40000, 1, 2), (41000, 1, 2), (40000, 1, 3)]
        path = folder(tmp_path / "scan", ["frequency", "real", "imaginary"], rows)
        refused(lambda: read_scan(path), "40000 Hz twice", code="missing", argument="scan")

    def test_a_line_twice_with_the_same_values_counts_once(self, tmp_path):
        rows = [(40000, 1, 2), (41000, 1, 2), (40000, 1, 2)]
        path = folder(tmp_path / "scan", ["frequency", "real", "imaginary"], rows)
        assert read_scan(path).response.frequency.tolist() == [40000.0, 41000.0]


class TestUniversalFiles:
    def curves(self, **changes):
        return [curve(i + 1, VALUES[:, i], **changes) for i in range(12)]

    def test_an_empty_block_is_no_damage(self, tmp_path):
        path = uff(tmp_path / "a.uff", units(), nodes(), *self.curves())
        path.write_bytes(path.read_bytes() + b"    -1\n  2412\n    -1\n    -1\n    15\n    -1\n")
        assert read_scan(path).report.complete

    def test_responses_without_coordinates_take_places(self, tmp_path):
        path = uff(tmp_path / "a.uff", units(), *self.curves()[:2])
        error = refused(lambda: read_scan(path), "no coordinates", code="missing", argument="scan")
        assert "--at" in error.command
        assert "(path, at=" in error.next_step
        response = read_scan(path, at="1 mm, 2 mm; 3 mm, 2 mm").response
        assert response.points == pytest.approx(np.array([[1e-3, 2e-3], [3e-3, 2e-3]]))
        refused(lambda: read_scan(path, at="1 mm, 2 mm"), "for 2 points", code="mismatch", argument="at")

    def test_what_is_dropped_is_counted_by_kind(self, tmp_path):
        bad = self.curves(ordinate_axis_units_lab="Pa", ordinate_spec_data_type=0)
        path = uff(tmp_path / "a.uff", units(), nodes(), *self.curves(), *bad)
        report = read_scan(path).report
        assert len(report.dropped) == 12
        lines = str(report).splitlines()
        assert sum(line.startswith("  dropped") for line in lines) == 1
        assert "and 11 more" in str(report)

    def test_several_references_are_asked_for_by_their_option(self, tmp_path):
        other = self.curves(ref_ent_name="A2")
        path = uff(tmp_path / "a.uff", units(), nodes(), *self.curves(), *other)
        error = refused(lambda: read_scan(path), code="unknown", argument="reference")
        assert error.command == f"haptonic scan {path} --reference 'A1, V'"


@pytest.mark.parametrize("at", ["1 mm", "1,2,3", "1 mm, 2 kHz", "10,5 mm", "", (), (1,), "a,b"])
def test_places_that_are_none(tmp_path, at):
    write_mat(response(), tmp_path / "a.mat")
    refused(lambda: read_scan(tmp_path / "a.mat", at=at), code="malformed", argument="at")


@pytest.mark.parametrize("name", ["a.h5", "a.nc"])
@pytest.mark.parametrize("value", [np.zeros(0), np.arange(3), np.array(["a", "b"], dtype=object), 7])
def test_a_kind_that_is_no_word(tmp_path, name, value):
    write(response(), tmp_path / name)
    with h5py.File(tmp_path / name, "r+") as file:
        file.attrs["kind"] = value
    refused(lambda: read(tmp_path / name), kind=HaptonicError)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        # as plain arrays, it is a scan with real and imaginary parts and names of directions
        assert read_scan(tmp_path / name).report.points == 12


@pytest.mark.parametrize("part", ["direction", "region", "x", "frequency", "response_real"])
def test_a_response_that_unfolds_to_gigabytes(tmp_path, part):
    write(response(region=["a"] * 12), tmp_path / "a.nc")
    with h5py.File(tmp_path / "a.nc", "r+") as file:
        del file[part]
        file.create_dataset(part, (10**8,), "u1", compression="gzip", fillvalue=7, chunks=(10**6,))
    with within(1.0):
        refused(lambda: read_scan(tmp_path / "a.nc"), code="unreadable")
        refused(lambda: read(tmp_path / "a.nc"), code="unreadable")


@pytest.mark.parametrize("part", ["frf", "frequency", "x", "y", "points", "coherence"])
def test_arrays_of_anybody_that_unfold_to_gigabytes(tmp_path, part):
    """One of 16 kB had been read for 8 s before its size was compared."""
    sets = {"frf": VALUES.T, "frequency": LINES, "x": X, "y": Y, "coherence": np.full((12, 8), 0.9)}
    if part == "points":
        sets = {name: sets[name] for name in ("frf", "frequency")}
    with h5py.File(tmp_path / "a.h5", "w") as file:
        for name, values in sets.items():
            if name != part:
                file[name] = values
        axes, chunks = ((10**7, 3), (10**6, 3)) if part == "points" else ((3 * 10**7,), (10**6,))
        file.create_dataset(part, axes, "f8", compression="gzip", fillvalue=7, chunks=chunks)
    with within(0.3):
        refused(lambda: read_scan(tmp_path / "a.h5"), kind=HaptonicError)


@pytest.mark.parametrize("side", ["rows", "columns"])
@pytest.mark.parametrize("height", [0.0, 1e-3])
def test_places_of_three_points_at_three_frequencies(tmp_path, side, height):
    """The word for the response had turned the table of the places as well."""
    few, places = VALUES[:3, :3], np.column_stack([X[:3], Y[:3], np.full(3, height)])
    with h5py.File(tmp_path / "a.h5", "w") as file:
        file["frf"] = few.T if side == "rows" else few
        file["frequency"], file["points"] = LINES[:3], places
    scan = read_scan(tmp_path / "a.h5", points_in=side)
    assert scan.response.points == pytest.approx(places[:, :2])
    assert scan.response.values[..., 0] == pytest.approx(few)
    assert any("equal heights" in remark for remark in scan.report.remarks)


def test_places_of_two_points_at_two_frequencies(tmp_path):
    with h5py.File(tmp_path / "a.h5", "w") as file:
        file["frf"], file["frequency"] = VALUES[:2, :2], LINES[:2]
        file["points"] = np.column_stack([X[:2], Y[:2]])
    error = refused(lambda: read_scan(tmp_path / "a.h5", points_in="rows"), code="conflict")
    assert "--at" in error.command
    at = f"{X[0]} m, {Y[0]} m; {X[1]} m, {Y[1]} m"
    response = read_scan(tmp_path / "a.h5", points_in="columns", at=at).response
    assert response.values[..., 0] == pytest.approx(VALUES[:2, :2])


@pytest.mark.parametrize("word", ["units", "unit", "Unit"])
def test_units_are_attributes_of_hdf5_data_sets(tmp_path, word):
    sets = {"frf": (1e3 * VALUES, "mm/s/V"), "frequency": (1e-3 * LINES, "kHz"), "x": (1e3 * X, "mm"),
            "y": (1e3 * Y, "mm")}  # fmt: skip
    with h5py.File(tmp_path / "a.h5", "w") as file:
        for name, (values, unit) in sets.items():
            file[name] = values
            file[name].attrs[word] = unit
    response = read_scan(tmp_path / "a.h5").response
    assert response.values[..., 0] == pytest.approx(VALUES)
    assert response.frequency == pytest.approx(LINES)
    assert response.points == pytest.approx(np.column_stack([X, Y]))


@pytest.mark.parametrize("side", ["rows", "columns"])
def test_as_many_points_as_frequencies(tmp_path, side):
    square, few = VALUES[:, :8], slice(0, 8)
    with h5py.File(tmp_path / "a.h5", "w") as file:
        file["frf"] = square.T if side == "rows" else square
        file["frequency"], file["x"], file["y"] = LINES, X[few], Y[few]
    error = refused(lambda: read_scan(tmp_path / "a.h5"), code="conflict", argument="frf")
    assert "--points-in rows" in error.command
    response = read_scan(tmp_path / "a.h5", points_in=side).response
    assert response.values[..., 0] == pytest.approx(square)
