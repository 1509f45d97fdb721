"""The command about what a finger feels of the plate: feel."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from rich.table import Table
from rich.text import Text

from haptonic import plots
from haptonic.cli.console import speaking
from haptonic.cli.options import Json, Out, Overwrite, StudyFile, folder_for, pictures, tell_where
from haptonic.friction.lubrication import WEBER_FRACTION
from haptonic.results import Feel, refuse_taken, write_files
from haptonic.results.feel.value import check_reduction
from haptonic.store import whole_set
from haptonic.study import load
from haptonic.units import format_quantity, to_si

MARKS = {"green": "● green", "amber": "▲ amber", "red": "■ red"}  # told apart without their colour too
COLOURS = {"green": "green", "amber": "yellow", "red": "red"}


def feel(
    study: StudyFile,
    voltage: Annotated[
        str | None,
        typer.Option("--voltage", metavar="VOLTAGE", help='Of the first actuator, such as "200 V".'),
    ] = None,
    at: Annotated[
        str | None,
        typer.Option("--at", metavar="FREQUENCY", help="Of the drive; else the loudest resonance."),
    ] = None,
    reduction: Annotated[
        float | None,
        typer.Option("--reduction", metavar="SHARE", help="Also say which drive gives it, 0.5 for 50 %."),
    ] = None,
    out: Out = None,
    json: Json = False,
    overwrite: Overwrite = False,
) -> None:
    """What a finger feels of the plate: a map of friction, reductions, whether they are noticed."""
    with speaking(json) as voice:
        loaded = load(study)
        frequency = None if at is None else float(to_si(at, "Hz", "--at"))
        volts = None if voltage is None else float(to_si(voltage, "V", "--voltage"))
        if reduction is not None:
            check_reduction(reduction)
        folder = folder_for(study, out, json, "feel")
        refuse_taken(folder, FEEL_FILES, overwrite=overwrite)
        with voice.counted("shifts", 0) as progress:
            result = loaded.felt(at=frequency, voltage=volts, on_progress=progress)
        wanted = None if reduction is None else drives_for(result, reduction)
        if folder:
            with whole_set(folder, overwrite=overwrite) as draft:
                write_feel(result, draft, overwrite)
        voice.tell(felt_table(result))
        voice.tell(lights_table(result))
        if wanted is not None:
            drives = "; ".join(f"{name}: {_drive(result, drive)}" for name, drive in wanted.items())
            voice.tell(f"For a reduction of {100 * reduction:.0f} %: {drives}")  # type: ignore[operator]
        voice.tell(_assumed(result))
        tell_where(voice, folder)
        answer = result.to_json()
        voice.answer(answer if wanted is None else answer | {"drive_for": {"reduction": reduction, **wanted}})


FEEL_FILES = [*Feel.FILES, *pictures(Feel.FIGURES)]


def drives_for(result: Feel, reduction: float) -> dict[str, float | None]:
    """Amplitude of the drive that gives a reduction on each region."""
    return {name: result.drive_for(reduction, name) for name in result.regions}


def write_feel(result: Feel, folder: Path, overwrite: bool) -> None:
    """Data and pictures of what a finger feels."""
    write_files(folder, result.files(), overwrite=overwrite)
    for name, figure in result.figures().items():
        plots.save(figure, folder, name, overwrite=overwrite)


def felt_table(result: Feel) -> Table:
    """Every region: amplitudes, reduction with its band, the drive from which on it is noticed."""
    reductions = result.reductions()
    drive = format_quantity(result.drive, result.unit)
    table = Table(
        "region", "amplitude / um", "without finger / um", "reduction", "noticed from",
        title=f"below a finger of {result.touch.force:g} N at {result.frequency / 1e3:.2f} kHz and {drive}, "
        "simulated",
    )  # fmt: skip
    for name in result.regions:
        table.add_row(
            f"{name} (driven)" if name == result.driven else name,
            f"{1e6 * result.amplitude(name):.3g}",
            f"{1e6 * result.amplitude(name, 'free'):.3g}",
            str(reductions[name]),
            _drive(result, result.drive_for(WEBER_FRACTION, name)),
        )
    return table


def lights_table(result: Feel) -> Table:
    """Whether the plate does what it is for."""
    table = Table("", "demand", "why", title="does the plate do what it is for?")
    for light in result.lights:
        table.add_row(Text(MARKS[light.colour], COLOURS[light.colour]), light.what, light.reason)
    return table


def _drive(result: Feel, drive: float | None) -> str:
    return "not reached" if drive is None else f"{drive:.3g} {result.unit}"


def _assumed(result: Feel) -> str:
    marked = [name for name, one in result.skin.assumptions().items() if one["mark"] == "assumed"]
    return (
        f"Assumed, not measured: {', '.join(name.replace('_', ' ') for name in marked)}, damping of the "
        "finger. Values by load sharing; intervals over both models and all plausible parameters. Simulated."
    )
