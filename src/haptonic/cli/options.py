"""Arguments and options that several commands share, and where their files go."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import typer

from haptonic.cli.console import Voice
from haptonic.paths import target

StudyFile = Annotated[Path, typer.Argument(metavar="STUDY", help="Study file (TOML).")]
Out = Annotated[
    Path | None,
    typer.Option("--out", metavar="DIR", help="Folder for the files; results/STUDY-COMMAND by default."),
]
Json = Annotated[
    bool, typer.Option("--json", help="Print one JSON object; files are then written only with --out.")
]
Overwrite = Annotated[bool, typer.Option("--overwrite", help="Replace files of an earlier run.")]
Workers = Annotated[
    int, typer.Option("--workers", metavar="N", help="Worker processes on this machine; 0 works in this one.")
]
Scheduler = Annotated[
    str | None, typer.Option("--scheduler", metavar="ADDRESS", help="A running Dask scheduler to work on.")
]
KEPT = "the designs that were finished are kept; the same command goes on from there"


def folder_for(study: Path, out: Path | None, json: bool, command: str) -> Path | None:
    """Where a command's files go; nowhere if a machine asks and names no folder."""
    if out is None and json:
        return None
    return target(Path("results") / f"{study.stem}-{command}" if out is None else out)


def pictures(names: Sequence[str]) -> list[str]:
    """File names of pictures."""
    return [f"{name}.{kind}" for name in names for kind in ("svg", "png")]


def tell_where(voice: Voice, folder: Path | None) -> None:
    """Say where the files are."""
    if folder:
        voice.tell(f"files: {folder}")
