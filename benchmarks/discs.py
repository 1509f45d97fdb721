"""Errors of cells with discs against a finer mesh: drawn over features, outlines, materials and lattices.

    python discs.py              # forty cells of seed 1; some minutes each
    python discs.py 20 --seed 7

Each cell is asked as a user would ask, for ten bands at the default accuracy. For each: what was stated, how
far the finer mesh is, and the least and the median ratio of the two over ten bands at four wavevectors.
"""

from __future__ import annotations

import argparse
import math
import time
from typing import Any

import numpy as np

from haptonic.bloch import BlochModel, Resolution
from haptonic.bloch.model import bloch_model
from haptonic.bloch.settings import BandSettings
from haptonic.cell import Disc, Site, UnitCell
from haptonic.errors import GeometryError, HaptonicError, ResourceError
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial, material

# finer meshes, of which the first that takes so many seconds at most is used
FINE = tuple(
    Resolution(order, rings, 3, 24) for order, rings in ((9, 2), (8, 2), (6, 2), (5, 2), (6, 1), (5, 1))
)
LONGEST = 60.0
SHARES = np.array([(0.35, 0.73), (1.0, 0.0), (0.13, -0.83), (1.0, 1.0)])  # of pi
TUNGSTEN = IsotropicMaterial(411e9, 0.28, 19250.0, name="tungsten")
RUBBER = IsotropicMaterial(1.175e5, 0.469, 1300.0, name="rubber")
SOLIDS = (material("steel"), material("epoxy"), material("silicon"), TUNGSTEN, RUBBER)
SECTIONS = ("round", "round", "square", "hexagon", "ellipse")
FEATURES = ("hole", "blind hole", "inclusion", "coated inclusion", "pillar on glue", "cap", "hollow pillar")


def drawn(seed: int, number: int) -> tuple[str, UnitCell]:
    """A cell and what it is, by its number; each is drawn for itself."""
    rng = np.random.default_rng([seed, number])
    feature = FEATURES[number % len(FEATURES)]
    while True:
        try:
            return feature, _cell(rng, feature)
        except GeometryError:
            continue


def _cell(rng: np.random.Generator, feature: str) -> UnitCell:
    pitch = 10 ** rng.uniform(-5, -2)
    lattices = (
        Lattice.square(pitch),
        Lattice.square(pitch),
        Lattice.triangular(pitch),
        Lattice.rectangular(pitch, pitch * rng.uniform(0.7, 1.5)),
        Lattice(lattice="honeycomb", pitch=pitch),
    )
    lattice = lattices[rng.integers(len(lattices))]
    room = 2 * lattice.inradius * (0.577 if lattice.name == "honeycomb" else 1.0)
    thickness = room * 10 ** rng.uniform(-1.0, -0.1)
    discs = _discs(rng, feature, room, thickness)
    plate = SOLIDS[rng.integers(3)]
    if lattice.name != "honeycomb":
        return UnitCell(lattice, thickness, plate, disc=discs)
    return UnitCell(lattice, thickness, plate, site=(Site(disc=discs), Site()))


def _discs(rng: np.random.Generator, feature: str, room: float, thickness: float) -> tuple[Disc, ...]:
    wide, share = room * rng.uniform(0.3, 0.9), rng.uniform(0.4, 0.9)
    section = str(rng.choice(SECTIONS))
    shape: dict[str, Any] = {"section": section}
    if section == "ellipse":
        shape["length"] = wide * rng.uniform(0.6, 1.0)
    if section in ("square", "hexagon"):  # sharp corners are upright edges, towards which no mesh is graded
        shape["corner_radius"] = wide * rng.uniform(0.05, 0.25)
    inner = shape | {name: share * shape[name] for name in ("length", "corner_radius") if name in shape}
    solid, other = (SOLIDS[k] for k in rng.choice(len(SOLIDS), 2, replace=False))
    height, glue = room * 10 ** rng.uniform(-0.8, 0.2), thickness * rng.uniform(0.1, 0.5)
    made = {
        "hole": [Disc(wide, empty=True, **shape)],
        "blind hole": [Disc(wide, low=-thickness * rng.uniform(0.2, 0.8), empty=True, **shape)],
        "inclusion": [Disc(wide, material=solid, **shape)],
        "coated inclusion": [
            Disc(wide, material=solid, **shape),
            Disc(share * wide, material=other, **inner),
        ],
        "pillar on glue": [
            Disc(wide, low=0.0, high=glue, material=SOLIDS[1], **shape),
            Disc(wide, low=glue, high=glue + height, material=solid, **shape),
        ],
        "cap": [
            Disc(share * wide, low=0.0, high=height, **inner),
            Disc(wide, low=height, high=1.4 * height, **shape),
        ],
        "hollow pillar": [
            Disc(wide, low=0.0, high=height, **shape),
            Disc(share * wide, low=0.0, high=height, empty=True, **inner),
        ],
    }  # fmt: skip
    return tuple(made[feature])


def survey(cell: UnitCell) -> tuple[str, float, float]:
    """A line of text, the least and the median ratio of what is stated and what the finer mesh shows."""
    start = time.process_time()
    settings = BandSettings()
    model = bloch_model(cell, settings)
    solved = [model.solve(np.pi * share) for share in SHARES]
    seconds = time.process_time() - start
    used = model.resolution
    fine = [mesh for mesh in FINE if mesh.order > used.order or mesh.foot_rings > used.foot_rings]
    fine = [mesh for mesh in fine if mesh.seconds(cell) < LONGEST]
    if not fine:
        raise ResourceError.too_large(
            argument="cell", given="a finer mesh", allowed=f"{LONGEST:g} s", cause="it takes longer",
            next_step="none",
        )  # fmt: skip
    finer = BlochModel.of(cell, fine[0], settings.count, measured=False)
    ratios, own, off = [], 0.0, 0.0
    for share, found in zip(SHARES, solved, strict=True):
        exact = finer.solve(np.pi * share)
        distance = np.abs(found.frequency - exact.frequency)
        ratios.append(found.error / np.maximum(distance, 1e-3 * found.error))
        own = max(own, float((exact.error / exact.frequency).max()))
        off = max(off, float((distance / exact.frequency).max()))
    text = (
        f"order {used.order}, {used.foot_rings} rings, {seconds:.0f} s: stated {model.worst_error:.1e}, "
        f"off {off:.1e} (order {fine[0].order}, {fine[0].foot_rings} rings: {own:.1e})"
    )
    return text, float(np.min(ratios)), float(np.median(ratios))


def main(count: int, seed: int) -> None:
    """Survey cells, and say what all of them together show."""
    least, refused = math.inf, 0
    medians: list[float] = []
    for number in range(count):
        feature, cell = drawn(seed, number)
        try:
            text, lowest, median = survey(cell)
        except HaptonicError as error:
            refused += 1
            print(f"{number} {feature}, {cell.lattice.name}: refused, {error.cause}", flush=True)
            continue
        least, medians = min(least, lowest), [*medians, median]
        sections = {disc.section for discs in cell.disc_tables.values() for disc in discs}
        print(
            f"{number} {feature}, {', '.join(sections)}, {cell.lattice.name}: {text}, "
            f"ratio {lowest:.2f}, median {median:.1f}",
            flush=True,
        )
    print(
        f"least ratio {least:.2f}, median of medians {np.median(medians):.1f}, {refused} of {count} refused"
    )


if __name__ == "__main__":
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("count", nargs="?", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    given = parser.parse_args()
    main(given.count, given.seed)
