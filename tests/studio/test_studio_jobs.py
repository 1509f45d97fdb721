"""Jobs in a worker process: one after another, the latest wins, and none is lost with a page."""

import http.client
import json
import multiprocessing
import os
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor

import psutil
import pytest
from served import PATIENCE, Served, served

from haptonic.studio.order import Order, Wish
from haptonic.studio.worker import serve
from haptonic.study import templates
from quick import QUICK_CELL

SLOW = str(templates()["touchpad"])


@pytest.fixture(scope="module")
def studio(tmp_path_factory):
    folder = tmp_path_factory.mktemp("jobs")
    (folder / "quick.toml").write_text(QUICK_CELL, "utf-8")
    with served(folder, "quick.toml") as running:
        yield running


def start(studio, analysis: str, text: str = QUICK_CELL, **options) -> int:
    reply = studio.post("run", analysis=analysis, options=options, text=text, file="quick.toml")
    assert reply.status == 200, reply.content
    return reply.json["number"]


def test_a_result_has_sentences_tables_and_the_command(studio):
    job = studio.finished(start(studio, "plan"))
    assert job["state"] == "done"
    assert job["command"] == "haptonic plan quick.toml"
    assert job["python"] == 'haptonic.load("quick.toml").plan()'
    assert "Quick" in job["answer"]["summary"][0]
    assert all(len(row) == len(table["head"]) for table in job["answer"]["tables"] for row in table["rows"])


def test_bands_have_their_view_and_pictures_and_again_from_the_store(studio):
    for _ in range(2):
        job = studio.finished(start(studio, "bands"))
        assert job["state"] == "done", job["error"]
        assert job["view"]
    view = studio.ask("GET", f"/api/jobs/{job['number']}/view").content
    header = json.loads(view[4 : 4 + int.from_bytes(view[:4], "little")])
    assert header["kind"] == "bands"
    assert [picture["name"] for picture in job["answer"]["pictures"]] == ["dispersion", "natures", "modes"]
    picture = studio.ask("GET", f"/api/jobs/{job['number']}/pictures/dispersion")
    assert picture.headers["Content-Type"] == "image/svg+xml"
    assert "default-src 'none'" in picture.headers["Content-Security-Policy"]
    assert studio.ask("GET", f"/api/jobs/{job['number']}/pictures/none").status == 404


def test_the_latest_job_wins_and_every_page_hears_of_it(studio):
    with studio.listening() as page_1, studio.listening() as page_2:
        first = start(studio, "bands", SLOW)
        second = start(studio, "plan")
        assert studio.finished(first)["state"] == "cancelled"
        assert studio.finished(second)["state"] == "done"
        for page in (page_1, page_2):
            states: dict[int, str] = {}
            end = time.monotonic() + 20
            while states.get(second) != "done" and time.monotonic() < end:
                states = {job["number"]: job["state"] for job in json.loads(page.recv(timeout=20))["jobs"]}
            assert states[first] == "cancelled"
            assert states[second] == "done"


def test_a_job_goes_on_while_no_page_is_open(studio):
    with studio.listening() as page:
        page.recv()
        number = start(studio, "plan")
    studio.finished(number)
    with studio.listening() as page:
        jobs = json.loads(page.recv())["jobs"]
    assert [job["state"] for job in jobs if job["number"] == number] == ["done"]


def test_pictures_are_drawn_in_another_process_while_a_job_is_computed(studio):
    drawn = studio.finished(start(studio, "bands"))
    worker = studio.studio.jobs._worker.process.pid
    number = start(studio, "bands", SLOW)
    picture = studio.ask("GET", f"/api/jobs/{drawn['number']}/pictures/dispersion")
    assert picture.status == 200
    assert picture.content.startswith(b"<?xml")
    # the job goes on in its own process
    assert studio.studio.jobs._worker.process.pid == worker
    assert studio.studio.exports._worker.process.pid != worker
    assert studio.ask("GET", f"/api/jobs/{number}/pictures/dispersion").status == 404  # no result yet
    studio.post("cancel", number=number)


def test_a_picture_that_no_page_waits_for_is_left_out(studio, monkeypatch):
    number = studio.finished(start(studio, "bands"))["number"]
    done, asked = studio.studio.exports.done, []

    def slow(order, answer):
        asked.append(order.export.name)
        time.sleep(0.5)
        return done(order, answer)

    monkeypatch.setattr(studio.studio.exports, "done", slow)
    names = ("dispersion", "natures", "modes")
    with ThreadPoolExecutor(1) as aside:
        first = aside.submit(studio.ask, "GET", f"/api/jobs/{number}/pictures/dispersion")
        while not asked:
            time.sleep(0.01)
        connection = http.client.HTTPConnection("127.0.0.1", studio.port)
        connection.request("GET", f"/api/jobs/{number}/pictures/natures", headers={"Cookie": studio.cookie})
        connection.close()  # the page has gone to another result
        assert first.result().status == 200
    assert studio.ask("GET", f"/api/jobs/{number}/pictures/modes").status == 200
    assert asked == [name for name in names if name != "natures"]


def test_a_wish_behind_an_order_does_not_end_it(tmp_path):
    spawned = multiprocessing.get_context("spawn")
    ours, theirs = spawned.Pipe()
    order = Order(number=1, text=QUICK_CELL, folder=tmp_path, file="a.toml", analysis="plan", options={})
    for message in (order, Wish("cell.pitch")):
        ours.send(message)
    worker = spawned.Process(target=serve, args=(theirs,), daemon=True)
    worker.start()
    kinds = set()
    while "done" not in kinds:
        assert ours.poll(PATIENCE)
        kinds.add(ours.recv()[0])
    worker.kill()


def test_a_job_is_cancelled(studio):
    number = start(studio, "bands", SLOW)
    assert studio.post("cancel", number=number).status == 200
    assert studio.finished(number)["state"] == "cancelled"
    assert studio.finished(start(studio, "plan"))["state"] == "done"


def test_a_worker_that_dies_gives_an_error_and_the_next_job_works(studio):
    number = start(studio, "bands", SLOW)
    while not studio.studio.jobs.jobs[number].begun:  # an order that was not received is given again
        time.sleep(0.01)
    os.kill(studio.studio.jobs._worker.process.pid, signal.SIGKILL)
    job = studio.finished(number)
    assert job["state"] == "failed"
    assert job["error"]["code"] == "worker"
    assert "exit code -9" in job["error"]["given"]
    assert studio.finished(start(studio, "plan"))["state"] == "done"


def test_an_idle_worker_that_dies_is_replaced(studio):
    studio.finished(start(studio, "plan"))
    os.kill(studio.studio.jobs._worker.process.pid, signal.SIGKILL)
    assert studio.finished(start(studio, "plan"))["state"] == "done"


def test_an_error_of_the_study_has_five_parts(studio):
    job = studio.finished(start(studio, "plate"))
    assert job["state"] == "failed"
    assert {"argument", "given", "allowed", "cause", "next_step", "code"} <= job["error"].keys()


@pytest.mark.parametrize(
    ("analysis", "options"),
    [
        ("export", {}),
        ("os.system", {}),
        (3, {}),
        ("bands", {"x": 1}),
        ("bands", {"surface": "yes"}),
        ("bands", []),
    ],
)
def test_a_request_for_anything_else_is_refused(studio, analysis, options):
    reply = studio.post("run", analysis=analysis, options=options, text=QUICK_CELL)
    assert reply.status == 422
    assert "next_step" in reply.json["error"]


def test_ctrl_c_ends_the_server_and_its_worker(tmp_path):
    (tmp_path / "quick.toml").write_text(QUICK_CELL, "utf-8")
    command = [sys.executable, "-m", "haptonic", "studio", str(tmp_path / "quick.toml"), "--no-browser"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        process.stdout.readline()
        link = process.stdout.readline().strip()
        running = served_elsewhere(link)
        number = start(running, "bands", SLOW)
        assert number == 1
        end = time.monotonic() + PATIENCE
        while not (workers := psutil.Process(process.pid).children()) and time.monotonic() < end:
            time.sleep(0.1)
        assert workers
        process.send_signal(signal.SIGINT)
        assert process.wait(30) == 0
        _, alive = psutil.wait_procs(workers, timeout=10)
        assert alive == []
        assert "Traceback" not in process.stderr.read()


def served_elsewhere(link: str):
    """A studio of another process."""
    port = int(link.split(":")[2].split("/")[0])
    running = Served(None, None, port)
    reply = running.ask("GET", link.removeprefix(running.origin))
    running.cookie = reply.headers["Set-Cookie"].split(";")[0]
    return running


def test_a_taken_port_gives_an_error(studio):
    command = [sys.executable, "-m", "haptonic", "studio", "--no-browser", "--port", str(studio.port)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE, check=False)
    assert done.returncode == 2
    assert "next step" in done.stderr
    assert "Traceback" not in done.stderr
