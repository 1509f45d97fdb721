"""Reading of the records of friction trials before their analysis."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from haptonic.friction.recordings import Understood
from haptonic.later import xarray as xr
from haptonic.results.reading import MOST_SAMPLES, Reading
from haptonic.results.table import Table
from haptonic.units import format_quantity


@dataclass(frozen=True, eq=False, repr=False)
class TrialsReading(Reading):
    """Friction trials as they were read."""

    trials: Understood

    @property
    def origin(self) -> str:
        return "simulated" if self.trials.simulated else "measured"

    @cached_property
    def dataset(self) -> xr.Dataset:
        """Forces of the first record; without records an empty axis."""
        first = self.trials.first
        if first is None:
            return xr.Dataset(coords={"time": ("time", np.zeros(0), {"units": "s"})})
        _, record = first
        every = max(1, -(-len(record.normal) // MOST_SAMPLES))
        forces = {
            name: ("time", getattr(record, name)[::every], {"units": "N", "long_name": f"{name} force"})
            for name in ("normal", "tangential")
        }
        time = np.arange(len(record.normal))[::every] / record.rate
        return xr.Dataset(
            forces,
            coords={"time": ("time", time, {"units": "s", "long_name": f"time in the record of {first[0]}"})},
        )

    def summary(self) -> list[str]:
        total = sum(self.trials.trials.values())
        people = dict.fromkeys(person for person, _, _ in self.trials.trials)
        regions = dict.fromkeys(region for _, region, _ in self.trials.trials)
        return [f"{total} trials of {len(people)} participants on {' and '.join(regions)}, {self.origin}."]

    def remarks(self) -> list[str]:
        return [*self.trials.doubts, *(f"assumed: {text}" for text in self.trials.remarks)]

    def answers(self) -> list[tuple[str, str]]:
        rows = [
            (f"{meaning} channel", f'"{name}", 1 unit = {format_quantity(abs(value), unit)}'
             + (", turned" if value < 0 else ""))
            for meaning, (name, value, unit) in self.trials.channels.items()
        ]  # fmt: skip
        if self.trials.first is not None:
            label, record = self.trials.first
            rows += [
                ("first record", label),
                ("sampling rate", format_quantity(record.rate, "Hz")),
                ("largest normal force", format_quantity(float(np.nanmax(record.normal)), "N")),
                ("largest tangential force",
                 format_quantity(float(np.nanmax(np.abs(record.tangential))), "N")),
            ]  # fmt: skip
        return rows

    def tables(self) -> list[Table]:
        rows = [(*labels, str(count)) for labels, count in self.trials.trials.items()]
        counts = Table("trials of each condition", ("participant", "region", "vibration", "trials"), rows)
        return [*super().tables(), counts]
