"""The report's first screen: the design, three numbers, three requirements, one picture."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from haptonic.bloch import gaps_of
from haptonic.bloch.gaps import gap_at
from haptonic.plots.text import gap_text
from haptonic.report.chapter import Chapter, Picture, Results
from haptonic.results.bands import CarrierPlace
from haptonic.results.feel.requirements import Requirement, drive_in_gap
from haptonic.results.feel.value import MARKS, Feel
from haptonic.results.plain import split
from haptonic.results.plate.value import PlateResult
from haptonic.units import hz_text, in_percent, share_form

LIGHTS = 3
VERDICTS = {"red": "not met", "amber": "uncertain", "green": "met"}  # the worst first
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
    requirements = _requirements(results)
    worst = sorted(requirements, key=lambda requirement: list(VERDICTS).index(requirement.colour))[:LIGHTS]
    return FirstScreen(
        numbers=(*_gap(results), *_contrast(results), *_reduction(results)),
        requirements=tuple(
            (
                requirement.colour,
                f"{MARKS[requirement.colour]} {requirement.what}: {VERDICTS[requirement.colour]}",
                requirement.reason,
            )
            for requirement in requirements
            if requirement in worst
        ),
        others=len(requirements) - len(worst),
        picture=next((pictures[name] for name in SHOWN if name in pictures), None),
    )


def _requirements(results: Results) -> list[Requirement]:
    """Requirements of the plate; without one, only that the carrier lies in a gap."""
    feel, carrier = results.of(Feel), results.study.carrier
    if feel is not None:
        return feel.requirements
    return [] if carrier is None else [drive_in_gap(carrier, gap_at(gaps_of(results.bands), carrier))]


def _gap(results: Results) -> list[Number]:
    """The gap around the carrier with the margin, or else the nearest gap; without a carrier the widest."""
    every = [gap for gap in gaps_of(results.bands) if gap.complete]
    complete = [gap for gap in every if gap.certain]
    carrier = results.study.carrier
    if every and not complete:
        widest = max(every, key=lambda gap: gap.width)
        note = "not wider than the errors of its edges, so it may not exist"
        return [Number(gap_text(widest), "uncertain band gap", note)]
    if not complete:
        return [Number("none", "complete band gap")]
    if carrier is None:
        widest = max(complete, key=lambda gap: gap.width)
        share = in_percent(widest.width / widest.centre, form=".1f")
        return [Number(gap_text(widest), "complete band gap", f"{share} of its centre")]
    place, name = CarrierPlace.among(complete, carrier), f"the carrier, {hz_text(carrier, form='g')}"
    if place.room <= 0:
        note = f"{name}, lies in no complete gap, {place}"
        return [Number(gap_text(place.gap), "nearest complete band gap", note)]
    note = f"margin of {name}: {place}" + ", within its error" * (not place.gap.holds(carrier))
    return [Number(gap_text(place.gap), "complete band gap around the carrier", note)]


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
    for name, reduction in feel.friction.reductions().items():
        if name in feel.friction.driven:
            form = share_form(reduction.low, reduction.high)
            plausible = in_percent(reduction.low, reduction.high, form=form)
            note = f"plausible {plausible}, at {feel.at_drive}"
            return [Number(in_percent(reduction.value, form=form), f"less friction on {name}", note)]
    return []
