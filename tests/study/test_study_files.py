"""Files that cannot be read, each with an error that gives the reason."""

import os
from pathlib import Path

import pytest
import xarray as xr

from five_parts import refusing
from haptonic.errors import StudyError
from haptonic.study import load, loads


class TestUnreadableFiles:
    @staticmethod
    def refused(path, code) -> StudyError:
        with refusing(StudyError, code, "study") as caught:
            load(path)
        return caught.value

    def test_no_such_file_suggests_a_similar_one(self, tmp_path, reference_text):
        (tmp_path / "touchpad.toml").write_text(reference_text)
        error = self.refused(tmp_path / "touchpd.toml", "not-found")
        assert str(tmp_path / "touchpad.toml") in error.next_step

    def test_no_vaguely_similar_file_is_suggested(self, tmp_path, reference_text):
        (tmp_path / "tc.toml").write_text(reference_text)
        for name in ("nosuch.toml", "x.toml"):
            assert self.refused(tmp_path / name, "not-found").next_step == "check the path"
        assert "tc.toml" in self.refused(tmp_path / "tc.tml", "not-found").next_step

    def test_a_broken_link_is_not_suggested_as_a_file(self, tmp_path):
        (tmp_path / "linked.toml").symlink_to(tmp_path / "gone.toml")
        assert "linked.toml" not in self.refused(tmp_path / "linked.toml", "not-found").next_step

    def test_no_such_folder(self, tmp_path):
        error = self.refused(tmp_path / "none" / "study.toml", "not-found")
        assert f"{tmp_path / 'none'} " in error.next_step

    def test_folder(self, tmp_path, reference_text):
        (tmp_path / "touchpad.toml").write_text(reference_text)
        assert "touchpad.toml" in self.refused(tmp_path, "unreadable").next_step

    @pytest.mark.parametrize(
        "head", [b"title = 'x'\n", b"\x89PNG\r\n\x1a\n", b"\x89HDF\r\n\x1a\n", b"PK\x03\x04\xff", b"CDF\x01"]
    )
    def test_binary(self, tmp_path, head):
        path = tmp_path / "study.toml"
        path.write_bytes(head + b"\x00\x01")
        self.refused(path, "malformed")

    def test_not_utf8_names_the_line(self, tmp_path):
        path = tmp_path / "study.toml"
        path.write_bytes(b"# ok\n# caf\xe9\n")
        assert "line 2" in self.refused(path, "encoding").cause

    def test_utf16(self, tmp_path, reference_text):
        path = tmp_path / "study.toml"
        path.write_text(reference_text, encoding="utf-16")
        self.refused(path, "encoding")

    def test_too_large(self, tmp_path):
        path = tmp_path / "study.toml"
        path.write_text("#" * 1_000_001)
        self.refused(path, "too-large")

    def test_path_that_no_system_has(self):
        self.refused("study\0.toml", "malformed")

    @pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may read everything")
    def test_no_permission(self, tmp_path):
        path = tmp_path / "study.toml"
        path.write_text("title = 'x'")
        path.chmod(0)
        self.refused(path, "forbidden")

    def test_no_permission_as_the_system_reports_it(self, tmp_path, monkeypatch):
        def denied(*args, **kwargs):
            raise PermissionError(13, "Permission denied")

        monkeypatch.setattr("pathlib.Path.open", denied)
        self.refused(tmp_path / "study.toml", "forbidden")


class TestStudiesInResults:
    def test_a_result_contains_its_study(self, tmp_path, reference_text):
        path = tmp_path / "touchpad.toml"
        path.write_text(reference_text)
        study = load(path)
        result = study.with_keys({"bands.accuracy": 1e-2, "bands.count": 4, "bands.points": 10}).bands()
        result.write(tmp_path / "answer")
        again = load(tmp_path / "answer" / "bands.nc")
        assert again == study.with_keys({"bands.accuracy": 1e-2, "bands.count": 4, "bands.points": 10})
        assert again.bands().dataset.attrs["inputs"] == result.dataset.attrs["inputs"]

    def test_a_netcdf_file_of_others_is_refused(self, tmp_path):
        xr.Dataset({"x": ("n", [1.0])}).to_netcdf(tmp_path / "other.nc", engine="h5netcdf")
        with refusing(StudyError, "missing", "study"):
            load(tmp_path / "other.nc")

    def test_the_file_of_its_cell_is_found_above_the_result(self, tmp_path, monkeypatch):
        (tmp_path / "cell.step").touch()
        folder = tmp_path / "results" / "bands"
        folder.mkdir(parents=True)
        solid = '[cell]\npitch = "7 mm"\nthickness = "1 mm"\n[cell.solid]\nfile = "cell.step"\n'
        text = f'material = "steel"\n{solid}'
        xr.Dataset(attrs={"study": text}).to_netcdf(folder / "bands.nc", engine="h5netcdf")
        for place in (tmp_path, folder, tmp_path.parent):
            monkeypatch.chdir(place)
            assert Path(load(folder / "bands.nc").cell.solid.file).resolve() == tmp_path / "cell.step"

    def test_the_geometry_of_a_file_cannot_be_swept(self, tmp_path):
        (tmp_path / "cell.step").touch()
        text = f"""
            material = "steel"
            cell = {{ pitch = "7 mm", thickness = "1 mm", solid = {{ file = "{tmp_path / "cell.step"}" }} }}
            sweep = [{{ vary = "cell.pitch", from = "6 mm", to = "8 mm", steps = 3 }}]
        """
        with refusing(StudyError, "unknown", "sweep[1].vary"):
            loads(text)
