"""The texts of ``--help``, shown as they are written."""

from __future__ import annotations

from typing import Any

from rich.markup import escape
from typer.core import TyperArgument, TyperCommand, TyperGroup, TyperOption


class Worded(TyperGroup):
    """Commands whose help may name tables such as ``[trials]``, which typer would take for markup."""

    def __init__(self, **known: Any) -> None:
        super().__init__(**known)
        _escape(self)


def _escape(command: object) -> None:
    """Escape the help of a command, of its options and of the commands below it."""
    assert isinstance(command, TyperCommand | TyperGroup)
    command.help = _literal(command.help)
    for one in command.params:
        if isinstance(one, TyperArgument | TyperOption):
            one.help = _literal(one.help)
    for inner in command.commands.values() if isinstance(command, TyperGroup) else ():
        _escape(inner)


def _literal(text: str | None) -> str | None:
    return text and escape(text)
