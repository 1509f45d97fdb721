"""Comparison of a plate's model with its measurement, and fitted numbers of the model."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from haptonic import plots
from haptonic.arrays import Array
from haptonic.gate import declared
from haptonic.later import Axes, Figure, xarray as xr
from haptonic.names import counted
from haptonic.plate import Plate
from haptonic.plate.layout.sampling import driven_region
from haptonic.plate.vibration.region_measures import contrasts
from haptonic.response import FrequencyResponse, average_spectrum, write
from haptonic.results.common import stamped
from haptonic.results.plain import split
from haptonic.results.result import Result, figure, file
from haptonic.results.table import Cell, Column, Table, Uncertain
from haptonic.units import format_quantity, in_percent
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
    """A measurement and its models, at the same points and frequencies.

    plate : as given; responses : by `MEASURED`, `BEFORE` and, after a fit, `AFTER`
    agreements : of the computed responses with the measured response, by the same names
    ranges : of high contrast over the lattice in each response, by the same method; None without one
    fit : result of the fit, if any
    recomputed : relative error of the fit's response against the fitted plate, computed again
    left_out : number of points of the scan outside the plate
    study : file with the fitted numbers, if any
    inputs : all inputs, in JSON types
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
        """Origin of the measurement, "measured" or "simulated"."""
        return str(self.measured.dataset.attrs["origin"])

    @property
    def last(self) -> str:
        """Name of the last model: the fitted one, if any."""
        return AFTER if AFTER in self.responses else BEFORE

    @property
    def labels(self) -> dict[str, str]:
        """Labels of the responses in pictures."""
        label = "simulated measurement" if self.origin == "simulated" else "measurement"
        return {name: label if name == MEASURED else f"{name} (simulated)" for name in self.responses}

    def contrasts(self) -> dict[str, dict[str, Array]]:
        """Contrasts of the driven region by pair of regions and response, dB."""
        by_name = {
            name: contrasts(response, driven_region(self.plate)) for name, response in self.responses.items()
        }
        return {
            pair: {name: levels[pair].values for name, levels in by_name.items()}
            for pair in by_name[MEASURED]
        }

    @figure("before-after", "Measurement and model, averaged over the points and as contrast.")
    def _before_after(self) -> Figure:
        labels = self.labels
        spectra = {
            labels[name]: average_spectrum(response).values for name, response in self.responses.items()
        }
        levels = {
            pair: {labels[name]: level for name, level in contrast.items()}
            for pair, contrast in self.contrasts().items()
        }
        return plots.before_after(self.measured.frequency, spectra, levels, units=self.measured.units)

    @figure("frac", "Agreement of measurement and model at every point.")
    def _frac(self) -> Figure:
        frac = {self.labels[name]: agreement.frac for name, agreement in self.agreements.items()}
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
        """Sentences on the explained share of the measurement, and on the certainty of fitted numbers."""
        agreements = [
            f"{name}: the model leaves {_share(agreement.unexplained)} of the measured "
            f"energy unexplained, median FRAC {np.nanmedian(agreement.frac):.4f}."
            for name, agreement in self.agreements.items()
        ]
        sentences = [" ".join(agreements)]
        if (fit := self.fit) is not None:
            uncertainty = fit.uncertainty
            kind = (
                "look independent"
                if uncertainty.independent
                else "are alike at neighbouring points or frequencies"
            )
            sentences.append(
                f"Residuals {kind}: {uncertainty.data} numbers count as {uncertainty.effective:.0f}. The "
                f"response of the fit differs by {self.recomputed:.1e} from the plate computed again. "
                f"Left out for outlying residuals: {counted(len(fit.left_out), 'point')}."
            )
        if self.left_out:
            sentences.append(f"Left out, because outside the plate: {counted(self.left_out, 'point')}.")
        return [*sentences, f"{self.labels[MEASURED].capitalize()} compared with a simulation."]

    def tables(self) -> list[Table]:
        """Fitted numbers, pairs of shapes, ranges of high contrast."""
        tables = [] if self.fit is None else [fit_table(self.fit)]
        tables.append(pairs_table(self.agreements[self.last], self.last))
        return [*tables, self._ranges()] if any(self.ranges.values()) else tables

    def _ranges(self) -> Table:
        """Table of the ranges with high contrast of the driven region, by one method for all responses."""
        ends = [Column(name, "Hz", "kHz", ".2f") for name in ("from", "to")]
        rows: list[tuple[Cell, ...]] = [
            (name, "not determined", "") if span is None
            else (name, Uncertain(span.lower, span.lower_error), Uncertain(span.upper, span.upper_error))
            for name, span in self.ranges.items()
        ]  # fmt: skip
        return Table("high contrast over the lattice", ("response", *ends), rows)

    @cached_property
    def dataset(self) -> xr.Dataset:
        """FRAC of each model against the points, and the MAC matrix of the last model."""
        last = self.agreements[self.last]
        data = xr.Dataset(
            {
                "frac": (
                    ("model", "point"),
                    np.stack([agreement.frac for agreement in self.agreements.values()]),
                ),
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
        data = stamped(data, dict(self.inputs))
        return data.assign_attrs(origin=f"{self.origin} response against a simulated one")

    def facts(self) -> dict[str, Any]:
        return {
            "measurement": self.origin,
            "model": "simulated",
            "lines": len(self.measured.frequency),
            "points": len(self.measured.points),
            "points_left_out": self.left_out,
            "agreement": {name: _facts_of(agreement) for name, agreement in self.agreements.items()},
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


def _share(unexplained: float) -> str:
    return in_percent(unexplained, form=".2g" if unexplained < 0.1 else ".0f")


def fit_table(fit: Fit) -> Table:
    """Table of each fitted number before and after the fit."""
    rows = [
        (
            number.name,
            format_quantity(number.start, number.unit),
            format_quantity(number.value, number.unit),
            number.range_text,
        )
        for number in fit.numbers
    ]
    return Table("numbers fitted to the response", ("parameter", "start", "fitted", "95 % interval"), rows)


def pairs_table(agreement: Agreement, model: str) -> Table:
    """Table of paired shapes."""
    title = (
        f"{agreement.measured.how}: {counted(len(agreement.pairs), 'pair')} of "
        f"{len(agreement.measured.frequency)} measured and {len(agreement.computed.frequency)} of the {model}"
    )
    return Table.of(title, paired(agreement).isel(pair=slice(MOST_ROWS)), "pair", PAIR_COLUMNS)


def _facts_of(agreement: Agreement) -> dict[str, Any]:
    return {
        "shapes": agreement.measured.how,
        "unexplained": agreement.unexplained,
        "frac_median": float(np.nanmedian(agreement.frac)),
        "measured_hz": agreement.measured.frequency,
        "computed_hz": agreement.computed.frequency,
        "mac": agreement.mac,
        "pairs": split(paired(agreement), "pair"),
    }
