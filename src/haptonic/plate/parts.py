"""What is fixed to a plate: supports, actuators, forces, a finger. Positions are those of the plate, m."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from haptonic.materials import Material, PiezoelectricMaterial
from haptonic.plate.layout import Layout
from haptonic.plate.layout import Side as Side

Place = Literal["left", "right", "bottom", "top", "corners"]
Hold = Literal["clamped", "simple", "spring"]


@dataclass(frozen=True)
class Support:
    """What holds the plate at its outer side faces.

    where : the faces that look to one side, or what of them lies next to the corners of the map
    hold : "clamped" no motion; "simple" no motion along the face (hard simple support), normal motion free;
        "spring" an elastic foundation
    length : of the held part of each face from the corner on, m; only for "corners"
    stiffness : of the foundation, per area of side face and alike in all directions, N/m^3; only for "spring"
    loss_factor : of the foundation
    """

    where: Place
    hold: Hold
    length: float | None = None
    stiffness: float | None = None
    loss_factor: float = 0.0


@dataclass(frozen=True)
class Bond:
    """The layer of glue below an actuator. thickness : m"""

    thickness: float
    material: Material


@dataclass(frozen=True)
class Actuator:
    """A piezoelectric patch on the face that carries the pillars, poled along z, an electrode on either face.

    centre : (x, y), m; size : (along x, along y, thickness), m
    bond : None if the patch is one with the plate
    voltage : complex amplitude between its free and its glued electrode, V
    """

    name: str
    centre: tuple[float, float]
    size: tuple[float, float, float]
    material: PiezoelectricMaterial
    bond: Bond | None
    voltage: complex = 1.0


@dataclass(frozen=True)
class Force:
    """A force normal to the flat face, at a point or spread evenly over a rectangle.

    centre : (x, y), m; size : (along x, along y), m, or None for a point
    amplitude : complex, N
    """

    name: str
    centre: tuple[float, float]
    size: tuple[float, float] | None
    amplitude: complex = 1.0


@dataclass(frozen=True)
class Finger:
    """A mass on a spring and damper, spread over a disc of the flat face; it meets normal motion only.

    The pad is a foundation of springs and dampers whose other ends carry a mass each, so that every point of
    the disc feels the same impedance per area. Totals over the disc:

    centre : (x, y), m; diameter : m
    mass : kg; stiffness : N/m; damping : N s/m; mass inf means that the other ends are at rest
    """

    centre: tuple[float, float]
    diameter: float
    mass: float
    stiffness: float
    damping: float


@dataclass(frozen=True)
class Plate:
    """Everything that a computation of a plate needs to know.

    loss_factor : of plate and pillars
    """

    layout: Layout
    supports: tuple[Support, ...] = ()
    actuators: tuple[Actuator, ...] = ()
    forces: tuple[Force, ...] = ()
    finger: Finger | None = None
    loss_factor: float = 0.0

    @property
    def rigid_modes(self) -> int:
        """How many rigid-body motions the supports leave free: 6 of a plate that nothing holds."""
        if any(support.hold != "simple" for support in self.supports):
            return 0  # a piece of a face that cannot turn
        held = [row for support in self.supports for row in self._simply_held(support)]
        return 6 - int(np.linalg.matrix_rank(np.array(held))) if held else 6

    @property
    def rigid(self) -> bool:
        """Whether some rigid-body motion is free, so that the statics of the plate have no solution."""
        return self.rigid_modes > 0

    def _simply_held(self, support: Support) -> list[list[float]]:
        """Rows whose product with a rigid motion (3 shifts, 3 turns by the plate's width) has to vanish."""
        layout, rows = self.layout, []
        normal = 0 if support.where in ("left", "right") else 1
        size = layout.x[-1]
        for tile in layout.edge(support.where) if support.where != "corners" else []:
            left, bottom, right, top = layout.bounds(tile)
            face = [(left if support.where == "left" else right, y) for y in (bottom, top)]
            if normal == 1:
                face = [(x, bottom if support.where == "bottom" else top) for x in (left, right)]
            for x, y in face:
                for z in (0.0, layout.thickness):
                    turns = [[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]]
                    for axis in {0, 1, 2} - {normal}:
                        shift = [float(axis == other) for other in range(3)]
                        rows.append([*shift, *(arm / size for arm in turns[axis])])
        return rows
