"""Gaps along rows of designs."""

from __future__ import annotations

import numpy as np

from haptonic import plots
from haptonic.later import xarray as xr
from haptonic.plots.sweeps import SUBSCRIPTED
from haptonic.plots.text import minus, readable, scaled_unit
from haptonic.report.chapter import Absent, Chapter, Finding, Picture, Results, Table
from haptonic.report.trend import trend_of
from haptonic.units import hz_text

TITLE = "Sweeps"
STRAIGHT = 0.02  # of the edge's mean: how far off a line that is called straight may be


def chapter(results: Results) -> Chapter | Absent:
    """Complete gaps of every sweep, and how they move."""
    if not results.study.sweep_settings:
        return Absent(TITLE, "the study describes none")
    if not results.sweeps:
        return Absent(TITLE, "they were not computed in this run")
    said = [
        Finding(sentence, f"sweep_{k}")
        for k, sweep in enumerate(results.sweeps, start=1)
        for sentence in _findings(sweep)
    ]
    rows = tuple(row for sweep in results.sweeps for row in _fit_rows(sweep))
    head = ("Along", "Designs", "Upper edge", "Lower edge", "Timoshenko", "Equation (3)")
    fits = Table(
        "Exponent p of frequency ~ value^p, fitted by least squares of logarithms to the designs that share "
        "the gap of the study's own design; ± is the standard error, which tells how far the points are from "
        "a power. The last two columns are the resonance of the pillar alone that lies nearest to the upper "
        "edge.",
        head,
        rows,
    )
    return Chapter(
        title=TITLE,
        identifier="sweeps",
        paragraphs=(
            "Each pair of points is one design; all its other sizes are those of the study. Thin lines are "
            "bending resonances of the pillar alone, clamped at its foot: by equation (3) of Daunizeau, "
            "Gueorguiev, Haliyo and Hayward, “Phononic Crystals Applied to Localised Surface Haptics”, "
            "which takes it as slender, and with shear and rotary inertia (Timoshenko). Gaps above the "
            "dashed line were not looked for.",
        ),
        findings=tuple(said),
        pictures=tuple(
            _picture(sweep, name := f"sweep_{k}", results.where(name))
            for k, sweep in enumerate(results.sweeps, start=1)
        ),
        tables=(fits,) if rows else (),
    )


def _picture(sweep: xr.Dataset, called: str, where: str) -> Picture:
    expression = sweep.attrs["expression"]
    name = readable(expression)
    unit, factor = scaled_unit(sweep["value"].attrs["units"])
    low, high = sweep["value"].values.min() * factor, sweep["value"].values.max() * factor
    span = f"{low:g} to {high:g}" + (f" {unit}" if factor != 1.0 else "")
    count = int(_certain(sweep).any(axis=1).sum())
    return Picture(
        plots.sweep(sweep),
        f"Simulated complete gaps against {name}.{where}",
        f"Complete gaps of {sweep.sizes['step']} designs, {name} from {span}; {count} of them have a gap.",
        called,
    )


def _certain(sweep: xr.Dataset) -> np.ndarray:
    doubt = sweep["gap_lower_error"] + sweep["gap_upper_error"]
    return np.asarray((sweep["gap_upper"] - sweep["gap_lower"]).values > doubt.values)


def _findings(sweep: xr.Dataset) -> list[str]:
    name = readable(sweep.attrs["expression"])
    unit, factor = scaled_unit(sweep["value"].attrs["units"])
    ending = f" {unit}" if factor != 1.0 else ""
    certain = _certain(sweep)
    value = sweep["value"].values * factor
    if not certain.any():
        return [f"No design along {name} has a certain complete gap."]
    lower, upper = sweep["gap_lower"].values, sweep["gap_upper"].values
    share = np.where(certain, 2 * (upper - lower) / (upper + lower), 0.0)
    step, slot = np.unravel_index(share.argmax(), share.shape)
    said = [
        f"Along {name}, {certain.any(axis=1).sum()} of {len(value)} designs have a certain complete gap. The "
        f"widest for its frequency is at {value[step]:.4g}{ending}: {lower[step, slot] / 1e3:.1f} to "
        f"{hz_text(upper[step, slot], form='.1f')}, {share[step, slot]:.0%} of its centre."
    ]
    trend = trend_of(sweep)
    if trend is not None and np.isfinite(trend.slender).all():
        off, resonance = trend.straightness, SUBSCRIPTED[trend.nearest]
        share_off = off / trend.upper.mean()
        shape = "is a straight line to within" if share_off < STRAIGHT else "leaves a straight line by up to"
        why = (
            "the line does not go through the origin, so the exponent below is not equation (3)'s"
            if share_off < STRAIGHT
            else "equation (3) holds for slender pillars only"
        )
        apart = f"{hz_text(max(off, 100.0), form='.1f')} ({share_off:.1%} of the edge)"
        said.append(
            f"Against equation (3)'s {resonance} the upper edge of the study's gap {shape} {apart} over "
            f"{len(trend.value)} designs; {why}."
        )
    return said


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
