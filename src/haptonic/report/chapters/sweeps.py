"""Chapter on the gaps along rows of designs."""

from __future__ import annotations

import numpy as np

from haptonic.bloch.gap_datasets import certain_gaps
from haptonic.later import xarray as xr
from haptonic.plots.sweeps import SUBSCRIPTED
from haptonic.plots.text import minus, readable, scaled_unit
from haptonic.report.chapter import Absent, Chapter, Finding, Picture, Results, Table
from haptonic.report.trend import trend_of
from haptonic.results.sweeps import Sweep, Sweeps
from haptonic.units import hz_text, in_percent

TITLE = "Sweeps"
STRAIGHT = 0.02  # of the edge's mean: largest distance from a line that counts as straight
OF_LINES = (
    "Each pair of points is one design; all its other sizes are those of the study. Thin lines are bending "
    "resonances of the pillar alone, clamped at its foot: by equation (3) of Daunizeau, Gueorguiev, Haliyo "
    "and Hayward, “Phononic Crystals Applied to Localised Surface Haptics”, which takes it as slender, and "
    "with shear and rotary inertia (Timoshenko). Gaps above the dashed line were not searched."
)
OF_MAPS = (
    "Each field of a map is one design; all its other sizes are those of the study. Its colour is the width "
    "of the widest complete gap below the last computed band."
)


def chapter(results: Results) -> Chapter | Absent:
    """Describe the complete gaps of every sweep and their shift."""
    if not results.study.sweep_settings:
        return Absent(TITLE, "the study describes none")
    sweeps = results.of(Sweeps)
    if sweeps is None:
        return Absent(TITLE, "they were not computed in this run")
    findings = [
        Finding(sentence, f"sweep_{k}")
        for k, sweep in enumerate(sweeps.rows, start=1)
        for sentence in _findings(sweep)
    ]
    rows = tuple(row for sweep in results.sweeps for row in _fit_rows(sweep))
    head = ("Along", "Designs", "Upper edge", "Lower edge", "Timoshenko", "Equation (3)")
    fits = Table(
        "Exponent p of frequency ~ value^p, fitted by least squares of logarithms to the designs that share "
        "the gap of the study's own design; the number after ± is the standard error of the fit. The last "
        "two columns are the resonance of the pillar alone that lies nearest to the upper edge.",
        head,
        rows,
    )
    return Chapter(
        title=TITLE,
        identifier="sweeps",
        paragraphs=tuple(
            text
            for text, axes in ((OF_LINES, 1), (OF_MAPS, 2))
            if any(len(sweep.axes) == axes for sweep in sweeps.rows)
        ),
        findings=tuple(findings),
        pictures=tuple(
            _picture(sweep, name := f"sweep_{k}", results.where(name))
            for k, sweep in enumerate(sweeps.rows, start=1)
        ),
        tables=(fits,) if rows else (),
    )


def _picture(sweep: Sweep, called: str, where: str) -> Picture:
    data, spans = sweep.dataset, []
    for variable, (expression, _) in sweep.axes.items():
        unit, factor = scaled_unit(data[variable].attrs["units"])
        low, high = data[variable].values.min() * factor, data[variable].values.max() * factor
        ending = f" {unit}" if factor != 1.0 else ""
        spans.append(f"{readable(expression)} from {low:g} to {high:g}{ending}")
    count = int(certain_gaps(data).any(axis=1).sum())
    return Picture(
        sweep.drawn(),
        f"Simulated complete gaps against {readable(sweep.expressions)}.{where}",
        f"Complete gaps of {data.sizes['step']} designs, {', '.join(spans)}; {count} of them have a gap.",
        called,
    )


def _findings(sweep: Sweep) -> list[str]:
    name, data = readable(sweep.expressions), sweep.dataset
    certain = certain_gaps(data)
    if not certain.any():
        return [f"No design along {name} has a certain complete gap."]
    lower, upper = data["gap_lower"].values, data["gap_upper"].values
    width = np.where(certain, upper - lower, 0.0)
    step, slot = np.unravel_index(width.argmax(), width.shape)
    centre = 0.5 * (lower + upper)[step, slot]
    findings = [
        f"Along {name}, {certain.any(axis=1).sum()} of {len(certain)} designs have a certain complete gap. "
        f"The widest is at {sweep.values_at(int(step))}: {lower[step, slot] / 1e3:.1f} to "
        f"{hz_text(upper[step, slot], form='.1f')}, {in_percent(width[step, slot] / centre)} of its centre."
    ]
    trend = trend_of(data)
    if trend is not None and np.isfinite(trend.slender).all():
        off, resonance = trend.straightness, SUBSCRIPTED[trend.nearest]
        share_off = off / trend.upper.mean()
        shape = (
            "is a straight line to within"
            if share_off < STRAIGHT
            else "deviates from a straight line by up to"
        )
        why = (
            "the line does not go through the origin, so the exponent in the table is not that of equation "
            "(3)"
            if share_off < STRAIGHT
            else "equation (3) is valid for slender pillars only"
        )
        apart = f"{hz_text(max(off, 100.0), form='.1f')} ({in_percent(share_off, form='.1f')} of the edge)"
        findings.append(
            f"Against equation (3)'s {resonance} the upper edge of the study's gap {shape} {apart} over "
            f"{len(trend.value)} designs; {why}."
        )
    return findings


def _fit_rows(sweep: xr.Dataset) -> list[tuple[str, ...]]:
    trend = trend_of(sweep)
    if trend is None or not np.isfinite(trend.slender).all():
        return []
    _, factor = scaled_unit(sweep["value"].attrs["units"])
    first, last = trend.value.min() * factor, trend.value.max() * factor
    return [
        (
            readable(sweep.attrs["expression"]),
            f"{len(trend.value)}, from {first:.4g} to {last:.4g}",
            minus(str(trend.power(trend.upper))),
            minus(str(trend.power(trend.lower))),
            minus(str(trend.power(trend.stocky[:, trend.nearest]))),
            minus(f"{trend.power(trend.slender[:, trend.nearest]).exponent:.2f}"),
        )
    ]
