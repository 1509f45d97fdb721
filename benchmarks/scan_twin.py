"""Claim: the analysis of a simulated scan of the prototype returns the truth that made it, and 2 GB of time
records at 4444 points are analysed in 30 s and 1 GB on two cores, pictures included."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
import warnings
from pathlib import Path

import numpy as np
from record import STUDY, write

import haptonic
from haptonic.response import FrequencyResponse
from haptonic.results import write_files
from haptonic.results.scan import Estimation, ScanResult, Twin, compute_scan
from haptonic.store import Store
from haptonic.study import scanning
from haptonic.vibrometry import ReadReport, Scan

SEEDS = range(5)
QUIET = 5e3  # Hz, below which the plate hardly moves
LONG = '[scan]\nrate = "200 kHz"\nhighest = "80 kHz"\naverages = 56\n\n# Wider and narrower pillars'
# the peak is read where it begins anew: ru_maxrss of a child begins with that of its parent
RUN = r"""
import re, sys, time
from haptonic.cli.app import app
app(sys.argv[1:], standalone_mode=False)
print(time.process_time(), re.search(r"VmHWM:\s+(\d+)", open("/proc/self/status").read())[1])
"""


def main() -> None:
    warnings.simplefilter("ignore", haptonic.HaptonicWarning)  # the period is shorter than the ring-down
    study, store = haptonic.load(STUDY), Store.default()
    question = study.scan.frozen()
    section = study.plate_section
    assert section is not None
    asked = question.of_plate(section.response.tolerance, question.drive(study.plate()))
    start = time.perf_counter()
    response = study.vibrating(asked=asked, store=store).response
    computing = time.perf_counter() - start
    on, found = scanning.scanned(study), []
    for seed in SEEDS:
        made = scanning.twin_scan(study, seed=seed, response=response)
        scan = Scan(made.records, ReadReport("twin", "memory", len(made.records.names)))
        found.append(errors(compute_scan(scan, Estimation(), on, store=store), made))
    figures = {
        "points": len(made.records.names),
        "computing_s": computing,
        "seeds": len(found),
        "quiet_hz": QUIET,
        "computed_gap_hz": [on.gap.lower, on.gap.upper] if on.gap else None,
        "true_gap": made.truth()["gap"],
        **{name: [one[name] for one in found] for name in found[0]},
    }
    write("scan_twin", figures | stream(response))


def errors(result: ScanResult, twin: Twin) -> dict[str, float]:
    """How far a result is from the truth: contrast in dB, edges of the gap in standard errors."""
    truth = twin.truth()
    name = "WG1 over WG2"
    off = np.abs(result.contrasts[name].values - np.array(truth["contrast_db"][name]))
    gap = result.measured
    assert gap is not None
    return {
        "contrast_db": float(off[result.response.frequency >= QUIET].max()),
        "contrast_anywhere_db": float(off.max()),
        "lower_errors": abs(gap.lower - truth["gap"]["lower"]) / gap.lower_error,
        "upper_errors": abs(gap.upper - truth["gap"]["upper"]) / gap.upper_error,
    }


def stream(response: FrequencyResponse) -> dict[str, float]:
    """Two gigabytes of records, written, analysed by the command, and removed."""
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        path = place / "study.toml"
        path.write_text(STUDY.read_text("utf-8").replace("# Wider and narrower pillars", LONG), "utf-8")
        study = haptonic.load(path)
        cut = response.between(study.scan.lowest, study.scan.highest)
        start = time.perf_counter()
        write_files(place, scanning.twin_scan(study, response=cut).files("h5", "time"), overwrite=False)
        writing = time.perf_counter() - start
        start = time.perf_counter()
        done = subprocess.run(
            [sys.executable, "-c", RUN, "scan", place / "scan.h5", path, "--out", place / "out"],
            capture_output=True, text=True, check=True, env=os.environ | {"OMP_NUM_THREADS": "2"},
        )  # fmt: skip
        return {
            "bytes": (place / "scan.h5").stat().st_size,
            "writing_s": writing,
            "analysing_s": time.perf_counter() - start,
            "processor_s": float(done.stdout.split()[-2]),
            "peak_bytes": 1024.0 * float(done.stdout.split()[-1]),
        }


if __name__ == "__main__":
    main()
