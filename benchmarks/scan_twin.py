"""Claim: the analysis of a simulated scan of the prototype returns the truth that made it, and 2 GB of time
records at 4444 points are analysed in 30 s and 1 GB on two cores, pictures included."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
import warnings
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
from record import STUDY, write

import haptonic
from haptonic.analyses import scanning
from haptonic.analyses.scanning import Estimation, OnPlate, compute_scan
from haptonic.plate.layout.sampling import driven_region
from haptonic.plate.vibration.region_measures import contrasts
from haptonic.response import FrequencyResponse
from haptonic.results import write_files
from haptonic.results.scan import ScanResult, SimulatedScan
from haptonic.store import Store
from haptonic.vibrometry import ReadReport, Scan, estimate, read_scan
from haptonic.vibrometry.of_settings import drive_for, response_for

SEEDS = range(5)
LONG = '[scan]\nrate = "200 kHz"\nhighest = "80 kHz"\naverages = 56\n\n# Wider and narrower pillars'
# Peaks are read where they begin anew: ru_maxrss of a child begins with that of its parent. Pages of files,
# such as libraries and what the system keeps of the records, count in the first one only.
RUN = r"""
import re, sys, threading, time
from haptonic.cli.app import app
def status(name):
    return int(re.search(name + r":\s+(\d+)", open("/proc/self/status").read())[1])
own = [0]
def watch():
    while True:
        own[0] = max(own[0], status("RssAnon"))
        time.sleep(0.02)
threading.Thread(target=watch, daemon=True).start()
app(sys.argv[1:], standalone_mode=False)
print(time.process_time(), status("VmHWM"), own[0])
"""


def main() -> None:
    warnings.simplefilter("ignore", haptonic.HaptonicWarning)  # the period is shorter than the ring-down
    study, store = haptonic.load(STUDY), Store.default()
    question = study.scan_settings
    section = study.plate_settings
    assert section is not None
    asked = response_for(question, section.response.tolerance, drive_for(question, study.mounted_plate()))
    start = time.perf_counter()
    response = study.plate(settings=asked, store=store).response
    computing = time.perf_counter() - start
    on, results = scanning.on_plate(study), []
    for seed in SEEDS:
        simulated = study.simulate_scan(seed=seed, response=response)
        scan = Scan(simulated.records, ReadReport("twin", "memory", len(simulated.records.names)))
        results.append(errors(compute_scan(scan, Estimation(), on, store=store), simulated, on))
    figures = {
        "points": len(simulated.records.names),
        "computing_s": computing,
        "seeds": len(results),
        "computed_gap_hz": [on.gap.lower, on.gap.upper] if on.gap else None,
        "contrast_range": simulated.truth()["contrast_range"],
        **{name: [result[name] for result in results] for name in results[0]},
    }
    write("scan_twin", figures | stream(response))


def errors(result: ScanResult, simulated: SimulatedScan, on: OnPlate) -> dict[str, Any]:
    """How far a result is from the truth: contrast in dB; edges of the gap with their standard errors, Hz."""
    truth = simulated.truth()
    name = "WG1 over WG2"
    off = np.abs(result.contrasts[name].values - np.array(truth["contrast_db"][name]))
    plain = contrasts(result.response, driven_region(on.plate))[name].values
    lattice = result.lattice
    assert lattice is not None
    return {
        "contrast_db": float(np.nanmax(off)),
        "hidden_lines": int(np.isnan(off).sum()),
        "plain_contrast_db": float(np.abs(plain - np.array(truth["contrast_db"][name])).max()),
        "lower": lattice.lower and asdict(lattice.lower),
        "upper": lattice.upper and asdict(lattice.upper),
    }


def stream(response: FrequencyResponse) -> dict[str, Any]:
    """Two gigabytes of records, written, analysed by the command twice, and removed.

    The first time nothing is in the store: gap and waves of the lattice are computed as well.
    """
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        path = place / "study.toml"
        path.write_text(STUDY.read_text("utf-8").replace("# Wider and narrower pillars", LONG), "utf-8")
        study = haptonic.load(path)
        cut = response.between(study.scan_settings.lowest, study.scan_settings.highest)
        start = time.perf_counter()
        write_files(place, study.simulate_scan(response=cut).files, overwrite=False)
        writing = time.perf_counter() - start
        own = {"OMP_NUM_THREADS": "2", "HAPTONIC_STORE": str(place / "store")}
        runs = []
        for name in ("first", "second"):
            load = os.getloadavg()[0]
            start = time.perf_counter()
            done = subprocess.run(
                [sys.executable, "-c", RUN, "scan", place / "scan.h5", path, "--out", place / name],
                capture_output=True, text=True, check=True, env=os.environ | own,
            )  # fmt: skip
            wall = time.perf_counter() - start
            processor, peak, anonymous = map(float, done.stdout.split()[-3:])
            runs.append({
                "analysing_s": wall, "processor_s": processor, "peak_bytes": 1024 * peak,
                "anonymous_bytes": 1024 * anonymous, "load_before": load,
            })  # fmt: skip
        records = read_scan(place / "scan.h5").records
        band, period = (
            (study.scan_settings.lowest, study.scan_settings.highest),
            round(study.scan_settings.record * study.scan_settings.rate),
        )
        start, spent = time.perf_counter(), time.process_time()
        estimate(records, band=band, segment=period, workers=2)
        return {
            "bytes": (place / "scan.h5").stat().st_size,
            "writing_s": writing,
            "runs": runs,
            "estimating_s": time.perf_counter() - start,
            "estimating_processor_s": time.process_time() - spent,
        }


if __name__ == "__main__":
    main()
