"""Tables of the study file with keys of the user: letters of a map, names of regions."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, TypeVar, get_args

from pydantic import GetCoreSchemaHandler, ValidatorFunctionWrapHandler
from pydantic_core import core_schema

from haptonic.fields.expressions import ExpressedNumber

V = TypeVar("V")


class Entries(Mapping[str, V]):
    """An immutable mapping that keeps the given order; it can be compared, hashed and pickled."""

    __slots__ = ("_pairs",)

    def __init__(self, pairs: Mapping[str, V] | Iterable[tuple[str, V]] = ()) -> None:
        self._pairs = dict(pairs)

    def __getitem__(self, name: str) -> V:
        return self._pairs[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._pairs)

    def __len__(self) -> int:
        return len(self._pairs)

    def __hash__(self) -> int:
        return hash(frozenset(self._pairs.items()))

    def __repr__(self) -> str:
        return f"Entries({self._pairs!r})"

    def __reduce__(self) -> tuple[type[Entries[V]], tuple[dict[str, V]]]:
        return Entries, (self._pairs,)

    @classmethod
    def __get_pydantic_core_schema__(
        cls, source: Any, handler: GetCoreSchemaHandler
    ) -> core_schema.CoreSchema:
        """Schema of a mapping from texts to the type in ``Entries[...]``."""
        (value,) = get_args(source)
        schema = handler.generate_schema(value)
        if value is float:  # pydantic would make a plain float of it
            schema = core_schema.no_info_wrap_validator_function(_with_expression, schema)
        return core_schema.no_info_after_validator_function(
            cls,
            core_schema.dict_schema(core_schema.str_schema(), schema),
            serialization=core_schema.plain_serializer_function_ser_schema(dict),
        )


def _with_expression(value: object, handler: ValidatorFunctionWrapHandler) -> object:
    """A number that keeps its expression."""
    return value if isinstance(value, ExpressedNumber) else handler(value)
