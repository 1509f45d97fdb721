"""Every key of the study file as a flat table, read from the schema and from nothing else."""

from __future__ import annotations

import re
from collections.abc import Container, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cache
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, TypeVar, Union, get_args, get_origin

import annotated_types
from pydantic.fields import FieldInfo

from haptonic.fields.entries import Entries
from haptonic.fields.placing import Named, Placed
from haptonic.fields.quantity import Quantity
from haptonic.units import format_quantity

T = TypeVar("T")


@dataclass(frozen=True)
class Key:
    """One key of the study file.

    path : dotted, such as ``cell.pillar.diameter``; ``sweep[].from`` for a key of every ``[[sweep]]``
    kind : "quantity", "number", "integer", "boolean", "text", "choice", "table" or "tables"; "quantities" for
        a list of them; "entries" for a table whose keys the user chooses
    unit : SI unit, of each where there are several; empty without one
    default : as it would be written; None for a key that has to be given, "" for one that may be absent
    bounds, typical : in words; empty without any
    choices : the allowed words of a choice; named : of a value that a name can stand for, such as a material
    quantity : the declaration itself, for a quantity or number; the first one's of a list
    count : how many there are in a list
    numbers : paths of the study's numbers that a text may name; see `haptonic.fields.of_number`
    example : a text that may be given, where one is declared; of several quantities, as a file has the list
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
    named: Named | None = None
    quantity: Quantity | None = None
    count: int = 1
    numbers: tuple[str, ...] = ()
    example: str = ""

    @property
    def required(self) -> bool:
        return self.default is None

    @property
    def default_text(self) -> str:
        """The default as a file would give it, without quotes; empty for what is absent by default."""
        return (
            format_quantity(float(self.default), self.unit)
            if self.default and self.unit
            else self.default or ""
        )

    @property
    def known_names(self) -> tuple[str, ...]:
        """The words or names that are known here."""
        return self.choices or (tuple(self.named.known()) if self.named else ())

    @property
    def label(self) -> str:
        """For an axis or a column: ``Pitch (m)``."""
        return f"{self.title} ({self.unit})" if self.unit else self.title


@cache
def table(kind: type, prefix: str = "") -> dict[str, Key]:
    """Every key of a described value and of the tables in it, by path and in the order of declaration; those
    at the top of a file before the table whose value they belong to."""
    keys: dict[str, Key] = {}
    for slot in slots(kind):
        path = slot.path(prefix)
        key = _key(path, slot.field)
        if slot.name == "parameter" and (known := getattr(kind, "known", None)):
            key = replace(key, numbers=tuple(known()))
        own = {} if slot.placed.inline else {path: key}
        for below in slot.kinds:
            own |= table(below, f"{path}[]." if key.kind == "tables" else slot.below(prefix))
        outside = {name: one for name, one in own.items() if prefix and not name.startswith(prefix)}
        keys |= {name: one for name, one in own.items() if name not in outside}
        keys = outside | keys
    return keys


@dataclass(frozen=True)
class Slot:
    """A field of a described value.

    name : of the attribute; key : in a file
    quantities : the declarations of its numbers, several for a list
    kinds : the described values that it can hold
    """

    name: str
    key: str
    field: FieldInfo
    placed: Placed
    named: Named | None
    quantities: tuple[Quantity, ...]
    kinds: tuple[type, ...]

    def path(self, prefix: str) -> str:
        """Of the field in a file, below a table of that path with a dot after it."""
        if self.placed.inline:
            return prefix.removesuffix(".")
        return self.key if self.placed.top else f"{prefix}{self.key}"

    def below(self, prefix: str) -> str:
        """What stands before the keys of the value in the field."""
        return prefix if self.placed.inline else f"{self.path(prefix)}."

    def name_of(self, value: object) -> str | None:
        """The name that stands for the field's value in a file, if there is one."""
        return self.named.name_of(value) if self.named and value is not None else None

    def declared(self, model: Any, value: object) -> Quantity | None:
        """The declaration of a number that is the field's value; another key of the table may decide it."""
        declared = None if isinstance(value, str) else next(iter(self.quantities), None)
        if declared is None and isinstance(value, float) and hasattr(model, "unit"):
            declared = Quantity(model.unit)
        return declared


def slots(kind: Any) -> tuple[Slot, ...]:
    """The fields of a described class in the order of declaration."""
    return _slots(kind)


@cache
def _slots(kind: type) -> tuple[Slot, ...]:
    made = []
    for name, field in fields_of(kind).items():
        placed = next((one for one in field.metadata if isinstance(one, Placed)), Placed())
        named = _named(field)
        kinds = tuple(_kinds(named.table if named else field.annotation))
        made.append(
            Slot(
                name=name,
                key=field.alias or name,
                field=field,
                placed=placed,
                named=named,
                quantities=quantities_of(field),
                kinds=kinds,
            )
        )
    return tuple(made)


def is_described(value: object) -> bool:
    """Whether a value, or a class, declares its fields."""
    return hasattr(value, "__pydantic_fields__")


def fields_of(kind: Any) -> dict[str, FieldInfo]:
    """The declared fields of a class, by name."""
    declared: dict[str, FieldInfo] = kind.__pydantic_fields__
    return declared


def leaves(
    model: Any, prefix: str = "", *, names: bool = True, without: Container[int] = frozenset()
) -> Iterator[tuple[str, Any, Quantity | None]]:
    """(path, value, declaration) of every key that has a value, tables inside tables included.

    Parameters
    ----------
    names : whether a value that a file may give by its name is that name, not the numbers behind it
    without : identities (`id`) of described values that are left out
    """
    for slot in slots(type(model)):
        path, value = slot.path(prefix), getattr(model, slot.name)
        if id(value) in without and is_described(value):
            continue
        if names and (name := slot.name_of(value)):
            yield path, name, None
        elif is_described(value):
            yield from leaves(value, slot.below(prefix), names=names, without=without)
        elif isinstance(value, tuple):
            for index, item in enumerate(value, start=1):
                if is_described(item):
                    if id(item) not in without:
                        yield from leaves(item, f"{path}[{index}].", names=names, without=without)
                else:
                    yield f"{path}[{index}]", item, slot.quantities[index - 1]
        elif isinstance(value, Entries):
            for entry, item in value.items():
                declared = None if isinstance(item, str) else unit_of(model, slot.field, entry)
                yield f"{path}.{entry}", item, declared
        elif value is not None:
            yield path, value, slot.declared(model, value)


def pattern_of(path: str) -> str:
    """The path of the key that stands for a path: tables of one name count in it no more."""
    return re.sub(r"\[\d+\]", "[]", path)


class ByPattern(Mapping[str, T]):
    """Values by the path of a key, ``sweep[].from``, found by those of its numbers, ``sweep[2].from``."""

    def __init__(self, by_key: Mapping[str, T]) -> None:
        self._by_key = dict(by_key)

    def __getitem__(self, path: str) -> T:
        return self._by_key[pattern_of(path)]

    def __iter__(self) -> Iterator[str]:
        return iter(self._by_key)

    def __len__(self) -> int:
        return len(self._by_key)


def key_of(path: str, keys: Mapping[str, Key]) -> Key | None:
    """The key that a path of `leaves`, or one that an error names, belongs to."""
    pattern = whole = pattern_of(path)
    while pattern and pattern not in keys:
        pattern = pattern.removesuffix("[]") if pattern.endswith("[]") else pattern.rpartition(".")[0]
    key = keys.get(pattern)
    return key if key and (pattern == whole or key.kind in {"quantities", "entries"}) else None


def unit_of(model: object, field: FieldInfo, entry: str) -> Quantity | None:
    """The declaration of one number of a table with keys of the user's own."""
    declared = quantity_of(field)
    return Quantity(model.units[entry]) if declared is None and hasattr(model, "units") else declared


def _key(path: str, field: FieldInfo) -> Key:
    quantity, kind, named = quantity_of(field), _kind(field), _named(field)
    count = len(quantities_of(field)) if kind == "quantities" else 1
    bounds, typical = (quantity.limits, quantity.usual) if quantity else (_plain_bounds(field), "")
    if count > 1:
        bounds, typical = f"{count} of them, {bounds}", ""
    return Key(
        path=path,
        title=field.title or path.rpartition(".")[2].replace("_", " ").capitalize(),
        kind=kind,
        unit=quantity.unit if quantity else "",
        default=_default(field, quantity),
        bounds=bounds,
        typical=typical,
        description=field.description or "",
        choices=_choices(field.annotation),
        named=named,
        quantity=quantity,
        count=count,
        example=next(iter(field.examples or ()), ""),
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
    named = _named(field)
    if any(_kinds(named.table if named else field.annotation)):
        return "table"
    plain = {get_args(part)[0] if get_origin(part) is Annotated else part for part in parts}
    if bool in plain:
        return "boolean"
    return "integer" if int in plain else "number" if float in plain else "text"


def _default(field: FieldInfo, quantity: Quantity | None) -> str | None:
    if field.is_required():
        return None
    value = field.get_default(call_default_factory=True)
    if value is None or is_described(value) or isinstance(value, tuple | Entries):
        return ""
    return str(value).lower() if isinstance(value, bool) else str(value)


def quantity_of(field: FieldInfo) -> Quantity | None:
    """The declaration of a field, also of one that may be absent; of a list, the first one's."""
    return next(iter(quantities_of(field)), None)


def quantities_of(field: FieldInfo) -> tuple[Quantity, ...]:
    """The declarations of a field: several for a list, each of whose numbers has its own."""
    return tuple(item for item in metadata_of(field) if isinstance(item, Quantity))


def _named(field: FieldInfo) -> Named | None:
    """The mark of a field whose value a name can stand for, also where the field may be absent."""
    return next((item for item in metadata_of(field) if isinstance(item, Named)), None)


def metadata_of(field: FieldInfo) -> tuple[Any, ...]:
    """The marks of a field and of what its annotation wraps: quantities, bounds, lengths."""
    return (*field.metadata, *_metadata(field.annotation))


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
    literals = [part for part in _parts(annotation) if get_origin(part) is Literal]
    return tuple(word for part in literals for word in get_args(part))


def _plain_bounds(field: FieldInfo) -> str:
    found = metadata_of(field)
    lowest = [f"at least {item.ge}" for item in found if isinstance(item, annotated_types.Ge)]
    highest = [f"at most {item.le}" for item in found if isinstance(item, annotated_types.Le)]
    counted = "of them" if _kind(field) == "tables" else "characters"
    longest = [
        f"at most {item.max_length} {counted}" for item in found if isinstance(item, annotated_types.MaxLen)
    ]
    return " and ".join([*lowest, *highest, *longest])
