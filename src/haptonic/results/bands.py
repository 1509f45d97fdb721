"""Bands of one unit cell."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from haptonic import plots, vtu
from haptonic.bloch import Gap, gaps_of
from haptonic.bloch.bands import mode_names
from haptonic.later import Axes, Figure, pandas as pd, xarray as xr
from haptonic.plots.text import band_text
from haptonic.results.plain import plain
from haptonic.results.result import Result, figure, file
from haptonic.results.table import Column, Table, Uncertain
from haptonic.units import format_quantity, hz_text

WRITTEN = [
    "band_below", "band_above", "lower_hz", "upper_hz", "lower_error_hz", "upper_error_hz", "complete",
    "direction", "samples", "waves",
]  # fmt: skip


def _where(gap: Gap) -> str:
    if gap.complete:
        return "everywhere (complete)"
    return f"{gap.direction} only" if gap.waves == "all" else "everywhere, these waves only"


def _over_the_zone(result: Bands) -> bool:
    return "zone_frequency" in result.dataset


@dataclass(frozen=True, eq=False, repr=False)
class Bands(Result):
    """Band diagram, gaps and mode shapes of a unit cell; ``dataset`` holds all of it, labelled."""

    title = "Bands and gaps"
    data_file = "bands"

    dataset: xr.Dataset

    @property
    def gaps(self) -> tuple[Gap, ...]:
        """Complete gaps first, then those of single directions."""
        return gaps_of(self.dataset)

    def summary(self) -> list[str]:
        complete = [gap for gap in self.gaps if gap.complete]
        said = [
            f"Complete gap from {band_text(gap.lower, gap.lower_error, gap.upper, gap.upper_error)}, "
            f"between bands {gap.between[0]} and {gap.between[1]}"
            + ("." if gap.certain else "; it is not wider than the errors of its edges, so it may not exist.")
            for gap in complete
        ]
        said += [] if complete else ["There is no complete gap among the bands that were computed."]
        said += [
            f"Gap of {gap.waves} waves alone from "
            f"{band_text(gap.lower, gap.lower_error, gap.upper, gap.upper_error)}, "
            f"between their bands {gap.between[0]} and {gap.between[1]}."
            for gap in self.gaps
            if gap.waves != "all"
        ]
        checked, missed = (int(self.dataset.attrs[f"counts_{name}"]) for name in ("checked", "missed"))
        return [*said, *self._about_carrier(complete), counted(checked, missed)]

    def _about_carrier(self, complete: Sequence[Gap]) -> list[str]:
        carrier = self.dataset.attrs.get("carrier_hz")
        if carrier is None or not complete:
            return []
        gap = max(complete, key=lambda one: one.margin(carrier))  # that which holds it, else the nearest
        ends = sorted(
            [(carrier - gap.lower, "lower", gap.lower_error), (gap.upper - carrier, "upper", gap.upper_error)]
        )
        # the nearer edge, unless only the other one is so uncertain that the gap may not hold the carrier
        room, edge, _ = next((one for one in ends if one[0] <= one[2]), ends[0])
        name, away = (
            f"The carrier, {format_quantity(carrier, 'Hz')},",
            hz_text(abs(room), form=".2g"),
        )
        if room <= 0:
            said = f"{name} lies in no complete gap, {away} from the nearest edge"
            return [f"{said}: at this frequency the lattice lets waves through."]
        said = f"{name} lies inside the gap, {away} ({room / carrier:.1%}) from its {edge} edge"
        if not gap.holds(carrier):
            return [f"{said}, which is within the error of that edge."]
        if room < 0.1 * gap.width:
            said += ": close enough for a tolerance of the sizes or of the material to move the edge past it"
        return [f"{said}."]

    def tables(self) -> list[Table]:
        gaps = self.gaps
        columns = (
            "bands", "where", Column("lower", "Hz", "kHz", ".3f"), Column("upper", "Hz", "kHz", ".3f"),
            Column("width", "Hz", "kHz", ".2f"),
        )  # fmt: skip
        rows = [
            (
                f"{'' if gap.waves == 'all' else f'{gap.waves} '}{gap.between[0]}-{gap.between[1]}",
                _where(gap),
                Uncertain(gap.lower, gap.lower_error),
                Uncertain(gap.upper, gap.upper_error),
                Uncertain(
                    gap.width, gap.lower_error + gap.upper_error, "" if gap.certain else " (uncertain)"
                ),
            )
            for gap in gaps
        ]
        return [Table("band gaps", columns, rows, [k for k, gap in enumerate(gaps) if gap.complete])]

    @figure(
        "dispersion",
        "Simulated dispersion along the edge of the irreducible zone. Complete gaps are shaded, those of one "
        "parity hatched.",
    )
    def _dispersion(self, *, ax: Axes | None = None) -> Figure:
        """Band diagram with the complete gaps and the carrier."""
        return plots.dispersion(self.dataset, self.dataset.attrs.get("carrier_hz"), ax=ax)

    @figure(
        "natures",
        "Simulated bands by what moves: colour, dashes and markers change where a mode changes its nature. "
        "Complete gaps are shaded, those of one parity hatched.",
    )
    def _natures(self, *, ax: Axes | None = None) -> Figure:
        """The same with each mode in the colour of what moves."""
        carrier = self.dataset.attrs.get("carrier_hz")
        return plots.dispersion(self.dataset, carrier, natures=True, ax=ax)

    @figure(
        "modes",
        "Simulated mode shapes at one wavevector; the body at rest in grey lines. Same view and scale for "
        "all; each mode's largest displacement is drawn equally large.",
    )
    def _modes(self) -> Figure:
        return plots.mode_shapes(self.dataset)

    @figure(
        "iso_frequency",
        "Simulated contours of equal frequency over the first Brillouin zone; the dashed line bounds the "
        "irreducible zone. Waves travel at right angles to the contours.",
        when=_over_the_zone,
    )
    def _iso_frequency(self) -> Figure:
        return plots.iso_frequency(self.dataset)

    @figure(
        "density_of_states",
        "Simulated density of states of the infinite lattice, from the bands over the whole zone.",
        when=_over_the_zone,
    )
    def _density_of_states(self, *, ax: Axes | None = None) -> Figure:
        return plots.density_of_states(self.dataset, ax=ax)

    @file("gaps.csv")
    def _write_gaps(self, path: Path) -> None:
        rows = [
            {"band_below": gap.between[0], "band_above": gap.between[1], **plain(gap)} for gap in self.gaps
        ]
        pd.DataFrame(rows, columns=WRITTEN).to_csv(path, index=False, float_format="%.3f")

    @file("modes.vtu")
    def _write_modes(self, path: Path) -> None:
        vtu.write_modes(path, self.dataset, overwrite=True)

    def facts(self) -> dict[str, Any]:
        data, names = self.dataset, json.loads(self.dataset.attrs["character_names"])
        along = [name for name, one in data.items() if {"wavevector", "path_corner"} & set(one.dims)]
        named = data["character"].dims, np.array(names)[data["character"].values]
        return {
            "gaps": self.gaps, "bands": data[along].assign(character=named), "modes": mode_names(data),
        }  # fmt: skip


def counted(checked: int, missed: int) -> str:
    """What the exact counts of modes say of the bands."""
    if not checked:
        return "Bands were not counted by another method: where it would be done, one lies within its error."
    missing = f"{missed or 'no'} band{'s' * (missed != 1)} missing"
    return f"Counted by another method, in {checked} comparison{'s' * (checked != 1)}: {missing}."
