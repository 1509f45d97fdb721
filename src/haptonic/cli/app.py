"""Commands of the ``haptonic`` program."""

from __future__ import annotations

from typing import Annotated

import typer
from rich.table import Table

from haptonic import __version__
from haptonic.cli.console import speaking
from haptonic.cli.designing import design, export, tolerance
from haptonic.cli.doctor import examined
from haptonic.cli.experiments import protocol
from haptonic.cli.feeling import feel
from haptonic.cli.helping import Worded
from haptonic.cli.lattices import bands, sweep
from haptonic.cli.mirrors import layers, waveguide
from haptonic.cli.options import Json
from haptonic.cli.plates import plate
from haptonic.cli.reproducing import reproduce
from haptonic.cli.scans import chirp, scan
from haptonic.cli.touching import friction
from haptonic.cli.twins import twin
from haptonic.cli.verdicts import verdict
from haptonic.fields import table
from haptonic.study import Study

app = typer.Typer(
    name="haptonic",
    cls=Worded,
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


COMMANDS = (
    bands, sweep, reproduce, layers, waveguide, design, tolerance, export, plate, feel, chirp, scan, protocol,
    friction, verdict,
)  # fmt: skip
for command in COMMANDS:
    app.command()(command)
app.add_typer(twin, name="twin")


@app.command()
def doctor(json: Json = False) -> None:
    """Versions, threads, solver, memory, and a check of the physics that takes a second."""
    with speaking(json) as voice:
        with voice.busy("examining"):
            report = examined()
        shown = Table("", "", title="haptonic doctor", show_header=False)
        for name, value in report.items():
            shown.add_row(name.replace("_", " "), str(value))
        voice.tell(shown)
        voice.answer(report)
        if not report["healthy"]:
            raise SystemExit(1)


@app.command()
def keys(json: Json = False) -> None:
    """Every key of the study file, with its unit, default and bounds."""
    with speaking(json) as voice:
        known = table(Study)
        shown = Table("key", "meaning", "unit", "default", "allowed", title="keys of the study file")
        for path, key in known.items():
            shown.add_row(path, f"{key.title}. {key.description}", key.unit, key.default, key.bounds)
        voice.tell(shown)
        voice.answer(
            {
                "keys": [
                    {"path": path, "title": key.title, "unit": key.unit, "default": key.default,
                     "allowed": key.bounds, "description": key.description, "required": key.required}
                    for path, key in known.items()
                ]
            }
        )  # fmt: skip
