"""Commands of the ``haptonic`` program."""

from __future__ import annotations

import time
from datetime import UTC, datetime
from pathlib import Path
from typing import Annotated

import typer
import xarray as xr
from rich.table import Table

from haptonic import __version__, plots
from haptonic.cli.console import Voice, speaking
from haptonic.cli.designing import design, export, tolerance
from haptonic.cli.doctor import examined
from haptonic.cli.mirrors import LAYER_FILES, layers, waveguide, write_layers
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
from haptonic.cli.plates import plate, plate_files, write_plate
from haptonic.cli.verdicts import verdict
from haptonic.errors import StudyError
from haptonic.report import Results, paper, write_report
from haptonic.report.guide_shifts import guide_shifts
from haptonic.results import (
    Bands,
    Guides,
    Layers,
    PlateResult,
    Runner,
    Sweep,
    layer_tasks,
    refuse_taken,
    write_files,
    write_netcdf,
)
from haptonic.store import Store
from haptonic.study import Study, load, table

app = typer.Typer(
    name="haptonic",
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
def bands(
    study: StudyFile,
    out: Out = None,
    json: Json = False,
    surface: Annotated[
        bool, typer.Option("--surface", help="Also contours over the zone and the density of states.")
    ] = False,
    overwrite: Overwrite = False,
) -> None:
    """Band diagram, gaps and mode shapes of the unit cell."""
    with speaking(json) as voice:
        loaded = load(study)
        folder = folder_for(study, out, json, "bands")
        names = [*Bands.FILES, *pictures(Bands.figure_names(surface=surface))]
        refuse_taken(folder, names, overwrite=overwrite)
        with voice.busy("bands"):
            result = loaded.bands(surface=surface)
            if folder:
                _write_bands(result, folder, overwrite)
        voice.tell(gap_table(result))
        tell_where(voice, folder)
        voice.answer(result.to_json())


@app.command()
def sweep(
    study: StudyFile,
    out: Out = None,
    json: Json = False,
    workers: Workers = 0,
    scheduler: Scheduler = None,
    overwrite: Overwrite = False,
) -> None:
    """Complete gaps along the study's sweeps."""
    with speaking(json, KEPT) as voice:
        loaded = load(study)
        loaded.need_sweeps()
        folder = folder_for(study, out, json, "sweep")
        names = [f"sweep_{i + 1}" for i in range(len(loaded.sweep))]
        refuse_taken(folder, [*pictures(names), *(f"{n}.nc" for n in names)], overwrite=overwrite)
        results = _swept(loaded, voice, workers, scheduler)
        if folder:
            for name, result in zip(names, results, strict=True):
                _write_sweep(result, folder, name, overwrite)
        for result in results:
            voice.tell(sweep_table(result))
            _tell_failures(voice, result)
        tell_where(voice, folder)
        voice.answer({"sweeps": [result.to_json() for result in results]})


@app.command()
def reproduce(
    study: StudyFile,
    out: Out = None,
    json: Json = False,
    workers: Workers = 0,
    scheduler: Scheduler = None,
    overwrite: Overwrite = False,
) -> None:
    """Everything the study describes, and one report that sets it beside the paper."""
    with speaking(json, KEPT) as voice:
        loaded = load(study)
        folder = folder_for(study, out, False, "report")
        assert folder is not None
        sweeps = [f"sweep_{i + 1}" for i in range(len(loaded.sweep))]
        names = [*Bands.FILES, *pictures([*Bands.figure_names(surface=True), *sweeps])]
        names += ["report.html", *(f"{n}.nc" for n in sweeps)]
        if _has_mirror(loaded):
            names += LAYER_FILES
        if loaded.plate_section is not None and loaded.carrier is not None:
            names += plate_files(loaded.plate())
        refuse_taken(folder, names, overwrite=overwrite)
        started, timings = datetime.now(UTC), {}
        clock = time.perf_counter()
        with voice.busy("bands, zone and modes"):
            result = loaded.bands(surface=True)
        timings["bands, zone and modes"] = time.perf_counter() - clock
        clock = time.perf_counter()
        swept = _swept(loaded, voice, workers, scheduler)
        if swept:
            timings["sweeps"] = time.perf_counter() - clock
        clock = time.perf_counter()
        mirror, guides = _mirror(loaded, voice, workers, scheduler)
        if mirror:
            timings["mirror and waveguide"] = time.perf_counter() - clock
        clock = time.perf_counter()
        plated, shifts = _plate(loaded, voice)
        if plated:
            timings["plate"] = time.perf_counter() - clock
        filleted = None
        if paper.is_its_cell(loaded):
            with voice.busy("the paper's cell with a fillet"):
                filleted = loaded.gap_with({"cell.pillar.fillet": paper.TRIED_FILLET})
        with voice.busy("pictures and report"):
            _write_bands(result, folder, overwrite)
            for name, one in zip(sweeps, swept, strict=True):
                _write_sweep(one, folder, name, overwrite)
            if mirror:
                write_layers(mirror, folder, overwrite)
            data = tuple(one.dataset for one in swept)
            if plated:
                write_plate(plated, folder, overwrite)
            results = Results(
                loaded, result.dataset, data, mirror, guides, plated, shifts, filleted, timings, started
            )
            report = write_report(results, folder / "report.html", overwrite=overwrite)
        voice.tell(gap_table(result))
        for one in swept:
            _tell_failures(voice, one)
        voice.tell(f"report: {report}")
        answer = {"report": str(report), "seconds": timings, "sweeps": [one.to_json() for one in swept]}
        voice.answer({**result.to_json(), **answer})


def _plate(loaded: Study, voice: Voice) -> tuple[PlateResult | None, xr.Dataset | None]:
    """The finite plate, and what moves the mode of its guides if it is the paper's."""
    if loaded.plate_section is None or loaded.carrier is None:
        return None, None
    with voice.counted("plate", 0) as progress:
        result = loaded.vibrating(on_progress=progress)
    if not (paper.is_its_cell(loaded) and loaded.plate_section.actuator):
        return result, None
    with voice.busy("what moves the mode of the guides"):
        return result, guide_shifts(loaded, Store.default())


for command in (layers, waveguide, plate, verdict, design, tolerance, export):
    app.command()(command)


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


def gap_table(result: Bands) -> Table:
    """The gaps as a person reads them."""
    shown = Table("bands", "where", "lower / kHz", "upper / kHz", "width / kHz", "samples", title="band gaps")
    for gap in result.gaps:
        shown.add_row(
            f"{gap.between[0]}-{gap.between[1]}",
            "everywhere (complete)" if gap.complete else f"{gap.direction} only",
            f"{gap.lower / 1e3:.3f} ± {gap.lower_error / 1e3:.3f}",
            f"{gap.upper / 1e3:.3f} ± {gap.upper_error / 1e3:.3f}",
            f"{gap.width / 1e3:.2f}" + ("" if gap.certain else " (uncertain)"),
            str(gap.samples),
            style="bold" if gap.complete else "",
        )
    if not result.gaps:
        shown.add_row("", "none found", "", "", "", "")
    return shown


def sweep_table(result: Sweep) -> Table:
    """The widest complete gap of each design."""
    data = result.to_json()
    unit = f" / {data['unit']}" if data["unit"] != "1" else ""
    shown = Table(f"{data['vary']}{unit}", "gaps", "widest / kHz", "from / kHz", "to / kHz", title="sweep")
    for one in data["designs"]:
        widest = max(one["gaps"], key=lambda g: g["upper_hz"] - g["lower_hz"], default=None)
        numbers = ["-"] * 3
        if widest:
            low, high = widest["lower_hz"] / 1e3, widest["upper_hz"] / 1e3
            numbers = [f"{high - low:.2f}", f"{low:.2f}", f"{high:.2f}"]
        count = "failed" if one["error"] else str(len(one["gaps"]))
        shown.add_row(f"{one['value']:.4g}", count, *numbers)
    return shown


def _has_mirror(loaded: Study) -> bool:
    """Whether a mirror can be asked for: there is a carrier, and something that reflects."""
    return loaded.carrier is not None and loaded.cell.pillar is not None


def _mirror(
    loaded: Study, voice: Voice, workers: int, scheduler: str | None
) -> tuple[Layers | None, Guides | None]:
    """Layers and waveguides for the report, the latter if the gap holds the carrier."""
    if not _has_mirror(loaded):
        return None, None
    with voice.counted("mirror", layer_tasks(loaded.layers.points)) as progress:
        layered = loaded.layered(Runner(Store.default(), workers, scheduler, progress))
    try:
        with voice.busy("waveguide"):
            return layered, loaded.guided()
    except StudyError as error:
        voice.warn(f"no waveguide: {error.cause}")
        return layered, None


def _swept(loaded: Study, voice: Voice, workers: int, scheduler: str | None) -> tuple[Sweep, ...]:
    if not loaded.sweep:
        return ()
    with voice.counted("sweeps", sum(section.steps for section in loaded.sweep)) as progress:
        return loaded.swept(workers=workers, scheduler=scheduler, on_progress=progress)


def _write_bands(result: Bands, folder: Path, overwrite: bool) -> None:
    write_files(folder, result.files(), overwrite=overwrite)
    for name, figure in result.figures().items():
        plots.save(figure, folder, name, overwrite=overwrite)


def _write_sweep(result: Sweep, folder: Path, name: str, overwrite: bool) -> None:
    write_files(folder, {f"{name}.nc": lambda path: write_netcdf(result.dataset, path)}, overwrite=overwrite)
    plots.save(result.plot(), folder, name, overwrite=overwrite)


def _tell_failures(voice: Voice, result: Sweep) -> None:
    for step, error in result.failed.items():
        voice.warn(f"design {step + 1} of the sweep was left out: {error['cause']} ({error['argument']})")
