"""Differences of two sets of bands: in each band, in the gaps, and in the inputs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from haptonic import plots
from haptonic.arrays import Array
from haptonic.bloch import Gap
from haptonic.errors import StudyError
from haptonic.fields.keys import pattern_of
from haptonic.later import Axes, Figure, xarray as xr
from haptonic.results.common import stamped
from haptonic.results.result import Result, figure
from haptonic.results.table import Cell, Column, Table
from haptonic.units import format_quantity, hz_text, in_percent

LOW = 0.05  # of the highest frequency; a relative difference of lower frequencies is not meaningful
FEW = 3  # differences that are listed in a sentence
MOST_APART = 0.1  # relative difference; a larger one indicates other bands, another unit or another size
RATIOS = {
    "angular frequencies, in rad/s, were taken for Hz": 2 * np.pi,
    "Hz were taken for angular frequencies, in rad/s": 1 / (2 * np.pi),
    "kHz were taken for Hz, or the like": 1e-3,
    "Hz were taken for kHz, or the like": 1e3,
}
SAME_EDGE = 1e-6  # relative difference of the edges of a gap below which they are the same
SAME_PLACE = 1e-6  # distance of two wavevectors, as a share of a segment of the path
OTHER_BAND = 0.1  # relative difference; bands of the same number that differ more are hardly the same
Edges = tuple[float, float]


@dataclass(frozen=True, eq=False)
class BandSet:
    """Bands along a path.

    name : name in tables and pictures
    position : (wavevector,) corners of the path count 0, 1, 2, ...; fractions between them
    frequency : (wavevector, band) ascending, Hz; NaN for a missing one
    labels : of the corners; length : of the path, rad/m
    gaps : complete ones, for bands of haptonic
    inputs : plain values of the study, for bands of haptonic; ours : True if haptonic computed the bands
    left : names of the columns of a table that are not frequencies
    loss : (wavevector, band) loss factors, 1/Q; loss_from : their origin; remarks : of its reader
    """

    name: str
    position: Array
    frequency: Array
    labels: tuple[str, ...]
    gaps: tuple[Gap, ...]
    inputs: Mapping[str, Any]
    ours: bool = True
    left: tuple[str, ...] = ()
    loss: Array | None = None
    loss_from: str = ""
    remarks: tuple[str, ...] = ()

    @property
    def usual_loss(self) -> float | None:
        """Median loss factor of all modes; rigid modes have none."""
        if self.loss is None:
            return None
        floor = LOW * float(np.nanmax(self.frequency))
        losses = self.loss[np.isfinite(self.loss) & (self.frequency > floor)]
        return float(np.median(losses)) if losses.size else None

    def at(self, position: Array) -> Array:
        """(position, band) frequencies, Hz, linear between the wavevectors; NaN beyond them."""
        columns = [np.interp(position, self.position, f, np.nan, np.nan) for f in self.frequency.T]
        return np.stack(columns, axis=1)

    def gap_edges(self) -> dict[tuple[int, int], Edges]:
        """(lower, upper) edges (Hz) of the complete gaps, or of those on a table's path, by their bands."""
        if self.ours:
            return {gap.between: gap.edges for gap in self.gaps}
        lower, upper = np.nanmax(self.frequency, axis=0), np.nanmin(self.frequency, axis=0)
        return {
            (k + 1, k + 2): (float(lower[k]), float(upper[k + 1]))
            for k in range(len(lower) - 1)
            if upper[k + 1] > lower[k]
        }


@dataclass(frozen=True, eq=False, repr=False)
class Comparison(Result):
    """Two sets of bands, compared at the wavevectors of the second.

    units : SI units of the inputs, by key of the study
    """

    title = "Comparison"
    data_file = "compare"

    first: BandSet
    second: BandSet
    units: Mapping[str, str] = field(default_factory=dict)

    @property
    def difference(self) -> Array:
        """(wavevector, band) frequency of the second minus that of the first, Hz, for their common bands."""
        count = min(self.first.frequency.shape[1], self.second.frequency.shape[1])
        return np.asarray(self.second.frequency[:, :count] - self.first.at(self.second.position)[:, :count])

    @property
    def relative(self) -> Array:
        """(wavevector, band) difference relative to the first's frequency.

        If the frequency is nearly zero, as for rigid modes at the centre of the zone, the difference is
        relative to `LOW` of the highest frequency; so a mode that only one of the two has is still visible.
        """
        difference = self.difference
        first = self.first.at(self.second.position)[:, : difference.shape[1]]
        floor = max(LOW * float(np.nanmax(self.first.frequency)), np.finfo(float).tiny)
        return np.asarray(difference / np.maximum(first, floor))

    @property
    def largest(self) -> tuple[int, int] | None:
        """(wavevector, band) of the largest relative difference, from 0; None if nothing can be compared."""
        relative = np.abs(self.relative)
        if not np.isfinite(relative).any():
            return None
        wavevector, band = np.unravel_index(np.nanargmax(relative), relative.shape)
        return int(wavevector), int(band)

    def refuse_apart(self) -> None:
        """Raise StudyError if a relative difference exceeds `MOST_APART`."""
        place = self.largest
        if place is None:
            raise StudyError.mismatch(
                argument=self.second.name, given="no frequency at a wavevector of both",
                allowed="frequencies at wavevectors of our path",
                cause="the table has other wavevectors, or no wavevectors",
                next_step="export more wavevectors along the path",
            )  # fmt: skip
        apart = float(self.relative[place])
        if abs(apart) <= MOST_APART:
            return
        ours = float(self.first.at(self.second.position)[place])
        theirs = float(self.second.frequency[place])
        where = self._place(float(self.second.position[place[0]]))
        raise StudyError.mismatch(
            argument=self.second.name,
            given=f"band {place[1] + 1} at {where} is at {format_quantity(theirs, 'Hz')}, and that of "
            f"{self.first.name} at {format_quantity(ours, 'Hz')}",
            allowed=f"frequencies that differ by at most {in_percent(MOST_APART)}",
            cause=self._likely_cause(),
            next_step="check units, columns and sizes; add --any-difference to compare them anyway",
        )

    def _likely_cause(self) -> str:
        """Likely cause of a large difference, from the ratio of the frequencies."""
        count = self.difference.shape[1]
        first = self.first.at(self.second.position)[:, :count]
        floor = LOW * float(np.nanmax(self.first.frequency))
        ratio = (self.second.frequency[:, :count] / np.maximum(first, floor))[first > floor]
        ratio = ratio[np.isfinite(ratio) & (ratio > 0)]
        if ratio.size:
            usual = float(np.median(ratio))
            for name, value in RATIOS.items():
                if abs(usual / value - 1) < MOST_APART:
                    return f"its frequencies are {value:.4g} times ours: {name}"
            if float(np.ptp(ratio)) < 0.02 * usual:
                return f"all its frequencies are {usual:.4g} times ours: a size or a material differs"
        return "a band is missing in one of the two, a column is not a frequency, or a size differs"

    @cached_property
    def dataset(self) -> xr.Dataset:
        """Differences at the wavevectors of the second."""
        both = ("wavevector", "band")
        absent = {"units": "Hz", "nan_means": "one of the two lacks this band here"}
        data = xr.Dataset(
            {
                "position": ("wavevector", self.second.position, {"units": "1"}),
                "frequency": (both, self.second.frequency[:, : self.difference.shape[1]], absent),
                "difference": (both, self.difference, absent),
            },
            coords={"band": np.arange(1, self.difference.shape[1] + 1)},
            attrs={"first": self.first.name, "second": self.second.name},
        )
        return stamped(data, self.first.inputs)

    def summary(self) -> list[str]:
        a, b = self.first, self.second
        relative, place = np.abs(self.relative), self.largest
        if place is None:
            return [f"{b.name} and {a.name} have no wavevector in common."]
        sentences = [
            f"{b.name} against {a.name}: {relative.shape[1]} bands at {len(b.position)} wavevectors, "
            f"{in_percent(np.sqrt(np.nanmean(relative**2)), form='.3g')} apart on average (root mean "
            f"square), at most {in_percent(relative[place], form='.3g')} (band {place[1] + 1}, "
            f"{self._place(float(b.position[place[0]]))})."
        ]
        if (gap := self._widest_common_gap()) is not None:
            bands, edges, others = gap
            shifts = [other - edge for edge, other in zip(edges, others, strict=True)]
            name = f"The gap between bands {bands[0]}-{bands[1]}"
            where = "" if b.ours else f", at the wavevectors of {b.name},"
            if max(map(abs, shifts)) < SAME_EDGE * edges[0]:
                sentences.append(f"{name}{where} is the same.")
            else:
                first, last = (
                    f"{hz_text(abs(shift), form='.3g')} {'higher' if shift > 0 else 'lower'}"
                    for shift in shifts
                )
                sentences.append(f"{name}{where} begins {first} and ends {last}.")
        if (losses := self._losses()) is not None:
            sentences.append(losses)
        changed = list(self._changed())
        if 0 < len(changed) <= FEW:
            sentences.append(
                "Differing inputs: "
                + "; ".join(f"{key}, {before} and {after}" for key, before, after in changed)
                + "."
            )
        elif changed:
            sentences.append(f"{len(changed)} keys of the studies differ.")
        return sentences

    def _losses(self) -> str | None:
        """Sentence on the loss factors of both, if the second is a table with damping."""
        theirs, ours = self.second.usual_loss, self.first.usual_loss
        if self.second.ours or theirs is None:
            return None
        text = f"Loss factor of {self.second.name}, from {self.second.loss_from}: {_loss_text(theirs)}"
        if ours is None:
            return f"{text}; not compared, because {self.first.name} has materials of several loss factors."
        return f"{text}; of {self.first.name}, from {self.first.loss_from}: {_loss_text(ours)}."

    def tables(self) -> list[Table]:
        a, b = self.first, self.second
        gaps = Table(
            "gaps" if b.ours else f"gaps; those of {b.name} at its wavevectors only",
            (
                "bands",
                *(
                    Column(f"{side.name} {end}", "Hz", "kHz", ".3f")
                    for side in (a, b)
                    for end in ("from", "to")
                ),
            ),
            [tuple(row) for row in self._gap_rows()],
        )
        bands = Table(
            f"{b.name} minus {a.name}",
            ("band", Column("root mean square", "Hz", "kHz", ".4f"), Column("largest", "Hz", "kHz", "+.4f"),
             Column("relative", "", "%", "+.3f"), "where"),
            list(self._band_rows()),
        )  # fmt: skip
        changed = Table("differing inputs of the studies", ("key", a.name, b.name), list(self._changed()))
        return [gaps, *([changed] if changed.rows else []), bands]

    def _band_rows(self) -> Iterator[tuple[Cell, ...]]:
        for band, (apart, share) in enumerate(zip(self.difference.T, self.relative.T, strict=True), start=1):
            if not np.isfinite(apart).any():
                continue
            k = int(np.nanargmax(np.abs(apart)))
            part = None if np.isnan(share[k]) else float(share[k])
            where = self._place(float(self.second.position[k]))
            yield str(band), float(np.sqrt(np.nanmean(apart**2))), float(apart[k]), part, where

    def _widest_common_gap(self) -> tuple[tuple[int, int], Edges, Edges] | None:
        """Bands of the first's widest gap that the second has too, and its edges in both, Hz.

        A table has no gaps of the whole zone. Both are then compared where the table has the two bands.
        """
        ours = self.first.gap_edges()
        theirs = self.second.gap_edges() if self.second.ours else {}
        for bands in sorted(ours, key=lambda bands: ours[bands][0] - ours[bands][1]):
            if bands in theirs:
                return bands, ours[bands], theirs[bands]
            if not self.second.ours and (both := self._edges_at_table(bands)) is not None:
                return bands, *both
        return None

    def _edges_at_table(self, bands: tuple[int, int]) -> tuple[Edges, Edges] | None:
        """Edges of both between two bands where the table has them, Hz; None without a gap."""
        columns = [band - 1 for band in bands]
        if max(columns) >= self.difference.shape[1]:
            return None
        ours, theirs = self.first.at(self.second.position)[:, columns], self.second.frequency[:, columns]
        common = np.isfinite(ours) & np.isfinite(theirs)
        if not common.any(axis=0).all():
            return None
        edges = [
            (float(side[common[:, 0], 0].max()), float(side[common[:, 1], 1].min()))
            for side in (ours, theirs)
        ]
        return (edges[0], edges[1]) if all(lower < upper for lower, upper in edges) else None

    def _gap_rows(self) -> list[tuple[Cell, Cell, Cell, Cell, Cell]]:
        """Bands and edges (Hz) of each gap; None for an edge that one of the two lacks."""
        first, second = self.first.gap_edges(), self.second.gap_edges()
        none: tuple[None, None] = (None, None)
        return [
            (f"{pair[0]}-{pair[1]}", *first.get(pair, none), *second.get(pair, none))
            for pair in sorted(first.keys() | (second.keys() if self.second.ours else set()))
        ]

    def _changed(self) -> Iterator[tuple[str, str, str]]:
        if self.second.ours:
            yield from differing_inputs(self.first.inputs, self.second.inputs, self.units)

    def _place(self, position: float) -> str:
        """Name of a position on the path, such as ``0.30 of X-M``."""
        k = min(int(position), len(self.first.labels) - 2)
        start, stop = self.first.labels[k : k + 2]
        share = f"{position - k:.2f}"
        return {"0.00": start, "1.00": stop}.get(share, f"{share} of {start}-{stop}")

    def remarks(self) -> list[str]:
        remarks = []
        apart = [
            float(np.nanmedian(np.abs(band))) if np.isfinite(band).any() else 0.0 for band in self.relative.T
        ]
        far = [number for number, median in enumerate(apart, start=1) if median > OTHER_BAND]
        if far and self.second.inputs == {}:
            remarks.append(
                f"band {far[0]} and others are more than {in_percent(OTHER_BAND)} apart: a band may be "
                "missing in one of the two, or a unit or a size may differ"
            )
        if self.second.left:
            remarks.append(
                f"columns of {self.second.name} without frequencies are left out: "
                f"{', '.join(self.second.left)}"
            )
        lacking = self.second.frequency.shape[1] - self.first.frequency.shape[1]
        if lacking > 0 and not self.second.ours:
            remarks.append(
                f"{lacking} more bands of {self.second.name} are not compared: increase count in [bands]"
            )
        remarks += self.second.remarks
        nearest = np.interp(self.second.position, self.first.position, np.arange(len(self.first.position)))
        distance = np.abs(self.first.position[np.round(nearest).astype(int)] - self.second.position)
        if (distance > SAME_PLACE).any():
            remarks.append(
                f"bands of {self.first.name} are interpolated linearly between its "
                f"{len(self.first.position)} wavevectors"
            )
        return remarks

    def facts(self) -> dict[str, Any]:
        names = ("bands", "first_lower_hz", "first_upper_hz", "second_lower_hz", "second_upper_hz")
        return {
            "data": self.dataset,
            "loss_factor": {"first": self.first.usual_loss, "second": self.second.usual_loss},
            "gaps": [dict(zip(names, row, strict=True)) for row in self._gap_rows()],
            "changed": [dict(zip(("key", "first", "second"), row, strict=True)) for row in self._changed()],
        }

    @figure("compare", "Two sets of bands along the edge of the irreducible zone, and their complete gaps.")
    def _drawn(self, *, ax: Axes | None = None) -> Figure:
        sides = (self.first, self.second)
        return plots.compared(
            [(side.name, side.position, side.frequency, [gap.edges for gap in side.gaps]) for side in sides],
            self.first.labels,
            crosses=not self.second.ours,
            ax=ax,
        )


def differing_inputs(
    first: Mapping[str, Any], second: Mapping[str, Any], units: Mapping[str, str]
) -> Iterator[tuple[str, str, str]]:
    """Keys of two studies whose values differ, with both values as texts; ``units`` are SI, by key."""

    def text(key: str, value: object) -> str:
        pattern = pattern_of(key)
        unit = units.get(pattern) or units.get(pattern.replace(".uncertainty.", "."), "")
        return format_quantity(value, unit) if isinstance(value, float) else str(value)

    ours, theirs = dict(_flat(first)), dict(_flat(second))
    for key in dict.fromkeys([*ours, *theirs]):
        before, after = ours.get(key, "-"), theirs.get(key, "-")
        if before != after:
            yield key, text(key, before), text(key, after)


def _loss_text(loss: float) -> str:
    return f"{loss:.3g} (Q {1 / loss:.4g})" if loss > 0 else "0, undamped"


def _flat(tree: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, object]]:
    for name, value in tree.items():
        if isinstance(value, Mapping):
            yield from _flat(value, f"{prefix}{name}.")
        elif isinstance(value, list) and value and all(isinstance(item, Mapping) for item in value):
            for number, item in enumerate(value, start=1):
                yield from _flat(item, f"{prefix}{name}[{number}].")
        elif value is not None:
            yield f"{prefix}{name}", value
