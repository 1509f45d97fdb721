"""Friction under a finger on a vibrating plate: at every place, by region, and the drive it needs."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from haptonic.arrays import Bools
from haptonic.friction.lubrication.law import ENDS, FrictionLaw
from haptonic.friction.lubrication.parameters import Fingertip, Touch
from haptonic.friction.lubrication.perception import Margin, rise_time, time_constant
from haptonic.later import xarray as xr
from haptonic.response import Reference
from haptonic.units import share_text

CURVE = 41  # drives in the curve of reduction against drive
BEYOND = 2.0  # times the drive: where that curve ends


@dataclass(frozen=True)
class Reduction:
    """A reduction of friction, 0.55 for 55 %, with the ends of its interval."""

    value: float
    low: float
    high: float

    def __str__(self) -> str:
        return share_text(self.value, self.low, self.high)


@dataclass(frozen=True, eq=False)
class FrictionOnPlate:
    """Friction under a finger on a plate, relative to that without vibration.

    loaded : vibration below a finger with its middle at each point, see `haptonic.plate.vibration.touch`
    below : by region, (point,) places at which the whole finger lies on the region
    driven : the regions with a drive; the reference is the drive of the first
    touch : frequency, force and speed
    skin : parameters of the friction models
    drive : amplitude of the first drive, V or N
    """

    loaded: xr.Dataset
    below: Mapping[str, Bools]
    driven: tuple[str, ...]
    touch: Touch
    skin: Fingertip
    drive: float

    @property
    def frequency(self) -> float:
        """Drive frequency, Hz."""
        return float(self.loaded.attrs["frequency_hz"])

    @property
    def unit(self) -> str:
        """Unit of the drive, V or N."""
        return Reference.parse(str(self.loaded.attrs["reference"])).unit

    @property
    def regions(self) -> tuple[str, ...]:
        """Regions of plain plate."""
        return tuple(self.below)

    @cached_property
    def law(self) -> FrictionLaw:
        """mu / mu0 against amplitude."""
        return FrictionLaw.of(self.touch, self.skin)

    def at_points(self, drive: float | None = None) -> xr.Dataset:
        """``value`` (point,) mu / mu0; ``low``, ``high``: interval over both models, skin and damping."""
        drive = self.drive if drive is None else drive
        moved = self.loaded["amplitude"] * drive
        return xr.Dataset(  # the least friction is with the least damping
            {end: ("point", self.law.at(moved.sel(load=end).values, end)) for end in ENDS}
            | {"amplitude": moved.sel(load="value", drop=True)},
            attrs={"origin": "simulated", "drive": f"{drive:g} {self.unit}"},
        )

    def reductions(self, drive: float | None = None) -> dict[str, Reduction]:
        """Mean reduction over the places of every region."""
        friction = self.at_points(drive)
        return {
            name: Reduction(
                *(1 - float(friction[end].values[places].mean()) for end in ("value", "high", "low"))
            )
            for name, places in self.below.items()
        }

    def drive_for(self, reduction: float, region: str) -> float | None:
        """Drive amplitude, V or N, for a mean reduction on a region; see `FrictionLaw`."""
        per_unit = self.loaded["amplitude"].sel(load="value").values[self.below[region]]
        return self.law.drive_for(reduction, per_unit, self.drive)

    def amplitude(self, region: str, load: str = "value") -> float:
        """Mean amplitude below a finger on a region, m."""
        return self.drive * float(self.loaded["amplitude"].sel(load=load).values[self.below[region]].mean())

    def quality(self, load: str = "value") -> float:
        """Median quality factor of the dominant mode, with a finger on the first driven region.

        NaN if no mode is near the frequency; then `rise` and `constant` are NaN too.
        """
        where = self.below[self.driven[0]] if self.driven else np.ones(self.loaded.sizes["point"], dtype=bool)
        return float(np.median(self.loaded["quality"].sel(load=load).values[where]))

    @property
    def rise(self) -> float:
        """Rise time (10 to 90 %) of the vibration with a finger on the driven region, s."""
        quality = self.quality()
        return rise_time(quality, self.frequency) if math.isfinite(quality) else math.nan

    @property
    def constant(self) -> float:
        """Time constant of the vibration with a finger on the driven region, s."""
        quality = self.quality()
        return time_constant(quality, self.frequency) if math.isfinite(quality) else math.nan

    @property
    def ratio(self) -> dict[str, float]:
        """Amplitude below a finger on the first driven region over that on every region without a drive."""
        if not self.driven:
            return {}
        most = self.amplitude(self.driven[0])
        return {name: most / self.amplitude(name) for name in self.regions if name not in self.driven}

    @property
    def margins(self) -> dict[str, Margin]:
        """Perception margins of the first driven region, for every region without a drive."""
        if not self.driven:
            return {}
        reductions = self.reductions()
        return {
            name: Margin(reductions[self.driven[0]].value, reductions[name].value)
            for name in self.regions if name not in self.driven
        }  # fmt: skip

    @property
    def curve(self) -> xr.Dataset:
        """``value``, ``low`` and ``high`` (region, drive): reduction against the amplitude of the drive."""
        drives = np.linspace(0, BEYOND * self.drive, CURVE)
        reductions = [self.reductions(float(drive)) for drive in drives]
        dims = ("region", "drive")
        return xr.Dataset(
            {
                end: (
                    dims,
                    np.array(
                        [[getattr(by_region[name], end) for by_region in reductions] for name in self.regions]
                    ),
                )
                for end in ENDS
            },
            coords={"region": list(self.regions), "drive": ("drive", drives, {"units": self.unit})},
        )
