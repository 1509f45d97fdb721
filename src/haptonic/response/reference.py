"""Reference of a response: the quantity that it is divided by, with its unit."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Reference:
    """A drive. name : as in its source, including commas; unit : of its amplitude, such as V.

    Both are empty for a response that is not divided by anything.
    """

    name: str = ""
    unit: str = ""

    @classmethod
    def parse(cls, text: str) -> Reference:
        """Parse "A1, V": a unit never contains a comma, so the last comma ends the name.

        A text without a comma, or that ends with one, is a name without a unit.
        """
        name, comma, unit = text.rpartition(",")
        return cls(name, unit.strip()) if comma else cls(text)

    def __bool__(self) -> bool:
        return self != Reference()

    def __str__(self) -> str:
        """Text that `parse` reads."""
        if self.unit:
            return f"{self.name}, {self.unit}"
        return f"{self.name}," if "," in self.name else self.name
