"""Cells drawn over all that a study can say, and their frequencies by a route that shares no estimate.

A cell with a pillar is meshed whole, several orders above those that accuracies usually lead to, and keeps
an interior space of several hundred fields. A plain plate needs no mesh: its waves are Rayleigh's and Lamb's.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import product

import numpy as np
import scipy.linalg as la
from numpy.typing import NDArray

from haptonic.bloch.centred import CentredPencil
from haptonic.bloch.pencil import eigenpairs
from haptonic.bloch.plate_waves import PlainPlate
from haptonic.cell import MeshPlan, Pillar, UnitCell
from haptonic.cell.pillar import Step
from haptonic.errors import GeometryError
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial, material
from haptonic.superelement import condense, condense_by_parts

Array = NDArray[np.float64]

KINDS = ("round", "square", "fillet", "draft", "step", "mixed", "round", "plain")
MATERIALS = ("steel", "brass", "soda-lime-glass", "silicon", "aluminium-2017a", "borosilicate-glass")
ACCURACIES = (2.5e-2, 1e-2, 5e-3, 2e-3, 1e-3, 5e-4)
COUNTS = (10, 10, 10, 15, 20, 30)
KAPPA = np.pi * np.array([(1, 0), (0.2, 1), (1, 1), (1, 0.5), (0.5, 0.5), (0.6, 0.3), (0.15, 0.05)])
STEPS, BLOCK = 5, 30  # of a reference's interior space
LARGEST = 200_000  # unknowns of a mesh that is condensed whole: 240,000 take 10 GB
# order and rings of a reference, and what such ones agreed to with others (relative), by the accuracy asked
FINE, COARSE = (7, 2, 3e-5), (6, 2, 2e-4)
COARSE_FROM, COARSE_UP_TO = 2e-3, 15  # accuracies from which the coarse one serves, and up to how many bands
LEAST_ORDER = 5  # of a reference
PLATE_LEVELS = 16  # polynomials through a plain plate, plus one


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
    kind = KINDS[number % len(KINDS)]
    while True:
        try:
            cell = _cell(rng, kind)
        except GeometryError:
            continue
        return Drawn(kind, cell, int(rng.choice(COUNTS)), float(rng.choice(ACCURACIES)))


def _log_uniform(rng: np.random.Generator, low: float, high: float) -> float:
    return float(math.exp(rng.uniform(math.log(low), math.log(high))))


def _cell(rng: np.random.Generator, kind: str) -> UnitCell:
    pitch = _log_uniform(rng, 2e-3, 20e-3)
    lattice = Lattice.square(pitch)
    if rng.random() < 0.5:
        lattice = Lattice.rectangular(pitch, pitch * _log_uniform(rng, 0.5, 2.0))
    short = min(pitch, lattice.a2[1])
    thickness = short * _log_uniform(rng, 0.02, 0.6)
    matter = material(str(rng.choice(MATERIALS)))
    if rng.random() < 0.5:
        matter = IsotropicMaterial(70e9, float(rng.uniform(-0.3, 0.49)), 2700.0, name="drawn")
    if kind == "plain":
        return UnitCell(lattice, thickness, matter)
    diameter, height = short * rng.uniform(0.05, 0.97), short * _log_uniform(rng, 0.05, 6.0)
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
    return np.sort(KAPPA)[:, ::-1] if "d" in cell.point_group.mirrors else KAPPA


@dataclass(frozen=True)
class Truth:
    """frequency, uncertainty : (len(KAPPA), count) Hz at `wavevectors`; route : how they were found."""

    frequency: Array
    uncertainty: Array
    route: str


def truth(question: Drawn) -> Truth:
    """Frequencies at `KAPPA`, with what they may be off by."""
    cell, count = question.cell, question.count
    if cell.pillar is None:
        exact = np.array([plain_plate(cell, kappa, count) for kappa in wavevectors(cell)])
        return Truth(exact, 1e-8 * exact, "Rayleigh-Lamb")
    coarse = question.accuracy >= COARSE_FROM and count <= COARSE_UP_TO
    order, rings, agreed = COARSE if coarse else FINE
    rings = 1 if cell.pillar.fillet else rings
    while _too_large(cell, order, rings):
        order, agreed = order - 1, COARSE[2]
    frequency, route = _computed(cell, count, order, rings)
    return Truth(frequency, agreed * frequency, route)


def _too_large(cell: UnitCell, order: int, rings: int) -> bool:
    """Whether a mesh that has to be condensed whole does not fit; a straight pillar's need not be."""
    straight = cell.pillar is not None and not (cell.pillar.draft or cell.pillar.step)
    return order > LEAST_ORDER and not straight and _unknowns(cell, order, rings) > LARGEST


def _unknowns(cell: UnitCell, order: int, rings: int) -> int:
    return 3 * sum(MeshPlan.suited(cell, order, rings).level_sizes)


def _computed(cell: UnitCell, count: int, order: int, rings: int) -> tuple[Array, str]:
    whole = _unknowns(cell, order, rings) < LARGEST
    by = condense if whole else condense_by_parts
    plan = MeshPlan.suited(cell, order, rings)
    pencil = CentredPencil.of(by(cell, plan, STEPS, block=BLOCK, measured=False))
    values = np.array([eigenpairs(pencil, kappa, count)[0] for kappa in wavevectors(cell)])
    route = f"order {order}, {plan.foot_rings} rings{'' if whole else ', by parts'}"
    return np.sqrt(np.maximum(values, 0.0)) / (2 * np.pi), route


def plain_plate(cell: UnitCell, kappa: Array, count: int) -> Array:
    """(count,) frequencies of a plate's waves, Hz, folded back into the zone of a lattice."""
    plate = PlainPlate.of(cell, PLATE_LEVELS + 1)
    turning = 1j * (plate.crossed.swapaxes(1, 2) - plate.crossed)
    far = math.ceil(math.sqrt(count)) + 1
    values: list[float] = []
    for turns in product(range(-far, far + 1), repeat=2):
        k = cell.lattice.wavevector(kappa + 2 * np.pi * np.array(turns))
        stiffness = np.einsum("a,b,abij->ij", k, k, plate.gradient) + np.tensordot(k, turning, axes=1)
        values += la.eigh(
            stiffness + plate.still, plate.mass, eigvals_only=True, subset_by_index=(0, 11)
        ).tolist()
    return np.sqrt(np.maximum(np.sort(values)[:count], 0.0)) / (2 * np.pi)
