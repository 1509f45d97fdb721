"""Chapter on friction trials: simulated participants on the computed plate, analysed like measured ones."""

from __future__ import annotations

import math
from collections.abc import Mapping

from haptonic.friction.phrases import averages, change
from haptonic.friction.statistics import Test
from haptonic.report.chapter import Absent, Chapter, Finding, Results, Table
from haptonic.results.friction import FrictionResult
from haptonic.units import in_percent, share_text

TITLE = "Friction trials"
WORDS = {
    "conditions": "Bars of mean friction with the vibration on and off, by waveguide and participant.",
    "reductions": "Reduction of friction on each waveguide with intervals.",
}


def chapter(results: Results) -> Chapter | Absent:
    """Describe the conditions as in Fig. 6D, the tests, and the conclusions."""
    result = results.of(FrictionResult)
    if result is None:
        return Absent(TITLE, "no trials were simulated or analysed in this run")
    known = results.references
    published = known.friction if known else None
    summary = result.found
    origin = result.origin.capitalize()
    trials, left_out = result.trials.sizes["stroke"], sum(result.excluded.values())
    people = len(set(result.trials["participant"].values.tolist()))
    return Chapter(
        title=TITLE,
        identifier="trials",
        paragraphs=(
            *(["Participants, strokes and sensor are simulated; friction follows from computed amplitudes. "
               "The trials test the analysis, and show which differences such trials can detect."]
              if result.origin == "simulated" else []),
            f"{trials} trials of {people} participants, {left_out} of them excluded by the rules of the "
            "study.",
            *([averages()] if summary.equivalences else []),
        ),
        findings=(
            *(Finding(text, "reductions") for text in _reductions(result, published)),
            *(Finding(text, "conditions") for text in summary.conclusions),
            *_alarms(results, people),
        ),
        pictures=results.pictures(result, WORDS),
        tables=(_tests(summary.tests, origin),),
    )  # fmt: skip


def _reductions(result: FrictionResult, published: Mapping[str, float] | None) -> list[str]:
    summary = result.found

    def measured(name: str) -> str:
        known = (published or {}).get(name)
        return "" if known is None else f"; measured: {in_percent(known)}"

    findings = []
    for guide, estimate in summary.reductions.items():
        reference = measured("driven" if guide == summary.driven else "idle")
        findings.append(f"{guide}: {change(estimate.value, estimate.low, estimate.high)}{reference}.")
    for guide, estimate in summary.stopped.items():
        if math.isnan(estimate.value):
            findings.append(f"{guide}: no share of the driven reduction is determined; {estimate.note}.")
            continue
        share = share_text(estimate.value, estimate.low, estimate.high)
        findings.append(f"{share} of the driven reduction does not reach {guide}{measured('stopped')}.")
    return findings


def _alarms(results: Results, people: int) -> list[str]:
    """List the false-alarm rates of the tests."""
    if not results.alarms:
        return []
    rates = "; ".join(
        f"{name}, {round(rate * count)} of {count}" for name, (rate, _, count) in results.alarms.items()
    )
    return [
        f"False alarms of tests at a level of 5 %, in simulated experiments with {people} participants and "
        f"without an effect: {rates}. The test over trials treats the strokes of one person as independent."
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
    return Table(
        f"{origin} difference of friction: the published test, and tests over participants.", head, rows
    )
