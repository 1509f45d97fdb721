"""Every key of the study file as a flat table, read from the schema and from nothing else."""

from __future__ import annotations

import re
from collections.abc import Container, Hashable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, cast, get_args, get_origin

import annotated_types
from pydantic.fields import FieldInfo

from haptonic.fields.entries import Entries
from haptonic.fields.quantity import Quantity


@dataclass(frozen=True)
class Key:
    """One key of the study file.

    path : dotted, such as ``cell.pillar.diameter``; ``sweep[].from`` for a key of every ``[[sweep]]``
    kind : "quantity", "number", "integer", "text", "choice", "table" or "tables"; "quantities" for a list of
        them; "entries" for a table whose keys the user chooses
    unit : SI unit, of each where there are several; empty without one
    default : as it would be written; None for a key that has to be given, "" for one that may be absent
    bounds, typical : in words; empty without any
    choices : the allowed words of a choice
    quantity : the declaration itself, for a quantity or number; the first one's of a list
    count : how many there are in a list
    """

    path: str
    title: str
    kind: str
    unit: str
    default: str | None
    bounds: str
    typical: str
    description: str
    choices: tuple[str, ...] = ()
    quantity: Quantity | None = None
    count: int = 1

    @property
    def required(self) -> bool:
        return self.default is None

    @property
    def label(self) -> str:
        """For an axis or a column: ``Pitch (m)``."""
        return f"{self.title} ({self.unit})" if self.unit else self.title


@cache
def table(kind: type, prefix: str = "") -> dict[str, Key]:
    """Every key of a described value and of the tables in it, by path and in the order of declaration."""
    keys: dict[str, Key] = {}
    for name, field in fields_of(kind).items():
        path = f"{prefix}{field.alias or name}"
        key = _key(path, field)
        keys[path] = key
        for below in _kinds(field.annotation):
            keys |= table(below, f"{path}[]." if key.kind == "tables" else f"{path}.")
    return keys


def is_described(value: object) -> bool:
    """Whether a value, or a class, declares its fields."""
    return hasattr(value, "__pydantic_fields__")


def fields_of(kind: Any) -> dict[str, FieldInfo]:
    """The declared fields of a class, by name."""
    declared: dict[str, FieldInfo] = kind.__pydantic_fields__
    return declared


def leaves(
    model: Any, prefix: str = "", only: Container[str] | None = None
) -> Iterator[tuple[str, Any, Quantity | None]]:
    """(path, value, declaration) of every key that has a value, tables inside tables included.

    ``only`` names the keys of the outermost table that are looked at.
    """
    for name, (field, each) in _declared(cast("Hashable", type(model))).items():
        key = field.alias or name
        if only is not None and key not in only:
            continue
        path, value = f"{prefix}{key}", getattr(model, name)
        if is_described(value):
            yield from leaves(value, f"{path}.")
        elif isinstance(value, tuple):
            for index, item in enumerate(value, start=1):
                if is_described(item):
                    yield from leaves(item, f"{path}[{index}].")
                else:
                    yield f"{path}[{index}]", item, each[index - 1]
        elif isinstance(value, Entries):
            for entry, item in value.items():
                yield f"{path}.{entry}", item, None if isinstance(item, str) else unit_of(model, field, entry)
        elif value is not None:
            declared = None if isinstance(value, str) else next(iter(each), None)
            if declared is None and isinstance(value, float) and hasattr(model, "unit"):
                declared = Quantity(model.unit)  # it depends on another key of the table
            yield path, value, declared


@cache
def _declared(kind: type) -> dict[str, tuple[FieldInfo, tuple[Quantity, ...]]]:
    """Each field of a described value with the declarations of its numbers."""
    return {name: (field, quantities_of(field)) for name, field in fields_of(kind).items()}


def key_of(path: str, keys: Mapping[str, Key]) -> Key | None:
    """The key that a path of `leaves`, or one that an error names, belongs to."""
    pattern = whole = re.sub(r"\[\d+\]", "[]", path)
    while pattern and pattern not in keys:
        pattern = pattern.removesuffix("[]") if pattern.endswith("[]") else pattern.rpartition(".")[0]
    key = keys.get(pattern)
    return key if key and (pattern == whole or key.kind in {"quantities", "entries"}) else None


def unit_of(model: object, field: FieldInfo, entry: str) -> Quantity | None:
    """The declaration of one number of a table with keys of the user's own."""
    declared = quantity_of(field)
    return Quantity(model.units[entry]) if declared is None and hasattr(model, "units") else declared


def _key(path: str, field: FieldInfo) -> Key:
    quantity, kind = quantity_of(field), _kind(field)
    count = len(quantities_of(field)) if kind == "quantities" else 1
    bounds, typical = (quantity.limits, quantity.usual) if quantity else (_plain_bounds(field), "")
    if count > 1:
        bounds, typical = f"{count} of them, {bounds}", ""
    return Key(
        path=path,
        title=field.title or path,
        kind=kind,
        unit=quantity.unit if quantity else "",
        default=_default(field, quantity),
        bounds=bounds,
        typical=typical,
        description=field.description or "",
        choices=_choices(field.annotation),
        quantity=quantity,
        count=count,
    )


def _kind(field: FieldInfo) -> str:
    quantity, parts = quantity_of(field), _parts(field.annotation)
    if any(get_origin(part) is Entries for part in parts):
        return "entries"
    if any(get_origin(part) is tuple for part in parts):
        return "quantities" if quantity else "tables"
    if quantity:
        return "quantity" if quantity.unit else "number"
    if _choices(field.annotation):
        return "choice"
    if any(_kinds(field.annotation)):
        return "table"
    plain = {get_args(part)[0] if get_origin(part) is Annotated else part for part in parts}
    return "integer" if int in plain else "number" if float in plain else "text"


def _default(field: FieldInfo, quantity: Quantity | None) -> str | None:
    if field.is_required():
        return None
    value = field.get_default(call_default_factory=True)
    if value is None or is_described(value) or isinstance(value, tuple | Entries):
        return ""
    return str(value)


def quantity_of(field: FieldInfo) -> Quantity | None:
    """The declaration of a field, also of one that may be absent; of a list, the first one's."""
    return next(iter(quantities_of(field)), None)


def quantities_of(field: FieldInfo) -> tuple[Quantity, ...]:
    """The declarations of a field: several for a list, each of whose numbers has its own."""
    found = [*field.metadata, *_metadata(field.annotation)]
    return tuple(item for item in found if isinstance(item, Quantity))


def _metadata(annotation: Any) -> Iterator[Any]:
    for part in _parts(annotation):
        if get_origin(part) is Annotated:
            for item in get_args(part)[1:]:
                yield from item.metadata if isinstance(item, FieldInfo) else (item,)
        elif get_origin(part) in (tuple, Entries):
            for inner in get_args(part):
                yield from _metadata(inner)


def _parts(annotation: Any) -> tuple[Any, ...]:
    """The alternatives of a union without None; of anything else, itself."""
    if get_origin(annotation) in (Union, UnionType):
        return tuple(part for part in get_args(annotation) if part is not NoneType)
    return (annotation,)


def _kinds(annotation: Any) -> Iterator[type]:
    """The described values that an annotation can hold, however deep it wraps them."""
    if isinstance(annotation, type) and is_described(annotation):
        yield annotation
    elif get_origin(annotation) is not Literal:
        for part in get_args(annotation):
            yield from _kinds(part)


def _choices(annotation: Any) -> tuple[str, ...]:
    return tuple(get_args(annotation)) if get_origin(annotation) is Literal else ()


def _plain_bounds(field: FieldInfo) -> str:
    found = [*field.metadata, *_metadata(field.annotation)]
    lowest = [f"at least {item.ge}" for item in found if isinstance(item, annotated_types.Ge)]
    highest = [f"at most {item.le}" for item in found if isinstance(item, annotated_types.Le)]
    counted = "of them" if _kind(field) == "tables" else "characters"
    longest = [
        f"at most {item.max_length} {counted}" for item in found if isinstance(item, annotated_types.MaxLen)
    ]
    return " and ".join([*lowest, *highest, *longest])
