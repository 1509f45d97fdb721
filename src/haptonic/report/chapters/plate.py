"""The finite plate: where it vibrates below, in and above the gap."""

from __future__ import annotations

from functools import partial

from haptonic import plots
from haptonic.later import xarray as xr
from haptonic.plate.vibration.datasets import part_name
from haptonic.plate.vibration.modes import has_one_lobe
from haptonic.report.chapter import Absent, Chapter, Finding, Picture, Results
from haptonic.results.plain import split
from haptonic.results.plan import border_text
from haptonic.results.plate.tables import lines_table, modes_table
from haptonic.results.plate.value import ERRORS, PlateResult
from haptonic.units import hz_text

TITLE = "Plate"
LOCALISED = 20.0  # dB of contrast that the prototype is expected to reach in the gap
EVERYWHERE = 10.0  # dB of contrast below which the whole plate vibrates
MOST_MODES = 12


def chapter(results: Results) -> Chapter | Absent:
    """Maps, contrast, impedance and modes of the finite plate."""
    result = results.of(PlateResult)
    if result is None:
        return Absent(TITLE, "it was not computed in this run")
    words = dict.fromkeys(result.figures, "Conductance and capacitance against frequency.") | {
        "plan": "Map of tiles with pillars, regions, actuators and supports.",
        "maps": "; ".join(_in_words(line) for line in split(result.maps, "frequency")),
        "contrast": "Level of the driven region above the others against frequency.",
        "velocity": "Root mean square velocity of each region against frequency.",
    }
    return Chapter(
        title=TITLE,
        identifier="plate",
        paragraphs=(
            f"The plate has {result.plate.layout.parts} and is computed from condensed tiles with "
            f"{result.lines.attrs['unknowns']} unknowns on {result.lines.attrs['basis']} vectors. At every "
            "line the answer was put back into the unreduced equations; the largest error of the field that "
            f"this bounds is {float(result.lines['solver_error'].max()):.0e}. {ERRORS} Loss factor of the "
            f"plate: {result.plate.loss_factor:g}, assumed.",
            *border_text(result.plate.layout),
        ),
        findings=tuple(_findings(result)),
        pictures=(*results.pictures(result, words), _swinging(result)),
        tables=tuple(
            one.labelled("simulated") for one in (lines_table(result), modes_table(_nearest(result)))
        ),
    )


def _swinging(result: PlateResult) -> Picture:
    """The plate in motion, where its driven region resonates in the gap."""
    shown, layout, drive = result.marked, result.plate.layout, result.drive
    frequency = hz_text(result.resonance, form=".2f")
    return Picture(
        figure=plots.map_at(shown, result.resonance, layout, None, drive=drive),
        caption=f"Simulated normal displacement of the flat face at {frequency}, as a moving picture unless "
        "the reader prefers none.",
        alternative=f"Map of the plate at {frequency}, red and blue taking turns.",
        name="carrier",
        moving=partial(plots.animated, shown, result.resonance, layout, drive=drive),
    )


def _in_words(line: xr.Dataset) -> str:
    loudest = line["rms"].idxmax("region").item() if "rms" in line else "nothing"
    return f"at {hz_text(float(line['frequency']), form='.1f')} {loudest} vibrates most"


def _findings(result: PlateResult) -> list[str]:
    said: list[str] = []
    gap = result.gap
    for line in split(result.maps, "frequency"):
        frequency = float(line["frequency"])
        where = "in" if gap and gap.holds(frequency) else "outside of"
        for name, level in split(line.get("contrast"), "pair").items():
            verdict = "the vibration stays there" if level >= LOCALISED else (
                "the whole plate vibrates" if level < EVERYWHERE else "part of it goes elsewhere"
            )  # fmt: skip
            told = f"{name} at {hz_text(frequency, form='.2f')}, {where} the gap: {level:.1f} dB; {verdict}."
            said.append(Finding(told, "maps"))
    names, frequencies = result.modes["name"].values.tolist(), result.modes["frequency"].values / 1e3
    lobed = [k for k, name in enumerate(names) if has_one_lobe(name)]
    if lobed:
        told = "; ".join(f"{names[k]} at {hz_text(1e3 * frequencies[k], form='.2f')}" for k in lobed)
        said.append(f"Modes near the carrier with one lobe across a guide: {told}.")
    if lobed and result.driven is not None:
        stored = result.modes["strain_energy"]
        part = {name: part_name(result.plate, name) for name in (result.driven, *result.plate.layout.cells)}
        shares = stored.sel(part=part[result.driven]).values
        k = max(lobed, key=lambda mode: shares[mode])
        quality, plate_alone = float(result.modes["quality_factor"][k]), 1 / result.plate.loss_factor
        lattice = sum(float(stored.sel(part=part[name])[k]) for name in result.plate.layout.cells)
        said.append(
            f"The driven guide's mode {names[k]} has a quality factor of {quality:.0f}; the plate's loss "
            f"alone would give {plate_alone:.0f}. The mirrors hold {100 * lattice:.0f} % of its strain "
            "energy and have the plate's loss factor, so they cost no quality while theirs is no larger: "
            f"the {100 * (1 - quality / plate_alone):.1f} % that are missing go into patch, bond and "
            "supports."
        )
    return said


def _nearest(result: PlateResult) -> xr.Dataset:
    """The modes that lie nearest to the map in the gap."""
    modes = result.modes
    nearest = abs(modes["frequency"] - result.resonance).argsort().values[:MOST_MODES]
    return modes.isel(mode=sorted(nearest.tolist()))
