"""Runs of the command line in the archive of the studio, for its list of runs."""

from __future__ import annotations

import time
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, Self

from haptonic.analyses.analysis import Analysis
from haptonic.results.result import Result
from haptonic.store import Store
from haptonic.studio.answers import answer_of
from haptonic.studio.archive import Archive
from haptonic.studio.job import Job
from haptonic.studio.offers import is_offered
from haptonic.studio.order import Order
from haptonic.study.schema import Description
from haptonic.study.text_file import text_of


@dataclass(frozen=True)
class CommandRun:
    """A run of the command line that begins.

    text, title : of the study, as it is then; file : its path; started : time
    """

    analysis: Analysis
    options: dict[str, Any]
    title: str
    text: str
    file: Path
    started: float

    @classmethod
    def begun(
        cls, analysis: Analysis, study: Description | None, file: Path | None, options: Any
    ) -> Self | None:
        """Note the beginning; None for a run that the studio could not repeat from the study alone."""
        values = {field.name: getattr(options, field.name) for field in fields(options)}
        alone = all(value is None or isinstance(value, bool | int | float | str) for value in values.values())
        if study is None or file is None or not alone or not is_offered(analysis):
            return None
        return cls(
            analysis=analysis, options=values, title=study.title, text=text_of(file), file=file.resolve(),
            started=time.time(),
        )  # fmt: skip

    def keep(self, result: Result) -> None:
        """Add the finished run to the archive of the folder of its study.

        Raises
        ------
        ResourceError : the archive cannot be written
        """
        archive = Archive(self.file.parent, Store.default())
        order = Order(
            number=max(archive.briefs, default=0) + 1, text=self.text, folder=self.file.parent,
            file=self.file.name, analysis=self.analysis.name, title=self.title, options=self.options,
        )  # fmt: skip
        job = Job.ordered(order)
        job.answer, job.view = answer_of(result)
        job.started, job.by_command = self.started, True
        job.finish("done")
        archive.keep(job)
