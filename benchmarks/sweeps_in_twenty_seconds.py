"""Claim: the two sweeps of the reference study, 50 designs with complete gaps, take 20 s on two cores."""

from __future__ import annotations

import tempfile
import time
from pathlib import Path

from record import STUDY, write

import haptonic
from haptonic.store import Store

WORKERS = 2


def main() -> None:
    study = haptonic.load(STUDY)
    finished: list[float] = []
    with tempfile.TemporaryDirectory() as folder:
        start = time.perf_counter()
        sweeps = study.swept(
            store=Store(Path(folder)),
            workers=WORKERS,
            on_progress=lambda *_: finished.append(time.perf_counter() - start),
        )
        total = time.perf_counter() - start
    half = len(finished) // 2
    write(
        "sweeps_in_twenty_seconds",
        {
            "workers": WORKERS,
            "designs": sum(sweep.dataset.sizes["step"] for sweep in sweeps),
            "failed": sum(len(sweep.failed) for sweep in sweeps),
            "total_s": total,
            "first_design_s": finished[0],
            "per_design_s": (finished[-1] - finished[half]) / (len(finished) - 1 - half),
        },
    )


if __name__ == "__main__":
    main()
