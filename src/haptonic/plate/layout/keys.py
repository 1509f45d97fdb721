"""Keys of the parts of a plate; they are values, so names may contain any character."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Kind = Literal["plate", "actuator", "support", "supports", "finger"]
Role = Literal["", "bond", "ceramic", "field", "dielectric"]


@dataclass(frozen=True)
class PartKey:
    """Key of a part that stores or loses energy.

    owner : name of the actuator, or number of the support; role : part of an actuator
    """

    kind: Kind
    owner: str | int = ""
    role: Role = ""

    def __str__(self) -> str:
        """Text for people and files, unique for each key: only keys of actuators end in their role."""
        return f"{self.owner} {self.role}" if self.role else f"{self.kind} {self.owner}".rstrip()


PLATE = PartKey("plate")
SUPPORTS = PartKey("supports")  # all together
FINGER = PartKey("finger")


def bond(actuator: str) -> PartKey:
    """Key of the glue below an actuator."""
    return PartKey("actuator", actuator, "bond")


def ceramic(actuator: str) -> PartKey:
    """Key of an actuator's stiffness at a constant electric field, c^E."""
    return PartKey("actuator", actuator, "ceramic")


def electric(actuator: str) -> PartKey:
    """Key of the stiffness due to the electric field at given voltage of the electrodes."""
    return PartKey("actuator", actuator, "field")


def dielectric(actuator: str) -> PartKey:
    """Key of an actuator's capacitance at rest."""
    return PartKey("actuator", actuator, "dielectric")


def support(number: int) -> PartKey:
    """Key of the springs of a support."""
    return PartKey("support", number)
