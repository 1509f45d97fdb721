"""Chapter on the vibration of the finite plate below, in and above the gap."""

from __future__ import annotations

from functools import partial

from haptonic import plots
from haptonic.bloch import Gap
from haptonic.later import xarray as xr
from haptonic.names import listed
from haptonic.plate import Plate
from haptonic.plate.vibration.datasets import part_name
from haptonic.plate.vibration.modes import has_one_lobe
from haptonic.report.chapter import Absent, Chapter, Finding, Picture, Results
from haptonic.results.plain import split
from haptonic.results.plan import border_text
from haptonic.results.plate.tables import carriers_table, lines_table, modes_table, power_table
from haptonic.results.plate.value import CarrierAnswer, PlateResult
from haptonic.units import hz_text, in_percent

TITLE = "Plate"
LOCALISED = 20.0  # dB of contrast that the prototype is expected to reach in the gap
EVERYWHERE = 10.0  # dB of contrast below which the whole plate vibrates
MOST_MODES = 12


def chapter(results: Results) -> Chapter | Absent:
    """Describe maps, contrast, impedance and modes of the finite plate."""
    result = results.of(PlateResult)
    if result is None:
        return Absent(TITLE, "it was not computed in this run")
    words = dict.fromkeys(result.figures, "Conductance and capacitance against frequency.") | {
        "plan": "Map of tiles with pillars, regions, actuators and supports.",
        "maps": "; ".join(_in_words(line) for line in split(result.maps, "frequency")),
        "contrast": "Level of the driven region above the others against frequency.",
        "carriers": "Map of the plate at each carrier, with its own drives alone.",
        "velocity": "Root mean square velocity of each region against frequency.",
    }
    return Chapter(
        title=TITLE,
        identifier="plate",
        paragraphs=(
            f"The plate has {result.plate.layout.parts}. Its model consists of condensed tiles with "
            f"{result.lines.attrs['unknowns']} unknowns, reduced to {result.lines.attrs['basis']} vectors. "
            "The residual in the unreduced equations bounds the error of the field at every frequency by "
            f"{float(result.lines['solver_error'].max()):.0e}. {result.errors} The loss factor of the plate, "
            f"{result.plate.loss_factor:g}, is assumed.",
            *border_text(result.plate.layout),
        ),
        findings=tuple(_findings(result)),
        pictures=(*results.pictures(result, words), _swinging(result)),
        tables=tuple(
            table.labelled("simulated")
            for table in (
                *carriers_table(result.answers),
                lines_table(result),
                power_table(result),
                modes_table(_nearest(result)),
            )
        ),
        views={"Scrub through the frequencies": result.view()},
    )


def _swinging(result: PlateResult) -> Picture:
    """Moving picture of the plate at the resonance of its driven region in the gap."""
    shown, layout, drive = result.marked, result.plate.layout, result.drive
    frequency = hz_text(result.resonance, form=".2f")
    return Picture(
        figure=plots.map_at(shown, result.resonance, layout, None, drive=drive),
        caption=f"Simulated normal displacement of the flat face at {frequency}, as a moving picture.",
        alternative=f"Map of the plate at {frequency}, red and blue taking turns.",
        name="carrier",
        moving=partial(plots.animated, shown, result.resonance, layout, drive=drive),
    )


def _in_words(line: xr.Dataset) -> str:
    loudest = line["rms"].idxmax("region").item() if "rms" in line else "nothing"
    return f"at {hz_text(float(line['frequency']), form='.1f')} {loudest} vibrates most"


def _findings(result: PlateResult) -> list[str]:
    findings: list[str] = [_of_carrier(answer) for answer in result.answers]
    gap = result.gap
    lines = split(result.maps, "frequency")
    # the maps in the gap first: these are the findings that a folded chapter shows
    for line in sorted(lines, key=lambda line: not (gap and gap.lower < line["frequency"] < gap.upper)):
        frequency = float(line["frequency"])
        where = _place(frequency, gap)
        for name, level in split(line.get("contrast"), "pair").items():
            verdict = "the vibration stays in the driven region" if level >= LOCALISED else (
                "the whole plate vibrates" if level < EVERYWHERE else "part of it leaves the driven region"
            )  # fmt: skip
            text = f"{name} at {hz_text(frequency, form='.2f')}, {where}: {level:.1f} dB; {verdict}."
            findings.append(Finding(text, "maps"))
    names, frequencies = result.modes["name"].values.tolist(), result.modes["frequency"].values / 1e3
    lobed = [k for k, name in enumerate(names) if has_one_lobe(name)]
    if lobed:
        modes = "; ".join(f"{names[k]} at {hz_text(1e3 * frequencies[k], form='.2f')}" for k in lobed)
        findings.append(f"Modes near the carrier with one lobe across a guide: {modes}.")
    if lobed and result.driven is not None:
        stored = result.modes["strain_energy"]
        part = {name: part_name(result.plate, name) for name in (result.driven, *result.plate.layout.cells)}
        shares = stored.sel(part=part[result.driven]).values
        k = max(lobed, key=lambda mode: shares[mode])
        quality, plate_alone = float(result.modes["quality_factor"][k]), 1 / result.plate.loss_factor
        lattice = sum(float(stored.sel(part=part[name])[k]) for name in result.plate.layout.cells)
        others = _lossy_parts(result.plate)
        change = ("raise" if quality > plate_alone else "reduce") + "s" * (len(others) == 1)
        share = in_percent(abs(1 - quality / plate_alone), form=".1f")
        findings.append(
            f"Mode {names[k]} of the driven guide has a quality factor of {quality:.0f}. With the loss "
            f"factor of the plate alone it would be {plate_alone:.0f}"
            f"{f'; {listed(others)} {change} it by {share}' if others else ''}. {in_percent(lattice)} of the "
            "strain energy is in the mirrors, which have the loss factor of the plate."
        )
    return findings


def _lossy_parts(plate: Plate) -> list[str]:
    """Parts with a loss factor of their own."""
    present = {
        "patch": plate.actuators,
        "bond": [patch for patch in plate.actuators if patch.bond is not None],
        "supports": plate.supports,
        "finger": plate.finger,
    }
    return [name for name, parts in present.items() if parts]


def _of_carrier(answer: CarrierAnswer) -> Finding:
    """Sentence on one of several carriers."""
    drives, frequency = listed(answer.drives), hz_text(answer.carrier, form="g")
    missing = [name for name, gap in answer.around.items() if gap is None]
    gaps = (
        f"{' and '.join(missing)} without a gap there" if missing else "in the gap of the lattices around it"
    )
    level = answer.least_contrast
    contrast = f"; {level[0]} {level[1]:.1f} dB" if level else ""
    return Finding(f"{drives} at {frequency}, {gaps}{contrast}.", "carriers")


def _place(frequency: float, gap: Gap | None) -> str:
    """Place of a frequency (Hz) relative to the gap, in words."""
    if gap is None:
        return "in no certain gap"
    if not gap.lower < frequency < gap.upper:
        return "outside of the gap"
    return "in the gap" if gap.holds(frequency) else "in the gap within the error of its edge"


def _nearest(result: PlateResult) -> xr.Dataset:
    """Modes nearest to the frequency of the map in the gap."""
    modes = result.modes
    nearest = abs(modes["frequency"] - result.resonance).argsort().values[:MOST_MODES]
    return modes.isel(mode=sorted(nearest.tolist()))
