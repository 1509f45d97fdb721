"""The finite plate: where it vibrates below, in and above the gap, beside the paper's description."""

from __future__ import annotations

from haptonic.report import paper
from haptonic.report.chapter import Absent, Chapter, Picture, Results, Table
from haptonic.results import PlateResult

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
        "plan": "The plate as it was computed.",
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
            f"this bounds is {float(result.lines['error'].max()):.0e}. Loss factor of the plate: "
            f"{result.plate.loss_factor:g}, assumed.",
        ),
        findings=tuple(_findings(result, paper.is_its_cell(results.study))),
        pictures=tuple(pictures),
        tables=(_lines_table(result), _modes_table(result)),
    )


def _in_words(result: PlateResult, k: int) -> str:
    line = result.map_lines[k]
    loudest = max(result.told(line)["rms"].items(), key=lambda pair: pair[1], default=("nothing", 0.0))[0]
    return f"at {float(line.frequency[0]) / 1e3:.1f} kHz {loudest} vibrates most"


def _findings(result: PlateResult, compared: bool) -> list[str]:
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
    if compared:
        said.append(
            "The paper's resonance of the waveguide, 0x17, lies at 58.8 kHz; the mode of that name lies "
            f"{100 * (58.8e3 / dict(named)['0x17'] - 1):.1f} % lower here."
            if any(name == "0x17" for name, _ in named)
            else "With the patch on it the driven guide has no pure 0x17 mode near the paper's 58.8 kHz."
        )
    return said


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
    nearest = abs(modes["mode_frequency"] - result.carrier).argsort().values[:MOST_MODES]
    rows = []
    for k in sorted(nearest.tolist()):
        mode = modes.isel(mode=k)
        rows.append(
            (
                f"{float(mode['mode_frequency']) / 1e3:.3f} kHz",
                str(mode["name"].values) or "no product",
                f"{float(mode['quality']):.0f}",
                f"{float(mode['rise_time']) * 1e3:.1f} ms",
                *(f"{100 * share:.1f} %" for share in mode["stored"].values),
            )
        )
    head = ("frequency", "name", "Q", "10 to 90 % rise", *(f"strain energy in {name}" for name in regions))
    return Table("Simulated modes near the carrier", head, tuple(rows))
