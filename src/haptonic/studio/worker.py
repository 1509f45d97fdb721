"""The worker process: it computes one order after another and reports on a connection.

A message is a kind, the number of the order, and a content: "begun"; "cost" with a sentence; "progress" with
the steps done and planned and the name of the current one; "point" with a computed design; "first" with the
part of a view that is computed first; "done" with answer and view; "understood" with answer and view of the
files; "knobs" with the numbers that can be turned; "preview" with the path of one of them and a view;
"file" with name and content of an export; "failed" with the parts of an error.

After an answer the worker prepares previews, one after the other. An order goes first.
"""

from __future__ import annotations

import _thread
import multiprocessing
import os
import signal
import threading
import traceback
import warnings
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from multiprocessing.connection import Connection
from queue import SimpleQueue
from types import FrameType
from typing import Any

from haptonic.analyses.analysis import Analysis
from haptonic.analyses.points import ComputedPoint
from haptonic.analyses.runner import Runner
from haptonic.errors import HaptonicError, HaptonicWarning, ResourceError
from haptonic.later import leave_out, xarray as xr
from haptonic.results.result import Result
from haptonic.studio.answers import answer_of, packed_part
from haptonic.studio.editing import steps_of
from haptonic.studio.files import file_of
from haptonic.studio.memory import give_back, share_one_arena
from haptonic.studio.offers import offered, with_paths
from haptonic.studio.order import Order, Wish
from haptonic.studio.workspace import Workspace
from haptonic.study import Study
from haptonic.study.loading import examined

MOST_WISHES = 20  # paths that are remembered
Send = Callable[..., None]  # kind and content of a message


class _ReplacedError(BaseException):
    """The order that is computed has been replaced by a newer one."""


class WorkerChannel:
    """Messages to and from the worker; a newer order interrupts one that is computed."""

    def __init__(self, connection: Connection) -> None:
        self._connection, self._messages = connection, SimpleQueue[Order | Wish | None]()
        self._is_computing = self._is_sending = False
        self._heard = self._taken = 0  # orders; each number is written by one thread
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
            self._heard += isinstance(message, Order)
            self._messages.put(message)
            if isinstance(message, Order) and self._is_computing:
                _thread.interrupt_main()

    def _interrupt(self, number: int, frame: FrameType | None) -> None:
        if self._is_computing and self._heard > self._taken and not self._is_sending:
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
        self._taken += isinstance(message, Order)
        return message

    @contextmanager
    def computing(self) -> Iterator[None]:
        """Allow a newer order to end the computation of the block."""
        self._is_computing = True
        try:
            yield
        except _ReplacedError:
            pass
        finally:
            self._is_computing = False


def serve(connection: Connection) -> None:
    """Compute orders until the other end closes, or its process ends."""
    share_one_arena()
    channel, turnings, wishes = WorkerChannel(connection), dict[str, Any](), Wishes()
    leave_out()
    threading.Thread(target=_end_with_parent, daemon=True).start()
    after: Aftermath | None = None
    while True:
        has_work = after is not None
        if not has_work:
            give_back()
        try:
            message = channel.next(wait=not has_work)
        except EOFError:
            return
        if isinstance(message, Wish):
            wishes.add(message.path)
        elif message is not None:
            after = None
            if message.turned:
                wishes.add(message.turned)
            with channel.computing():
                after = _reported(message, channel, turnings, wishes)
        if after is not None and not after.advance():
            after = None


def _reported(
    order: Order, channel: WorkerChannel, turnings: dict[str, Any], wishes: Wishes
) -> Aftermath | None:
    """Compute an order, and report its answer or its error."""

    def send(kind: str, content: Any = None) -> None:
        channel.send(kind, order.number, content)

    send("begun")
    try:
        if order.examines:
            send("understood", _understood(order))
            return None
        study, result, turning = _computed(order, send, turnings)
    except Exception as error:  # noqa: BLE001  a fault of the program must not end in silence
        send("failed", _parts(error))
        return None
    if study is None or turning is None or order.export is not None:
        return None
    return Aftermath(order.number, channel, _previewed(study, result, turning, wishes, send))


def _inputs(order: Order) -> tuple[Analysis, Study | None, dict[str, Any]]:
    """The analysis of an order, its study, None without one, and its options."""
    analysis = offered(order.analysis)
    options = with_paths(analysis, order.options, Workspace(order.folder).measurement)
    if order.alone:
        return analysis, None, options
    if analysis.settings is not None:
        return analysis, None, {**options, **analysis.settings(order.text, order.folder)}
    return analysis, study_of(order), options


def study_of(order: Order) -> Study:
    """The study of an order.

    Raises
    ------
    HaptonicError : its text has a problem
    """
    # the designs of a sweep take longer to check than the rest, and do not belong to a design that is turned
    omitted = ("sweep",) if order.turned else ()
    study, _, problems = examined(order.text, Study, order.folder, omitted=omitted)
    if study is None:
        raise problems[0]
    return study


def _understood(order: Order) -> tuple[dict[str, Any], bytes | None]:
    """Reading of the files of an order."""
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
    if order.export is None and analysis.cost is not None and not order.turned:
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


class Wishes:
    """Paths of the numbers that the user has turned or selected, the latest first."""

    def __init__(self) -> None:
        self._paths: list[str] = []

    def add(self, path: str) -> None:
        """Put a path first."""
        self._paths = [path, *(known for known in self._paths if known != path)][:MOST_WISHES]

    def first_of(self, paths: Iterable[str]) -> str:
        """The path that is wanted first."""
        known = list(paths)
        return next((path for path in self._paths if path in known), known[0])


@dataclass(frozen=True)
class Aftermath:
    """Tasks after an answer, in small steps: the numbers that can be turned, and their previews."""

    number: int
    channel: WorkerChannel
    steps: Iterator[None]

    def advance(self) -> bool:
        """Do one step; False if there is none left, or a newer order has come."""
        is_left = False
        with self.channel.computing():
            try:
                is_left = next(self.steps, self) is None
            except Exception as error:  # noqa: BLE001  the answer stays if a preview fails
                self.channel.send("failed", self.number, _parts(error))
        return is_left


def _previewed(study: Study, result: Result, turning: Any, wishes: Wishes, send: Send) -> Iterator[None]:
    """Steps of the previews of a result; after each the next number is that of the latest wish."""
    knobs = turning.knobs(study)
    send("knobs", [asdict(knob) | {"steps": steps_of(knob.path)} for knob in knobs])
    yield
    certified = turning.certified(study, result)
    waiting: dict[str, Iterator[xr.Dataset | None]] = {
        knob.path: turning.previews(study, certified, knob) for knob in knobs
    }
    yield
    while waiting:
        path = wishes.first_of(waiting)
        try:
            preview = next(waiting[path])
        except StopIteration:
            del waiting[path]
            continue
        if preview is not None:
            send("preview", (path, packed_part("preview", preview)))
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
