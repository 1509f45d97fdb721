"""Commands made of the table of analyses when they are asked for; texts of ``--help`` as they are written."""

from __future__ import annotations

from typing import Any

import typer
from rich.markup import escape
from typer.core import TyperArgument, TyperCommand, TyperGroup, TyperOption

from haptonic import analyses
from haptonic.analyses import analysis
from haptonic.cli.running import command

GROUPS = {"twin": "Simulate a measurement whose truth is known."}  # first words of names of two words


class Worded(TyperGroup):
    """Commands whose help may name tables such as ``[trials]``, which typer would take for markup."""

    def __init__(self, **known: Any) -> None:
        super().__init__(**known)
        _escape(self)


class Analyses(Worded):
    """The commands of the program; that of an analysis is made when it is asked for, as its module is loaded
    only then."""

    def list_commands(self, ctx: Any) -> list[str]:
        first = (name.split()[0] for name in analyses.NAMES)
        return list(dict.fromkeys([*first, *super().list_commands(ctx)]))

    def get_command(self, ctx: Any, cmd_name: str) -> Any:
        if cmd_name in analyses.NAMES:
            return made(cmd_name)
        inner = [name for name in analyses.NAMES if name.split()[0] == cmd_name]
        if not inner:
            return super().get_command(ctx, cmd_name)
        commands = {name.split()[1]: made(name) for name in inner}
        return Worded(
            name=cmd_name, help=GROUPS[cmd_name], commands=commands, no_args_is_help=True,
            rich_markup_mode="rich",
        )  # fmt: skip


def made(name: str) -> TyperCommand:
    """The command of an analysis."""
    alone = typer.Typer(add_completion=False, pretty_exceptions_enable=False)
    alone.command(name.split()[-1])(command(analysis(name)))
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
