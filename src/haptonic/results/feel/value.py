"""Friction under a finger on a plate: a map, reductions by region, the required drive, the rise time."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from haptonic import plots
from haptonic.bloch import Gap
from haptonic.bloch.gaps import common_gap
from haptonic.friction.lubrication import CUE_THRESHOLD, WEBER_FRACTION
from haptonic.friction.lubrication.on_plate import FrictionOnPlate
from haptonic.friction.lubrication.settings import Pad
from haptonic.friction.phrases import change
from haptonic.gate import declared
from haptonic.later import Axes, Figure, xarray as xr
from haptonic.names import listed
from haptonic.plate import Plate
from haptonic.results.feel.interactive import feel_view
from haptonic.results.feel.requirements import Requirement, drive_in_gap, requirements
from haptonic.results.plain import determined, split
from haptonic.results.result import Result, figure, page
from haptonic.results.table import Column, Table
from haptonic.units import format_quantity, hz_text, in_percent
from haptonic.views import InteractiveView

MARKS = {"green": "●", "amber": "▲", "red": "■"}  # readable without colours
COLUMNS = (
    Column("region"),
    Column("mean amplitude", shown="µm", form=".3g", of="amplitude"),
    Column("without finger", shown="µm", form=".3g", of="amplitude_without_finger"),
    Column("reduction", shown="%", form=".0f", ends=("low", "high")),
    Column("noticed from", form=".3g", of="drive_to_be_felt"),
)


@dataclass(frozen=True, eq=False, repr=False)
class Feel(Result):
    """Friction under a finger on a plate, and the requirements of the plate.

    plate : the vibrating plate
    gaps : around the frequency, of each lattice beside the driven regions, None for a lattice without one
    friction : relative to that without vibration; reduction : target for which the drive is computed, if any
    pad : load of the finger on the plate; interactive : whether the interactive page is among its files
    """

    title = "Friction under a finger"
    data_file = "feel"

    plate: Plate
    gaps: Mapping[str, Gap | None]
    friction: FrictionOnPlate
    reduction: float | None = None
    pad: Pad = field(default_factory=Pad)
    interactive: bool = False

    @cached_property
    def by_region(self) -> xr.Dataset:
        """(region) ``reduction`` with its ends ``low`` and ``high``, mean ``amplitude`` below the finger and
        without it, and the smallest drive that people notice."""
        friction, regions, reductions = self.friction, self.friction.regions, self.friction.reductions()
        variables = {
            "reduction": ("1", [reductions[name].value for name in regions]),
            "low": ("1", [reductions[name].low for name in regions]),
            "high": ("1", [reductions[name].high for name in regions]),
            "amplitude": ("m", [friction.amplitude(name) for name in regions]),
            "amplitude_without_finger": ("m", [friction.amplitude(name, "free") for name in regions]),
            "drive_to_be_felt": (
                friction.unit, [friction.drive_for(WEBER_FRACTION, name) or np.nan for name in regions]
            ),
        }  # fmt: skip
        data = xr.Dataset(
            {name: ("region", numbers, {"units": u}) for name, (u, numbers) in variables.items()}
        )
        declared(data, drive_to_be_felt="no drive makes it noticeable")
        return data.assign_coords(region=np.array(regions, dtype=str))

    @property
    def requirements(self) -> list[Requirement]:
        """Requirements of the plate, each with a colour and its reason."""
        friction = self.friction
        return requirements(
            friction.reductions(),
            friction.driven,
            friction.rise,
            friction.constant,
            drive_in_gap(friction.frequency, self.gap, self._without_gap),
        )

    @property
    def gap(self) -> Gap | None:
        """The gap around the frequency that the lattices beside the driven regions share, if any."""
        return common_gap(self.gaps.values())

    @property
    def _without_gap(self) -> list[str]:
        """Lattices without a gap around the frequency, if others have one."""
        without = [name for name, gap in self.gaps.items() if gap is None]
        return without if len(without) < len(self.gaps) else []

    @property
    def at_drive(self) -> str:
        """Frequency and amplitude of the drive."""
        return f"{self._frequency} and {self._drive}"

    @property
    def _frequency(self) -> str:
        return hz_text(self.friction.frequency, form=".2f")

    @property
    def _drive(self) -> str:
        first, *others = self._driving
        amplitude = format_quantity(self.friction.drive, self.friction.unit)
        return f"{amplitude} at {first}" if others else amplitude

    @property
    def _driving(self) -> list[str]:
        """Names of the drives that move the plate, the reference first."""
        return [drive.name for drive in self.plate.drives if drive.amplitude]

    @cached_property
    def dataset(self) -> xr.Dataset:
        """Friction and amplitudes at every point, with the assumptions."""
        friction = self.friction
        data = friction.at_points()
        quality = friction.loaded["quality"].sel(load="value", drop=True)
        described = {
            "value": "mu / mu0, load sharing",
            "low": "lower end of the band",
            "high": "upper end of the band",
        }
        for name, words in described.items():
            data[name].attrs = {"units": "1", "long_name": words}
        data["amplitude"].attrs = {"units": "m", "long_name": "rms below the finger, peak in time"}
        data["quality"] = quality
        data.attrs |= dict(friction.loaded.attrs) | {
            "touch": json.dumps({"force_n": friction.touch.force, "speed_m_s": friction.touch.speed}),
            "assumptions": json.dumps(friction.skin.assumptions()),
        }
        return data

    @figure(
        "friction",
        "Simulated reduction of friction below a finger centred at each point; on the right the ends of the "
        "interval over two models and all plausible parameters.",
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

    _page = page("feel.html")

    def view(self) -> InteractiveView | None:
        """Interactive view of the finger; None if it was not asked for."""
        return feel_view(self) if self.interactive else None

    def summary(self) -> list[str]:
        driven, reductions = self.friction.driven, self.friction.reductions()
        felt = "; ".join(
            f"{name}{' (driven)' if name in driven else ''}: {change(r.value, r.low, r.high)}"
            for name, r in reductions.items()
        )
        sentences = [f"At {self.at_drive}, {felt}."]
        first, *others = self._driving
        if others:
            keep = "keeps its" if len(others) == 1 else "keep their"
            sentences.append(f"For other amplitudes of {first}, {listed(others)} {keep} ratio to it.")
        if self.reduction is not None:
            drives = "; ".join(f"{name}: {self.drive_text(v)}" for name, v in self.drives.items())
            sentences.append(f"Drive for a reduction of {in_percent(self.reduction)}: {drives}")
        if flat := self.friction.law.pressed_flat:
            sentences.append(
                f"A force of {self.friction.touch.force:g} N presses {in_percent(flat)} of the plausible "
                "skins flat, without a film of air; the intervals are without them."
            )
        assumptions = self.friction.skin.assumptions()
        assumed = [name for name, assumption in assumptions.items() if assumption["mark"] == "assumed"]
        sentences.append(
            f"Assumed, not measured: {', '.join(name.replace('_', ' ') for name in assumed)}, damping of the "
            "finger. Values from the load-sharing model; intervals over both models and all plausible "
            "parameters. Simulated."
        )
        return sentences

    @property
    def drives(self) -> dict[str, float | None]:
        """Amplitude of the drive for the target reduction on each region; None if it is not reached."""
        return {name: self.friction.drive_for(self.reduction or 0.0, name) for name in self.friction.regions}

    def drive_text(self, drive: float | None) -> str:
        """A drive as text."""
        return "not reached" if drive is None else f"{drive:.3g} {self.friction.unit}"

    def tables(self) -> list[Table]:
        """Table of the regions with amplitudes, reduction and noticeable drive; table of the requirements."""
        touched = Table.of(
            f"below a finger of {self.friction.touch.force:g} N at {self.at_drive}, simulated",
            self.by_region,
            "region",
            COLUMNS,
            [number for number, name in enumerate(self.friction.regions) if name in self.friction.driven],
        )
        demands = [(f"{MARKS[r.colour]} {r.colour}", r.what, r.reason) for r in self.requirements]
        return [
            touched,
            Table("requirements of the simulated plate", ("light", "requirement", "reason"), demands),
        ]

    def facts(self) -> dict[str, Any]:
        friction = self.friction
        return {
            "gap_hz": self.gap.edges if self.gap else None,
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
