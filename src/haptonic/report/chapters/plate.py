"""The finite plate: where it vibrates below, in and above the gap, beside the paper's description."""

from __future__ import annotations

import numpy as np
import xarray as xr

from haptonic.report import paper
from haptonic.report.chapter import Absent, Chapter, Picture, Results, Table
from haptonic.report.guide_shifts import AS_IT_IS
from haptonic.results import PlateResult
from haptonic.results.plate.value import ERRORS

TITLE = "Plate"
LOCALISED = 20.0  # dB of contrast that the prototype is expected to reach in the gap
EVERYWHERE = 10.0  # dB of contrast below which the whole plate vibrates
MOST_MODES = 12


def chapter(results: Results) -> Chapter | Absent:
    """Maps, contrast, impedance and modes of the finite plate."""
    result = results.plate
    if result is None:
        return Absent(TITLE, "it was not computed in this run")
    figures = result.figures()
    captions = {
        "plan": "Simulated plate: its pillars, regions, actuators and supports.",
        "maps": "Simulated normal velocity of the flat face, each map scaled to its largest point. The paper "
        "(Fig. 5C) shows the driven waveguide alone in the gap, and the whole plate below and above it.",
        "contrast": "Simulated contrast of the driven region.",
        "velocity": "Simulated velocity of the regions.",
    }
    words = {
        "plan": "Map of tiles with pillars, regions, actuators and supports.",
        "maps": "; ".join(_in_words(result, k) for k in range(len(result.map_lines))),
        "contrast": "Level of the driven region above the others against frequency.",
        "velocity": "Root mean square velocity of each region against frequency.",
    }
    pictures = [
        Picture(
            figure,
            captions.get(name, f"Simulated electrical impedance of {name.removeprefix('impedance-')}."),
            words.get(name, "Magnitude and phase against frequency."),
        )
        for name, figure in figures.items()
    ]
    return Chapter(
        title=TITLE,
        identifier="plate",
        paragraphs=(
            f"The plate has {result.plate.layout.pillars} pillars and is computed from condensed tiles with "
            f"{result.lines.attrs['unknowns']} unknowns on {result.lines.attrs['basis']} vectors. At every "
            "line the answer was put back into the unreduced equations; the largest error of the field that "
            f"this bounds is {float(result.lines['error'].max()):.0e}. {ERRORS} Loss factor of the plate: "
            f"{result.plate.loss_factor:g}, assumed.",
        ),
        findings=(*_findings(result), *_shift_findings(results.guide_shifts)),
        pictures=tuple(pictures),
        tables=(_lines_table(result), _modes_table(result), *_shifts_tables(results.guide_shifts)),
    )


def _in_words(result: PlateResult, k: int) -> str:
    line = result.map_lines[k]
    loudest = max(result.told(line)["rms"].items(), key=lambda pair: pair[1], default=("nothing", 0.0))[0]
    return f"at {float(line.frequency[0]) / 1e3:.1f} kHz {loudest} vibrates most"


def _findings(result: PlateResult) -> list[str]:
    said = []
    gap = result.gap
    for line in result.map_lines:
        told = result.told(line)
        frequency = told["frequency_hz"]
        where = "in" if gap and gap.lower < frequency < gap.upper else "outside of"
        for name, level in told["contrast_db"].items():
            verdict = "the vibration stays there" if level >= LOCALISED else (
                "the whole plate vibrates" if level < EVERYWHERE else "part of it goes elsewhere"
            )  # fmt: skip
            said.append(f"{name} at {frequency / 1e3:.2f} kHz, {where} the gap: {level:.1f} dB; {verdict}.")
    named = [
        (str(mode["name"].values), float(mode["mode_frequency"]))
        for mode in (result.modes.isel(mode=k) for k in range(result.modes.sizes["mode"]))
    ]
    lobes = [f"{name} at {frequency / 1e3:.2f} kHz" for name, frequency in named if name.startswith("0x")]
    if lobes:
        said.append(f"Modes near the carrier with one lobe across a guide: {'; '.join(lobes)}.")
    driven = [k for k, (name, _) in enumerate(named) if name.startswith("0x")]
    if driven and result.driven in result.modes["region"].values:
        shares = result.modes["stored"].sel(region=result.driven).values
        k = max(driven, key=lambda mode: shares[mode])
        quality, plate_alone = float(result.modes["quality"][k]), 1 / result.plate.loss_factor
        lattice = sum(float(result.modes["stored"].sel(region=name)[k]) for name in result.plate.layout.cells)
        said.append(
            f"The driven guide's mode {named[k][0]} has a quality factor of {quality:.0f}; the plate's loss "
            f"alone would give {plate_alone:.0f}. The mirrors hold {100 * lattice:.0f} % of its strain "
            "energy and have the plate's loss factor, so they cost no quality while theirs is no larger: "
            f"the {100 * (1 - quality / plate_alone):.1f} % that are missing go into patch, bond and "
            "supports."
        )
    return said


def _shift_findings(shifts: xr.Dataset | None) -> list[str]:
    if shifts is None:
        return []
    frequency = dict(zip(shifts["plate"].values.tolist(), shifts["mode_frequency"].values, strict=True))
    base = frequency.pop(AS_IT_IS)
    missing = 100 * (paper.RESONANCE / base - 1)
    parts = "; ".join(f"{label}: {100 * (f / base - 1):+.1f} %" for label, f in frequency.items() if f == f)
    return [
        f"The paper's mode {paper.GUIDE_MODE} lies at {paper.RESONANCE / 1e3:.1f} kHz, {missing:.1f} % above "
        f"that of the computed plate without its patch, {base / 1e3:.2f} kHz. One thing changed at a time "
        f"moves it by: {parts}."
    ]


def _shifts_tables(shifts: xr.Dataset | None) -> tuple[Table, ...]:
    if shifts is None:
        return ()
    base = float(shifts["mode_frequency"].sel(plate=AS_IT_IS))
    rows = tuple(
        (str(label), f"{f / 1e3:.2f} kHz", f"{100 * (f / base - 1):+.2f} %")
        if np.isfinite(f)
        else (str(label), "not found", "")
        for label, f in zip(shifts["plate"].values, shifts["mode_frequency"].values, strict=True)
    )
    caption = (
        f"What moves the driven guide's mode {paper.GUIDE_MODE} (paper: {paper.RESONANCE / 1e3:.1f} kHz)"
    )
    return (Table(caption, ("plate", "frequency", "against the first"), rows),)


def _lines_table(result: PlateResult) -> Table:
    regions = [name for name in result.response.regions if name]
    units = result.response.units
    rows = []
    for line in result.map_lines:
        told = result.told(line)
        rows.append(
            (
                f"{told['frequency_hz'] / 1e3:.2f} kHz",
                *(f"{told['rms'][name]:.3g}" for name in regions),
                *(f"{told['finger_um'][name]:.3g}" for name in regions),
                f"{told['given_w']:.3g}",
            )
        )
    head = (
        "frequency",
        *(f"{name}, rms {units}" for name in regions),
        *(f"{name}, below a finger {units.replace('m/s', 'um')}" for name in regions),
        "power, W",
    )
    return Table("Simulated vibration at the frequencies of the maps", head, tuple(rows))


def _modes_table(result: PlateResult) -> Table:
    modes = result.modes
    regions = modes["region"].values.tolist()
    regions += [f"patch {name}" for name in modes["actuator"].values.tolist()]
    nearest = abs(modes["mode_frequency"] - result.resonance).argsort().values[:MOST_MODES]
    rows = []
    for k in sorted(nearest.tolist()):
        mode = modes.isel(mode=k)
        rows.append(
            (
                f"{float(mode['mode_frequency']) / 1e3:.3f}",
                str(mode["name"].values) or "no product",
                f"{float(mode['quality']):.0f}",
                f"{float(mode['rise_time']) * 1e3:.1f} ms",
                *(
                    f"{100 * share:.1f} %"
                    for share in (*mode["stored"].values, *mode["stored_in_actuator"].values)
                ),
            )
        )
    head = (
        "frequency, kHz",
        "name",
        "Q",
        "10 to 90 % rise",
        *(f"strain energy in {name}" for name in regions),
    )
    where = f"{result.resonance / 1e3:.2f} kHz"
    return Table(f"Simulated modes near the frequency of the map, {where}", head, tuple(rows))
