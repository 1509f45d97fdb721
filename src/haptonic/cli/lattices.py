"""Commands about the lattice: bands, sweep."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from rich.table import Table

from haptonic import plots
from haptonic.cli.console import Voice, speaking
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
from haptonic.results import Bands, Sweep, refuse_taken, write_files, write_netcdf
from haptonic.store import whole_set
from haptonic.study import Study, load


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
                with whole_set(folder, overwrite=overwrite) as draft:
                    write_bands(result, draft, overwrite)
        voice.tell(gap_table(result))
        voice.tell(counted(**result.to_json()["counts"]))
        tell_where(voice, folder)
        voice.answer(result.to_json())


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
        names = [f"sweep_{i + 1}" for i in range(len(loaded.sweep_settings))]
        refuse_taken(folder, [*pictures(names), *(f"{n}.nc" for n in names)], overwrite=overwrite)
        results = swept(loaded, voice, workers, scheduler)
        if folder:
            with whole_set(folder, overwrite=overwrite) as draft:
                for name, result in zip(names, results, strict=True):
                    write_sweep(result, draft, name, overwrite)
        for result in results:
            voice.tell(sweep_table(result))
            tell_failures(voice, result)
        tell_where(voice, folder)
        voice.answer({"sweeps": [result.to_json() for result in results]})


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


def counted(checked: int, missed: int) -> str:
    """What the exact counts of modes say of the bands."""
    if not checked:
        return "Bands were not counted by another method: where it would be done, one lies within its error."
    missing = f"{missed or 'no'} band{'s' * (missed != 1)} missing"
    return f"Counted by another method, in {checked} comparison{'s' * (checked != 1)}: {missing}."


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


def swept(loaded: Study, voice: Voice, workers: int, scheduler: str | None) -> tuple[Sweep, ...]:
    if not loaded.sweep_settings:
        return ()
    with voice.counted("sweeps", sum(section.steps for section in loaded.sweep_settings)) as progress:
        return loaded.swept(workers=workers, scheduler=scheduler, on_progress=progress)


def write_bands(result: Bands, folder: Path, overwrite: bool) -> None:
    write_files(folder, result.files(), overwrite=overwrite)
    for name, figure in result.figures().items():
        plots.save(figure, folder, name, overwrite=overwrite)


def write_sweep(result: Sweep, folder: Path, name: str, overwrite: bool) -> None:
    write_files(folder, {f"{name}.nc": lambda path: write_netcdf(result.dataset, path)}, overwrite=overwrite)
    plots.save(result.plot(), folder, name, overwrite=overwrite)


def tell_failures(voice: Voice, result: Sweep) -> None:
    for step, error in result.failed.items():
        voice.warn(f"design {step + 1} of the sweep was left out: {error['cause']} ({error['argument']})")
