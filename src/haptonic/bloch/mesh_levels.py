"""Selection of the mesh levels for a cell, within a budget of time and the free memory.

Computation, forecast and refusals use the same functions: `MeshLimits.lack` compares a mesh with the limits,
`first_level` selects the first mesh level.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, Literal

from haptonic.bloch.resolution import LEAST_ORDER, LEVELS, Resolution
from haptonic.cell import UnitCell
from haptonic.errors import GeometryError, HaptonicError, ResourceError
from haptonic.later import psutil
from haptonic.names import counted
from haptonic.units import duration

# Rounding of a plate's stiffness grows as the fourth power of pitch over thickness: at 1/400 it affected the
# error estimates of a plain plate, and at 1/1000 it changed the lowest band by 0.7 %.
LEAST_THICKNESS = 0.004  # of the longer pitch
# Accuracy of each level. For eight round pillars in plates of 0.06 to 0.29 pitches the second level had
# estimates of 1.7e-3 to 3.7e-3, the third 1.9 to 4.5 times less, and the fourth 2.0 to 4.7 times less again.
EXPECTED = (5e-3, 2e-3, 8e-4, 4e-4, 2e-4, 1e-4, 3e-5, 1e-5, 2e-6)
# Accuracy from which the first level is enough for most holes. Of 26 drawn inclusions, with and without a
# coating, 22 had estimates of 1.1e-3 to 5e-3 at that level.
WITH_HOLES = 1e-2
MOST_MEMORY = 0.9  # share of the free memory
LARGEST_BUDGET = 30 * 86400.0  # s
LOWER = ((3, 0), (2, 1), (2, 0))  # orders and rings below the mesh levels, which [mesh] can set


def starting_level(accuracy: float) -> int:
    """Number of the mesh level that is first computed for an accuracy (relative)."""
    for level, expected in enumerate(EXPECTED):
        if expected <= accuracy:
            return level
    return len(LEVELS) - 1


def expected_level(cell: UnitCell, accuracy: float) -> int:
    """Number of the mesh level that is first computed for a cell and an accuracy (relative).

    Error estimates are larger for pillars that nearly touch on a thin plate, for plain plates at order 3, and
    for holes in the plate.
    """
    has_hole = any(disc.empty and disc.is_in_plate for disc in cell.discs.values())
    if not cell.has_features or (has_hole and accuracy < WITH_HOLES):
        return max(starting_level(accuracy), 1)
    narrow = any(
        placed.tile.pillar is not None and placed.tile.is_thin and placed.tile.clearance < cell.thickness
        for placed in cell.tiles
    )
    return min(starting_level(accuracy) + narrow, len(LEVELS) - 1)


@dataclass(frozen=True)
class MeshLimits:
    """Limits for the meshes of a cell.

    seconds : estimated time of one processor for all meshes together, the user's budget
    memory : bytes, of each mesh
    """

    seconds: float
    memory: float

    @classmethod
    def of(cls, budget: float) -> MeshLimits:
        """Limits from a budget (s) and the free memory."""
        return cls(budget, MOST_MEMORY * float(psutil.virtual_memory().available))

    @property
    def gigabytes(self) -> str:
        """Memory limit as text."""
        return f"{self.memory / 1e9:.2g} GB of the free memory may be used"

    def lack(self, cell: UnitCell, mesh: Resolution, spent: float = 0.0) -> Lack | None:
        """Limit that a mesh exceeds after ``spent`` s for other meshes; None if it fits."""
        if mesh.memory(cell) > self.memory:
            return Lack("memory", mesh, self, spent)
        return Lack("time", mesh, self, spent) if spent + mesh.seconds(cell) > self.seconds else None


@dataclass(frozen=True)
class Lack:
    """Reason why a mesh is not computed; "range" for the finest mesh, which no mesh follows.

    spent : estimated time of the meshes before it, s
    """

    of: Literal["time", "memory", "range"]
    mesh: Resolution
    limits: MeshLimits
    spent: float = 0.0

    def text(self, cell: UnitCell) -> str:
        """Text with the need of the mesh and the limit."""
        name = f"a mesh of order {self.mesh.order} with {counted(self.mesh.foot_rings, 'ring')} at the foot"
        if self.of == "memory":
            return f"{name} needs about {self.mesh.memory(cell) / 1e9:.2g} GB, and {self.limits.gigabytes}"
        if self.of == "range":
            return f"{name} is the finest mesh"
        after = f" after {duration(self.spent)} for coarser ones" if self.spent else ""
        return (
            f"{name} takes about {duration(self.mesh.seconds(cell))} of processor time{after}, and the "
            f"budget is {duration(self.limits.seconds)}"
        )

    def attributes(self, cell: UnitCell) -> dict[str, Any]:
        """Attributes of a dataset: the limit, its text, and for time the sufficient budget (s)."""
        attributes = {"stopped_by": self.of, "stopped_why": self.text(cell)}
        return attributes | ({"budget_needed_s": self.budget(cell)} if self.of == "time" else {})

    def budget(self, cell: UnitCell) -> float:
        """Smallest sufficient budget in whole minutes, or hours of two digits, s."""
        seconds = self.spent + self.mesh.seconds(cell)
        unit = 3600.0 if seconds > 6000 else 60.0 if seconds > 60 else 1.0
        return rounded_up(seconds * (1 + 1e-9) / unit) * unit


def first_level(cell: UnitCell, count: int, accuracy: float, limits: MeshLimits) -> int:
    """Number of the mesh level that is computed first.

    It is the first level for the accuracy, or the highest level below it that fits. A cell is computed, with
    its error, if any level fits.

    Raises
    ------
    GeometryError : a plate too thin to be computed
    ResourceError : not even the lowest level fits
    """
    check_thickness(cell)
    lack = None
    for level in range(expected_level(cell, accuracy), -1, -1):
        lack = limits.lack(cell, LEVELS[level].for_bands(cell, count))
        if lack is None:
            return level
    assert lack is not None, "no mesh levels"
    raise refusal(cell, count, accuracy, lack)


def growth_for(truncation: float, goal: float) -> int:
    """Number of enlargements of the interior for a truncation goal; see `Resolution.grown`.

    The first three widen the blocks, which takes 5 to 20 % more time each; a further condensation takes all
    of it again. Around wide holes and pillars each divided the truncation error by 1.4 to 8, so a half is
    expected. Further ones add blocks, and a tenth is expected.
    """
    ratio = truncation / goal
    return max(min(math.ceil(math.log2(ratio)), 3), math.ceil(math.log10(ratio)), 1)


def finer_level(
    cell: UnitCell, mesh: Resolution, level: int, excess: float, limits: MeshLimits, spent: float
) -> tuple[int, Resolution] | Lack:
    """Select the next level and mesh, with at least the present interior, or give the reason for none.

    It is the first level that is expected to reach the accuracy, or the highest level below it that fits.
    Without singular edges the error decreases like the square of `EXPECTED`: for a plain plate and plates
    with holes, each order divided it by 4 to 14.

    excess : error of the mesh as a multiple of the accuracy; spent : time of the meshes before, s
    """
    tried = mesh.plans(cell)
    meshes = {n: LEVELS[n].for_bands(cell, mesh.bands) for n in range(level + 1, len(LEVELS))}
    # without a pillar, rings have no effect
    levels = [n for n, finer in meshes.items() if finer.plans(cell) != tried]
    if all(part.tile.is_smooth for part in cell.tiles):
        excess = math.sqrt(excess)
    reaching = (n for n in levels if excess * EXPECTED[n] <= EXPECTED[level])
    following = min(levels, default=level)
    # in files, a level divided the error of a pillar by 7 (by 2.5 in `EXPECTED`), in three times the memory
    first = following if cell.solid is not None else next(reaching, following)
    lack = Lack("range", mesh, limits, spent)
    for n in reversed([n for n in levels if n <= first]):
        finer = replace(
            meshes[n], steps=max(meshes[n].steps, mesh.steps), block=max(meshes[n].block, mesh.block)
        )
        missing = limits.lack(cell, finer, spent)
        if missing is None:
            return n, finer
        lack = missing
    return lack


def started(cell: UnitCell, count: int, accuracy: float, limits: MeshLimits) -> list[Resolution]:
    """Meshes computed first: the first level, and the next if it fits; errors as in `first_level`."""
    level = first_level(cell, count, accuracy, limits)
    first, *after = (finer.for_bands(cell, count) for finer in LEVELS[level : level + 2])
    return [first, *(mesh for mesh in after if limits.lack(cell, mesh, first.seconds(cell)) is None)]


def most_bands(cell: UnitCell, fewer_than: int, limits: MeshLimits) -> int:
    """Largest number of bands, below a refused number, whose lowest mesh level fits; 0 if none does."""
    fits = (n for n in range(fewer_than - 1, 0, -1) if not limits.lack(cell, LEVELS[0].for_bands(cell, n)))
    return next(fits, 0)


def refusal(cell: UnitCell, count: int, accuracy: float, lack: Lack) -> HaptonicError:
    """Error for a cell whose coarsest mesh exceeds the time or the memory.

    Its next steps are checked against the same limits.
    """
    limits, reason = lack.limits, lack.text(cell)
    fewer = most_bands(cell, count, limits)
    steps = [f"write count = {fewer} in [bands]"] * (fewer > 0)
    if lack.of == "range":
        return GeometryError.inaccurate(
            argument="cell",
            given=f"{count} bands of a cell",
            allowed="cells whose inner motion a mesh can resolve",
            cause=f"range of validity: every mesh omits too much of the inner motion, and {reason}",
            next_step="set fewer bands with count in [bands]",
        )
    if lack.of == "memory":
        needed = rounded_up(lack.mesh.memory(cell) / MOST_MEMORY / 1e9)
        steps += lower_meshes(cell, LEVELS[starting_level(accuracy)], count, limits)
        steps.append(f"free memory until {needed:g} GB are free, or use a machine that has them")
        return ResourceError.too_large(
            argument="memory",
            given=limits.gigabytes,
            allowed=f"a cell whose meshes fit, or at least {needed:g} GB of free memory for {count} bands",
            cause=f"lack of memory: {reason}",
            next_step=", or ".join(steps),
        )
    budget = lack.budget(cell)
    if budget > LARGEST_BUDGET:
        return GeometryError.out_of_range(
            argument="cell",
            given=f"a cell whose coarsest mesh takes {duration(budget)}",
            allowed=f"cells and numbers of bands whose meshes take at most {duration(LARGEST_BUDGET)}",
            cause=f"range of validity: the sizes of the cell are too far apart for any mesh; {reason}",
            next_step=", or ".join([*steps, "choose a thicker plate or a wider gap between the pillars"]),
        )
    text = duration(budget)
    steps = [f'ask again with --budget "{text}", or write budget = "{text}" in [bands]', *steps]
    return ResourceError.too_large(
        argument="bands.budget",
        given=duration(limits.seconds),
        allowed=f"at least {text} for this cell and {count} bands",
        cause=f"lack of time: {reason}",
        next_step=", or ".join(steps),
    )


def lower_meshes(cell: UnitCell, first: Resolution, count: int, limits: MeshLimits) -> list[str]:
    """Next step with the finest mesh below all mesh levels that fits into the memory.

    If none fits for ``count`` bands, the step is the coarsest mesh with as many bands as fit.

    first : mesh whose interior the lower meshes keep
    """
    meshes = [replace(first, order=order, foot_rings=rings) for order, rings in LOWER]
    tried = [(mesh, count) for mesh in meshes] + [(meshes[-1], n) for n in range(count - 1, 0, -1)]
    for mesh, bands in tried:
        if mesh.for_bands(cell, bands).memory(cell) <= limits.memory:
            step = f"write order = {mesh.order} and foot_rings = {mesh.foot_rings} in [mesh]"
            return [f"{step} and count = {bands} in [bands]" if bands < count else step]
    return []


def check_memory(cell: UnitCell, chosen: Resolution, count: int, limits: MeshLimits) -> None:
    """Refuse a mesh of the user for ``count`` bands that exceeds the memory; its time is not limited."""
    mesh = chosen.for_bands(cell, count)
    if mesh.memory(cell) <= limits.memory:
        return
    lower = (replace(mesh, order=order) for order in range(chosen.order - 1, LEAST_ORDER - 1, -1))
    fits = next((mesh.order for mesh in lower if mesh.memory(cell) <= limits.memory), None)
    steps = [f"write order = {fits} in [mesh]"] if fits else []
    if limits.lack(cell, LEVELS[0].for_bands(cell, count)) is None:
        steps.append("leave [mesh] out")
    steps = steps or lower_meshes(cell, chosen, count, limits)
    needed = rounded_up(mesh.memory(cell) / MOST_MEMORY / 1e9)
    raise ResourceError.too_large(
        argument="mesh",
        given=f"order = {chosen.order}, foot_rings = {chosen.foot_rings}",
        allowed=f"a mesh that fits: {limits.gigabytes}",
        cause=f"lack of memory: {Lack('memory', mesh, limits).text(cell)}",
        next_step=", or ".join(steps)
        or f"free memory until {needed:g} GB are free, or use a machine that has them",
    )


def check_thickness(cell: UnitCell) -> None:
    """Refuse a plate that is too thin for its pitch."""
    longest = max(math.hypot(*cell.lattice.a1), math.hypot(*cell.lattice.a2))
    if cell.thickness < LEAST_THICKNESS * longest:
        least = f'"{rounded_up(LEAST_THICKNESS * longest * 1e3, 4):g} mm"'
        raise GeometryError.out_of_range(
            argument="cell.thickness",
            given=f"{cell.thickness * 1e3:.4g} mm",
            allowed=f"at least {least.strip(chr(34))}, {LEAST_THICKNESS:g} of the pitch",
            cause="range of validity: rounding errors are too large for a plate as thin as this",
            next_step=f"write thickness = {least} or more in [cell], or choose a smaller pitch",
        )


def rounded_up(value: float, digits: int = 2) -> float:
    """Smallest number with so many digits that is not below ``value``."""
    unit = 10.0 ** (math.floor(math.log10(value)) - digits + 1)
    return float(f"{math.ceil(value / unit) * unit:.{digits}g}")
