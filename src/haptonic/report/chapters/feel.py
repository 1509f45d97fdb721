"""Chapter on the friction at a fingertip: predictions, and the amplitude ratio of measured reductions."""

from __future__ import annotations

import math

from haptonic.friction.lubrication import CUE_THRESHOLD, WEBER_FRACTION, explained
from haptonic.friction.lubrication.on_plate import FrictionOnPlate
from haptonic.friction.phrases import change
from haptonic.report.chapter import Absent, Chapter, Finding, Results, Table
from haptonic.results.feel.value import Feel
from haptonic.units import hz_text, in_percent

TITLE = "Friction at a fingertip"


def chapter(results: Results) -> Chapter | Absent:
    """Describe friction over the plate, its regions, and the inversion of measured reductions."""
    result = results.of(Feel)
    if result is None:
        return Absent(TITLE, "it was not computed in this run")
    friction, touch = result.friction, result.friction.touch
    words = {
        "friction": "Maps of friction over the plate.",
        "reduction": "Reduction of each region against the drive, with bands.",
    }
    assumed = [
        str(parameter["title"])
        for parameter in friction.skin.assumptions().values()
        if parameter["mark"] == "assumed"
    ]
    return Chapter(
        title=TITLE,
        identifier="feel",
        paragraphs=(
            f"A finger presses with {touch.force:g} N, slides at {1e3 * touch.speed:g} mm/s and damps the "
            "plate below it. Friction follows from the amplitudes below the finger. The value is that of a "
            "film of squeezed air that carries a part of the load; the interval includes intermittent "
            "contact.",
            f"The fingertip was not measured. Assumed: {'; '.join(assumed)}; the damping by the finger.",
        ),
        findings=(*_findings(friction), *_inversion(results, friction)),
        pictures=results.pictures(result, words),
        tables=(
            *result.tables(),
            *_published(results, friction),
        ),
    )


def _findings(friction: FrictionOnPlate) -> list[str]:
    findings: list[str] = [
        Finding(
            f"{name}{' (driven)' if name in friction.driven else ''}: "
            f"{change(felt.value, felt.low, felt.high)}; {_noticed(friction, name)}.",
            "reduction",
        )
        for name, felt in friction.reductions().items()
    ]
    mode = friction.loaded.attrs["mode_hz"]
    if math.isfinite(mode):
        findings.append(
            f"A finger on the driven region lowers the quality factor of the mode at "
            f"{hz_text(mode, form='.2f')} from {friction.quality('free'):.0f} to {friction.quality():.0f}; "
            f"the vibration then rises from 10 to 90 % in {1e3 * friction.rise:.1f} ms. People feel cues of "
            f"{1e3 * CUE_THRESHOLD:.1f} ms."
        )
    return findings


def _noticed(friction: FrictionOnPlate, region: str) -> str:
    drive = friction.drive_for(WEBER_FRACTION, region)
    if drive is None:
        return "no drive makes the change noticeable"
    return f"noticeable from {drive:.3g} {friction.unit} on"


def _inversion(results: Results, friction: FrictionOnPlate) -> list[str]:
    """Compare the ratio of amplitudes that measured reductions require with that of the simulated plate."""
    known = results.references
    if known is None or not {"driven", "idle"} <= known.friction.keys() or not friction.ratio:
        return []
    driven, left = known.friction["driven"], known.friction["idle"]
    required = explained(driven, left, friction.touch, friction.skin)["ratio"]
    value, low, high = (float(required.sel(quantity=end)) for end in ("value", "low", "high"))
    idle, ratio = next(iter(friction.ratio.items()))
    margin = friction.margins[idle]
    return [
        f"{known.title[0].upper()}{known.title[1:]} measured reductions of {in_percent(driven)} on the "
        f"driven guide and {in_percent(left)} on the idle one. They require a ratio of amplitudes of "
        f"{value:.1f} ({low:.1f} to {high:.1f} for plausible parameters), or {_decibels(value)}. The "
        f"simulated plate has a ratio of {ratio:.1f} below a finger, or {_decibels(ratio)}.",
        f"The lattice stops {in_percent(margin.stopped)} of the reduction in the simulation and "
        f"{in_percent(1 - left / driven)} on the measured plate. A scan of both regions on one scale would "
        "determine the ratio of a real plate.",
    ]


def _published(results: Results, friction: FrictionOnPlate) -> tuple[Table, ...]:
    """Table of predicted and measured reductions."""
    known = results.references.friction if results.references else {}
    if not friction.driven or not {"driven", "idle"} <= known.keys():
        return ()
    rows = [
        (name, str(felt), in_percent(known["driven" if name in friction.driven else "idle"]))
        for name, felt in friction.reductions().items()
    ]
    head = ("region", "predicted, with its interval", "measured")
    return (Table("Predicted and measured reduction of friction.", head, rows),)


def _decibels(ratio: float) -> str:
    return f"{20 * math.log10(ratio):.1f} dB"
