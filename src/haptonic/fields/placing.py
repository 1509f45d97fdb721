"""Marks in the annotation of a field: where the keys of its value stand in a file, and what else may."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from pydantic import GetCoreSchemaHandler
from pydantic_core import core_schema

from haptonic.fields.quantity import collected


@dataclass(frozen=True)
class Placed:
    """Of a described value whose keys stand in no table of its own.

    inline : its keys stand among those of the table that holds it
    top : they stand at the top of the file, whatever holds the value
    """

    inline: bool = False
    top: bool = False


INLINE, TOP = Placed(inline=True), Placed(top=True)


@dataclass(frozen=True)
class Named:
    """Of a value that a file gives by a table or by a name, such as that of a built-in one.

    find : the value of a name; raises an error with five parts
    name_of : the name of a value; None if it has none
    known : all of these names, as they are told; `find` may take others, such as capitals
    table : the class that a table is read as; None where a file gives names only
    others : further classes, which only Python and names can give
    """

    find: Callable[[str], Any]
    name_of: Callable[[Any], str | None]
    known: Callable[[], Iterable[str]]
    table: type | None
    others: tuple[type, ...] = ()

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> core_schema.CoreSchema:
        named = core_schema.no_info_after_validator_function(self._found, core_schema.str_schema())
        # a tag in brackets cannot be taken for a key in the path of an error
        choices: dict[Hashable, core_schema.CoreSchema] = {"<name>": named}
        if self.table:
            choices["<table>"] = handler.generate_schema(self.table)
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
        return "<table>" if self.table and isinstance(value, Mapping | self.table) else None
