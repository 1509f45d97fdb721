"""How well a plate's model fits its measurement, and with which numbers it fits best."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from haptonic import plots
from haptonic.arrays import Array
from haptonic.gate import declared
from haptonic.later import Axes, Figure, xarray as xr
from haptonic.plate import Plate
from haptonic.plate.levels import contrasts
from haptonic.plate.sampling import driven_region
from haptonic.response import FrequencyResponse, average_spectrum, write
from haptonic.results.common import stamped
from haptonic.results.plain import split
from haptonic.results.result import Result, figure, file
from haptonic.results.table import Cell, Column, Table, Uncertain
from haptonic.units import format_quantity
from haptonic.updating.agreement import UNRESOLVED, Agreement, paired
from haptonic.updating.fit import Fit
from haptonic.vibrometry.maps.gap import MeasuredGap

MOST_ROWS = 40  # pairs that a table shows
PAIR_COLUMNS = (
    Column("measured", shown="kHz", form=".3f"), Column("model", shown="kHz", form=".3f", of="computed"),
    Column("difference", shown="%", form="+.2f", of="frequency_difference"),
    Column("damping", shown="%", form=".3f", of="measured_damping"),
    Column("model damping", shown="%", form=".3f", of="computed_damping"),
    Column("MAC", form=".3f", of="mac"),
)  # fmt: skip
MEASURED, BEFORE, AFTER = "measurement", "model as given", "model fitted"


@dataclass(frozen=True, eq=False, repr=False)
class Verdict(Result):
    """A measurement beside its model, at the same points and lines.

    plate : as given; responses : by `MEASURED`, `BEFORE` and, after a fit, `AFTER`
    agreements : of the computed responses with the measured one, by the same names
    ranges : of high contrast over the lattice in each response, found in the same way; None without one
    fit : if there was one
    recomputed : relative error of the fit's response, against that of the fitted plate computed anew
    left_out : points of the scan that do not lie on the plate
    study : the file with the fitted numbers, if there was a fit
    inputs : all that made it, in JSON types
    """

    title = "Verdict"
    data_file = "verdict"

    plate: Plate
    responses: Mapping[str, FrequencyResponse]
    agreements: Mapping[str, Agreement]
    ranges: Mapping[str, MeasuredGap | None]
    fit: Fit | None
    recomputed: float | None
    left_out: int
    study: str | None
    inputs: Mapping[str, Any]

    @property
    def measured(self) -> FrequencyResponse:
        return self.responses[MEASURED]

    @property
    def origin(self) -> str:
        """Of the measurement, "measured" or "simulated"."""
        return str(self.measured.dataset.attrs["origin"])

    @property
    def last(self) -> str:
        """The better of the models, by name."""
        return AFTER if AFTER in self.responses else BEFORE

    @property
    def labels(self) -> dict[str, str]:
        """What pictures call each response."""
        own = "simulated measurement" if self.origin == "simulated" else "measurement"
        return {name: own if name == MEASURED else f"{name} (simulated)" for name in self.responses}

    def contrasts(self) -> dict[str, dict[str, Array]]:
        """By pair of regions and response, dB; see `haptonic.plate.levels.contrasts`."""
        found = {name: contrasts(one, driven_region(self.plate)) for name, one in self.responses.items()}
        return {
            pair: {name: levels[pair].values for name, levels in found.items()} for pair in found[MEASURED]
        }

    @figure("before-after", "Measurement and model, averaged over the points and as contrast.")
    def _before_after(self) -> Figure:
        labels = self.labels
        spectra = {labels[name]: average_spectrum(one).values for name, one in self.responses.items()}
        levels = {
            pair: {labels[name]: level for name, level in one.items()}
            for pair, one in self.contrasts().items()
        }
        return plots.before_after(self.measured.frequency, spectra, levels, units=self.measured.units)

    @figure("frac", "Agreement of measurement and model at every point.")
    def _frac(self) -> Figure:
        frac = {self.labels[name]: one.frac for name, one in self.agreements.items()}
        layout = self.plate.layout
        return plots.frac_maps(self.measured.points, frac, layout, measured=self.labels[MEASURED])

    @figure("mac", "Agreement of shapes.", when=lambda result: result.agreements[result.last].mac.size)
    def _mac(self, *, ax: Axes | None = None) -> Figure:
        last, labels = self.agreements[self.last], self.labels
        return plots.mac_matrix(last, measured=labels[MEASURED], computed=labels[self.last], ax=ax)

    @file("verdict.json")
    def _write_json(self, path: Path) -> None:
        path.write_text(json.dumps(self.to_json(), indent=1) + "\n", "utf-8")

    @file("model.nc")
    def _write_model(self, path: Path) -> None:
        write(self.responses[self.last], path)

    @file("fitted.toml", when=lambda result: result.study is not None)
    def _write_study(self, path: Path) -> None:
        path.write_text(self.study or "", "utf-8")

    def summary(self) -> list[str]:
        """How much of the measurement the models explain, and how sure the numbers are."""
        said = [
            f"{name}: the model leaves {100 * one.unexplained:.2g} % of the measured energy unexplained; "
            f"median FRAC {np.nanmedian(one.frac):.4f}."
            for name, one in self.agreements.items()
        ]
        if (fit := self.fit) is not None:
            known = fit.uncertainty
            kind = "look independent" if known.independent else "are alike at neighbouring points or lines"
            said.append(
                f"Residuals {kind}: {known.data} numbers count as {known.effective:.0f}. The response "
                f"of the fit is {self.recomputed:.1e} off the plate computed anew. {len(fit.left_out)} "
                "points of strange residuals were left out."
            )
        if self.left_out:
            said.append(f"{self.left_out} points do not lie on the plate and were left out.")
        return [*said, f"{self.labels[MEASURED].capitalize()} against a simulation."]

    def tables(self) -> list[Table]:
        """Fitted numbers, pairs of shapes, ranges of high contrast."""
        found = [] if self.fit is None else [fit_table(self.fit)]
        found.append(pairs_table(self.agreements[self.last], self.last))
        return [*found, self._ranges()] if any(self.ranges.values()) else found

    def _ranges(self) -> Table:
        """Where the driven region stands out from the lattice in each response, found in the same way."""
        ends = [Column(name, "Hz", "kHz", ".2f") for name in ("from", "to")]
        rows: list[tuple[Cell, ...]] = [
            (name, "none found", "") if one is None
            else (name, Uncertain(one.lower, one.lower_error), Uncertain(one.upper, one.upper_error))
            for name, one in self.ranges.items()
        ]  # fmt: skip
        return Table("high contrast over the lattice", ("response", *ends), rows)

    @property
    def dataset(self) -> xr.Dataset:
        """FRAC of each model against the points, and the MAC matrix of the last one."""
        last = self.agreements[self.last]
        data = xr.Dataset(
            {
                "frac": (("model", "point"), np.stack([one.frac for one in self.agreements.values()])),
                "mac": (("measured_shape", "computed_shape"), last.mac),
                "measured_frequency": ("measured_shape", last.measured.frequency, {"units": "Hz"}),
                "computed_frequency": ("computed_shape", last.computed.frequency, {"units": "Hz"}),
                "measured_damping": ("measured_shape", last.measured.damping),
                "computed_damping": ("computed_shape", last.computed.damping),
            },
            coords={
                "model": list(self.agreements),
                "x": ("point", self.measured.points[:, 0], {"units": "m"}),
                "y": ("point", self.measured.points[:, 1], {"units": "m"}),
            },
        )
        declared(data, frac="the point does not move", **UNRESOLVED)
        made = stamped(data, dict(self.inputs))
        return made.assign_attrs(origin=f"{self.origin} response against a simulated one")

    def facts(self) -> dict[str, Any]:
        return {
            "measurement": self.origin,
            "model": "simulated",
            "lines": len(self.measured.frequency),
            "points": len(self.measured.points),
            "points_left_out": self.left_out,
            "agreement": {name: _facts_of(one) for name, one in self.agreements.items()},
            "contrast_range": self.ranges,
            "fit": self.fit and self._fit_facts(self.fit),
        }

    def _fit_facts(self, fit: Fit) -> dict[str, Any]:
        return {
            "parameters": fit.numbers,
            "unexplained_before": fit.unexplained_before,
            "unexplained": fit.unexplained,
            "points_left_out": len(fit.left_out),
            "residuals_independent": fit.uncertainty.independent,
            "data": fit.uncertainty.data,
            "effective_data": fit.uncertainty.effective,
            "correlation": fit.uncertainty.correlation,
            "small_model_error": fit.error,
            "recomputed_error": self.recomputed,
            "answers_in_small_model": fit.anchors,
        }


def fit_table(fit: Fit) -> Table:
    """Each number before and after."""
    rows = [
        (
            one.name,
            format_quantity(one.start, one.unit),
            format_quantity(one.value, one.unit),
            one.range_text,
        )
        for one in fit.numbers
    ]
    return Table("numbers fitted to the response", ("parameter", "start", "fitted", "95 % interval"), rows)


def pairs_table(one: Agreement, model: str) -> Table:
    """Shapes that belong together."""
    title = (
        f"{one.measured.how}: {len(one.pairs)} pairs of {len(one.measured.frequency)} measured and "
        f"{len(one.computed.frequency)} of the {model}"
    )
    return Table.of(title, paired(one).isel(pair=slice(MOST_ROWS)), "pair", PAIR_COLUMNS)


def _facts_of(one: Agreement) -> dict[str, Any]:
    return {
        "shapes": one.measured.how,
        "unexplained": one.unexplained,
        "frac_median": float(np.nanmedian(one.frac)),
        "measured_hz": one.measured.frequency,
        "computed_hz": one.computed.frequency,
        "mac": one.mac,
        "pairs": split(paired(one), "pair"),
    }
