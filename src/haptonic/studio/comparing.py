"""Two runs side by side: changed keys of their studies, and differences of their numbers."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from haptonic.errors import StudyError
from haptonic.fields.keys import table
from haptonic.results.comparison import differing_inputs
from haptonic.results.differences import differences
from haptonic.results.table import Table
from haptonic.studio.answers import plain_table, table_of
from haptonic.studio.job import Job
from haptonic.study import Study
from haptonic.study.loading import examined


def compared(first: Job, second: Job, folder: Path) -> dict[str, Any]:
    """Names, sentences, and tables of two runs with answers, in plain values for the page.

    Raises
    ------
    StudyError : a run has no answer
    """
    if first.answer is None or second.answer is None:
        raise StudyError.missing(
            argument="runs", allowed="two runs with a result", cause="one of them failed or was cancelled",
            next_step="compute it again, or choose another run",
        )  # fmt: skip
    studies = [examined(job.order.text, Study, folder)[0] for job in (first, second)]
    before, after = ({} if study is None else study.inputs() for study in studies)
    units = {path: key.unit for path, key in table(Study).items()}
    names = [f"{job.number}. {job.order.analysis}" for job in (first, second)]
    keys = Table("changed keys of the study", ("key", *names), list(differing_inputs(before, after, units)))
    changed = list(differing_inputs(first.order.options, second.order.options, {}))
    chosen = [Table("changed options", ("option", *names), changed)] if changed else []
    numbers = differences(*([table_of(each) for each in job.answer["tables"]] for job in (first, second)))  # type: ignore[index]
    return {
        "runs": [
            {"name": name, "title": job.order.title, "summary": job.answer["summary"]}  # type: ignore[index]
            for name, job in zip(names, (first, second), strict=True)
        ],
        "tables": [plain_table(each) for each in (keys, *chosen, *numbers)],
    }
