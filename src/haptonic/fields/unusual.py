"""Remarks on allowed values that are so unusual that they are probably mistakes, such as a wrong unit.

A number declares its usual range (`Quantity.typical`). A described value that compares its numbers with each
other has a method ``doubtful()``, which returns sentences by path below the value.
"""

from __future__ import annotations

import sys
import warnings
from collections.abc import Container, Iterable, Iterator
from types import FrameType
from typing import Any

from haptonic.errors import HaptonicWarning
from haptonic.fields.keys import is_described, leaves, slots
from haptonic.fields.quantity import Quantity

PACKAGE = __name__.partition(".")[0]
PASSED_BY = ("dataclasses",)  # `dataclasses.replace` makes a value for its caller


def unusual_values(model: Any, prefix: str = "", without: Container[int] = frozenset()) -> dict[str, str]:
    """Remarks on unusual numbers of a described value, by path in a study.

    Numbers are compared with each other only if each of them is within its typical range.

    Parameters
    ----------
    prefix, without : see `haptonic.fields.leaves`
    """
    numbers = leaves(model, prefix, without=without)
    remarks = {path: declared.unusual(number) for path, number, declared in numbers if declared}
    remarks = {path: text for path, text in remarks.items() if text}
    for place, value in _values(model, prefix, without):
        doubtful = getattr(value, "doubtful", None)
        if not remarks and doubtful is not None:  # a wrong unit also explains unusual ratios
            remarks = {f"{place}{path}": text for path, text in doubtful().items() if text}
    return remarks


def unusual_beside(
    value: float, unit: str, shares: tuple[float, float], yardstick: float, beside: str
) -> str:
    """Remark on a value that is unusual relative to another one; empty for an ordinary value.

    Parameters
    ----------
    value, yardstick : the number and its reference, in ``unit``
    shares : lowest and highest usual ratio of the two
    beside : name of the reference, such as "for a pitch of 7 mm"
    """
    low, high = (float(f"{share * yardstick:.2g}") for share in shares)
    return Quantity(unit, typical=(low, high)).unusual(value, beside)


def warn_caller(texts: Iterable[str], frame: FrameType | None, kind: type | None = None) -> None:
    """Warn the code that made a value, unless it is this package.

    Parameters
    ----------
    texts : sentences; they are computed only for a warning
    frame : frame of the caller
    kind : class whose own constructors (class methods) do not count as callers
    """
    while frame is not None and (
        _package(frame) in PASSED_BY or (kind is not None and frame.f_locals.get("cls") is kind)
    ):
        frame = frame.f_back
    if frame is None or _package(frame) == PACKAGE:
        return
    level, above = 1, sys._getframe()
    while above is not frame and above.f_back is not None:
        level, above = level + 1, above.f_back
    for text in texts:
        warnings.warn(text, HaptonicWarning, stacklevel=level)


def caller() -> FrameType | None:
    """Frame of the caller of the function that calls this one."""
    try:
        return sys._getframe(2)
    except ValueError:
        return None


def _package(frame: FrameType) -> str:
    """Package of the code that a frame runs, or its module outside of a package."""
    return str(frame.f_globals.get("__name__", "")).partition(".")[0]


def _values(model: Any, prefix: str, without: Container[int]) -> Iterator[tuple[str, Any]]:
    """Described values in a value, itself first, each with the prefix of its keys."""
    if id(model) in without:
        return
    yield prefix, model
    for slot in slots(type(model)):
        value = getattr(model, slot.name)
        if slot.name_of(value):
            continue
        if is_described(value):
            yield from _values(value, slot.below(prefix), without)
        elif isinstance(value, tuple):
            for index, item in enumerate(value, start=1):
                if is_described(item):
                    yield from _values(item, f"{slot.path(prefix)}[{index}].", without)
