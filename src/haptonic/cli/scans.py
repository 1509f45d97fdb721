"""Commands about scans with a laser vibrometer: chirp, scan."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
import typer
from numpy.typing import NDArray
from rich.table import Table

from haptonic import plots
from haptonic.cli.console import Voice, speaking
from haptonic.cli.options import Json, Out, Overwrite, StudyFile, folder_for, pictures, tell_where
from haptonic.errors import ScanError, StudyError
from haptonic.plate import Plate
from haptonic.results import refuse_taken, write_files
from haptonic.results.scan import Estimation, Excitation, OnPlate, ScanResult, compute_scan
from haptonic.store import Store
from haptonic.study import load, scanning
from haptonic.units import to_si
from haptonic.vibrometry import Edge, read_scan
from haptonic.vibrometry.estimation.quality import check_flags

Array = NDArray[np.float64]

PROGRESS = "estimating"  # folder in which an estimation that was stopped goes on
ANIMATION = "shape.webp"


def chirp(study: StudyFile, out: Out = None, json: Json = False, overwrite: Overwrite = False) -> None:
    """The drive of a scan as WAV, CSV and HDF5, and the points in the order of the stage."""
    with speaking(json) as voice:
        loaded = load(study)
        folder = folder_for(study, out, json, "chirp")
        plate = loaded.plate() if loaded.plate_section else None
        refuse_taken(folder, Excitation.file_names(plate), overwrite=overwrite)
        result = Excitation.of(loaded.scan.frozen(), plate)
        if folder:
            with voice.busy("files"):
                write_files(folder, result.files(), overwrite=overwrite)
                for name, figure in result.figures().items():
                    plots.save(figure, folder, name, overwrite=overwrite)
        answer = result.to_json()
        voice.tell(drive_table(answer))
        tell_where(voice, folder)
        voice.answer(answer)


def scan(
    path: Annotated[
        Path, typer.Argument(metavar="PATH", help="Scan file, or a folder with one CSV a point.")
    ],
    study: Annotated[
        Path | None, typer.Argument(metavar="[STUDY]", help="Study of the plate that was scanned.")
    ] = None,
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="DIR", help="Folder for the files; results/PATH-scan by default."),
    ] = None,
    json: Json = False,
    estimator: Annotated[
        Literal["H1", "H2", "Hv"],
        typer.Option("--estimator", help="H1 for noise on the response, a laser's."),
    ] = "H1",
    window: Annotated[
        Literal["none", "hann", "exponential"],
        typer.Option("--window", help="none for periodic chirps, exponential for bursts, hann for noise."),
    ] = "none",
    decay: Annotated[
        str | None, typer.Option("--decay", metavar="TIME", help='Of the exponential window, such as "5 ms".')
    ] = None,
    segment: Annotated[
        str | None,
        typer.Option(
            "--segment", metavar="TIME", help="One transform; else the study's period, or a record."
        ),
    ] = None,
    overlap: Annotated[float, typer.Option("--overlap", help="Of segments, from 0 to below 1.")] = 0.0,
    align: Annotated[bool, typer.Option("--align", help="Align records by their reference.")] = False,
    repair: Annotated[
        str,
        typer.Option(
            "--repair", metavar="FLAGS", help='Replace points, such as "dropout,saturated"; marked.'
        ),
    ] = "",
    at: Annotated[
        str | None,
        typer.Option("--at", metavar="FREQUENCY", help="Of the operating shape; else the loudest."),
    ] = None,
    corners: Annotated[
        str | None,
        typer.Option(
            "--corners",
            metavar="PLACES",
            help="The plate's corners as the scan has them, from the lower left anticlockwise: "
            '"0 0 127 0 127 140 0 140 mm".',
        ),
    ] = None,
    mirrored: Annotated[
        bool, typer.Option("--mirrored", help="The scan saw the plate's map from behind.")
    ] = False,
    unit: Annotated[
        str, typer.Option("--unit", help="Of responses or records in files that give none.")
    ] = "m/s/V",
    length_unit: Annotated[
        str | None,
        typer.Option("--length-unit", help='Of coordinates, where it is not the file\'s, such as "mm".'),
    ] = None,
    reference: Annotated[
        str | None, typer.Option("--reference", help='Name and unit of the reference, such as "A1, V".')
    ] = None,
    simulated: Annotated[bool, typer.Option("--simulated", help="The file is of a simulation.")] = False,
    overwrite: Overwrite = False,
) -> None:
    """What a scan tells: responses, maps, contrast, the gap in it, waves, decay, bad points."""
    kept = "the points that were estimated are kept; the same command goes on from there"
    with speaking(json, kept) as voice:
        plate, on = _on_plate(study, corners, mirrored, voice)
        folder = folder_for(path, out, json, "scan")
        names = ["response.nc", "scan.nc", "points.csv", ANIMATION, *pictures(ScanResult.figure_names(plate))]
        refuse_taken(folder, names, overwrite=overwrite)
        how = Estimation(
            estimator, window, _time(decay, "--decay"), _time(segment, "--segment"), overlap, align,
            folder / PROGRESS if folder else None, _flags(repair),
        )  # fmt: skip
        with voice.busy("reading"):
            content = read_scan(
                path, unit=unit, reference=reference, origin="simulated" if simulated else "measured",
                length_unit=None if length_unit is None else to_si(f"1 {length_unit}", "m", "--length-unit"),
            )  # fmt: skip
        frequency = None if at is None else to_si(at, "Hz", "--at")
        with voice.counted("points", content.report.points) as progress:
            result = compute_scan(
                content, how, on, at=frequency, store=Store.default(),
                progress=lambda done, total: progress(done, total, False),
            )  # fmt: skip
        if folder:
            with voice.busy("files and pictures"):
                write_scan(result, folder, overwrite)
            _forget(folder / PROGRESS)
        _speak(result, voice)
        tell_where(voice, folder)
        voice.answer(result.to_json())


def write_scan(result: ScanResult, folder: Path, overwrite: bool) -> None:
    """Data, pictures and the animation of a scan."""
    write_files(folder, result.files(), overwrite=overwrite)
    for name, figure in result.figures().items():
        plots.save(figure, folder, name, overwrite=overwrite)
    if result.on_grid:
        plots.animated(
            folder / ANIMATION, result.response, result.loudest, result.layout, overwrite=overwrite
        )


def _on_plate(
    study: Path | None, corners: str | None, mirrored: bool, voice: Voice
) -> tuple[Plate | None, OnPlate | None]:
    if study is None:
        if corners is not None or mirrored:
            raise ScanError(
                argument="--corners" if corners is not None else "--mirrored", given="no study",
                allowed="together with the study of a plate",
                cause="a scan is registered to the plate of a study",
                next_step="name the study behind the scan",
            )  # fmt: skip
        return None, None
    loaded = load(study)
    if loaded.plate_section is None:
        raise StudyError(
            argument="plate", given="nothing", allowed="a study with a [plate]",
            cause="the study describes a lattice, and no plate that was scanned",
            next_step="add [plate], or leave the study out",
        )  # fmt: skip
    with voice.busy("the lattice's gap"):
        on = scanning.scanned(loaded, _places(corners), mirrored=mirrored)
    return on.plate, on


def _places(text: str | None) -> Array | None:
    """Four corners written as eight numbers and a unit."""
    if text is None:
        return None
    *numbers, unit = re.split(r"[\s,;]+", text.strip()) or [""]
    if len(numbers) != 8:
        raise ScanError(
            argument="--corners",
            given=f'"{text}"',
            allowed='eight numbers and a unit of length, such as "0 0 127 0 127 140 0 140 mm"',
            cause="a number is missing, or the unit",
            next_step="give x and y of the four corners, from the lower left one anticlockwise",
        )
    return np.array([to_si(f"{number} {unit}", "m", "--corners") for number in numbers]).reshape(4, 2)


def _time(text: str | None, argument: str) -> float | None:
    return None if text is None else to_si(text, "s", argument)


def _flags(text: str) -> tuple[str, ...]:
    names = tuple(name for part in text.split(",") if (name := part.strip()))
    check_flags(names)
    return names


def _forget(folder: Path) -> None:
    """Remove what an estimation kept, now that it is done."""
    for file in folder.glob("*") if folder.is_dir() else ():
        file.unlink()
    if folder.is_dir():
        folder.rmdir()


def _speak(result: ScanResult, voice: Voice) -> None:
    if not result.report.complete or result.report.remarks:
        voice.tell(str(result.report))
    for text in result.told:
        voice.warn(text)
    told = result.to_json()
    flags = ", ".join(f"{count} {flag}" for flag, count in told["flags"].items() if count) or "none flagged"
    voice.tell(
        f"{told['points']} points ({flags}), {told['lines']} lines from {told['band_hz'][0] / 1e3:.4g} to "
        f"{told['band_hz'][1] / 1e3:.4g} kHz, {result.origin}."
    )
    if result.registration is not None:
        found = result.registration
        x, y = 1e3 * found.shift
        voice.tell(
            f"Registered: scale {found.scale:.5f}, turned by {np.degrees(found.angle):.3f}°, shifted by "
            f"{x:.3f} and {y:.3f} mm; misfit {found.misfit * 1e3:.3f} mm."
        )
    if result.lattice is not None:
        computed = (
            f"; computed {result.gap.lower / 1e3:.2f} to {result.gap.upper / 1e3:.2f} kHz"
            if result.gap
            else ""
        )
        lower, upper = _edge(result.lattice.lower), _edge(result.lattice.upper)
        voice.tell(f"Gap in the scan: lower edge {lower}, upper edge {upper}{computed}.")
        for text in result.lattice.reasons:
            voice.tell(f"  {text}")
    if result.measured is not None:
        seen = result.measured
        voice.tell(
            f"The driven region stands out from the lattice from {seen.lower / 1e3:.2f} ± "
            f"{seen.lower_error / 1e3:.2f} to {seen.upper / 1e3:.2f} ± {seen.upper_error / 1e3:.2f} kHz."
        )
    voice.tell(shapes_table(result))


def _edge(edge: Edge | None) -> str:
    return f"{edge.frequency / 1e3:.2f} ± {edge.error / 1e3:.2f} kHz" if edge else "not told"


def shapes_table(result: ScanResult) -> Table:
    """Velocities, contrasts and decay at the frequencies of the operating shapes."""
    lines = [result.told_at(frequency) for frequency in result.shapes]
    table = Table(
        "operating shape", *(f"{line['frequency_hz'] / 1e3:.3f} kHz" for line in lines), title=result.origin
    )
    rows: dict[str, list[str]] = {
        f"rms / ({result.response.units})": [f"{line['rms_of_all']:.3g}" for line in lines]
    }
    for name in lines[0]["rms"]:
        rows[f"rms of {name}"] = [_number(line["rms"][name], ".3g") for line in lines]
    for name in lines[0]["contrast_db"]:
        rows[f"{name} / dB"] = [_number(line["contrast_db"][name], ".1f") for line in lines]
    decays = [line.get("decay_db_per_cell", {}) for line in lines]
    if any(decays):
        rows["decay / (dB/cell)"] = [
            f"{d['decay']:.1f} ({d['low']:.1f} to {d['high']:.1f})" if d else "" for d in decays
        ]
        rows["computed"] = [
            f"{d['computed_least']:.1f} to {d['computed_largest']:.1f}" if "computed_least" in d else ""
            for d in decays
        ]
    for name, cells in rows.items():
        table.add_row(name, *cells)
    return table


def _number(value: float | None, form: str) -> str:
    return "-" if value is None else format(value, form)


def drive_table(answer: dict[str, object]) -> Table:
    """A drive and a plan as a person reads them."""
    table = Table("", "", title="excitation", show_header=False)
    numbers = {name: float(str(value)) for name, value in answer.items() if isinstance(value, int | float)}
    table.add_row("band", f"{numbers['low'] / 1e3:.5g} to {numbers['high'] / 1e3:.5g} kHz")
    table.add_row("lines", f"{numbers['lines']:.0f}, {numbers['line_spacing_hz']:.4g} Hz apart")
    table.add_row(
        "period", f"{numbers['duration_s'] * 1e3:.4g} ms, {numbers['averages']:.0f} recorded at each point"
    )
    table.add_row("sample rate", f"{numbers['sample_rate'] / 1e3:.5g} kHz")
    table.add_row(
        "largest voltage", f"{numbers['full_scale']:.4g} V, crest factor {numbers['crest_factor']:.3f}"
    )
    plan = answer["plan"]
    if isinstance(plan, dict):
        table.add_row("points", f"{plan['points']}, {plan['left_out']} left out")
        table.add_row("way", f"{plan['travel_m']:.3g} m, {plan['measuring_s']:.0f} s of recording")
    return table
