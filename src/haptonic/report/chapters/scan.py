"""Chapter on the simulated scan of the plate: maps, contrast, and the gap."""

from __future__ import annotations

import numpy as np

from haptonic import plots
from haptonic.errors import HaptonicError
from haptonic.report.chapter import Absent, Chapter, Finding, Picture, Results, Table
from haptonic.results.plate.value import PlateResult
from haptonic.results.scan import ScanResult
from haptonic.results.table import Column
from haptonic.units import hz_text
from haptonic.vibrometry import MeasuredGap
from haptonic.vibrometry.on_plate import contrast_range

TITLE = "Simulated scan"
MEANING = (
    "The analysis reports an edge of the lattice's gap at the frequency at which waves in the rows of "
    "pillars begin to decay, if the few rows of the plate show it. High contrast, where the driven region "
    "vibrates much more than the lattices, is a property of this plate and drive: it may continue beyond the "
    "gap, where waves that pass the lattice do not exist in the driven guide."
)
CLOSE = 0.5  # dB, within which the contrast of a scan counts as that of the plate


def chapter(results: Results) -> Chapter | Absent:
    """Maps of the simulated scan below the computed ones, contrast, and the gaps beside one another."""
    plate, scan = results.of(PlateResult), results.of(ScanResult)
    if plate is None or scan is None:
        return Absent(TITLE, "no scan was simulated in this run")
    edges = plate.gap.edges if plate.gap else None
    rows = {"computed": plate.response, "simulated scan": scan.response}
    maps = Picture(
        plots.maps_compared(rows, scan.shapes, plate.plate.layout, edges),
        f"Simulated normal displacement of the flat face{results.where('maps')}; below it that of the "
        f"simulated scan{results.where('scan')}. All maps are on one scale; grey: not scanned.",
        "Maps below, in and above the gap, computed ones above those of the simulated scan.",
    )
    words = {
        "contrast": "Contrast against frequency; the range of high contrast and the computed gap are marked."
    }
    return Chapter(
        title=TITLE,
        identifier="scan",
        paragraphs=(_what(results, scan), MEANING),
        findings=(
            *_everywhere(plate, scan),
            *(f"{reason[0].upper()}{reason[1:]}." for reason in scan.undetermined),
        ),
        pictures=(maps, *results.pictures(scan, words)),
        tables=(_levels(plate, scan), _gaps(plate, scan)),
    )


def _what(results: Results, scan: ScanResult) -> str:
    asked, lines = results.study.scan_settings, scan.response.frequency
    instrument = asked.instrument
    return (
        "The records are simulated. The instrument takes the velocity of the "
        f"computed plate at {scan.response.dataset.sizes['point']} points and {len(lines)} lines "
        f"{lines[1] - lines[0]:.4g} Hz apart, those of the response in place of the band of [scan], records "
        f"{asked.averages} periods "
        f"with noise of {1e6 * instrument.noise:.3g} µm/s and {instrument.bits} bits, and loses the surface "
        f"at {scan.flags['dropout']} points. The records are analysed like measured ones. The comparison "
        "shows the errors of instrument and analysis, not those of the model of the plate."
    )


def _levels(plate: PlateResult, scan: ScanResult) -> Table:
    rows = []
    for frequency in scan.shapes:
        scanned = {
            name: level.sel(frequency=frequency, method="nearest") for name, level in scan.contrasts.items()
        }
        for name, level in plate.contrasts(plate.response.at(frequency)).items():
            rows.append(
                (
                    f"{name}, {hz_text(frequency, form='.2f')}",
                    float(level[0]),
                    float(scanned.get(name, np.nan)),
                )
            )
    columns = Column("computed", "dB", form=".1f"), Column("simulated scan", "dB", form=".1f")
    return Table("Simulated contrast at the maps.", ("contrast", *columns), rows)


def _everywhere(plate: PlateResult, scan: ScanResult) -> list[str]:
    """Compare the first contrast of the scan with that of the plate at all frequencies."""
    for name, level in plate.contrasts(plate.response).items():
        if name not in scan.contrasts:
            continue
        off = np.abs(scan.contrasts[name].values - level.values)
        given = np.isfinite(off)
        if not given.any():
            return [f"{name} is not determined at any frequency because of noise."]
        worst = int(np.nanargmax(off))
        hidden = "" if given.all() else "; noise hides it at the others"
        text = (
            f"{name} is determined at {given.sum()} of {len(off)} frequencies{hidden}. "
            f"It is within {CLOSE:g} dB of the computed contrast at {(off < CLOSE).sum()} of them. The "
            f"largest difference is {off[worst]:.2f} dB, at "
            f"{hz_text(plate.response.frequency[worst], form='.3g')}."
        )
        return [Finding(text, "contrast")]
    return []


def _gaps(plate: PlateResult, scan: ScanResult) -> Table:
    rows: list[tuple[str, ...]] = []
    if plate.gap:
        rows.append(
            (
                "lattice, computed",
                hz_text(plate.gap.lower, error=plate.gap.lower_error),
                hz_text(plate.gap.upper, error=plate.gap.upper_error),
            )
        )
    if scan.lattice:
        edges = (scan.lattice.lower, scan.lattice.upper)
        other = plate.gap is not None and scan.lattice.beside(*plate.gap.edges)
        rows.append(
            (
                "lattice, simulated scan (experimental)"
                + ": another range, perhaps a gap of some waves" * other,
                *(str(edge or "not determined") for edge in edges),
            )
        )
    try:
        rows.append(
            (
                "high contrast, computed plate (experimental)",
                *_edges(contrast_range(plate.response, plate.plate)),
            )
        )
    except HaptonicError as error:
        rows.append(("high contrast, computed plate (experimental)", "none", error.given))
    if scan.measured:
        rows.append(("high contrast, simulated scan (experimental)", *_edges(scan.measured)))
    return Table(
        "Simulated gaps, with bounds of errors if computed, and standard errors if from a scan.",
        ("where", "from", "to"),
        tuple(rows),
    )


def _edges(gap: MeasuredGap) -> tuple[str, str]:
    return (
        hz_text(gap.lower, form=".1f", error=gap.lower_error),
        hz_text(gap.upper, form=".1f", error=gap.upper_error),
    )
