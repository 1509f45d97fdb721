"""Which meshes are tried for an accuracy, and which are refused because of what they would cost."""

from __future__ import annotations

import math
from dataclasses import replace

from haptonic.bloch.resolution import LADDER, LEAST_ORDER, LEAST_STEPS, Resolution
from haptonic.cell import UnitCell
from haptonic.errors import GeometryError, ResourceError
from haptonic.later import psutil

# Rounding of a plate's stiffness grows as the fourth power of pitch over thickness: at 1/400 it spoilt the
# estimates of a plain plate, and at 1/1000 it moved the lowest band by 0.7 %.
LEAST_THICKNESS = 0.004  # of the longer pitch
EXPECTED = (5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4, 3e-5, 1e-5, 2e-6)  # error each is tried for first


def starting_rung(accuracy: float) -> int:
    """The rung of the ladder that an accuracy (relative) is tried on first."""
    for rung, expected in enumerate(EXPECTED):
        if expected <= accuracy:
            return rung
    return len(LADDER) - 1


def first_rung(cell: UnitCell, accuracy: float) -> int:
    """The rung that an accuracy (relative) is tried on first for a cell.

    Between pillars that nearly touch on a thin plate the rungs told 1.3 to 1.8 times what they do elsewhere.
    Of a plain plate order 3 told 3 to 8 %, whatever was asked: its lower order has parabolas for plate waves.
    """
    if not cell.has_pillars:
        return max(starting_rung(accuracy), 1)
    narrow = any(
        one.tile.pillar is not None and one.tile.is_thin and one.tile.clearance < cell.thickness
        for one in cell.tiles
    )
    return min(starting_rung(accuracy) + narrow, len(LADDER) - 1)


LONGEST = 60.0  # s of one processor, foreseen for all meshes that are tried for an accuracy of `USUAL`
USUAL = 2e-3  # for finer ones as the root of their ratio: who asks for more digits waits longer
LITTLE = 0.5  # of the same; see `is_little`
LATE = 1.5  # times the same for the mesh that follows an answer: who has waited wants no refusal by a hair
MOST_MEMORY = 0.9  # of what is free


def longest(accuracy: float) -> float:
    """Processor time that may be foreseen for all meshes tried for an accuracy, s."""
    return LONGEST * max(1.0, math.sqrt(USUAL / accuracy))


def started(cell: UnitCell, count: int, accuracy: float) -> list[Resolution]:
    """The meshes that have to fit before the first is made.

    The first rung is tried for an accuracy, and does not always reach it: so the one after has to fit as
    well. A plain plate has no edge, and the first was enough for it.
    """
    first = first_rung(cell, accuracy)
    return [rung.for_bands(cell, count) for rung in LADDER[first : first + (2 if cell.has_pillars else 1)]]


def most_bands(cell: UnitCell, fewer_than: int, accuracy: float) -> int:
    """Most bands below a refused number whose first meshes are foreseen to fit; 0 if none are."""
    for count in range(fewer_than - 1, 0, -1):
        tried = started(cell, count, accuracy)
        if _fit(cell, tried, accuracy):
            return count
    return 0


def is_little(seconds: float, accuracy: float) -> bool:
    """Whether a first mesh is tried though the second may not fit.

    Of 14 drawn cells with such meshes the first was enough for all.
    """
    return seconds <= LITTLE * longest(accuracy)


def _fit(cell: UnitCell, tried: list[Resolution], accuracy: float) -> bool:
    """Whether meshes fit the time for an accuracy together, and the memory one by one."""
    free = float(psutil.virtual_memory().available)
    return (
        sum(one.seconds(cell) for one in tried) <= longest(accuracy)
        and max(one.memory(cell) for one in tried) <= MOST_MEMORY * free
    )


def within_reach(cell: UnitCell, count: int, refused: float) -> float:
    """The best accuracy above a refused one whose meshes are foreseen to fit time and memory, or infinity.

    A rung told up to four times what it is tried for, so those up to the one after it have to fit, unless it
    takes little itself; an interior of two blocks may have to grow. It is a forecast: a slender pillar on a
    plate of 0.1 to 0.15 pitches told 1 to 2 % at order 4, ten times what that is tried for.
    """
    for rung in range(len(LADDER) - 1, -1, -1):
        accuracy = 2 * EXPECTED[rung]
        if accuracy <= refused:
            continue
        first = first_rung(cell, accuracy)
        tried = [one.for_bands(cell, count) for one in LADDER[first : max(first, rung) + 2]]
        if tried[-1].steps == LEAST_STEPS:
            tried.append(tried[-1].grown())
        alone = first == rung and is_little(tried[0].seconds(cell), accuracy)
        if _fit(cell, tried[:1] if alone else tried, accuracy):
            return accuracy
    return math.inf


def check_cost(
    cell: UnitCell,
    resolution: Resolution,
    accuracy: float,
    spent: float = 0.0,
    reached: float = math.inf,
) -> float:
    """Refuse a mesh that does not fit, or takes longer than anybody waits for; else its processor time, s.

    Parameters
    ----------
    spent : s, for the meshes that were tried before; reached : the best accuracy that any answered with
    """
    needed, memory = resolution.seconds(cell), resolution.memory(cell)
    free = float(psutil.virtual_memory().available)
    too_large = memory > MOST_MEMORY * free
    if not too_large and spent + needed <= longest(accuracy) * (LATE if reached < math.inf else 1.0):
        return needed
    possible = reached if reached < math.inf else within_reach(cell, resolution.bands, accuracy)
    would = (
        f"need about {memory / 1e9:.1f} GB, and {free / 1e9:.1f} GB are free"
        if too_large
        else f"take about {needed:.0f} s of processor time for this cell"
        + (f", after {spent:.0f} s for lower ones" if spent else "")
    )
    fewer = most_bands(cell, resolution.bands, accuracy)
    raise ResourceError.too_large(
        argument="bands.accuracy",
        given=f"{accuracy:g}",
        allowed=f"{rounded_up(possible):g} or more for this cell and {resolution.bands} bands"
        if possible < math.inf
        else f"at most {fewer} bands for this cell"
        if fewer
        else "what meshes reach in a time that anybody waits for: with sizes like these none does",
        cause=f"elements of order {resolution.order} with {resolution.foot_rings} rings at the foot would "
        f"{would}",
        next_step=" or ".join(
            ["ask for less accuracy"] * (possible < math.inf)
            + [f"ask for at most {fewer} bands"] * (fewer > 0)
        )
        or "choose a thicker plate, a wider gap between the pillars, or a stouter pillar",
    )


def check_memory(cell: UnitCell, chosen: Resolution) -> None:
    """Refuse a mesh that somebody chose and this machine cannot hold; how long it takes is up to them."""
    free = MOST_MEMORY * psutil.virtual_memory().available
    needed = chosen.memory(cell)
    if needed <= free:
        return
    lower = (replace(chosen, order=order) for order in range(chosen.order - 1, LEAST_ORDER - 1, -1))
    fits = next((one.order for one in lower if one.memory(cell) <= free), None)
    raise ResourceError.too_large(
        argument="mesh",
        given=f"order = {chosen.order}, foot_rings = {chosen.foot_rings}",
        allowed=f"a mesh of a cell that fits into the {free / 1e9:.1f} GB that are free",
        cause=f"it may need {needed / 1e9:.1f} GB",
        next_step=f"write order = {fits}, or leave [mesh] out" if fits else "leave [mesh] out",
    )


def check_start(cell: UnitCell, count: int, accuracy: float) -> None:
    """Refuse before anything is condensed what would most likely be refused afterwards; see `started`."""
    spent = 0.0
    for rung in started(cell, count, accuracy):
        spent += check_cost(cell, rung, accuracy, spent)
        if is_little(spent, accuracy):
            return


def rounded_up(value: float, digits: int = 2) -> float:
    """The next number of so many digits that is not below ``value``."""
    unit = 10.0 ** (math.floor(math.log10(value)) - digits + 1)
    return float(f"{math.ceil(value / unit) * unit:.{digits}g}")


def check_thickness(cell: UnitCell) -> None:
    """Refuse a plate that is too thin for its pitch to be computed at all."""
    longest = max(math.hypot(*cell.lattice.a1), math.hypot(*cell.lattice.a2))
    if cell.thickness < LEAST_THICKNESS * longest:
        raise GeometryError.out_of_range(
            argument="cell.thickness",
            given=f"{cell.thickness * 1e3:.4g} mm",
            allowed=f"at least {LEAST_THICKNESS * longest * 1e3:.4g} mm, {LEAST_THICKNESS:g} of the pitch",
            cause="on a plate as thin as this rounding spoils every frequency",
            next_step="choose a thicker plate or a smaller pitch",
        )
