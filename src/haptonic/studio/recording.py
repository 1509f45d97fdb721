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
from haptonic.studio.worker import Order
from haptonic.study.loading import text_of
from haptonic.study.schema import Description


@dataclass(frozen=True)
class CommandRun:
    """A run of the command line that begins.

    text : of the study, as it is then; file : its path; started : time
    """

    analysis: Analysis
    study: Description
    text: str
    file: Path
    started: float

    @classmethod
    def begun(cls, analysis: Analysis, study: Description | None, file: Path | None) -> Self | None:
        """Note the beginning; None for an analysis that the studio does not offer."""
        if study is None or file is None or not is_offered(analysis):
            return None
        return cls(
            analysis=analysis, study=study, text=text_of(file), file=file.resolve(), started=time.time()
        )

    def keep(self, options: Any, result: Result, files: Path | None) -> None:
        """Add the finished run to the archive of the folder of its study.

        Parameters
        ----------
        options : of the analysis; files : folder with its pictures, None if none was written

        Raises
        ------
        ResourceError : the archive cannot be written
        """
        archive = Archive(self.file.parent, Store.default())
        order = Order(
            number=max(archive.briefs, default=0) + 1, text=self.text, folder=self.file.parent,
            file=self.file.name, analysis=self.analysis.name, title=self.study.title,
            options={field.name: getattr(options, field.name) for field in fields(options)},
        )  # fmt: skip
        job = Job.ordered(order)
        job.answer, job.view = answer_of(result)
        for name in result.figures if files else ():
            picture = files / f"{name}.svg" if files else None
            if picture is not None and picture.is_file():
                job.pictures[name] = picture.read_bytes()
        job.started, job.by_command, job.drawn = self.started, True, True
        job.finish("done")
        archive.keep(job)
