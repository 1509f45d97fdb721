"""Flat table of all keys of the study file, read from the declarations."""

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
from haptonic.fields.expressions import ExpressedNumber
from haptonic.fields.placing import Named, Placed, Synonyms
from haptonic.fields.quantity import AnyUnit, Quantity
from haptonic.names import listed
from haptonic.units import format_quantity

T = TypeVar("T")


@dataclass(frozen=True)
class Key:
    """A key of the study file.

    path : dotted, such as ``cell.pillar.diameter``; ``sweep[].from`` for a key of every ``[[sweep]]``
    kind : "quantity", "number", "integer", "boolean", "text", "choice", "table" or "tables"; "quantities" for
        a list of quantities; "entries" for a table with keys of the user
    unit : SI unit, of each quantity of a list; empty without one
    default : as in a file; None for a required key, "" for one that may be absent
    bounds, typical : as texts; empty without any
    choices : allowed words of a choice; synonyms : other words that are read as one of them
    named : for a value that may be given by name, such as a material
    quantity : the declaration, for a quantity or number; that of the first number of a list
    count : length of a list
    numbers : paths of the study's numbers that a text may name; see `haptonic.fields.of_number`
    example : declared example, if any; for several quantities the whole list as in a file
    is_alternative : True for a required key of one kind of a table that has several, such as a material
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
    synonyms: tuple[str, ...] = ()
    named: Named | None = None
    quantity: Quantity | None = None
    count: int = 1
    numbers: tuple[str, ...] = ()
    example: str = ""
    is_alternative: bool = False

    @property
    def required(self) -> bool:
        return self.default is None

    @property
    def default_text(self) -> str:
        """The default as in a file, without quotes; empty for a key that is absent by default."""
        return (
            format_quantity(float(self.default), self.unit)
            if self.default and self.unit
            else self.default or ""
        )

    @property
    def known_names(self) -> tuple[str, ...]:
        """Allowed words of a choice, or known names."""
        return self.choices or (tuple(self.named.known()) if self.named else ())

    @property
    def label(self) -> str:
        """Label of an axis or a column: ``Pitch (m)``."""
        return f"{self.title} ({self.unit})" if self.unit else self.title


@cache
def table(kind: type, prefix: str = "") -> dict[str, Key]:
    """All keys of a described value and of the tables in it, by path and in the order of declaration; keys at
    the top of a file come before the table of their value."""
    keys: dict[str, Key] = {}
    for slot in slots(kind):
        path = slot.path(prefix)
        key = _key(path, slot.field)
        if slot.name == "parameter" and (parameters := getattr(kind, "known", None)):
            key = replace(key, numbers=tuple(parameters()))
        in_table = {} if slot.placed.inline else {path: key}
        start = f"{path}[]." if key.kind == "tables" else slot.below(prefix)
        inner = [table(below, start) for below in slot.kinds]
        for of_kind in inner:
            for at, each in of_kind.items():
                is_alternative = each.required and not all(at in other for other in inner)
                in_table[at] = replace(each, is_alternative=True) if is_alternative else each
        outside = {name: each for name, each in in_table.items() if prefix and not name.startswith(prefix)}
        keys |= {name: each for name, each in in_table.items() if name not in outside}
        keys = outside | keys
    return keys


@dataclass(frozen=True)
class Slot:
    """A field of a described value.

    name : of the attribute; key : its name in a file
    quantities : declarations of its numbers, several for a list
    kinds : described classes of its possible values
    """

    name: str
    key: str
    field: FieldInfo
    placed: Placed
    named: Named | None
    quantities: tuple[Quantity, ...]
    kinds: tuple[type, ...]

    def path(self, prefix: str) -> str:
        """Path of the field in a file; ``prefix`` is the path of its table with a dot."""
        if self.placed.inline:
            return prefix.removesuffix(".")
        return self.key if self.placed.top else f"{prefix}{self.key}"

    def below(self, prefix: str) -> str:
        """Prefix of the keys of the value in the field."""
        return prefix if self.placed.inline else f"{self.path(prefix)}."

    def name_of(self, value: object) -> str | None:
        """Name that a file gives in place of the field's value; None without one."""
        return self.named.name_of(value) if self.named and value is not None else None

    def declared(self, model: Any, value: object) -> Quantity | None:
        """Declaration of a number in the field; its unit may depend on another key of the table."""
        declared = None if isinstance(value, str) else next(iter(self.quantities), None)
        if declared is None and isinstance(value, float) and hasattr(model, "unit"):
            declared = Quantity(model.unit)
        return declared


def slots(kind: Any) -> tuple[Slot, ...]:
    """Fields of a described class in the order of declaration."""
    return _slots(kind)


@cache
def _slots(kind: type) -> tuple[Slot, ...]:
    slots_of_kind = []
    for name, field in fields_of(kind).items():
        placed = next((mark for mark in field.metadata if isinstance(mark, Placed)), Placed())
        named = _named(field)
        kinds = named.tables if named else tuple(_kinds(field.annotation))
        slots_of_kind.append(
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
    return tuple(slots_of_kind)


def is_described(value: object) -> bool:
    """True if a value, or a class, declares its fields."""
    return hasattr(value, "__pydantic_fields__")


def fields_of(kind: Any) -> dict[str, FieldInfo]:
    """Declared fields of a class, by name."""
    declared: dict[str, FieldInfo] = kind.__pydantic_fields__
    return declared


def leaves(
    model: Any, prefix: str = "", *, names: bool = True, without: Container[int] = frozenset()
) -> Iterator[tuple[str, Any, Quantity | None]]:
    """(path, value, declaration) of every key with a value, including keys of nested tables.

    Parameters
    ----------
    names : True to replace a value that has a name in a file by this name, False for its numbers
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
                declared = None if isinstance(item, str) else declared_entry(model, slot.field, entry, item)
                yield f"{path}.{entry}", item, declared
        elif value is not None:
            yield path, value, slot.declared(model, value)


def pattern_of(path: str) -> str:
    """Path with "[]" in place of the numbers of tables."""
    return re.sub(r"\[\d+\]", "[]", path)


class ByPattern(Mapping[str, T]):
    """Mapping by the pattern of a key, ``sweep[].from``; paths with numbers are found too."""

    def __init__(self, by_key: Mapping[str, T]) -> None:
        self._by_key = dict(by_key)

    def __getitem__(self, path: str) -> T:
        return self._by_key[pattern_of(path)]

    def __iter__(self) -> Iterator[str]:
        return iter(self._by_key)

    def __len__(self) -> int:
        return len(self._by_key)


def key_of(path: str, keys: Mapping[str, Key]) -> Key | None:
    """Key of a path from `leaves`, or of a path in an error."""
    pattern = whole = pattern_of(path)
    while pattern and pattern not in keys:
        pattern = pattern.removesuffix("[]") if pattern.endswith("[]") else pattern.rpartition(".")[0]
    key = keys.get(pattern)
    return key if key and (pattern == whole or key.kind in {"quantities", "entries"}) else None


def declared_entry(model: object, field: FieldInfo, entry: str, item: object) -> Quantity | None:
    """Declaration of a number in a table with keys of the user."""
    declared = quantity_of(field)
    if declared is None and any(isinstance(mark, AnyUnit) for mark in metadata_of(field)):
        return Quantity(item.unit) if isinstance(item, ExpressedNumber) else Quantity("")
    return Quantity(model.units[entry]) if declared is None and hasattr(model, "units") else declared


def _key(path: str, field: FieldInfo) -> Key:
    quantity, kind, named = quantity_of(field), _kind(field), _named(field)
    count = len(quantities_of(field)) if kind == "quantities" else 1
    bounds, typical = (quantity.limits, quantity.usual) if quantity else (_plain_bounds(field), "")
    if count > 1:
        bounds, typical = f"{count} values, {bounds}", ""
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
        synonyms=tuple(word for mark in field.metadata if isinstance(mark, Synonyms) for word in mark.words),
        named=named,
        quantity=quantity,
        count=count,
        example=next(iter(field.examples or ()), "") or _usual_list(field),
    )


def _usual_list(field: FieldInfo) -> str:
    """The default of a list of quantities, as in a file; empty without one."""
    declared, value = quantities_of(field), field.default
    if not declared or not isinstance(value, tuple) or len(value) != len(declared):
        return ""
    texts = [format_quantity(number, each.unit) for number, each in zip(value, declared, strict=True)]
    quote = '"' if declared[0].unit else ""
    return f"[{', '.join(f'{quote}{text}{quote}' for text in texts)}]"


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
    if named.tables if named else any(_kinds(field.annotation)):
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
    """Declaration of a field; of a list, that of the first number."""
    return next(iter(quantities_of(field)), None)


def quantities_of(field: FieldInfo) -> tuple[Quantity, ...]:
    """Declarations of a field: for a list one for each of its numbers."""
    return tuple(item for item in metadata_of(field) if isinstance(item, Quantity))


def _named(field: FieldInfo) -> Named | None:
    """Mark of a field whose value may be given by name."""
    return next((item for item in metadata_of(field) if isinstance(item, Named)), None)


def metadata_of(field: FieldInfo) -> tuple[Any, ...]:
    """Marks of a field and of its nested annotations: quantities, bounds, lengths."""
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
    """Alternatives of a union without None; otherwise the annotation itself."""
    if get_origin(annotation) in (Union, UnionType):
        return tuple(part for part in get_args(annotation) if part is not NoneType)
    return (annotation,)


def _kinds(annotation: Any) -> Iterator[type]:
    """Described classes in an annotation, at any depth."""
    if isinstance(annotation, type) and is_described(annotation):
        yield annotation
    elif get_origin(annotation) is not Literal:
        for part in get_args(annotation):
            yield from _kinds(part)


def _choices(annotation: Any) -> tuple[str, ...]:
    literals = [part for part in _parts(annotation) if get_origin(part) is Literal]
    return tuple(word for part in literals for word in get_args(part))


def _plain_bounds(field: FieldInfo) -> str:
    marks = metadata_of(field)
    lowest = [f"at least {item.ge}" for item in marks if isinstance(item, annotated_types.Ge)]
    highest = [f"at most {item.le}" for item in marks if isinstance(item, annotated_types.Le)]
    counted = "entries" if _kind(field) == "tables" else "characters"
    longest = [
        f"at most {item.max_length} {counted}" for item in marks if isinstance(item, annotated_types.MaxLen)
    ]
    return listed([*lowest, *highest, *longest])
