"""Claim: the studio does not grow. Rounds of use in a real browser compress an hour: numbers are turned,
bands and a plate are computed, the map is painted, a finger moves, views and older runs are opened and
closed. The memory of server, worker, process of files and page after each round has no slope beyond its
noise. Needs Chromium and the test extra.

The page uses itself, by the program in hour_of_the_studio.js. A library that drives browsers would let the
page keep what it received, and kilobytes of each request.

    python benchmarks/hour_of_the_studio.py [ROUNDS]
"""

from __future__ import annotations

import itertools
import json
import subprocess
import sys
import tempfile
import time
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import psutil
from record import ROOT, write
from websockets.sync.client import ClientConnection, connect

sys.path += [str(ROOT / "tests")]
from browser import CHROMIUM, FLAGS, need_browser
from quick import FINER_CELL, QUICK_PLATE

ROUNDS = 60  # with 4 turned numbers, 3 results, 2 strokes and 2 older runs each: two hours of use
WARM = 30  # rounds before the slope: caches fill, and the list has as many runs as the server keeps
LEAST = 8  # further rounds
ALLOWED = 0.1  # MB per round beyond twice the standard error of the slope; 3 MB in an hour
PATIENCE = 300  # s
STUDY = FINER_CELL.replace("60 kHz", "10 kHz") + QUICK_PLATE
ROUND = Path(__file__).with_suffix(".js").read_text("utf-8")
SHARES = (0.15, 0.85)  # of a slider
MOVES = (4, 12)  # numbers, moves of each


class OwnPage:
    """A page of the browser, through the browser's own protocol."""

    def __init__(self, connection: ClientConnection) -> None:
        self._connection, self._numbers = connection, itertools.count()

    def call(self, method: str, **parameters: Any) -> dict[str, Any]:
        """Call a method of the protocol."""
        number = next(self._numbers)
        self._connection.send(json.dumps({"id": number, "method": method, "params": parameters}))
        answer: dict[str, Any] = {}
        while answer.get("id") != number:
            answer = json.loads(self._connection.recv(PATIENCE))
        assert "error" not in answer, answer
        result: dict[str, Any] = answer["result"]
        return result

    def run(self, program: str) -> Any:
        """Value of a program in the page, when it has ended."""
        result = self.call("Runtime.evaluate", expression=program, awaitPromise=True, returnByValue=True)
        assert "exceptionDetails" not in result, result
        return result["result"].get("value")


@contextmanager
def own_page(link: str) -> Iterator[tuple[OwnPage, psutil.Process]]:
    """Open a link in a browser without motion: the page, and the process of the browser."""
    need_browser()
    with tempfile.TemporaryDirectory() as profile:
        command = [
            str(CHROMIUM), "--headless=new", f"--user-data-dir={profile}", "--remote-debugging-port=0",
            "--window-size=1440,900", "--force-prefers-reduced-motion", *FLAGS, "about:blank",
        ]  # fmt: skip
        with subprocess.Popen(command, stderr=subprocess.DEVNULL) as browser:
            try:
                ready = Path(profile) / "DevToolsActivePort"
                while not (ready.exists() and ready.read_text()):
                    time.sleep(0.1)
                port = ready.read_text().split()[0]
                with urllib.request.urlopen(f"http://127.0.0.1:{port}/json") as listed:
                    pages = [target for target in json.load(listed) if target["type"] == "page"]
                with connect(pages[0]["webSocketDebuggerUrl"], max_size=None) as connection:
                    page = OwnPage(connection)
                    page.call("Page.navigate", url=link)
                    while not page.run("document.querySelector('.form') !== null"):
                        time.sleep(0.1)
                    yield page, psutil.Process(browser.pid)
            finally:
                browser.kill()


def measured(
    page: OwnPage, browser: psutil.Process, server: psutil.Process, roles: dict[int, str]
) -> dict[str, float]:
    """Memory of the processes and of the objects of the page, MB, and thousands of elements of the page."""
    page.call("HeapProfiler.collectGarbage")
    page.call("Performance.enable")
    metrics = {metric["name"]: metric["value"] for metric in page.call("Performance.getMetrics")["metrics"]}
    page.call("Performance.disable")
    memory = {"server": server.memory_info().rss / 1e6}
    for child in server.children():
        if "spawn_main" in " ".join(child.cmdline()):
            name = roles.setdefault(child.pid, ("worker", "files")[len(roles) % 2])
            memory[name] = child.memory_info().rss / 1e6
    living = [child for child in browser.children(recursive=True) if child.status() != psutil.STATUS_ZOMBIE]
    renderers = [child for child in living if "--type=renderer" in child.cmdline()]
    memory["page"] = max(renderer.memory_info().rss for renderer in renderers) / 1e6
    memory["objects of the page"] = metrics["JSHeapUsedSize"] / 1e6
    memory["elements of the page"] = metrics["Nodes"] / 1e3
    return memory


def slope(values: list[float]) -> tuple[float, float]:
    """Slope per round after the warm rounds, and its standard error."""
    late = np.array(values[WARM:])
    rounds = np.arange(len(late), dtype=float)
    (rise, _), covariance = np.polyfit(rounds, late, 1, cov=True)
    return float(rise), float(np.sqrt(covariance[0, 0]))


def hour(rounds: int) -> dict[str, Any]:
    """Memory after each round, and its slopes."""
    random, roles, measures = np.random.default_rng(41), dict[int, str](), list[dict[str, float]]()
    with tempfile.TemporaryDirectory() as folder:
        study = Path(folder) / "study.toml"
        study.write_text(STUDY, "utf-8")
        command = [sys.executable, "-m", "haptonic", "studio", str(study), "--no-browser"]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
            assert process.stdout is not None
            process.stdout.readline()
            link = process.stdout.readline().strip()
            try:
                with own_page(link) as (page, browser):
                    start = time.perf_counter()
                    for number in range(rounds):
                        shares = random.uniform(*SHARES, MOVES).tolist()
                        page.run(f"({ROUND})({json.dumps(STUDY)}, {json.dumps(shares)})")
                        measures.append(measured(page, browser, psutil.Process(process.pid), roles))
                        shown = {name: round(value, 1) for name, value in measures[-1].items()}
                        print(number + 1, shown, flush=True)
                    seconds = time.perf_counter() - start
            finally:
                process.terminate()
    memory = {}
    for name in measures[-1]:
        values = [each[name] for each in measures]
        rise, noise = slope(values)
        memory[name] = {
            "last": round(values[-1], 1), "largest": round(max(values), 1),
            "per_round": round(rise, 3), "standard_error": round(noise, 3),
        }  # fmt: skip
    return {"rounds": rounds, "warm_rounds": WARM, "seconds": round(seconds), "memory": memory}


def main() -> None:
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else ROUNDS
    assert rounds >= WARM + LEAST, f"a slope needs {WARM + LEAST} rounds"
    record = hour(rounds)
    write("hour_of_the_studio", record)
    growing = {
        name: figures
        for name, figures in record["memory"].items()
        if figures["per_round"] - 2 * figures["standard_error"] > ALLOWED
    }
    assert not growing, growing


if __name__ == "__main__":
    main()
