"""Claim: the two sweeps of the reference study, 50 designs with complete gaps, take 20 s on two cores.

In the first sweep the pillar's diameter varies, and so its foot; in the second its height alone.
"""

from __future__ import annotations

import tempfile
import time
from pathlib import Path

import numpy as np
from record import STUDY, write

import haptonic
from haptonic.store import Store

WORKERS = 2


def per_design(finished: np.ndarray) -> float:
    """Seconds between designs of a sweep that were finished one after the other, start-up left out."""
    return float((finished[-1] - finished[WORKERS]) / (len(finished) - 1 - WORKERS))


def main() -> None:
    study = haptonic.load(STUDY)
    finished: list[float] = []
    with tempfile.TemporaryDirectory() as folder:
        start = time.perf_counter()
        sweeps = study.sweep(
            store=Store(Path(folder)),
            workers=WORKERS,
            progress=lambda *_: finished.append(time.perf_counter() - start),
        ).rows
        total = time.perf_counter() - start
    ends = np.cumsum([sweep.dataset.sizes["step"] for sweep in sweeps])
    first, second = np.split(finished, ends[:-1])  # the sweeps are computed one after the other
    write(
        "sweeps_in_twenty_seconds",
        {
            "workers": WORKERS,
            "designs": sum(sweep.dataset.sizes["step"] for sweep in sweeps),
            "failed": sum(len(sweep.failed) for sweep in sweeps),
            "total_s": total,
            "first_design_s": finished[0],
            "another_foot_each_s": per_design(first),
            "one_foot_for_all_s": per_design(second),
        },
    )


if __name__ == "__main__":
    main()
