"""Runs of the command line in the archive of the studio, for its list of runs."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from haptonic.analyses.analysis import Analysis
from haptonic.results.result import Result
from haptonic.store import Store
from haptonic.studio.answers import answer_of
from haptonic.studio.archive import Archive
from haptonic.studio.job import Job
from haptonic.studio.offers import is_offered
from haptonic.studio.worker import Order
from haptonic.study.schema import Description


def record(
    analysis: Analysis,
    study: Description,
    text: str,
    file: Path,
    options: Mapping[str, Any],
    result: Result,
    started: float,
    files: Path | None,
) -> None:
    """Add a finished run to the archive of the folder of its study.

    Analyses that the studio does not offer are left out.

    Parameters
    ----------
    text : of the study, in its file; options : by name; started : time of its begin
    files : folder with its pictures; None if none was written

    Raises
    ------
    ResourceError : the archive cannot be written
    """
    if not is_offered(analysis):
        return
    file = file.resolve()
    archive = Archive(file.parent, Store.default())
    order = Order(
        number=max(archive.briefs, default=0) + 1, text=text, folder=file.parent, file=file.name,
        analysis=analysis.name, options=dict(options), title=study.title,
    )  # fmt: skip
    job = Job.ordered(order)
    job.answer, job.view = answer_of(result)
    for name in result.figures if files else ():
        picture = files / f"{name}.svg" if files else None
        if picture is not None and picture.is_file():
            job.pictures[name] = picture.read_bytes()
    job.started, job.by_command, job.drawn = started, True, True
    job.finish("done")
    archive.keep(job)
