"""What commands about scans say to people: the drive, what a scan told."""

from __future__ import annotations

import numpy as np
from rich.table import Table

from haptonic.cli.console import Voice
from haptonic.results.scan import ScanResult


def tell_scan(result: ScanResult, voice: Voice) -> None:
    """What was read, how it was registered, the gap in it, and its operating shapes."""
    if not result.report.complete or result.report.remarks:
        voice.tell(str(result.report))
    for text in result.told:
        voice.warn(text)
    told = result.to_json()
    flags = ", ".join(f"{count} {flag}" for flag, count in told["flags"].items() if count) or "none flagged"
    voice.tell(
        f"{told['points']} points ({flags}), {told['lines']} lines from {told['band_hz'][0] / 1e3:.4g} to "
        f"{told['band_hz'][1] / 1e3:.4g} kHz, {result.origin}."
    )
    if result.registration is not None:
        found = result.registration
        x, y = 1e3 * found.shift
        voice.tell(
            f"Registered: scale {found.scale:.5f}, turned by {np.degrees(found.angle):.3f}°, shifted by "
            f"{x:.3f} and {y:.3f} mm; misfit {found.misfit * 1e3:.3f} mm."
        )
    if result.lattice is not None:
        computed = (
            f"; computed {result.gap.lower / 1e3:.2f} to {result.gap.upper / 1e3:.2f} kHz"
            if result.gap
            else ""
        )
        lower, upper = (edge or "not determined" for edge in (result.lattice.lower, result.lattice.upper))
        voice.tell(f"Gap in the scan: lower edge {lower}, upper edge {upper}{computed}.")
        for text in result.lattice.reasons:
            voice.tell(f"  {text}")
    if result.measured is not None:
        seen = result.measured
        voice.tell(
            f"The driven region stands out from the lattice from {seen.lower / 1e3:.2f} ± "
            f"{seen.lower_error / 1e3:.2f} to {seen.upper / 1e3:.2f} ± {seen.upper_error / 1e3:.2f} kHz."
        )
    voice.tell(shapes_table(result))


def _number(value: float | None, form: str) -> str:
    return "-" if value is None else format(value, form)


def shapes_table(result: ScanResult) -> Table:
    """Velocities, contrasts and decay at the frequencies of the operating shapes."""
    lines = [result.told_at(frequency) for frequency in result.shapes]
    table = Table(
        "operating shape", *(f"{line['frequency_hz'] / 1e3:.3f} kHz" for line in lines), title=result.origin
    )
    rows: dict[str, list[str]] = {
        f"rms / ({result.response.units})": [f"{line['rms_of_all']:.3g}" for line in lines]
    }
    for name in lines[0]["rms"]:
        rows[f"rms of {name}"] = [_number(line["rms"][name], ".3g") for line in lines]
    for name in lines[0]["contrast_db"]:
        rows[f"{name} / dB"] = [_number(line["contrast_db"][name], ".1f") for line in lines]
    decays = [line.get("decay_db_per_cell", {}) for line in lines]
    if any(decays):
        rows["decay / (dB/cell)"] = [
            f"{d['decay']:.1f} ({d['low']:.1f} to {d['high']:.1f})" if d else "" for d in decays
        ]
        rows["computed"] = [
            f"{d['computed_least']:.1f} to {d['computed_largest']:.1f}" if "computed_least" in d else ""
            for d in decays
        ]
    for name, cells in rows.items():
        table.add_row(name, *cells)
    return table


def drive_table(answer: dict[str, object]) -> Table:
    """A drive and a plan as a person reads them."""
    table = Table("", "", title="excitation", show_header=False)
    numbers = {name: float(str(value)) for name, value in answer.items() if isinstance(value, int | float)}
    table.add_row("band", f"{numbers['low'] / 1e3:.5g} to {numbers['high'] / 1e3:.5g} kHz")
    table.add_row("lines", f"{numbers['lines']:.0f}, {numbers['line_spacing_hz']:.4g} Hz apart")
    table.add_row(
        "period", f"{numbers['duration_s'] * 1e3:.4g} ms, {numbers['averages']:.0f} recorded at each point"
    )
    table.add_row("sample rate", f"{numbers['sample_rate'] / 1e3:.5g} kHz")
    table.add_row(
        "largest value",
        f"{numbers['full_scale']:.4g} {answer['unit']}, crest factor {numbers['crest_factor']:.3f}",
    )
    plan = answer["plan"]
    if isinstance(plan, dict):
        table.add_row("points", f"{plan['points']}, {plan['left_out']} left out")
        table.add_row("way", f"{plan['travel_m']:.3g} m, {plan['measuring_s']:.0f} s of recording")
    return table
