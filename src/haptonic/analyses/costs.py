"""Forecasts of what analyses need, from those of meshes and plates; one line for each that may take long.

The numbers are processor seconds that the templates took, on the machine of the benchmarks.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from haptonic.analyses.export import ExportOptions
from haptonic.analyses.needs import has_mirror, has_plate, need_rows
from haptonic.bloch.mirrors import MOST_ROWS
from haptonic.bloch.resolution import started
from haptonic.design.quick import QUICK
from haptonic.plate.forecast import Counted
from haptonic.plate.parts import Plate
from haptonic.plate.settings import ResponseSettings
from haptonic.results.cost import BASE, Cost
from haptonic.study.loading import load_as
from haptonic.study.schema import Description
from haptonic.vibrometry.of_settings import plan_for

FIRST, SECOND = 0.5, 0.25  # of what meshes are foreseen to take at most: the second is not always needed
ZONE = 0.2  # s, of the search for gaps
DIAGRAM, PER_WAVEVECTOR = 2.5, 0.02  # s, of names, shapes and counts; of ten bands
SURFACE = 6.0  # s, of the whole zone
# of what one mesh is foreseen to take, for a design that a search sees: twenty drawn searches of squares took
# 0.15 to 0.4 s, those of honeycomb and kagome cells 1.0 and 0.8 s
QUICK_DESIGN = 0.19
REFINED = 6  # designs that a search computes as exactly as asked for
MIRROR, SQUARE_FACE = 0.035, 72  # s of a row at a frequency, where so many unknowns are on a face
GUIDES, SAMPLE = 2.0, 0.6  # s, of a design beside the study's own
COLUMN, BULK = 0.17, 0.2  # s of a column of a ribbon at a wavevector, where it has one tile; of a crystal
REPORT = 30.0  # s, of pictures and of the twins of a scan and of trials
DRIVE = 2.0  # s, of a drive's files and pictures
POWER = 3.0  # s, of simulated experiments
FILM, STROKE = 3.0, 0.006  # s, of load sharing; of a stroke that is made up and written
FILES = 3.0  # s, of outlines, solids and the drawing of a cell
PER_FACE, BYTES_OF_FACE = 1e-3, 6e4  # s and B, of a face of a solid
PER_PAIR = 1.5e-7  # s, of two of them
DRAWN = 0.04  # s, of a pillar on the drawing of a plate
RECORDED = 0.008  # s, of a point that is made up and written
ANALYSED, BYTE_OF_SCAN = 4.0, 5e-8  # s, of maps and pictures; of a byte that is read and estimated
TESTED, BYTE_OF_TRIALS = 4.0, 6e-8  # s, of statistics and pictures; of a byte that is read and filtered
HELD = 4.0  # of a file in memory at once, times its size
FITTED = 0.2  # of the plate's response, for every number that is fitted


def meshes(study: Description, second: float = SECOND) -> Cost:
    """Of the models of a cell: the first that is tried, and a share of the next."""
    cell, settings = study.cell, study.bands_settings
    chosen = settings.resolution
    tried = [chosen] if chosen else started(cell, settings.count, settings.accuracy)
    seconds = FIRST * tried[0].seconds(cell) + second * sum(one.seconds(cell) for one in tried[1:])
    return Cost(seconds, max(one.memory(cell) for one in tried))


def gaps(study: Description) -> Cost:
    """Of the complete gaps of the study's cell, for which the first mesh is mostly enough."""
    return meshes(study, second=0.0) + Cost(ZONE)


def bands(study: Description, options: Any) -> Cost:
    """Of `haptonic bands`."""
    surface = SURFACE if getattr(options, "surface", False) else 0.0
    return meshes(study) + Cost(DIAGRAM + PER_WAVEVECTOR * study.bands_settings.points + surface)


def sweep(study: Description, options: Any) -> Cost:
    """Of all designs of all rows."""
    return gaps(study).times(sum(one.steps for one in study.sweep_settings))


def layers(study: Description, options: Any) -> Cost:
    """Of a mirror's spectra."""
    settings = study.layers_settings
    on_face, memory = need_rows(study)
    each = MIRROR * (on_face / SQUARE_FACE) ** 2.5
    return gaps(study) + Cost(each * (settings.count * settings.points + MOST_ROWS), BASE + memory)


def waveguide(study: Description, options: Any) -> Cost:
    """Of the guides that are compared."""
    on_face, memory = need_rows(study, "waveguide")
    return gaps(study) + Cost(GUIDES * max(1.0, on_face / SQUARE_FACE) ** 2.5, BASE + memory)


def ribbon(study: Description, options: Any) -> Cost:
    """Of the modes of a ribbon at each wavevector, and of the bulk bands of its crystals."""
    section = study.ribbon_settings
    assert section is not None
    made = section.ribbon(study.cell)
    tiles = max(len(cell.tiles) for cell in made.cells) * len(made.lines)
    each = Cost(COLUMN * tiles**2 * len(made.first) + BULK * len(made.crystals) * len(made.lines))
    return meshes(study).times(max(1, len(made.cells))) + each.times(section.rows or section.wavevectors)


def design(study: Description, options: Any) -> Cost:
    """Of a search; more where the carrier is hard to reach."""
    section = study.design_settings
    seen = section.starts + section.climbs * section.steps
    once = Cost(QUICK_DESIGN * QUICK.seconds(study.cell) * seen) + gaps(study).times(REFINED)
    return once.times(1 + section.pitches / 2) if getattr(options, "pareto", False) else once


def tolerance(study: Description, options: Any) -> Cost:
    """Of the designs that spreads lead to."""
    return gaps(study) + Cost(SAMPLE * study.tolerance_settings.samples)


def plate(study: Description, options: Any) -> Cost:
    """Of a plate's response, and of its lattice's gap."""
    mounted = study.mounted_plate()  # says what is missing where there is none
    assert study.finite_plate is not None
    asked, at = study.finite_plate.response, getattr(options, "at", None)
    if at is not None:
        return response(mounted, asked.single(at))
    return gaps(study) + response(mounted, asked)


def response(mounted: Plate, asked: ResponseSettings) -> Cost:
    """Of a plate."""
    counted = Counted.of(mounted, asked)
    return Cost(counted.seconds, counted.memory)


def reproduce(study: Description, options: Any) -> Cost:
    """Of every analysis in the report."""
    total = bands(study, options) + Cost(SURFACE + (REPORT if has_plate(study) else 0.0))
    for name in ("sweep", "layers", "waveguide", "ribbon", "plate"):
        if FORECASTS[name].when(study):
            total += FORECASTS[name].cost(study, options)
    return total


def export(study: Description, options: Any) -> Cost:
    """Of the files; of the tolerances in a drawing where the study gives spreads."""
    asked = options or ExportOptions()
    part, total = asked.part(study), Cost(FILES)
    if "step" in asked.kinds:
        total += Cost(PER_FACE * part.faces + PER_PAIR * part.faces**2, BASE + BYTES_OF_FACE * part.faces)
    if "drawing" in asked.kinds:
        total += Cost(DRAWN * part.pillars)
        if study.carrier and study.tolerance_settings.of:
            total += tolerance(study, None)
    return total


def simulate_friction(study: Description, options: Any) -> Cost:
    """Of every stroke."""
    asked = study.protocol_settings
    people = getattr(options, "participants", None) or asked.participants
    return Cost(FILM + STROKE * people * asked.blocks * asked.trials)


def simulate_scan(study: Description, options: Any) -> Cost:
    """Of the plate's response in the band of the drive, if it is not given, and of every point."""
    mounted, asked = study.mounted_plate(), study.scan_settings
    made = Cost(RECORDED * len(plan_for(asked, mounted).points))
    if getattr(options, "response", None) is not None:
        return made
    lines = ResponseSettings(
        lowest=asked.lowest, highest=asked.highest, points=round(asked.lines), grid=asked.grid
    )
    return response(mounted, lines) + gaps(study) + made


def verdict(study: Description, options: Any) -> Cost:
    """Of the response that is compared, if it is not given, and of the fits."""
    numbers = len(study.fit_settings.vary)
    computed = 0.0 if getattr(options, "computed", None) is not None else 1.0
    return plate(study, None).times(computed + (1.0 + FITTED * numbers if numbers else 0.0))


def scan(study: Description | None, options: Any) -> Cost:
    """Of what is read, and of the verdict on a model."""
    size = _size(options.path)
    read = Cost(ANALYSED + BYTE_OF_SCAN * size, BASE + HELD * size)
    if options.model_is_a_study:
        return read + verdict(load_as(options.against, Description), None)
    return read + (verdict(study, options) if study is not None and options.against else Cost(0.0))


def friction(study: None, options: Any) -> Cost:
    """Of what is read."""
    return Cost(TESTED + BYTE_OF_TRIALS * _size(options.path))


def _size(path: Path) -> int:
    """Of a file, or of all in a folder, bytes."""
    files = path.rglob("*") if path.is_dir() else [path]
    return sum(one.stat().st_size for one in files if one.is_file())


@dataclass(frozen=True)
class Forecast:
    """cost : takes study and options; when : whether a study gives all that the analysis needs."""

    cost: Callable[[Description, Any], Cost]
    when: Callable[[Description], Any] = lambda study: True


FORECASTS = {
    "bands": Forecast(bands),
    "sweep": Forecast(sweep, lambda study: study.sweep_settings),
    "reproduce": Forecast(reproduce),
    "layers": Forecast(layers, has_mirror),
    "waveguide": Forecast(waveguide, has_mirror),
    "ribbon": Forecast(ribbon, lambda study: study.ribbon_settings),
    "design": Forecast(design, lambda study: study.carrier and study.design_settings.vary),
    "tolerance": Forecast(tolerance, lambda study: study.carrier and study.tolerance_settings.of),
    "plate": Forecast(plate, has_plate),
    "feel": Forecast(plate, has_plate),
}
# of every analysis by name; a plan does not tell the last: they take seconds, or what they take depends on
# a file
COSTS: dict[str, Callable[[Any, Any], Cost]] = {
    **{name: one.cost for name, one in FORECASTS.items()},
    "export": export,
    "chirp": lambda study, options: Cost(DRIVE),
    "protocol": lambda study, options: Cost(POWER),
    "simulate friction": simulate_friction,
    "simulate scan": simulate_scan,
    "scan": scan,
    "friction": friction,
    "verdict": verdict,
}
