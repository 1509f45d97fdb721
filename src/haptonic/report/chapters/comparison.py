"""The paper's facts beside ours."""

from __future__ import annotations

import json

import numpy as np
import xarray as xr

from haptonic.bloch import Gap, gaps_of
from haptonic.materials import IsotropicMaterial
from haptonic.plots.words import khz, minus, readable
from haptonic.report import paper
from haptonic.report.chapter import Absent, Chapter, Results, Table
from haptonic.report.chapters.dispersion import along
from haptonic.report.chapters.modes import mode_names
from haptonic.report.trend import Trend, trend_of

TITLE = "Comparison with the paper"
Row = tuple[str, str, str, str, str]
NEAR = 0.1  # of the lower edge: how close a band has to come to count as forming it
NONE = "-"  # no difference to give


def chapter(results: Results) -> Chapter | Absent:
    """Paper, haptonic, difference, why."""
    if not paper.is_its_cell(results.study):
        return Absent(TITLE, "the study's unit cell is not the paper's")
    rows = [*_gap_rows(results), *_mode_rows(results.bands), *_trend_rows(results), _bragg_row(results)]
    return Chapter(
        title=TITLE,
        identifier="comparison",
        paragraphs=(
            f"The paper is {paper.CITATION}. Its numbers for the lattice are simulated, as ours are; what it "
            "measured on its plate and with people stands in the chapters on these.",
        ),
        tables=(
            Table(
                "Paper and haptonic, for the same unit cell and the same material.",
                ("Quantity", "Paper", "haptonic", "Difference", "Why"),
                tuple(rows),
            ),
        ),
    )


def _gap_rows(results: Results) -> list[Row]:
    complete = [gap for gap in gaps_of(results.bands) if gap.complete and gap.certain]
    theirs = f"{paper.GAP[0] / 1e3:.1f} to {paper.GAP[1] / 1e3:.1f} kHz"
    if not complete:
        return [("Complete gap", theirs, "none found", NONE, "not known")]
    gap = max(complete, key=lambda gap: min(gap.upper, paper.GAP[1]) - max(gap.lower, paper.GAP[0]))
    below, above = gap.between
    rows = [
        _edge_row("lower", paper.GAP[0], gap.lower, gap.lower_error, _why_lower(gap, results.bands)),
        _edge_row("upper", paper.GAP[1], gap.upper, gap.upper_error, _why_upper(gap, results.filleted)),
        _edge_row(
            "", paper.GAP[1] - paper.GAP[0], gap.width, gap.lower_error + gap.upper_error,
            "Follows from the edges.",
        ),
    ]  # fmt: skip
    same = (max(paper.BELOW), min(paper.ABOVE)) == gap.between
    rows.append(
        (
            "Bands below and above the gap",
            f"M{max(paper.BELOW)} and M{min(paper.ABOVE)}",
            f"{below} and {above}",
            "none" if same else "differ",
            "Both count from the lowest frequency." if same else "Not known.",
        )
    )
    return [*rows, _lower_row(gap, results.bands)]


def _lower_row(gap: Gap, data: xr.Dataset) -> Row:
    """Which bands come close to the lower edge."""
    highest = data["frequency"].max("wavevector").values[: gap.between[0]]
    near = tuple(
        int(band) for band in data["band"].values[: gap.between[0]][highest > (1 - NEAR) * gap.lower]
    )
    return (
        "Lower edge formed by",
        f"M{', M'.join(map(str, paper.BELOW))}",
        f"bands {', '.join(map(str, near))}",
        "none" if near == paper.BELOW else "differ",
        f"We count the bands that reach to within {NEAR:.0%} of the edge; band {gap.between[0]} makes it.",
    )


def _edge_row(edge: str, theirs: float, ours: float, error: float, why: str) -> Row:
    name = f"Complete gap, {edge} edge" if edge else "Complete gap, width"
    difference = ours - theirs
    shown = minus(f"{difference / 1e3:+.2f} kHz ({difference / theirs:+.1%})")
    return (name, f"{theirs / 1e3:.1f} kHz", f"{khz(ours, error)} kHz", shown, why)


def _why_lower(gap: Gap, data: xr.Dataset) -> str:
    place = _place(np.array(gap.lower_kappa), data)
    said = f"Our edge lies {place}, found by sampling the whole irreducible zone. "
    if gap.lower < paper.GAP[0]:
        said += (
            "Elements that are too coarse are too stiff and raise frequencies, which is the sign seen here."
        )
    return said.strip()


def _why_upper(gap: Gap, filleted: Gap | None) -> str:
    if gap.upper + gap.upper_error >= paper.GAP[1]:
        return "Agrees within our error." if gap.upper - gap.upper_error <= paper.GAP[1] else "Not known."
    return (
        f"The converged edge is {khz(gap.upper, gap.upper_error)} kHz. Coarse quadratic tetrahedra give "
        f"about {paper.COARSE_UPPER_EDGE / 1e3:.1f} kHz for the same cell, close to the paper's figure. A "
        "fillet at the foot, as machining leaves one, stiffens the pillar and would raise the edge too, if "
        f"the paper's model had it. {_of_a_fillet(gap, filleted)}"
    )


def _of_a_fillet(gap: Gap, filleted: Gap | None) -> str:
    """Whether a fillet could be the cause of both of the paper's edges, by the gap with one."""
    if filleted is None or filleted.upper <= gap.upper:
        return "Which of the two it was is not known."
    share = (paper.GAP[1] - gap.upper) / (filleted.upper - gap.upper)
    lower = gap.lower + share * (filleted.lower - gap.lower)
    off = lower - paper.GAP[0]
    said = (
        f"A radius of about {share * paper.TRIED_FILLET * 1e3:.2g} mm would do, but it moves the lower edge "
        f"as well, to {lower / 1e3:.1f} kHz, where the paper has {paper.GAP[0] / 1e3:.1f}: "
    )
    doubt = gap.lower_error + filleted.lower_error
    return said + (
        "that fits both edges." if abs(off) <= doubt else "a fillet alone does not fit both edges."
    )


def _place(kappa: np.ndarray, data: xr.Dataset) -> str:
    """Where a wavevector lies, in words: at a corner, inside a segment of the path, or inside the zone."""
    labels = along(data)
    corners = data["kappa"].values[json.loads(data.attrs["path_corners"])]
    for label, corner in zip(labels, corners, strict=True):
        if np.allclose(kappa, corner, atol=1e-6):
            return f"at {label}"
    for k in range(len(labels) - 1):
        side, reach = corners[k + 1] - corners[k], kappa - corners[k]
        off = abs(side[0] * reach[1] - side[1] * reach[0]) / (side @ side)
        if off < 1e-6 and 0 < reach @ side < side @ side:
            return f"between {labels[k]} and {labels[k + 1]}, not at a corner"
    return "inside the irreducible zone, off its edge"


def _mode_rows(data: xr.Dataset) -> list[Row]:
    names = mode_names(data)
    if len(names) < max(paper.ABOVE):
        return []
    named = {number: names[number - 1] for number in range(1, len(names) + 1)}
    rows = []
    for a, b in paper.PAIRS:
        alike = named[a] == named[b] and named[a].startswith("pillar bending")
        rows.append(
            (
                f"M{a} and M{b}",
                "a pair by flexural mode",
                named[a] if named[a] == named[b] else f"{named[a]} and {named[b]}",
                "none" if alike else "differ",
                "Bending in two planes, which the wavevector makes unlike." if alike else "Not known.",
            )
        )
    rows.append(_named_row(paper.TRACTION, "traction", named, ""))
    rows.append(_named_row(paper.EXPANSION, "expansion", named, _about_expansion(named[paper.EXPANSION])))
    rows.append(_pair_row(data))
    return rows


def _named_row(number: int, theirs: str, named: dict[int, str], why: str) -> Row:
    same = named[number] == theirs
    reason = "The pillar moves along its axis." if same else why or "Not known."
    return (f"M{number}", theirs, named[number], "none" if same else "name", reason)


def _about_expansion(ours: str) -> str:
    if ours != "torsion":
        return ""
    return (
        "In ours the pillar's sections turn about its axis, which holds most of the kinetic energy. Drawn "
        "with magnified displacements a torsion looks like a widening of the pillar (see the mode shapes). "
        "Whether the paper means this motion is not known."
    )


def _pair_row(data: xr.Dataset) -> Row:
    """Whether the two bands above the gap meet where the upper edge is, as a pair."""
    first, second = min(paper.ABOVE), max(paper.ABOVE)
    lowest = int(data["frequency"].sel(band=first).values.argmin())
    one, two = (float(data["frequency"].sel(band=band)[lowest]) for band in (first, second))
    errors = sum(float(data["frequency_error"].sel(band=band)[lowest]) for band in (first, second))
    paired = abs(two - one) <= errors
    place = _place(data["kappa"].values[lowest], data)
    names = json.loads(data.attrs["character_names"])
    kinds = [names[int(data["character"].sel(band=band)[lowest])] for band in (first, second)]
    return (
        "Upper edge formed by",
        f"the pair M{first} and M{second}",
        f"bands {first} and {second}, {'equal' if paired else 'not equal'} {place}",
        "none" if paired else "differ",
        (f"They are {abs(two - one):.2g} Hz apart there, less than their errors" if paired else "Not known")
        + f"; there they are {' and '.join(dict.fromkeys(kinds))}.",
    )


def _trend_rows(results: Results) -> list[Row]:
    rows = []
    for sweep in results.sweeps:
        trend = trend_of(sweep)
        if trend is not None and np.isfinite(trend.slender).all():
            rows.append(_trend_row(readable(sweep.attrs["expression"]), trend))
    return rows


def _trend_row(name: str, trend: Trend) -> Row:
    slender = trend.power(trend.slender[:, trend.nearest]).exponent
    stocky, upper = trend.power(trend.stocky[:, trend.nearest]), trend.power(trend.upper)
    lower = trend.power(trend.lower)
    difference = upper.exponent - slender
    smaller = "Same direction, smaller exponent. " if abs(upper.exponent) < abs(slender) else ""
    return (
        f"Exponent of the gap's edges in {name}",
        minus(f"{slender:.0f}, by equation (3)"),
        minus(f"{upper} upper, {lower} lower"),
        minus(f"{difference:+.2f} (upper)"),
        f"{smaller}Equation (3) takes the pillar as slender and its foot as clamped; "
        + minus(f"with shear and rotary inertia alone the exponent is {stocky}."),
    )


def _bragg_row(results: Results) -> Row:
    material, carrier = results.study.cell.material, results.study.carrier or paper.BRAGG_FREQUENCY
    assert isinstance(material, IsotropicMaterial)
    speed, pitch = material.shear_speed, results.study.cell.lattice.pitch
    theirs, ours = paper.BRAGG_SPEED / paper.BRAGG_FREQUENCY * 1e3, speed / carrier * 1e3
    return (
        "Period for Bragg scattering, c / f",
        f"{theirs:.0f} mm",
        f"{ours:.0f} mm",
        minus(f"{ours - theirs:+.1f} mm"),
        f"The paper takes c = {paper.BRAGG_SPEED:.0f} m/s; ours is the speed of shear waves, {speed:.0f} "
        f"m/s, at {carrier / 1e3:g} kHz. Either is far above the pitch of {pitch * 1e3:g} mm: the gap comes "
        "from resonance of the pillars, not from Bragg scattering.",
    )
