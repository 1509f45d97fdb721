"""Best design of a search, and all examined designs."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from haptonic import plots
from haptonic.bloch import Gap
from haptonic.design.links import units_of
from haptonic.later import Axes, Figure, xarray as xr
from haptonic.plots.text import gap_text
from haptonic.results.common import write_netcdf
from haptonic.results.plain import split
from haptonic.results.result import Result, figure, file
from haptonic.results.table import Column, Table
from haptonic.units import format_quantity, hz_text


def _has_front(result: Design) -> bool:
    return result.front is not None


@dataclass(frozen=True, eq=False, repr=False)
class Design(Result):
    """Best design of a search, and all examined designs.

    values : numbers of the design by path, SI; own : the same numbers of the study
    gap : at the required accuracy; margin : of the carrier in it, with errors subtracted, Hz
    dataset : all examined designs
    study : the study with the best design, as TOML
    front : widest margin of each pitch, if computed
    """

    title = "Design"
    data_file = "search"

    values: dict[str, float]
    gap: Gap
    margin: float
    dataset: xr.Dataset
    own: dict[str, float] = field(default_factory=dict)
    study: str = ""
    front: xr.Dataset | None = None

    @property
    def held_back_by(self) -> list[str]:
        """Bounds and limits that the design has reached, as texts."""
        return list(json.loads(self.dataset.attrs["held_back_by"]))

    @property
    def is_settled(self) -> bool:
        """True if the search ended where no small change of the design widens the margin."""
        return bool(self.dataset.attrs["settled"])

    @property
    def left_out(self) -> list[dict[str, Any]]:
        """Designs that could not be computed: ``stage`` of the search, ``values`` by path (SI), ``cause``."""
        return list(json.loads(self.dataset.attrs["left_out"]))

    @property
    def units(self) -> dict[str, str]:
        """SI units of the varied numbers, by path."""
        return units_of(self.dataset["parameter"])

    def summary(self) -> list[str]:
        gap, carrier = self.gap, float(self.dataset.attrs["carrier_hz"])
        sentences = [
            f"The carrier, {hz_text(carrier, form='g')}, lies in the gap "
            f"{gap_text(gap)} with a margin of "
            f"at least {hz_text(self.margin, form='.2f')}.",
            self._limiting(),
        ]
        units = self.units
        return sentences + [
            "left out: "
            + ", ".join(f"{path} = {format_quantity(v, units[path])}" for path, v in design["values"].items())
            + f", because {design['cause']}"
            for design in self.left_out
        ]

    def _limiting(self) -> str:
        reached = ", ".join(self.held_back_by)
        if self.is_settled:
            return f"The margin is limited by {reached or 'no bound and no limit'}."
        at = f" The design has reached {reached}." if reached else ""
        return f"The search ended before the margin was largest: more steps in [design] may widen it.{at}"

    def tables(self) -> list[Table]:
        units = self.units
        values = [
            (path, *(format_quantity(v, units[path], digits=4) for v in (self.own.get(path, value), value)))
            for path, value in self.values.items()
        ]
        table = Table("design", ("parameter", "study", "best design"), values)
        return [table] if self.front is None else [table, front_table(self.front)]

    @figure(
        "search", "Simulated designs of the search: their sizes, and the margin of the carrier in the gap."
    )
    def _search(self) -> Figure:
        return plots.search(self.dataset, self.units)

    @figure("front", "The widest gap against the pitch.", when=_has_front)
    def _front(self, *, ax: Axes | None = None) -> Figure:
        assert self.front is not None
        return plots.front(self.front, ax=ax)

    @file("front.nc", when=_has_front)
    def _write_front(self, path: Path) -> None:
        assert self.front is not None
        write_netcdf(self.front, path)

    @file("design.toml")
    def _write_study(self, path: Path) -> None:
        path.write_text(self.study, "utf-8")

    def facts(self) -> dict[str, Any]:
        front = {} if self.front is None else {"front": self.front[["pitch", "lower", "upper", "margin"]]}
        return {
            "values": self.values,
            "gap": self.gap,
            "margin_hz": self.margin,
            "seen": split(self.dataset, "visit"),
            "study": self.study,
            **front,
        }


def front_table(front: xr.Dataset) -> Table:
    """Table of the widest gap of each pitch."""
    open_gaps = front.where(front["margin"] > 0)  # a comparison with NaN is False
    columns = (
        Column("pitch", shown="mm", form=".3g"), Column("from", shown="kHz", form=".2f", of="lower"),
        Column("to", shown="kHz", form=".2f", of="upper"), Column("width", shown="kHz", form=".2f"),
    )  # fmt: skip
    rows = open_gaps.assign(
        pitch=front["pitch"], width=(open_gaps["upper"] - open_gaps["lower"]).assign_attrs(units="Hz")
    )
    return Table.of("widest gap around the carrier (-: none)", rows, "design", columns)
