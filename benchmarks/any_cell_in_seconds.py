"""Claim: the diagram of a hole or an inclusion takes 1.5 s, that of a CAD file's solids half a minute.

Each has 66 wavevectors, 10 bands and an accuracy of 2e-3, as in ``diagram_in_a_second.py``. The reference
pillar is computed from a STEP file at 3e-3, and in blocks at the same accuracy. The errors of both are the
largest at the zone's corners, against the converged values of a third code.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from diagram_in_a_second import along_path
from record import CORNERS, ROOT, STUDY, fresh, timed, true_error, write
from threadpoolctl import threadpool_limits

import haptonic
from haptonic.bloch import BlochModel
from haptonic.bloch.settings import BandSettings
from haptonic.cell import Disc, Solid, SolidPart, UnitCell
from haptonic.lattice import Lattice

sys.path.insert(0, str(ROOT / "tests"))
from cad_cells import step_of
from stacks import STACKS

MM = 1e-3
COUNT, POINTS = 10, 66
ACCURACY, ACCURACY_OF_FILES = 2e-3, 3e-3
LATTICES = {"square": Lattice.square(7 * MM), "triangular": Lattice.triangular(7 * MM)}
SNOWFLAKE = Disc(5.74 * MM, section="snowflake", arm_width=1.05 * MM, corner_radius=0.21 * MM, empty=True)


def diagram(cell: UnitCell, accuracy: float) -> BlochModel:
    return along_path(cell, BandSettings(COUNT, points=POINTS, accuracy=accuracy))


def figures(model: BlochModel, seconds: float) -> dict[str, Any]:
    return {
        "order": model.resolution.order,
        "unknowns": model.fine.tiling.meshes[0].unknowns,
        "seconds": seconds,
        "largest_estimate": model.worst_error,
    }


def of_discs(name: str, lattice: str) -> dict[str, Any]:
    plate = haptonic.load(STUDY).cell
    discs = (SNOWFLAKE,) if name == "snowflake" else STACKS[name]
    cell = UnitCell(LATTICES[lattice], plate.thickness, plate.material, disc=discs)
    diagram(cell, ACCURACY)  # the index work of the topology
    seconds, model = timed(lambda: diagram(fresh(cell), ACCURACY), repeats=3)
    return {"cell": name, "lattice": lattice, **figures(model, seconds)}


def of_pillar(cell: UnitCell, name: str) -> dict[str, Any]:
    seconds, model = timed(lambda: diagram(fresh(cell), ACCURACY_OF_FILES))
    at_corners = {corner: model.solve(np.array(kappa)).frequency for corner, kappa in CORNERS.items()}
    return {"cell": name, **figures(model, seconds), "true_error": true_error(at_corners)}


def of_a_file(folder: Path) -> list[dict[str, Any]]:
    """The reference pillar in blocks, and from a STEP file."""
    blocks = haptonic.load(STUDY).cell
    assert blocks.pillar is not None
    disc = Disc(blocks.pillar.diameter, low=0.0, high=blocks.pillar.height)
    stack = UnitCell(blocks.lattice, blocks.thickness, blocks.material, disc=(disc,))
    path, names = step_of(stack, folder / "cell.step")
    parts = tuple(SolidPart(name=name, material=solid) for name, solid in names.items())
    solids = UnitCell(blocks.lattice, blocks.thickness, blocks.material, solid=Solid(str(path), part=parts))
    return [of_pillar(blocks, "blocks"), of_pillar(solids, "STEP file")]


def main() -> None:
    with threadpool_limits(1), tempfile.TemporaryDirectory() as folder:
        names = "hole", "inclusion", "coated inclusion"
        discs = [of_discs(name, lattice) for name in names for lattice in LATTICES]
        write(
            "any_cell_in_seconds",
            {
                "discs": [*discs, of_discs("snowflake", "triangular")],
                "accuracy": ACCURACY,
                "pillar": of_a_file(Path(folder)),
                "accuracy_of_files": ACCURACY_OF_FILES,
            },
        )


if __name__ == "__main__":
    main()
