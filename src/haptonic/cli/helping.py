"""Commands built from the tables of names on demand, with the texts of ``--help`` printed as they are."""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module
from typing import Any

import typer
from rich.markup import escape
from typer.core import TyperArgument, TyperCommand, TyperGroup, TyperOption

from haptonic import analyses
from haptonic.cli import commands

GROUPS = {"simulate": "Simulate a measurement with known ground truth."}  # first word of names with two words
# first words of the commands, in the order of the help
PANELS = {
    "Start": ("new", "studio", "plan", "bands", "reproduce"),
    "Design": ("design", "sweep", "tolerance", "layers", "waveguide", "ribbon", "compare"),
    "Plate": ("plate", "feel", "export"),
    "Measurements": ("chirp", "scan", "verdict", "protocol", "friction", "simulate"),
    "Files and help": ("keys", "materials", "schema", "verify", "doctor"),
}


class _Worded:
    """Shows flags without a value name, which typer would print beside them."""

    def get_params(self, ctx: Any) -> list[Any]:
        parameters: list[Any] = super().get_params(ctx)  # type: ignore[misc]  # of a command, below
        for parameter in parameters:
            if isinstance(parameter, TyperOption) and parameter.is_flag:
                parameter.metavar = ""
        return parameters


class Command(_Worded, TyperCommand):
    """A command."""


class Worded(_Worded, TyperGroup):
    """Commands whose help may contain ``[trials]`` and other tables, which typer would read as markup."""

    def __init__(self, **settings: Any) -> None:
        super().__init__(**settings)
        _escape(self)


class Listed(Worded):
    """Commands of which only name and help are loaded until one of them is called.

    So the list of commands, completion and messages on misspelt names import no numerical library.

    table : name -> help; before : words in front of these names
    """

    def __init__(self, table: Mapping[str, str] | None = None, before: str = "", **settings: Any) -> None:
        table = analyses.NAMES | commands.NAMES if table is None else table
        first = {name.split()[0]: GROUPS.get(name.split()[0], text) for name, text in table.items()}
        panels = {name: panel for panel, inside in PANELS.items() for name in inside if name in first}
        alone = {
            name: TyperCommand(name, help=first[name], rich_help_panel=panels.get(name))
            for name in dict.fromkeys((*panels, *first))
        }
        super().__init__(**settings | {"commands": alone})
        self._table, self._before = table, before

    def list_commands(self, ctx: Any) -> list[str]:
        return list(self.commands)

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        if not self._before and args and args[0] in analyses.SYNONYMS:
            ctx.fail(f"No such command {args[0]!r}. Did you mean {analyses.SYNONYMS[args[0]]!r}?")
        name, command, rest = super().resolve_command(ctx, args)
        return name, command and self._build(name or ""), rest

    def _build(self, name: str) -> TyperCommand | TyperGroup:
        if name in self._table:
            return made(self._before + name)
        inner = {full.split()[1]: text for full, text in self._table.items() if full.split()[0] == name}
        return Listed(
            inner, f"{name} ", name=name, help=GROUPS[name], no_args_is_help=True, rich_markup_mode="rich"
        )


def made(name: str) -> TyperCommand:
    """Build the command of an analysis or of a module of `haptonic.cli.commands`."""
    alone = typer.Typer(add_completion=False, pretty_exceptions_enable=False)
    if name in analyses.NAMES:
        run = import_module("haptonic.cli.running").command(analyses.named(name))
    else:
        run = import_module(f"haptonic.cli.commands.{name}").run
    text = (analyses.NAMES | commands.NAMES)[name]
    alone.command(name.split()[-1], cls=Command, help=text)(run)
    built = typer.main.get_command(alone)
    assert isinstance(built, TyperCommand)
    _escape(built)
    return built


def _escape(command: object) -> None:
    """Escape the help of a command, of its options and of the commands below it."""
    assert isinstance(command, TyperCommand | TyperGroup)
    command.help = _literal(command.help)
    for parameter in command.params:
        if isinstance(parameter, TyperArgument | TyperOption):
            parameter.help = _literal(parameter.help)
    for inner in command.commands.values() if isinstance(command, TyperGroup) else ():
        _escape(inner)


def _literal(text: str | None) -> str | None:
    return text and escape(text)
