"""Simulated scan of a computed plate, with known truth."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import asdict, dataclass, replace
from functools import partial
from pathlib import Path, PurePosixPath
from typing import Any, Literal

from haptonic.bloch import Gap
from haptonic.errors import HaptonicError, ScanError
from haptonic.later import xarray as xr
from haptonic.names import counted, listed
from haptonic.plate import Plate
from haptonic.plate.layout.sampling import driven_region
from haptonic.plate.vibration.region_measures import contrasts
from haptonic.response import FrequencyResponse, write
from haptonic.results.common import Writer
from haptonic.results.result import Result
from haptonic.units import hz_text
from haptonic.vibrometry import TimeScan, write_records, write_uff, write_uff_records
from haptonic.vibrometry.chirp import Drive
from haptonic.vibrometry.exports import csv_files, write_mat, write_mat_records, write_tdms
from haptonic.vibrometry.on_plate import contrast_range
from haptonic.vibrometry.readers.folder import GEOMETRY
from haptonic.vibrometry.settings import ScanSettings

Kind = Literal["time", "frf"]

STAGE = (12e-3, 7e-3)  # m, corner of the plate in the coordinates of the stage
TIME: dict[str, Callable[[TimeScan, Path], None]] = {
    "h5": write_records, "uff": write_uff_records, "mat": write_mat_records, "tdms": write_tdms,
}  # fmt: skip
FRF: dict[str, Callable[[FrequencyResponse, Path], None]] = {
    "nc": write, "uff": write_uff, "mat": write_mat,
}  # fmt: skip
RESPONSES = (*FRF, "csv")
CONTENTS: dict[Kind, str] = {"time": "time records", "frf": "responses"}
FORMATS = ("h5", "nc", "uff", "mat", "csv", "tdms")

FOLDER = PurePosixPath("scan")  # folder of a scan with one file per point


@dataclass(frozen=True, eq=False, repr=False)
class SimulatedScan(Result):
    """A simulated scan.

    true : the plate's response at the points of the plan, in the order of the stage, on the plate
    records : records of the instrument, in the coordinates of the stage
    form : format of the file; kind : time records or responses
    estimated : responses that the instrument estimates itself, if these are written
    """

    title = "Simulated scan"

    plate: Plate
    settings: ScanSettings
    signal: Drive
    gap: Gap | None
    true: FrequencyResponse
    records: TimeScan
    seed: int
    form: str = "h5"
    kind: Kind = "time"
    estimated: FrequencyResponse | None = None

    @property
    def dataset(self) -> xr.Dataset:
        """The true response."""
        return self.true.dataset

    @classmethod
    def names(cls, options: Any = None) -> list[Any]:
        form = "h5" if options is None else options.form
        return [scan_name(form), "truth.json"]

    @property
    def files(self) -> dict[Any, Writer]:
        """Writers of the files by name."""
        text = json.dumps(self.truth(), indent=1) + "\n"
        truth: dict[Any, Writer] = {"truth.json": lambda path: path.write_text(text, "utf-8")}
        if self.kind == "time":
            return {f"scan.{self.form}": partial(TIME[self.form], self.records)} | truth
        assert self.estimated is not None
        if self.form == "csv":
            return {FOLDER / name: writer for name, writer in csv_files(self.estimated).items()} | truth
        return {f"scan.{self.form}": partial(FRF[self.form], self.estimated)} | truth

    def summary(self) -> list[str]:
        records, content = self.records, "records" if self.kind == "time" else "responses"
        return [
            f"{counted(len(records.names), 'point')}, {counted(records.repeats, 'period')} of "
            f"{records.samples} samples at {hz_text(records.sample_rate, form='g')}, written as {content}. "
            "Simulated."
        ]

    def facts(self) -> dict[str, Any]:
        truth = self.truth()
        return {
            "origin": "simulated", "kind": self.kind, "points": truth["points"],
            **{name: truth[name] for name in ("contrast_range", "computed_gap_hz")}, "seed": self.seed,
        }  # fmt: skip

    def located(self, folder: Path) -> dict[str, Any]:
        return {"files": [str(folder / name) for name in self.names(self)]}

    def truth(self) -> dict[str, Any]:
        """True values, which an analysis of the files should reproduce."""
        try:
            stands_out = asdict(contrast_range(self.true, self.plate))
        except HaptonicError as error:
            stands_out = {"none": error.given}
        levels = contrasts(self.true, driven_region(self.plate))
        instrument = asdict(
            replace(
                self.settings.instrument,
                full_scale=self.records.response_scale * (self.records.full_scale or 1),
            )
        )
        return {
            "origin": "simulated",
            "seed": self.seed,
            "contrast_range": stands_out,
            "computed_gap_hz": self.gap.edges if self.gap else None,
            "frequency_hz": self.true.frequency.tolist(),
            "contrast_db": {name: level.values.tolist() for name, level in levels.items()},
            "points": len(self.true.points),
            "stage_m": list(STAGE),
            "instrument": instrument,
            "loss_factor": self.plate.loss_factor,
            "inputs": json.loads(self.true.dataset.attrs["inputs"]),
        }


def kind_of(form: str, kind: Kind | None) -> Kind:
    """Content of a format: the given kind, by default time records if possible.

    Raises
    ------
    ScanError : a format without this kind
    """
    have: list[Kind] = [name for name, forms in (("time", TIME), ("frf", RESPONSES)) if form in forms]  # type: ignore[misc]
    if kind is None:
        return have[0]
    if kind not in have:
        other = [name for name in FORMATS if name in (TIME if kind == "time" else RESPONSES)]
        raise ScanError.conflict(
            argument="--format",
            given=f"{form}, for {CONTENTS[kind]}",
            allowed=f"for {CONTENTS[kind]}: {listed(other, 'or')}",
            cause=f"files of this format contain {CONTENTS[have[0]]}",
            next_step="choose another format, or leave out the choice between records and responses",
        )
    return kind


def scan_name(form: str) -> str | PurePosixPath:
    """Name of the file of a simulated scan, or of a file in its folder."""
    return FOLDER / GEOMETRY if form == "csv" else f"scan.{form}"
