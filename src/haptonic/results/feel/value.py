"""What a finger feels of a plate: friction wherever it lies, regions, the drive that it takes, the time."""

from __future__ import annotations

import json
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic import plots
from haptonic.bloch import Gap
from haptonic.friction.lubrication import (
    CUE_THRESHOLD,
    WEBER_FRACTION,
    Fingertip,
    Margin,
    Touch,
    rise_time,
    time_constant,
)
from haptonic.friction.lubrication.law import End, FrictionLaw
from haptonic.friction.phrases import change
from haptonic.gate import declared
from haptonic.later import Axes, Figure, xarray as xr
from haptonic.plate import Plate
from haptonic.plate.sampling import driven_regions
from haptonic.plate.touch import whole_finger_on
from haptonic.response import Reference
from haptonic.results.feel.reduction import Reduction
from haptonic.results.feel.requirements import Requirement, requirements
from haptonic.results.plain import determined, split
from haptonic.results.result import Result, figure
from haptonic.results.table import Column, Table
from haptonic.units import format_quantity

ENDS: tuple[End, ...] = ("value", "low", "high")
CURVE = 41  # drives of the curve of reduction against drive
MARKS = {"green": "●", "amber": "▲", "red": "■"}  # told apart without their colour too
COLUMNS = (
    Column("region"),
    Column("amplitude", shown="um", form=".3g"),
    Column("without finger", shown="um", form=".3g", of="amplitude_without_finger"),
    Column("reduction", shown="%", form=".0f", ends=("low", "high")),
    Column("noticed from", form=".3g", of="drive_to_be_felt"),
)
BEYOND = 2.0  # times the drive: where that curve ends


@dataclass(frozen=True, eq=False, repr=False)
class Feel(Result):
    """Friction that a finger meets on a plate, over that without vibration.

    plate : what vibrates; gap : of its lattice around the carrier, if there is one
    loaded : from `haptonic.plate.loaded.loaded`; diameter : of the finger's disc, m
    touch : frequency, force and speed; skin : what the lubrication models know of the finger
    drive : amplitude of the first drive, V or N
    reduction : for which a drive is asked, if one is
    """

    title = "What a finger feels"
    data_file = "feel"

    plate: Plate
    gap: Gap | None
    loaded: xr.Dataset
    diameter: float
    touch: Touch
    skin: Fingertip
    drive: float
    reduction: float | None = None

    @property
    def frequency(self) -> float:
        """Hz"""
        return float(self.loaded.attrs["frequency_hz"])

    @property
    def unit(self) -> str:
        """Of the drive, V or N."""
        return Reference.parse(str(self.loaded.attrs["reference"])).unit

    @property
    def driven(self) -> tuple[str, ...]:
        """The regions of plain plate that carry a drive, that of the first one first."""
        return driven_regions(self.plate)

    @property
    def regions(self) -> tuple[str, ...]:
        """Regions of plain plate."""
        return self.plate.layout.regions

    @cached_property
    def below(self) -> dict[str, NDArray[np.bool_]]:
        """(point,) places at which the whole finger lies on a region, or its middle if it is too small."""
        points = np.stack([self.loaded["x"].values, self.loaded["y"].values], axis=1)
        of = {name: self.loaded["region"].values == name for name in self.regions}
        return {
            name: whole_finger_on(points, inside, self.plate.layout, self.diameter)
            for name, inside in of.items()
        }

    @cached_property
    def law(self) -> FrictionLaw:
        """mu / mu0 against amplitude."""
        return FrictionLaw.of(self.touch, self.skin)

    def friction(self, drive: float | None = None) -> xr.Dataset:
        """``value`` (point,) mu / mu0; ``low`` and ``high``, the band of both models, skin and damping."""
        drive = self.drive if drive is None else drive
        moved = self.loaded["amplitude"] * drive
        return xr.Dataset(  # the least friction is with the least damping
            {end: ("point", self.law.at(moved.sel(load=end).values, end)) for end in ENDS}
            | {"amplitude": moved.sel(load="value", drop=True)},
            attrs={"origin": "simulated", "drive": f"{drive:g} {self.unit}"},
        )

    def reductions(self, drive: float | None = None) -> dict[str, Reduction]:
        """Mean reduction over the places of every region."""
        found = self.friction(drive)
        return {
            name: Reduction(
                *(1 - float(found[end].values[self.below[name]].mean()) for end in ("value", "high", "low"))
            )
            for name in self.regions
        }

    @cached_property
    def by_region(self) -> xr.Dataset:
        """(region) what is felt: ``reduction`` with its ends ``low`` and ``high``, the mean ``amplitude``
        below the finger and without it, and the drive from which on people notice it."""
        found = self.reductions()
        told = {
            "reduction": ("1", [found[name].value for name in self.regions]),
            "low": ("1", [found[name].low for name in self.regions]),
            "high": ("1", [found[name].high for name in self.regions]),
            "amplitude": ("m", [self.amplitude(name) for name in self.regions]),
            "amplitude_without_finger": ("m", [self.amplitude(name, "free") for name in self.regions]),
            "drive_to_be_felt": (
                self.unit, [self.drive_for(WEBER_FRACTION, name) or np.nan for name in self.regions]
            ),
        }  # fmt: skip
        made = xr.Dataset({name: ("region", numbers, {"units": u}) for name, (u, numbers) in told.items()})
        declared(made, drive_to_be_felt="no drive makes it noticed")
        return made.assign_coords(region=np.array(self.regions, dtype=str))

    def drive_for(self, reduction: float, region: str) -> float | None:
        """Amplitude of the drive, V or N, for a mean reduction on a region; see `FrictionLaw`."""
        per_unit = self.loaded["amplitude"].sel(load="value").values[self.below[region]]
        return self.law.drive_for(reduction, per_unit, self.drive)

    def amplitude(self, region: str, load: str = "value") -> float:
        """Mean amplitude below a finger on a region, m."""
        return self.drive * float(self.loaded["amplitude"].sel(load=load).values[self.below[region]].mean())

    def quality(self, load: str = "value") -> float:
        """Median quality factor of the mode that answers most, a finger being on the first driven region."""
        where = self.below[self.driven[0]] if self.driven else np.ones(self.loaded.sizes["point"], dtype=bool)
        return float(np.median(self.loaded["quality"].sel(load=load).values[where]))

    @property
    def rise(self) -> float:
        """Time from 10 to 90 % of the vibration with a finger on the driven region, s."""
        return rise_time(self.quality(), self.frequency)

    @property
    def constant(self) -> float:
        """Time constant of the vibration with a finger on the driven region, s."""
        return time_constant(self.quality(), self.frequency)

    @property
    def ratio(self) -> dict[str, float]:
        """Amplitude below a finger on the first driven region over that on every one without a drive."""
        if not self.driven:
            return {}
        most = self.amplitude(self.driven[0])
        return {name: most / self.amplitude(name) for name in self.regions if name not in self.driven}

    @property
    def margins(self) -> dict[str, Margin]:
        """The first driven region beside every one without a drive."""
        if not self.driven:
            return {}
        found = self.reductions()
        return {
            name: Margin(found[self.driven[0]].value, found[name].value)
            for name in self.regions if name not in self.driven
        }  # fmt: skip

    @property
    def requirements(self) -> list[Requirement]:
        """Whether the plate does what it is for, each as a traffic light with its reason."""
        return requirements(
            self.reductions(), self.driven, self.rise, self.constant, self.frequency, self.gap
        )

    @property
    def curve(self) -> xr.Dataset:
        """``value``, ``low`` and ``high`` (region, drive): reduction against the amplitude of the drive."""
        drives = np.linspace(0, BEYOND * self.drive, CURVE)
        found = [self.reductions(float(drive)) for drive in drives]
        dims = ("region", "drive")
        return xr.Dataset(
            {
                end: (dims, np.array([[getattr(one[name], end) for one in found] for name in self.regions]))
                for end in ENDS
            },
            coords={"region": list(self.regions), "drive": ("drive", drives, {"units": self.unit})},
        )

    @property
    def dataset(self) -> xr.Dataset:
        """Friction and amplitudes at every place, with all that made them."""
        found = self.friction()
        quality = self.loaded["quality"].sel(load="value", drop=True)
        described = {
            "value": "mu / mu0, load sharing",
            "low": "lower end of the band",
            "high": "upper end of the band",
        }
        for name, words in described.items():
            found[name].attrs = {"units": "1", "long_name": words}
        found["amplitude"].attrs = {"units": "m", "long_name": "rms below the finger, peak in time"}
        found["quality"] = quality
        found.attrs |= dict(self.loaded.attrs) | {
            "touch": json.dumps({"force_n": self.touch.force, "speed_m_s": self.touch.speed}),
            "assumptions": json.dumps(self.skin.assumptions()),
        }
        return found

    @figure(
        "friction",
        "Simulated friction below a finger with its middle at each point, over that without vibration; on "
        "either side the ends of the band that two models and all plausible parameters leave.",
    )
    def _friction(self) -> Figure:
        title = f"{self.frequency / 1e3:.2f} kHz, {format_quantity(self.drive, self.unit)}, simulated"
        return plots.friction_map(self.friction(), self.plate.layout, title=title)

    @figure(
        "reduction",
        "Simulated reduction of friction, averaged over each region, against the amplitude of the drive.",
    )
    def _reduction(self, *, ax: Axes | None = None) -> Figure:
        title = f"{self.frequency / 1e3:.2f} kHz, simulated"
        return plots.reduction_curve(self.curve, self.drive, WEBER_FRACTION, title=title, ax=ax)

    def summary(self) -> list[str]:
        drive = format_quantity(self.drive, self.unit)
        felt = "; ".join(
            f"{name}{' (driven)' if name in self.driven else ''}: {change(one.value, one.low, one.high)}"
            for name, one in self.reductions().items()
        )
        said = [f"At {self.frequency / 1e3:.2f} kHz and {drive}, {felt}."]
        if self.reduction is not None:
            drives = "; ".join(f"{name}: {self.drive_text(v)}" for name, v in self.drives.items())
            said.append(f"For a reduction of {100 * self.reduction:.0f} %: {drives}")
        marked = [name for name, one in self.skin.assumptions().items() if one["mark"] == "assumed"]
        said.append(
            f"Assumed, not measured: {', '.join(name.replace('_', ' ') for name in marked)}, damping of the "
            "finger. Values by load sharing; intervals over both models and all plausible parameters. "
            "Simulated."
        )
        return said

    @property
    def drives(self) -> dict[str, float | None]:
        """Amplitude of the drive that gives the reduction asked for on each region."""
        return {name: self.drive_for(self.reduction or 0.0, name) for name in self.regions}

    def drive_text(self, drive: float | None) -> str:
        """A drive as people read it."""
        return "not reached" if drive is None else f"{drive:.3g} {self.unit}"

    def tables(self) -> list[Table]:
        """Every region: amplitudes, reduction, the drive from which on it is noticed; then the demands."""
        felt = Table.of(
            f"below a finger of {self.touch.force:g} N at {self.frequency / 1e3:.2f} kHz and "
            f"{format_quantity(self.drive, self.unit)}, simulated",
            self.by_region,
            "region",
            COLUMNS,
            [number for number, name in enumerate(self.regions) if name in self.driven],
        )
        demands = [(f"{MARKS[one.colour]} {one.colour}", one.what, one.reason) for one in self.requirements]
        return [
            felt,
            Table("does the simulated plate do what it is for?", ("light", "demand", "why"), demands),
        ]

    def facts(self) -> dict[str, Any]:
        return {
            "gap_hz": (self.gap.lower, self.gap.upper) if self.gap else None,
            "drive": {"amplitude": self.drive, "unit": self.unit},
            "driven": self.driven,
            "regions": split(self.by_region, "region"),
            "drive_for": None if self.reduction is None else {"reduction": self.reduction, **self.drives},
            "amplitude_ratio": self.ratio,
            "localised": {name: margin.localised for name, margin in self.margins.items()},
            "stopped": {name: margin.stopped for name, margin in self.margins.items()},
            "quality_factor": determined(self.quality()),
            "quality_factor_without_finger": determined(self.quality("free")),
            "rise_time_s": determined(self.rise),
            "cue_threshold_s": CUE_THRESHOLD,
            "weber_fraction": WEBER_FRACTION,
            "requirements": self.requirements,
        }
