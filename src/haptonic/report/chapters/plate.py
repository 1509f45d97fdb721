"""The finite plate: where it vibrates below, in and above the gap."""

from __future__ import annotations

from dataclasses import replace

from haptonic.report.chapter import Absent, Chapter, Picture, Results
from haptonic.results.plate.tables import lines_table, modes_table
from haptonic.results.plate.value import ERRORS, PlateResult

TITLE = "Plate"
LOCALISED = 20.0  # dB of contrast that the prototype is expected to reach in the gap
EVERYWHERE = 10.0  # dB of contrast below which the whole plate vibrates
MOST_MODES = 12


def chapter(results: Results) -> Chapter | Absent:
    """Maps, contrast, impedance and modes of the finite plate."""
    result = results.of(PlateResult)
    if result is None:
        return Absent(TITLE, "it was not computed in this run")
    figures = result.figures
    words = {
        "plan": "Map of tiles with pillars, regions, actuators and supports.",
        "maps": "; ".join(_in_words(result, k) for k in range(len(result.map_lines))),
        "contrast": "Level of the driven region above the others against frequency.",
        "velocity": "Root mean square velocity of each region against frequency.",
    }
    pictures = [
        Picture(
            figures[name],
            figures.captions[name] + results.where(name),
            words.get(name, "Magnitude and phase against frequency."),
        )
        for name in figures
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
        findings=tuple(_findings(result)),
        pictures=tuple(pictures),
        tables=tuple(
            one.labelled("simulated") for one in (lines_table(result), modes_table(_nearest(result)))
        ),
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


def _nearest(result: PlateResult) -> PlateResult:
    """With the modes that lie nearest to the map in the gap only."""
    modes = result.modes
    nearest = abs(modes["mode_frequency"] - result.resonance).argsort().values[:MOST_MODES]
    return replace(result, modes=modes.isel(mode=sorted(nearest.tolist())))
