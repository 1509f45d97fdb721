"""Commands about scans with a laser vibrometer: chirp, scan."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
import typer
from numpy.typing import NDArray

from haptonic import plots
from haptonic.cli.console import Voice, speaking
from haptonic.cli.options import Json, Out, Overwrite, StudyFile, folder_for, pictures, tell_where
from haptonic.cli.scan_tables import drive_table, tell_scan
from haptonic.cli.verdicts import tell_verdict, verdict_files, write_verdict
from haptonic.errors import ScanError, StudyError
from haptonic.paths import source
from haptonic.response import FrequencyResponse, read
from haptonic.results import refuse_taken, write_files
from haptonic.results.scan import Estimation, Excitation, OnPlate, ScanResult, compute_scan
from haptonic.store import Store, whole_set
from haptonic.study import Study, load, scanning
from haptonic.study.judging import judged
from haptonic.units import shown, to_si
from haptonic.vibrometry import read_scan
from haptonic.vibrometry.estimation.quality import check_flags

Array = NDArray[np.float64]

PROGRESS = "estimating"  # folder in which an estimation that was stopped goes on
ANIMATION = "shape.webp"


def chirp(study: StudyFile, out: Out = None, json: Json = False, overwrite: Overwrite = False) -> None:
    """The drive of a scan as WAV, CSV and HDF5, and the points in the order of the stage."""
    with speaking(json) as voice:
        loaded = load(study)
        folder = folder_for(study, out, json, "chirp")
        plate = loaded.mounted_plate() if loaded.finite_plate else None
        refuse_taken(folder, Excitation.file_names(plate), overwrite=overwrite)
        result = Excitation.of(loaded.scan_settings.frozen(), plate)
        if folder:
            with voice.busy("files"), whole_set(folder, overwrite=overwrite) as draft:
                write_files(draft, result.files(), overwrite=overwrite)
                for name, figure in result.figures().items():
                    plots.save(figure, draft, name)
        answer = result.to_json()
        voice.tell(drive_table(answer))
        tell_where(voice, folder)
        voice.answer(answer)


def scan(
    path: Annotated[
        Path, typer.Argument(metavar="PATH", help="Scan file, or a folder with one CSV a point.")
    ],
    study: Annotated[
        Path | None, typer.Argument(metavar="STUDY", help="Study of the plate that was scanned.")
    ] = None,
    against: Annotated[
        Path | None,
        typer.Option(
            "--against",
            metavar="MODEL",
            help="Judge the model as well: a study; or, after STUDY, the response (.nc) that it has given.",
        ),
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
    frequency_unit: Annotated[
        str | None,
        typer.Option("--frequency-unit", help='Of frequencies in files that give none, such as "kHz".'),
    ] = None,
    variables: Annotated[
        str | None,
        typer.Option(
            "--variables",
            metavar="MEANING=NAME,...",
            help="Names in a MATLAB file: response=FRF,frequency=fkHz,x=Xmm,y=Ymm.",
        ),
    ] = None,
    reference: Annotated[
        str | None, typer.Option("--reference", help='Name and unit of the reference, such as "A1, V".')
    ] = None,
    simulated: Annotated[bool, typer.Option("--simulated", help="The file is of a simulation.")] = False,
    overwrite: Overwrite = False,
) -> None:
    """Analyse a scan: responses, maps, contrast, the gap in it, waves; and how well a model fits."""
    kept = "the points that were estimated are kept; the same command goes on from there"
    with speaking(json, kept) as voice:
        path = source(path, "scan")
        loaded, computed = _model(study, against)
        folder = folder_for(path, out, json, "scan")
        refuse_taken(folder, _names(loaded, judging=against is not None), overwrite=overwrite)
        on = _on_plate(loaded, corners, mirrored, voice)
        how = Estimation(
            estimator, window, _time(decay, "--decay"), _time(segment, "--segment"), overlap, align,
            folder / PROGRESS if folder else None, _flags(repair),
        )  # fmt: skip
        with voice.busy("reading"):
            content = read_scan(
                path, unit=unit, reference=reference, origin="simulated" if simulated else "measured",
                length_unit=length_unit, frequency_unit=frequency_unit, variables=_named(variables),
            )  # fmt: skip
        frequency = None if at is None else to_si(at, "Hz", "--at")
        with voice.counted("points", content.report.points) as progress:
            result = compute_scan(
                content, how, on, at=frequency, store=Store.default(),
                progress=lambda done, total: progress(done, total, False),
            )  # fmt: skip
        found = None
        if loaded and against:
            with voice.busy("model") as said:
                found = judged(loaded, result.response, computed=computed, said=said)
        if folder:
            with voice.busy("files and pictures"), whole_set(folder, overwrite=overwrite) as draft:
                write_scan(result, draft, overwrite)
                if found:
                    write_verdict(found, draft, overwrite)
            _forget(folder / PROGRESS)
        tell_scan(result, voice)
        tell_where(voice, folder)
        answer = result.to_json()
        if found:
            tell_verdict(found, voice)
            answer["verdict"] = found.to_json()
        voice.answer(answer)


def write_scan(result: ScanResult, folder: Path, overwrite: bool) -> None:
    """Data, pictures and the animation of a scan."""
    write_files(folder, result.files(), overwrite=overwrite)
    for name, figure in result.figures().items():
        plots.save(figure, folder, name, overwrite=overwrite)
    if result.mapped:
        plots.animated(
            folder / ANIMATION, result.response, result.loudest, result.layout, overwrite=overwrite
        )


def _named(variables: str | None) -> dict[str, str]:
    """Names of variables by what they mean, as ``response=FRF,x=Xmm``.

    Raises
    ------
    ScanError : another form
    """
    pairs = [one.split("=") for one in variables.split(",")] if variables else []
    if any(len(pair) != 2 or not all(part.strip() for part in pair) for pair in pairs):
        raise ScanError(
            argument="--variables",
            given=shown(variables),
            allowed="MEANING=NAME, several of them parted by commas",
            cause="a sign of equality or a name is missing",
            next_step="write --variables response=FRF,frequency=f,x=X,y=Y",
        )
    return {meaning.strip(): name.strip() for meaning, name in pairs}


def _model(study: Path | None, against: Path | None) -> tuple[Study | None, FrequencyResponse | None]:
    """The study of the plate that was scanned, and what it has computed if that is compared with."""
    response = against is not None and against.suffix == ".nc"
    if response and study is None:
        raise ScanError(
            argument="--against", given=f"{against}, a response without its study",
            allowed="a study; or the study behind the scan, and here the response that it has given",
            cause="a response says neither where regions lie nor what may be fitted",
            next_step=f"haptonic scan PATH STUDY --against {against}",
        )  # fmt: skip
    if against and not response and study not in (None, against):
        raise ScanError(
            argument="--against", given=f"{against}, beside the study {study}",
            allowed="one study, or after a study the response (.nc) that it has given",
            cause="the study that is judged also says where on the plate the points lie",
            next_step="leave the study behind the scan out",
        )  # fmt: skip
    own = study if response else study or against
    return None if own is None else load(own), read(against) if response and against else None


def _names(study: Study | None, *, judging: bool) -> list[str]:
    """Of all files that a scan may give."""
    plate = study.mounted_plate() if study and study.finite_plate else None
    names = ["response.nc", "scan.nc", "points.csv", ANIMATION, *pictures(ScanResult.figure_names(plate))]
    return [*names, *verdict_files(bool(study.fit_settings.vary))] if study and judging else names


def _on_plate(study: Study | None, corners: str | None, mirrored: bool, voice: Voice) -> OnPlate | None:
    if study is None:
        if corners is not None or mirrored:
            raise ScanError(
                argument="--corners" if corners is not None else "--mirrored", given="no study",
                allowed="together with the study of a plate",
                cause="a scan is registered to the plate of a study",
                next_step="name the study behind the scan",
            )  # fmt: skip
        return None
    if study.finite_plate is None:
        raise StudyError(
            argument="plate", given="nothing", allowed="a study with a [plate]",
            cause="the study describes a lattice, and no plate that was scanned",
            next_step="add [plate], or leave the study out",
        )  # fmt: skip
    with voice.busy("the lattice's gap"):
        return scanning.scanned(study, _places(corners), mirrored=mirrored)


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
