"""The command about the finite plate: plate."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Annotated

import typer
from rich.table import Table

from haptonic import plots
from haptonic.cli.console import speaking
from haptonic.cli.options import Json, Out, Overwrite, StudyFile, folder_for, pictures, tell_where
from haptonic.plate import Plate
from haptonic.response import write
from haptonic.results import PlateResult, refuse_taken, write_files, write_netcdf
from haptonic.results.plate.value import ERRORS, impedance_names
from haptonic.store import whole_set
from haptonic.study import load
from haptonic.units import to_si
from haptonic.vtu import write_body

ROOMY = 3  # regions that fit beside the other columns of a table with room around them


def plate(
    study: StudyFile,
    out: Out = None,
    json: Json = False,
    at: Annotated[
        str | None, typer.Option("--at", metavar="FREQUENCY", help='One frequency only, such as "58.8 kHz".')
    ] = None,
    overwrite: Overwrite = False,
) -> None:
    """How the finite plate vibrates: response, localisation, energies, impedance, modes."""
    with speaking(json) as voice:
        loaded = load(study)
        frequency = None if at is None else float(to_si(at, "Hz", "--at"))
        folder = folder_for(study, out, json, "plate")
        files = plate_files(loaded.mounted_plate())
        refuse_taken(folder, files, overwrite=overwrite)
        if loaded.mounted_plate().rigid:
            voice.warn(
                f"nothing holds the plate: {loaded.mounted_plate().rigid_modes} rigid-body motions are free"
            )
        with voice.counted("shifts", 0) as progress:
            result = loaded.vibrating(at=frequency, on_progress=progress)
        if folder:
            with whole_set(folder, overwrite=overwrite) as draft:
                write_plate(result, draft, overwrite)
        voice.tell(localisation_table(result))
        voice.tell(power_table(result))
        if result.modes.sizes["mode"]:
            voice.tell(modes_table(result))
        voice.tell(
            f"Largest solver's error of the field at any line: {float(result.lines['error'].max()):.1e} "
            f"(a bound), of {result.lines.attrs['unknowns']} unknowns on {result.lines.attrs['basis']} "
            f"vectors. {ERRORS} Simulated."
        )
        tell_where(voice, folder)
        voice.answer(result.to_json())


def plate_files(plate: Plate) -> list[str]:
    """Names of all that `write_plate` can write."""
    names = ["plan", "maps", "velocity", "contrast", *impedance_names(plate).values()]
    return ["response.nc", "maps.nc", "plate.nc", "modes.nc", "plate.vtu", "carrier.webp", *pictures(names)]


def write_plate(result: PlateResult, folder: Path, overwrite: bool) -> None:
    """Data, pictures and the animation of a plate."""
    write_files(
        folder,
        {
            "response.nc": partial(write, result.response),
            "maps.nc": partial(write, result.marked),
            "plate.nc": partial(write_netcdf, result.lines),
            "modes.nc": partial(write_netcdf, result.modes),
            "plate.vtu": lambda path: write_body(path, result.body),
        },
        overwrite=overwrite,
    )
    for name, figure in result.figures().items():
        plots.save(figure, folder, name, overwrite=overwrite)
    plots.animated(
        folder / "carrier.webp", result.marked, result.resonance, result.plate.layout, overwrite=overwrite
    )


def localisation_table(result: PlateResult) -> Table:
    """Velocities and contrasts at the frequencies of the maps."""
    units = result.response.units
    regions = [name for name in result.response.regions if name]
    lines = [result.told(line) for line in result.map_lines]
    contrasts = list(lines[0]["contrast_db"])
    title = "root mean square velocity, contrast, and largest amplitude below a finger"
    table = Table(
        "frequency / kHz", *(f"{name} / ({units})" for name in regions),
        *(f"{name} / dB" for name in contrasts),
        *(f"finger {name} / ({units.replace('m/s', 'um')})" for name in regions), title=title,
    )  # fmt: skip
    for line in lines:
        table.add_row(
            f"{line['frequency_hz'] / 1e3:.3f}",
            *(f"{line['rms'][name]:.3g}" for name in regions),
            *(f"{line['contrast_db'][name]:.1f}" for name in contrasts),
            *(f"{line['finger_um'][name]:.3g}" for name in regions),
        )
    return table


def power_table(result: PlateResult) -> Table:
    """Where the power goes at the resonance of the map in the gap."""
    line = result.told(result.marked.at(result.resonance))
    table = Table(
        "part",
        "power / W",
        "share / %",
        title=f"power at {line['frequency_hz'] / 1e3:.3f} kHz, per unit squared",
    )
    for name, power in line["dissipated_w"].items():
        if power:
            table.add_row(name, f"{power:.3g}", f"{100 * power / line['given_w']:.1f}")
    table.add_row("given by the drives", f"{line['given_w']:.3g}", "100.0", style="bold")
    return table


def modes_table(result: PlateResult) -> Table:
    """Modes near the carrier."""
    modes = result.modes
    regions = modes["region"].values.tolist()
    regions += [f"patch {name}" for name in modes["actuator"].values.tolist()]
    table = Table(
        "frequency / kHz", "solver's error", "name", "Q", "rise / ms", *(f"{name} / %" for name in regions),
        title="modes near the carrier: where their strain energy is",
        padding=(0, 1 if len(regions) <= ROOMY else 0),
    )  # fmt: skip
    for k in range(modes.sizes["mode"]):
        mode = modes.isel(mode=k)
        table.add_row(
            f"{float(mode['mode_frequency']) / 1e3:.3f}",
            f"{float(mode['mode_error']):.0e}",
            str(mode["name"].values),
            f"{float(mode['quality']):.0f}",
            f"{float(mode['rise_time']) * 1e3:.2f}",
            *(f"{100 * share:.1f}" for share in (*mode["stored"].values, *mode["stored_in_actuator"].values)),
        )
    for column in table.columns:  # headings may be folded in a narrow terminal, numbers may not
        column.overflow = "fold"
        column.min_width = max((len(str(cell)) for cell in column.cells), default=0)
    return table
