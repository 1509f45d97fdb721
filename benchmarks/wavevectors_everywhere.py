"""Claim: at any wavevector, in the irreducible zone or outside, a frequency is within its error.

Wavevectors are drawn evenly over three by three zones of twelve cells: all lattices, pillars on one face and
on both, one site, two and three, isotropic metals and a crystal, one without any symmetry. The model carries
each into the irreducible zone; the unreduced pencil of a finer mesh is solved at the wavevector itself and
knows neither a symmetry nor a basis. Each cell has a file, so a run that was stopped continues.
"""

from __future__ import annotations

import argparse
import json
import math
import time
from typing import Any

import numpy as np
from record import ROOT, STUDY, write
from threadpoolctl import threadpool_limits

from haptonic.bloch.candidates import bloch_model
from haptonic.bloch.centred import lattice_pencil
from haptonic.bloch.model import BlochModel
from haptonic.bloch.pencil import eigenpairs, hertz
from haptonic.bloch.representative import BESIDE
from haptonic.bloch.resolution import Resolution
from haptonic.bloch.settings import BandSettings
from haptonic.bloch.truncation import REST
from haptonic.cell import Pillar, Site, UnitCell
from haptonic.lattice import Lattice
from haptonic.materials import Material, material
from haptonic.names import counted
from haptonic.study import load
from haptonic.superelement import Tiling

FOLDER = ROOT / "results" / "wavevectors_everywhere"
WAVEVECTORS, ZONES = 10_000, 3
FINER = 1  # orders of the reference's mesh more than the model's
MM = 1e-3


def cells() -> dict[str, tuple[UnitCell, BandSettings | Resolution]]:
    """Twelve cells, and what is asked of each: an accuracy, or ten bands of a mesh."""
    steel, silicon = material("steel"), material("silicon")
    tall, slim, wide = Pillar(3 * MM, 10 * MM), Pillar(1.8 * MM, 5 * MM), Pillar(2.6 * MM, 6 * MM)
    usual, fine = BandSettings(10, accuracy=1e-2), BandSettings(12, accuracy=2e-3)

    def cell(lattice: Lattice, pillar: Pillar = wide, of: Material = steel, **further: Any) -> UnitCell:
        return UnitCell(lattice, 1.2 * MM, of, pillar, **further)

    def sites(lattice: Lattice, *placed: tuple[float, float, Pillar]) -> UnitCell:
        given = tuple(Site(at=(x, y), pillar=pillar) for x, y, pillar in placed)
        return UnitCell(lattice, 1.2 * MM, steel, site=given)

    square, triangular = Lattice.square(6 * MM), Lattice.triangular(6 * MM)
    honeycomb = UnitCell(
        Lattice(lattice="honeycomb", pitch=9 * MM), 1.2 * MM, steel,
        site=(Site(pillar=slim), Site(pillar=wide)),
    )  # fmt: skip
    kagome = UnitCell(Lattice(lattice="kagome", pitch=9 * MM), 1.2 * MM, steel, slim)
    glide = sites(Lattice.rectangular(7 * MM, 6 * MM), (0.2, 0.3, slim), (0.7, 0.7, slim))
    anywhere = sites(Lattice.square(8 * MM), (0.0, 0.0, wide), (0.4, 0.45, slim))
    return {
        "the touchpad's": (load(STUDY).cell, usual),
        "square, both faces": (cell(square, faces="both"), usual),
        "rectangular": (cell(Lattice.rectangular(6 * MM, 7.3 * MM)), usual),
        "triangular": (cell(triangular, tall), fine),
        "triangular, both faces": (cell(triangular, faces="both"), usual),
        "triangular, silicon": (cell(triangular, of=silicon), usual),
        "centred": (cell(Lattice.centred(7 * MM, 9 * MM)), usual),
        "oblique": (cell(Lattice.oblique(6 * MM, 7 * MM, 1.35)), usual),
        "honeycomb, two pillars": (honeycomb, usual),
        "kagome": (kagome, usual),
        "rectangular, two sites and a glide": (glide, usual),
        "square, two pillars without symmetry": (anywhere, Resolution(3, 1)),
    }  # fmt: skip


def finer(model: BlochModel) -> Any:
    """The unreduced pencil of a finer mesh with more of the interior; by parity where a mirror parts it."""
    used = model.resolution.grown()
    more = Resolution(used.order + FINER, used.foot_rings, used.steps, used.block, used.bands)
    tiling = Tiling.condensed(model.cell, more.plans(model.cell), more.steps, more.block, measured=False)
    return lattice_pencil(tiling)


def measured(
    name: str, cell: UnitCell, settings: BandSettings | Resolution, count: int, seed: int
) -> dict[str, Any]:
    """Draw wavevectors for a cell and compare."""
    start = time.process_time()
    if isinstance(settings, Resolution):
        model = BlochModel.of(cell, settings, 10, measured=False)
    else:
        model = bloch_model(cell, settings)
    reference = finer(model)
    rng = np.random.default_rng(seed)
    drawn = rng.uniform(-ZONES * np.pi, ZONES * np.pi, (count, 2))
    lattice, used = cell.lattice.name, model.resolution
    compared = beyond = outside = uncarried = 0
    largest, ratios, errors = 0.0, [], []
    for kappa in drawn:
        exact = hertz(eigenpairs(reference, kappa, model.count)[0])
        solution = model.solve(kappa)
        moving = exact > 2 * REST * model.highest
        away, error = np.abs(solution.frequency - exact)[moving], solution.error[moving]
        compared += int(moving.sum())
        beyond += int((away > error).sum())
        outside += int(cell.zone.depth(kappa[None])[0] < -BESIDE)
        largest = max(largest, float((away / error).max()))
        ratios.append(float(np.median(error / np.maximum(away, 1e-3 * error))))
        errors.append(float((away / exact[moving]).max()))
        # what the small basis gives outside the zone, for which it was not made
        raw = hertz(eigenpairs(model.fine.pencil, kappa, model.count)[0])
        uncarried += int((np.abs(raw - exact)[moving] > error).any())
    return {
        "cell": name,
        "lattice": lattice,
        "mesh": f"order {used.order}, {counted(used.foot_rings, 'ring')}",
        "basis": model.fine.pencil.size,
        "unreduced": int(reference.size),
        "wavevectors": count,
        "outside": outside,
        "frequencies": compared,
        "beyond": beyond,
        "largest_share": largest,
        "median_ratio": float(np.median(ratios)),
        "largest_error": max(errors),
        "beyond_without_carrying": uncarried,
        "seconds": time.process_time() - start,
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--wavevectors", type=int, default=WAVEVECTORS, help="of all cells together")
    parser.add_argument("--seed", type=int, default=38)
    parser.add_argument("--anew", action="store_true", help="leave out what an earlier run kept")
    given = parser.parse_args()
    drawn = cells()
    each = math.ceil(given.wavevectors / len(drawn))
    FOLDER.mkdir(parents=True, exist_ok=True)
    rows = []
    for number, (name, (cell, settings)) in enumerate(drawn.items()):
        kept = FOLDER / f"{given.seed}-{each}-{number}.json"
        if given.anew or not kept.exists():
            with threadpool_limits(1):
                row = measured(name, cell, settings, each, given.seed + number)
            kept.write_text(json.dumps(row), "utf-8")
        rows.append(json.loads(kept.read_text("utf-8")))
        print(json.dumps(rows[-1]), flush=True)
    summed = ("wavevectors", "outside", "frequencies", "beyond")
    totals = {key: sum(row[key] for row in rows) for key in summed}
    write("wavevectors_everywhere", {"seed": given.seed, "zones": ZONES, **totals, "rows": rows})


if __name__ == "__main__":
    main()
