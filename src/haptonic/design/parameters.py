"""Numbers of a cell that a designer can change, with their names in the study file."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import ClassVar

from pydantic import field_validator

from haptonic.cell import UnitCell
from haptonic.design.discs import DISC, moving_together, reason_of_thickness
from haptonic.fields import ByPattern, OfNumber, described, problem, table
from haptonic.fields.keys import pattern_of

UNITS = ByPattern({
    path: key.unit
    for path, key in sorted(table(UnitCell, "cell.").items(), key=lambda row: row[0].startswith("material."))
    # the bands are lossless; designs follow one mesh, so lattices and sites keep their symmetry
    if key.quantity and key.kind != "quantities" and not path.endswith("material.loss_factor")
    and ".point[]" not in path and not path.endswith(".turn") and not path.startswith("cell.solid.")
})  # fmt: skip
"""Every number of a cell that its bands depend on, and its SI unit; those of the material are last."""

COORDINATE = re.compile(
    r"cell\.(a[12]|site\[\d+\]\.(at|position))(\[\d+\])?|cell(\.site\[\d+\])?\."
    r"(pillar|disc\[\d+\])\.(turn|point\[\d+\]\.[xy])|(.+\.)?material\.turn"
)
FEATURE = re.compile(r"\.(pillar|disc\[\d+\])\.")
"""Part of the path of every number of a pillar or a disc."""
HEIGHT = ".pillar.height"
FILLET = ".pillar.fillet"
"""Ends of paths of numbers of a pillar, whether of all sites or of one.

A fillet's radius may vary, but not to zero: a sharp edge needs another mesh.
"""


@described("")
class OfCell(OfNumber):
    """A value for one number of the cell, or for a named parameter of its numbers."""

    takes_parameters: ClassVar[bool] = True

    @classmethod
    def unit_of(cls, path: str) -> str | None:
        """SI unit of a number of the cell; None for any other path."""
        return UNITS.get(path)

    @classmethod
    def known(cls) -> Sequence[str]:
        """Paths of the numbers of a cell."""
        return tuple(UNITS)

    @field_validator("parameter", mode="before")
    @classmethod
    def _keeps_symmetry(cls, path: object) -> object:
        if isinstance(path, str) and COORDINATE.fullmatch(path):
            raise problem(
                "unsupported",
                path,
                "sizes and angles of the cell, of its pillars and discs, and constants of materials",
                "coordinates, and turns of sections and crystals, change the symmetry, the mesh and the zone",
                "vary it in a [[sweep]]; for a lattice given by its name, cell.pitch, cell.pitch_y, "
                "cell.pitch_2 and cell.angle can be named here",
            )
        return path


def values_of(cell: UnitCell) -> dict[str, float]:
    """All numbers of a cell that can be varied, in SI units, in the order of `UNITS`.

    A sharp edge cannot be varied into a fillet, nor a sharp corner into a round one; an absent step cannot be
    varied. Some sections have no draft, see `Pillar`. For discs see `haptonic.design.discs`.
    """
    together = moving_together(cell)
    numbers = {path: value for path, value in cell.numbers().items()
               if path in together or not DISC.fullmatch(path)}  # fmt: skip
    if reason_of_thickness(cell) is not None:
        del numbers["cell.thickness"]
    for number, pillar in enumerate(cell.pillars):
        if pillar is not None:
            absent = [name for name in ("fillet", "corner_radius") if not getattr(pillar, name)]
            absent += [] if pillar.outline.is_tangential else ["draft"]
            for name in absent:
                numbers.pop(f"{cell.pillar_path(number)}.{name}", None)
    order = list(UNITS)
    paths = [path for path in numbers if path in UNITS]
    return {path: numbers[path] for path in sorted(paths, key=lambda path: order.index(pattern_of(path)))}
