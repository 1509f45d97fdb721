"""The unit cell in the words of the field: a plate of some thickness, one pillar on it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property
from typing import Annotated

import numpy as np
from pydantic import Field

from haptonic.brillouin import IrreducibleZone
from haptonic.cell.pillar import Pillar
from haptonic.errors import GeometryError
from haptonic.fields import INLINE, TOP, described, numbers, problem, size, with_numbers
from haptonic.lattice import Lattice, PointGroup
from haptonic.materials import GIVEN, Material, is_symmetry

TURNED = np.diag([-1.0, -1.0, 1.0])  # half a turn about the normal
SHEET = 0.08  # thickness, in half pitches, below which a plate is thin
SHEET_CLEARANCE = 3.0  # and so narrow a neck, in thicknesses, that it is none
LEAST_CLEARANCE = 0.01  # of the pitch, between a pillar and the nearest side of its cell


@described("cell", GeometryError)
class UnitCell:
    """One period of the plate; its flat face lies at z = 0, the pillar stands on z = ``thickness``.

    Raises
    ------
    GeometryError : sizes that are not positive, a pillar that does not fit into the period, or a material
        that half a turn about the normal does not leave as it is
    """

    lattice: Annotated[Lattice, INLINE] = Field(title="Lattice", description="How the cells repeat.")
    thickness: Annotated[float, size(20e-6, 20e-3)] = Field(
        title="Plate thickness", description="Without the pillar."
    )
    material: Annotated[Material, GIVEN, TOP] = Field(
        title="Material", description="Of the plate and its pillars: a built-in name or its constants."
    )
    pillar: Pillar | None = Field(
        default=None, title="Pillar", description="Without this table the cell is a piece of plain plate."
    )

    def __post_init__(self) -> None:
        # lattices and outlines always have it; the rest of the group is left until it is asked for
        if not is_symmetry(self.material.stiffness, TURNED):
            raise problem(
                "unsupported",
                self.material.name,
                "a material that half a turn about the plate's normal leaves as it is",
                "its constants couple motion in the plane with motion out of it",
                "turn the material so that one of its axes is normal to the plate",
                at="material",
            )
        if self.pillar is not None and self.pillar.section == "square" and len(self.lattice.neighbours) != 4:
            raise problem(
                "unsupported",
                "square",
                f"round on a {self.lattice.name} lattice",
                "a cell of six sides is meshed around a circle",
                'write section = "round", or take a square or rectangular lattice',
                at="pillar.section",
            )
        if self.pillar is not None and self.clearance < LEAST_CLEARANCE * self.lattice.pitch:
            raise _too_wide(self.pillar, self.inradius - LEAST_CLEARANCE * self.lattice.pitch)

    @cached_property
    def point_group(self) -> PointGroup:
        """The turns and mirrors that leave lattice, pillar and material as they are."""
        return self.lattice.point_group.kept(
            lambda turn: (
                is_symmetry(self.material.stiffness, turn)
                and (self.pillar is None or self.pillar.has_symmetry(turn))
            )
        )

    @cached_property
    def zone(self) -> IrreducibleZone:
        """The part of the Brillouin zone that these operations and time reversal do not repeat."""
        return IrreducibleZone.of(self.lattice, self.point_group)

    @property
    def inradius(self) -> float:
        """Distance from the centre of the cell to its nearest side, m."""
        return self.lattice.inradius

    @property
    def clearance(self) -> float:
        """Free width of plate between the pillar and the nearest side of the cell, m."""
        return self.inradius - (self.pillar.widest if self.pillar else 0.0)

    @property
    def is_thin(self) -> bool:
        """Whether the plate is so thin for its pitch that many of its waves lie below those of its pillar."""
        return self.thickness < SHEET * self.inradius

    @property
    def is_sheet(self) -> bool:
        """Whether the plate is so thin that it bends like a sheet everywhere but at the foot.

        Its waves are as long as those of a thicker one, so that it needs many orders in its plane and few
        through it. With a fillet the foot's rings follow the arc, and there it is none.
        """
        wide = SHEET_CLEARANCE * self.thickness < self.clearance
        return self.is_thin and wide and not (self.pillar and self.pillar.fillet)

    def scaled(self, factor: float) -> UnitCell:
        """The same cell with every length multiplied by ``factor``."""
        pillar = self.pillar and self.pillar.scaled(factor)
        thickness = self.thickness * factor
        return replace(self, lattice=self.lattice.scaled(factor), thickness=thickness, pillar=pillar)

    def numbers(self) -> dict[str, float]:
        """Every number of the cell, in SI units, by its path in a study: ``cell.pillar.diameter``."""
        return numbers(self, "cell.")

    def with_numbers(self, changes: Mapping[str, float]) -> UnitCell:
        """The cell with some of its `numbers` changed, all at once.

        Raises
        ------
        GeometryError : sizes that do not make a body
        """
        return with_numbers(self, changes, "cell.")

    def without_pillar(self) -> UnitCell:
        """The plain plate of the same period."""
        return replace(self, pillar=None)


def _too_wide(pillar: Pillar, room: float) -> Exception:
    """A pillar, or its fillet, for which half the width that there is (m) is not enough."""
    free = "so that a hundredth of the pitch stays free on either side"
    sharp = replace(pillar, fillet=0.0)
    if pillar.arc is not None and sharp.widest < room:
        most = pillar.fillet * (room - pillar.radius) / (pillar.arc.centre[0] - pillar.radius)
        return problem(
            "out-of-range",
            f"{pillar.fillet * 1e3:.4g} mm",
            f"less than {most * 1e3:.4g} mm, {free}",
            "the fillet reaches beyond the cell",
            "choose a smaller radius, a thinner pillar or a larger pitch",
            at="pillar.fillet",
        )
    beyond = 2 * (sharp.widest - pillar.radius)
    return problem(
        "out-of-range",
        f"{pillar.diameter * 1e3:g} mm"
        + (f", and {beyond * 1e3:.4g} mm more where the pillar is widest" if beyond else ""),
        f"less than {(2 * room - beyond) * 1e3:.4g} mm, {free}",
        "the pillar is wider than the cell",
        "choose a thinner pillar or a larger pitch",
        at="pillar.diameter",
    )
