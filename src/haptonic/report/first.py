"""The report's first screen: what was designed, three numbers, three requirements, one picture."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from haptonic.bloch import gaps_of
from haptonic.plots.text import in_percent
from haptonic.report.chapter import Chapter, Picture, Results
from haptonic.report.chapters.dispersion import gap_text
from haptonic.results.feel.value import MARKS, Feel
from haptonic.results.plain import split
from haptonic.results.plate.value import PlateResult
from haptonic.units import hz_text

LIGHTS = 3
SEVERITY = ("red", "amber", "green")
SHOWN = ("maps", "dispersion")  # names of the picture, the first that a report has


@dataclass(frozen=True)
class Number:
    """A large number with its name and its condition."""

    value: str
    name: str
    note: str = ""


@dataclass(frozen=True, eq=False)
class FirstScreen:
    """Content of the report that is visible without scrolling.

    requirements : (colour, requirement, reason) of the worst ones
    others : number of further requirements
    """

    numbers: tuple[Number, ...]
    requirements: tuple[tuple[str, str, str], ...]
    others: int
    picture: Picture | None


def first_screen(results: Results, chapters: Iterable[Chapter]) -> FirstScreen:
    """Build the first screen from the results of a report."""
    pictures = {picture.name: picture for chapter in reversed(list(chapters)) for picture in chapter.pictures}
    feel = results.of(Feel)
    requirements = feel.requirements if feel else []
    worst = sorted(requirements, key=lambda requirement: SEVERITY.index(requirement.colour))[:LIGHTS]
    return FirstScreen(
        numbers=(*_gap(results), *_contrast(results), *_reduction(results)),
        requirements=tuple(
            (requirement.colour, f"{MARKS[requirement.colour]} {requirement.what}", requirement.reason)
            for requirement in requirements
            if requirement in worst
        ),
        others=len(requirements) - len(worst),
        picture=next((pictures[name] for name in SHOWN if name in pictures), None),
    )


def _gap(results: Results) -> list[Number]:
    complete = [gap for gap in gaps_of(results.bands) if gap.complete and gap.certain]
    if not complete:
        return [Number("none", "complete band gap")]
    widest = max(complete, key=lambda gap: gap.width)
    return [
        Number(
            gap_text(widest), "complete band gap", f"{100 * widest.width / widest.centre:.1f} % of its centre"
        )
    ]


def _contrast(results: Results) -> list[Number]:
    plate = results.of(PlateResult)
    levels = split(plate.maps.sel(frequency=plate.resonance).get("contrast"), "pair") if plate else {}
    if plate is None or not levels:
        return []
    pair, level = next(iter(levels.items()))
    return [
        Number(f"{float(level):.1f} dB", f"contrast, {pair}", f"at {hz_text(plate.resonance, form='.2f')}")
    ]


def _reduction(results: Results) -> list[Number]:
    feel = results.of(Feel)
    if feel is None:
        return []
    felt = feel.friction.reductions()
    return [
        Number(
            in_percent(reduction.value),
            f"less friction on {name}",
            f"plausible {100 * reduction.low:.0f} to {in_percent(reduction.high)}, at {feel.at_drive}",
        )
        for name, reduction in felt.items()
        if name in feel.friction.driven
    ][:1]
