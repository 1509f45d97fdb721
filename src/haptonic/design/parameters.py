"""What a designer can change in a cell, by the names that the study file has for it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from haptonic.cell import UnitCell
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial

UNITS = {
    "cell.pitch": "m",
    "cell.pitch_y": "m",
    "cell.thickness": "m",
    "cell.pillar.diameter": "m",
    "cell.pillar.height": "m",
    "cell.pillar.draft": "rad",
    "cell.pillar.fillet": "m",
    "cell.pillar.step.diameter": "m",
    "cell.pillar.step.height": "m",
    "material.youngs_modulus": "Pa",
    "material.poisson_ratio": "",
    "material.density": "kg/m^3",
}
"""Every number that can be varied, and its SI unit."""


def values_of(cell: UnitCell) -> dict[str, float]:
    """All numbers of a cell that can be varied, in SI units and the order of `UNITS`.

    A sharp edge cannot be varied into a fillet, which would need another mesh; nor can an absent step.
    """
    values = {"cell.pitch": cell.lattice.pitch, "cell.thickness": cell.thickness}
    if cell.lattice.name == "rectangular":
        values["cell.pitch_y"] = float(np.hypot(*cell.lattice.a2))
    if cell.pillar is not None:
        names = ["diameter", "height", "draft"] + ["fillet"] * bool(cell.pillar.fillet)
        values |= {f"cell.pillar.{name}": getattr(cell.pillar, name) for name in names}
        if cell.pillar.step is not None:
            values["cell.pillar.step.diameter"] = cell.pillar.step.diameter
            values["cell.pillar.step.height"] = cell.pillar.step.height
    constants = ["youngs_modulus", "poisson_ratio"] if isinstance(cell.material, IsotropicMaterial) else []
    values |= {f"material.{name}": getattr(cell.material, name) for name in (*constants, "density")}
    return {path: float(values[path]) for path in UNITS if path in values}


def changed(cell: UnitCell, values: Mapping[str, float]) -> UnitCell:
    """The cell with some numbers changed, all at once.

    Raises
    ------
    GeometryError : sizes that do not make a body
    """
    unknown = values.keys() - values_of(cell).keys()
    assert not unknown, f"this cell does not have {unknown}"

    def below(prefix: str) -> dict[str, float]:
        paths = (path for path in values if path.startswith(prefix))
        return {
            path.removeprefix(prefix): values[path] for path in paths if "." not in path.removeprefix(prefix)
        }

    pillar = cell.pillar
    if pillar is not None:
        step = pillar.step and replace(pillar.step, **below("cell.pillar.step."))
        pillar = replace(pillar, step=step, **below("cell.pillar."))  # type: ignore[arg-type]
    own = {**values_of(cell), **values}
    lattice = Lattice.square(own["cell.pitch"])
    if cell.lattice.name == "rectangular":
        lattice = Lattice.rectangular(own["cell.pitch"], own["cell.pitch_y"])
    material = replace(cell.material, **below("material."))  # type: ignore[arg-type]
    return UnitCell(lattice, own["cell.thickness"], material, pillar)
