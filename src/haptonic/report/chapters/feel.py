"""What a finger feels of the plate: predicted friction, and the ratio that explains what was measured."""

from __future__ import annotations

import math

from haptonic.friction.lubrication import CUE_THRESHOLD, WEBER_FRACTION, explained
from haptonic.friction.lubrication.on_plate import FrictionOnPlate
from haptonic.friction.phrases import change
from haptonic.report.chapter import Absent, Chapter, Finding, Results, Table
from haptonic.results.feel.value import Feel
from haptonic.units import hz_text, in_percent

TITLE = "What a finger feels"


def chapter(results: Results) -> Chapter | Absent:
    """Predicted friction over the plate, reductions of its regions, and the inversion of measured ones."""
    result = results.of(Feel)
    if result is None:
        return Absent(TITLE, "it was not computed in this run")
    friction, touch = result.friction, result.friction.touch
    words = {
        "friction": "Maps of friction over the plate.",
        "reduction": "Reduction of each region against the drive, with bands.",
    }
    assumed = [str(one["title"]) for one in friction.skin.assumptions().values() if one["mark"] == "assumed"]
    return Chapter(
        title=TITLE,
        identifier="feel",
        paragraphs=(
            f"A finger of {touch.force:g} N that slides at {1e3 * touch.speed:g} mm/s damps "
            "the plate wherever it lies; amplitudes are those that are left below it. Friction follows from "
            "them by a film of squeezed air that shares the load with the skin, which gives the value, or by "
            "intermittent contact; the band spans both.",
            f"Nobody measured this fingertip. Assumed: {'; '.join(assumed)}; the damping that it adds.",
        ),
        findings=(*_findings(friction), *_inversion(results, friction)),
        pictures=results.pictures(result, words),
        tables=(
            *result.tables(),
            *_published(results, friction),
        ),
    )


def _findings(friction: FrictionOnPlate) -> list[str]:
    said: list[str] = [
        Finding(
            f"{name}{' (driven)' if name in friction.driven else ''}: "
            f"{change(one.value, one.low, one.high)}; {_noticed(friction, name)}.",
            "reduction",
        )
        for name, one in friction.reductions().items()
    ]
    mode = friction.loaded.attrs["mode_hz"]
    if math.isfinite(mode):
        said.append(
            f"A finger on the driven region lowers the quality factor of the mode at "
            f"{hz_text(mode, form='.2f')} from {friction.quality('free'):.0f} to {friction.quality():.0f}; "
            f"the vibration then takes {1e3 * friction.rise:.1f} ms from 10 to 90 %. "
            f"Cues of {1e3 * CUE_THRESHOLD:.1f} ms are felt."
        )
    return said


def _noticed(friction: FrictionOnPlate, region: str) -> str:
    drive = friction.drive_for(WEBER_FRACTION, region)
    if drive is None:
        return "no drive makes it noticed"
    return f"it is noticed from {drive:.3g} {friction.unit} on"


def _inversion(results: Results, friction: FrictionOnPlate) -> list[str]:
    """What ratio of amplitudes measured reductions need, and what the simulated plate has."""
    known = results.references
    if known is None or not {"driven", "idle"} <= known.friction.keys() or not friction.ratio:
        return []
    driven, left = known.friction["driven"], known.friction["idle"]
    found = explained(driven, left, friction.touch, friction.skin)["ratio"]
    value, low, high = (float(found.sel(quantity=end)) for end in ("value", "low", "high"))
    idle, ratio = next(iter(friction.ratio.items()))
    margin = friction.margins[idle]
    return [
        f"Reductions of {in_percent(driven)} and {in_percent(left)}, which {known.title} has measured, "
        f"need an amplitude {value:.1f} times as large on the driven guide as on the idle one ({low:.1f} to "
        f"{high:.1f} over the plausible parameters), that is {_decibels(value)}. Below a finger the "
        f"simulated plate has {ratio:.1f} times, {_decibels(ratio)}.",
        f"In the simulation the lattice stops {in_percent(margin.stopped)} of the reduction; on the measured "
        f"plate it is {in_percent(1 - left / driven)}. A scan of both regions on one scale would say how "
        "much a plate lets through.",
    ]


def _published(results: Results, friction: FrictionOnPlate) -> tuple[Table, ...]:
    """Reductions beside those that were measured."""
    known = results.references.friction if results.references else {}
    if not friction.driven or not {"driven", "idle"} <= known.keys():
        return ()
    rows = [
        (name, str(one), in_percent(known["driven" if name in friction.driven else "idle"]))
        for name, one in friction.reductions().items()
    ]
    head = ("region", "predicted, with its interval", "measured")
    return (Table("Reduction of friction, and what was measured on people.", head, rows),)


def _decibels(ratio: float) -> str:
    return f"{20 * math.log10(ratio):.1f} dB"
