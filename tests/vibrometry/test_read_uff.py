"""Universal files: those of others, broken ones, and our own read back by pyuff."""

from __future__ import annotations

import json

import numpy as np
import pytest
import pyuff
from hypothesis import given, strategies as st
from scans import (
    DATA,
    LINES,
    VALUES,
    X,
    Y,
    curve,
    nodes,
    noise,
    response,
    uff,
    units,
    whole,
)
from sdypy import EMA

from five_parts import assert_explained, refusing
from haptonic.channels.labels import label_of, ratio_of
from haptonic.errors import ScanError
from haptonic.response import read, write
from haptonic.vibrometry import read_scan, uff_contents, write_uff

# pyuff's binary writer, which makes some of the files here, leaves them open
pytestmark = [
    pytest.mark.filterwarnings("ignore::ResourceWarning"),
    pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning"),
]

SAMPLES = sorted(DATA.glob("*.uff"))
REFUSED = {  # none of them is a scan, and why
    "1858.uff": "no measured curve",
    "Sample_UFF58b_bin.uff": "a time record",
    "binary8byte.uff": "no coordinates",
    "mesh_Oros-modal_uff15_uff2412.uff": "no measured curve",
    "non_ascii_header.uff": "does not give its point",
    "sample_dataset58_psd.uff": "power spectral density",
    "uff55_record10.uff": "mode shape",
}


class TestFilesOfOthers:
    @pytest.mark.parametrize("path", SAMPLES, ids=lambda path: path.name)
    def test_the_curves_are_those_that_pyuff_reads(self, path):
        theirs = [data_set for data_set in _sets(path) if data_set["type"] == 58]
        ours = uff_contents(path).functions
        assert len(ours) == len(theirs)
        for mine, other in zip(ours, theirs, strict=True):
            abscissa, ordinate = mine.values()
            assert np.array_equal(abscissa, other["x"])
            assert np.array_equal(ordinate, other["data"])
            assert len(ordinate) == other["num_pts"]
            unit = other["ordinate_axis_units_lab"].replace("NONE", "")
            assert mine.header.over.unit.replace("²", "\ufffd") == unit  # pyuff knows no Latin-1
            assert mine.header.response_node == other["rsp_node"]

    def test_the_points_of_a_mesh(self):
        contents = uff_contents(DATA / "mesh_Oros-modal_uff15_uff2412.uff")
        assert len(contents.nodes) == 96
        assert contents.nodes[7] == pytest.approx([-51.619, 51.619, 50.0])
        assert contents.notes.dropped == []

    @pytest.mark.parametrize("name", REFUSED)
    def test_what_is_no_scan_is_refused_with_the_reason(self, name):
        with pytest.raises(ScanError) as caught:
            read_scan(DATA / name)
        assert_explained(caught.value, name, REFUSED[name], code="missing", argument="scan")

    def test_all_samples_are_tested(self):
        assert {path.name for path in SAMPLES} == set(REFUSED)

    def test_the_code_page_of_older_instruments(self):
        (function,) = uff_contents(DATA / "non_ascii_header.uff").functions
        assert function.header.over.unit == "(1/N)*(m/s²)"

    def test_a_measured_response_comes_back(self, tmp_path):
        text = (DATA / "meas_point_1.txt").read_text().split()
        measured = np.array([complex(number) for number in text])
        lines = 0.5 * np.arange(1, len(measured) + 1)
        path = uff(tmp_path / "a.uff", units(), nodes(count=1), curve(1, measured, x=lines))
        response = read_scan(path).response
        assert response.frequency == pytest.approx(lines, rel=1e-6)
        assert response.values[:, 0, 0] == pytest.approx(measured, rel=1e-11)


def _sets(path):
    data_sets = pyuff.UFF(str(path)).read_sets()
    return data_sets if isinstance(data_sets, list) else [data_sets]


class TestAWholeScan:
    @pytest.mark.parametrize("binary", [0, 1])
    @pytest.mark.parametrize("spacing", [0, 1])
    @pytest.mark.parametrize("kind", [15, 2411])
    def test_every_form(self, tmp_path, binary, spacing, kind):
        curves = [
            curve(i + 1, VALUES[:, i], binary=binary, abscissa_spacing=spacing, n_bytes=0) for i in range(12)
        ]
        if binary:
            curves = [{k: v for k, v in data.items() if k != "n_bytes"} | {"n_bytes": 128} for data in curves]
        scan = read_scan(uff(tmp_path / "a.uff", units(), nodes(kind=kind), *curves))
        assert scan.report.complete, str(scan.report)
        assert scan.response.values[..., 0] == pytest.approx(VALUES, rel=1e-11)
        assert scan.response.frequency == pytest.approx(LINES, rel=1e-12)
        assert scan.response.points == pytest.approx(np.column_stack([X, Y]), abs=1e-9)
        assert scan.response.units == "m/s/V"
        assert scan.response.dataset.attrs["reference"] == "A1, V"
        assert scan.response.dataset.attrs["origin"] == "measured"

    @pytest.mark.parametrize("kind", [15, 2411])
    @pytest.mark.parametrize("binary", [0, 1])
    def test_all_data_sets_of_pyuff_in_one_file(self, tmp_path, kind, binary):
        """151, 164, nodes of 15 or 2411, lines of 82, curves of 58 or 58b; a mode shape of 55 is named."""
        head = pyuff.prepare_151(
            model_name="touchpad", description="a plate", db_app="haptonic", date_db_created="01-Jan-26",
            time_db_created="00:00:00", version_db1=0, version_db2=0, file_type=0,
            date_db_saved="01-Jan-26", time_db_saved="00:00:00", program="haptonic",
            date_db_written="01-Jan-26", time_db_written="00:00:00",
        )  # fmt: skip
        outline = pyuff.prepare_82(
            trace_num=1, n_nodes=4, color=0, id="outline", nodes=np.array([1, 4, 12, 9])
        )
        shape = pyuff.prepare_55(
            model_type=1, analysis_type=2, data_ch=2, spec_data_type=11, data_type=2, n_data_per_node=3,
            load_case=1, mode_n=1, freq=100.0, modal_m=1.0, modal_damp_vis=0.0, modal_damp_his=0.0,
            node_nums=np.arange(1, 13), r1=np.zeros(12), r2=np.zeros(12), r3=np.ones(12),
        )  # fmt: skip
        curves = [curve(i + 1, VALUES[:, i], binary=binary) for i in range(12)]
        path = uff(tmp_path / "all.uff", head, units(), nodes(kind=kind), outline, *curves, shape)
        scan = read_scan(path)
        assert scan.response.values[..., 0] == pytest.approx(VALUES, rel=1e-6)
        assert scan.response.points == pytest.approx(np.stack([X, Y], axis=1))
        notes = scan.response.dataset.attrs
        assert notes["title"] == "touchpad"
        assert json.loads(notes["inputs"])["lines"] == [[1, 4, 12, 9]]
        assert [str(part) for part in scan.report.dropped if "mode shape" in str(part)]

    def test_the_binary_values_may_contain_the_mark_of_an_end(self, tmp_path):
        trap = np.frombuffer(b"\n    -1\n" * 16, dtype="<f8").view(complex)
        path = uff(tmp_path / "a.uff", nodes(count=2), *(curve(i, trap, binary=1, n_bytes=0) for i in (1, 2)))
        content = path.read_bytes().replace(b"%12i%12i" % (11, 64), b"%12i%12i" % (11, 128))
        path.write_bytes(content)
        response = read_scan(path).response
        assert np.array_equal(response.values[:, 1, 0], trap)

    def test_the_other_order_of_bytes(self, tmp_path):
        path = uff(tmp_path / "a.uff", nodes(count=1), curve(1, VALUES[:, 0], binary=1))
        content, plain = path.read_bytes(), VALUES[:, 0].tobytes()
        assert plain in content
        turned = content.replace(plain, VALUES[:, 0].astype(">c16").tobytes())
        path.write_bytes(turned.replace(b"58b     1     2", b"58b     2     2"))
        assert np.array_equal(read_scan(path).response.values[:, 0, 0], VALUES[:, 0])

    def test_uneven_lines_with_touching_numbers(self, tmp_path):
        path = uff(
            tmp_path / "a.uff", nodes(count=1), curve(1, -np.abs(VALUES[:, 0]) + 0j, abscissa_spacing=0)
        )
        text = path.read_text()
        for line in text.splitlines()[-9:-1]:
            real = float(line[13:33])
            text = text.replace(line, f"{line[:13]}{real:20.13E}{'-0.0000000000000D-00':>20}")
        path.write_text(text)
        response = read_scan(path).response
        assert response.frequency == pytest.approx(LINES)
        assert response.values[:, 0, 0] == pytest.approx(-np.abs(VALUES[:, 0]), rel=1e-10)

    def test_a_drive_against_the_axis(self, tmp_path):
        response = read_scan(whole(tmp_path / "a.uff", ref_dir=-3, ref_node=4)).response
        assert response.values[..., 0] == pytest.approx(-VALUES, rel=1e-10)
        assert response.dataset.attrs["reference"] == "4z, V"

    def test_single_precision_and_fortran_numbers(self, tmp_path):
        path = whole(tmp_path / "a.uff")
        text = path.read_text()
        number = next(line for line in text.splitlines() if line.count("e") == 4)
        touching = "".join(f"{float(number[i : i + 20]):20.11e}" for i in range(0, 80, 20)).replace("e", "D")
        path.write_text(text.replace(number, touching, 1))
        assert read_scan(path).response.values[..., 0] == pytest.approx(VALUES, rel=1e-11)

    def test_units_of_the_file(self, tmp_path):
        """In mm and mN without labels: positions, velocities and forces become SI."""
        changes = {
            "ordinate_axis_units_lab": "NONE",
            "orddenom_axis_units_lab": "NONE",
            "orddenom_spec_data_type": 13,
        }
        curves = [curve(i + 1, VALUES[:, i], **changes) for i in range(12)]
        response = read_scan(uff(tmp_path / "a.uff", units(1e3, 1e3), nodes(1e3), *curves)).response
        assert response.points == pytest.approx(np.column_stack([X, Y]), abs=1e-12)
        # (mm/s)/mN is (m/s)/N
        assert response.values[..., 0] == pytest.approx(VALUES, rel=1e-10)
        assert response.units == "m/s/N"

    def test_a_contradicting_label_is_used_and_reported(self, tmp_path):
        scan = read_scan(uff(tmp_path / "a.uff", units(1e3), nodes(1e3, count=1), curve(1, VALUES[:, 0])))
        assert scan.response.values[:, 0, 0] == pytest.approx(VALUES[:, 0])
        assert any("data set 164" in remark for remark in scan.report.remarks)

    def test_missing_units_are_reported(self, tmp_path):
        scan = read_scan(uff(tmp_path / "a.uff", nodes(1e4), *(curve(1, VALUES[:, 0]),)))
        assert any("no data set 164" in remark for remark in scan.report.remarks)
        assert any("probably in mm" in remark for remark in scan.report.remarks)
        again = read_scan(tmp_path / "a.uff", length_unit=1e-4)
        assert np.all(np.abs(again.response.points) < 0.1)

    def test_accelerations_become_velocities(self, tmp_path):
        changes = {"ordinate_spec_data_type": 12, "ordinate_axis_units_lab": "g"}
        response = read_scan(whole(tmp_path / "a.uff", **changes)).response
        expected = 9.80665 * VALUES / (2j * np.pi * LINES[:, None])
        assert response.values[..., 0] == pytest.approx(expected, rel=1e-10)
        assert response.units == "m/s/V"

    def test_a_direction_against_the_axis(self, tmp_path):
        response = read_scan(whole(tmp_path / "a.uff", rsp_dir=-3)).response
        assert response.values[..., 0] == pytest.approx(-VALUES, rel=1e-10)

    def test_three_directions(self, tmp_path):
        more = [curve(i + 1, (k + 1) * VALUES[:, i], rsp_dir=k + 1) for i in range(12) for k in range(3)]
        path = uff(tmp_path / "a.uff", units(), nodes(), *more[:-1])
        scan = read_scan(path)
        assert list(scan.response.dataset["direction"].values) == ["x", "y", "z"]
        assert scan.response.values[:, 0, 1] == pytest.approx(2 * VALUES[:, 0])
        assert [str(point) for point in scan.report.dropped] == [
            "point 12: directions differ from those of the scan: z"
        ]

    def test_coherence(self, tmp_path):
        level = np.linspace(0.1, 1.0, 8)
        more = [
            curve(i + 1, level * (i + 1) / 12, func_type=6, ordinate_axis_units_lab="NONE") for i in range(12)
        ]
        curves = [curve(i + 1, VALUES[:, i]) for i in range(12)]
        response = read_scan(uff(tmp_path / "a.uff", units(), nodes(), *curves, *more)).response
        assert response.dataset["coherence"].values[:, 5] == pytest.approx(level / 2)
        less = read_scan(uff(tmp_path / "b.uff", units(), nodes(), *curves, *more[:5]))
        assert "coherence" not in less.response.dataset
        assert any("5 of 12" in remark for remark in less.report.remarks)

    def test_several_references(self, tmp_path):
        curves = [
            curve(i + 1, (k + 1) * VALUES[:, i], ref_ent_name=f"A{k + 1}")
            for i in range(12)
            for k in range(2)
        ]
        path = uff(tmp_path / "a.uff", units(), nodes(), *curves)
        with pytest.raises(ScanError) as caught:
            read_scan(path)
        assert_explained(caught.value, code="unknown", argument="reference")
        with refusing(ScanError, "unknown", "reference"):
            read_scan(path, reference="A3")
        assert read_scan(path, reference="A2").response.values[..., 0] == pytest.approx(2 * VALUES)

    def test_shapes_over_frequency(self, tmp_path):
        """Data set 55, frequency response: one shape for each line; the directions at rest are left out."""
        shapes = [
            {"type": 55, "model_type": 1, "analysis_type": 5, "data_ch": 2, "spec_data_type": 11,
             "load_case": 0, "freq_step_n": k, "freq": LINES[k], "node_nums": np.arange(1, 13),
             "r1": 0j * VALUES[k], "r2": 0j * VALUES[k], "r3": VALUES[k], "n_data_per_node": 3,
             "data_type": 5}
            for k in range(8)
        ]  # fmt: skip
        response = read_scan(uff(tmp_path / "a.uff", units(), nodes(), *shapes[::-1])).response
        assert response.values[..., 0] == pytest.approx(VALUES, abs=1e-4)
        assert response.units == "m/s"


class TestBrokenFiles:
    def test_cut_anywhere(self, tmp_path):
        """Whatever is left: the points that are whole are read, and every other one is named."""
        content = whole(tmp_path / "a.uff").read_bytes()
        path, counts = tmp_path / "b.uff", set()
        for cut in range(0, len(content), 997):
            path.write_bytes(content[:cut])
            try:
                scan = read_scan(path)
            except ScanError as error:
                assert_explained(error)
                continue
            points = scan.response.dataset.sizes["point"]
            counts.add(points)
            assert scan.response.values[..., 0] == pytest.approx(VALUES[:, :points], rel=1e-10)
            assert len(scan.report.missing) + len(scan.report.dropped) >= 12 - points
            assert len(scan.report.dropped) <= 1
        assert counts >= set(range(1, 12))

    def test_the_cut_curve_is_named(self, tmp_path):
        path = whole(tmp_path / "a.uff")
        path.write_bytes(path.read_bytes()[:-200])
        (dropped,) = read_scan(path).report.dropped
        assert "cut short: 6 of 8 values" in dropped.reason or "cut short" in dropped.reason
        assert "point 12" in dropped.what

    def test_a_lost_end_in_the_middle(self, tmp_path):
        path = whole(tmp_path / "a.uff")
        parts = path.read_bytes().split(b"    -1\n    -1\n")
        parts[4:6] = [parts[4][:-100] + b"\n    -1\n" + parts[5]]
        path.write_bytes(b"    -1\n    -1\n".join(parts))
        scan = read_scan(path)
        assert scan.report.points == 11
        assert len(scan.report.dropped) == 1

    def test_not_a_number(self, tmp_path):
        path = whole(tmp_path / "a.uff")
        lines = path.read_text().splitlines()
        at = [i for i, line in enumerate(lines) if line.count("e") == 4][5]  # in the second curve
        lines[at] = f"{'NaN':>20}" + lines[at][20:]
        path.write_text("\n".join(lines) + "\n")
        scan = read_scan(path)
        assert scan.report.points == 11
        assert scan.report.dropped[0].reason == "1 of its 8 numbers are not finite"

    def test_text_between_numbers(self, tmp_path):
        path = whole(tmp_path / "a.uff")
        lines = path.read_text().splitlines()
        at = [i for i, line in enumerate(lines) if line.count("e") == 4][5]
        lines[at] = f"{'overload':>20}" + lines[at][20:]
        path.write_text("\n".join(lines) + "\n")
        assert '"overload"' in read_scan(path).report.dropped[0].reason

    @pytest.mark.parametrize("kind", [15, 2411])
    def test_a_broken_node(self, tmp_path, kind):
        """The others keep their places; the point of the broken one has none."""
        curves = [curve(i + 1, VALUES[:, i]) for i in range(12)]
        path = uff(tmp_path / "a.uff", units(), nodes(kind=kind), *curves)
        lines = path.read_text().splitlines()
        at = next(i for i, line in enumerate(lines) if line.split()[:4] == ["5", "0", "0", "0"])
        if kind == 15:
            lines[at] = lines[at][:-13] + "     overflow"
        else:
            lines[at + 1] = lines[at + 1][:-25] + "                 overflow"
        path.write_text("\n".join(lines) + "\n")
        scan = read_scan(path)
        keep = [i for i in range(12) if i != 4]
        assert scan.response.points == pytest.approx(np.column_stack([X, Y])[keep], abs=1e-9)
        assert [str(part) for part in scan.report.dropped] == [
            "points (geometry): 1 that are cut short or not numbers",
            "point 5 (data set 7 (type 58)): no coordinates",
        ]

    def test_duplicates_and_strangers(self, tmp_path):
        curves = [curve(i + 1, VALUES[:, i]) for i in range(10)]
        odd = [
            curve(1, VALUES[:, 0]),
            curve(2, 3 * VALUES[:, 1]),
            curve(77, VALUES[:, 3]),
            curve(11, VALUES[:5, 3], x=LINES[:5]),
            curve(12, VALUES[:, 3], ordinate_axis_units_lab="Pa", ordinate_spec_data_type=15),
            curve(12, VALUES[:, 3], rsp_dir=5),
            curve(12, VALUES[:, 3].real),
            {"type": 58} | curve(12, VALUES[:, 3].real, func_type=2),
        ]
        scan = read_scan(uff(tmp_path / "a.uff", units(), nodes(), *curves, *odd))
        assert scan.response.values[..., 0] == pytest.approx(VALUES[:, :10], rel=1e-10)
        text = str(scan.report)
        for word in ("the same again", "other values", "no coordinates", "5 lines", '"Pa"', "a rotation",
                     "the phase is missing", "auto spectrum"):  # fmt: skip
            assert word in text, word
        assert len(scan.report.dropped) == 8
        assert scan.report.missing == ()

    def test_two_points_on_one_place(self, tmp_path):
        table = nodes()
        table["x"], table["y"] = np.append(X[:11], X[0]), np.append(Y[:11], Y[0])
        path = uff(tmp_path / "a.uff", units(), table, *(curve(i + 1, VALUES[:, i]) for i in range(12)))
        scan = read_scan(path)
        assert [str(point) for point in scan.report.dropped] == [
            "point 12 (data set 14 (type 58)): lies at the position of point 1"
        ]

    def test_mixed_quantities(self, tmp_path):
        flat = {"ordinate_spec_data_type": 8, "ordinate_axis_units_lab": "um"}
        curves = [curve(i + 1, VALUES[:, i]) for i in range(11)]
        curves.append(curve(12, VALUES[:, 11], **flat))
        scan = read_scan(uff(tmp_path / "a.uff", units(), nodes(), *curves))
        assert scan.response.values[:, 11, 0] == pytest.approx(1e-6 * 2j * np.pi * LINES * VALUES[:, 11])
        assert any("mixed" in remark for remark in scan.report.remarks)

    @pytest.mark.parametrize("content", [b"", b"\n", b"    -1\n", b"    -1\n    -1\n", b"    -1\n    58\n",
                                         b"    -1\n    58\n" + b"1 2\n" * 20,
                                         bytes(range(256)) * 9])  # fmt: skip
    def test_rubbish(self, tmp_path, content):
        (tmp_path / "a.uff").write_bytes(content)
        with pytest.raises(ScanError) as caught:
            read_scan(tmp_path / "a.uff")
        assert_explained(caught.value)

    @given(st.binary(max_size=300), st.integers(0, 4000))
    def test_anything_in_the_middle(self, tmp_path_factory, rubbish, at):
        """Either a scan of true values, or a five-part error: nothing else."""
        folder = tmp_path_factory.mktemp("uff")
        content = whole(folder / "a.uff").read_bytes()
        (folder / "a.uff").write_bytes(content[:at] + rubbish + content[at:])
        try:
            scan = read_scan(folder / "a.uff")
        except ScanError as error:
            assert_explained(error)
        else:
            assert scan.report.points <= 12


class TestTimeRecords:
    def records(self, tmp_path, **changes):
        time = np.arange(64) / 200e3
        common = {"func_type": 1, "x": time, "abscissa_spec_data_type": 17, "orddenom_axis_units_lab": "NONE",
                  "orddenom_spec_data_type": 0, "binary": 1, "n_bytes": 512}  # fmt: skip
        moving = [curve(i + 1, VALUES.real[0, i] * time, **common) for i in range(12)]
        driven = [
            curve(i + 1, (i + 1) * np.cos(1e4 * time), **common | {"ordinate_axis_units_lab": "mV",
                  "ordinate_spec_data_type": 1}) for i in range(12)
        ]  # fmt: skip
        return time, moving, driven

    def test_records_and_reference(self, tmp_path):
        time, moving, driven = self.records(tmp_path)
        path = uff(tmp_path / "a.uff", units(), nodes(), *moving, *driven)
        scan = read_scan(path).records
        assert (scan.samples, scan.repeats, len(scan.names)) == (64, 1, 12)
        assert scan.sample_rate == pytest.approx(200e3)
        assert scan.reference_scale == 1e-3
        _, reference, moved = next(scan.chunks(5, start=2))
        assert moved[:, 0] == pytest.approx(VALUES.real[0, 2:7, None] * time, rel=1e-5)
        assert reference[3, 0] == pytest.approx(6 * np.cos(1e4 * time), rel=1e-5, abs=1e-5)

    def test_one_reference_for_all(self, tmp_path):
        _, moving, driven = self.records(tmp_path)
        scan = read_scan(uff(tmp_path / "a.uff", units(), nodes(), *moving, driven[0])).records
        assert next(scan.chunks(5))[1].shape == (1, 1, 64)

    def test_no_reference(self, tmp_path):
        _, moving, driven = self.records(tmp_path)
        path = uff(tmp_path / "a.uff", units(), nodes(), *moving, *driven[:5])
        with pytest.raises(ScanError) as caught:
            read_scan(path)
        assert_explained(caught.value, "5 records", code="mismatch", argument="reference channel")

    def test_the_wrong_part_is_asked_for(self, tmp_path):
        _, moving, driven = self.records(tmp_path)
        scan = read_scan(uff(tmp_path / "a.uff", units(), nodes(), *moving, driven[0]))
        with refusing(ScanError, "mismatch", "scan.response"):
            _ = scan.response
        with refusing(ScanError, "mismatch", "scan.records"):
            _ = read_scan(whole(tmp_path / "b.uff")).records


class TestWriter:
    def test_pyuff_reads_what_was_written(self, tmp_path):
        coherence = np.linspace(0, 1, 96).reshape(8, 12)
        write_uff(response(coherence=coherence, title="Größe"), tmp_path / "a.uff")
        sets = _sets(tmp_path / "a.uff")
        assert [data_set["type"] for data_set in sets] == [164, 2411] + [58] * 24
        assert sets[1]["x"].tolist() == X.tolist()
        for i, data_set in enumerate(sets[2:14]):
            assert (data_set["func_type"], data_set["rsp_node"], data_set["rsp_dir"]) == (4, i + 1, 3)
            assert data_set["data"] == pytest.approx(VALUES[:, i], rel=1e-11, abs=1e-300)
            assert data_set["x"].tolist() == LINES.tolist()
            assert (data_set["ordinate_axis_units_lab"], data_set["orddenom_axis_units_lab"]) == ("m/s", "V")
        assert sets[14]["data"] == pytest.approx(coherence[:, 0], rel=1e-11)

    def test_sdypy_reads_what_was_written(self, tmp_path):
        """Curves of responses alone, and not those of coherence; it cuts at a line of ours."""
        write_uff(response(coherence=np.ones((8, 12))), tmp_path / "a.uff")
        model = EMA.Model(lower=LINES[0], upper=LINES[-2])
        model.read_uff(str(tmp_path / "a.uff"))
        assert model.frf_form == "mobility"
        assert model.frf.shape[0] == len(X)
        assert len(model.freq) >= len(LINES) - 2
        assert np.array_equal(model.freq, LINES[: len(model.freq)])
        assert np.abs(model.frf.T - VALUES[: len(model.freq)]).max() < 1e-11 * np.abs(VALUES).max()

    @pytest.mark.parametrize("quantity", ["velocity", "displacement"])
    @pytest.mark.parametrize("reference", ["A1, V", "F1, N", ""])
    def test_round_trip(self, tmp_path, quantity, reference):
        ours = response(quantity=quantity, reference=reference, origin="simulated", title="twin")
        write_uff(ours, tmp_path / "a.uff")
        scan = read_scan(tmp_path / "a.uff")
        assert scan.report.complete
        assert scan.report.remarks == ()
        assert scan.response.values == pytest.approx(ours.values, rel=1e-11)
        assert np.array_equal(scan.response.points, ours.points)
        assert scan.response.units == ours.units
        assert scan.response.dataset.attrs["reference"] == reference
        assert scan.response.dataset.attrs["origin"] == "simulated"

    def test_written_twice_is_the_same(self, tmp_path):
        write_uff(response(), tmp_path / "a.uff")
        write_uff(read_scan(tmp_path / "a.uff").response, tmp_path / "b.uff")
        assert (tmp_path / "a.uff").read_text() == (tmp_path / "b.uff").read_text()

    def test_lines_that_six_digits_cannot_give_are_written_out(self, tmp_path):
        lines = np.array([100.0, 207.0, 300.0, 400.0, 500.0, 600.0, 700.0, 800.0])
        write_uff(response(frequency=lines), tmp_path / "a.uff")
        assert read_scan(tmp_path / "a.uff").response.frequency == pytest.approx(lines, rel=1e-12)

    def test_evenly_spaced_lines_are_written_by_their_spacing(self, tmp_path):
        write_uff(response(), tmp_path / "a.uff")
        assert all(data_set["abscissa_spacing"] == 1 for data_set in _sets(tmp_path / "a.uff")[2:])
        lines = np.array([100.0, 207.0, 300.0, 400.0, 500.0, 600.0, 700.0, 800.0])
        write_uff(response(frequency=lines), tmp_path / "b.uff")
        assert all(data_set["abscissa_spacing"] == 0 for data_set in _sets(tmp_path / "b.uff")[2:])

    def test_points_keep_their_numbers(self, tmp_path):
        numbers = [str(7 * i + 3) for i in range(12)]
        write_uff(response(inputs={"points": numbers}), tmp_path / "a.uff")
        assert [f"{data_set['rsp_node']}" for data_set in _sets(tmp_path / "a.uff")[2:]] == numbers
        again = read_scan(tmp_path / "a.uff").response
        assert json.loads(again.dataset.attrs["inputs"])["points"] == numbers

    def test_netcdf(self, tmp_path):
        write(response(), tmp_path / "a.nc")
        assert (
            read_scan(tmp_path / "a.nc").response.values.tobytes() == read(tmp_path / "a.nc").values.tobytes()
        )

    def test_a_folder_that_is_not_there(self, tmp_path):
        with pytest.raises(ScanError) as caught:
            write_uff(response(), tmp_path / "no" / "a.uff")
        assert_explained(caught.value, code="unwritable", argument="output file")


@pytest.mark.parametrize(
    ("text", "motion", "unit", "factor"),
    [("m/s", "velocity", "m/s", 1), ("mm/s", "velocity", "m/s", 1e-3), ("µm", "displacement", "m", 1e-6),
     ("m/s²", "acceleration", "m/s^2", 1), ("m/s^2", "acceleration", "m/s^2", 1),
     ("in/s", "velocity", "m/s", 0.0254),
     ("g", "acceleration", "m/s^2", 9.80665), ("(mm/s)", "velocity", "m/s", 1e-3), ("mV", None, "V", 1e-3),
     ("NONE", None, "", 1), ("Pa", None, "Pa", 1), ("min", None, "min", 1), ("furlong", None, "furlong", 1)],
)  # fmt: skip
def test_labels(text, motion, unit, factor):
    label = label_of(text)
    assert (label.motion, label.unit) == (motion, unit)
    assert label.factor == pytest.approx(factor)


@pytest.mark.parametrize(
    ("text", "motion", "under", "factor"),
    [("m/s/V", "velocity", "V", 1), ("(mm/s)/V", "velocity", "V", 1e-3), ("m/s", "velocity", "", 1),
     ("mm/mV", "displacement", "V", 1), ("(1/N)*(m/s²)", "acceleration", "N", 1),
     ("m/s per N", "velocity", "N", 1),
     ("g²/Hz", None, "", 1), ("V/V", None, "", 1)],
)  # fmt: skip
def test_ratios(text, motion, under, factor):
    ratio = ratio_of(text)
    assert (ratio.over.motion, ratio.under.unit) == (motion, under)
    assert ratio.factor == pytest.approx(factor)


def test_noise_is_not_constant():
    assert np.ptp(noise(5).real) > 0
