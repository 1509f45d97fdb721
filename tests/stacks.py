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


def cone(diameter: float, draft: float, height: float, share: float = math.pi / 12) -> tuple[float, float]:
    """Volume, mm^3, and upper diameter, mm, of a cone on its lower diameter; ``share`` 1 / 3 for a square."""
    top = diameter - 2 * height * math.tan(draft)
    return share * height * (diameter**2 + diameter * top + top**2), top


def drafted_volumes(area: float) -> dict[str, dict[str, float]]:
    """Volume of each material, mm^3, for a plate of an area, mm^2."""
    plate, tube = 1.5 * area, math.pi / 4
    sunk, chamfer = cone(3, -RIGHT, 0.6)[0], cone(3, RIGHT, 0.5)[0]
    coated, core = cone(5, 0.2, 1.5)[0], cone(3.5, -0.1, 1.5)[0]
    hollow = cone(4.5, 0.15, 4)[0] - cone(3, 0.1, 4)[0]
    cap = tube * 4 * 2 + cone(2, -RIGHT, 1)[0] + tube * 16 * 0.6 + cone(4, RIGHT, 0.4)[0]
    square, undercut = cone(3, 0.3, 1.5, 1 / 3)[0], cone(4.5, 0.7, 0.8)[0]
    return {
        "countersunk hole": {"metal": plate - sunk - tube * 9 * 0.9},
        "chamfered pillar": {"metal": plate + tube * 9 * 3.5 + chamfer},
        "drafted coated inclusion": {"metal": plate - coated, "epoxy": coated - core, "steel": core},
        "hollow taper": {"metal": plate + hollow},
        "cap on a cone": {"metal": plate + cap},
        "square cone in a round hole": {
            "metal": plate - tube * 25 * 1.5,
            "steel": tube * 25 * 1.5 - square,
        },
        "undercut": {"metal": plate - undercut, "epoxy": undercut},
    }
