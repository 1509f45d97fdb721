"""Friction trials with made-up people on the computed plate, analysed like measured ones."""

from __future__ import annotations

import math
from collections.abc import Mapping

from haptonic.friction.phrases import averages, change
from haptonic.friction.statistics import IntervalEstimate, Test
from haptonic.report.chapter import Absent, Chapter, Finding, Results, Table
from haptonic.results.friction import FrictionResult

TITLE = "Friction trials"
WORDS = {
    "conditions": "Bars of mean friction with the vibration on and off, by waveguide and participant.",
    "reductions": "Reduction of friction on each waveguide with intervals.",
}


def chapter(results: Results) -> Chapter | Absent:
    """Bars of the conditions as in Fig. 6D, all tests in one table, what may be concluded."""
    result = results.of(FrictionResult)
    if result is None:
        return Absent(TITLE, "no trials were made up or analysed in this run")
    known = results.references
    published = known.friction if known else None
    made_up = result.origin == "simulated"
    found = result.found
    origin = result.origin.capitalize()
    trials, left_out = result.trials.sizes["stroke"], sum(result.excluded.values())
    people = len(set(result.trials["participant"].values.tolist()))
    return Chapter(
        title=TITLE,
        identifier="trials",
        paragraphs=(
            *(["Nobody was measured: people, strokes and sensor are simulated, and friction follows from the "
               "computed amplitudes. What is tested here is the analysis, and what such trials could prove."]
              if made_up else []),
            f"{trials} trials of {people} participants, {left_out} of them left out by declared rules.",
            *([averages()] if found.equivalences else []),
        ),
        findings=(
            *(Finding(text, "reductions") for text in _reductions(result, published)),
            *(Finding(text, "conditions") for text in found.conclusions),
            *_alarms(results, people),
        ),
        pictures=results.pictures(result, WORDS),
        tables=(_tests(found.tests, origin),),
    )  # fmt: skip


def _reductions(result: FrictionResult, published: Mapping[str, float] | None) -> list[str]:
    found = result.found

    def beside(name: str) -> str:
        known = (published or {}).get(name)
        return "" if known is None else f"; measured: {100 * known:.0f} %"

    said = []
    for guide, one in found.reductions.items():
        told = beside("driven" if guide == found.driven else "idle")
        said.append(f"{guide}: {change(one.value, one.low, one.high)}{told}.")
    for guide, one in found.stopped.items():
        said.append(f"Of the driven reduction, {_percent(one)} does not reach {guide}{beside('stopped')}.")
    return said


def _alarms(results: Results, people: int) -> list[str]:
    """How often the tests would find an effect that is not there."""
    if not results.alarms:
        return []
    rates = "; ".join(
        f"{name}, {round(rate * count)} of {count}" for name, (rate, _, count) in results.alarms.items()
    )
    return [
        f"Without any effect in the population, tests at 5 % find one all the same in so many simulated "
        f"experiments with {people} such participants: {rates}. The test over trials takes strokes of one "
        "person as independent."
    ]


def _tests(tests: tuple[Test, ...], origin: str) -> Table:
    rows = tuple(
        (
            test.waveguide,
            test.name,
            str(test.n),
            f"{test.difference:.3f}",
            f"{test.low:.3f} to {test.high:.3f}" if math.isfinite(test.low) else "-",
            *(f"{p:.2g}" if math.isfinite(p) else "-" for p in (test.p, test.corrected, test.holm)),
            f"{test.d_z:.2f}" if math.isfinite(test.d_z) else "-",
        )
        for test in tests
    )
    head = ("waveguide", "test", "n", "on less off", "95 % interval", "p", "Bonferroni", "Holm", "d_z")
    return Table(f"{origin} difference of friction: the test as published, and as it should be.", head, rows)


def _percent(one: IntervalEstimate) -> str:
    interval = f" ({100 * one.low:.0f} to {100 * one.high:.0f} %)" if math.isfinite(one.low) else ""
    return f"{100 * one.value:.0f} %{interval}"
