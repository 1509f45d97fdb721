"""Cells drawn over all that a study can say, and their frequencies by a route that shares no estimate.

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

from haptonic.bloch.centred import CentredPencil
from haptonic.bloch.model import REST, interior_error
from haptonic.bloch.pencil import eigenpairs, hertz
from haptonic.bloch.plate_waves import PlainPlate
from haptonic.bloch.resolution import Resolution
from haptonic.cell import MeshPlan, Pillar, UnitCell
from haptonic.cell.pillar import Step
from haptonic.errors import GeometryError
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial, material
from haptonic.superelement import Tiling, condense, condense_by_parts, on_each

Array = NDArray[np.float64]

KINDS = ("round", "square", "fillet", "draft", "step", "mixed", "round", "plain")
MATERIALS = ("steel", "brass", "soda-lime-glass", "silicon", "aluminium-2017a", "borosilicate-glass")
ACCURACIES = (2.5e-2, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4)
COUNTS = (10, 10, 10, 15, 20, 30)
KAPPA = np.pi * np.array([(1, 0), (0, 1), (1, 1), (1, 0.5), (0.5, 0.5), (0.6, 0.3), (0.15, 0.05)])
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
    """`KAPPA` within the irreducible zone, the only one that a model answers for: a square's is an eighth."""
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
    if cell.pillar is None:
        exact = np.array([plain_plate(cell, kappa, count) for kappa in wavevectors(cell)])
        plate = _plate(cell, count)
        largest = la.eigh(plate.still, plate.mass, eigvals_only=True)[-1]
        rounding = ROUNDING * largest / (8 * np.pi**2 * np.maximum(exact, REST * exact.max()))
        return Truth(exact, 1e-8 * exact + rounding, "Rayleigh-Lamb")
    before, found = None, None
    for turn, (order, rings) in enumerate(_meshes(question.accuracy)):
        plans = [MeshPlan.suited(cell, order, fewer, count) for fewer in range(rings, 0, -1)]
        if cell.pillar.fillet:  # there is no edge at the foot
            plans = plans[-1:]
        plan = next((plan for plan in plans if _unknowns(cell, plan) <= LARGEST), None)
        if plan is None:
            break
        frequency, lost = _computed(cell, plan, count, MORE * turn)
        if before is not None:
            finer = plan.foot_rings > before[1]
            if cell.pillar.fillet:
                share = 0.6 if cell.pillar.step is None else 2.0
            else:
                share = 0.6 if finer else 1.0 if plan.foot_rings > 1 else 2.0
            uncertainty = share * np.abs(frequency - before[0]) + lost
            found = Truth(frequency, uncertainty, f"order {order}, {plan.foot_rings} rings")
            moving = frequency > REST * frequency.max()
            if (uncertainty <= ENOUGH * question.accuracy * frequency)[moving].all():
                break
        before = frequency, plan.foot_rings
    return found


def foreseen(question: Drawn) -> float:
    """Processor time of a truth as it is foreseen, s, for want of a better measure by the product."""
    if question.cell.pillar is None:
        return 0.0
    used = [
        Resolution(*mesh, STEPS, BLOCK).for_bands(question.cell, question.count)
        for mesh in _meshes(question.accuracy)
    ]
    return sum(resolution.seconds(question.cell) for resolution in used)


def _meshes(accuracy: float) -> tuple[tuple[int, int], ...]:
    return next(meshes for least, meshes in MESHES.items() if accuracy >= least)


def _unknowns(cell: UnitCell, plan: MeshPlan) -> int:
    """Of a mesh, a straight pillar's body left out, which can be condensed apart."""
    assert cell.pillar is not None
    meshed = replace(plan, pillar_layers=1) if cell.pillar.is_prism else plan
    return 3 * sum(meshed.level_sizes)


def _computed(cell: UnitCell, plan: MeshPlan, count: int, more: int) -> tuple[Array, Array]:
    """(wavevectors, count) Hz, and by how much what the interior leaves out would lower each, Hz."""
    # a stepped pillar whole in any case: its parts are what the product has
    whole = 3 * sum(plan.level_sizes) < WHOLE or (cell.pillar is not None and cell.pillar.step is not None)
    by = condense if whole else condense_by_parts
    used = Resolution(plan.order, plan.foot_rings, STEPS, BLOCK).for_bands(cell, count)
    tiling = Tiling.single(by(cell, plan, used.steps, block=used.block + more, measured=False))
    pencil = CentredPencil.of(tiling)
    found, lost = [], []
    for kappa in wavevectors(cell):
        values, modes = eigenpairs(pencil, kappa, count)
        fields = pencil.periodic.expanded(pencil.free(modes, kappa), kappa)
        found.append(hertz(values))
        lost.append(interior_error(values, on_each(tiling.truncation, fields)))
    return np.array(found), np.array(lost)


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
