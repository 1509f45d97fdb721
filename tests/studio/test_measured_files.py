"""Measured files in the studio's folder: received whole or not at all, read by name, understood."""

import asyncio
import base64
import os
import socket
import time
from collections.abc import AsyncIterator, Callable
from pathlib import Path
from urllib.parse import urlencode

import numpy as np
import pytest
from served import Reply, Served, served

from each import each
from haptonic import read_scan
from haptonic.channels.formats import HEAD
from haptonic.errors import HaptonicError
from haptonic.studio import guard
from haptonic.studio.uploads import receive
from haptonic.studio.workspace import DEEPEST, Workspace
from haptonic.views.packed import header_of

CASES = Path(__file__).parents[1] / "data/cases"
HOSTILE = [
    "../../x.csv", "/etc/x.csv", "a/../../x.csv", "..\\x.csv", "C:x.csv", "C:/x.csv", ".hidden.csv",
    "a/.x/b.csv", "", "..", ".", "a//b.csv", "a/", "nul\0.csv", "line\n.csv", "x" * 300 + ".csv",
    "a/b/c/d.csv", "\u202e.csv",
]  # fmt: skip


@pytest.fixture(scope="module")
def studio(tmp_path_factory) -> Served:
    folder = tmp_path_factory.mktemp("inner") / "studies"
    folder.mkdir()
    with served(folder) as running:
        yield running


def upload(studio: Served, name: str, content: bytes = b"1", replace: bool = False, **headers) -> Reply:
    query = urlencode({"name": name, "replace": "1" if replace else "0"})
    return studio.ask("POST", f"/api/upload?{query}", content, **headers)


def add_case(studio: Served, case: str) -> str:
    for path in sorted((CASES / case).rglob("*")):
        if path.is_file():
            name = f"{case}/{path.relative_to(CASES / case).as_posix()}"
            assert upload(studio, name, path.read_bytes(), replace=True).status == 200
    return case


def examine(studio: Served, analysis: str, **options) -> dict:
    reply = studio.post("examine", analysis=analysis, options=options, alone=True)
    assert reply.status == 200
    return reply.json


def files_in(folder: Path) -> dict[str, bytes]:
    return {str(path): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@each("name", HOSTILE)
@each("replace", [True, False])
def test_a_hostile_name_changes_nothing(studio, name, replace):
    above = studio.studio.workspace.folder.parent
    before = files_in(above)
    reply = upload(studio, name, replace=replace)
    assert reply.status == 422
    assert reply.json["error"]["code"] == "forbidden"
    assert all(reply.json["error"][part] for part in ("argument", "allowed", "cause", "next_step"))
    assert files_in(above) == before
    with pytest.raises(HaptonicError):
        studio.studio.workspace.measurement(name)


def test_a_name_of_markup_is_only_a_name(studio):
    name = "<script>alert(1)<_script>.csv"
    assert name in upload(studio, name).json["measured"]
    assert (studio.studio.workspace.folder / name).read_bytes() == b"1"


def test_a_file_is_not_replaced_without_being_asked(studio):
    path = studio.studio.workspace.folder / "once.csv"
    assert upload(studio, "once.csv", b"first").status == 200
    refused = upload(studio, "once.csv", b"second")
    assert (refused.status, refused.json["error"]["code"]) == (422, "repeated")
    assert path.read_bytes() == b"first"
    assert upload(studio, "once.csv", b"third", replace=True).status == 200
    assert path.read_bytes() == b"third"
    assert upload(studio, "once.csv/inner.csv", replace=True).status == 422
    (studio.studio.workspace.folder / "folder.csv").mkdir()
    assert upload(studio, "folder.csv", replace=True).status == 422


@each(
    ("name", "content", "is_read"),
    [
        ("picture.png", b"\x89PNG", False),
        ("page.pdf", b"%PDF" + b"x" * 10_000, False),
        ("STUDY.TOML", b"", False),
        ("study.toml", b"title = 'x'", True),
        ("cell.STEP", b"ISO-10303-21;", True),
        ("cell.msh", b"$MeshFormat", True),
        ("scan.CSV", b"", True),
        ("scan.ascii", b"    -1\n   151\n", True),  # UFF by its first bytes
    ],
)
def test_a_file_that_nothing_reads_is_refused_before_it_is_written(tmp_path, name, content, is_read):
    seen = []

    async def parts() -> AsyncIterator[bytes]:
        for k in range(0, len(content), 3):
            yield content[k : k + 3]
            seen.append(sorted(path.name for path in tmp_path.iterdir()))

    if is_read:
        asyncio.run(receive(Workspace(tmp_path), name, parts()))
        assert (tmp_path / name).read_bytes() == content
    else:
        with pytest.raises(HaptonicError, match="reads this format") as refusal:
            asyncio.run(receive(Workspace(tmp_path), name, parts()))
        assert refusal.value.code == "unsupported"
        assert not any(seen)
        assert list(tmp_path.iterdir()) == []


def test_no_link_leads_out_of_the_folder(tmp_path):
    outside, folder = tmp_path / "outside", tmp_path / "studies"
    outside.mkdir()
    folder.mkdir()
    secret = outside / "secret.csv"
    secret.write_text("a,b\n1,2\n")
    (folder / "link.csv").symlink_to(secret)
    (folder / "linked").symlink_to(outside)
    (folder / "trials").mkdir()
    (folder / "trials/inner.csv").symlink_to(secret)
    with served(folder) as studio:
        workspace = studio.studio.workspace
        assert workspace.measured() == []
        for name in ("link.csv", "linked", "linked/secret.csv", "trials"):
            with pytest.raises(HaptonicError, match="leads out of the folder"):
                workspace.measurement(name)
            problem = examine(studio, "friction", path=name)["problem"]
            assert (problem["code"], problem["argument"]) == ("forbidden", "path")
        assert upload(studio, "linked/new.csv").status == 422
        assert upload(studio, "link.csv").status == 422
        assert upload(studio, "link.csv", b"mine", replace=True).status == 200
    assert (folder / "link.csv").read_bytes() == b"mine"
    assert secret.read_text() == "a,b\n1,2\n"
    assert [path.name for path in outside.iterdir()] == ["secret.csv"]


def test_a_file_that_is_too_large_leaves_nothing(studio, monkeypatch):
    monkeypatch.setattr(guard, "LARGEST_UPLOAD", 4_000_000)
    folder = studio.studio.workspace.folder
    before = files_in(folder)
    assert upload(studio, "allowed.h5", b" " * (guard.LARGEST_BODY + 1)).status == 200
    assert upload(studio, "large.h5", b" " * 4_000_001).status == 413
    # without a length in its head
    with socket.create_connection(("127.0.0.1", studio.port), timeout=60) as raw:
        head = (
            f"POST /api/upload?name=chunks.h5 HTTP/1.1\r\nHost: 127.0.0.1:{studio.port}\r\n"
            f"Origin: {studio.origin}\r\nCookie: {studio.cookie}\r\nTransfer-Encoding: chunked\r\n\r\n"
        )
        raw.sendall(head.encode())
        chunk = b"10000\r\n" + b" " * 0x10000 + b"\r\n"
        for _ in range(4_000_000 // 0x10000 + 1):
            raw.sendall(chunk)
        assert raw.recv(100).startswith(b"HTTP/1.1 413")
    assert files_in(folder).keys() - before.keys() == {str(folder / "allowed.h5")}


def test_a_file_that_breaks_off_leaves_nothing(studio):
    folder = studio.studio.workspace.folder

    def names() -> list[str]:
        return sorted(path.name for path in folder.iterdir())

    def need(condition: Callable[[], bool]) -> None:
        end = time.monotonic() + 20
        while not condition() and time.monotonic() < end:
            time.sleep(0.02)
        assert condition()

    before = names()
    with socket.create_connection(("127.0.0.1", studio.port), timeout=60) as raw:
        head = (
            f"POST /api/upload?name=broken.h5 HTTP/1.1\r\nHost: 127.0.0.1:{studio.port}\r\n"
            f"Origin: {studio.origin}\r\nCookie: {studio.cookie}\r\nContent-Length: {3 * HEAD}\r\n\r\n"
        )
        raw.sendall(head.encode() + b" " * HEAD)  # enough for the server to see the format
        need(lambda: names() != before)  # the part that has arrived is in a file of another name
        assert not (folder / "broken.h5").exists()
    need(lambda: names() == before)


@pytest.mark.parametrize("early", [True, False])
def test_a_name_that_is_taken_before_or_while_a_file_arrives_is_kept(tmp_path, early):
    path, parts = tmp_path / "scan.csv", []

    async def content() -> AsyncIterator[bytes]:
        path.write_text("of another program")
        parts.append(1)
        yield b"mine"

    if early:
        path.write_text("of another program")
    with pytest.raises(HaptonicError, match="in the folder"):
        asyncio.run(receive(Workspace(tmp_path), "scan.csv", content()))
    assert path.read_text() == "of another program"
    assert len(parts) == (0 if early else 1)  # a refused file is not received at all
    assert [each.name for each in tmp_path.iterdir()] == ["scan.csv"]


def test_an_upload_needs_the_cookie_and_the_pages_origin(studio):
    assert upload(studio, "other.csv", cookie="").status == 403
    assert upload(studio, "other.csv", origin="http://evil.example").status == 403
    assert upload(studio, "other.csv", origin=None).status == 403
    assert not (studio.studio.workspace.folder / "other.csv").exists()


def test_files_and_their_folders_are_listed_without_hidden_ones(tmp_path):
    for name in ("scan.uff", "a/b/p.csv", "notes.txt", ".git/x.csv", "x/y/z/deep.csv", "my.toml"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("1")
    assert DEEPEST == 3
    assert Workspace(tmp_path).measured() == ["a", "scan.uff", "a/b", "a/b/p.csv"]


def test_a_folder_that_nobody_may_read_is_left_out(tmp_path):
    if os.geteuid() == 0:
        pytest.skip("root may read everything")
    (tmp_path / "closed").mkdir(mode=0)
    assert Workspace(tmp_path).measured() == []
    (tmp_path / "closed").chmod(0o700)


def test_a_scan_is_understood_before_it_is_computed(studio):
    case = add_case(studio, "scan-plain-hdf5")
    given = examine(studio, "scan", path=f"{case}/scan.h5")
    (table,) = given["answer"]["tables"]
    rows = dict(table["rows"])
    assert rows["points"] == "9, in 3 columns and 3 rows"
    assert rows["frequencies"] == "30, 40 to 60 kHz"
    assert rows["from left to right"] == "0 to 50 mm"
    assert "coordinates without a unit were read in m" in given["answer"]["remarks"]
    view = base64.b64decode(given["view"])
    assert header_of(view)["kind"] == "reading"
    assert header_of(view)["variables"]["x"]["shape"] == [9]
    scaled = examine(
        studio, "scan", path=f"{case}/scan.h5", length_unit="mm", frequency_unit="kHz", unit="mm/s/V"
    )
    rows = dict(scaled["answer"]["tables"][0]["rows"])
    assert rows["from left to right"] == "0 to 0.05 mm"
    assert rows["frequencies"] == "30, 40 to 60 MHz"


@pytest.mark.parametrize(
    ("options", "argument", "code"),
    [
        ({"length_unit": "kg"}, "length_unit", "malformed"),
        ({"unit": "furlong"}, "unit", "malformed"),
        ({"variables": "response=nope"}, "variables.response", "unknown"),
        ({"corners": "1 2 3"}, "corners", "malformed"),
        ({"path": "absent.uff"}, "path", "not-found"),
    ],
)
def test_a_wrong_answer_gives_the_five_parts_at_its_question(studio, options, argument, code):
    case = add_case(studio, "scan-plain-hdf5")
    given = examine(studio, "scan", **{"path": f"{case}/scan.h5", **options})
    assert given["answer"] is None
    problem = given["problem"]
    assert (problem["argument"], problem["code"]) == (argument, code)
    assert all(problem[part] for part in ("given", "allowed", "cause", "next_step"))


def test_columns_are_named_and_the_scan_is_right(studio):
    case = add_case(studio, "scan-names-of-other-languages")
    problem = examine(studio, "scan", path=case)["problem"]
    assert "variables=" in problem["next_step"]
    assert "Realteil" in problem["given"]
    names = "frequency=Frequenz,real=Realteil,imaginary=Imaginärteil"
    number = studio.post("run", analysis="scan", options={"path": case, "variables": names}, alone=True).json[
        "number"
    ]
    job = studio.finished(number)
    assert job["state"] == "done"
    assert job["command"] == f"haptonic scan {case} --html --variables '{names}'"
    assert job["alone"] is True
    content = studio.post("product", number=number, kind="file", name="response.nc").content
    path = studio.studio.workspace.folder / "measured.nc"
    path.write_bytes(content)
    measured, expected = (read_scan(each).response for each in (path, CASES / case / "expected"))
    assert np.allclose(measured.values, expected.values, rtol=1e-5)


def test_trials_are_understood_and_their_friction_is_right(studio):
    case = add_case(studio, "friction-names-f-x")
    rows = dict(examine(studio, "friction", path=case)["answer"]["tables"][0]["rows"])
    assert rows["normal channel"] == '"F_z", 1 unit = 1 N'
    assert rows["sampling rate"] == "500 Hz"
    number = studio.post("run", analysis="friction", options={"path": case}, alone=True).json["number"]
    answer = studio.finished(number)["answer"]
    table = next(table for table in answer["tables"] if table["title"].startswith("friction of each"))
    means = {row[2]: float(row[5].split()[0]) for row in table["rows"]}
    assert means["off"] == pytest.approx(0.50, abs=0.01)
    assert means["on"] == pytest.approx(0.25, abs=0.01)


def test_the_settings_of_the_page_name_the_columns_of_trials(studio):
    case = add_case(studio, "friction-without-names")
    assert "trials.sensor" in examine(studio, "friction", path=case)["problem"]["next_step"]
    text = '[trials.sensor]\nnormal = "4"\ntangential = "3"\ntime = "1"\n'
    reply = studio.post("examine", analysis="friction", options={"path": case}, text=text).json
    assert reply["problem"] is None
    rows = dict(reply["answer"]["tables"][0]["rows"])
    assert rows["normal channel"] == '"4", 1 unit = 1 N'
    number = studio.post("run", analysis="friction", options={"path": case}, text=text).json["number"]
    job = studio.finished(number)
    assert job["state"] == "done"
    assert job["command"] == f"haptonic friction {case} --html --study my.toml"


def test_a_table_of_trials_is_drafted_after_it_was_shown(studio):
    for name in ("ann_blk1_01.csv", "ann_blk1_02.csv"):
        assert upload(studio, f"drafted/{name}", b"Fz,Fy\n1,2\n", replace=True).status == 200
    assert "--draft" in examine(studio, "friction", path="drafted")["problem"]["next_step"]
    given = examine(studio, "friction", path="drafted", draft=True)["answer"]
    assert "can be written" in given["summary"][0]
    table = studio.studio.workspace.folder / "drafted/trials.csv"
    assert not table.exists()
    number = studio.post("run", analysis="friction", options={"path": "drafted", "draft": True}, alone=True)
    assert studio.finished(number.json["number"])["state"] == "done"
    assert table.is_file()


def test_an_analysis_that_needs_a_study_is_not_computed_without_one(studio):
    assert studio.post("run", analysis="bands", options={}, alone=True).status == 422
    assert studio.post("examine", analysis="bands", options={}, text="").status == 422
    assert studio.post("run", analysis="scan", options={"response": "x"}, alone=True).status == 422
