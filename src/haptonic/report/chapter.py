"""What a report is made from, and what a chapter of it is."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime
from typing import TYPE_CHECKING

import xarray as xr

from haptonic.bloch import Gap
from haptonic.friction.statistics import Alarms
from haptonic.results import Feel, FrictionResult, Guides, Layers, PlateResult
from haptonic.results.scan import ScanResult
from haptonic.study import Study

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True, eq=False)
class Results:
    """All that a run gave.

    study : what was asked
    bands : from `haptonic.bloch.bands_dataset`
    sweeps : one dataset for each of the study's sweeps that was computed; may be empty
    layers, guides : what was asked of the lattice as a mirror, if it was computed
    plate : how the finite plate vibrates, if it was computed
    scan : of a twin of the instrument on that plate, if it was made up
    feel : what a finger feels of the plate, if it was computed
    trials : of made-up people on that plate, if they were made up
    alarms : how often each test finds a difference in such trials where the population has none, by its name
    guide_shifts : from `haptonic.report.guide_shifts`, if the plate is the paper's
    filleted : the gap of the same cell with a fillet of the radius that `paper` names, if it was computed
    timings : seconds that each part of the run took, by name
    started : when the run began, with its time zone
    """

    study: Study
    bands: xr.Dataset
    sweeps: tuple[xr.Dataset, ...] = ()
    layers: Layers | None = None
    guides: Guides | None = None
    plate: PlateResult | None = None
    scan: ScanResult | None = None
    feel: Feel | None = None
    trials: FrictionResult | None = None
    alarms: Mapping[str, Alarms] = field(default_factory=dict)
    guide_shifts: xr.Dataset | None = None
    filleted: Gap | None = None
    timings: Mapping[str, float] = field(default_factory=dict)
    started: datetime | None = None


@dataclass(frozen=True, eq=False)
class Picture:
    """A figure with the sentence below it and the words that stand for it where it cannot be seen."""

    figure: Figure
    caption: str
    alternative: str


@dataclass(frozen=True)
class Table:
    """Rows of text below a head; ``caption`` says what they are. The first column names the row."""

    caption: str
    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]

    def __post_init__(self) -> None:
        assert all(len(row) == len(self.head) for row in self.rows), self.caption


@dataclass(frozen=True, eq=False)
class Chapter:
    """One part of the report; ``identifier`` is its anchor in the page."""

    title: str
    identifier: str
    paragraphs: tuple[str, ...] = ()
    findings: tuple[str, ...] = ()
    pictures: tuple[Picture, ...] = ()
    tables: tuple[Table, ...] = ()


@dataclass(frozen=True)
class Absent:
    """A chapter that could not be written, and why."""

    title: str
    reason: str
