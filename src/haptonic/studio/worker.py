"""The worker process: it computes one order after another and reports on a connection.

A message is a kind, the number of the order, and a content: "begun"; "cost" with a sentence; "progress" with
the steps done and planned and the name of the current one; "point" with a computed design; "first" with the
part of a view that is computed first; "done" with answer and view; "understood" with answer and view of what
was read; "knobs" with the numbers that can be turned; "preview" with the path of one of them and a view;
"picture" with name and SVG; "file" with name and content of an export; "failed" with the parts of an error;
"idle" after the last picture.

After an answer the worker prepares previews, and draws pictures, one after the other. An order goes first.
"""

from __future__ import annotations

import _thread
import multiprocessing
import os
import signal
import threading
import traceback
import warnings
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from multiprocessing.connection import Connection
from pathlib import Path
from queue import SimpleQueue
from types import FrameType
from typing import Any

from haptonic.analyses.analysis import Analysis
from haptonic.analyses.points import ComputedPoint
from haptonic.analyses.runner import Runner
from haptonic.errors import HaptonicError, HaptonicWarning, ResourceError
from haptonic.later import leave_out, xarray as xr
from haptonic.results.result import Result
from haptonic.studio.answers import answer_of, packed_part, pictures_of
from haptonic.studio.editing import steps_of
from haptonic.studio.files import Export, file_of
from haptonic.studio.offers import offered, with_paths
from haptonic.studio.workspace import Workspace
from haptonic.study import Study
from haptonic.study.loading import examined

Send = Callable[..., None]  # kind and content of a message


@dataclass(frozen=True)
class Order:
    """An analysis to compute.

    number : of the job
    text : of the study; title : in it; folder : of its file, which may have no such name yet
    analysis : name of an offered analysis
    export : file to make of the result, instead of an answer for the page
    alone : the analysis does not use the study of the page
    examines : only read the files, and report what was understood
    turned : path of the number that a user turns; empty for another order
    """

    number: int
    text: str
    folder: Path
    file: str
    analysis: str
    options: Mapping[str, Any]
    title: str = ""
    export: Export | None = None
    turned: str = ""
    alone: bool = False
    examines: bool = False


@dataclass(frozen=True)
class Wish:
    """A number whose preview is wanted before others."""

    path: str


class _ReplacedError(BaseException):
    """The order that is computed has been replaced by a newer one."""


class WorkerChannel:
    """Messages to and from the worker; a newer order interrupts one that is computed."""

    def __init__(self, connection: Connection) -> None:
        self._connection, self._messages = connection, SimpleQueue[Order | Wish | None]()
        self._is_computing = self._is_replaced = self._is_sending = False
        # Ctrl-C reaches this process too; the server handles it and ends this process
        signal.signal(signal.SIGINT, self._interrupt)
        threading.Thread(target=self._listen, daemon=True).start()

    def _listen(self) -> None:
        while True:
            try:
                message = self._connection.recv()
            except EOFError:
                self._messages.put(None)
                return
            self._messages.put(message)
            if isinstance(message, Order) and self._is_computing:
                self._is_replaced = True
                _thread.interrupt_main()

    def _interrupt(self, number: int, frame: FrameType | None) -> None:
        if self._is_computing and self._is_replaced and not self._is_sending:
            self._is_computing = False
            raise _ReplacedError

    def send(self, kind: str, number: int, content: Any = None) -> None:
        """Send a message about the order of a number, as a whole."""
        self._is_sending = True
        self._connection.send((kind, number, content))
        self._is_sending = False
        self._interrupt(0, None)  # one that came meanwhile

    def next(self, wait: bool) -> Order | Wish | None:
        """The next message; None if the other end has closed, or if there is none and it should not wait.

        Raises
        ------
        EOFError : the other end has closed
        """
        if not wait and self._messages.empty():
            return None
        message = self._messages.get()
        if message is None:
            raise EOFError
        return message

    @contextmanager
    def computing(self) -> Iterator[None]:
        """Allow a newer order to end what is computed here."""
        self._is_replaced, self._is_computing = not self._messages.empty(), True
        try:
            yield
        except _ReplacedError:
            pass
        finally:
            self._is_computing = False


def serve(connection: Connection) -> None:
    """Compute orders until the other end closes, or its process ends."""
    channel, turnings = WorkerChannel(connection), dict[str, Any]()
    leave_out()
    threading.Thread(target=_end_with_parent, daemon=True).start()
    after: Aftermath | None = None
    while True:
        try:
            message = channel.next(wait=after is None)
        except EOFError:
            return
        if isinstance(message, Wish):
            if after is not None:
                after.wished = message.path
        elif message is not None:
            if after is not None:
                after.leave()
            after = None
            with channel.computing():
                after = _reported(message, channel, turnings)
        if after is not None and not after.advance():
            after = None


def _reported(order: Order, channel: WorkerChannel, turnings: dict[str, Any]) -> Aftermath | None:
    """Compute an order, and report its answer or its error."""

    def send(kind: str, content: Any = None) -> None:
        channel.send(kind, order.number, content)

    send("begun")
    try:
        if order.examines:
            send("understood", _understood(order))
            send("idle")
            return None
        study, result, turning = _computed(order, send, turnings)
        if order.export is None:
            return Aftermath(order=order, study=study, result=result, turning=turning, channel=channel)
    except Exception as error:  # noqa: BLE001  a fault of the program must not end in silence
        send("failed", _parts(error))
    send("idle")
    return None


def _inputs(order: Order) -> tuple[Analysis, Study | None, dict[str, Any]]:
    """The analysis of an order, its study, None without one, and its options."""
    analysis = offered(order.analysis)
    options = with_paths(analysis, order.options, Workspace(order.folder).measurement)
    if order.alone:
        return analysis, None, options
    if analysis.settings is not None:
        return analysis, None, {**options, **analysis.settings(order.text, order.folder)}
    study, _, problems = examined(order.text, Study, order.folder)
    if study is None:
        raise problems[0]
    return analysis, study, options


def _understood(order: Order) -> tuple[dict[str, Any], bytes | None]:
    """What was understood of the files of an order."""
    analysis, study, options = _inputs(order)
    with _heard() as words:
        reading = analysis.examined(study, Runner(), options)
        answer, view = answer_of(reading)
    return _warned(answer, words), view


@contextmanager
def _heard() -> Iterator[list[warnings.WarningMessage]]:
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", HaptonicWarning)
        yield caught


def _warned(answer: dict[str, Any], caught: list[warnings.WarningMessage]) -> dict[str, Any]:
    """The answer with the warnings among its remarks."""
    words = [str(each.message) for each in caught if issubclass(each.category, HaptonicWarning)]
    return answer | {"remarks": list(dict.fromkeys([*answer["remarks"], *words]))}


def _computed(order: Order, send: Send, turnings: dict[str, Any]) -> tuple[Study | None, Result, Any]:
    analysis, study, options = _inputs(order)
    if order.export is None and analysis.cost is not None:
        send("cost", analysis.cost(study, analysis.chosen(options)).sentence)

    def progress(done: int, planned: int, what: str = "", /) -> None:
        send("progress", (done, planned, what))

    def report(point: ComputedPoint, /) -> None:
        send("point", asdict(point))

    turning = analysis.turning and turnings.setdefault(analysis.name, analysis.turning())
    with _heard() as caught:
        runner = Runner(
            progress=progress,
            about=order.folder / order.file,
            report=report,
            first=lambda dataset: send("first", packed_part(analysis.name, dataset)),
        )
        result = analysis.run(study, runner, options)
    if order.export is not None:
        send("file", file_of(result, order.export, analysis.method))
        return study, result, turning
    answer, view = answer_of(result)
    send("done", (_warned(answer, caught), view))
    return study, result, turning


class Aftermath:
    """What follows an answer, in small steps: previews of the wanted number, pictures, other previews.

    wished : path of the number whose preview comes next
    """

    def __init__(
        self, order: Order, study: Study | None, result: Result, turning: Any, channel: WorkerChannel
    ) -> None:
        self._number, self._channel = order.number, channel
        self._result, self.wished = result, order.turned
        self._is_drawn, self._shown = False, set[str]()
        self._steps = self._all(study, turning)

    def advance(self) -> bool:
        """Do one step; False if there is none left."""
        try:
            next(self._steps)
        except StopIteration:
            return False
        except Exception as error:  # noqa: BLE001  the answer stays if a preview or a picture fails
            self._send("failed", _parts(error))
            self.leave()
            return False
        return True

    def _send(self, kind: str, content: Any = None) -> None:
        self._channel.send(kind, self._number, content)

    def leave(self) -> None:
        """Leave out the pictures that are not drawn."""
        if not self._is_drawn:
            self._is_drawn = True
            self._send("idle")

    def _all(self, study: Study | None, turning: Any) -> Iterator[None]:
        waiting: dict[str, Iterator[xr.Dataset | None]] = {}
        if turning is not None:
            knobs = turning.knobs(study)
            self._send("knobs", [asdict(knob) | {"steps": steps_of(knob.path)} for knob in knobs])
            yield
            certified = turning.certified(study, self._result)
            waiting = {knob.path: turning.previews(study, certified, knob) for knob in knobs}
        yield from self._first_preview(waiting)
        for picture in pictures_of(self._result):
            self._send("picture", picture)
            yield
            yield from self._first_preview(waiting)
        self.leave()
        while waiting:
            path = self.wished if self.wished in waiting else next(iter(waiting))
            yield from self._preview(waiting, path)

    def _first_preview(self, waiting: dict[str, Iterator[xr.Dataset | None]]) -> Iterator[None]:
        """Steps up to the first preview of the wanted number, or else of the first in the list."""
        while (path := self.wished or next(iter(waiting), "")) in waiting and path not in self._shown:
            yield from self._preview(waiting, path)

    def _preview(self, waiting: dict[str, Iterator[xr.Dataset | None]], path: str) -> Iterator[None]:
        """One step of a preview."""
        preview = None
        try:
            # a picture is drawn to its end instead, because its library reports other errors
            with self._channel.computing():
                preview = next(waiting[path])
        except StopIteration:
            del waiting[path]
            return
        if preview is not None:
            self._shown.add(path)
            self._send("preview", (path, packed_part("preview", preview)))
        yield


def _parts(error: Exception) -> dict[str, str]:
    """Parts of an error; a fault of the program is printed."""
    if isinstance(error, HaptonicError):
        return error.parts()
    traceback.print_exc()
    return ResourceError.worker(
        argument="analysis",
        given=f"{type(error).__name__}: {error}"[:300],
        allowed="an answer, or an error that names its cause",
        cause="a fault of the program",
        next_step="report the fault with the study; the terminal of the studio has the details",
    ).parts()


def _end_with_parent() -> None:
    """End this process when the server has ended in any way."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)
