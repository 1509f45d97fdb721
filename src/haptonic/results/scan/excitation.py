"""The drive of a scan and the points that it visits."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from haptonic import plots
from haptonic.plate import Plate
from haptonic.results.scan.question import ScanQuestion
from haptonic.vibrometry.chirp import Drive, drive_notes, write_drive
from haptonic.vibrometry.planning import ScanPlan

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True, eq=False)
class Excitation:
    """One period of a drive, and the plan of a scan.

    plan : None without a plate
    """

    question: ScanQuestion
    drive: Drive
    plate: Plate | None
    plan: ScanPlan | None

    @classmethod
    def of(cls, question: ScanQuestion, plate: Plate | None) -> Excitation:
        """The drive and the plan for a plate, or the drive alone.

        Raises
        ------
        ScanError : settings that do not fit together
        """
        return cls(question, question.drive(plate), plate, None if plate is None else question.plan(plate))

    @staticmethod
    def file_names(plate: Plate | None) -> list[str]:
        """Of all that `files` and `figures` make."""
        names = ["drive.wav", "drive.csv", "drive.h5", "drive.json"]
        pictures = ["signal"] if plate is None else ["signal", "scan-plan"]
        return [*names, *([] if plate is None else ["scan_plan.csv"]),
                *(f"{name}.{kind}" for name in pictures for kind in ("svg", "png"))]  # fmt: skip

    def files(self) -> dict[str, Callable[[Path], object]]:
        """Writers of the files by name; the drive's hold one period."""
        notes = drive_notes(self.drive) | {"averages": self.question.averages}
        found: dict[str, Callable[[Path], object]] = {
            name: partial(write_drive, self.drive) for name in ("drive.wav", "drive.csv", "drive.h5")
        }
        found["drive.json"] = lambda path: path.write_text(json.dumps(notes, indent=1) + "\n", "utf-8")
        if self.plan is not None:
            found["scan_plan.csv"] = self._write_plan
        return found

    def _write_plan(self, path: Path) -> None:
        assert self.plan is not None
        rows = [f"{i},{x:.7g},{y:.7g}" for i, (x, y) in enumerate(self.plan.points, start=1)]
        path.write_text("\n".join(["point,x (m),y (m)", *rows, ""]), "utf-8")

    def figures(self) -> dict[str, Figure]:
        """All pictures, by name."""
        found = {"signal": plots.drive_signal(self.drive)}
        if self.plate is not None and self.plan is not None:
            found["scan-plan"] = plots.plate_plan(self.plate, self.plan.points)
        return found

    def to_json(self) -> dict[str, Any]:
        """Plain values for machines."""
        drive, plan = self.drive, self.plan
        planned = None
        if plan is not None:
            planned = {
                "points": len(plan.points), "left_out": len(plan.left_out), "travel_m": plan.travel,
                "measuring_s": len(plan.points) * self.question.averages * drive.duration,
            }  # fmt: skip
        return drive_notes(drive) | {
            "line_spacing_hz": drive.line_spacing,
            "lines": int(np.rint((drive.band[1] - drive.band[0]) * drive.duration)) + 1,
            "duration_s": drive.duration,
            "averages": self.question.averages,
            "notes": list(drive.warnings),
            "plan": planned,
        }
