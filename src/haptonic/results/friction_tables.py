"""What trials say to people: sentences and tables."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, TypeVar

from haptonic.friction.lubrication import WEBER_FRACTION
from haptonic.friction.phrases import averages, change
from haptonic.friction.signals.record import EVERYBODY
from haptonic.friction.statistics import IntervalEstimate, Test
from haptonic.friction.statistics.summary import Condition
from haptonic.results.table import Cell, Table

if TYPE_CHECKING:
    from haptonic.results.friction import FrictionResult

MOST_SHOWN = 12  # participants whose rows are shown

Row = TypeVar("Row", Condition, Test)


def reported(result: FrictionResult) -> list[str]:
    """What may be concluded, then reductions and what reaches the idle waveguide, then what to know of it."""
    found = result.found
    said = list(found.conclusions)
    for guide, one in found.reductions.items():
        note = f" ({one.note})" if one.note else ", 95 % interval" * math.isfinite(one.low)
        said.append(f"{guide}: {change(one.value, one.low, one.high, digits=1)}{note}.")
    if found.driven:
        said.append(f"Driven: {found.driven}, {found.chosen}.")
    for guide, one in found.stopped.items():
        said.append(f"Share of the reduction that does not reach {guide}: {_percent(one)}.")
        said.append(f"The same by bootstrap: {_percent(found.stopped_here[guide])}.")
    for same in found.equivalences:
        proof = same.note or (
            f"90 % interval {same.low:.1%} to {same.high:.1%}; one-sided test against the "
            f"{WEBER_FRACTION:.0%} that people feel: p = {same.p_above:.2g}"
        )
        said.append(
            f"{same.waveguide}, idle: reduction {same.mean:.1%} as the mean of participants; {proof}."
        )
    if found.equivalences:
        said.append(averages())
    if found.drift:
        said.append(f"Drift over a session with the vibration off: {_percent(found.drift)}.")
    said += notes_of((*found.tests, *found.each))
    said += [f"guessed: {text}" for text in result.guessed]
    if not result.excluded:
        said.append(f"{result.trials.sizes['stroke']} trials, none of them left out")
    if result.origin == "simulated":
        said.append("Simulated: these trials were made up; nobody was measured.")
    return said


def excluded_table(result: FrictionResult) -> Table:
    """How many trials do not count, by reason, with the first of each."""
    total, trials = result.trials.sizes["stroke"], result.trials
    left_out = sum(result.excluded.values())
    rows = []
    for reason, count in result.excluded.items():
        row = trials["excluded"].values.tolist().index(reason)
        first = " ".join(f"{name} {trials[name].values[row]}" for name in ("participant", "block", "trial"))
        detail = str(trials["detail"].values[row])
        rows.append((reason, str(count), f"{first}: {detail}" if detail else first))
    return Table(f"{total} trials, {left_out} of them left out", ("reason", "trials", "the first"), rows)


def conditions_table(result: FrictionResult) -> Table:
    """Every condition of every participant: mean and standard deviation over trials."""
    head = (
        "who",
        "where",
        "vibration",
        "trials",
        "left out",
        "mean of ratios",
        "ratio of means",
        "force / N",
        "speed / (mm/s)",
    )
    rows: list[tuple[Cell, ...]] = []
    for one in _few(result, result.found.conditions):
        fast = one.speed[0] * 1e3, one.speed[1] * 1e3
        rows.append((
            one.participant, one.waveguide, one.actuation, str(one.used), str(one.excluded),
            _spread(one.friction, 3), _spread(one.by_means, 3), _spread(one.force, 2), _spread(fast, 0),
        ))  # fmt: skip
    return Table("friction of each condition: mean ± standard deviation over trials", head, rows)


def tests_tables(result: FrictionResult) -> list[Table]:
    """All tests of the difference on less off: the difference and p; corrections and sizes of the effect."""
    found: list[tuple[Cell, ...]] = []
    sizes: list[tuple[Cell, ...]] = []
    for test in (*result.found.tests, *_few(result, result.found.each)):
        name = f"{test.participant}, {test.name}" if test.participant else test.name
        found.append((
            test.waveguide, name, str(test.n), f"{test.difference:.3f}", _interval(test.low, test.high, 3),
            _number(test.statistic, ".2f"), _number(test.p, ".2g"),
        ))  # fmt: skip
        sizes.append((
            test.waveguide, name, _number(test.corrected, ".2g"), _number(test.holm, ".2g"),
            f"{_number(test.d_z, '.2f')} {_interval(test.d_z_low, test.d_z_high, 2)}",
            f"{_number(test.d_av, '.2f')} {_interval(test.d_av_low, test.d_av_high, 2)}",
        ))  # fmt: skip
    return [
        Table(
            "tests of the difference of friction",
            ("waveguide", "test", "n", "on - off", "95 % interval", "t", "p"),
            found,
        ),
        Table(
            "p-values corrected for several tests, and sizes of the effect with 95 % intervals",
            ("waveguide", "test", "Bonferroni", "Holm", "d_z", "d_av"),
            sizes,
        ),
    ]


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


def _percent(one: IntervalEstimate) -> str:
    interval = f", 95 % interval {one.low:.1%} to {one.high:.1%}" if math.isfinite(one.low) else ""
    return f"{one.value:.1%}{interval}{f' ({one.note})' if one.note else ''}"
