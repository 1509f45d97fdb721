"""Cells drawn over all that a study can describe, and their frequencies by a route that shares no estimate.

A cell with a pillar is computed on two meshes or more, each finer than the last, until what they differ by is
little beside the accuracy asked for; that difference, with what the interior space of several hundred fields
leaves out, is the uncertainty of the last. A plain plate needs no mesh: its waves are Rayleigh's and Lamb's.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
import scipy.linalg as la
from numpy.typing import NDArray

from haptonic.bloch.centred import lattice_pencil
from haptonic.bloch.pencil import eigenpairs, hertz
from haptonic.bloch.plate_waves import PlainPlate
from haptonic.bloch.resolution import Resolution
from haptonic.bloch.truncation import REST, interior_error
from haptonic.cell import Pillar, Site, UnitCell
from haptonic.cell.pillar import Faces
from haptonic.cell.pillar_parts import Step
from haptonic.cell.sites import SITES
from haptonic.errors import GeometryError
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial, material
from haptonic.superelement import TiledMesh, Tiling, condense, on_each

Array = NDArray[np.float64]

KINDS = ("round", "square", "fillet", "draft", "step", "mixed", "round", "plain")
MATERIALS = ("steel", "brass", "soda-lime-glass", "silicon", "aluminium-2017a", "borosilicate-glass")
TILES = ("six sides", "three sides", "both faces", "two sites", "draft and fillet")
ACCURACIES = (2.5e-2, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4)
COUNTS = (10, 10, 10, 15, 20, 30)
KAPPA = np.pi * np.array([(1, 0), (0, 1), (1, 1), (1, 0.5), (0.5, 0.5), (0.6, 0.3), (0.15, 0.05)])
TILES_FROM = 2000  # numbers of designs by turns of `TILES`
STOUT_FROM = 1000  # numbers of designs of a class apart: stout pillars on thin plates, asked for coarsely
# order and rings of a reference's meshes, by the least accuracy asked that they are for
MESHES = {1e-2: ((4, 1), (5, 1), (6, 2)), 2e-3: ((4, 1), (5, 2), (6, 2)), 0.0: ((5, 1), (6, 2), (7, 3))}
# Of their interior spaces: blocks for ten bands, directions of each, and how many more the next mesh has.
STEPS, BLOCK, MORE = 3, 24, 8
ENOUGH = 0.2  # share of the accuracy that a reference's uncertainty may be
WHOLE, LARGEST = 60_000, 400_000  # unknowns that are condensed whole, and at all: 230,000 take 4 GB
# Polynomials through a plain plate: these, and as many more as its shortest wave has radians in it.
# More would only round: of seventeen in a plate of 0.04 pitches the lowest band was 1.2e-4 off.
PLATE_LEVELS, ROUNDING = 7, 2 * np.finfo(float).eps


@dataclass(frozen=True)
class Drawn:
    """One question: a cell, how many bands, how accurate; ``kind`` is the class of the cell."""

    kind: str
    cell: UnitCell
    count: int
    accuracy: float


def drawn(seed: int, number: int) -> Drawn:
    """Question ``number`` of a seed; each is drawn for itself, so any can be asked again alone."""
    if number >= TILES_FROM:
        return _drawn_tile(seed, number)
    rng = np.random.default_rng([seed, number])
    stout = number >= STOUT_FROM
    kind = "stout" if stout else KINDS[number % len(KINDS)]
    while True:
        try:
            cell = _cell(rng, kind)
        except GeometryError:
            continue
        accuracies = [accuracy for accuracy in ACCURACIES if accuracy >= 1e-2 or not stout]
        return Drawn(kind, cell, int(rng.choice(COUNTS)), float(rng.choice(accuracies)))


def _drawn_tile(seed: int, number: int) -> Drawn:
    """Question about a cell of six or three sides, with both faces, two sites, or draft and fillet."""
    rng = np.random.default_rng([seed, number])
    kind = TILES[number % len(TILES)]
    while True:
        try:
            cell = _tiled(rng, kind)
        except GeometryError:
            continue
        return Drawn(kind, cell, int(rng.choice(COUNTS[:5])), float(rng.choice(ACCURACIES[:4])))


def _tiled(rng: np.random.Generator, kind: str) -> UnitCell:
    pitch = _log_uniform(rng, 2e-3, 20e-3)
    lattices = {
        "triangular": Lattice.triangular(pitch),
        "centred": Lattice.centred(pitch, pitch * _log_uniform(rng, 0.6, 1.7)),
        "oblique": Lattice.oblique(pitch, pitch * rng.uniform(1.0, 1.5), math.radians(rng.uniform(55, 85))),
        "honeycomb": Lattice(lattice="honeycomb", pitch=pitch),
        "square": Lattice.square(pitch),
        "rectangular": Lattice.rectangular(pitch, pitch * _log_uniform(rng, 0.6, 1.7)),
    }
    six = ("triangular", "triangular", "centred", "oblique")
    names = {
        "six sides": six,
        "three sides": ("honeycomb",),
        "both faces": (*six, "honeycomb"),
        "two sites": ("honeycomb", "square", "rectangular", "triangular"),
        "draft and fillet": (*six, "honeycomb", "square", "rectangular"),
    }
    lattice = lattices[str(rng.choice(names[kind]))]
    matter = material(str(rng.choice(MATERIALS)))
    if rng.random() < 0.3:
        matter = IsotropicMaterial(70e9, float(rng.uniform(0.0, 0.45)), 2700.0, name="drawn")
    room = 2 * lattice.inradius * (0.577 if lattice.name == "honeycomb" else 1.0)
    thickness = room * _log_uniform(rng, 0.06, 0.6)
    faces: Faces = "both" if kind == "both faces" else "one"
    pillars = [_any_pillar(rng, room, kind) for _ in range(2)]
    if kind != "two sites":
        return UnitCell(lattice, thickness, matter, pillars[0], faces=faces)
    if lattice.name in SITES:
        return UnitCell(lattice, thickness, matter, site=tuple(Site(pillar=pillar) for pillar in pillars))
    apart = rng.uniform(0.3, 0.5, 2)
    pillars = [replace(pillar, diameter=pillar.diameter * 0.6) for pillar in pillars]
    sites = (Site(at=(0.0, 0.0), pillar=pillars[0]), Site(at=(apart[0], apart[1]), pillar=pillars[1]))
    return UnitCell(lattice, thickness, matter, site=sites)


def _any_pillar(rng: np.random.Generator, room: float, kind: str) -> Pillar:
    """A round pillar; where the kind asks for it, or by chance, with a draft, a fillet or a step."""
    diameter, height = room * rng.uniform(0.15, 0.9), room * _log_uniform(rng, 0.15, 3.0)
    more: dict[str, object] = {}
    if kind == "draft and fillet":
        steepest = min(math.atan(0.33 * diameter / height), math.radians(20))
        more["draft"] = float(rng.uniform(-0.3, 1.0)) * steepest
        more["fillet"] = min(diameter, height, room - diameter) * rng.uniform(0.05, 0.5)
    elif rng.random() < 0.15:
        more["step"] = Step(diameter * rng.uniform(0.3, 0.85), height * rng.uniform(0.3, 0.7))
    return Pillar(diameter, height, **more)  # type: ignore[arg-type]


def _log_uniform(rng: np.random.Generator, low: float, high: float) -> float:
    return float(math.exp(rng.uniform(math.log(low), math.log(high))))


def _cell(rng: np.random.Generator, kind: str) -> UnitCell:
    pitch = _log_uniform(rng, 2e-3, 20e-3)
    lattice = Lattice.square(pitch)
    if rng.random() < 0.5:
        lattice = Lattice.rectangular(pitch, pitch * _log_uniform(rng, 0.5, 2.0))
    short = min(pitch, lattice.a2[1])
    thickness = short * (_log_uniform(rng, 0.02, 0.08) if kind == "stout" else _log_uniform(rng, 0.02, 0.6))
    matter = material(str(rng.choice(MATERIALS)))
    if rng.random() < 0.5:
        matter = IsotropicMaterial(70e9, float(rng.uniform(-0.3, 0.49)), 2700.0, name="drawn")
    if kind == "plain":
        return UnitCell(lattice, thickness, matter)
    diameter = short * (rng.uniform(0.5, 0.97) if kind == "stout" else rng.uniform(0.05, 0.97))
    height = short * (_log_uniform(rng, 0.05, 1.0) if kind == "stout" else _log_uniform(rng, 0.05, 6.0))
    more: dict[str, object] = {}
    if kind == "square" or (kind == "mixed" and rng.random() < 0.5):
        more["section"] = "square"
    if kind in ("fillet", "mixed"):
        more["fillet"] = min(diameter, height, short - diameter) * rng.uniform(0.05, 0.5)
    if kind in ("draft", "mixed"):  # up to a tip of a third of the foot, or as much wider
        steepest = math.atan(0.33 * diameter / height)
        more["draft"] = float(rng.uniform(-0.3, 1.0)) * min(steepest, math.radians(20))
    if kind == "step" or (kind == "mixed" and rng.random() < 0.5):
        more["step"] = Step(diameter * rng.uniform(0.3, 0.85), height * rng.uniform(0.2, 0.8))
    return UnitCell(lattice, thickness, matter, Pillar(diameter, height, **more))  # type: ignore[arg-type]


def wavevectors(cell: UnitCell) -> Array:
    """Wavevectors within the irreducible zone, the only one that a model answers for.

    Of one pillar in a rectangle `KAPPA`, an eighth of the zone of a square. Of others the zone's corners but
    Gamma, two places between those, and two inside.
    """
    if not (cell.is_simple and cell.lattice.is_rectangular):
        corners = np.array(list(cell.zone.corner_phases.values())[1:])
        ends, middle = corners[[0, -1]], corners.mean(axis=0)
        return np.array([*corners, ends.mean(axis=0), *(0.5 * ends), 0.7 * middle, 0.1 * middle])
    within = np.sort(KAPPA)[:, ::-1] if "d" in cell.point_group.mirrors else KAPPA
    return np.unique(within, axis=0)


@dataclass(frozen=True)
class Truth:
    """frequency, uncertainty : (wavevectors, count) Hz at `wavevectors`; route : how they were found."""

    frequency: Array
    uncertainty: Array
    route: str


def truth(question: Drawn) -> Truth | None:
    """Frequencies at `wavevectors`, with what they may be off by; None if no two meshes fit.

    From one order to the next the smooth part of the error falls at least to 0.36 of it: so it does in an
    element whose far border is 16 times as far from an edge as its near one, and hardly any is longer; hence
    0.6 of the difference. What an edge leaves falls to a seventh where a ring is added as well, 0.2^1.09 by
    the grading times what the order brings (haptonic.bloch.resolution); where none is, to two thirds, hence
    twice the difference; with two rings the edge does not lead, and the whole difference is taken.
    """
    cell, count = question.cell, question.count
    pillars = pillars_of(cell)
    if not pillars:
        exact = np.array([plain_plate(cell, kappa, count) for kappa in wavevectors(cell)])
        plate = _plate(cell, count)
        largest = la.eigh(plate.still, plate.mass, eigvals_only=True)[-1]
        rounding = ROUNDING * largest / (8 * np.pi**2 * np.maximum(exact, REST * exact.max()))
        return Truth(exact, 1e-8 * exact + rounding, "Rayleigh-Lamb")
    before, reference = None, None
    for turn, (order, rings) in enumerate(_meshes(question)):
        sharp = not any(pillar.fillet for pillar in pillars)  # else there is no edge at a foot
        fewer = [Resolution(order, fewer, STEPS, BLOCK) for fewer in (range(rings, 0, -1) if sharp else [1])]
        used = [resolution.for_bands(cell, count) for resolution in fewer]
        mesh = next((resolution for resolution in used if _unknowns(cell, resolution) <= LARGEST), None)
        if mesh is None:
            break
        frequency, lost = _computed(cell, mesh, MORE * turn)
        if before is not None:
            finer = mesh.foot_rings > before[1]
            if not sharp:
                share = 0.6 if all(pillar.step is None for pillar in pillars) else 2.0
            else:
                share = 0.6 if finer else 1.0 if mesh.foot_rings > 1 else 2.0
            uncertainty = share * np.abs(frequency - before[0]) + lost
            reference = Truth(frequency, uncertainty, f"order {order}, {mesh.foot_rings} rings")
            moving = frequency > REST * frequency.max()
            if (uncertainty <= ENOUGH * question.accuracy * frequency)[moving].all():
                break
        before = frequency, mesh.foot_rings
    return reference


def estimated_seconds(question: Drawn) -> float:
    """Estimated processor time of a truth, s, for want of a better measure by the product."""
    if not question.cell.has_features:
        return 0.0
    used = [
        Resolution(*mesh, STEPS, BLOCK).for_bands(question.cell, question.count) for mesh in _meshes(question)
    ]
    return sum(resolution.seconds(question.cell) for resolution in used)


def _meshes(question: Drawn) -> tuple[tuple[int, int], ...]:
    """Order and rings of a reference's meshes: of tiles with other than four sides orders 5 and 4 differ."""
    accuracy = question.accuracy if question.kind not in TILES else min(question.accuracy, 5e-3)
    return next(meshes for least, meshes in MESHES.items() if accuracy >= least)


def pillars_of(cell: UnitCell) -> list[Pillar]:
    """Pillars of the cell's tiles."""
    return [placed.tile.pillar for placed in cell.tiles if placed.tile.pillar is not None]


def _unknowns(cell: UnitCell, used: Resolution) -> int:
    """Unknowns of a mesh, straight pillars' bodies left out, which can be condensed apart."""
    return sum(
        3 * sum((replace(plan, pillar_layers=1) if placed.tile.pillar.is_prism else plan).level_sizes)
        for placed, plan in zip(cell.tiles, used.plans(cell), strict=True)
        if placed.tile.pillar is not None
    )


def _computed(cell: UnitCell, used: Resolution, more: int) -> tuple[Array, Array]:
    """(wavevectors, count) Hz, and by how much what the interior leaves out would lower each, Hz."""
    plans, block = used.plans(cell), used.block + more
    # a stepped pillar whole in any case: its parts are what the product has
    stepped = any(pillar.step is not None for pillar in pillars_of(cell))
    whole = stepped or 3 * sum(sum(plan.level_sizes) for plan in plans) < WHOLE
    if whole and cell.is_simple:
        tiling = Tiling.single(condense(cell, plans[0], used.steps, block=block, measured=False))
    elif whole:
        tiling = TiledMesh.of(cell, plans).condensed(used.steps, block, measured=False)
    else:
        tiling = Tiling.condensed(cell, plans, used.steps, block, measured=False)
    pencil = lattice_pencil(tiling)
    frequencies, lost = [], []
    for kappa in wavevectors(cell):
        values, modes = eigenpairs(pencil, kappa, used.bands)
        fields = pencil.fields(modes, kappa)
        frequencies.append(hertz(values))
        lost.append(interior_error(values, on_each(tiling.truncation, fields)))
    return np.array(frequencies), np.array(lost)


def plain_plate(cell: UnitCell, kappa: Array, count: int) -> Array:
    """(count,) frequencies of a plate's waves, Hz, folded back into the zone of a lattice."""
    plate = _plate(cell, count)
    turning = 1j * (plate.crossed.swapaxes(1, 2) - plate.crossed)
    far = _farthest(count)
    values: list[float] = []
    for turns in product(range(-far, far + 1), repeat=2):
        k = cell.lattice.wavevector(kappa + 2 * np.pi * np.array(turns))
        stiffness = np.einsum("a,b,abij->ij", k, k, plate.gradient) + np.tensordot(k, turning, axes=1)
        values += la.eigh(
            stiffness + plate.still, plate.mass, eigvals_only=True, subset_by_index=(0, 11)
        ).tolist()
    return np.sqrt(np.maximum(np.sort(values)[:count], 0.0)) / (2 * np.pi)


def _farthest(count: int) -> int:
    """Turns of a phase up to which waves of a plain plate may be among so many bands."""
    return math.ceil(math.sqrt(count)) + 1


def _plate(cell: UnitCell, count: int) -> PlainPlate:
    shortest = 2 * np.pi * _farthest(count) / (2 * cell.inradius)
    return PlainPlate.of(cell, PLATE_LEVELS + math.ceil(shortest * cell.thickness))
