"""The program ``haptonic``: a command for each analysis, and a few about the program itself."""

from __future__ import annotations

from typing import Annotated

import typer

from haptonic import __version__
from haptonic.cli.console import speaking
from haptonic.cli.doctor import examined
from haptonic.cli.helping import Analyses
from haptonic.cli.running import Json
from haptonic.fields import table
from haptonic.results.table import Table
from haptonic.study import Study

app = typer.Typer(
    name="haptonic",
    cls=Analyses,
    help="Design and check surfaces whose friction is shaped by phononic crystals.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def main() -> None:
    """Entry point of the program."""
    app()


@app.callback(invoke_without_command=True)
def root(
    version: Annotated[bool, typer.Option("--version", help="Print the version and leave.")] = False,
) -> None:
    if version:
        typer.echo(f"haptonic {__version__}")
        raise typer.Exit


@app.command()
def doctor(json: Json = False) -> None:
    """Versions, threads, solver, memory, and a check of the physics that takes a second."""
    with speaking(json) as voice:
        with voice.counted("examining"):
            report = examined()
        rows = [(name.replace("_", " "), str(value)) for name, value in report.items()]
        voice.show(Table("haptonic doctor", ("what", "value"), rows))
        voice.answer(report)
        if not report["healthy"]:
            raise SystemExit(1)


@app.command()
def keys(json: Json = False) -> None:
    """Every key of the study file, with its unit, default and bounds."""
    with speaking(json) as voice:
        known = table(Study)
        rows = [
            (path, f"{key.title}. {key.description}", key.unit, key.default, key.bounds)
            for path, key in known.items()
        ]
        head = ("key", "meaning", "unit", "default", "allowed")
        voice.show(Table("keys of the study file", head, rows))
        voice.answer(
            {
                "keys": [
                    {"path": path, "title": key.title, "unit": key.unit, "default": key.default,
                     "allowed": key.bounds, "description": key.description, "required": key.required}
                    for path, key in known.items()
                ]
            }
        )  # fmt: skip
