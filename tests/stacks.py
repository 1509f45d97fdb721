"""Stacks of discs, by what they make, that several tests share; for a plate of 1.5 mm at a pitch of 7 mm."""

import math

from haptonic.cell import Disc
from haptonic.materials import material

MM = 1e-3
EPOXY, STEEL = material("epoxy"), material("steel")
RIGHT = math.radians(45)


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

DRAFTED = {
    "countersunk hole": (
        Disc(3 * MM, high=-0.6 * MM, empty=True),
        Disc(3 * MM, low=-0.6 * MM, draft=-RIGHT, empty=True),
    ),
    "chamfered pillar": (above(3, 0, 3.5), above(3, 3.5, 4, draft=RIGHT)),
    "drafted coated inclusion": (
        Disc(5 * MM, material=EPOXY, draft=0.2),
        Disc(3.5 * MM, material=STEEL, draft=-0.1),
    ),
    "hollow taper": (above(4.5, 0, 4, draft=0.15), above(3, 0, 4, draft=0.1, empty=True)),
    "cap on a cone": (
        above(2, 0, 2),
        above(2, 2, 3, draft=-RIGHT),
        above(4, 3, 3.6),
        above(4, 3.6, 4, draft=RIGHT),
    ),
    "square cone in a round hole": (
        Disc(5 * MM, material=STEEL),
        Disc(3 * MM, section="square", draft=0.3, empty=True),
    ),
    "undercut": (Disc(4.5 * MM, low=-0.8 * MM, draft=0.7, material=EPOXY),),
}
