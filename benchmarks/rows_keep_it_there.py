"""Claim: three rows of the lattice keep the prototype's vibration in its guide. The same plate with none to
four between its guides, driven by its patch, at the resonance of the driven guide in the gap."""

from __future__ import annotations

import time

from record import STUDY, write

import haptonic
from haptonic.results.plate.variants import Look, resonance, with_rows

ROWS = (0, 1, 2, 3, 4)
GUIDE_MODE = "0x17"  # of the prototype: nodal lines across, intervals between nodal lines along
BETWEEN = (54.5e3, 58.5e3)  # Hz, in the gap


def main() -> None:
    study = haptonic.load(STUDY)
    plate, section = study.mounted_plate(), study.finite_plate
    assert section is not None
    first, second = plate.layout.regions
    asked = section.response
    look = Look(*BETWEEN, GUIDE_MODE, asked.grid, asked.tolerance)
    found, seconds = [], []
    for rows in ROWS:
        start = time.perf_counter()
        found.append(resonance(with_rows(plate, first, second, rows), look, first, second))
        seconds.append(time.perf_counter() - start)
    mirror = study.layers()
    family = mirror.families[0]
    guide = study.waveguide().to_json()["nearest"]
    write(
        "rows_keep_it_there",
        {
            "rows": list(ROWS),
            "resonance_hz": [frequency for frequency, _ in found],
            "contrast_db": [level for _, level in found],
            "seconds": seconds,
            "family": family,
            "mirror_db": [0.0, *mirror.insulation(family)[: max(ROWS)].tolist()],
            "guide_db_per_row": guide["decay_db_per_row"],
        },
    )


if __name__ == "__main__":
    main()
