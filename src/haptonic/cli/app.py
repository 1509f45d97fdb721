"""The program ``haptonic``: a command for each analysis, and a few commands about the program itself."""

from __future__ import annotations

import atexit
import gc
import io
import sys
from typing import Annotated

import typer

from haptonic import __version__
from haptonic.cli.helping import Listed
from haptonic.cli.streams import UNHEARD, mute
from haptonic.errors import ResourceError
from haptonic.later import leave_out

app = typer.Typer(
    name="haptonic",
    cls=Listed,
    help="Design and check surfaces whose friction is shaped by phononic crystals.",
    no_args_is_help=True,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


# new objects between collections; with Python's 700 they take a tenth of the imports, and with 50,000 still
# 0.15 s of the 2.3 s of `haptonic bands` with a stored answer
COLLECTED_AFTER = 200_000


def main() -> None:
    """Entry point of the program."""
    leave_out()
    gc.set_threshold(COLLECTED_AFTER)
    atexit.register(gc.freeze)  # the collections while Python ends took 0.5 s after `haptonic bands`
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")  # print "?" for letters that the terminal does not have
    try:
        app()
    except OSError as error:
        if error.filename is not None or error.errno not in UNHEARD:
            raise
        mute(sys.stdout)
        refusal = ResourceError.unwritable(
            argument="standard output",
            given=error.strerror,
            allowed="a terminal, or a file with room for the answer",
            cause="the disk is full, or the program that read the answer has ended",
            next_step="send the answer to another place; files of the command, if it has any, are written",
        )
        print(refusal, file=sys.stderr)
        raise SystemExit(2) from None


@app.callback(invoke_without_command=True)
def root(
    version: Annotated[bool, typer.Option("--version", help="Print the version and leave.")] = False,
) -> None:
    if version:
        typer.echo(f"haptonic {__version__}")
        raise typer.Exit
