"""Refusal of bounds and limits that no design meets together, with values that would do."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial

import numpy as np

from haptonic.arrays import Array
from haptonic.design.brief import LEAST_BETWEEN, LEAST_GAP, Brief
from haptonic.errors import HaptonicError, StudyError
from haptonic.names import listed
from haptonic.units import format_quantity

REACHES = tuple(0.02 * 1.5**k for k in range(17))  # shares of a value by which it moves, up to 13 times it
LEAST_SCALE = 1e-3  # of a value of zero, such as the height of the plate's upper face
HALVINGS = 16
DIGITS = 3  # of a proposed value
SLIGHT = 0.05  # of the last digit: rounding of a value that has no further digits
MOST_PROPOSED = 3
RELAXED = {"slenderness": ("", 1), "tool": ("m", -1), "reach": ("m", 1), "finger_deflection": ("m", 1)}
"""Keys of [design] that limit the designs: unit, and sign of a change that relaxes the limit."""


def check_met(brief: Brief) -> None:
    """Refuse bounds that contradict each other, or that leave no design.

    Raises
    ------
    StudyError : limits that cannot be met together, with the limit that is missed and values that would do
    """
    best = brief.feasible(np.full(len(brief.bounds), 0.5))
    if brief.allows(best):
        return
    worst, room = min(brief.limits(best).items(), key=lambda item: item[1])
    values = zip(brief.paths, brief.values(best), strict=True)
    closest = listed([f"{path} = {_text(value, brief.links.unit(path))}" for path, value in values])
    enough = [*_wider_bounds(brief, best), *_relaxed_limits(brief, best)][:MOST_PROPOSED]
    raise StudyError.no_answer(
        argument="design",
        given=f"bounds of {', '.join(brief.paths) or 'nothing'}",
        allowed="bounds that some design meets together",
        cause=f"{_missed(brief, best, worst, room)}, even in the closest design, {closest or 'the cell'}",
        next_step=listed(enough, "or") if enough else "widen several bounds together",
    )


def _missed(brief: Brief, share: Array, limit: str, room: float) -> str:
    """A missed limit in plain words, with its value."""
    cell, allowed = brief.unchecked(share), brief.allowed
    name, _, table = limit.partition(" of cell.")

    def length(value: float) -> str:
        return _text(value, "m")

    apart = (room + LEAST_BETWEEN) * cell.thickness
    passing = f"pass each other by {length(-apart)}" if apart < 0 else f"are only {length(apart)} apart"
    gap = length(max(allowed.tool or 0.0, LEAST_GAP * cell.lattice.pitch))
    words = {
        "gap between discs": f"neighbouring discs overlap or are closer than {gap}",
        "gap between pillars": f"neighbouring pillars overlap or are closer than {gap}",
        "layers of the discs": f"ends of two discs {passing}",
        "rings of the discs": "sides of discs pass each other or nearly meet",
        "slenderness": f"a part is higher than {allowed.slenderness or 0:g} times its least width",
        "reach of the tool": f"a part is higher, or a hole deeper, than {length(allowed.reach or 0)}",
        "width of a hole": f"a hole is narrower than the end mill, {length(allowed.tool or 0)}",
        "finger": f"a plate of {length(cell.thickness)} deflects too much under the finger",
    }.get(name, f'the limit "{name}" is missed by {-room:.3g} of its value')
    return f"{words} (cell.{table})" if table else words


def _wider_bounds(brief: Brief, share: Array) -> Iterator[str]:
    """Proposals of one wider bound each, with which the other numbers of a position are allowed."""
    for position, (path, bounds) in enumerate(brief.bounds.items()):
        others = np.delete(share, position)
        for key, end, sign in zip(("from", "to"), bounds, (-1, 1), strict=True):
            value = _sufficient(partial(_allows_number, brief, others, path), end, sign)
            if value is not None:
                yield f'let {path} vary {key} "{_text(value, brief.links.unit(path))}"'


def _allows_number(brief: Brief, others: Array, path: str, value: float) -> bool:
    fixed = brief.fixed(path, value)
    fixed.at(others)  # bounds do not contain the value, so that it may give no body
    return fixed.allows(others)


def _relaxed_limits(brief: Brief, share: Array) -> Iterator[str]:
    """Proposals of one relaxed limit each, with which a position is allowed."""
    for key, (unit, sign) in RELAXED.items():
        if (given := getattr(brief.allowed, key)) is not None:
            value = _sufficient(partial(_allows_limit, brief, share, key), given, sign)
            if value is not None:
                text = _text(value, unit)
                yield f"write {key} = " + (f'"{text}"' if unit else text) + " in [design]"


def _allows_limit(brief: Brief, share: Array, key: str, value: float) -> bool:
    return replace(brief, allowed=replace(brief.allowed, **{key: value})).allows(share)


def _sufficient(allows: Callable[[float], bool], start: float, sign: int) -> float | None:
    """The nearest value on one side of a start that is allowed, rounded to `DIGITS`; None if none is."""

    def is_allowed(value: float) -> bool:
        try:
            return allows(value)
        except HaptonicError:
            return False

    scale, near = sign * (abs(start) or LEAST_SCALE), 0.0
    far = next((far for far in REACHES if is_allowed(start + far * scale)), None)
    if far is None:
        return None
    for _ in range(HALVINGS):
        middle = 0.5 * (near + far)
        near, far = (near, middle) if is_allowed(start + middle * scale) else (middle, far)
    value = start + far * scale
    step = 10.0 ** (math.floor(math.log10(abs(value) or LEAST_SCALE)) + 1 - DIGITS)
    digits = math.ceil(sign * value / step - SLIGHT)
    rounded = (float(f"{sign * number * step:.12g}") for number in (digits, digits + 1))
    return next(filter(is_allowed, rounded), None)


def _text(value: float, unit: str) -> str:
    return format_quantity(value, unit, digits=DIGITS)
