"""Complete gaps along sweeps of a design."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from haptonic import plots
from haptonic.bloch.gap_datasets import carrier_margins
from haptonic.bloch.mesh_levels import rounded_up
from haptonic.gate import declared
from haptonic.later import Axes, Figure, pandas as pd, xarray as xr
from haptonic.plots.text import band_text
from haptonic.results.common import Writer, write_netcdf
from haptonic.results.result import Result, figure, file
from haptonic.results.table import Cell, Column, Table, Uncertain
from haptonic.units import format_quantity, hz_text

SHOWN = {"m": "mm", "rad": "deg", "Pa": "GPa"}  # units of varied numbers for people
VALUES = ("value", "second_value")  # variables of the first and the second expression


@dataclass(frozen=True)
class Sweep:
    """Complete gaps along a sweep; designs that could not be computed are in ``failed``."""

    dataset: xr.Dataset
    failed: dict[int, dict[str, str]]

    @property
    def axes(self) -> dict[str, tuple[str, str]]:
        """Expression and SI unit, empty for a bare number, of each variable that the sweep changes."""
        names = [name for name in VALUES if name in self.dataset]
        units = [str(self.dataset[name].attrs["units"]) for name in names]
        return {
            name: (str(self.dataset[name].attrs["long_name"]), "" if unit == "1" else unit)
            for name, unit in zip(names, units, strict=True)
        }

    @property
    def expressions(self) -> str:
        """The one or two expressions that vary."""
        return " and ".join(expression for expression, _ in self.axes.values())

    def drawn(self, *, ax: Axes | None = None) -> Figure:
        """Draw the gaps against the swept value, or a map of their widths over two."""
        draw = plots.sweep_grid if len(self.axes) == 2 else plots.sweep
        return draw(self.dataset, ax=ax)

    def values_at(self, step: int) -> str:
        """The values of one design with their units."""
        values = (float(self.dataset[name][step]) for name in self.axes)
        units = (unit for _, unit in self.axes.values())
        return " and ".join(format_quantity(value, unit) for value, unit in zip(values, units, strict=True))

    def gaps_at(self, step: int) -> list[dict[str, Any]]:
        """The gaps of one design as plain values."""
        row = self.dataset.isel(step=step)
        return [
            {
                "lower_hz": float(row["gap_lower"][i]),
                "upper_hz": float(row["gap_upper"][i]),
                "lower_error_hz": float(row["gap_lower_error"][i]),
                "upper_error_hz": float(row["gap_upper_error"][i]),
                "complete": True,
                "between": [int(row["gap_below"][i]), int(row["gap_below"][i]) + 1],
            }
            for i in np.flatnonzero(np.isfinite(row["gap_lower"].values))
        ]

    def short_of_accuracy(self) -> list[str]:
        """Warning if edges of some designs miss the required accuracy; each edge has its error."""
        missed = self.dataset["missed_accuracy"].values
        steps = np.flatnonzero(np.isfinite(missed))
        if not len(steps):
            return []
        named = ", ".join(str(step + 1) for step in steps)
        return [
            f"The required accuracy, {self.dataset.attrs['accuracy']:g}, is not reached by "
            f"design{'s' * (len(steps) > 1)} {named} of the sweep: errors go up to "
            f"{rounded_up(float(missed[steps].max())):g} of an edge. A larger --budget may reach it."
        ]

    def around_carrier(self) -> list[str]:
        """Sentence on the designs with a gap around the carrier; none without a carrier."""
        if "carrier_hz" not in self.dataset.attrs:
            return []
        carrier = f"carrier, {hz_text(self.dataset.attrs['carrier_hz'], form='g')}"
        margins = carrier_margins(self.dataset)
        count = int(np.isfinite(margins).sum())
        if not count:
            return [f"No gap of these designs contains the {carrier}."]
        best = int(np.nanargmax(margins))
        return [
            f"The {carrier}, is inside a gap of {count} of {len(margins)} designs; its largest margin is "
            f"{hz_text(float(margins[best]), form='.2f')}, at {self.values_at(best)}."
        ]

    def table(self) -> Table:
        """Table of the widest complete gap of each design, and of the margin of the carrier in a gap."""
        data = self.dataset
        rows: list[tuple[Cell, ...]] = []
        margins = carrier_margins(data)
        of_carrier = ("margin",) if "carrier_hz" in data.attrs else ()
        for step, values in enumerate(np.stack([data[name].values for name in self.axes], axis=1)):
            gaps = self.gaps_at(step)
            widest = max(gaps, key=lambda gap: gap["upper_hz"] - gap["lower_hz"], default=None)
            count = "failed" if step in self.failed else str(len(gaps))
            frequencies = _with_errors(widest) if widest else (None,) * 3
            margin = None if np.isnan(margins[step]) else float(margins[step])
            rows.append((*values.tolist(), count, *frequencies, *(margin for _ in of_carrier)))
        return Table(
            "sweep",
            (*(Column(name, unit, SHOWN.get(unit, "")) for name, unit in self.axes.values()), "gaps",
             *(Column(name, "Hz", "kHz", ".2f") for name in ("widest", "from", "to", *of_carrier))),
            rows,
        )  # fmt: skip

    def facts(self) -> dict[str, Any]:
        """Designs with their gaps, for JSON."""
        data, margins = self.dataset, carrier_margins(self.dataset)
        designs = [
            {
                **{name: float(data[name][step]) for name in self.axes},
                "gaps": self.gaps_at(step),
                "carrier_margin_hz": None if np.isnan(margins[step]) else float(margins[step]),
                "error": self.failed.get(step),
            }
            for step in range(data.sizes["step"])
        ]
        facts: dict[str, Any] = {}
        for name, (expression, unit) in self.axes.items():
            prefix = name.removesuffix("value")
            facts |= {f"{prefix}vary": expression, f"{prefix}unit": unit or "1"}
        return {**facts, "designs": designs}


@dataclass(frozen=True, eq=False, repr=False)
class Sweeps(Result):
    """Complete gaps along all sweeps of a study."""

    title = "Parameter sweeps"

    rows: tuple[Sweep, ...]

    @property
    def dataset(self) -> xr.Dataset:
        """All sweeps, joined along ``sweep``; shorter ones are padded with NaN."""
        names = [row.expressions for row in self.rows]
        # lengths differ, and xarray aligns only dimensions with coordinates
        data = [
            row.dataset.assign_coords({name: np.arange(size) for name, size in row.dataset.sizes.items()})
            for row in self.rows
        ]
        joined = xr.concat(data, "sweep", combine_attrs="drop_conflicts", join="outer")
        joined = joined.drop_vars(list(joined.indexes))
        missing = "this sweep has no further design, or varies one expression"
        declared(joined, **dict.fromkeys(set(VALUES) & set(joined), missing))
        return joined.assign_coords(expression=("sweep", names))

    @property
    def datasets(self) -> tuple[xr.Dataset, ...]:
        return tuple(row.dataset for row in self.rows)

    def summary(self) -> list[str]:
        sentences = []
        for row in self.rows:
            gaps = [(gap, step) for step in range(row.dataset.sizes["step"]) for gap in row.gaps_at(step)]
            name, count = row.expressions, row.dataset.sizes["step"]
            if not gaps:
                result = "has a complete gap" if len(row.failed) < count else "could be computed"
                sentences.append(f"No design along {name} {result}.")
                continue
            best, step = max(gaps, key=lambda pair: pair[0]["upper_hz"] - pair[0]["lower_hz"])
            edges = (best[f"{edge}_hz"] for edge in ("lower", "lower_error", "upper", "upper_error"))
            sentences.append(
                f"Along {name}, the widest complete gap of {count} designs is at {row.values_at(step)}: "
                f"{band_text(*edges)}."
            )
            sentences += row.around_carrier()
        return sentences

    def tables(self) -> list[Table]:
        return [row.table() for row in self.rows]

    def to_dataframe(self) -> pd.DataFrame:
        """One row for each design, in SI units; with several sweeps the first column numbers them."""
        frames = [table.to_dataframe() for table in self.tables()]
        if len(frames) == 1:
            return frames[0]
        numbered = pd.concat(frames, keys=range(1, len(frames) + 1), names=["sweep"])
        return numbered.reset_index("sweep").reset_index(drop=True)

    def remarks(self) -> list[str]:
        left = [
            f"design {step + 1} of the sweep is left out: {error['cause']} ({error['argument']})"
            for row in self.rows
            for step, error in row.failed.items()
        ]
        return [*left, *(remark for row in self.rows for remark in row.short_of_accuracy())]

    @figure("sweep_*")
    def _drawn(self) -> dict[str, Callable[[], Figure]]:
        return {f"sweep_{k}": row.drawn for k, row in enumerate(self.rows, start=1)}

    @file("sweep_*.nc")
    def _written(self) -> dict[str, Writer]:
        return {
            f"sweep_{k}.nc": partial(write_netcdf, row.dataset) for k, row in enumerate(self.rows, start=1)
        }

    def facts(self) -> dict[str, Any]:
        return {"sweeps": [row.facts() for row in self.rows]}


def _with_errors(gap: Mapping[str, float]) -> tuple[Uncertain, ...]:
    """Width, lower and upper edge of a gap of `Sweep.gaps_at`, Hz."""
    lower, upper, *errors = (gap[f"{name}_hz"] for name in ("lower", "upper", "lower_error", "upper_error"))
    return Uncertain(upper - lower, sum(errors)), Uncertain(lower, errors[0]), Uncertain(upper, errors[1])
