"""Claim: time and memory of a plate grow as a power of its pillars; what no longer fits is refused before it
starts. The prototype's map with fewer and more rows: one frequency, which needs no basis, and a tenth of the
lines from zero to 100 kHz."""

from __future__ import annotations

import json
import sys
import time
from dataclasses import replace

import numpy as np
from record import STUDY, apart, peak_memory, write

import haptonic
from haptonic.errors import ResourceError
from haptonic.plate import Band, Layout, Plate, PlateModel
from haptonic.plate.layout.sampling import unit_drives

ROWS = (10, 15, 20, 30, 60, 220)
POINTS = 101
ONE = 56.43e3  # Hz
TOLERANCE = 1e-3


def plate_of(rows: int) -> Plate:
    """The prototype with so many rows of tiles, its patch where it was."""
    plate = haptonic.load(STUDY).mounted_plate()
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
    figures: dict[str, object] = {"pillars": plate.layout.pillars, "unknowns": model.assembly.size}
    tiles = time.perf_counter() - start
    _, line = Band.of(model, ONE, ONE).answer(unit_drives(plate), np.array([ONE]), TOLERANCE)
    figures |= {
        "one_seconds": time.perf_counter() - start,
        "one_peak_bytes": peak_memory(),
        "one_bound": float(line.error[0]),
    }
    start = time.perf_counter() - tiles
    try:
        band = Band.of(model, 100.0, 1e5)
    except ResourceError as error:
        return {**figures, "refused_after_s": time.perf_counter() - start, "said": error.parts()["cause"]}
    answer = band.reduced.answer(unit_drives(plate), 2 * np.pi * np.linspace(100.0, 1e5, POINTS))
    return {
        **figures,
        "basis": band.reduced.basis.dimension,
        "seconds": time.perf_counter() - start,
        "peak_bytes": peak_memory(),
        "largest_bound": float(answer.error.max()),
    }


def main() -> None:
    plates = [apart(__file__, rows) for rows in ROWS]
    write("plate_growth", {"plates": plates, "lines": POINTS, "one_hz": ONE, "exponents": exponents(plates)})


def exponents(plates: list[dict[str, float]]) -> dict[str, float]:
    """Exponents over the number of pillars, for every figure that is known of two plates at least."""
    fitted = {}
    for name in ("seconds", "peak_bytes", "basis", "unknowns", "one_seconds", "one_peak_bytes"):
        known = [(plate["pillars"], plate[name]) for plate in plates if name in plate]
        pillars, value = np.log(np.array(known)).T
        fitted[name] = float(np.polyfit(pillars, value, 1)[0])
    return fitted


if __name__ == "__main__":
    if len(sys.argv) > 1:
        print(json.dumps(measured(int(sys.argv[1]))))
    else:
        main()
