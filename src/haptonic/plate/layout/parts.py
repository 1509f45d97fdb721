"""Parts on a plate: actuators, forces, a finger; and the plate with all of them.

Positions in a study are relative to the corner of the given region, or without a region to that of the plate.
"""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass, replace
from typing import Annotated, ClassVar

import numpy as np

from haptonic.fields import (
    CARRIER,
    LARGEST,
    Aliases,
    Name,
    Quantity,
    described,
    meant,
    needed,
    problem,
    setting,
    size,
)
from haptonic.materials import GIVEN, Material, PiezoelectricMaterial
from haptonic.materials.library import CERAMIC
from haptonic.plate.layout.grid import Layout
from haptonic.plate.layout.supports import Support
from haptonic.units import format_quantity

Position = Annotated[float, Quantity("m", at_least=-LARGEST, at_most=LARGEST)]
Width = Annotated[float, size(100e-9, 100e-3)]
PatchThickness = Annotated[float, size(10e-9, 10e-3)]
BondThickness = Annotated[float, size(1e-9, 1e-3)]
Phase = Annotated[float, Quantity("rad", at_least=-2 * math.pi, at_most=2 * math.pi)]
CENTRE = "Position from the lower left corner of the smallest rectangle around the region, or the plate."


Carrier = Annotated[float, CARRIER]
OWN_CARRIER = "Frequency of the drive, if not the study's. Drives of different frequencies act separately."


@described("plate.actuator.bond")
class Bond:
    """The layer of glue below an actuator."""

    thickness: BondThickness = needed(
        "Thickness of the layer of glue.", title="Thickness of the bond", examples=["50 um"]
    )
    material: Annotated[Material, GIVEN] = needed(
        "A built-in name or its constants.", title="Material of the bond"
    )


@described("plate.actuator")
class Actuator:
    """Piezoelectric patch on the face with the pillars, poled along z, with an electrode on each face.

    The voltage is that of its free electrode relative to the glued one.
    """

    aliases: ClassVar[Aliases] = {
        **meant("carrier", "frequency", "f", "drive_frequency"),
        **meant("centre", "center", "position", "at", "place", "x", "y"),
        **meant(
            "size", "width", "length", "height", "thickness", "diameter", "radius",
            cause="a patch is a rectangle that is given by its three sizes",
            next_step='write size = ["11.5 mm", "8 mm", "0.7 mm"]: along x, along y, and its thickness',
        ),
        **meant("voltage", "amplitude", "drive", "v"),
        **meant("region", "guide", "waveguide", "tile"),
        **meant("bond", "glue", "adhesive"),
    }  # fmt: skip

    name: Name = needed("Name in results.", examples=["A1"])
    centre: tuple[Position, Position] = needed(CENTRE)
    size: tuple[Width, Width, PatchThickness] = needed(
        "Size along x, size along y, and thickness.", examples=['["11.5 mm", "8 mm", "0.7 mm"]']
    )
    material: Annotated[PiezoelectricMaterial, CERAMIC] = needed(
        "A built-in piezoelectric one, or its constants; poled along z."
    )
    bond: Bond | None = setting(None, "Layer of glue; without it the patch is joined to the plate directly.")
    voltage: Annotated[float, Quantity("V", at_least=0.0, at_most=1e5, typical=(0.0, 1e3))] = setting(
        1.0, "Amplitude between the electrodes on its two faces."
    )
    phase: Phase = setting(0.0, "Phase of the voltage.")
    carrier: Carrier | None = setting(None, OWN_CARRIER, title="Carrier of the patch", examples=["76 kHz"])
    region: Name | None = setting(
        None, "Region of plain plate under the whole patch; by default any.", examples=["WG1"]
    )

    def __post_init__(self) -> None:
        *sides, thickness = self.size
        if thickness > min(sides):
            raise problem(
                "out-of-range",
                format_quantity(thickness, "m"),
                f"at most its shorter side, {format_quantity(min(sides), 'm')}",
                "the sizes are in another order, or this is a stack, which has more than two electrodes",
                "write size = [along x, along y, thickness]",
                at="size",
            )

    @property
    def amplitude(self) -> complex:
        """Complex amplitude of the voltage, V."""
        return _phasor(self.voltage, self.phase)


@described("plate.force")
class Force:
    """Force normal to the flat face, at a point or spread evenly over a rectangle."""

    aliases: ClassVar[Aliases] = {
        **meant("carrier", "frequency", "f", "drive_frequency"),
        **meant("centre", "center", "position", "at", "place", "x", "y"),
        **meant("force", "amplitude", "f0"),
    }

    name: Name = needed("Name in results.", examples=["F1"])
    centre: tuple[Position, Position] = needed(CENTRE)
    size: tuple[Width, Width] | None = setting(
        None,
        "Size along x and along y; without it the force acts at a point.",
        examples=['["2 mm", "2 mm"]'],
    )
    force: Annotated[float, Quantity("N", at_least=0.0, at_most=1e6, typical=(0.0, 100.0))] = setting(
        1.0, "Amplitude of its total."
    )
    phase: Phase = setting(0.0, "Phase of the force.")
    carrier: Carrier | None = setting(None, OWN_CARRIER, title="Carrier of the force", examples=["76 kHz"])
    region: Name | None = setting(
        None, "Region or lattice that contains the whole force; by default any.", examples=["WG1"]
    )

    @property
    def amplitude(self) -> complex:
        """Complex amplitude of the force, N."""
        return _phasor(self.force, self.phase)


@described("plate.finger")
class Finger:
    """Finger on the flat face: a mass on a spring and a damper, spread over a disc.

    It acts on normal motion only. The pad is a foundation of springs and dampers with a mass at the other end
    of each, so the impedance per area is uniform over the disc; the values are totals over the disc.
    """

    centre: tuple[Position, Position] = needed(CENTRE)
    diameter: Annotated[float, size(1e-3, 40e-3)] = setting(10e-3, "Diameter of the disc that it touches.")
    mass: Annotated[float, Quantity("kg", above=0.0, at_most=1e3, typical=(1e-5, 1.0))] | None = setting(
        None, "Mass that vibrates with the pad; without it spring and damper end at rest."
    )
    stiffness: Annotated[float, Quantity("N/m", at_least=0.0, at_most=1e12, typical=(0.0, 1e6))] = setting(
        0.0, "Value for the whole disc.", title="Stiffness of the pad"
    )
    damping: Annotated[float, Quantity("N s/m", at_least=0.0, at_most=1e9, typical=(0.0, 1e3))] = setting(
        0.0, "Value for the whole disc.", title="Damping of the pad"
    )
    region: Name | None = setting(
        None, "Region or lattice from whose corner the centre counts; by default the plate.", examples=["WG1"]
    )

    def __post_init__(self) -> None:
        if self.stiffness == 0 and self.damping == 0:
            raise problem(
                "missing",
                "neither stiffness nor damping",
                "at least one of them above zero",
                "nothing ties the finger to the plate",
                'add damping = "10 N s/m", or remove the finger',
                at="damping",
            )


def _phasor(amplitude: float, phase: float) -> complex:
    """Amplitude times exp(i phase); quarter turns, such as antiphase, are exact."""
    quarters = round(phase / (0.5 * math.pi))
    if abs(phase - quarters * 0.5 * math.pi) < 1e-12:
        return amplitude * (1, 1j, -1, -1j)[quarters % 4]
    return cmath.rect(amplitude, phase)


@dataclass(frozen=True)
class Plate:
    """Plate with supports, drives, finger and losses.

    loss_factor : of plate and pillars
    """

    layout: Layout
    supports: tuple[Support, ...] = ()
    actuators: tuple[Actuator, ...] = ()
    forces: tuple[Force, ...] = ()
    finger: Finger | None = None
    loss_factor: float = 0.0

    @property
    def drives(self) -> tuple[Actuator | Force, ...]:
        """Actuators, then forces."""
        return (*self.actuators, *self.forces)

    def carriers(self, usual: float) -> tuple[float, ...]:
        """Different frequencies of the drives with an amplitude, Hz; ``usual`` is that of all without one."""
        return tuple(dict.fromkeys(drive.carrier or usual for drive in self.drives if drive.amplitude))

    def driven_at(self, carrier: float, usual: float) -> Plate:
        """The plate with the drives of one carrier, Hz; all others get no amplitude.

        usual : frequency of drives without a carrier of their own
        """

        def acts(drive: Actuator | Force) -> bool:
            return (drive.carrier or usual) == carrier

        return replace(
            self,
            actuators=tuple(
                patch if acts(patch) else replace(patch, voltage=0.0) for patch in self.actuators
            ),
            forces=tuple(force if acts(force) else replace(force, force=0.0) for force in self.forces),
        )

    @property
    def rigid_modes(self) -> int:
        """Number of rigid-body motions that the supports allow: 6 for a plate without supports."""
        if any(support.hold != "simple" for support in self.supports):
            return 0  # a supported piece of a face cannot rotate
        conditions = [row for support in self.supports for row in self._simply_held(support)]
        return 6 - int(np.linalg.matrix_rank(np.array(conditions))) if conditions else 6

    @property
    def rigid(self) -> bool:
        """True if a rigid-body motion is possible, so the static problem has no solution."""
        return self.rigid_modes > 0

    def _simply_held(self, support: Support) -> list[list[float]]:
        """Rows whose product with a rigid motion (3 shifts, 3 turns by the plate's width) must be 0."""
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
