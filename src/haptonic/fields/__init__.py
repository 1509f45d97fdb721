"""Fields declared once, with title, unit, bounds, usual range, help: for checks, files and labels."""

from haptonic.fields.described import Section, described, remade
from haptonic.fields.entries import Entries
from haptonic.fields.keys import Key, leaves, table
from haptonic.fields.numbers import numbers, with_numbers
from haptonic.fields.placing import INLINE, TOP, Named, Placed
from haptonic.fields.quantity import FROM_FILE, LARGEST, SMALLEST, Name, Quantity, number_of, problem, size

__all__ = [
    "FROM_FILE",
    "INLINE",
    "LARGEST",
    "SMALLEST",
    "TOP",
    "Entries",
    "Key",
    "Name",
    "Named",
    "Placed",
    "Quantity",
    "Section",
    "described",
    "leaves",
    "number_of",
    "numbers",
    "problem",
    "remade",
    "size",
    "table",
    "with_numbers",
]
