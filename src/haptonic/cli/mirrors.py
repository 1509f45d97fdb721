"""Commands about the lattice as a mirror: layers, waveguide."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Annotated

import typer
from rich.table import Table

from haptonic import plots
from haptonic.bloch.mirrors import MOST_ROWS
from haptonic.cli.console import speaking
from haptonic.cli.options import (
    KEPT,
    Json,
    Out,
    Overwrite,
    Scheduler,
    StudyFile,
    Workers,
    folder_for,
    pictures,
    tell_where,
)
from haptonic.results import Guides, Layers, Runner, layer_tasks, refuse_taken, write_files, write_netcdf
from haptonic.store import Store, whole_set
from haptonic.study import load

LAYER_FILES = ["layers.nc", *pictures(["decay", "layers"])]


def layers(
    study: StudyFile,
    out: Out = None,
    json: Json = False,
    workers: Workers = 0,
    scheduler: Scheduler = None,
    overwrite: Overwrite = False,
) -> None:
    """What rows of cells let through between two plain plates, and how many of them the carrier needs."""
    with speaking(json, KEPT) as voice:
        loaded = load(study)
        folder = folder_for(study, out, json, "layers")
        refuse_taken(folder, LAYER_FILES, overwrite=overwrite)
        with voice.counted("frequencies", layer_tasks(loaded.layers_settings.points)) as progress:
            result = loaded.layered(Runner(Store.default(), workers, scheduler, progress))
        if folder:
            with whole_set(folder, overwrite=overwrite) as draft:
                write_layers(result, draft, overwrite)
        voice.tell(layers_table(result))
        voice.tell(needed_table(result))
        decay = float(result.dataset.attrs["carrier_attenuation_db"])
        voice.tell(f"The wave that reaches farthest fades by {decay:.2f} dB per row at the carrier.")
        tell_where(voice, folder)
        voice.answer(result.to_json())


def waveguide(
    study: StudyFile,
    out: Out = None,
    json: Json = False,
    mode: Annotated[
        str | None,
        typer.Option("--mode", metavar="MxN", help="Nodal lines across, intervals along; else the study's."),
    ] = None,
    overwrite: Overwrite = False,
) -> None:
    """Width, length and frequency of a waveguide between two such mirrors."""
    with speaking(json) as voice:
        loaded = load(study)
        if mode is not None:
            loaded = loaded.with_mode(mode)
        folder = folder_for(study, out, json, "waveguide")
        refuse_taken(folder, pictures(["waveguide"]), overwrite=overwrite)
        with voice.busy("waveguides"):
            result = loaded.guided()
        if folder:
            with whole_set(folder, overwrite=overwrite) as draft:
                plots.save(result.plot(), draft, "waveguide")
        voice.tell(guides_table(result))
        tell_where(voice, folder)
        voice.answer(result.to_json())


def write_layers(result: Layers, folder: Path, overwrite: bool) -> None:
    """Data and pictures of a mirror."""
    write_files(folder, {"layers.nc": partial(write_netcdf, result.dataset)}, overwrite=overwrite)
    for name, figure in result.figures().items():
        plots.save(figure, folder, name, overwrite=overwrite)


def layers_table(result: Layers) -> Table:
    """Insulation at the carrier by rows."""
    data = result.dataset
    carrier = float(data.attrs["carrier_hz"]) / 1e3
    title = (
        f"transmitted energy at {carrier:g} kHz {result.incidence}, dB below the incident wave: "
        "all waves (the same kind alone)"
    )
    shown = Table("rows", *(f"incident {family}" for family in result.families), title=title)
    for k, rows in enumerate(data["rows"].values):
        cells = [f"{result.insulation(f)[k]:.1f} ({result.same_wave(f)[k]:.1f})" for f in result.families]
        shown.add_row(str(rows), *cells)
    return shown


def needed_table(result: Layers) -> Table:
    """Rows needed for round insulations."""
    shown = Table("incident", *(f"{goal:g} dB" for goal in result.needed(result.families[0])),
                  title="rows needed")  # fmt: skip
    for family in result.families:
        needed = result.needed(family).values()
        shown.add_row(family, *(str(rows) if rows else f"more than {MOST_ROWS}" for rows in needed))
    return shown


def guides_table(result: Guides) -> Table:
    """Every waveguide compared."""
    title = f"waveguides for mode {result.across}x{result.along}, {result.ends} ends"
    shown = Table(
        "width / mm", "length / mm", "cells", "frequency / kHz", "nodal spacing / mm", "edge / peak",
        "fixed line / mm", "dB per row", title=title,
    )  # fmt: skip
    for strip in result.strips:
        shown.add_row(
            f"{strip.mode.width * 1e3:.2f}",
            f"{strip.length * 1e3:.1f}",
            str(strip.rows),
            f"{strip.frequency / 1e3:.3f}",
            f"{strip.spacing * 1e3:.3f}",
            f"{strip.mode.at_edge:.3f}",
            f"{strip.fixed_line * 1e3:.2f}",
            f"{strip.decay:.1f}",
            style="bold" if strip is result.best else "",
        )
    return shown
