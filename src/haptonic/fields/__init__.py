"""Fields declared once, with title, unit, bounds, usual range, help: for checks, files and labels."""

from haptonic.fields.described import Section, described
from haptonic.fields.entries import Entries
from haptonic.fields.keys import Key, leaves, table
from haptonic.fields.quantity import FROM_FILE, LARGEST, SMALLEST, Name, Quantity, number_of, problem, size

__all__ = [
    "FROM_FILE",
    "LARGEST",
    "SMALLEST",
    "Entries",
    "Key",
    "Name",
    "Quantity",
    "Section",
    "described",
    "leaves",
    "number_of",
    "problem",
    "size",
    "table",
]
