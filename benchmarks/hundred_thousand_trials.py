"""Claim: 100 000 trials are analysed in under a minute on two cores, and memory does not grow with them.

The records are simulated: 10 080 strokes, in HDF5 files of a block of 30 each, on the disk before the clock
starts. The larger experiment reads every file ten times, under the names of ten groups of people,
so that the disk's cache helps. Timed is all of `compute_friction`: table, files, filters, statistics; not the
pictures and not the start of Python. Processor time is that of all processes: on a shared machine it
is the better measure.
"""

from __future__ import annotations

import json
import resource
import sys
import tempfile
import time
from pathlib import Path

import h5py
import numpy as np
import pandas as pd
from record import apart, peak_memory, write

from haptonic.analyses.friction import compute_friction
from haptonic.friction.protocol import Protocol
from haptonic.friction.recordings import Sensor
from haptonic.friction.signals import Rules
from haptonic.friction.simulation import Truth, strokes

PARTICIPANTS = 42  # of 240 trials each: 10 080
TIMES = 10
WORKERS = 2


def main() -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        table = simulated(folder)
        runs = []
        for times in (1, TIMES):
            people = range(1, times * PARTICIPANTS + 1)
            names = np.repeat([f"P{number}" for number in people], len(table) // PARTICIPANTS)
            every = pd.concat([table] * times).assign(participant=names)
            every.to_csv(folder / "trials.csv", index=False)
            runs.append(apart(__file__, name))
        size = sum(path.stat().st_size for path in folder.glob("*.h5"))
    write("hundred_thousand_trials", {"workers": WORKERS, "bytes_read": [size, size * TIMES], "runs": runs})


def simulated(folder: Path) -> pd.DataFrame:
    """Files of blocks, and the table of their trials."""
    rows, block = [], []
    protocol = Protocol()
    for label, record, _ in strokes(Truth(), protocol, PARTICIPANTS, seed=1):
        block.append(record)
        name, lasts = f"{label.participant}-{label.block}.h5", len(record.normal) / record.rate
        start = (label.trial - 1) * lasts
        rows.append((*vars(label).values(), name, start, start + lasts, "simulated"))
        if label.trial == protocol.trials:
            with h5py.File(folder / name, "w") as file:
                file.attrs.update(origin="simulated", sample_rate=record.rate)
                for channel, forces in (("Fz", "normal"), ("Fy", "tangential"), ("position", "position")):
                    file[channel] = np.concatenate([getattr(stroke, forces) for stroke in block]).astype("f4")
            block.clear()
    head = ["participant", "block", "trial", "waveguide", "actuation", "file", "start", "stop", "origin"]
    return pd.DataFrame(rows, columns=head)


def measured(folder: Path) -> dict[str, object]:
    marks, processor = [time.perf_counter()], time.process_time()

    def mark(done: int, planned: int, what: str = "") -> None:
        if done == planned:
            marks.append(time.perf_counter())

    result = compute_friction(folder, Sensor(), Rules(), workers=WORKERS, progress=mark)
    marks.append(time.perf_counter())
    assert result.origin == "simulated"
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return {
        "trials": result.trials.sizes["stroke"],
        "participants": len(set(result.trials["participant"].values.tolist())),
        "excluded": sum(result.excluded.values()),
        "records_s": marks[1] - marks[0],
        "statistics_s": marks[2] - marks[1],
        "total_s": marks[2] - marks[0],
        "processor_s": time.process_time() - processor + children.ru_utime + children.ru_stime,
        "peak_bytes": peak_memory(),
        "worker_peak_bytes": 1024.0 * children.ru_maxrss,
        "reduction": {guide: reduction.value for guide, reduction in result.found.reductions.items()},
    }


if __name__ == "__main__":
    if len(sys.argv) > 1:
        print(json.dumps(measured(Path(sys.argv[1]))))
    else:
        main()
