"""Errors of cells with discs against a finer mesh: drawn over features, outlines, materials and lattices.

    python discs.py    # cells of seed 1 for ten minutes, the cheapest of each feature first
    python discs.py --seed 7 --cells 80 --minutes 30 --meshes 3-1 4-1 5-1 --features undercut hole --workers 2

Each cell is computed on some meshes, and on a finer one with two rings, of order six or as given. For each
mesh: the estimate over the distance to the finer mesh, for those of ten bands at four wavevectors whose
distance exceeds its uncertainty. The last table has the same by classes of edges.
"""

from __future__ import annotations

import argparse
import math
import multiprocessing
import time
from collections.abc import Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from record import write

from haptonic.arrays import Array
from haptonic.bloch import Resolution
from haptonic.bloch.centred import lattice_pencil
from haptonic.bloch.pencil import change_in_hertz, eigenpairs, hertz
from haptonic.cell import Disc, Site, UnitCell
from haptonic.errors import GeometryError, HaptonicError
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial, material
from haptonic.parallel import one_thread
from haptonic.superelement import Tiling, missing_energy, on_each

INTERIOR = (4, 36)  # of all meshes
TRUNCATED = 1e-4  # relative: its largest truncation error of ten bands in a thick plate
UNSURE = 0.6  # uncertainty of the finer mesh as a share of its distance to the order below
MODES = 12  # bands, of which ten are judged
JUDGED = 10
MOVING = 1e-4  # share of the highest frequency; only rigid motions are below
SHARES = np.array([(0.35, 0.73), (1.0, 0.0), (0.13, -0.83), (1.0, 1.0)])  # of pi
TUNGSTEN = IsotropicMaterial(411e9, 0.28, 19250.0, name="tungsten")
RUBBER = IsotropicMaterial(1.175e5, 0.469, 1300.0, name="rubber")
SOLIDS = (material("steel"), material("epoxy"), material("silicon"), TUNGSTEN, RUBBER)
SECTIONS = ("round", "round", "square", "hexagon", "ellipse")
FEATURES = (
    "hole", "blind hole", "inclusion", "coated inclusion", "pillar on glue", "cap", "hollow pillar",
    "countersunk hole", "undercut", "drafted inclusion", "drafted coating", "hollow cone",
)  # fmt: skip


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
    depth, draft = thickness * rng.uniform(0.2, 0.8), rng.uniform(0.1, 0.7)
    sink = math.atan(0.5 * (1 - share) * wide / depth)
    steep = min(
        draft, 0.5 * math.atan(0.5 * share * wide / max(height, thickness))
    )  # of what reaches farther
    discs = {
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
        "countersunk hole": [
            Disc(share * wide, high=-depth, empty=True, **inner),
            Disc(share * wide, low=-depth, draft=-sink, empty=True, **inner),
        ],
        "undercut": [Disc(wide, low=-depth, draft=min(draft, 0.4 * wide / depth), material=other, **shape)],
        "drafted inclusion": [Disc(wide, material=solid, draft=steep, **shape)],
        "drafted coating": [
            Disc(wide, material=other, draft=steep, **shape),
            Disc(0.8 * share * wide, material=solid, draft=-0.5 * steep, **inner),
        ],
        "hollow cone": [
            Disc(wide, low=0.0, high=height, draft=steep, **shape),
            Disc(0.8 * share * wide, low=0.0, high=height, draft=0.5 * steep, empty=True, **inner),
        ],
    }  # fmt: skip
    return tuple(discs[feature])


@dataclass(frozen=True)
class Row:
    """A cell on one mesh: what its estimates are over the distance to the finer mesh.

    edges : class of its edges; off, stated : largest relative distance and estimate
    below : estimates smaller than the distance by more than its uncertainty
    """

    seed: int
    number: int
    feature: str
    lattice: str
    edges: str
    mesh: str
    frequencies: int
    below: int
    least: float
    median: float
    off: float
    stated: float
    seconds: float


def edges_of(cell: UnitCell) -> str:
    """Class of a cell's edges."""
    stacks = [placed.tile.stack for placed in cell.tiles if placed.tile.stack is not None]
    if any(stack.has_corners for stack in stacks):
        return "upright corners"
    if any(stack.singular.any() and stack.raised is not None for stack in stacks):
        return "edges above the plate"
    if any(stack.singular.any() for stack in stacks):
        return "edges in the plate"
    return "interfaces" if any(len(stack.solids) for stack in stacks) else "no edges"


def solved(cell: UnitCell, mesh: Resolution) -> tuple[Array, Array]:
    """(wavevectors, MODES) frequencies on a mesh, and errors of the mesh, Hz."""
    with one_thread():
        tiling = Tiling.condensed(cell, mesh.plans(cell), *INTERIOR, measured=False)
        pencil = lattice_pencil(tiling)
        frequencies, errors = [], []
        for kappa in np.pi * SHARES:
            values, modes = eigenpairs(pencil, kappa, MODES)
            fields = pencil.fields(modes, kappa)
            energies = (on_each(form, fields) for form in tiling.surplus)
            frequencies.append(hertz(values))
            moving = np.maximum(frequencies[-1], MOVING * frequencies[-1].max())
            errors.append(change_in_hertz(missing_energy(*energies), moving))
    return np.array(frequencies), np.array(errors)


def survey(seed: int, number: int, meshes: Sequence[str], finer: int) -> list[Row]:
    """Compare the estimates of a cell on each mesh with the mesh of order ``finer``."""
    feature, cell = drawn(seed, number)
    fine, lower = (solved(cell, Resolution(order, 2))[0] for order in (finer, finer - 1))
    unsure = UNSURE * np.abs(fine - lower) + TRUNCATED * fine
    rows = []
    for mesh in meshes:
        start, used = time.process_time(), Resolution(*(int(part) for part in mesh.split("-")))
        frequency, estimate = solved(cell, used)
        off = np.abs(frequency - fine)
        moving = frequency > MOVING * frequency.max()
        moving[:, JUDGED:] = False
        moving &= off > unsure
        if not moving.any():
            continue
        ratio, certain = (estimate / off)[moving], ((off - unsure) / estimate)[moving]
        rows.append(
            Row(
                seed=seed, number=number, feature=feature, lattice=cell.lattice.name, edges=edges_of(cell),
                mesh=mesh, frequencies=int(moving.sum()), below=int((certain > 1).sum()),
                least=float(ratio.min()), median=float(np.median(ratio)),
                off=float((off / frequency)[moving].max()),
                stated=float((estimate / frequency)[moving].max()), seconds=time.process_time() - start,
            )
        )  # fmt: skip
    return rows


def summary(rows: Sequence[Row]) -> dict[str, Any]:
    """Figures of some rows."""
    return {
        "cells": len(rows),
        "frequencies": sum(row.frequencies for row in rows),
        "below": sum(row.below for row in rows),
        "least": round(min(row.least for row in rows), 2),
        "median": round(float(np.median([row.median for row in rows])), 1),
    }


def in_order(count: int, seed: int, features: Sequence[str], finer: int) -> list[int]:
    """Numbers of cells: the cheapest of each feature, then the next of each."""
    numbers = [number for number in range(count) if FEATURES[number % len(FEATURES)] in features]
    cost = {number: Resolution(finer, 2).seconds(drawn(seed, number)[1]) for number in numbers}
    rounds: dict[int, tuple[int, float]] = {}
    for feature in FEATURES:
        alike = [number for number in numbers if FEATURES[number % len(FEATURES)] == feature]
        for rank, number in enumerate(sorted(alike, key=lambda number: cost[number])):
            rounds[number] = rank, cost[number]
    return sorted(numbers, key=lambda number: rounds[number])


def survey_in_time(
    deadline: float, seed: int, number: int, meshes: Sequence[str], finer: int
) -> list[Row] | str | None:
    """Survey of a cell, the reason of a refusal, or None after the deadline."""
    if time.monotonic() > deadline:
        return None
    try:
        rows = survey(seed, number, meshes, finer)
    except HaptonicError as error:
        print(f"{number}: refused, {error.cause}", flush=True)
        return error.cause
    for row in rows:
        print(
            f"{row.number} {row.feature}, {row.lattice}, {row.edges}, {row.mesh}: off {row.off:.1e}, "
            f"stated {row.stated:.1e}, {row.below} below, ratio {row.least:.2f}, {row.median:.1f}, "
            f"{row.seconds:.0f} s",
            flush=True,
        )
    return rows


def main(
    *,
    count: int,
    seed: int,
    minutes: float,
    meshes: Sequence[str],
    features: Sequence[str],
    finer: int,
    workers: int,
) -> None:
    """Survey cells, and store what all of them together show."""
    deadline = time.monotonic() + 60 * minutes  # one clock for all processes
    with ProcessPoolExecutor(workers, multiprocessing.get_context("spawn")) as pool:
        numbers = in_order(count, seed, features, finer)
        futures = [pool.submit(survey_in_time, deadline, seed, number, meshes, finer) for number in numbers]
        answers = [answer for future in futures if (answer := future.result()) is not None]
    surveys = [answer for answer in answers if isinstance(answer, list)]
    rows = [row for of_cell in surveys for row in of_cell]
    run, refused = len(answers), len(answers) - len(surveys)
    groups = {(row.mesh, row.edges): summary([r for r in rows if (r.mesh, r.edges) == (row.mesh, row.edges)])
              for row in rows}  # fmt: skip
    judged = [mesh for mesh in meshes if any(row.mesh == mesh for row in rows)]
    by_mesh = {mesh: summary([row for row in rows if row.mesh == mesh]) for mesh in judged}
    for (mesh, edges), figures in sorted(groups.items()):
        print(mesh, edges, figures)
    write(
        "discs",
        {
            "seed": seed, "finer": finer, "drawn": count, "run": run, "refused": refused, "all": by_mesh,
            "classes": [{"mesh": mesh, "edges": edges} | of for (mesh, edges), of in sorted(groups.items())],
            "rows": [asdict(row) for row in rows],
        },
    )  # fmt: skip


if __name__ == "__main__":
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--cells", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--minutes", type=float, default=10.0)
    parser.add_argument("--finer", type=int, default=6, help="order of the finer mesh")
    parser.add_argument("--meshes", nargs="+", default=["3-1", "4-1"])
    parser.add_argument("--workers", type=int, default=1, help="cells at a time")
    parser.add_argument("--features", nargs="+", default=FEATURES, choices=FEATURES)
    given = parser.parse_args()
    main(
        count=given.cells,
        seed=given.seed,
        minutes=given.minutes,
        meshes=given.meshes,
        features=given.features,
        finer=given.finer,
        workers=given.workers,
    )
