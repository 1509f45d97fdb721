"""The worker process: it computes one order after another and reports on a connection.

A message is a kind, the number of the order, and a content: "begun"; "cost" with a sentence; "progress" with
the steps done and planned and the name of the current one; "point" with a computed design; "done" with answer
and view; "picture" with name and SVG; "file" with name and content of an export; "failed" with the parts of
an error; "idle" at the end.
"""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
import traceback
import warnings
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

from haptonic.analyses.points import ComputedPoint
from haptonic.analyses.runner import Runner
from haptonic.errors import HaptonicError, HaptonicWarning, ResourceError
from haptonic.later import leave_out
from haptonic.studio.answers import answer_of, pictures_of
from haptonic.studio.files import Export, file_of
from haptonic.studio.offers import offered
from haptonic.study import Study
from haptonic.study.loading import examined


@dataclass(frozen=True)
class Order:
    """An analysis to compute.

    number : of the job
    text : of the study; title : in it; folder : of its file, which may have no such name yet
    analysis : name of an offered analysis
    export : file to make of the result, instead of an answer for the page
    """

    number: int
    text: str
    folder: Path
    file: str
    analysis: str
    options: Mapping[str, Any]
    title: str = ""
    export: Export | None = None


def serve(connection: Connection) -> None:
    """Compute orders until the other end closes, or its process ends."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the server handles Ctrl-C and ends this process
    leave_out()
    threading.Thread(target=_end_with_parent, daemon=True).start()
    while True:
        try:
            order = connection.recv()
        except EOFError:
            return
        connection.send(("begun", order.number, None))
        try:
            _compute(order, connection)
        except HaptonicError as error:
            connection.send(("failed", order.number, error.parts()))
        except Exception as error:  # noqa: BLE001  a fault of the program must not end in silence
            traceback.print_exc()
            connection.send(("failed", order.number, _unexpected(error).parts()))
        connection.send(("idle", order.number, None))


def _compute(order: Order, connection: Connection) -> None:
    study, _, problems = examined(order.text, Study, order.folder)
    if study is None:
        raise problems[0]
    analysis = offered(order.analysis)
    if order.export is None and analysis.cost is not None:
        cost = analysis.cost(study, analysis.chosen(order.options))
        connection.send(("cost", order.number, cost.sentence))

    def progress(done: int, planned: int, what: str = "", /) -> None:
        connection.send(("progress", order.number, (done, planned, what)))

    def report(point: ComputedPoint, /) -> None:
        connection.send(("point", order.number, asdict(point)))

    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", HaptonicWarning)
        runner = Runner(progress=progress, about=order.folder / order.file, report=report)
        result = analysis.run(study, runner, order.options)
    if order.export is not None:
        connection.send(("file", order.number, file_of(result, order.export, analysis.method)))
        return
    answer, view = answer_of(result)
    words = [str(each.message) for each in caught if issubclass(each.category, HaptonicWarning)]
    answer["remarks"] = list(dict.fromkeys([*answer["remarks"], *words]))
    connection.send(("done", order.number, (answer, view)))
    for picture in pictures_of(result):
        connection.send(("picture", order.number, picture))
        if connection.poll():  # the next order is more urgent than pictures of this one
            return


def _unexpected(error: Exception) -> HaptonicError:
    return ResourceError.worker(
        argument="analysis",
        given=f"{type(error).__name__}: {error}"[:300],
        allowed="an answer, or an error that names its cause",
        cause="a fault of the program",
        next_step="report the fault with the study; the terminal of the studio has the details",
    )


def _end_with_parent() -> None:
    """End this process when the server has ended in any way."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)
