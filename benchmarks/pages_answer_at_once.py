"""Claim: the interactive pages follow the hand. A mode is on the screen 150 ms after it is selected, the
script of a frame takes less than 4 ms, and the touchpad's plate of 1001 frequencies opens within a second and
scrubs without a stall. A real browser with software rendering; needs Chromium and the test extra."""

from __future__ import annotations

import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np
from record import STUDY, write

import haptonic

sys.path.append(str(Path(__file__).parents[1] / "tests"))
from browser import chromium, page_at

MOVES, FRAMES, OPENINGS = 60, 60, 5
# milliseconds from a key to the picture that shows its effect, measured at the next frame of the browser
MOVED = """async ([key, moves]) => {
  const walk = document.querySelector(".walk");
  const times = [];
  for (let k = 0; k < moves; k++) {
    const start = performance.now();
    walk.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
    await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
    times.push(performance.now() - start);
  }
  return times;
}"""
DRAWN = """async (frames) => {
  const { moving } = document.querySelector(".mode canvas");
  const times = [];
  for (let k = 0; k < frames; k++) {
    const start = performance.now();
    moving.turn(k / frames);
    times.push(performance.now() - start);
    await new Promise(requestAnimationFrame);
  }
  return times;
}"""


def spread(milliseconds: list[float]) -> dict[str, float]:
    """Median and 95th percentile, ms."""
    median, high = np.percentile(milliseconds, [50, 95])
    return {"median_ms": round(float(median), 1), "high_ms": round(float(high), 1)}


def opening(browser: Any, address: str) -> float:
    """Seconds from the call until the first picture is drawn."""
    start = time.perf_counter()
    with page_at(browser, address, 1440, reduced_motion="reduce") as page:
        page.wait_for_selector("canvas[data-shown]")
        return time.perf_counter() - start


def main() -> None:
    study = haptonic.load(STUDY)
    figures: dict[str, Any] = {}
    with tempfile.TemporaryDirectory() as folder, chromium() as browser:
        for name, result in (("bands", study.bands(html=True)), ("plate", study.plate(html=True))):
            result.write(Path(folder) / name)
            file = Path(folder) / name / f"{name}.html"
            seconds = sorted(opening(browser, file.as_uri()) for _ in range(OPENINGS))
            figures[name] = {
                "bytes": file.stat().st_size, "opens_in_s": round(seconds[OPENINGS // 2], 2)
            }  # fmt: skip
            with page_at(browser, file.as_uri(), 1440, reduced_motion="reduce") as page:
                page.wait_for_selector("canvas[data-shown]")
                figures[name]["moves"] = spread(page.evaluate(MOVED, ["ArrowLeft", MOVES]))
                if name == "bands":
                    figures[name]["script_of_a_frame"] = spread(page.evaluate(DRAWN, FRAMES))
    write("pages_answer_at_once", figures)


if __name__ == "__main__":
    main()
