"""Commands made of the tables of names when they are asked for; texts of ``--help`` as they are written."""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module
from typing import Any

import typer
from rich.markup import escape
from typer.core import TyperArgument, TyperCommand, TyperGroup, TyperOption

from haptonic import analyses
from haptonic.cli import commands

GROUPS = {"simulate": "Simulate a measurement whose truth is known."}  # first words of names of two words


class _Worded:
    """Flags stand without the word that they are of, which typer puts beside them: they take no value."""

    def get_params(self, ctx: Any) -> list[Any]:
        found: list[Any] = super().get_params(ctx)  # type: ignore[misc]  # of a command, below
        for one in found:
            if isinstance(one, TyperOption) and one.is_flag:
                one.metavar = ""
        return found


class Command(_Worded, TyperCommand):
    """One command."""


class Worded(_Worded, TyperGroup):
    """Commands whose help may name tables such as ``[trials]``, which typer would take for markup."""

    def __init__(self, **known: Any) -> None:
        super().__init__(**known)
        _escape(self)


class Listed(Worded):
    """Commands of which only name and help are known, until one of them is asked for.

    So a list of them, a completion or a word about a slip needs none of the libraries that compute.

    table : name -> help; before : words in front of these names
    """

    def __init__(self, table: Mapping[str, str] | None = None, before: str = "", **known: Any) -> None:
        table = analyses.NAMES | commands.NAMES if table is None else table
        first = {name.split()[0]: GROUPS.get(name.split()[0], text) for name, text in table.items()}
        alone = {name: TyperCommand(name, help=text) for name, text in first.items()}
        super().__init__(**known | {"commands": alone})
        self._table, self._before = table, before

    def list_commands(self, ctx: Any) -> list[str]:
        return list(self.commands)

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        name, found, rest = super().resolve_command(ctx, args)
        return name, found and self._made(name or ""), rest

    def _made(self, name: str) -> TyperCommand | TyperGroup:
        if name in self._table:
            return made(self._before + name)
        inner = {one.split()[1]: text for one, text in self._table.items() if one.split()[0] == name}
        return Listed(
            inner, f"{name} ", name=name, help=GROUPS[name], no_args_is_help=True, rich_markup_mode="rich"
        )


def made(name: str) -> TyperCommand:
    """The command of an analysis, or of a module of `haptonic.cli.commands`."""
    alone = typer.Typer(add_completion=False, pretty_exceptions_enable=False)
    if name in analyses.NAMES:
        run = import_module("haptonic.cli.running").command(analyses.named(name))
    else:
        run = import_module(f"haptonic.cli.commands.{name}").run
    text = (analyses.NAMES | commands.NAMES)[name]
    alone.command(name.split()[-1], cls=Command, help=text)(run)
    found = typer.main.get_command(alone)
    assert isinstance(found, TyperCommand)
    _escape(found)
    return found


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
