"""Marks in the annotation of a field: the place of its keys, values given by name, and other words."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from pydantic import GetCoreSchemaHandler
from pydantic_core import core_schema

from haptonic.fields.quantity import collected


@dataclass(frozen=True)
class Placed:
    """Place of the keys of a described value that has no table of its own.

    inline : its keys are in the table that contains it
    top : its keys are at the top of the file
    """

    inline: bool = False
    top: bool = False


INLINE, TOP = Placed(inline=True), Placed(top=True)


class Synonyms:
    """Other words of a choice, each with the word that it means: ``Synonyms(hexagonal="triangular")``."""

    def __init__(self, **words: str) -> None:
        self.words = words

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> core_schema.CoreSchema:
        return core_schema.no_info_before_validator_function(self._read, handler(source))

    def _read(self, value: object) -> object:
        return self.words.get(value, value) if isinstance(value, str) else value


@dataclass(frozen=True)
class Named:
    """A value that a file gives by a table or by a name, such as that of a built-in material.

    find : returns the value of a name; raises an error with five parts
    name_of : returns the name of a value; None without a name
    known : returns all names for lists; `find` may accept others, such as capitals
    tables : classes of the tables that a file may give, the usual one first
    others : further classes, for values from Python and from names
    """

    find: Callable[[str], Any]
    name_of: Callable[[Any], str | None]
    known: Callable[[], Iterable[str]]
    tables: tuple[type, ...]
    others: tuple[type, ...] = ()

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> core_schema.CoreSchema:
        named = core_schema.no_info_after_validator_function(self._found, core_schema.str_schema())
        # a tag in brackets cannot be taken for a key in the path of an error
        choices: dict[Hashable, core_schema.CoreSchema] = {"<name>": named}
        for kind in self.tables:
            choices[self._tag_of(kind)] = handler.generate_schema(kind)
        if self.others:
            choices["<made>"] = core_schema.is_instance_schema(self.others)
        return core_schema.tagged_union_schema(choices, self._tag)

    def _found(self, name: str) -> Any:
        with collected():
            return self.find(name)

    def _tag(self, value: object) -> str | None:
        if isinstance(value, str):
            return "<name>"
        if isinstance(value, self.others):
            return "<made>"
        if isinstance(value, Mapping):
            given = {name.lower() for name in value if isinstance(name, str)}
            return self._tag_of(max(self.tables, key=lambda kind: len(names_of(kind) & given)))
        return next((self._tag_of(kind) for kind in self.tables if isinstance(value, kind)), None)

    @staticmethod
    def _tag_of(kind: type) -> str:
        return f"<{kind.__name__}>"


def names_of(kind: Any) -> set[str]:
    """Names of the fields of a described class, and other words for them."""
    return {*kind.__pydantic_fields__, *getattr(kind, "aliases", ())}
