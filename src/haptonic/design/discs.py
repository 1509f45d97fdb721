"""Numbers of discs that move together, and those that a designer can change without a change of the grid.

A design follows one mesh. Discs that share an end, a border or a material go on sharing it, so that such
equal numbers count as one and move together. An end at a face of the plate stays there. A number that would
part the sides of two discs, such as the angle of a cone below a cap, is fixed. In sweeps and fits, every
design has a mesh of its own, and only ends that meet move together.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from haptonic.cell import UnitCell
from haptonic.cell.outlines.outline import SAME
from haptonic.cell.stack import Stack
from haptonic.errors import HaptonicError
from haptonic.fields import with_numbers
from haptonic.names import listed
from haptonic.units import format_quantity

DISC = re.compile(r"cell\.(?P<table>(?:site\[\d+\]\.)?)disc\[(?P<number>\d+)\]\.(?P<name>.+)")
DIGITS = 8  # of equal numbers of one border
SLIGHT = 1e-5  # relative change of a number that must not part the sides of two discs
PARTED = (
    "the side of this disc and that of the next one would no longer meet",
    "vary a number that both have, such as their diameter, or write a study for each value",
)


def stacks_of(cell: UnitCell) -> dict[str, Stack]:
    """Stacks of discs, by the path of their site or cell, below [cell]."""
    return {
        table: Stack(discs, cell.thickness, cell.is_mirrored) for table, discs in cell.disc_tables.items()
    }


@lru_cache(maxsize=64)
def moving_together(cell: UnitCell) -> dict[str, tuple[str, ...]]:
    """Numbers of discs that designs can vary, each with the paths of the equal numbers that move with it."""
    groups: dict[tuple[object, ...], list[str]] = {}
    stacks = stacks_of(cell)
    for path, value in cell.numbers().items():
        if (named := DISC.fullmatch(path)) is None:
            continue
        table, name = named["table"], named["name"]
        stack = stacks[table]
        disc = stack.discs[int(named["number"]) - 1]
        if name in ("low", "high"):
            level = _level(stack, disc.ends(stack.thickness)[name == "high"])
            if level not in (None, 0, stack.in_plate):
                groups.setdefault((table, "level", level), []).append(path)
        elif name.startswith("material."):
            groups.setdefault((table, name, disc.material), []).append(path)
        elif value:  # a sharp corner cannot vary into a round one
            border = stack.border_of(int(named["number"]) - 1)
            share = round(value if name == "draft" else value / stack.widest, DIGITS)
            groups.setdefault((table, name, disc.section, border, share), []).append(path)
    return {first: tuple(others) for first, *others in groups.values() if _keeps(cell, [first, *others])}


def _keeps(cell: UnitCell, paths: Sequence[str]) -> bool:
    """True if a small change of some equal numbers leaves the sides of discs together that continue others.

    Prisms of one border move together, so there is nothing to check.
    """
    if not any(disc.draft for disc in cell.discs.values()):
        return True
    changed = dict.fromkeys(paths, (1 + SLIGHT) * cell.numbers()[paths[0]])
    return is_divided_alike(cell, with_numbers(cell, changed, "cell.", checked=False))


def with_shared(cell: UnitCell, values: Mapping[str, float]) -> dict[str, float]:
    """New values of numbers of a cell, and of the numbers of discs that move with them in designs."""
    together = moving_together(cell)
    others = {other: value for path, value in values.items() for other in together.get(path, ())}
    return {**values, **others}


def with_joined(cell: UnitCell, values: Mapping[str, Any]) -> dict[str, Any]:
    """New values of numbers of a cell, and of the ends of discs that meet those that change.

    Ends meet if one disc ends where another one of its stack begins, as a pillar on its glue does.
    """
    ends = {
        path: (named["table"], height, named["name"])
        for path, height in cell.numbers().items()
        if (named := DISC.fullmatch(path)) and named["name"] in ("low", "high")
    }
    moved: dict[str, Any] = {}
    for path, value in values.items():
        if path in ends:
            table, changed, _ = ends[path]
            near = {
                end: name
                for end, (same, height, name) in ends.items()
                if same == table and abs(height - changed) <= SAME * cell.thickness
            }
            if len(set(near.values())) > 1:
                moved |= dict.fromkeys(near, value)
    return {**moved, **values}


def for_given_end(cell: UnitCell, given: Mapping[str, Any], error: HaptonicError) -> HaptonicError:
    """The error of a disc without thickness for the end that was changed, with the range that it has."""
    moved = with_joined(cell, given)
    lows, highs = list[float](), list[float]()
    for path, disc in cell.discs.items():
        low, high = (end - cell.thickness for end in disc.ends(cell.thickness))
        lows += [low] if f"cell.{path}.high" in moved else []
        highs += [high] if f"cell.{path}.low" in moved else []
    path, value = next(iter(given.items()), ("", 0.0))
    above, below = max(lows, default=-math.inf), min(highs, default=math.inf)
    if len(given) != 1 or not isinstance(value, int | float) or not (value <= above or value >= below):
        return error
    ranges = [f"above {format_quantity(above, 'm')}"] if lows else []
    ranges += [f"below {format_quantity(below, 'm')}"] if highs else []
    joined = listed([end for end in moved if end != path])
    return error.changed(
        type(error),
        argument=path,
        given=format_quantity(value, "m"),
        allowed=listed(ranges),
        cause=(f"{joined} meets it and moves with it; " if joined else "") + "a disc would have no thickness",
        next_step="choose a height in this range",
    )


def reason_of_thickness(cell: UnitCell) -> tuple[str, str] | None:
    """Cause and next step if discs fix the thickness; None if it can vary."""
    for table, stack in stacks_of(cell).items():
        for number, disc in enumerate(stack.discs, start=1):
            if disc.low is not None and _level(stack, stack.thickness + disc.low) == 0:
                low = f"cell.{table}disc[{number}].low"
                return (
                    f"{low} is a number that would not follow the lower face",
                    f"leave {low} out of the disc",
                )
    return None if _keeps(cell, ["cell.thickness"]) else PARTED


def reason_fixed(cell: UnitCell, path: str) -> tuple[str, str] | None:
    """Cause and next step for a number of the cell that discs keep from varying; None for another path."""
    if path not in cell.numbers():
        return None
    for first, others in moving_together(cell).items():
        if path in others:
            return f"it equals {first}, and the two move together", f"name {first} instead"
    if path == "cell.thickness":
        return reason_of_thickness(cell)
    if path.endswith((".low", ".high")):
        end = "this end lies at a face or below the middle of the plate", "vary the other end, or a diameter"
        return end if _keeps(cell, [path]) else PARTED
    return PARTED if path.endswith((".diameter", ".draft")) and cell.numbers()[path] else None


def is_divided_alike(cell: UnitCell, other: UnitCell) -> bool:
    """True if the discs of two cells form the same grids of storeys and annuli."""
    grids = [
        [(stack.grid, stack.in_plate, stack.chains) for stack in stacks_of(each).values()]
        for each in (cell, other)
    ]
    return grids[0] == grids[1]


def _level(stack: Stack, end: float) -> int | None:
    """Number of the level of an end above the plate's lower face, m; None below the lowest level."""
    near = np.flatnonzero(np.abs(stack.heights - end) <= SAME * stack.thickness)
    return int(near[0]) if len(near) else None
