"""Bands, gaps and mode shapes of one unit cell."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Self

import numpy as np

from haptonic import plots, vtu
from haptonic.arrays import Array
from haptonic.bloch import Gap, gaps_of
from haptonic.bloch.bands import lattice_of, mode_names
from haptonic.bloch.gap_datasets import further_gaps_of
from haptonic.later import Axes, Figure, pandas as pd, xarray as xr
from haptonic.names import counted
from haptonic.plots.text import WavevectorUnit, gap_text
from haptonic.results.plain import plain
from haptonic.results.result import Result, figure, file, page
from haptonic.results.table import Cell, Column, Table, Uncertain
from haptonic.results.zone_view import ZONE_SHORT, zone_extra, zone_variables
from haptonic.units import format_quantity, hz_text, in_percent
from haptonic.views import InteractiveView

WRITTEN = [
    "band_below", "band_above", "lower_hz", "upper_hz", "lower_error_hz", "upper_error_hz", "complete",
    "direction", "samples", "waves", "lattice",
]  # fmt: skip


EDGES = (
    Column("lower", "Hz", "kHz", ".3f"),
    Column("upper", "Hz", "kHz", ".3f"),
    Column("width", "Hz", "kHz", ".2f"),
)


def _where(gap: Gap) -> str:
    if gap.complete:
        return "everywhere (complete)"
    return f"{gap.direction} only" if gap.waves == "all" else "everywhere, these waves only"


def _bands_of(gap: Gap) -> str:
    return f"{'' if gap.waves == 'all' else f'{gap.waves} '}{gap.between[0]}-{gap.between[1]}"


def _edges_of(gap: Gap) -> tuple[Uncertain, Uncertain, Uncertain]:
    """Lower and upper edge, and width."""
    doubt = "" if gap.certain else " (uncertain)"
    return (
        Uncertain(gap.lower, gap.lower_error),
        Uncertain(gap.upper, gap.upper_error),
        Uncertain(gap.width, gap.lower_error + gap.upper_error, doubt),
    )


# variables of the interactive view; those of the second list are stored with 16 bits
SEEN = [
    "kappa", "distance", "frequency", "frequency_error", "group_velocity", "group_velocity_error",
    "parity", "middle_parity", "branch", "character", "gap_below", "gap_lower", "gap_upper",
    "gap_lower_error", "gap_upper_error", "gap_complete", "gap_direction", "gap_waves",
    "skin_position", "skin_face", "skin_edge",
]  # fmt: skip
SEEN_SHORT = ["path_shape", "path_mode_real", "path_mode_imag"]


def _moving(result: Bands) -> bool:
    return "path_shape" in result.dataset


def _over_the_zone(result: Bands) -> bool:
    return "zone_frequency" in result.dataset


@dataclass(frozen=True)
class CarrierPlace:
    """Place of a carrier in the complete gap around it, or else beside the nearest one.

    room : distance to the ``edge``, "lower" or "upper", Hz; negative if the carrier lies beyond it
    """

    gap: Gap
    carrier: float
    edge: str
    room: float

    @classmethod
    def among(cls, gaps: Sequence[Gap], carrier: float) -> Self:
        """Find the place of a carrier (Hz) among complete gaps, at least one."""
        gap = max(gaps, key=lambda candidate: candidate.margin(carrier))
        ends = sorted(
            [(carrier - gap.lower, "lower", gap.lower_error), (gap.upper - carrier, "upper", gap.upper_error)]
        )
        # the nearer edge, unless only the other one is so uncertain that the carrier may lie outside
        room, edge, _ = next((end for end in ends if end[0] <= end[2]), ends[0])
        return cls(gap, carrier, edge, room)

    @property
    def is_uncertain(self) -> bool:
        """True if the carrier is nearer to the edge than the error of the edge."""
        return abs(self.room) <= (self.gap.lower_error if self.edge == "lower" else self.gap.upper_error)

    def __str__(self) -> str:
        """``0.21 kHz (0.3 %) from its upper edge``."""
        if self.room <= 0:
            return f"{hz_text(-self.room, form='.2g')} from the nearest edge"
        share = in_percent(self.room / self.carrier, form=".1f")
        return f"{hz_text(self.room, form='.2g')} ({share}) from its {self.edge} edge"


@dataclass(frozen=True, eq=False, repr=False)
class Bands(Result):
    """Band diagram, gaps and mode shapes of a unit cell, all in ``dataset``."""

    title = "Bands and gaps"
    data_file = "bands"

    dataset: xr.Dataset

    @property
    def gaps(self) -> tuple[Gap, ...]:
        """Gaps: the complete ones first, then those of single directions."""
        return gaps_of(self.dataset)

    @property
    def further(self) -> dict[str, tuple[Gap, ...]]:
        """Complete gaps of the other lattices of the study's plate, by name."""
        return further_gaps_of(self.dataset)

    @property
    def frequency(self) -> Array:
        """Frequencies along the path, Hz: (wavevectors, bands)."""
        return np.array(self.dataset["frequency"])

    @property
    def error(self) -> Array:
        """Bounds of the errors of `frequency`, Hz: (wavevectors, bands)."""
        return np.array(self.dataset["frequency_error"])

    @property
    def wavevector(self) -> Array:
        """Components kx and ky of the wavevectors along the path, rad/m: (wavevectors, 2)."""
        return lattice_of(self.dataset).wavevector(np.array(self.dataset["kappa"]))

    @property
    def distance(self) -> Array:
        """Length of the path up to each wavevector, rad/m: (wavevectors,)."""
        return np.array(self.dataset["distance"])

    @property
    def corners(self) -> tuple[tuple[str, float], ...]:
        """Name of each corner on the path and its distance, rad/m: the ticks of a band diagram."""
        names, rows = (json.loads(self.dataset.attrs[f"path_{what}"]) for what in ("labels", "corners"))
        return tuple(zip(names, self.distance[rows].tolist(), strict=True))

    def diagram(self) -> pd.DataFrame:
        """The band diagram as a table: a row for each wavevector, columns with units in their names."""
        bands = range(1, self.frequency.shape[1] + 1)
        return pd.DataFrame(
            {
                "distance (rad/m)": self.distance,
                **{f"k{axis} (rad/m)": k for axis, k in zip("xy", self.wavevector.T, strict=True)},
                **{f"f{band} (Hz)": f for band, f in zip(bands, self.frequency.T, strict=True)},
                **{f"error of f{band} (Hz)": e for band, e in zip(bands, self.error.T, strict=True)},
            }
        )

    def summary(self) -> list[str]:
        """Complete gaps in one sentence, and the carrier: a command prints the first sentences only."""
        complete = [gap for gap in self.gaps if gap.complete]
        listed = [
            f"from {gap_text(gap)}, between bands {gap.between[0]} and {gap.between[1]}"
            + ("" if gap.certain else " (it is not wider than the errors of its edges, so it may not exist)")
            for gap in complete
        ]
        noun = "Complete gaps" if len(listed) > 1 else "Complete gap"
        gaps = f"{noun} {'; '.join(listed)}." if listed else self._without_gap()
        of_some = [
            f"Gap of {gap.waves} waves alone from {gap_text(gap)}, between their bands {gap.between[0]} and "
            f"{gap.between[1]}."
            for gap in self.gaps
            if gap.waves != "all"
        ]
        checked, missed = (int(self.dataset.attrs[f"counts_{name}"]) for name in ("checked", "missed"))
        return [gaps, *self._about_carrier(complete), *of_some, check_text(checked, missed)]

    def _without_gap(self) -> str:
        carrier = self.dataset.attrs.get("carrier_hz")
        highest = float(self.frequency[:, -1].min())  # above it, bands are missing
        known = f"The computed bands have no complete gap below {hz_text(highest, form='.3g')}"
        if carrier is not None:
            above = carrier > highest
            shown = format_quantity(carrier, "Hz")
            known += f", and the carrier, {shown}, lies above" if above else f", so none around {shown}"
            if above:
                return f"{known}: compute more bands (key bands.count)."
        others = ", or compute more bands (key bands.count)" if carrier is None else ""
        return f"{known}: change the sizes of the cell, or run `haptonic design`{others}."

    def _about_carrier(self, complete: Sequence[Gap]) -> list[str]:
        carrier = self.dataset.attrs.get("carrier_hz")
        if carrier is None or not complete:
            return []
        place = CarrierPlace.among(complete, carrier)
        name, gap = f"The carrier, {format_quantity(carrier, 'Hz')},", place.gap
        if place.is_uncertain:
            return [
                f"{name} may lie inside the gap from {gap_text(gap)} or outside: its distance from the "
                f"{place.edge} edge is smaller than the error of that edge. Increase the accuracy."
            ]
        if place.room <= 0:
            text = f"{name} lies in no complete gap, {place}"
            return [f"{text}: waves of this frequency propagate in the lattice."]
        text = f"{name} lies inside the gap from {gap_text(gap)}, {place}"
        if place.room < 0.1 * gap.width:
            text += ": close enough for a tolerance of the sizes or of the material to move the edge past it"
        return [f"{text}."]

    def tables(self) -> list[Table]:
        gaps = self.gaps
        rows = [(_bands_of(gap), _where(gap), *_edges_of(gap)) for gap in gaps]
        own = Table(
            "band gaps", ("bands", "where", *EDGES), rows, [k for k, gap in enumerate(gaps) if gap.complete]
        )
        further = self.further
        others: list[tuple[Cell, ...]] = [
            (name, _bands_of(gap), *_edges_of(gap)) for name, every in further.items() for gap in every
        ]
        others += [
            (name, "no complete gap", None, None, None) for name, every in further.items() if not every
        ]
        title = "complete band gaps of the plate's other lattices"
        return [own, Table(title, ("lattice", "bands", *EDGES), others)] if others else [own]

    @figure(
        "dispersion",
        "Simulated dispersion along the edge of the irreducible zone. Complete gaps are shaded, those of one "
        "parity hatched.",
    )
    def _dispersion(
        self,
        *,
        gaps: bool = True,
        labels: bool = True,
        label: str | None = None,
        wavevectors: WavevectorUnit | None = None,
        ax: Axes | None = None,
    ) -> Figure:
        """Band diagram with the complete gaps and the carrier; see `haptonic.plots.dispersion`."""
        carrier = self.dataset.attrs.get("carrier_hz")
        return plots.dispersion(
            self.dataset, carrier, gaps=gaps, labels=labels, label=label, wavevectors=wavevectors, ax=ax
        )

    @figure(
        "natures",
        "Simulated bands, coloured by the motion: colour, dashes and markers change where a mode changes its "
        "motion. Complete gaps are shaded, those of one parity hatched.",
    )
    def _natures(self, *, gaps: bool = True, labels: bool = True, ax: Axes | None = None) -> Figure:
        """Band diagram with each mode in the colour of its motion."""
        carrier = self.dataset.attrs.get("carrier_hz")
        return plots.dispersion(self.dataset, carrier, natures=True, gaps=gaps, labels=labels, ax=ax)

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
            {"band_below": gap.between[0], "band_above": gap.between[1], **plain(gap), "lattice": name}
            for name, every in {"lattice": self.gaps, **self.further}.items()
            for gap in every
        ]
        pd.DataFrame(rows, columns=WRITTEN).to_csv(path, index=False, float_format="%.3f")

    @file("bands.csv")
    def _write_diagram(self, path: Path) -> None:
        self.diagram().to_csv(path, index=False, float_format="%.9g")

    _page = page("bands.html", when=_moving)

    def view(self) -> InteractiveView | None:
        """Interactive view of the diagram and its modes; None if the modes were not computed."""
        if not _moving(self):
            return None
        seen, zone = self.dataset[SEEN + SEEN_SHORT], {}
        if _over_the_zone(self):
            seen, zone = seen.merge(zone_variables(self.dataset)), zone_extra(self.dataset)
        top = plots.shown_up_to(self.dataset, self.dataset.attrs.get("carrier_hz"))
        return InteractiveView(
            kind="bands",
            title=self.title,
            dataset=seen,
            extra={
                "summary": self.summary(),
                "colours": plots.shades(64),
                "top": top,
                "lattice_vectors": lattice_of(self.dataset).vectors.tolist(),
                **zone,
            },
            short=[*SEEN_SHORT, *ZONE_SHORT],
        )

    @file("modes.vtu")
    def _write_modes(self, path: Path) -> None:
        vtu.write_modes(path, self.dataset, overwrite=True)

    def facts(self) -> dict[str, Any]:
        data, names = self.dataset, json.loads(self.dataset.attrs["character_names"])
        along = [
            name
            for name, variable in data.items()
            if {"wavevector", "path_corner"} & set(variable.dims) and "shape" not in variable.dims
        ]
        named = data["character"].dims, np.array(names)[data["character"].values]
        return {
            "gaps": self.gaps, "bands": data[along].assign(character=named), "modes": mode_names(data),
            **({"further_lattices": further} if (further := self.further) else {}),
        }  # fmt: skip


def check_text(checked: int, missed: int) -> str:
    """Sentence on the check of the bands by exact eigenvalue counts."""
    if not checked:
        return "The number of bands was not checked: each frequency for the check lies within a band's error."
    comparisons, missing = counted(checked, "comparison"), counted(missed, "band")
    return f"Checked by exact eigenvalue counts, in {comparisons}: {missing} missing."
