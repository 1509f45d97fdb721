"""Numbers of a described value by their paths in a study file: names, reading and changing.

``cell.pillar.diameter`` is a path; tables of one name count from 1, ``plate.actuator[1].bond.thickness``.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from types import MappingProxyType
from typing import Any, TypeVar

from haptonic.errors import HaptonicError, StudyError
from haptonic.fields.described import remade, unchecked
from haptonic.fields.entries import Entries
from haptonic.fields.keys import Slot, is_described, leaves, pattern_of, slots

T = TypeVar("T")


def numbers(value: object, prefix: str = "", *, names: bool = False) -> dict[str, float]:
    """Declared numbers of a value, in SI units, by path.

    Parameters
    ----------
    prefix : path of the value with a dot after it, ``cell.``; empty for a study
    names : see `haptonic.fields.keys.leaves`
    """
    return {path: number for path, number, declared in leaves(value, prefix, names=names) if declared}


def with_numbers(value: T, changes: Mapping[str, float], prefix: str = "", checked: bool = True) -> T:
    """A copy of the value with some of its `numbers` changed at the same time.

    Only the values that contain these numbers are made again; they are checked if ``checked``.

    Raises
    ------
    HaptonicError : a number out of its bounds, or contradicting numbers; of the class of the value's errors
    StudyError : an unknown name
    """
    left = dict(changes)
    result: T = _changed(value, left, prefix, remade if checked else unchecked)
    for name in left:
        raise unknown_number(name, numbers(value, prefix))
    return result


def unknown_number(
    name: object, known: Mapping[str, object], absent: Mapping[str, str] = MappingProxyType({}), at: str = ""
) -> StudyError:
    """Error for a name that is not one of the known numbers.

    Parameters
    ----------
    absent : names that exist elsewhere, with the reason why they are absent here
    at : key that gives the name; by default the name is an argument
    """
    numbered = with_known_table(str(name), known)
    usual = "no numeric parameter has this name"
    if numbered is not None or "[0]" in str(name):
        usual = "numbers in brackets count from 1, and this one does not exist"
    cause = absent.get(str(name), usual)
    slip, next_step = str(name) not in absent and "[0]" not in str(name), "choose a name of the list"
    if numbered is not None and numbered in known:
        slip, next_step = False, f'write "{numbered}"'
    listed = [path.replace("[]", "[1]") for path in known]
    return StudyError.unknown(at or "name of a number", name, listed, cause, slip=slip, next_step=next_step)


def with_known_table(name: str, known: Iterable[str]) -> str | None:
    """A name with the number of the nearest table of the known names in place of one that none of them has.

    None if one of them has it, or no table of this kind.
    """
    for bracket in re.finditer(r"\[(\d+)\]", name):
        start, rest = name[: bracket.start()], name[bracket.end() :]
        paths = (re.match(rf"{re.escape(start)}\[(\d+)\]", path) for path in known)
        existing = {int(path[1]) for path in paths if path}
        if existing and int(bracket[1]) not in existing:
            nearest = min(existing, key=lambda number: abs(number - int(bracket[1])))
            return f"{start}[{nearest}]{rest}"
    return None


def _changed(value: Any, changes: dict[str, float], prefix: str, make: Callable[..., Any]) -> Any:
    """The value with its numbers in ``changes``, which are removed from there."""
    fields = {}
    for slot in slots(type(value)):
        old = getattr(value, slot.name)
        new = _in_slot(slot, old, changes, prefix, make)
        if new is not old:
            fields[slot.name] = new
    if not fields:
        return value
    try:
        return make(value, **fields)
    except HaptonicError as error:
        raise _placed(error, prefix) from None


def _placed(error: HaptonicError, prefix: str) -> HaptonicError:
    """The error of a value at ``prefix``, ``cell.disc[2].``, in place of ``cell.disc`` or ``material``.

    A value that is made alone does not know the number of its table, nor its owner.
    """
    table_name = pattern_of(prefix).removesuffix(".").removesuffix("[]").rpartition(".")[2]
    before, _, key = error.argument.partition(f"{table_name}.")
    of_value = table_name and key and (not before or before.endswith("."))
    return error.changed(type(error), argument=f"{prefix}{key}") if of_value else error


def _in_slot(slot: Slot, old: Any, changes: dict[str, float], prefix: str, make: Callable[..., Any]) -> Any:
    if not changes:  # all are made, mostly in the cell at the beginning of a study
        return old
    path = slot.path(prefix)
    if is_described(old):
        return _changed(old, changes, slot.below(prefix), make)
    if isinstance(old, tuple):
        items = [(f"{path}[{index}]", item) for index, item in enumerate(old, start=1)]
        new = tuple(
            _changed(item, changes, f"{at}.", make) if is_described(item) else changes.pop(at, item)
            for at, item in items
        )
        return old if all(a is b for a, b in zip(new, old, strict=True)) else new
    if isinstance(old, Entries):
        entries = {name: changes.pop(f"{path}.{name}", item) for name, item in old.items()}
        return old if all(entries[name] is old[name] for name in old) else Entries(entries)
    return changes.pop(path, old)
