"""Claim: a study as users write it is answered at default settings, or refused for a reason to be mended.

Designs are drawn over all lattices (``tests/user_designs.py``). Each is computed by its own process,
which prints the accuracy it reached, its processor time and its peak memory; these are stored with the
estimates. Every design is a line of a CSV file, so a run that was stopped goes on where it ended.
"""

from __future__ import annotations

import argparse
import csv
import json
import subprocess
import sys
import time
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import psutil
from record import ROOT, write

sys.path.insert(0, str(ROOT / "tests"))
from haptonic.bloch.candidates import best_model
from haptonic.bloch.mesh_levels import MeshLimits, expected_level, started
from haptonic.bloch.resolution import LEVELS
from haptonic.errors import HaptonicError
from haptonic.parallel import one_thread
from user_designs import study_of, study_text

FOLDER = ROOT / "results" / "answered_in_budget"
NAMES = (
    "seed", "number", "kind", "outcome", "order", "rings", "asked", "reached", "stopped_by", "seconds",
    "seconds_estimated", "gigabytes", "gigabytes_estimated",
)  # fmt: skip


def peak() -> float:
    """Peak memory of this process, GB; that of the process which started it, `getrusage` counts as well."""
    (line,) = (text for text in Path("/proc/self/status").read_text().splitlines() if "VmHWM" in text)
    return int(line.split()[1]) * 1024 / 1e9


def decided(seed: int, number: int, memory: float) -> dict[str, Any]:
    """The decision about a design with so much memory (bytes), without computing anything."""
    study = study_of(seed, number)
    cell, asked = study.cell, study.bands_settings
    row = {"seed": seed, "number": number, "kind": study_text(seed, number)[0], "asked": asked.accuracy}
    limits = MeshLimits(asked.budget, memory)
    try:
        meshes = started(cell, asked.count, asked.accuracy, limits)
    except HaptonicError as error:
        return {**row, "outcome": error.cause.split(":")[0]}
    wanted = LEVELS[expected_level(cell, asked.accuracy)].for_bands(cell, asked.count)
    lack = limits.lack(cell, wanted)
    return {
        **row,
        "outcome": "begun" if lack is None else f"begun lower, lack of {lack.of}",
        "order": meshes[0].order,
        "rings": meshes[0].foot_rings,
        "seconds_estimated": meshes[0].seconds(cell),
        "gigabytes_estimated": meshes[0].memory(cell) / 1e9,
    }


def computed(seed: int, number: int, memory: float) -> dict[str, Any]:
    """A design at default settings with so much memory (bytes); what a process of its own prints."""
    study = study_of(seed, number)
    cell, asked = study.cell, study.bands_settings
    row = {"seed": seed, "number": number, "kind": study_text(seed, number)[0], "asked": asked.accuracy}
    begin = time.process_time()
    try:
        with one_thread():
            best = best_model(cell, asked, limits=MeshLimits(asked.budget, memory))
    except HaptonicError as error:
        return {**row, "outcome": error.cause.split(":")[0], "seconds": time.process_time() - begin}
    used, worst = best.model.resolution, best.model.worst_error
    levels = [level.for_bands(cell, asked.count) for level in LEVELS]
    tried = [level for level in levels if (level.order, level.foot_rings) <= (used.order, used.foot_rings)]
    return {
        **row,
        "outcome": "reached" if worst <= asked.accuracy else "answered with its error",
        "order": used.order,
        "rings": used.foot_rings,
        "reached": worst,
        "stopped_by": best.lack.of if best.lack else "",
        "seconds": time.process_time() - begin,
        "seconds_estimated": sum(
            level.seconds(cell)
            for level in tried[min(expected_level(cell, asked.accuracy), len(tried) - 1) :]
        ),
        "gigabytes": peak(),
        "gigabytes_estimated": used.memory(cell) / 1e9,
    }


def read(path: Path) -> list[dict[str, str]]:
    """Rows of an earlier run."""
    if not path.exists():
        return []
    with path.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def survey(seed: int, count: int, gigabytes: float) -> None:
    """Compute what is not in the file yet, then write the summary."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    path = FOLDER / "designs.csv"
    done = {(int(row["seed"]), int(row["number"])) for row in read(path)}

    def estimated(number: int) -> float:
        return float(decided(seed, number, 1e9 * gigabytes).get("seconds_estimated", 0.0))

    for number in sorted(range(count), key=estimated):  # a run may be stopped
        if (seed, number) in done:
            continue
        command = [sys.executable, "-W", "ignore", __file__, "--one", str(number), "--seed", str(seed)]
        command += ["--memory", f"{gigabytes:g}"]
        while psutil.virtual_memory().available < 1e9 * gigabytes:  # others need it now
            time.sleep(5.0)
        answer = subprocess.run(command, capture_output=True, text=True, check=False)
        if answer.returncode:
            row = {"seed": seed, "number": number, "kind": study_text(seed, number)[0], "outcome": "failed"}
            print(answer.stderr[-2000:], file=sys.stderr)
        else:
            row = json.loads(answer.stdout)
        fresh = not path.exists()
        with path.open("a", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, NAMES)
            if fresh:
                writer.writeheader()
            writer.writerow(row)
        print(row, flush=True)
    write("answered_in_budget", summary([row for row in read(path) if int(row["seed"]) == seed]))


def summary(rows: list[dict[str, str]]) -> dict[str, Any]:
    """How many ended how; quantiles of what was estimated over what was used."""
    outcomes = [row["outcome"] for row in rows]
    ratios = {
        name: [float(row[f"{name}_estimated"]) / float(row[name]) for row in rows if row["reached"]]
        for name in ("gigabytes", "seconds")
    }
    return {
        "designs": len(rows),
        "outcomes": {outcome: outcomes.count(outcome) for outcome in sorted(set(outcomes))},
        **{f"{name}_ratio": np.quantile(of, [0, 0.5, 1]).tolist() for name, of in ratios.items() if of},
    }


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--one", type=int, help="Compute this design here and print its row.")
    parser.add_argument("--memory", type=float, default=8.0, metavar="GB", help="That meshes may take.")
    parser.add_argument("--decide", action="store_true", help="Only print what is begun, compute nothing.")
    given = parser.parse_args()
    warnings.simplefilter("ignore")
    if given.one is not None:
        print(json.dumps(computed(given.seed, given.one, 1e9 * given.memory)))
    elif given.decide:
        for number in range(given.count):
            print(decided(given.seed, number, 1e9 * given.memory))
    else:
        survey(given.seed, given.count, given.memory)
