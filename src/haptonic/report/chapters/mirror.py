"""The lattice as a mirror: how many rows are enough, and which waveguide fits between two of them."""

from __future__ import annotations

import numpy as np

from haptonic.report.chapter import Absent, Chapter, Finding, Results
from haptonic.results.guides import Guides
from haptonic.results.layers import Layers
from haptonic.units import hz_text

TITLE = "Mirror"
ROWS = 3  # of cells on either side of a guide, as prototypes have them
ALMOST_TOTAL = 20.0  # dB: one percent of the energy passes


def chapter(results: Results) -> Chapter | Absent:
    """What rows of cells let through, and the waveguide between two mirrors."""
    layers, guides = results.of(Layers), results.of(Guides)
    if layers is None:
        return Absent(TITLE, "it was not computed in this run")
    words = {
        "layers": layers.summary()[0],
        "decay": "Waves that propagate or fade in the lattice against frequency.",
    }
    pictures = results.pictures(layers, words)
    tables = layers.tables()
    if guides is not None:
        pictures += results.pictures(guides, {"waveguide": guides.summary()[1]})
        tables += guides.tables()
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
        findings=tuple(_findings(layers, guides)),
        pictures=pictures,
        tables=tuple(tables),
    )


def _findings(layers: Layers, guides: Guides | None) -> list[str]:
    carrier, rows = layers.carrier, ROWS
    said: list[str] = []
    if "A0" in layers.families:
        seen = layers.at_carrier.sel(incident="A0", rows=rows)
        total, same = float(seen["insulation"]), float(seen["same_wave"])
        verdict = "almost" if total >= ALMOST_TOTAL else "not"
        told = (
            f"At the carrier, {hz_text(carrier, form='g')}, three rows let {10 ** (-total / 10):.1%} of the "
            f"energy of a flexural wave (A0) at this angle through, {total:.1f} dB: {verdict} total "
            f"reflection. What passes as the same kind of wave is {same:.1f} dB below the incident one; the "
            "rest of what passes was turned into other waves."
        )
        said.append(Finding(told, "layers"))
        frequency, insulation = _best_in_gap(layers, rows)
        if frequency:
            where = hz_text(frequency, form=".1f")
            told = f"Within the gap three rows stop most at {where}: {insulation:.0f} dB."
            said.append(Finding(told, "layers"))
    if guides is not None:
        best, three = guides.best, rows * guides.best.decay
        along = np.degrees(np.arcsin(min(1.0, best.mode.wavenumber / _free_wavenumber(guides))))
        told = (
            f"The waves of the waveguide's mode meet the rows at {along:.0f}° from the normal. For them the "
            f"lattice fades by {best.decay:.1f} dB per row, about {three:.0f} dB in three."
        )
        said.append(Finding(told, "decay"))
    return said


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
