"""Commands from the question to the workshop: design, tolerance, export."""

from __future__ import annotations

from collections.abc import Callable
from datetime import date
from functools import partial
from pathlib import Path
from typing import Annotated

import typer
import xarray as xr
from rich.table import Table

from haptonic import plots, workshop
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
from haptonic.design.parameters import UNITS
from haptonic.design.tolerance import REACH
from haptonic.results import Design, Runner, Tolerance, refuse_taken, write_files, write_netcdf
from haptonic.results.common import no_nan
from haptonic.store import Store, whole_set
from haptonic.study import Study, load
from haptonic.units import format_quantity
from haptonic.workshop.shape import dimensions_of, in_mm


def design(
    study: StudyFile,
    out: Out = None,
    json: Json = False,
    pareto: Annotated[bool, typer.Option("--pareto", help="Also the widest gap against the pitch.")] = False,
    workers: Workers = 0,
    scheduler: Scheduler = None,
    overwrite: Overwrite = False,
) -> None:
    """The cell whose gap holds the carrier with the widest margin, within the study's [design]."""
    with speaking(json, KEPT) as voice:
        loaded = load(study)
        if pareto:
            loaded.need_pitches()
        folder = folder_for(study, out, json, "design")
        names = ["search", *["front"] * pareto]
        files = ["design.toml", *(f"{name}.nc" for name in names), *pictures(names)]
        refuse_taken(folder, files, overwrite=overwrite)
        section = loaded.design_settings
        with voice.counted("design", 0) as progress:
            result = loaded.designed(Runner(Store.default(), workers, scheduler, progress))
        found = loaded.without_plate().with_parameters(result.values)
        figures, datasets = {"search": result.plot()}, {"search": result.dataset}
        if pareto:
            with voice.counted("pitches", section.pitches) as progress:
                datasets["front"] = loaded.front(
                    result, Runner(Store.default(), workers, scheduler, progress)
                )
            figures["front"] = plots.front(datasets["front"])
        if folder:
            writers: dict[str, Callable[[Path], object]] = {
                f"{name}.nc": partial(write_netcdf, data) for name, data in datasets.items()
            }
            writers["design.toml"] = lambda path: path.write_text(found.to_toml(), "utf-8")
            with whole_set(folder, overwrite=overwrite) as draft:
                write_files(draft, writers, overwrite=overwrite)
                for name, figure in figures.items():
                    plots.save(figure, draft, name)
        voice.tell(design_table(loaded, result))
        for words in left_out(result):
            voice.tell(words)
        if pareto:
            voice.tell(front_table(datasets["front"]))
        tell_where(voice, folder)
        answer = {**result.to_json(), "study": found.to_toml()}
        if pareto:
            names_of_front = ("pitch", "lower", "upper", "margin")
            answer["front"] = {name: no_nan(datasets["front"][name].values) for name in names_of_front}
        voice.answer(answer)


def tolerance(
    study: StudyFile,
    out: Out = None,
    json: Json = False,
    workers: Workers = 0,
    scheduler: Scheduler = None,
    overwrite: Overwrite = False,
) -> None:
    """The chance that the gap holds the carrier, the size that matters most, and the loosest tolerances."""
    with speaking(json, KEPT) as voice:
        loaded = load(study)
        folder = folder_for(study, out, json, "tolerance")
        refuse_taken(folder, ["tolerance.nc", *pictures(["tolerance"])], overwrite=overwrite)
        with voice.counted("designs", loaded.tolerance_tasks()) as progress:
            result = loaded.toleranced(Runner(Store.default(), workers, scheduler, progress))
        if folder:
            writers = {"tolerance.nc": lambda path: write_netcdf(result.dataset, path)}
            with whole_set(folder, overwrite=overwrite) as draft:
                write_files(draft, writers, overwrite=overwrite)
                plots.save(result.plot(), draft, "tolerance")
        voice.tell(tolerance_table(result))
        voice.tell(in_words(loaded, result))
        tell_where(voice, folder)
        voice.answer(result.to_json())


def export(
    study: StudyFile,
    out: Out = None,
    json: Json = False,
    step: Annotated[bool, typer.Option("--step", help="Solid, for CAD (needs haptonic[cad]).")] = False,
    dxf: Annotated[bool, typer.Option("--dxf", help="Outlines seen from above.")] = False,
    stl: Annotated[bool, typer.Option("--stl", help="Surface as triangles.")] = False,
    drawing: Annotated[bool, typer.Option("--drawing", help="Dimensioned drawing (PDF, DXF).")] = False,
    columns: Annotated[int, typer.Option("--columns", metavar="N", help="Cells along x.")] = 1,
    rows: Annotated[int, typer.Option("--rows", metavar="N", help="Cells along y.")] = 1,
    overwrite: Overwrite = False,
) -> None:
    """Files for the workshop; all of them if none is named. The drawing has the tolerances found, or says why
    not."""
    with speaking(json) as voice:
        loaded = load(study)
        cell, stem = loaded.cell, study.stem
        folder = folder_for(study, out, False, "export")
        assert folder is not None
        wanted = {"step": step, "dxf": dxf, "stl": stl, "pdf": drawing}
        kinds = [kind for kind, asked in wanted.items() if asked] or list(wanted)
        files = [f"{stem}.{kind}" for kind in kinds]
        drawings = [f"{stem}.pdf", f"{stem}-drawing.dxf"] if "pdf" in kinds else []
        files += drawings[1:]
        refuse_taken(folder, files, overwrite=overwrite)
        in_mm(cell, columns, rows)  # refuses impossible numbers of cells before anything is computed
        tolerances: dict[str, float] = {}
        why_none = ""
        with voice.busy("files for the workshop"), whole_set(folder, overwrite=overwrite) as draft:
            if drawings:
                tolerances, why_none = drawn_tolerances(loaded)
            solids: dict[str, Callable[..., Path]] = {
                "step": partial(workshop.write_step, title=loaded.title),
                "dxf": workshop.write_dxf,
                "stl": workshop.write_stl,
            }
            for kind, writer in solids.items():
                if kind in kinds:
                    writer(draft / f"{stem}.{kind}", cell, columns, rows)
            for name in drawings:
                workshop.write_drawing(
                    draft / name, cell, loaded.title, columns, rows,
                    tolerances=tolerances, why_none=why_none, date=date.today(),
                )  # fmt: skip
        written = [str(folder / name) for name in files]
        for path in written:
            voice.tell(f"written: {path}")
        if why_none and loaded.tolerance_settings.of:
            voice.warn(f"the drawing has no tolerances: {why_none}")
        told = {"tolerances": tolerances, "why_no_tolerances": why_none or None} if drawings else {}
        voice.answer({"files": written, **told})


def drawn_tolerances(study: Study) -> tuple[dict[str, float], str]:
    """Half-widths (SI) of the sizes that the study gives spreads for: the loosest that keep its confidence.

    There is none for a draft of zero, which the drawing does not show.

    Returns
    -------
    the half-widths, and why there are none, if there are none
    """
    if not study.tolerance_settings.of:
        return {}, "the study gives no spreads, [tolerance] of"
    result, confidence = study.toleranced(), study.tolerance_settings.confidence
    spreads, shown = [one.frozen() for one in study.tolerance_settings.of], dimensions_of(study.cell)
    drawn = {s.path: result.loosest * s.half_range for s in spreads if s.path in shown}
    if not drawn:
        return {}, "the study gives spreads of the material or of what is not drawn only"
    if result.loosest > 0:
        return drawn, ""
    return {}, (
        f"none keeps the carrier in the gap with {confidence:.1%}, as [tolerance] asks; with the study's own "
        f"spreads the chance is {_chance(result.plate)}"
    )


def design_table(study: Study, result: Design) -> Table:
    """The design found beside the study's own."""
    shown = Table("", "study", "design found", title="design")
    own = study.parameters()
    for path, value in result.values.items():
        shown.add_row(path, *(format_quantity(v, UNITS[path], digits=4) for v in (own[path], value)))
    gap = result.gap
    shown.add_row("lower edge", "", f"{gap.lower / 1e3:.3f} ± {gap.lower_error / 1e3:.3f} kHz")
    shown.add_row("upper edge", "", f"{gap.upper / 1e3:.3f} ± {gap.upper_error / 1e3:.3f} kHz")
    shown.add_row("margin of the carrier", "", f"{result.margin / 1e3:.3f} kHz", style="bold")
    shown.add_row("held back by", "", ", ".join(result.held_back_by) or "no bound and no limit")
    return shown


def left_out(result: Design) -> list[str]:
    """A sentence for each design that could not be computed."""
    return [
        "left out: "
        + ", ".join(f"{path} = {format_quantity(v, UNITS[path])}" for path, v in one["values"].items())
        + f", since {one['cause']}"
        for one in result.left_out
    ]


def front_table(front: xr.Dataset) -> Table:
    """The widest gap of each pitch."""
    shown = Table(
        "pitch / mm", "from / kHz", "to / kHz", "width / kHz", title="widest gap around the carrier"
    )
    for i in range(front.sizes["design"]):
        row = front.isel(design=i)
        low, high = float(row["lower"]) / 1e3, float(row["upper"]) / 1e3
        held = float(row["margin"]) > 0  # NaN is not
        numbers = [f"{low:.2f}", f"{high:.2f}", f"{high - low:.2f}"] if held else ["-", "-", "none"]
        shown.add_row(f"{float(row['pitch']) * 1e3:.3g}", *numbers)
    return shown


def tolerance_table(result: Tolerance) -> Table:
    """What moves the edges."""
    shown = Table(
        "parameter", "lower edge", "upper edge", "index, lower", "index, upper", title="what moves the edges"
    )
    for row in result.to_json()["parameters"]:
        per = {"m": (1e-5, "10 µm"), "rad": (1.745e-3, "0.1°"), "Pa": (1e9, "GPa")}
        factor, word = per.get(UNITS[row["parameter"]], (0.01, "0.01"))
        if row["parameter"] == "material.density":
            factor, word = 10.0, "10 kg/m³"
        slopes = [f"{slope * factor:+.0f} Hz per {word}" for slope in row["slope_hz_per_si"]]
        shown.add_row(row["parameter"], *slopes, *(f"{index:.1%}" for index in row["total_index"]))
    return shown


def in_words(study: Study, result: Tolerance) -> str:
    """The chances as sentences."""
    section = study.tolerance_settings
    lower, upper = result.dataset["deviation"].values
    margin = f" with a margin of {section.margin:g} Hz" if section.margin else ""
    lines = [
        f"Edges vary by {lower:.0f} Hz (lower) and {upper:.0f} Hz (upper), one standard deviation.",
        f"One pillar keeps the carrier in its gap{margin} with a chance of {_chance(result.pillar)}, "
        f"all {section.pillars} of a plate with {_chance(result.plate)} "
        f"(to first order {_chance(float(result.dataset.attrs['chance_to_first_order']))}).",
    ]
    if result.loosest >= REACH:
        lines.append(f"Even {REACH:g} times as loose machining keeps {section.confidence:.1%}.")
    elif result.loosest > 0:
        lines.append(f"Machining may be {result.loosest:.2f} times as loose for {section.confidence:.1%}.")
    else:
        lines.append(f"No machining, however exact, keeps {section.confidence:.1%}.")
    return "\n".join(lines)


def _chance(value: float) -> str:
    """A chance in percent, as sure as some thousands of draws can be."""
    return "more than 99.99%" if value > 0.9999 else "less than 0.01%" if value < 1e-4 else f"{value:.2%}"
