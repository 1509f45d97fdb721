"""Files of the studio: names in one folder, and nothing else, whatever a text or a name contains."""

import os
import subprocess
import sys

import pytest
from served import served

from haptonic.errors import HaptonicError
from haptonic.studio.checking import checked
from haptonic.studio.workspace import Workspace
from haptonic.study import templates

HOSTILE = [
    "../../x.toml", "/etc/x.toml", "a/b.toml", "..\\x.toml", "C:x.toml", ".hidden.toml", "x", "", "..",
    "nul\0.toml", "x" * 300 + ".toml", None, 3, ["x.toml"],
]  # fmt: skip


@pytest.mark.parametrize("name", HOSTILE, ids=lambda name: str(name)[:20])
def test_a_name_that_leads_elsewhere_is_refused(tmp_path, name):
    folder = tmp_path / "inner" / "studies"
    folder.mkdir(parents=True)
    workspace = Workspace(folder)
    for act in (lambda: workspace.read(name), lambda: workspace.write(name, "x")):
        with pytest.raises(HaptonicError):
            act()
    assert [path for path in tmp_path.rglob("*") if path.is_file()] == []


def test_a_link_out_of_the_folder_is_refused(tmp_path):
    outside, folder = tmp_path / "outside.toml", tmp_path / "studies"
    outside.write_text('title = "secret"')
    folder.mkdir()
    (folder / "link.toml").symlink_to(outside)
    workspace = Workspace(folder)
    assert workspace.names() == []
    for act in (lambda: workspace.read("link.toml"), lambda: workspace.write("link.toml", "x")):
        with pytest.raises(HaptonicError, match="leads out of the folder"):
            act()
    assert outside.read_text() == 'title = "secret"'


def test_a_folder_that_is_itself_a_link_is_the_folder(tmp_path):
    (tmp_path / "real").mkdir()
    (tmp_path / "alias").symlink_to(tmp_path / "real")
    assert Workspace(tmp_path / "alias").write("a.toml", "title = 'x'") == "a.toml"
    assert Workspace(tmp_path / "alias").names() == ["a.toml"]


@pytest.mark.parametrize("file", ["../part.step", "/etc/passwd", "sub/../../part.step"])
def test_a_study_cannot_read_a_file_outside_of_the_folder(tmp_path, file):
    text = f'material = "brass"\n[cell]\npitch = "6 mm"\n[cell.solid]\nfile = "{file}"\n'
    (problem,) = checked(text, tmp_path)["problems"]
    assert problem["code"] == "forbidden"
    assert problem["path"] == "cell.solid.file"
    assert problem["line"] == 5


@pytest.fixture(scope="module")
def studio(tmp_path_factory):
    with served(tmp_path_factory.mktemp("studies")) as running:
        yield running


CELL = str(templates()["bare-cell"])


def test_a_study_is_saved_and_opened(studio):
    assert studio.post("save", name="mine.toml", text=CELL, known=None).json["files"] == ["mine.toml"]
    opened = studio.post("open", name="mine.toml").json
    assert opened["text"] == CELL
    assert opened["problems"] == []
    assert opened["values"]["cell"]["pitch"] == "6 mm"


def test_a_file_is_replaced_if_the_page_asks_for_it(studio):
    path = studio.studio.workspace.folder / "replaced.toml"
    path.write_text("# edited", "utf-8")
    for wish in (None, False, "true"):
        assert studio.post("save", name=path.name, text="# mine", known=CELL, replace=wish).status == 422
    assert studio.post("save", name=path.name, text="# mine", known=CELL, replace=True).status == 200
    assert path.read_text("utf-8") == "# mine"


def test_a_file_that_another_program_changed_is_not_replaced(studio):
    path = studio.studio.workspace.folder / "shared.toml"
    assert studio.post("save", name="shared.toml", text=CELL, known=None).status == 200
    path.write_text(f"# edited\n{CELL}", "utf-8")
    refused = studio.post("save", name="shared.toml", text="# mine", known=CELL)
    assert refused.status == 422
    assert refused.json["error"]["code"] == "repeated"
    assert "has changed since this page" in refused.json["error"]["cause"]
    taken = studio.post("save", name="shared.toml", text="# mine", known=None)
    assert "another file of this name" in taken.json["error"]["cause"]
    assert path.read_text("utf-8").startswith("# edited")
    assert (
        studio.post("save", name="shared.toml", text=f"# both\n{CELL}", known=f"# edited\n{CELL}").status
        == 200
    )


@pytest.mark.parametrize(
    "title", ["<script>alert(1)</script>", "../../x", "\u202e\u2066", "{{ 7 * 7 }}", "x" * 900_000]
)
def test_a_hostile_title_stays_in_its_place(studio, title):
    reply = studio.post("check", text=f'title = "{title}"\n{CELL.split(chr(10), 6)[-1]}')
    assert reply.status == 200
    assert reply.headers["Content-Type"] == "application/json"
    assert reply.json["values"]["title"] == title
    assert (len(reply.json["problems"]) == 0) == (len(title) <= 200)


def test_a_title_of_ten_megabytes_is_refused(studio):
    assert studio.post("check", text=f'title = "{"x" * 10_000_000}"').status == 413
    assert (
        studio.post("save", name="big.toml", text="x" * 1_500_000, known=None).json["error"]["code"]
        == "too-large"
    )
    assert studio.ask("GET", "/").status == 200


def test_a_file_of_another_user_gives_an_error(tmp_path):
    if os.geteuid() == 0:
        pytest.skip("root may read everything")
    (tmp_path / "a.toml").write_text("x")
    (tmp_path / "a.toml").chmod(0)
    with pytest.raises(HaptonicError, match="permission"):
        Workspace(tmp_path).read("a.toml")


def test_the_link_waits_for_no_module_that_computes():
    code = "import sys, haptonic.studio.serving; print(*sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    loaded = set(done.stdout.split())
    assert "uvicorn" in loaded
    assert not loaded & {"pydantic", "haptonic.analyses", "haptonic.bloch", "haptonic.study.schema"}
