"""Stacks of discs, by what they make, that several tests share; for a plate of 1.5 mm at a pitch of 7 mm."""

from haptonic.cell import Disc
from haptonic.materials import material

MM = 1e-3
EPOXY, STEEL = material("epoxy"), material("steel")


def above(diameter: float, low: float, high: float, **more: object) -> Disc:
    """A disc above the plate; lengths in mm."""
    return Disc(diameter * MM, low=low * MM, high=high * MM, **more)  # type: ignore[arg-type]


STACKS = {
    "hole": (Disc(4 * MM, empty=True),),
    "blind hole": (Disc(4 * MM, low=-0.7 * MM, empty=True),),
    "inclusion": (Disc(4 * MM, material=STEEL),),
    "coated inclusion": (Disc(5 * MM, material=EPOXY), Disc(4 * MM, material=STEEL)),
    "pillar on glue": (above(3, 0, 0.5, material=EPOXY), above(3, 0.5, 4, material=STEEL)),
    "cap": (above(2.5, 0, 3), above(4.5, 3, 4)),
    "hollow pillar": (above(4, 0, 4), above(2.5, 0, 4, empty=True)),
}
