"""The program ``haptonic``: a command for each analysis, and a few about the program itself."""

from __future__ import annotations

from typing import Annotated

import typer

from haptonic import __version__
from haptonic.cli.helping import Listed
from haptonic.later import leave_out

app = typer.Typer(
    name="haptonic",
    cls=Listed,
    help="Design and check surfaces whose friction is shaped by phononic crystals.",
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def main() -> None:
    """Entry point of the program."""
    leave_out()
    app()


@app.callback(invoke_without_command=True)
def root(
    version: Annotated[bool, typer.Option("--version", help="Print the version and leave.")] = False,
) -> None:
    if version:
        typer.echo(f"haptonic {__version__}")
        raise typer.Exit
