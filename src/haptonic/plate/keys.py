"""What the parts of a plate are called inside: values, so that a name may hold any character."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Kind = Literal["plate", "actuator", "support", "supports", "finger"]
Role = Literal["", "bond", "ceramic", "field", "dielectric"]


@dataclass(frozen=True)
class PartKey:
    """What stores or loses energy.

    owner : name of the actuator, or number of the support; role : what of an actuator it is
    """

    kind: Kind
    owner: str | int = ""
    role: Role = ""

    def __str__(self) -> str:
        """For people and files. No two keys share it: only those of actuators end in their role."""
        return f"{self.owner} {self.role}" if self.role else f"{self.kind} {self.owner}".rstrip()


PLATE = PartKey("plate")
SUPPORTS = PartKey("supports")  # all together
FINGER = PartKey("finger")


def bond(actuator: str) -> PartKey:
    """The glue below it."""
    return PartKey("actuator", actuator, "bond")


def ceramic(actuator: str) -> PartKey:
    """Its stiffness at a constant electric field, c^E."""
    return PartKey("actuator", actuator, "ceramic")


def electric(actuator: str) -> PartKey:
    """What the electric field in it adds while its electrodes are at given voltage."""
    return PartKey("actuator", actuator, "field")


def dielectric(actuator: str) -> PartKey:
    """Its capacitance while nothing moves."""
    return PartKey("actuator", actuator, "dielectric")


def support(number: int) -> PartKey:
    """The springs of one support."""
    return PartKey("support", number)
