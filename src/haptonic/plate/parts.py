"""What is fixed to a plate: supports, actuators, forces, a finger. Positions are those of the plate, m."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from haptonic.materials import Material, PiezoelectricMaterial
from haptonic.plate.layout import Layout

Side = Literal["left", "right", "bottom", "top"]
Place = Literal["left", "right", "bottom", "top", "corners"]
Hold = Literal["clamped", "simple", "spring"]


@dataclass(frozen=True)
class Support:
    """What holds the plate at its outer side faces.

    where : the faces that look to one side, or what of them lies next to the four outermost corners
    hold : "clamped" no motion; "simple" no motion along the face (hard simple support), normal motion free;
        "spring" a bed of springs
    length : of the held part of each face from the corner on, m; only for "corners"
    stiffness : of the bed, per area of side face and alike in all directions, N/m^3; only for "spring"
    loss_factor : of the bed
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

    The pad is a bed of springs and dampers whose other ends carry a mass each, so that every point of the
    disc feels the same impedance per area. Totals over the disc:

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
