"""The drive of a scan, and the order of its points."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from haptonic import plots
from haptonic.analyses.analysis import Analysis
from haptonic.analyses.options import NoOptions
from haptonic.analyses.runner import Runner
from haptonic.analyses.support import no_cell
from haptonic.errors import shown
from haptonic.later import Figure, xarray as xr
from haptonic.plate import Plate
from haptonic.plate.layout.parts import Actuator
from haptonic.plate.layout.sampling import reference_of
from haptonic.results.cost import Cost
from haptonic.results.result import Result, figure, file
from haptonic.results.table import Table
from haptonic.study.schema import Description
from haptonic.units import hz_text
from haptonic.vibrometry.chirp import Drive, drive_notes, write_drive
from haptonic.vibrometry.of_settings import drive_for, plan_for
from haptonic.vibrometry.planning import ScanPlan
from haptonic.vibrometry.settings import ScanSettings

REAL = 1e-9  # imaginary part of a ratio of amplitudes, in shares of it, below which drives are in phase


def _has_plan(result: Excitation) -> bool:
    return result.plan is not None


@dataclass(frozen=True, eq=False, repr=False)
class Excitation(Result):
    """One period of a drive, and the plan of a scan.

    plan : None without a plate
    """

    title = "Excitation"

    settings: ScanSettings
    drive: Drive
    plate: Plate | None
    plan: ScanPlan | None

    @property
    def driven(self) -> str | None:
        """Name of the patch or force that the signal is for; None without a plate."""
        return reference_of(self.plate)[0].name if self.plate else None

    @property
    def dataset(self) -> xr.Dataset:
        """One period of the drive, and the points of the plan in the order of the stage."""
        time = np.arange(len(self.drive.samples)) / self.drive.sample_rate
        dataset = xr.Dataset(
            {"drive": ("time", self.drive.samples, {"units": self.drive.unit})},
            coords={"time": ("time", time, {"units": "s"})},
        )
        if self.plan is None:
            return dataset
        x, y = self.plan.points.T
        return dataset.assign_coords(x=("point", x, {"units": "m"}), y=("point", y, {"units": "m"}))

    @file("drive.wav", "drive.csv", "drive.h5")
    def _write_drive(self, path: Path) -> None:
        write_drive(self.drive, path)

    @file("drive.json")
    def _write_notes(self, path: Path) -> None:
        notes = {"drive": self.driven, **drive_notes(self.drive), "averages": self.settings.averages}
        path.write_text(json.dumps(notes, indent=1) + "\n", "utf-8")

    @file("scan_plan.csv", when=_has_plan)
    def _write_plan(self, path: Path) -> None:
        assert self.plan is not None
        rows = [f"{i},{x:.7g},{y:.7g}" for i, (x, y) in enumerate(self.plan.points, start=1)]
        path.write_text("\n".join(["point,x (m),y (m)", *rows, ""]), "utf-8")

    @figure("signal", "One period of the drive.")
    def _signal(self) -> Figure:
        return plots.drive_signal(self.drive)

    @figure("scan-plan", "The points in the order of the stage.", when=_has_plan)
    def _scan_plan(self) -> Figure:
        assert self.plate is not None
        assert self.plan is not None
        return plots.plate_plan(self.plate, self.plan.points)

    def tables(self) -> list[Table]:
        facts = self.facts()
        plan = facts["plan"]
        rows = [("drive", self.driven)] if self.driven else []
        rows += [
            ("band", hz_text(facts['low'], facts['high'], form='.5g')),
            ("lines", f"{facts['lines']:.0f}, {facts['line_spacing_hz']:.4g} Hz apart"),
            ("period", f"{facts['duration_s'] * 1e3:.4g} ms, {facts['averages']:.0f} recorded at each point"),
            ("sample rate", hz_text(facts['sample_rate'], form='.5g')),
            ("largest value",
             f"{facts['full_scale']:.4g} {facts['unit']}, crest factor {facts['crest_factor']:.3f}"),
        ]  # fmt: skip
        if plan:
            rows += [
                ("points", f"{plan['points']}, {plan['left_out']} left out"),
                ("path", f"{plan['travel_m']:.3g} m, {plan['measuring_s']:.0f} s of recording"),
            ]
        return [Table("excitation", ("what", "value"), rows)]

    def remarks(self) -> list[str]:
        """Sentences on drives that the plate's model has beside the one that plays the signal."""
        return [] if self.plate is None else _not_played(self.plate)

    def facts(self) -> dict[str, Any]:
        drive, plan = self.drive, self.plan
        planned = None
        if plan is not None:
            planned = {
                "points": len(plan.points), "left_out": len(plan.left_out), "travel_m": plan.travel,
                "measuring_s": len(plan.points) * self.settings.averages * drive.duration,
            }  # fmt: skip
        return drive_notes(drive) | {
            "drive": self.driven,
            "line_spacing_hz": drive.line_spacing,
            "lines": int(np.rint((drive.band[1] - drive.band[0]) * drive.duration)) + 1,
            "duration_s": drive.duration,
            "averages": self.settings.averages,
            "notes": list(drive.warnings),
            "plan": planned,
        }


def _not_played(plate: Plate) -> list[str]:
    """Sentence on each drive of the carrier but the first: the model of a scan has their amplitudes."""
    first, *others = (drive for drive in plate.drives if drive.amplitude)
    sentences = []
    for drive in others:
        ratio = drive.amplitude / first.amplitude
        if type(drive) is type(first) and abs(ratio.imag) < REAL * abs(ratio):
            inverted = " and inverted" if ratio.real < 0 else ""
            advice = f"drive it by the same signal, {abs(ratio):.4g} times as large{inverted}"
        else:
            off = 'voltage = "0 V"' if isinstance(drive, Actuator) else 'force = "0 N"'
            advice = f"no amplifier makes its share from this signal, so write {off} in the study of the scan"
        sentences.append(
            f"the signal is for {shown(first.name)} alone, and the model of the scan also drives "
            f"{shown(drive.name)}: {advice}"
        )
    return sentences


def compute(study: Description, options: NoOptions, runner: Runner) -> Excitation:
    """One period of the drive; for a study with a plate also the plan of the scan.

    Raises
    ------
    ScanError : settings that contradict each other
    """
    settings = study.scan_settings
    plate = study.mounted_plate() if study.plate_settings else None
    plan = None if plate is None else plan_for(settings, plate)
    return Excitation(settings, drive_for(settings, plate), plate, plan)


ANALYSIS = Analysis(
    name="chirp",
    result=Excitation,
    compute=compute,
    supports=no_cell,
    cost=lambda study, options: Cost(2.0),  # files and pictures of a drive
)
