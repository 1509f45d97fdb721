"""Runs outlive their server, and points of a computation appear while it computes."""

import json
import os
import signal
import subprocess
import sys
import time
import tomllib
import zipfile
from dataclasses import replace
from pathlib import Path

import pytest
from served import PATIENCE, Served, served

from haptonic.atomic import write_atomically
from haptonic.materials import material
from haptonic.studio import jobs
from haptonic.studio.archive import Archive
from haptonic.studio.designs import design_text
from haptonic.studio.job import Job
from haptonic.studio.order import Order
from haptonic.studio.worker import Wishes, study_of
from haptonic.study import loads, templates
from quick import QUICK_CELL

SWEEP = (
    QUICK_CELL
    + """
[[sweep]]  # heights
vary = "cell.pillar.height"
from = "14 mm"
to = "15 mm"
steps = 3
"""
)
MANY = SWEEP.replace("steps = 3", "steps = 200")
SLOW = str(templates()["touchpad"])


@pytest.fixture(scope="module")
def studio(tmp_path_factory):
    with served(tmp_path_factory.mktemp("runs")) as running:
        yield running


def start(studio: Served, analysis: str, text: str) -> int:
    reply = studio.post("run", analysis=analysis, options={}, text=text, file=None)
    assert reply.status == 200, reply.content
    return reply.json["number"]


def points_of(studio: Served, number: int, first: int = 0) -> list[dict]:
    return studio.ask("GET", f"/api/jobs/{number}/points/{first}").json


def wait_for_points(studio: Served, number: int) -> None:
    end = time.monotonic() + PATIENCE
    while not points_of(studio, number) and time.monotonic() < end:
        time.sleep(0.05)


def test_a_killed_server_loses_no_run(tmp_path):
    (tmp_path / "quick.toml").write_text(QUICK_CELL, "utf-8")
    command = [sys.executable, "-m", "haptonic", "studio", str(tmp_path / "quick.toml"), "--no-browser"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        process.stdout.readline()
        running = served_elsewhere(process.stdout.readline().strip())
        number = start(running, "bands", QUICK_CELL)
        before = running.finished(number)
        view = running.ask("GET", f"/api/jobs/{number}/view").content
        unfinished = start(running, "bands", SLOW)
        with served(tmp_path) as beside, beside.listening() as page:
            assert [job["number"] for job in json.loads(page.recv())["jobs"]] == [number]  # it still runs
        process.send_signal(signal.SIGKILL)
        process.wait(30)
    with served(tmp_path, "quick.toml") as again:
        with again.listening() as page:
            brief, left = json.loads(page.recv())["jobs"]
        assert brief["title"] == "Quick"
        assert (left["number"], left["state"]) == (unfinished, "interrupted")
        job = again.ask("GET", f"/api/jobs/{unfinished}").json
        assert (job["state"], job["text"], job["answer"]) == ("interrupted", SLOW, None)
        after = again.ask("GET", f"/api/jobs/{number}").json
        assert after["answer"] == before["answer"]
        picture = again.ask("GET", f"/api/jobs/{number}/pictures/natures")
        assert picture.status == 200
        assert picture.content.startswith(b"<?xml")
        assert again.ask("GET", f"/api/jobs/{number}/view").content == view
        last = start(again, "sweep", MANY)
        assert last == unfinished + 1
        wait_for_points(again, last)
        assert again.post("remove", number=number).status == 200
        assert again.ask("GET", f"/api/jobs/{number}").status == 404
    # a server that ends keeps the designs of the job that it interrupts
    runs = Archive(tmp_path.resolve()).briefs
    assert [(each, brief["state"]) for each, brief in runs.items()] == [
        (unfinished, "interrupted"), (last, "interrupted"),
    ]  # fmt: skip
    assert runs[last]["points"] > 0


def served_elsewhere(link: str) -> Served:
    """A studio of another process."""
    running = Served(None, None, int(link.split(":")[2].split("/")[0]))
    reply = running.ask("GET", link.removeprefix(running.origin))
    running.cookie = reply.headers["Set-Cookie"].split(";")[0]
    return running


def a_run(folder, number: int) -> Job:
    order = Order(number=number, text="", folder=folder, file="a.toml", analysis="plan", options={})
    return Job(order, state="done", answer={"summary": []}, view=b"view")


def test_a_design_that_is_turned_is_read_without_the_designs_of_a_sweep(tmp_path):
    order = Order(number=1, text=SWEEP, folder=tmp_path, file="a.toml", analysis="bands", options={})
    assert len(study_of(order).sweep_settings) == 1
    turned = study_of(replace(order, turned="cell.pillar.height"))
    assert turned.sweep_settings == ()
    assert turned.cell == study_of(order).cell


def test_the_latest_wish_is_prepared_first():
    wishes = Wishes()
    assert wishes.first_of(["pitch", "height"]) == "pitch"
    for path in ("height", "pitch", "height", "gone"):
        wishes.add(path)
    assert wishes.first_of(["thickness", "pitch", "height"]) == "height"
    assert wishes.first_of(["thickness", "pitch"]) == "pitch"


def test_points_of_a_running_job_are_written_at_intervals(tmp_path, monkeypatch):
    monkeypatch.setattr(jobs, "SAVED_EVERY", 0.0)
    with served(tmp_path) as studio:
        number = start(studio, "sweep", MANY)
        wait_for_points(studio, number)
        archive = studio.studio.jobs.archive
        end = time.monotonic() + PATIENCE
        while not (stored := archive.read(number)).points and time.monotonic() < end:
            time.sleep(0.05)
        assert stored.points
        assert Archive(tmp_path).briefs == {}  # it still runs
        slow = start(studio, "bands", SLOW)
        assert sorted(archive.briefs) == [number, slow]
        studio.post("cancel", number=slow)
    assert list(Archive(tmp_path.resolve()).briefs) == [number]


def test_the_archive_is_bounded_and_leaves_damaged_files_alone(tmp_path):
    runs = Archive(tmp_path, most_runs=3)
    for number in range(1, 6):
        runs.keep(a_run(tmp_path, number))
    assert sorted(runs.briefs) == [3, 4, 5]
    assert runs.read(5).view == b"view"
    paths = sorted(runs.folder.iterdir())
    assert len(paths) == 3
    assert not any(".." in name for path in paths for name in zipfile.ZipFile(path).namelist())
    paths[0].write_bytes(paths[0].read_bytes()[:40])
    paths[1].write_bytes(b"")
    assert list(Archive(tmp_path).briefs) == [5]
    assert Archive(tmp_path / "other").briefs == {}
    small = Archive(tmp_path, most_bytes=1)
    small.keep(a_run(tmp_path, 6))  # the newest stays whatever its size
    assert list(small.briefs) == [6]


def test_points_of_a_sweep_come_with_errors_and_open_as_designs(studio):
    own = SWEEP.replace('"1.5 mm"', '"1.6 mm"')  # designs that no test beside this one puts into the store
    number = start(studio, "sweep", own)
    job = studio.finished(number)
    assert job["state"] == "done", job["error"]
    points = points_of(studio, number)
    assert [round(point["varied"][0]["value"] * 1e3, 6) for point in points] == [14.0, 14.5, 15.0]
    assert [result["title"] for result in points[0]["results"]] == ["lower edge", "upper edge"]
    assert all(result["error"] > 0 for point in points for result in point["results"])
    assert points_of(studio, number, 2) == points[2:]
    opened = studio.post("opened", number=number, point=2).json
    assert opened["problems"] == []
    assert loads(opened["text"]).cell.pillar.height == pytest.approx(15e-3, rel=1e-12)
    assert "[[sweep]]  # heights" in opened["text"]
    assert studio.post("opened", number=number, point=3).status == 422
    assert studio.post("opened", number=number, point=-1).status == 422


def test_points_appear_while_the_rest_is_computed_and_stay_when_it_is_cancelled(studio):
    number = start(studio, "sweep", MANY)
    wait_for_points(studio, number)
    assert studio.ask("GET", f"/api/jobs/{number}").json["state"] == "running"
    studio.post("cancel", number=number)
    assert studio.finished(number)["state"] == "cancelled"
    points = points_of(studio, number)
    assert points
    stored = Archive(studio.studio.workspace.folder).read(number)
    assert stored.state == "cancelled"
    assert stored.points == points


def test_a_worker_that_dies_keeps_the_points(studio):
    number = start(studio, "sweep", MANY)
    wait_for_points(studio, number)
    os.kill(studio.studio.jobs._worker.process.pid, signal.SIGKILL)
    assert studio.finished(number)["state"] == "failed"
    assert Archive(studio.studio.workspace.folder).read(number).points


@pytest.mark.parametrize(
    "text", [QUICK_CELL, QUICK_CELL.replace('"14.7 mm"', '"b"') + '[parameters]\nb = "14.7 mm"\n']
)
def test_the_text_of_a_design_keeps_its_comments(tmp_path, text):
    varied = "parameters.b" if "parameters" in text else "cell.pillar.height"
    result = design_text(f"{text}# end\n", {varied: 0.0151, "cell.pitch": 7e-3}, tmp_path)
    assert result.endswith("# end\n")
    assert tomllib.loads(result)["cell"]["pitch"] == "7 mm"
    assert loads(result).cell.pillar.height == pytest.approx(0.0151)


def test_a_design_has_no_rounding_errors_in_its_text(tmp_path):
    text = QUICK_CELL.replace('"14.7 mm"', '"share*14 mm"') + "[parameters]\nshare = 0.4\n"
    result = design_text(
        text, {"parameters.share": 0.4 + 0.1 - 0.06, "cell.pitch": 0.1 * 3 * 2.5e-2}, tmp_path
    )
    assert "share = 0.44\n" in result
    assert 'pitch = "7.5 mm"' in result


def test_the_text_of_a_design_moves_discs_that_share_an_end(tmp_path):
    glue = '[[cell.disc]]\ndiameter = "5 mm"\nhigh = "50 um"\nlow = "0 mm"\nmaterial = "epoxy"\n'
    pillar = '[[cell.disc]]\ndiameter = "5 mm"\nlow = "50 um"\nhigh = "7 mm"\n'
    text = f'material = "steel"\n[cell]\npitch = "8 mm"\nthickness = "1 mm"\n{glue}{pillar}# end\n'
    result = design_text(text, {"cell.disc[1].high": 80e-6}, tmp_path)
    assert result == text.replace("50 um", "80 µm")


def test_a_number_that_the_text_gives_in_another_way_gives_a_new_text(tmp_path):
    text = QUICK_CELL.replace('"aluminium-paper"', "{ youngs_modulus = '70 GPa', poisson_ratio = 0.33 }")
    text = text.replace("0.33 }", "0.33, density = '2700 kg/m^3' } # inline")
    result = design_text(text, {"material.density": 2800.0}, tmp_path)
    assert loads(result).parameters()["material.density"] == pytest.approx(2800.0)
    named = design_text(QUICK_CELL, {"material.density": 2800.0}, tmp_path)  # of a material by name
    assert loads(named).cell.material == replace(material("aluminium-paper"), density=2800.0)


def test_runs_of_the_command_line_are_listed_opened_and_compared(tmp_path):
    """Also one that ends while the studio runs, whose number another run has."""
    (tmp_path / "quick.toml").write_text(QUICK_CELL, "utf-8")

    def command(*words: str) -> None:
        call = [sys.executable, "-m", "haptonic", *words]
        subprocess.run(call, check=True, cwd=tmp_path, capture_output=True)

    command("bands", "quick.toml", "--out", "bands")
    with served(tmp_path, "quick.toml") as studio, studio.listening() as page:
        (first,) = json.loads(page.recv())["jobs"]
        assert (first["analysis"], first["title"], first["byCommand"]) == ("bands", "Quick", True)
        answer = studio.ask("GET", f"/api/jobs/{first['number']}").json
        assert answer["command"] == "haptonic bands quick.toml"
        assert answer["answer"]["summary"][0].startswith("Complete gap")
        picture = studio.ask("GET", f"/api/jobs/{first['number']}/pictures/dispersion")
        assert picture.content == (tmp_path / "bands/dispersion.svg").read_bytes()
        number = start(studio, "bands", QUICK_CELL.replace("14.7 mm", "14 mm"))
        studio.finished(number)
        (tmp_path / "quick.toml").write_text(QUICK_CELL.replace("14.7 mm", "14.2 mm"), "utf-8")
        command("bands", "quick.toml", "--json")
        end, jobs = time.monotonic() + PATIENCE, []
        while len(jobs) < 3 and time.monotonic() < end:
            jobs = json.loads(page.recv())["jobs"]
        assert [job["number"] for job in jobs] == [1, 2, 3]
        assert [job["byCommand"] for job in jobs] == [True, False, True]
        compared = studio.post("differences", first=1, second=3).json
        assert "14.2 mm" in json.dumps(compared["tables"][0])
        assert start(studio, "bands", QUICK_CELL) == 4


def test_a_run_that_is_being_written_is_not_listed(tmp_path):
    writing, watching = Archive(tmp_path), Archive(tmp_path)
    job = Job.ordered(Order(1, QUICK_CELL, tmp_path, "a.toml", "bands", {}))
    job.answer = {"title": "a.toml"}
    job.finish("done")
    writing.keep(job)
    assert watching.refresh()
    (file,) = watching.folder.glob("*.zip")

    def write(draft: Path) -> None:
        draft.write_bytes(file.read_bytes())
        assert not watching.refresh()
        assert list(watching.briefs) == [1]

    write_atomically(file.with_name("2-b.zip"), write)
    assert watching.refresh()
    assert list(watching.briefs) == [1, 2]


def test_a_run_with_a_number_that_is_taken_has_the_next_one(tmp_path):
    here, other = Archive(tmp_path), Archive(tmp_path)
    orders = [Order(1, QUICK_CELL, tmp_path, f"{name}.toml", "bands", {}) for name in ("a", "b")]
    for archive, order in zip((here, other), orders, strict=True):
        job = Job.ordered(order)
        job.answer = {"title": order.file}
        job.finish("done")
        archive.keep(job)
    assert here.refresh()
    assert not here.refresh()
    assert [brief["file"] for brief in here.briefs.values()] == ["a.toml", "b.toml"]
    assert here.read(2).order.file == "b.toml"
    assert here.read(2).number == 2
    other.remove(1)
    assert here.refresh()
    assert list(here.briefs) == [1]
