"""Errors of cells with pillars against a finer mesh: drawn round ones, and of other sections or materials.

    python pillars.py            # all; some minutes each
    python pillars.py hexagon    # those whose name has the word
    python pillars.py drawn      # round pillars, drawn with the seed SEED

For each cell and each of the first three resolutions: the largest and the median distance to the mesh of
order 6 with two rings, what was stated, and the largest ratio of both over ten bands at one wavevector. The
finer mesh has an error itself, which is printed as well.
"""

from __future__ import annotations

import math
import sys
from dataclasses import replace

import numpy as np

from haptonic.bloch import BlochModel, Resolution
from haptonic.cell import Pillar, Step, UnitCell
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial, material

MM = 1e-3
SEED, DRAWN = 11, 10
KAPPA, BANDS = np.array([1.9, 2.4]), 10
FINE, TRIED = Resolution(6, 2, 3, 24), (Resolution(3, 1), Resolution(4, 1), Resolution(5, 1))
SQUARE, TRIANGULAR = Lattice.square(7 * MM), Lattice.triangular(7 * MM)
RUBBER = IsotropicMaterial(1.175e5, 0.469, 1300.0, name="rubber")
TUNGSTEN = IsotropicMaterial(411e9, 0.28, 19250.0, name="tungsten")
SHORT, WIDE = Pillar(3 * MM, 4 * MM), Pillar(5 * MM, 3 * MM)
# lattice, thickness (mm), pillar; the plate is of aluminium
CELLS = {
    "hexagon": (SQUARE, 1.5, Pillar(3 * MM, 6 * MM, "hexagon")),
    "hexagon, triangular": (TRIANGULAR, 1.5, Pillar(3 * MM, 6 * MM, "hexagon")),
    "square on its corner": (SQUARE, 1.5, Pillar(3 * MM, 6 * MM, "square", turn=math.pi / 4)),
    "square, triangular": (TRIANGULAR, 1.5, Pillar(3 * MM, 6 * MM, "square")),
    "ellipse": (SQUARE, 1.5, Pillar(2 * MM, 6 * MM, "ellipse", length=3.6 * MM)),
    "triangle, triangular": (TRIANGULAR, 1.5, Pillar(2 * MM, 6 * MM, "polygon", sides=3)),
    "turned rectangle": (SQUARE, 1.5, Pillar(2 * MM, 6 * MM, "rectangle", length=3.6 * MM, turn=0.5)),
    "rounded square": (SQUARE, 1.5, Pillar(3 * MM, 6 * MM, "square", corner_radius=0.45 * MM)),
    "narrow, square on its corner": (SQUARE, 1.5, Pillar(4.6 * MM, 5 * MM, "square", turn=math.pi / 4)),
    "narrow, ellipse": (SQUARE, 1.5, Pillar(3 * MM, 5 * MM, "ellipse", length=6.6 * MM)),
    "narrow, hexagon": (TRIANGULAR, 1.5, Pillar(6.4 * MM, 5 * MM, "hexagon")),
    "narrow, turned hexagon": (TRIANGULAR, 1.5, Pillar(5.6 * MM, 5 * MM, "hexagon", turn=math.pi / 6)),
    "thin, hexagon": (SQUARE, 0.5, Pillar(4 * MM, 5 * MM, "hexagon")),
    "thin, turned rectangle": (SQUARE, 0.5, Pillar(2.5 * MM, 5 * MM, "rectangle", length=4 * MM, turn=0.4)),
    "step, ellipse": (
        SQUARE,
        1.5,
        Pillar(3 * MM, 6 * MM, "ellipse", length=4 * MM, step=Step(1.8 * MM, 3 * MM)),
    ),
    "material, steel": (SQUARE, 1.5, replace(SHORT, material=material("steel"))),
    "material, tungsten, triangular": (TRIANGULAR, 1.5, replace(SHORT, material=TUNGSTEN)),
    "material, tungsten, wide": (SQUARE, 1.5, replace(WIDE, material=TUNGSTEN)),
    "material, epoxy": (SQUARE, 1.5, replace(SHORT, material=material("epoxy"))),
    "material, epoxy, wide": (SQUARE, 1.5, replace(WIDE, material=material("epoxy"))),
    "material, rubber": (SQUARE, 1.5, replace(SHORT, material=RUBBER)),
    "material, rubber, wide": (TRIANGULAR, 1.5, replace(WIDE, material=RUBBER)),
    "material, thin, tungsten": (SQUARE, 0.5, replace(SHORT, material=TUNGSTEN)),
}


def drawn(number: int) -> tuple[Lattice, float, Pillar]:
    """Lattice, thickness (mm) and round pillar of a drawn cell, with sizes in the ranges of papers."""
    draw = np.random.default_rng([SEED, number])
    pillar = Pillar(draw.uniform(2.0, 5.6) * MM, draw.uniform(2.0, 10.0) * MM)
    return (SQUARE, TRIANGULAR)[number % 2], draw.uniform(0.7, 2.5), pillar


CELLS |= {f"drawn, {number}": drawn(number) for number in range(DRAWN)}


def survey(cell: UnitCell) -> list[str]:
    """A line of text for each resolution."""
    truth = BlochModel.of(cell, FINE, BANDS, measured=False).solve(KAPPA)
    exact, lines = truth.frequency[:BANDS], []
    own = float((truth.error[:BANDS] / exact).max())
    for resolution in TRIED:
        solution = BlochModel.of(cell, resolution, BANDS, measured=False).solve(KAPPA)
        off, stated = np.abs(solution.frequency[:BANDS] - exact), solution.error[:BANDS]
        plan = resolution.plan(cell)
        lines.append(
            f"  order {resolution.order}, {plan.blocks} blocks of order {plan.order}: "
            f"off {(off / exact).max():.1e}, median {np.median(off / exact):.1e}; "
            f"stated {(stated / exact).max():.1e}, median {np.median(stated / exact):.1e}; "
            f"ratio {(off / stated).max():.2f} (finer mesh {own:.1e})"
        )
    return lines


if __name__ == "__main__":
    for name, (lattice, thickness, pillar) in CELLS.items():
        if all(word in name for word in sys.argv[1:]):
            cell = UnitCell(lattice, thickness * MM, material("aluminium-2017a"), pillar)
            print(name, *survey(cell), sep="\n", flush=True)
