"""Sentences and tables on friction trials."""

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
from haptonic.units import in_percent, share_form, share_text

if TYPE_CHECKING:
    from haptonic.results.friction import FrictionResult

MOST_SHOWN = 12  # participants; the tables of larger groups have no rows for single participants

Row = TypeVar("Row", Condition, Test)


def reported(result: FrictionResult) -> list[str]:
    """Sentences: the reductions of all regions, then conclusions and localisation, then remarks."""
    summary = result.found
    effects = [
        f"{guide}: {change(estimate.value, estimate.low, estimate.high)}{_note(estimate)}"
        for guide, estimate in summary.reductions.items()
    ]
    sentences = [*([f"{'; '.join(effects)}."] if effects else []), *summary.conclusions]
    if summary.driven:
        sentences.append(f"Driven: {summary.driven}, {summary.chosen}.")
    for guide, estimate in summary.stopped.items():
        sentences.append(f"Share of the reduction that does not reach {guide}: {_estimated(estimate)}.")
        if math.isfinite(estimate.value):
            sentences.append(f"Bootstrap estimate of this share: {_estimated(summary.stopped_here[guide])}.")
    for same in summary.equivalences:
        form = share_form(same.low, same.high)
        proof = same.note or (
            f"90 % interval {in_percent(same.low, same.high, form=form)}; one-sided test against the "
            f"noticeable {in_percent(WEBER_FRACTION)}: p = {same.p_above:.2g}"
        )
        sentences.append(
            f"{same.waveguide}, idle: reduction {in_percent(same.mean, form=form)} as the mean of "
            f"participants; {proof}."
        )
    if summary.equivalences:
        sentences.append(averages())
    if summary.drift:
        sentences.append(f"Drift over a session with the vibration off: {_estimated(summary.drift)}.")
    sentences += notes_of((*summary.tests, *summary.each))
    sentences += [f"assumed: {text}" for text in result.guessed]
    if not result.excluded:
        sentences.append(f"{result.trials.sizes['stroke']} trials, none of them excluded")
    if result.origin == "simulated":
        sentences.append("Simulated: these trials are simulated, not measured.")
    return sentences


def excluded_table(result: FrictionResult) -> Table:
    """Number of excluded trials by reason, with the first of each."""
    total, trials = result.trials.sizes["stroke"], result.trials
    left_out = sum(result.excluded.values())
    rows = []
    for reason, count in result.excluded.items():
        row = trials["excluded"].values.tolist().index(reason)
        first = " ".join(f"{name} {trials[name].values[row]}" for name in ("participant", "block", "trial"))
        detail = str(trials["detail"].values[row])
        rows.append((reason, str(count), f"{first}: {detail}" if detail else first))
    return Table(f"{total} trials, {left_out} of them excluded", ("reason", "trials", "the first"), rows)


def conditions_table(result: FrictionResult) -> Table:
    """Conditions of each participant: mean and standard deviation over trials."""
    head = (
        "who",
        "where",
        "vibration",
        "trials",
        "excluded",
        "mean of ratios",
        "ratio of means",
        "force / N",
        "speed / (mm/s)",
    )
    rows: list[tuple[Cell, ...]] = []
    for condition in _few(result, result.found.conditions):
        fast = condition.speed[0] * 1e3, condition.speed[1] * 1e3
        rows.append((
            condition.participant, condition.waveguide, condition.actuation,
            str(condition.used), str(condition.excluded), _spread(condition.friction, 3),
            _spread(condition.by_means, 3), _spread(condition.force, 2), _spread(fast, 0),
        ))  # fmt: skip
    return Table("friction of each condition: mean ± standard deviation over trials", head, rows)


def tests_tables(result: FrictionResult) -> list[Table]:
    """Tests of the difference between on and off: difference and p; corrections and effect sizes."""
    differences: list[tuple[Cell, ...]] = []
    sizes: list[tuple[Cell, ...]] = []
    for test in (*result.found.tests, *_few(result, result.found.each)):
        name = f"{test.participant}, {test.name}" if test.participant else test.name
        differences.append((
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
            differences,
        ),
        Table(
            "p-values corrected for several tests, and sizes of the effect with 95 % intervals",
            ("waveguide", "test", "Bonferroni", "Holm", "d_z", "d_av"),
            sizes,
        ),
    ]


def notes_of(tests: Sequence[Test]) -> list[str]:
    """Remarks on tests; each one is listed once, with its tests."""
    by_note: dict[str, list[str]] = {}
    for test in tests:
        if test.note:
            by_note.setdefault(test.note, []).append(f"{test.waveguide} {test.name}")
    return [f"{'; '.join(dict.fromkeys(names))}: {note}." for note, names in by_note.items()]


def _few(result: FrictionResult, rows: Sequence[Row]) -> list[Row]:
    """Rows of single participants only if there are few participants; the files contain all."""
    few = len(set(result.trials["participant"].values.tolist())) <= MOST_SHOWN
    return [row for row in rows if few or row.participant == EVERYBODY]


def _number(value: float, form: str) -> str:
    return f"{value:{form}}" if math.isfinite(value) else "-"


def _interval(low: float, high: float, digits: int) -> str:
    return f"[{low:.{digits}f}, {high:.{digits}f}]" if math.isfinite(low) else ""


def _spread(pair: tuple[float, float], digits: int) -> str:
    mean, deviation = (_number(value, f".{digits}f") for value in pair)
    return mean if mean == "-" else f"{mean} ± {deviation}"


def _estimated(estimate: IntervalEstimate) -> str:
    """Share with its interval, or the reason why it has none."""
    if math.isnan(estimate.value):
        return f"not determined; {estimate.note}"
    return f"{share_text(estimate.value, estimate.low, estimate.high)}{_note(estimate)}"


def _note(estimate: IntervalEstimate) -> str:
    if estimate.note:
        return f" ({estimate.note})"
    return ", 95 % interval" * math.isfinite(estimate.low)
