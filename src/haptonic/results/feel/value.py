"""What a finger feels of a plate: friction wherever it lies, regions, the drive that it takes, the time."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from haptonic import plots
from haptonic.bloch import Gap
from haptonic.friction.lubrication import CUE_THRESHOLD, WEBER_FRACTION
from haptonic.friction.lubrication.on_plate import FrictionOnPlate
from haptonic.friction.phrases import change
from haptonic.gate import declared
from haptonic.later import Axes, Figure, xarray as xr
from haptonic.plate import Plate
from haptonic.results.feel.requirements import Requirement, requirements
from haptonic.results.plain import determined, split
from haptonic.results.result import Result, figure
from haptonic.results.table import Column, Table
from haptonic.units import format_quantity, hz_text

MARKS = {"green": "●", "amber": "▲", "red": "■"}  # told apart without their colour too
COLUMNS = (
    Column("region"),
    Column("amplitude", shown="um", form=".3g"),
    Column("without finger", shown="um", form=".3g", of="amplitude_without_finger"),
    Column("reduction", shown="%", form=".0f", ends=("low", "high")),
    Column("noticed from", form=".3g", of="drive_to_be_felt"),
)


@dataclass(frozen=True, eq=False, repr=False)
class Feel(Result):
    """What a finger feels of a plate, and whether that is what the plate is for.

    plate : what vibrates; gap : of its lattice around the carrier, if there is one
    friction : over that without vibration; reduction : for which a drive is asked, if one is
    """

    title = "What a finger feels"
    data_file = "feel"

    plate: Plate
    gap: Gap | None
    friction: FrictionOnPlate
    reduction: float | None = None

    @cached_property
    def by_region(self) -> xr.Dataset:
        """(region) what is felt: ``reduction`` with its ends ``low`` and ``high``, the mean ``amplitude``
        below the finger and without it, and the drive from which on people notice it."""
        friction, regions, found = self.friction, self.friction.regions, self.friction.reductions()
        told = {
            "reduction": ("1", [found[name].value for name in regions]),
            "low": ("1", [found[name].low for name in regions]),
            "high": ("1", [found[name].high for name in regions]),
            "amplitude": ("m", [friction.amplitude(name) for name in regions]),
            "amplitude_without_finger": ("m", [friction.amplitude(name, "free") for name in regions]),
            "drive_to_be_felt": (
                friction.unit, [friction.drive_for(WEBER_FRACTION, name) or np.nan for name in regions]
            ),
        }  # fmt: skip
        made = xr.Dataset({name: ("region", numbers, {"units": u}) for name, (u, numbers) in told.items()})
        declared(made, drive_to_be_felt="no drive makes it noticed")
        return made.assign_coords(region=np.array(regions, dtype=str))

    @property
    def requirements(self) -> list[Requirement]:
        """Whether the plate does what it is for, each as a traffic light with its reason."""
        friction = self.friction
        return requirements(
            friction.reductions(),
            friction.driven,
            friction.rise,
            friction.constant,
            friction.frequency,
            self.gap,
        )

    @property
    def at_drive(self) -> str:
        """Frequency and amplitude of the drive."""
        return f"{self._frequency} and {self._drive}"

    @property
    def _frequency(self) -> str:
        return hz_text(self.friction.frequency, form=".2f")

    @property
    def _drive(self) -> str:
        return format_quantity(self.friction.drive, self.friction.unit)

    @property
    def dataset(self) -> xr.Dataset:
        """Friction and amplitudes at every place, with all that made them."""
        friction = self.friction
        found = friction.at_points()
        quality = friction.loaded["quality"].sel(load="value", drop=True)
        described = {
            "value": "mu / mu0, load sharing",
            "low": "lower end of the band",
            "high": "upper end of the band",
        }
        for name, words in described.items():
            found[name].attrs = {"units": "1", "long_name": words}
        found["amplitude"].attrs = {"units": "m", "long_name": "rms below the finger, peak in time"}
        found["quality"] = quality
        found.attrs |= dict(friction.loaded.attrs) | {
            "touch": json.dumps({"force_n": friction.touch.force, "speed_m_s": friction.touch.speed}),
            "assumptions": json.dumps(friction.skin.assumptions()),
        }
        return found

    @figure(
        "friction",
        "Simulated reduction of friction below a finger with its middle at each point; on the right the ends "
        "of the range that two models and all plausible parameters leave.",
    )
    def _friction(self) -> Figure:
        title = f"{self._frequency}, {self._drive}, simulated"
        return plots.friction_map(self.friction.at_points(), self.plate.layout, title=title)

    @figure(
        "reduction",
        "Simulated reduction of friction, averaged over each region, against the amplitude of the drive.",
    )
    def _reduction(self, *, ax: Axes | None = None) -> Figure:
        title = f"{self._frequency}, simulated"
        return plots.reduction_curve(
            self.friction.curve, self.friction.drive, WEBER_FRACTION, title=title, ax=ax
        )

    def summary(self) -> list[str]:
        driven, reductions = self.friction.driven, self.friction.reductions()
        felt = "; ".join(
            f"{name}{' (driven)' if name in driven else ''}: {change(one.value, one.low, one.high)}"
            for name, one in reductions.items()
        )
        said = [f"At {self.at_drive}, {felt}."]
        if self.reduction is not None:
            drives = "; ".join(f"{name}: {self.drive_text(v)}" for name, v in self.drives.items())
            said.append(f"For a reduction of {100 * self.reduction:.0f} %: {drives}")
        marked = [name for name, one in self.friction.skin.assumptions().items() if one["mark"] == "assumed"]
        said.append(
            f"Assumed, not measured: {', '.join(name.replace('_', ' ') for name in marked)}, damping of the "
            "finger. Values by load sharing; intervals over both models and all plausible parameters. "
            "Simulated."
        )
        return said

    @property
    def drives(self) -> dict[str, float | None]:
        """Amplitude of the drive that gives the reduction asked for on each region."""
        return {name: self.friction.drive_for(self.reduction or 0.0, name) for name in self.friction.regions}

    def drive_text(self, drive: float | None) -> str:
        """A drive as people read it."""
        return "not reached" if drive is None else f"{drive:.3g} {self.friction.unit}"

    def tables(self) -> list[Table]:
        """Every region: amplitudes, reduction, the drive from which on it is noticed; then the demands."""
        touched = Table.of(
            f"below a finger of {self.friction.touch.force:g} N at {self.at_drive}, simulated",
            self.by_region,
            "region",
            COLUMNS,
            [number for number, name in enumerate(self.friction.regions) if name in self.friction.driven],
        )
        demands = [(f"{MARKS[one.colour]} {one.colour}", one.what, one.reason) for one in self.requirements]
        return [
            touched,
            Table("does the simulated plate do what it is for?", ("light", "demand", "why"), demands),
        ]

    def facts(self) -> dict[str, Any]:
        friction = self.friction
        return {
            "gap_hz": (self.gap.lower, self.gap.upper) if self.gap else None,
            "drive": {"amplitude": friction.drive, "unit": friction.unit},
            "driven": friction.driven,
            "regions": split(self.by_region, "region"),
            "drive_for": None if self.reduction is None else {"reduction": self.reduction, **self.drives},
            "amplitude_ratio": friction.ratio,
            "localised": {name: margin.localised for name, margin in friction.margins.items()},
            "stopped": {name: margin.stopped for name, margin in friction.margins.items()},
            "quality_factor": determined(friction.quality()),
            "quality_factor_without_finger": determined(friction.quality("free")),
            "rise_time_s": determined(friction.rise),
            "cue_threshold_s": CUE_THRESHOLD,
            "weber_fraction": WEBER_FRACTION,
            "requirements": self.requirements,
        }
