"""Claim: time and memory of a plate grow as a power of its pillars; what no longer fits is refused before it
starts. The prototype's map with fewer and more rows, from zero to 100 kHz, at a tenth of its lines."""

from __future__ import annotations

import json
import subprocess
import sys
import time
from dataclasses import replace

import numpy as np
from record import STUDY, peak_memory, write

import haptonic
from haptonic.errors import ResourceError
from haptonic.plate import Band, Layout, Plate, PlateModel
from haptonic.results.plate.question import unit_drives

ROWS = (10, 15, 20, 30, 60, 220)
POINTS = 101


def plate_of(rows: int) -> Plate:
    """The prototype with so many rows of tiles, its patch where it was."""
    plate = haptonic.load(STUDY).plate()
    layout = plate.layout
    pitch = layout.y[1]
    y = tuple((pitch * np.arange(rows + 1)).tolist())
    tiles = (layout.tiles[0],) * rows
    taller = Layout(tiles, layout.x, y, layout.cells, layout.thickness, layout.material)
    return replace(plate, layout=taller)


def measured(rows: int) -> dict[str, object]:
    plate = plate_of(rows)
    start = time.perf_counter()
    model = PlateModel.of(plate, 1e5)
    found: dict[str, object] = {"pillars": plate.layout.pillars, "unknowns": model.assembly.size}
    try:
        band = Band.of(model, 100.0, 1e5)
    except ResourceError as error:
        return {**found, "refused_after_s": time.perf_counter() - start, "said": error.parts()["cause"]}
    answer = band.reduced.answer(unit_drives(plate), 2 * np.pi * np.linspace(100.0, 1e5, POINTS))
    return {
        **found,
        "basis": band.reduced.basis.dimension,
        "seconds": time.perf_counter() - start,
        "peak_bytes": peak_memory(),
        "largest_bound": float(answer.error.max()),
    }


def main() -> None:
    plates = []
    for rows in ROWS:  # each in a process of its own: peak memory is a process's
        own = subprocess.run(
            [sys.executable, __file__, str(rows)], capture_output=True, text=True, check=True
        )
        plates.append(json.loads(own.stdout))
    done = [one for one in plates if "seconds" in one]
    pillars = np.log([one["pillars"] for one in done])
    write(
        "plate_growth",
        {
            "plates": plates,
            "lines": POINTS,
            "exponents": {
                name: float(np.polyfit(pillars, np.log([one[name] for one in done]), 1)[0])
                for name in ("seconds", "peak_bytes", "basis", "unknowns")
            },
        },
    )


if __name__ == "__main__":
    if len(sys.argv) > 1:
        print(json.dumps(measured(int(sys.argv[1]))))
    else:
        main()
