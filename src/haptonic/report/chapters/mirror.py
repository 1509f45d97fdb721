"""Chapter on the lattice as a mirror: the number of rows, and the waveguide between two mirrors."""

from __future__ import annotations

import numpy as np

from haptonic.names import counted
from haptonic.report.chapter import Absent, Chapter, Finding, Results
from haptonic.results.guides import Guides
from haptonic.results.layers import Layers
from haptonic.units import hz_text, in_percent, uncertain

TITLE = "Mirror"
ROWS = 3  # of cells on either side of a guide, as prototypes have them
ALMOST_TOTAL = 20.0  # dB: one percent of the energy passes


def chapter(results: Results) -> Chapter | Absent:
    """Describe the insertion loss of rows of cells, and the waveguide between two mirrors."""
    layers, guides = results.of(Layers), results.of(Guides)
    if layers is None:
        return Absent(TITLE, "it was not computed in this run")
    words = {
        "layers": layers.summary()[0],
        "decay": "Decay per row of the waves in the lattice against frequency.",
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
            "A plane wave of the plain plate meets rows of cells, which are infinitely long; behind them the "
            "plain plate continues. Transmitted energy includes waves of another kind than the incident one. "
            f"The rows have a loss factor of {loss:g}, the plain plates have no loss. If the loss of the "
            "rows is set to zero, reflected and transmitted energy differ from the incident energy by "
            f"{float(layers.dataset.attrs['energy_balance']):.0e}.",
        ),
        findings=tuple(_findings(layers, guides)),
        pictures=pictures,
        tables=tuple(tables),
        views={
            "Choose rows and frequency": layers.view() if layers.interactive else None,
            "Move the guided modes": guides.view() if guides is not None else None,
        },
    )


def _findings(layers: Layers, guides: Guides | None) -> list[str]:
    carrier, rows = layers.carrier, min(ROWS, layers.dataset.sizes["rows"])
    number = counted(rows, "row")
    findings: list[str] = []
    if "A0" in layers.families:
        levels = layers.at_carrier.sel(incident="A0", rows=rows)
        total, same = float(levels["insulation"]), float(levels["same_wave"])
        verdict = "almost total" if total >= ALMOST_TOTAL else "no total"
        text = (
            f"At the carrier, {hz_text(carrier, form='g')}, {number} transmit{'s' if rows == 1 else ''} "
            f"{in_percent(10 ** (-total / 10), form='.1f')} of the energy of a flexural wave (A0) "
            f"{layers.incidence}: insertion loss {total:.1f} dB, {verdict} reflection. Without the energy in "
            f"other kinds of waves the insertion loss is {same:.1f} dB."
        )
        findings.append(Finding(text, "layers"))
        frequency, insulation = _best_in_gap(layers, rows)
        if frequency:
            where = hz_text(frequency, form=".1f")
            text = (
                f"Within the gap the insertion loss of {number} is largest at {where}: {insulation:.0f} dB."
            )
            findings.append(Finding(text, "layers"))
    if guides is not None:
        best, together = guides.best, rows * guides.best.decay
        along = np.degrees(np.arcsin(min(1.0, best.mode.wavenumber / _free_wavenumber(guides))))
        text = (
            f"The waves of the waveguide's mode meet the rows at {along:.0f}° from the normal. In the "
            f"lattice they decay by {uncertain(best.decay, best.decay_error)} dB per row, about "
            f"{together:.0f} dB in {number}."
        )
        findings.append(Finding(text, "decay"))
    return findings


def _free_wavenumber(guides: Guides) -> float:
    """Wavenumber of the flexural wave in the plain plate at the frequency of the mode, rad/m."""
    best = guides.best
    across = np.pi * (best.mode.nodal_lines + 1) / (best.mode.width + 2 * best.fixed_line)
    return float(np.hypot(across, best.mode.wavenumber))


def _best_in_gap(layers: Layers, rows: int) -> tuple[float, float]:
    """Frequency (Hz) and size (dB) of the largest insertion loss of A0 in the gap; zeros without one."""
    data, gap = layers.dataset, layers.gap
    if not gap:
        return 0.0, 0.0
    frequency = data["frequency"].values
    inside = (frequency > gap.lower) & (frequency < gap.upper)
    if not inside.any():
        return 0.0, 0.0
    passed = data["transmitted"].sel(incident="A0", rows=rows).sum("outgoing", skipna=False).values[inside]
    best = int(np.nanargmin(passed))
    return float(frequency[inside][best]), float(-10 * np.log10(passed[best]))
