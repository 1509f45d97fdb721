"""The unit cell in the words of the field: a plate of some thickness, one pillar on it."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property

from haptonic.brillouin import IrreducibleZone
from haptonic.cell.pillar import Pillar
from haptonic.errors import GeometryError
from haptonic.lattice import HALF_TURN, Lattice, PointGroup
from haptonic.materials import Material, is_symmetry

SHEET = 0.08  # thickness, in half pitches, below which a plate is thin
SHEET_CLEARANCE = 3.0  # and so narrow a neck, in thicknesses, that it is none
LEAST_CLEARANCE = 0.01  # of the pitch, between a pillar and the nearest side of its cell


@dataclass(frozen=True)
class UnitCell:
    """One period of the plate; its flat face lies at z = 0, the pillar stands on z = ``thickness``.

    Raises
    ------
    GeometryError : sizes that are not positive, a pillar that does not fit into the period, or a material
        that half a turn about the normal does not leave as it is
    """

    lattice: Lattice
    thickness: float
    material: Material
    pillar: Pillar | None = None

    def __post_init__(self) -> None:
        if HALF_TURN not in self.point_group:
            raise GeometryError(
                argument="material",
                given=self.material.name,
                allowed="a material that half a turn about the plate's normal leaves as it is",
                cause="its constants couple motion in the plane with motion out of it",
                next_step="turn the material so that one of its axes is normal to the plate",
            )
        if not (math.isfinite(self.thickness) and self.thickness > 0):
            raise GeometryError(
                argument="cell.thickness",
                given=f"{self.thickness} m",
                allowed="a positive length",
                cause="a size was left at zero or has the wrong sign",
                next_step="give a positive length",
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
        (x1, y1), (x2, y2) = self.lattice.a1, self.lattice.a2
        lattice = replace(self.lattice, a1=(x1 * factor, y1 * factor), a2=(x2 * factor, y2 * factor))
        pillar = self.pillar and self.pillar.scaled(factor)
        return replace(self, lattice=lattice, thickness=self.thickness * factor, pillar=pillar)

    def without_pillar(self) -> UnitCell:
        """The plain plate of the same period."""
        return replace(self, pillar=None)


def _too_wide(pillar: Pillar, room: float) -> GeometryError:
    """A pillar, or its fillet, for which half the width that there is (m) is not enough."""
    free = "so that a hundredth of the pitch stays free on either side"
    sharp = replace(pillar, fillet=0.0)
    if pillar.arc is not None and sharp.widest < room:
        most = pillar.fillet * (room - pillar.radius) / (pillar.arc.centre[0] - pillar.radius)
        return GeometryError(
            argument="cell.pillar.fillet",
            given=f"{pillar.fillet * 1e3:.4g} mm",
            allowed=f"less than {most * 1e3:.4g} mm, {free}",
            cause="the fillet reaches beyond the cell",
            next_step="choose a smaller radius, a thinner pillar or a larger pitch",
        )
    beyond = 2 * (sharp.widest - pillar.radius)
    return GeometryError(
        argument="cell.pillar.diameter",
        given=f"{pillar.diameter * 1e3:g} mm"
        + (f", and {beyond * 1e3:.4g} mm more where the pillar is widest" if beyond else ""),
        allowed=f"less than {(2 * room - beyond) * 1e3:.4g} mm, {free}",
        cause="the pillar is wider than the cell",
        next_step="choose a thinner pillar or a larger pitch",
    )
