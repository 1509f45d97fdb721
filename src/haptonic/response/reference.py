"""What a response is divided by, or what a channel records."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Reference:
    """A drive. name : as its maker called it, commas and all; unit : of its amplitude, such as V

    Both are empty for a response that is divided by nothing.
    """

    name: str = ""
    unit: str = ""

    @classmethod
    def parse(cls, text: str) -> Reference:
        """From "A1, V", as files and people write it: no unit holds a comma, so the last one is the border.

        A text without a comma, or that ends with one, is a name without a unit.
        """
        name, comma, unit = text.rpartition(",")
        return cls(name, unit.strip()) if comma else cls(text)

    def __bool__(self) -> bool:
        return self != Reference()

    def __str__(self) -> str:
        """What `parse` takes apart again."""
        if self.unit:
            return f"{self.name}, {self.unit}"
        return f"{self.name}," if "," in self.name else self.name
