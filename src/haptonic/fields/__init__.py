"""Declared fields: title, unit, bounds, usual range and help of a value, for checks, files and labels."""

from haptonic.fields.aliases import Aliases, absent, meant
from haptonic.fields.described import described, extended, needed, remade, setting, unchecked
from haptonic.fields.entries import Entries
from haptonic.fields.expressions import PARAMETERS, ExpressedNumber, Scope
from haptonic.fields.keys import ByPattern, Key, leaves, table
from haptonic.fields.numbers import numbers, unknown_number, with_known_table, with_numbers
from haptonic.fields.of_number import NumberRange, OfNumber, ascending, once
from haptonic.fields.placing import INLINE, TOP, Named, Placed, Synonyms
from haptonic.fields.quantity import (
    CARRIER,
    FASTEST,
    FREQUENCY,
    FROM_FILE,
    LARGEST,
    SMALLEST,
    AnyUnit,
    Frequency,
    Length,
    Name,
    Quantity,
    handed_on,
    number_of,
    number_of_any_unit,
    problem,
    size,
)
from haptonic.fields.reading import read
from haptonic.fields.unusual import caller, unusual_beside, unusual_values, warn_caller

__all__ = [
    "CARRIER",
    "FASTEST",
    "FREQUENCY",
    "FROM_FILE",
    "INLINE",
    "LARGEST",
    "PARAMETERS",
    "SMALLEST",
    "TOP",
    "Aliases",
    "AnyUnit",
    "ByPattern",
    "Entries",
    "ExpressedNumber",
    "Frequency",
    "Key",
    "Length",
    "Name",
    "Named",
    "NumberRange",
    "OfNumber",
    "Placed",
    "Quantity",
    "Scope",
    "Synonyms",
    "absent",
    "ascending",
    "caller",
    "described",
    "extended",
    "handed_on",
    "leaves",
    "meant",
    "needed",
    "number_of",
    "number_of_any_unit",
    "numbers",
    "once",
    "problem",
    "read",
    "remade",
    "setting",
    "size",
    "table",
    "unchecked",
    "unknown_number",
    "unusual_beside",
    "unusual_values",
    "warn_caller",
    "with_known_table",
    "with_numbers",
]
