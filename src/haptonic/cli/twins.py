"""Twins: measurements in software whose truth is known, to test an analysis with."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from haptonic.cli.console import speaking
from haptonic.cli.options import Json, Overwrite, StudyFile, tell_where
from haptonic.response import read
from haptonic.results import refuse_taken, write_files
from haptonic.results.scan.twin import kind_of, scan_name
from haptonic.study import load, scanning

twin = typer.Typer(help="Measurements in software, whose truth is known.", no_args_is_help=True)


@twin.command("scan")
def twin_scan(
    study: StudyFile,
    out: Annotated[
        Path, typer.Option("--out", metavar="DIR", help="Folder for the scan and its truth.json.")
    ],
    json: Json = False,
    form: Annotated[
        Literal["h5", "nc", "uff", "mat", "csv", "tdms"], typer.Option("--format", help="Of the scan's file.")
    ] = "h5",
    time: Annotated[
        bool | None, typer.Option("--time/--frf", help="Records, or responses; else what the format has.")
    ] = None,
    seed: Annotated[int, typer.Option("--seed", min=0, help="Of noise and dropouts.")] = 0,
    response: Annotated[
        Path | None,
        typer.Option("--from", metavar="FILE", help="The plate's response, instead of computing it."),
    ] = None,
    overwrite: Overwrite = False,
) -> None:
    """What a laser vibrometer would record of the study's plate. Everything is marked as simulated."""
    with speaking(json) as voice:
        loaded = load(study)
        kind = kind_of(form, None if time is None else "time" if time else "frf")
        refuse_taken(out, [scan_name(form), "truth.json"], overwrite=overwrite)
        given = None if response is None else read(response)
        with voice.counted("shifts", 0) as progress:
            made = scanning.twin_scan(loaded, seed=seed, response=given, on_progress=progress)
        with voice.busy("records"):
            files = made.files(form, kind)
            write_files(out, files, overwrite=overwrite)
        records = made.records
        what = "records" if kind == "time" else "responses"
        voice.tell(
            f"{len(records.names)} points, {records.repeats} periods of {records.samples} samples at "
            f"{records.sample_rate / 1e3:g} kHz, written as {what}. Simulated."
        )
        tell_where(voice, out)
        truth = made.truth()
        voice.answer(
            {"origin": "simulated", "files": [str(out / name) for name in (scan_name(form), "truth.json")],
             "kind": kind, "points": truth["points"], "gap": truth["gap"], "seed": seed}
        )  # fmt: skip
