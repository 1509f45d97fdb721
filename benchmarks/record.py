"""What every benchmark shares: the reference study, a clock, and a record of machine, versions and commit."""

from __future__ import annotations

import json
import os
import platform
import resource
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from importlib.metadata import version
from itertools import count
from pathlib import Path
from typing import Any

import numpy as np
from threadpoolctl import threadpool_info

from haptonic.cell import UnitCell

ROOT = Path(__file__).parents[1]
RESULTS = Path(__file__).parent / "results"
STUDY = ROOT / "studies" / "touchpad.toml"
REFERENCE = json.loads((ROOT / "tests" / "data" / "reference_cell.json").read_text("utf-8"))
CORNERS = {"G": (0.0, 0.0), "X": (np.pi, 0.0), "M": (np.pi, np.pi)}


def machine() -> dict[str, Any]:
    """Where and with what a figure was measured."""
    model = next(
        (line.split(":")[1].strip() for line in _lines("/proc/cpuinfo") if line.startswith("model name")),
        platform.processor(),
    )
    commit = subprocess.run(
        ["git", "describe", "--always", "--dirty"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    return {
        "processor": model,
        "cores": os.cpu_count(),
        "kernels": next(
            (library["architecture"] for library in threadpool_info() if "architecture" in library), "unknown"
        ),
        "load_before": os.getloadavg()[0],
        "python": platform.python_version(),
        "versions": {name: version(name) for name in ("haptonic", "numpy", "scipy", "pypardiso", "mkl")},
        "commit": commit.stdout.strip(),
        "date": time.strftime("%Y-%m-%d"),
    }


def _lines(path: str) -> list[str]:
    return Path(path).read_text("utf-8").splitlines() if Path(path).exists() else []


_fresh = count(1)


def fresh(cell: UnitCell) -> UnitCell:
    """A cell but for some billionths of its thickness, so that no foot condensed before serves it."""
    return replace(cell, thickness=cell.thickness * (1 + 1e-9 * next(_fresh)))


def timed(work: Callable[[], Any], repeats: int = 1) -> tuple[float, Any]:
    """Shortest of some wall times, s, and the last result."""
    best, result = np.inf, None
    for _ in range(repeats):
        start = time.perf_counter()
        result = work()
        best = min(best, time.perf_counter() - start)
    return float(best), result


def peak_memory() -> float:
    """Largest resident memory of this process so far, bytes."""
    return 1024.0 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def apart(script: str, *given: object) -> Any:
    """What a script prints last, as JSON, in a process of its own: peak memory is a process's."""
    done = subprocess.run(
        [sys.executable, script, *map(str, given)], capture_output=True, text=True, check=True
    )
    return json.loads(done.stdout.splitlines()[-1])


def true_error(frequencies: dict[str, np.ndarray]) -> float:
    """Largest relative distance from the converged frequencies of bands 1 to 10 at the zone's corners.

    ``frequencies`` has those of each corner, Hz; rest modes are left out. The converged ones are an
    independent code's; see the tests' data.
    """
    worst = 0.0
    for corner, frequency in frequencies.items():
        exact = np.array(REFERENCE[corner][:10], dtype=float)
        moving = exact > 0
        worst = max(worst, float(np.abs(frequency[: len(exact)][moving] / exact[moving] - 1).max()))
    return worst


def write(name: str, figures: dict[str, Any]) -> None:
    """Keep the figures of a benchmark, and show them."""
    RESULTS.mkdir(exist_ok=True)
    text = json.dumps({"machine": machine(), **figures}, indent=1)
    (RESULTS / f"{name}.json").write_text(text + "\n", "utf-8")
    print(f"{name}: {json.dumps(figures)[:600]}", flush=True)
