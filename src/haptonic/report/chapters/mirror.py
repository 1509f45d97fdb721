"""The lattice as a mirror: how many rows are enough, and which waveguide fits between two of them."""

from __future__ import annotations

from math import isclose

import numpy as np

from haptonic import plots
from haptonic.bloch.mirrors import MOST_ROWS
from haptonic.report import paper
from haptonic.report.chapter import Absent, Chapter, Picture, Results, Table
from haptonic.results import Guides, Layers
from haptonic.results.guides import Strip

TITLE = "Mirror"
ALMOST_TOTAL = 20.0  # dB: one percent of the energy passes


def chapter(results: Results) -> Chapter | Absent:
    """What rows of cells let through, and the waveguide between two mirrors."""
    layers, guides = results.layers, results.guides
    if layers is None:
        return Absent(TITLE, "it was not computed in this run")
    compared = paper.is_its_cell(results.study)
    pictures = [
        Picture(
            plots.layers(layers.dataset),
            "Simulated energy that rows of cells let through between two plain plates.",
            _in_words(layers),
        ),
        Picture(
            plots.decay(layers.dataset),
            "Simulated complex band structure across the rows (left, middle), and decay per cell of the wave "
            "that reaches farthest, for several phases along the rows (right).",
            "Waves that propagate or fade in the lattice against frequency.",
        ),
    ]
    tables = [_rows_table(layers), _needed_table(layers)]
    if guides is not None:
        best = guides.best
        pictures.append(
            Picture(
                plots.guide(best.mode.position, best.mode.amplitude, best.mode.width, best.fixed_line),
                f"Simulated mode across a waveguide {best.mode.width * 1e3:.1f} mm wide.",
                f"The amplitude falls to {best.mode.at_edge:.0%} of its peak at the lattice.",
            )
        )
        tables.append(_guide_table(guides, compared))
    loss = float(layers.dataset.attrs["loss_factor"])
    return Chapter(
        title=TITLE,
        identifier="mirror",
        paragraphs=(
            "A plane wave of the plate meets rows of cells that repeat without end along the rows; behind "
            "them the plain plate goes on. All waves that leave count, also those of another kind than the "
            f"incident one. The rows have a loss factor of {loss:g}, the plates none. Without that loss "
            "reflected and transmitted energy add up to the incident one to "
            f"{float(layers.dataset.attrs['energy_balance']):.0e}.",
        ),
        findings=tuple(_findings(layers, guides, compared)),
        pictures=tuple(pictures),
        tables=tuple(tables),
    )


def _in_words(layers: Layers) -> str:
    return "; ".join(
        f"incident {family}: {layers.dataset.sizes['rows']} rows let "
        f"{-layers.insulation(family)[layers.dataset.sizes['rows'] - 1]:.0f} dB through at the carrier"
        for family in layers.families
    )


def _findings(layers: Layers, guides: Guides | None, compared: bool) -> list[str]:
    carrier, rows = float(layers.dataset.attrs["carrier_hz"]), paper.ENOUGH_ROWS
    said, flexural = [], "A0" in layers.families
    if flexural:
        total, same = layers.insulation("A0")[rows - 1], layers.same_wave("A0")[rows - 1]
        verdict = "almost" if total >= ALMOST_TOTAL else "not"
        said.append(
            f"At the carrier, {carrier / 1e3:g} kHz, three rows let {10 ** (-total / 10):.1%} of the energy "
            f"of a flexural wave (A0) at this angle through, {total:.1f} dB: {verdict} total reflection. "
            f"What passes as the same kind of wave is {same:.1f} dB below the incident one; the rest of what "
            "passes was turned into other waves."
        )
        frequency, insulation = _best_in_gap(layers, rows)
        if frequency:
            said.append(
                f"Within the gap three rows stop most at {frequency / 1e3:.1f} kHz: {insulation:.0f} dB."
            )
    if guides is not None:
        best, three = guides.best, rows * guides.best.decay
        along = np.degrees(np.arcsin(min(1.0, best.mode.wavenumber / _free_wavenumber(guides))))
        said.append(
            f"The waves of the waveguide's mode meet the rows at {along:.0f}° from the normal. For them the "
            f"lattice fades by {best.decay:.1f} dB per row, about {three:.0f} dB in three."
        )
        if compared and _is_the_papers(best) and flexural:
            angle = np.degrees(float(layers.dataset.attrs["angle"]))
            direction = "head-on" if angle == 0 else f"at {angle:.3g}° from the normal"
            enough = "holds" if three >= ALMOST_TOTAL else "does not hold"
            other = "" if total >= ALMOST_TOTAL else f", but not for waves that meet the rows {direction}"
            said.append(
                "That three rows are enough, which the paper says without details, "
                f"{enough} for the mode of the waveguide{other}."
            )
            ours, theirs = best.frequency / 1e3, paper.RESONANCE / 1e3
            said.append(
                f"The paper's waveguide resonates at {ours:.2f} kHz in this model, {ours / theirs - 1:+.1%} "
                f"off the {theirs:g} kHz that it gives. Its ends are taken as those of a long beam."
            )
    return said


def _is_the_papers(strip: Strip) -> bool:
    """Whether a waveguide has the width, the length and the nodal lines of the paper's."""
    pairs = (
        (strip.mode.width, paper.GUIDE_WIDTH),
        (strip.length, paper.GUIDE_LENGTH),
        (strip.spacing, paper.NODAL_SPACING),
    )
    return strip.mode.nodal_lines == 0 and all(isclose(ours, theirs, rel_tol=1e-3) for ours, theirs in pairs)


def _free_wavenumber(guides: Guides) -> float:
    """Of the flexural wave in the plain plate at the mode's frequency, rad/m, from its two components."""
    best = guides.best
    across = np.pi * (best.mode.nodal_lines + 1) / (best.mode.width + 2 * best.fixed_line)
    return float(np.hypot(across, best.mode.wavenumber))


def _best_in_gap(layers: Layers, rows: int) -> tuple[float, float]:
    """Frequency (Hz) in the gap at which so many rows stop A0 best, and how well, dB; zeros without one."""
    data, gap = layers.dataset, layers.gap
    if gap is None or data.sizes["rows"] < rows:
        return 0.0, 0.0
    frequency = data["frequency"].values
    inside = (frequency > gap.lower) & (frequency < gap.upper)
    if not inside.any():
        return 0.0, 0.0
    passed = data["transmitted"].sel(incident="A0", rows=rows).sum("outgoing", skipna=False).values[inside]
    best = int(np.nanargmin(passed))
    return float(frequency[inside][best]), float(-10 * np.log10(passed[best]))


def _rows_table(layers: Layers) -> Table:
    carrier = float(layers.dataset.attrs["carrier_hz"]) / 1e3
    head = ("Rows", *(f"Incident {family}" for family in layers.families))
    rows = tuple(
        (
            str(count),
            *(f"{layers.insulation(f)[k]:.1f} ({layers.same_wave(f)[k]:.1f})" for f in layers.families),
        )
        for k, count in enumerate(layers.dataset["rows"].values)
    )
    return Table(
        f"Energy that passes at {carrier:g} kHz {layers.incidence}, dB below the incident wave: all waves, "
        "in brackets the same kind alone.",
        head,
        rows,
    )


def _needed_table(layers: Layers) -> Table:
    goals = list(layers.needed(layers.families[0]))
    rows = tuple(
        (family, *(str(n) if n else f"more than {MOST_ROWS}" for n in layers.needed(family).values()))
        for family in layers.families
    )
    caption = "Rows from which on less energy than so many dB below the incident wave passes at the carrier."
    return Table(caption, ("Incident", *(f"{goal:g} dB" for goal in goals)), rows)


def _guide_table(guides: Guides, compared: bool) -> Table:
    head = ("Width (mm)", "Length (mm)", "Frequency (kHz)", "Nodal spacing (mm)", "Edge / peak", "dB per row")
    rows = [
        (
            f"{strip.mode.width * 1e3:.2f}",
            f"{strip.length * 1e3:.0f}",
            f"{strip.frequency / 1e3:.2f}",
            f"{strip.spacing * 1e3:.2f}",
            f"{strip.mode.at_edge:.2f}",
            f"{strip.decay:.1f}",
        )
        for strip in guides.strips
    ]
    if compared:
        width, length, spacing = (
            1e3 * x for x in (paper.GUIDE_WIDTH, paper.GUIDE_LENGTH, paper.NODAL_SPACING)
        )
        rows.append(
            (f"paper: {width:g}", f"{length:g}", f"{paper.RESONANCE / 1e3:g}", f"{spacing:g}", "-", "-")
        )
    caption = (
        f"Waveguides between two such mirrors for the mode {guides.across}x{guides.along}: nodal lines "
        f"across, intervals between nodal lines along; {guides.ends} ends, approximately."
    )
    return Table(caption, head, tuple(rows))
