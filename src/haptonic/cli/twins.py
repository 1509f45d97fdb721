"""Commands that make measurements up, to test their analysis with: twin friction, twin scan."""

from __future__ import annotations

import json as plain
from enum import StrEnum
from pathlib import Path
from typing import Annotated, Any, Literal

import typer
from rich.table import Table

from haptonic.cli.console import speaking
from haptonic.cli.options import Json, Out, Overwrite, StudyFile, folder_for, tell_where
from haptonic.errors import FrictionError, ResourceError
from haptonic.paths import source, target
from haptonic.response import read
from haptonic.results import FrictionTwin, friction_twin, refuse_taken, write_files
from haptonic.results.scan.twin import kind_of, scan_name
from haptonic.store import whole_set
from haptonic.study import load, scanning
from haptonic.study.experimenting import protocol_of, truth_of
from haptonic.units import shown

twin = typer.Typer(no_args_is_help=True, help="Simulate a measurement whose truth is known.")


class Format(StrEnum):
    """Forms of the files."""

    csv = "csv"
    h5 = "h5"
    mat = "mat"
    tdms = "tdms"


class PerFile(StrEnum):
    """What a file holds."""

    trial = "trial"
    block = "block"


@twin.command()
def friction(
    study: StudyFile,
    out: Out = None,
    json: Json = False,
    participants: Annotated[
        int | None, typer.Option("--participants", metavar="N", help="How many; else the study's.")
    ] = None,
    seed: Annotated[int, typer.Option("--seed", metavar="N", min=0, help="Of all that is drawn.")] = 0,
    form: Annotated[Format, typer.Option("--format", help="Of the force records.")] = Format.csv,
    per: Annotated[PerFile, typer.Option("--per", help="What a file holds.")] = PerFile.trial,
    raw: Annotated[
        bool, typer.Option("--raw", help="Six gauge voltages of 16 bits and a calibration, not forces.")
    ] = False,
    amplitudes: Annotated[
        Path | None,
        typer.Option(
            "--from", metavar="FILE", help='What `feel --json` said, or {"WG1": 1e-6, ...} in m (JSON).'
        ),
    ] = None,
    overwrite: Overwrite = False,
) -> None:
    """Made-up strokes of made-up people, as a folder that `haptonic friction` reads; all simulated."""
    with speaking(json) as voice:
        loaded = load(study)
        folder = folder_for(study, out, False, "twin-friction")
        assert folder is not None
        given = None if amplitudes is None else read_amplitudes(amplitudes)
        count = loaded.protocol_settings.participants if participants is None else participants
        protocol = protocol_of(loaded)
        protocol.order(count)
        with voice.busy("friction by load sharing"):
            truth = truth_of(loaded, given)
        made = friction_twin(
            truth, protocol, count, seed=seed, study=loaded.to_toml(), suffix=f".{form.value}",
            per=per.value, raw=raw,
        )  # fmt: skip
        refuse_taken(folder, made.names, overwrite=overwrite)
        strokes = count * protocol.blocks * protocol.trials
        with whole_set(folder, overwrite=overwrite) as draft, voice.counted("strokes", strokes) as progress:
            made.write(draft, progress)
        voice.tell(truth_table(made))
        voice.tell("Simulated: nobody stroked anything. The truth is in truth.json.")
        tell_where(voice, folder)
        voice.answer({**made.to_json(), "folder": str(folder), "files": len(made.names)})


def read_amplitudes(path: Path) -> dict[str, float]:
    """Amplitudes of vibration, m, by waveguide.

    Raises
    ------
    ResourceError : the file cannot be read
    FrictionError : it holds something else
    """
    path = source(path, "--from")
    try:
        values: Any = plain.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        missing = isinstance(error, FileNotFoundError)
        raise ResourceError(
            argument="--from",
            given=path,
            allowed='a JSON file such as {"WG1": 1e-6, "WG2": 3e-7}',
            cause="there is no such file" if missing else "it cannot be read, or is not JSON",
            next_step="check the name and the folder" if missing else "write it anew",
        ) from None
    if isinstance(values, dict) and isinstance(values.get("regions"), dict):  # what `haptonic feel` says
        values = {name: region.get("amplitude_m") for name, region in values["regions"].items()}
    numbers = isinstance(values, dict) and all(
        isinstance(one, int | float) and not isinstance(one, bool) for one in values.values()
    )
    if not numbers or not values:
        raise FrictionError(
            argument="--from",
            given=shown(values),
            allowed='amplitudes in m by waveguide, such as {"WG1": 1e-6, "WG2": 3e-7}',
            cause="the file is of another kind, or a number is written as text",
            next_step="write a number of metres for each waveguide",
        )
    return {str(name): float(value) for name, value in values.items()}


def truth_table(made: FrictionTwin) -> Table:
    """True reductions, of the population and of every participant."""
    truth = made.to_json()
    guides = made.protocol.waveguides
    table = Table("", "friction", *(f"{guide} / %" for guide in guides), title="true reductions (simulated)")
    rows = {"population": truth["population"], **truth["participants"]}
    for name, row in rows.items():
        table.add_row(
            name, f"{row['friction']:.3f}", *(f"{100 * row['reduction'][guide]:.1f}" for guide in guides)
        )
    return table


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
        out = target(out)
        refuse_taken(out, [scan_name(form), "truth.json"], overwrite=overwrite)
        given = None if response is None else read(response)
        with voice.counted("shifts", 0) as progress:
            made = scanning.twin_scan(loaded, seed=seed, response=given, on_progress=progress)
        with voice.busy("records"):
            files = made.files(form, kind)
            with whole_set(out, overwrite=overwrite) as draft:
                write_files(draft, files, overwrite=overwrite)
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
             "kind": kind, "points": truth["points"],
             **{name: truth[name] for name in ("contrast_range", "computed_gap_hz")}, "seed": seed}
        )  # fmt: skip
