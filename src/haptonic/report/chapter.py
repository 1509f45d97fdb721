"""Input of a report, and the parts of a chapter."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime
from functools import cached_property
from typing import Self, TypeVar

from haptonic.friction.statistics import Alarms
from haptonic.later import xarray as xr
from haptonic.pages import Picture
from haptonic.report.against import ComparedValue, compared
from haptonic.report.derived import derived, inputs_of
from haptonic.results.references import References, Variant
from haptonic.results.result import Result
from haptonic.results.sweeps import Sweeps
from haptonic.results.table import Table
from haptonic.study.schema import Description
from haptonic.views import InteractiveView

R = TypeVar("R", bound=Result)


@dataclass(frozen=True, eq=False)
class Results:
    """Results of a run.

    study : the description
    parts : the results by the names of their analyses; the bands are always there
    alarms : false-alarm rate of each test in such trials, by its name
    references : published values, if the example of the study has them
    variants : values of the study with one thing changed; None where there is none
    timings : seconds that each part of the run took, by name
    started : when the run began, with its time zone
    """

    study: Description
    parts: Mapping[str, Result]
    alarms: Mapping[str, Alarms] = field(default_factory=dict)
    references: References | None = None
    variants: tuple[tuple[Variant, float | None], ...] = ()
    timings: Mapping[str, float] = field(default_factory=dict)
    started: datetime | None = None

    @property
    def bands(self) -> xr.Dataset:
        """From `haptonic.bloch.bands_dataset`."""
        return self.parts["bands"].dataset

    @property
    def sweeps(self) -> tuple[xr.Dataset, ...]:
        """One for each of the study's sweeps that was computed."""
        sweeps = self.of(Sweeps)
        return tuple(row.dataset for row in sweeps.rows) if sweeps else ()

    @cached_property
    def comparisons(self) -> list[ComparedValue]:
        """A row for every published value; none without references."""
        if self.references is None:
            return []
        answers = {name: result.to_json() for name, result in self.parts.items()}
        answers |= {"study": inputs_of(self.study), "derived": derived(self.study, answers)}
        return compared(self.references, answers)

    def of(self, kind: type[R]) -> R | None:
        """The result of a kind, if it was computed."""
        return next((result for result in self.parts.values() if isinstance(result, kind)), None)

    def where(self, picture: str) -> str:
        """Figures of the references that correspond to a picture, for the sentence below it."""
        return self.references.where(picture) if self.references else ""

    def pictures(self, result: Result, words: Mapping[str, str]) -> tuple[Picture, ...]:
        """Return pictures of a result; captions name the corresponding figures of the references.

        Parameters
        ----------
        words : alternative texts by the name of each picture; other pictures are left out
        """
        figures = result.figures
        return tuple(
            Picture(figures[name], figures.captions[name] + self.where(name), words[name], name)
            for name in figures if name in words
        )  # fmt: skip


class Finding(str):
    """A sentence, and the name of the picture of its chapter that shows it."""

    picture: str

    def __new__(cls, text: str, picture: str) -> Self:
        """Make a finding."""
        finding = super().__new__(cls, text)
        finding.picture = picture
        return finding


@dataclass(frozen=True, eq=False)
class Chapter:
    """One part of the report.

    identifier : its anchor in the page
    views : interactive views by the words of the button that opens each
    """

    title: str
    identifier: str
    paragraphs: tuple[str, ...] = ()
    findings: tuple[str, ...] = ()
    pictures: tuple[Picture, ...] = ()
    tables: tuple[Table, ...] = ()
    views: Mapping[str, InteractiveView | None] = field(default_factory=dict)

    @property
    def opened(self) -> dict[str, tuple[str, InteractiveView]]:
        """Words and view of each button, by the name of its place in the page."""
        there = [(words, view) for words, view in self.views.items() if view is not None]
        return {f"view-{self.identifier}-{number}": pair for number, pair in enumerate(there)}

    def shown(self, finding: str) -> Picture | None:
        """Return the picture that shows a finding, if any."""
        name = finding.picture if isinstance(finding, Finding) else ""
        return next((picture for picture in self.pictures if name and picture.name == name), None)


@dataclass(frozen=True)
class Absent:
    """A chapter that could not be written, and why."""

    title: str
    reason: str


__all__ = ["Absent", "Chapter", "Finding", "Picture", "Results", "Table"]
