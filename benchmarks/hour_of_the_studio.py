"""Claim: the studio does not grow. Rounds of use in a real browser compress an hour: numbers are turned,
bands and a plate are computed, the map is painted, a finger moves, views and older runs are opened and
closed. The memory of server, worker, process of files and page after each round has no slope beyond its
noise. Needs Chromium and the test extra.

The program that drives the browser lets the page keep what it received, about 200 MB, and some kilobytes of
every request. The first is filled before the first round, the second is measured with small requests; the
page's memory is given without both.

    python benchmarks/hour_of_the_studio.py [ROUNDS]
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import psutil
from record import ROOT, write

sys.path += [str(ROOT / "tests")]
from browser import STILL, chromium, page_at
from quick import FINER_CELL, QUICK_PLATE

ROUNDS = 40  # with 4 turned numbers, 3 results, 2 strokes and 2 older runs each: more than an hour of use
WARM = 17  # rounds before the slope: caches fill, and the list has as many runs as the server keeps
LEAST = 8  # further rounds
ALLOWED = 0.1  # MB per round beyond twice the standard error of the slope; 3 MB in an hour
ANSWERS = 300  # of 0.8 MB, more than the driver of the browser lets the page keep
REQUESTS = 20_000  # small ones, which show what the driver keeps of each: 3 kB, within 2 MB of noise of all
PATIENCE = 300_000  # ms
STUDY = FINER_CELL.replace("60 kHz", "10 kHz") + QUICK_PLATE
TEXT = "textarea[aria-label^='Text of the study']"
ENTERED = """([area, text]) => {
  const field = document.querySelector(area);
  field.value = text;
  field.dispatchEvent(new InputEvent("input", { bubbles: true }));
}"""
RECEIVED = """async (times) => {
  for (let k = 0; k < times; k++) await (await fetch("/studio.js", { cache: "no-store" })).arrayBuffer();
}"""
ASKED = """async (times) => {
  for (let k = 0; k < times; k++) await (await fetch("/", { cache: "no-store" })).text();
}"""
DRAWN = "[...document.querySelectorAll('.pictures img')].every((image) => image.naturalWidth > 0)"
MOVED = """async (shares) => {
  const slider = document.querySelector(".turning input");
  const [low, high] = [Number(slider.min), Number(slider.max)];
  for (const share of shares) {
    slider.value = String(low + share * (high - low));
    slider.dispatchEvent(new InputEvent("input", { bubbles: true }));
    await new Promise((done) => setTimeout(done, 20));
  }
  slider.dispatchEvent(new Event("change", { bubbles: true }));
}"""


def until(page: Any, is_so: Callable[[], Any]) -> None:
    """Wait for a condition; the page allows no functions of the driver that are evaluated in it."""
    end = time.monotonic() + PATIENCE / 1000
    while not is_so():
        assert time.monotonic() < end, "the page does not answer"
        page.wait_for_timeout(50)


def compute(page: Any, analysis: str) -> None:
    """Compute an analysis and wait until its result is shown."""
    page.get_by_label("Analysis").select_option(analysis)
    page.get_by_role("button", name=f"Compute {analysis}").click()
    page.locator(f"#result[aria-label='Result of {analysis}']").wait_for(timeout=PATIENCE)
    page.locator(".compute .running").wait_for(state="detached", timeout=PATIENCE)


def turn(page: Any, path: str, random: np.random.Generator) -> None:
    """Drag a number, and wait for its certified curves."""
    page.select_option(".turning select", path)
    page.locator(".turning[data-prepared=true]").wait_for(timeout=PATIENCE)
    page.evaluate(MOVED, random.uniform(0.15, 0.85, 12).tolist())
    page.locator(".kind.certified").wait_for(timeout=PATIENCE)
    page.locator(".turning select:enabled").wait_for(timeout=PATIENCE)


def walk(page: Any, keys: str) -> None:
    """Press keys in the view."""
    for key in keys.split():
        page.locator(".walk").press(key)


def paint(page: Any) -> None:
    """Paint a tile of the map with the third letter, and take it back."""
    page.locator("summary", has_text="Map of the plate").click()
    canvas, before = page.locator(".paint canvas"), page.input_value(TEXT)
    for key in ("3", "ArrowRight", "Space"):
        canvas.press(key)
    until(page, lambda: page.input_value(TEXT) != before)
    for key in ("Control+z", "ArrowLeft"):
        canvas.press(key)
    until(page, lambda: page.input_value(TEXT) == before)
    page.locator("summary", has_text="Map of the plate").click()


def use(page: Any, random: np.random.Generator) -> None:
    """One round: two minutes of use, from the same study each time, so that designs do not drift.

    Locators wait here, because the handle of an element would keep its whole view in memory.
    """
    page.evaluate(ENTERED, [TEXT, STUDY])  # typed text would stay in the browser's own history
    compute(page, "bands")
    page.locator(".turning select:enabled").wait_for(timeout=PATIENCE)
    for path in ("cell.pillar.diameter", "cell.pillar.height", "cell.thickness", "cell.pitch"):
        turn(page, path, random)
    walk(page, "ArrowRight ArrowRight ArrowUp ArrowLeft h h t t")
    page.locator("summary", has_text="Pictures").click()
    page.locator(".pictures").scroll_into_view_if_needed()
    page.locator(".pictures img").first.wait_for(state="attached")
    until(page, lambda: page.evaluate(DRAWN))
    page.locator("summary", has_text="Pictures").click()
    paint(page)
    for analysis in ("plate", "feel"):
        compute(page, analysis)
        page.locator("canvas[data-shown]").first.wait_for(timeout=PATIENCE)
        walk(page, "ArrowRight ArrowRight ArrowUp ArrowDown")
    page.locator("summary", has_text="Runs").click()
    for old in page.locator("[aria-label=Runs] tbody tr").all()[1:3]:
        old.get_by_role("button").first.click()
        page.wait_for_timeout(500)
    page.locator("summary", has_text="Runs").click()


def measured(
    page: Any, server: psutil.Process, roles: dict[int, str], driver: float = 0.0
) -> dict[str, float]:
    """Memory of the processes and of the objects of the page, MB, and thousands of elements of the page.

    driver : memory of the page that its driver uses, MB
    """
    session = page.context.new_cdp_session(page)
    session.send("HeapProfiler.collectGarbage")
    session.send("Performance.enable")
    metrics = {
        metric["name"]: metric["value"] for metric in session.send("Performance.getMetrics")["metrics"]
    }
    session.detach()
    memory = {"server": server.memory_info().rss / 1e6}
    for child in server.children():
        if "spawn_main" in " ".join(child.cmdline()):
            name = roles.setdefault(child.pid, ("worker", "files")[len(roles) % 2])
            memory[name] = child.memory_info().rss / 1e6
    browser = psutil.Process().children(recursive=True)
    renderers = [each for each in browser if "--type=renderer" in each.cmdline()]
    memory["page"] = max(each.memory_info().rss for each in renderers) / 1e6 - driver
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
    with tempfile.TemporaryDirectory() as folder, chromium() as browser:
        (Path(folder) / "study.toml").write_text(STUDY, "utf-8")
        command = [
            sys.executable,
            "-m",
            "haptonic",
            "studio",
            str(Path(folder) / "study.toml"),
            "--no-browser",
        ]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
            assert process.stdout is not None
            process.stdout.readline()
            link = process.stdout.readline().strip()
            try:
                with page_at(browser, link, 1440, **STILL) as page:
                    page.locator(".form").first.wait_for()
                    server = psutil.Process(process.pid)
                    requests: list[str] = []
                    page.on("request", lambda request: requests.append(request.url))
                    before = [measured(page, server, {})["page"]]
                    for program, times in ((RECEIVED, ANSWERS), (ASKED, REQUESTS)):
                        page.evaluate(program, times)
                        before.append(measured(page, server, {})["page"])
                    received, each = before[1] - before[0], (before[2] - before[1]) / REQUESTS
                    start = time.perf_counter()
                    for number in range(rounds):
                        use(page, random)
                        driver = received + each * (len(requests) - ANSWERS)
                        measures.append(measured(page, server, roles, driver))
                        print(
                            number + 1,
                            {name: round(value, 1) for name, value in measures[-1].items()},
                            flush=True,
                        )
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
    return {
        "rounds": rounds, "warm_rounds": WARM, "seconds": round(seconds), "received": round(received),
        "requests": len(requests), "kilobytes_of_a_request": round(1e3 * each, 2), "memory": memory,
    }  # fmt: skip


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
