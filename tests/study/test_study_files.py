"""Files that cannot be read, each with an error that says why."""

import os

import pytest

from haptonic.errors import StudyError
from haptonic.study import load


class TestUnreadableFiles:
    @staticmethod
    def refused(path) -> StudyError:
        with pytest.raises(StudyError) as caught:
            load(path)
        assert all(caught.value.parts().values())
        return caught.value

    def test_no_such_file_suggests_a_similar_one(self, tmp_path, reference_text):
        (tmp_path / "touchpad.toml").write_text(reference_text)
        error = self.refused(tmp_path / "touchpd.toml")
        assert "no such file" in error.cause
        assert "touchpad.toml" in error.next_step

    def test_a_link_to_nothing_is_not_told_its_own_name(self, tmp_path):
        (tmp_path / "linked.toml").symlink_to(tmp_path / "gone.toml")
        error = self.refused(tmp_path / "linked.toml")
        assert "link" in error.cause
        assert "linked.toml" not in error.next_step

    def test_no_such_folder(self, tmp_path):
        assert "folder does not exist" in self.refused(tmp_path / "none" / "study.toml").next_step

    def test_folder(self, tmp_path, reference_text):
        (tmp_path / "touchpad.toml").write_text(reference_text)
        error = self.refused(tmp_path)
        assert "folder" in error.cause
        assert "touchpad.toml" in error.next_step

    @pytest.mark.parametrize(
        "head", [b"title = 'x'\n", b"\x89PNG\r\n\x1a\n", b"\x89HDF\r\n\x1a\n", b"PK\x03\x04\xff", b"CDF\x01"]
    )
    def test_binary(self, tmp_path, head):
        path = tmp_path / "study.toml"
        path.write_bytes(head + b"\x00\x01")
        error = self.refused(path)
        assert "binary" in error.cause
        assert ".toml" in error.next_step

    def test_not_utf8_names_the_line(self, tmp_path):
        path = tmp_path / "study.toml"
        path.write_bytes(b"# ok\n# caf\xe9\n")
        assert "line 2" in self.refused(path).cause

    def test_utf16(self, tmp_path, reference_text):
        path = tmp_path / "study.toml"
        path.write_text(reference_text, encoding="utf-16")
        assert "UTF-16" in self.refused(path).cause

    def test_too_large(self, tmp_path):
        path = tmp_path / "study.toml"
        path.write_text("#" * 1_000_001)
        assert "larger" in self.refused(path).cause

    def test_path_that_no_system_has(self):
        assert self.refused("study\0.toml").cause

    @pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may read everything")
    def test_no_permission(self, tmp_path):
        path = tmp_path / "study.toml"
        path.write_text("title = 'x'")
        path.chmod(0)
        assert "may not be read" in self.refused(path).cause

    def test_no_permission_as_the_system_reports_it(self, tmp_path, monkeypatch):
        def denied(*args, **kwargs):
            raise PermissionError(13, "Permission denied")

        monkeypatch.setattr("pathlib.Path.open", denied)
        assert "may not be read" in self.refused(tmp_path / "study.toml").cause
