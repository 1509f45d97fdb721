"""The command about people who touch the plate: friction."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated, TypeVar

import typer
from rich.table import Table

from haptonic import plots, report
from haptonic.cli.console import Voice, speaking
from haptonic.cli.options import Json, Out, Overwrite, Workers, folder_for, pictures, tell_where
from haptonic.friction.lubrication import WEBER_FRACTION
from haptonic.friction.recordings import Sensor
from haptonic.friction.signals.record import EVERYBODY
from haptonic.friction.statistics import Estimate, Test
from haptonic.friction.statistics.summary import Condition
from haptonic.friction.words import averages, change
from haptonic.paths import source
from haptonic.report import paper
from haptonic.results import FrictionResult, compute_friction, refuse_taken, write_files
from haptonic.results.plate.question import driven_region
from haptonic.store import whole_set
from haptonic.study import Study, Trials, load_trials

STUDY = "study.toml"  # beside the trials
QUALITY = "quality.html"
MOST_SHOWN = 12  # participants whose rows are printed

Row = TypeVar("Row", Condition, Test)


def friction(
    path: Annotated[
        Path, typer.Argument(metavar="PATH", help="Folder with trials.csv, or a single table of all samples.")
    ],
    study: Annotated[
        Path | None,
        typer.Option("--study", metavar="FILE", help="Its [trials] decides; else study.toml in the folder."),
    ] = None,
    out: Out = None,
    json: Json = False,
    workers: Workers = 0,
    overwrite: Overwrite = False,
) -> None:
    """Coefficients of friction from force records, and what they prove."""
    with speaking(json) as voice:
        path = source(path, "folder of trials")
        section, loaded = _asked(path, study)
        sensor = section.sensor.frozen(path) if path.is_dir() else Sensor()
        folder = folder_for(path.absolute(), out, json, "friction")
        names = [*FrictionResult.FILES, QUALITY, *pictures(FrictionResult.FIGURES)]
        refuse_taken(folder, names, overwrite=overwrite)
        with voice.counted("trials", 0) as progress:
            result = compute_friction(
                path,
                sensor,
                section,
                section.exclude,
                driven=section.driven or _driven(loaded),
                workers=workers,
                told=progress,
            )
        if folder:
            known = loaded is not None and paper.is_its_cell(loaded)
            with whole_set(folder, overwrite=overwrite) as draft:
                _write(result, draft, overwrite, voice, paper.FRICTION if known else None)
        _tell(result, voice)
        tell_where(voice, folder)
        voice.answer(result.to_json())


def _asked(path: Path, study: Path | None) -> tuple[Trials, Study | None]:
    beside = path / STUDY
    if study is None and not beside.is_file():
        return Trials(), None
    return load_trials(study or beside)


def _driven(loaded: Study | None) -> str | None:
    """The waveguide that a whole study drives."""
    return driven_region(loaded.mounted_plate()) if loaded is not None and loaded.finite_plate else None


def _write(
    result: FrictionResult, folder: Path, overwrite: bool, voice: Voice, published: Mapping[str, float] | None
) -> None:
    write_files(folder, result.files(), overwrite=overwrite)
    for name, figure in result.figures(published=published).items():
        plots.save(figure, folder, name, overwrite=overwrite)
    with voice.counted("sheets", 0) as progress:
        writers = {QUALITY: lambda file: report.write_quality(result, file, progress)}
        write_files(folder, writers, overwrite=overwrite)


def _tell(result: FrictionResult, voice: Voice) -> None:
    found = result.found
    for text in result.remarks:
        voice.tell(f"guessed: {text}")
    if result.excluded:
        voice.tell(excluded_table(result))
    else:
        voice.tell(f"{result.trials.sizes['stroke']} trials, none of them left out")
    voice.tell(conditions_table(result))
    for table in tests_tables(result):
        voice.tell(table)
    for text in notes_of((*found.tests, *found.each)):
        voice.tell(text)
    for text in found.conclusions:
        voice.tell(text)
    for guide, one in found.reductions.items():
        note = f" ({one.note})" if one.note else ", 95 % interval" * math.isfinite(one.low)
        voice.tell(f"{guide}: {change(one.value, one.low, one.high, digits=1)}{note}.")
    if found.driven:
        voice.tell(f"Driven: {found.driven}, {found.chosen}.")
    for guide, one in found.stopped.items():
        voice.tell(f"Share of the reduction that does not reach {guide}: {_percent(one)}.")
        voice.tell(f"The same by bootstrap: {_percent(found.stopped_here[guide])}.")
    for same in found.equivalences:
        proof = same.note or (
            f"90 % interval {same.low:.1%} to {same.high:.1%}; one-sided test against the "
            f"{WEBER_FRACTION:.0%} that people feel: p = {same.p_above:.2g}"
        )
        voice.tell(f"{same.waveguide}, idle: reduction {same.mean:.1%} as the mean of participants; {proof}.")
    if found.equivalences:
        voice.tell(averages())
    if found.drift:
        voice.tell(f"Drift over a session with the vibration off: {_percent(found.drift)}.")
    for text in found.omissions:
        voice.warn(text)
    if result.origin == "simulated":
        voice.tell("Simulated: these trials were made up; nobody was measured.")


def excluded_table(result: FrictionResult) -> Table:
    """How many trials do not count, by reason, with the first of each."""
    total, trials = result.trials.sizes["stroke"], result.trials
    left_out = sum(result.excluded.values())
    table = Table("reason", "trials", "the first", title=f"{total} trials, {left_out} of them left out")
    for reason, count in result.excluded.items():
        row = trials["excluded"].values.tolist().index(reason)
        first = " ".join(f"{name} {trials[name].values[row]}" for name in ("participant", "block", "trial"))
        detail = str(trials["detail"].values[row])
        table.add_row(reason, str(count), f"{first}: {detail}" if detail else first)
    return table


def conditions_table(result: FrictionResult) -> Table:
    """Every condition of every participant: mean and standard deviation over trials."""
    table = Table(
        "who", "where", "", "trials", "left out", "mean of ratios", "ratio of means", "force / N", "mm/s",
        title="friction of each condition: mean ± standard deviation over trials",
    )  # fmt: skip
    for one in _few(result, result.found.conditions):
        fast = one.speed[0] * 1e3, one.speed[1] * 1e3
        table.add_row(
            one.participant, one.waveguide, one.actuation, str(one.used), str(one.excluded),
            _spread(one.friction, 3), _spread(one.by_means, 3), _spread(one.force, 2), _spread(fast, 0),
        )  # fmt: skip
    return table


def tests_tables(result: FrictionResult) -> list[Table]:
    """All tests of the difference on less off: the difference and p; corrections and sizes of the effect."""
    found = Table(
        "waveguide", "test", "n", "on - off", "95 % interval", "t", "p",
        title="tests of the difference of friction",
    )  # fmt: skip
    sizes = Table(
        "waveguide", "test", "Bonferroni", "Holm", "d_z", "d_av",
        title="p-values corrected for several tests, and sizes of the effect with 95 % intervals",
    )  # fmt: skip
    for test in (*result.found.tests, *_few(result, result.found.each)):
        name = f"{test.participant}, {test.name}" if test.participant else test.name
        found.add_row(
            test.waveguide, name, str(test.n), f"{test.difference:.3f}", _interval(test.low, test.high, 3),
            _number(test.statistic, ".2f"), _number(test.p, ".2g"),
        )  # fmt: skip
        sizes.add_row(
            test.waveguide, name, _number(test.corrected, ".2g"), _number(test.holm, ".2g"),
            f"{_number(test.d_z, '.2f')} {_interval(test.d_z_low, test.d_z_high, 2)}",
            f"{_number(test.d_av, '.2f')} {_interval(test.d_av_low, test.d_av_high, 2)}",
        )  # fmt: skip
    return [found, sizes]


def notes_of(tests: Sequence[Test]) -> list[str]:
    """What has to be said of tests, each note once, with the tests that it belongs to."""
    by_note: dict[str, list[str]] = {}
    for test in tests:
        if test.note:
            by_note.setdefault(test.note, []).append(f"{test.waveguide} {test.name}")
    return [f"{'; '.join(dict.fromkeys(names))}: {note}." for note, names in by_note.items()]


def _few(result: FrictionResult, rows: Sequence[Row]) -> list[Row]:
    """Rows of single participants only where there are few of them; the files have all."""
    few = len(set(result.trials["participant"].values.tolist())) <= MOST_SHOWN
    return [row for row in rows if few or row.participant == EVERYBODY]


def _number(value: float, form: str) -> str:
    return f"{value:{form}}" if math.isfinite(value) else "-"


def _interval(low: float, high: float, digits: int) -> str:
    return f"[{low:.{digits}f}, {high:.{digits}f}]" if math.isfinite(low) else ""


def _spread(pair: tuple[float, float], digits: int) -> str:
    mean, deviation = (_number(value, f".{digits}f") for value in pair)
    return mean if mean == "-" else f"{mean} ± {deviation}"


def _percent(one: Estimate) -> str:
    interval = f", 95 % interval {one.low:.1%} to {one.high:.1%}" if math.isfinite(one.low) else ""
    return f"{one.value:.1%}{interval}{f' ({one.note})' if one.note else ''}"
