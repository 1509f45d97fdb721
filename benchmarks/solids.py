"""Claim: the error printed with a frequency of a CAD file's solids is never below the true one.

Stacks of discs are written as STEP files, computed as solids, and compared with block meshes of order 5; what
these are unsure of counts for the solids. ``--order`` and ``--only`` choose a part.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from record import ROOT, write

sys.path.insert(0, str(ROOT / "tests"))
from cad_cells import step_of
from haptonic.bloch.model import BlochModel
from haptonic.bloch.resolution import Resolution
from haptonic.cell import Disc, Solid, SolidPart, UnitCell
from haptonic.lattice import Lattice
from haptonic.materials import material
from stacks import STACKS

MM = 1e-3
COUNT = 8
KAPPAS = np.pi * np.array([(0.15, 0.05), (1.0, 0.0), (0.6, 0.3)])
LATTICES = {"square": Lattice.square(7 * MM), "triangular": Lattice.triangular(7 * MM)}
PILLARS = {
    "slender pillar": (Disc(2 * MM, low=0.0, high=8 * MM),),
    "stout pillar": (Disc(5 * MM, low=0.0, high=4 * MM),),
    "square pillar": (Disc(3 * MM, low=0.0, high=4 * MM, section="square"),),
}


def judged(name: str, lattice: str, order: int, folder: Path) -> dict[str, object]:
    """One cell as solids and in blocks."""
    plate = material("aluminium-2017a")
    discs = (STACKS | PILLARS)[name]
    cell = UnitCell(LATTICES[lattice], 1.5 * MM, plate, disc=discs)
    path, names = step_of(cell, folder / f"{lattice}.step")
    parts = tuple(SolidPart(name=part, material=solid) for part, solid in names.items())
    start = time.process_time()
    model = BlochModel.of(
        UnitCell(cell.lattice, cell.thickness, plate, solid=Solid(file=str(path), part=parts)),
        Resolution(order, 1),
        COUNT,
        measured=False,
    )
    seconds = time.process_time() - start
    exact = BlochModel.of(cell, Resolution(5, 1), COUNT, measured=False)
    solutions, truths = ([each.solve(kappa) for kappa in KAPPAS] for each in (model, exact))
    frequency, error = (np.array([getattr(s, part) for s in solutions]) for part in ("frequency", "error"))
    true, unsure = (np.array([getattr(s, part) for s in truths]) for part in ("frequency", "error"))
    away = np.abs(frequency - true)
    ratio = error / np.maximum(away, unsure)
    return {
        "cell": name,
        "lattice": lattice,
        "order": order,
        "seconds": seconds,
        "largest_error": float((away / true).max()),
        "largest_estimate": float((error / frequency).max()),
        "below_true": int((error < away - unsure).sum()),
        "least_ratio": float(ratio.min()),
        "median_ratio": float(np.median(ratio)),
    }


def main(orders: list[int], only: list[str]) -> None:
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for order in orders:
            for number, name in enumerate(only or [*PILLARS, *STACKS]):
                row = judged(name, ("square", "triangular")[number % 2], order, Path(folder))
                print(row, flush=True)
                rows.append(row)
    if not only:
        write("solids", {"cells": rows, "below_true": sum(int(str(row["below_true"])) for row in rows)})


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--order", type=int, nargs="*", default=[3, 4])
    parser.add_argument("--only", nargs="*", default=[])
    given = parser.parse_args()
    main(given.order, given.only)
