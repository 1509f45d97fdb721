"""Options of analyses, declared once for the command, its help and Python.

Options that several analyses share are here too.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import MISSING, dataclass, field, fields
from os import PathLike, fspath
from pathlib import Path
from typing import Any, Literal

from haptonic.errors import StudyError
from haptonic.fields import Quantity
from haptonic.units import format_quantity, to_si


@dataclass(frozen=True)
class Option:
    """Declaration of an option, besides its name, type and default.

    quantity : unit and bounds of a number, which may be given as a text such as "58.8 kHz"
    read : function that reads a text or the path of a file
    metavar : name of the value in a help; flag : name on the command line
    place : "option", or an argument of the command line before or behind the study
    is_path : True if `read` takes the path of a file; options of type Path need no mark
    topic : heading under which a help lists it and a page asks for it; empty for one that is rarely needed
    """

    help: str
    quantity: Quantity | None = None
    read: Callable[[str], Any] | None = None
    metavar: str | None = None
    flag: str = ""
    place: Literal["option", "before", "behind"] = "option"
    is_path: bool = False
    topic: str = ""

    @property
    def unit(self) -> str:
        """SI unit; empty for anything but a quantity."""
        return self.quantity.unit if self.quantity else ""

    @property
    def is_text(self) -> bool:
        """True if a command reads the value from a text, with a unit or by `read`."""
        return bool(self.unit or self.read)

    def value(self, given: Any) -> Any:
        """Value for the analysis: a text is converted by the unit or by `read`, a path by `read`."""
        if self.unit and isinstance(given, str):
            return to_si(given, self.unit, self.flag)
        return self.read(fspath(given)) if self.read and isinstance(given, str | PathLike) else given

    def check(self, value: Any) -> None:
        """Raise StudyError if a number is not within its bounds."""
        if self.quantity is None or value is None or self.quantity.holds(value):
            return
        raise StudyError.out_of_range(
            argument=self.flag,
            given=format_quantity(value, self.unit),
            allowed=self.quantity.allowed,
            cause="the value is out of bounds",
            next_step=f"choose a value that is {self.quantity.limits}, or leave it out",
        )


def option(default: Any = MISSING, help: str = "", **more: Any) -> Any:
    """Declare a field of an options class; see `Option`."""
    if default is MISSING:
        return field(metadata={"option": Option(help, **more)})
    return field(default=default, metadata={"option": Option(help, **more)})


COUNT = Quantity("", at_least=0)  # of a whole number
DURATION = Quantity("s", above=0.0)
CONTENT = "Facts that the file may lack"  # topic of options that describe the content of a file
POSITION = "Position of the plate"
MODEL = "Comparison with a model"


@dataclass(frozen=True)
class NoOptions:
    """Options of an analysis that has none."""


@dataclass(frozen=True, kw_only=True)
class PageOption:
    """Option of analyses whose result has an interactive view."""

    html: bool = option(False, "Also one interactive HTML page.")


def option_of(item: Any) -> Option | None:
    """Declaration of a field of an options class; None for a field that only Python can give."""
    declaration: Option | None = item.metadata.get("option")
    if declaration is None or declaration.flag:
        return declaration
    return Option(**{**vars(declaration), "flag": f"--{item.name.replace('_', '-')}"})


def path_of(options: Any) -> Path | None:
    """Path of the analysed file or folder, None without one; several paths are joined to one name."""
    placed = [
        item.name
        for item in fields(options)
        if (declaration := option_of(item)) and declaration.place == "before"
    ]
    paths = [Path(getattr(options, name)) for name in placed]
    if len(paths) < 2:
        return next(iter(paths), None)
    return Path("-".join(path.absolute().stem for path in paths) + paths[0].suffix)


@dataclass(frozen=True, kw_only=True)
class Seeded:
    """Option of analyses that draw random numbers."""

    seed: int = option(0, "Seed of all random numbers.", metavar="N", quantity=COUNT)


@dataclass(frozen=True, kw_only=True)
class UnitsOfFile:
    """Option of analyses that read files without units."""

    frequency_unit: str | None = option(
        None, 'Unit of frequencies in files that give none, such as "kHz".', metavar="UNIT", topic=CONTENT
    )
