"""Claim: three rows of the lattice keep the prototype's vibration in its guide. The same plate with none to
four between its guides, driven by its patch, at the resonance of the driven guide in the gap."""

from __future__ import annotations

import time
from dataclasses import replace

import numpy as np
from record import STUDY, write

import haptonic
from haptonic.plate import Layout, Plate
from haptonic.plate.layout.sampling import grid_points
from haptonic.plate.vibration.responses import responded
from haptonic.response import contrast, rms

ROWS = (0, 1, 2, 3, 4)
LINE = 20.0  # Hz between the lines among which a resonance is looked for
BETWEEN = (54.5e3, 58.5e3)  # Hz, in the gap


def with_rows(plate: Plate, first: str, second: str, rows: int) -> Plate:
    """A plate with so many columns of lattice between two regions that span all of its height.

    What is attached right of the first region is left away.
    """
    layout = plate.layout
    left = max(j for _, j in layout.of(first)) + 1
    right = min(j for _, j in layout.of(second))
    assert left < right, f"no lattice between {first} and {second}"
    columns = [*range(left), *([left] * rows), *range(right, layout.columns)]
    widths = np.diff(layout.x)[columns]
    tiles = tuple(tuple(row[j] for j in columns) for row in layout.tiles)
    x = tuple(np.concatenate([[0.0], np.cumsum(widths)]).tolist())
    border = layout.x[left]
    return replace(
        plate,
        layout=Layout(tiles, x, layout.y, layout.cells, layout.thickness, layout.material),
        actuators=tuple(actuator for actuator in plate.actuators if actuator.centre[0] < border),
        forces=tuple(force for force in plate.forces if force.centre[0] < border),
        finger=None,
    )


def resonance(
    plate: Plate, between: tuple[float, float], grid: float, tolerance: float, over: str, under: str
) -> tuple[float, float]:
    """Frequency, Hz, at which a region moves most, and its contrast over another one there, dB.

    Parameters
    ----------
    between : Hz, where it is looked for; grid : m; tolerance : field error
    """
    lines = np.arange(between[0], between[1] + LINE / 2, LINE)
    response = responded(plate, lines, *grid_points(plate, grid), tolerance)
    loudest = int(rms(response, over).values.argmax())
    return float(lines[loudest]), float(contrast(response, over, under).values[loudest])


def main() -> None:
    study = haptonic.load(STUDY)
    plate, section = study.mounted_plate(), study.plate_settings
    assert section is not None
    first, second = plate.layout.regions
    asked = section.response
    resonances, seconds = [], []
    for rows in ROWS:
        start, varied = time.perf_counter(), with_rows(plate, first, second, rows)
        resonances.append(resonance(varied, BETWEEN, asked.grid, asked.tolerance, first, second))
        seconds.append(time.perf_counter() - start)
    mirror = study.layers()
    family = mirror.families[0]
    guide = study.waveguide().to_json()["nearest"]
    write(
        "rows_keep_it_there",
        {
            "rows": list(ROWS),
            "resonance_hz": [frequency for frequency, _ in resonances],
            "contrast_db": [level for _, level in resonances],
            "seconds": seconds,
            "family": family,
            "mirror_db": [0.0, *mirror.insulation(family)[: max(ROWS)].tolist()],
            "guide_db_per_row": guide["decay_db_per_row"],
        },
    )


if __name__ == "__main__":
    main()
