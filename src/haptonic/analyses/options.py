"""What may be chosen of an analysis, declared once: for the command, its help, Python and whatever asks.

Also options that several analyses have.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import MISSING, dataclass, field, fields
from os import PathLike, fspath
from pathlib import Path
from typing import Any, Literal

from haptonic.units import to_si


@dataclass(frozen=True)
class Option:
    """What is known of something that may be chosen, besides its name, type and default.

    unit : SI unit of a quantity, which may be given as a text such as "58.8 kHz"
    read : what becomes of a text otherwise
    metavar : stands for the value in a help; flag : what a command line calls it
    place : whether a command line takes it by its place, before the study or behind it
    """

    help: str
    unit: str = ""
    read: Callable[[str], Any] | None = None
    metavar: str | None = None
    flag: str = ""
    place: Literal["option", "before", "behind"] = "option"
    least: int | None = None

    def value(self, given: Any) -> Any:
        """What was given, read if it is a text, or the path of a file that is read."""
        if self.unit and isinstance(given, str):
            return to_si(given, self.unit, self.flag)
        return self.read(fspath(given)) if self.read and isinstance(given, str | PathLike) else given


def option(default: Any = MISSING, help: str = "", **more: Any) -> Any:
    """A field of an options class; see `Option`."""
    if default is MISSING:
        return field(metadata={"option": Option(help, **more)})
    return field(default=default, metadata={"option": Option(help, **more)})


@dataclass(frozen=True)
class NoOptions:
    """Nothing may be chosen."""


def option_of(one: Any) -> Option | None:
    """What is declared of a field of an options class; None for one that only Python can give."""
    found: Option | None = one.metadata.get("option")
    if found is None or found.flag:
        return found
    return Option(**{**vars(found), "flag": f"--{one.name.replace('_', '-')}"})


def path_of(options: Any) -> Path | None:
    """The file or folder that is analysed, if the options name one; several are one name after the other."""
    placed = [one.name for one in fields(options) if (found := option_of(one)) and found.place == "before"]
    paths = [Path(getattr(options, name)) for name in placed]
    if len(paths) < 2:
        return next(iter(paths), None)
    return Path("-".join(path.absolute().stem for path in paths) + paths[0].suffix)


@dataclass(frozen=True, kw_only=True)
class Seeded:
    """Of what draws by chance."""

    seed: int = option(0, "Seed of all random numbers.", metavar="N", least=0)


@dataclass(frozen=True, kw_only=True)
class UnitsOfFile:
    """Of what reads files that may not say their units."""

    frequency_unit: str | None = option(
        None, 'Unit of frequencies in files that give none, such as "kHz".', metavar="UNIT"
    )
