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
    with tempfile.TemporaryDirectory() as folder:
        store = Store(Path(folder))
        rows, start = [], time.perf_counter()
        for section in study.sweep:
            before = time.perf_counter()
            sweep = study.swept(section, store=store, workers=WORKERS)
            rows.append(
                {
                    "vary": section.vary,
                    "designs": sweep.dataset.sizes["step"],
                    "failed": len(sweep.failed),
                    "seconds": time.perf_counter() - before,
                }
            )
        total = time.perf_counter() - start
    designs = sum(row["designs"] for row in rows)
    write(
        "sweeps_in_twenty_seconds",
        {
            "workers": WORKERS,
            "sweeps": rows,
            "total_s": total,
            "per_design_s": rows[-1]["seconds"] / rows[-1]["designs"],
            "designs": designs,
        },
    )


if __name__ == "__main__":
    main()
