"""Claim: the bands follow a slider. While a number is turned, the preview is on the screen within 100 ms at
the median and 250 ms at the 95th percentile, and the certified curves are there 1 s after the last move,
0.4 s for a height; certified gaps follow. Over 200 random moves of three lattices and two kinds of cell no
certified frequency or edge is farther from the preview than its bound. A real browser with software
rendering; needs Chromium and the test extra.

    python benchmarks/drag_answers_at_once.py [drags | bounds]
"""

from __future__ import annotations

import json
import multiprocessing
import os
import sys
import tempfile
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
from diagram_in_a_second import frequencies_and_errors
from record import RESULTS, ROOT, machine, timed, write

from haptonic.parallel import THREAD_LIMITS, cores
from haptonic.study import Study, templates
from haptonic.study.loading import examined

sys.path += [str(ROOT / "tests"), str(ROOT / "tests" / "studio")]
from served import served
from test_page import opened

from browser import chromium

MOVES, SEED = 200, 41
DRAG = 60  # moves of a drag
PREPARED = 120_000  # ms
LATTICES = {"square": "7 mm", "triangular": "8 mm", "honeycomb": "12 mm"}
FEATURES = {
    "pillar": '[cell.pillar]\ndiameter = "3.5 mm"\nheight = "10 mm"\n',
    "disc": '[[cell.disc]]\ndiameter = "4 mm"\nhigh = "2 mm"\nmaterial = "steel"\n',
}
STUDY = """
carrier = "60 kHz"
material = "aluminium-7075"
[parameters]
plate = "1.5 mm"
[cell]
lattice = "{lattice}"
pitch = "{pitch}"
thickness = "plate"
{feature}
[bands]
count = 8
points = 31
accuracy = 5e-3
"""
# milliseconds from a move of the slider to the picture that shows it, measured at the browser's next frame;
# and the time of the release
DRAGGED = """async ([moves, low, high]) => {
  const slider = document.querySelector(".turning input");
  const times = [];
  for (let k = 0; k < moves; k++) {
    const share = 0.5 + 0.45 * Math.sin(k / 3);
    const start = performance.now();
    slider.value = String(low + share * (high - low));
    slider.dispatchEvent(new InputEvent("input", { bubbles: true }));
    await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
    if (document.querySelector(".kind").textContent !== "preview") throw new Error("no preview");
    times.push(performance.now() - start);
  }
  const released = performance.now();
  slider.dispatchEvent(new PointerEvent("pointerup", { bubbles: true }));
  slider.dispatchEvent(new Event("change", { bubbles: true }));
  return [times, released];
}"""
# the page waits itself, because questions of the driver would take a third of a core from the computation
CERTIFIED = """async (released) => {
  const until = async (isReached) => {
    while (!isReached(document.querySelector(".kind").textContent))
      await new Promise((done) => setTimeout(done, 10));
    return performance.now() - released;
  };
  return [await until((kind) => kind !== "preview"), await until((kind) => kind === "certified")];
}"""
ENDS = "['min', 'max'].map((end) => Number(document.querySelector('.turning input')[end]))"


def study_of(text: str) -> Study:
    study, _, problems = examined(text, Study, ROOT)
    assert study is not None, problems
    return study


Cell = tuple[str, str]  # lattice and kind of cell


def of_cell(given: tuple[Cell, list[float]]) -> tuple[Cell, list[float]]:
    """Shares of the bound that moves of one cell need; a move is a share of the slider of the next number."""
    # the worker of the studio imports this script, and has to import xarray itself
    from haptonic.analyses.turning import BandsTurning
    from haptonic.results.bands import Bands
    from turned import used_of_bound

    (lattice, kind), moves = given
    study = study_of(STUDY.format(lattice=lattice, pitch=LATTICES[lattice], feature=FEATURES[kind]))
    turning, used = BandsTurning(), list[float]()
    certified = turning.certified(study, Bands(study.bands().dataset))
    knobs = turning.knobs(study)
    for place, knob in enumerate(knobs):
        (*_, preview) = turning.previews(study, certified, knob)
        for share in moves[place :: len(knobs)]:
            shown = knob.low + share * (knob.high - knob.low)
            design = study.with_parameter(knob.path, knob.scale * shown)
            used.append(used_of_bound(preview, knob.scale * shown, design.cell, design.bands_settings))
            print(f"{lattice} {kind} {knob.title} {shown:.4g} {knob.unit}: {used[-1]:.2f}", flush=True)
    return given[0], used


def bounds(moves: int) -> dict[str, Any]:
    """Largest share of the bound that random moves over whole sliders need, by lattice and kind of cell."""
    cells = [(lattice, kind) for lattice in LATTICES for kind in FEATURES]
    drawn = np.random.default_rng(SEED).random(moves).tolist()
    tasks = [(cell, drawn[number :: len(cells)]) for number, cell in enumerate(cells)]
    os.environ |= dict.fromkeys(THREAD_LIMITS, "1")  # of the processes, one for each core
    spawned = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(cores(), spawned) as pool:
        worst = dict(pool.map(of_cell, tasks))
    every = [used for moved in worst.values() for used in moved]
    return {
        "moves": len(every),
        "beyond_their_bound": sum(used > 1 for used in every),
        "largest_share_of_the_bound": {
            ", ".join(cell): round(max(moved), 3) for cell, moved in worst.items()
        },
        "median_share": round(float(np.median(every)), 3),
    }


def dragged(page: Any, path: str) -> dict[str, float]:
    """Turn a number in the page: times until the preview and until the certified curves are drawn."""
    page.select_option(".turning select", path)
    start = time.perf_counter()
    page.wait_for_selector(".turning[data-prepared=true]", timeout=PREPARED)
    prepared = time.perf_counter() - start
    times, released = page.evaluate(DRAGGED, [DRAG, *page.evaluate(ENDS)])
    curves, gaps = page.evaluate(CERTIFIED, released)
    page.wait_for_selector(".turning select:enabled", timeout=PREPARED)
    median, high = np.percentile(times, [50, 95])
    return {
        "median_ms": round(float(median), 1), "high_ms": round(float(high), 1),
        "certified_s": round(curves / 1000, 2), "gaps_s": round(gaps / 1000, 2),
        "prepared_s": round(prepared, 1),
    }  # fmt: skip


def drags() -> dict[str, Any]:
    """Drags on numbers of the touchpad and on a named parameter, and time of the reference cell's diagram."""
    frequencies_and_errors()  # what its topology needs once
    figures: dict[str, Any] = {"reference_s": timed(frequencies_and_errors, repeats=3)[0]}
    numbers = ("cell.pillar.diameter", "cell.pillar.height", "cell.thickness")
    with tempfile.TemporaryDirectory() as folder, chromium() as browser:
        for name, paths in (("touchpad", numbers), ("scaled-cell", ("parameters.a",))):
            (Path(folder) / f"{name}.toml").write_text(str(templates()[name]), "utf-8")
            with served(Path(folder), f"{name}.toml") as studio, opened(browser, studio) as page:
                page.get_by_role("button", name="Compute bands").click()
                page.wait_for_selector(".turning select", timeout=PREPARED)
                figures |= {path: dragged(page, path) for path in paths}
    return figures


PARTS: dict[str, Callable[[], dict[str, Any]]] = {"drags": drags, "bounds": lambda: bounds(MOVES)}


def main() -> None:
    """Measure the parts that are named, by default both; the record keeps the other part with its commit."""
    file = RESULTS / "drag_answers_at_once.json"
    before = json.loads(file.read_text("utf-8")) if file.exists() else {}
    commit = machine()["commit"]
    with tempfile.TemporaryDirectory() as store:
        os.environ["HAPTONIC_STORE"] = store  # without designs of an earlier run
        measured = {name: PARTS[name]() | {"commit": commit} for name in sys.argv[1:] or PARTS}
    write("drag_answers_at_once", {name: before[name] for name in PARTS if name in before} | measured)


if __name__ == "__main__":
    main()
