"""The command that does all of a study: reproduce."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager
from datetime import UTC, datetime
from pathlib import Path
from tempfile import TemporaryDirectory

import xarray as xr

from haptonic import report
from haptonic.cli.console import Voice, speaking
from haptonic.cli.feeling import FEEL_FILES, write_feel
from haptonic.cli.lattices import gap_table, swept, tell_failures, write_bands, write_sweep
from haptonic.cli.mirrors import LAYER_FILES, write_layers
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
)
from haptonic.cli.plates import plate_files, write_plate
from haptonic.errors import FrictionError, ScanError, StudyError
from haptonic.friction.recordings import Sensor
from haptonic.friction.statistics import Alarms, Population, false_alarms
from haptonic.report import Results, paper
from haptonic.report.guide_shifts import guide_shifts
from haptonic.results import (
    Bands,
    Feel,
    FrictionResult,
    Guides,
    Layers,
    PlateResult,
    Runner,
    compute_friction,
    friction_twin,
    layer_tasks,
    refuse_taken,
)
from haptonic.results.scan import ScanResult
from haptonic.store import Store, whole_set
from haptonic.study import Study, load, scanning
from haptonic.study.experimenting import protocol_of, truth_of

ALARMS = 400  # simulated experiments without an effect


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
        sweeps = [f"sweep_{i + 1}" for i in range(len(loaded.sweep_settings))]
        refuse_taken(folder, _names(loaded, sweeps), overwrite=overwrite)
        started, timings = datetime.now(UTC), dict[str, float]()
        with _timed(timings, "bands, zone and modes"), voice.busy("bands, zone and modes"):
            bands = loaded.bands(surface=True)
        with _timed(timings, "sweeps", loaded.sweep_settings):
            rows = swept(loaded, voice, workers, scheduler)
        with _timed(timings, "mirror and waveguide", _has_mirror(loaded)):
            mirror, guides = _mirror(loaded, voice, workers, scheduler)
        with _timed(timings, "plate", _has_plate(loaded)):
            plate, shifts = _plate(loaded, voice)
        with _timed(timings, "twin of a scan", plate):
            scan = _scanned(loaded, plate, voice) if plate else None
        with _timed(timings, "what a finger feels", _has_plate(loaded)):
            felt = _felt(loaded, voice)
        with _timed(timings, "made-up trials", felt):
            trials = _tried(loaded, felt, voice) if felt else None
            alarms = _alarms(loaded, voice) if trials else {}
        filleted = None
        if paper.is_its_cell(loaded):
            with voice.busy("the paper's cell with a fillet"):
                filleted = loaded.gap_with({"cell.pillar.fillet": paper.TRIED_FILLET})
        with voice.busy("pictures and report"), whole_set(folder, overwrite=overwrite) as draft:
            write_bands(bands, draft, overwrite)
            for name, one in zip(sweeps, rows, strict=True):
                write_sweep(one, draft, name, overwrite)
            if mirror:
                write_layers(mirror, draft, overwrite)
            if plate:
                write_plate(plate, draft, overwrite)
            if felt:
                write_feel(felt, draft, overwrite)
            results = Results(
                loaded,
                bands.dataset,
                sweeps=tuple(one.dataset for one in rows),
                layers=mirror,
                guides=guides,
                plate=plate,
                scan=scan,
                feel=felt,
                trials=trials,
                alarms=alarms,
                guide_shifts=shifts,
                filleted=filleted,
                timings=timings,
                started=started,
            )
            report.write_report(results, draft / "report.html")
        page = folder / "report.html"
        voice.tell(gap_table(bands))
        for one in rows:
            tell_failures(voice, one)
        voice.tell(f"report: {page}")
        answer = {"report": str(page), "seconds": timings, "sweeps": [one.to_json() for one in rows]}
        voice.answer({**bands.to_json(), **answer})


def _names(loaded: Study, sweeps: list[str]) -> list[str]:
    """Of all files that will be written."""
    names = [*Bands.FILES, *pictures([*Bands.figure_names(surface=True), *sweeps])]
    names += ["report.html", *(f"{name}.nc" for name in sweeps)]
    if _has_mirror(loaded):
        names += LAYER_FILES
    if _has_plate(loaded):
        names += [*plate_files(loaded.mounted_plate()), *FEEL_FILES]
    return names


@contextmanager
def _timed(timings: dict[str, float], part: str, wanted: object = True) -> Iterator[None]:
    """Note the seconds of a part of the run, if there is such a part."""
    clock = time.perf_counter()
    yield
    if wanted:
        timings[part] = time.perf_counter() - clock


def _plate(loaded: Study, voice: Voice) -> tuple[PlateResult | None, xr.Dataset | None]:
    """The finite plate, and what moves the mode of its guides if it is the paper's."""
    if not _has_plate(loaded):
        return None, None
    with voice.counted("plate", 0) as progress:
        result = loaded.vibrating(on_progress=progress)
    if not (paper.is_its_cell(loaded) and result.plate.actuators):
        return result, None
    with voice.busy("what moves the mode of the guides"):
        return result, guide_shifts(loaded, Store.default())


def _scanned(loaded: Study, plate: PlateResult, voice: Voice) -> ScanResult | None:
    """What a scan of the computed plate by a twin of the instrument tells."""
    try:
        with voice.counted("twin of a scan", 0) as progress:
            return scanning.rescanned(loaded, plate, progress=lambda done, all_: progress(done, all_, False))
    except (ScanError, StudyError) as error:
        voice.warn(f"no scan was made up: {error.cause}")
        return None


def _felt(loaded: Study, voice: Voice) -> Feel | None:
    """What a finger feels of the plate, if there is one."""
    if not _has_plate(loaded):
        return None
    with voice.counted("what a finger feels", 0) as progress:
        return loaded.felt(on_progress=progress)


def _tried(loaded: Study, felt: Feel, voice: Voice) -> FrictionResult | None:
    """Trials of made-up people on the plate as it is computed, analysed like measured ones."""
    try:
        protocol = protocol_of(loaded)
        truth = truth_of(loaded, {name: felt.amplitude(name) for name in felt.regions})
    except (StudyError, FrictionError) as error:
        voice.warn(f"no trials were made up: {error.cause}")
        return None
    count = loaded.protocol_settings.participants
    made = friction_twin(truth, protocol, count, seed=0, study=loaded.to_toml(), suffix=".h5", per="block")
    with TemporaryDirectory() as name:
        folder, section = Path(name), loaded.trials
        with voice.counted("made-up strokes", count * protocol.blocks * protocol.trials) as progress:
            made.write(folder, progress)
        with voice.counted("their analysis", 0) as progress:
            return compute_friction(folder, Sensor(), section, driven=protocol.waveguides[0], told=progress)


def _alarms(loaded: Study, voice: Voice) -> dict[str, Alarms]:
    """How often each test cries wolf in trials like those of the study."""
    section, people = loaded.protocol_settings, loaded.participants
    if section.participants < 2:
        return {}
    population = Population(0.0, people.effect_between, people.within, people.between)
    each = section.blocks * section.trials // 4
    with voice.busy("false alarms of the tests"):
        return false_alarms(population, section.participants, each, simulations=ALARMS)


def _has_plate(loaded: Study) -> bool:
    """Whether a finite plate can be asked for."""
    return loaded.finite_plate is not None and loaded.carrier is not None


def _has_mirror(loaded: Study) -> bool:
    """Whether a mirror can be asked for: there is a carrier, and something that reflects."""
    return loaded.carrier is not None and loaded.cell.pillar is not None


def _mirror(
    loaded: Study, voice: Voice, workers: int, scheduler: str | None
) -> tuple[Layers | None, Guides | None]:
    """Layers and waveguides for the report, the latter if the gap holds the carrier."""
    if not _has_mirror(loaded):
        return None, None
    with voice.counted("mirror", layer_tasks(loaded.layers_settings.points)) as progress:
        layered = loaded.layered(Runner(Store.default(), workers, scheduler, progress))
    try:
        with voice.busy("waveguide"):
            return layered, loaded.guided()
    except StudyError as error:
        voice.warn(f"no waveguide: {error.cause}")
        return layered, None
