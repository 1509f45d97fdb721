"""Requests to the reading process, and its limits.

The process is started once and serves many files: starting takes about 0.2 s, a request less than a
millisecond. A process that crashes, hangs or exceeds its limits is ended; the next request starts another.
"""

from __future__ import annotations

import atexit
import os
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from queue import SimpleQueue
from typing import Any

from haptonic.errors import ChannelError, ResourceError
from haptonic.foreign import wire

# Processor time of a request. A good file of 100 MB takes 1 s (compressed MATLAB 5); damaged ones may hang.
SECONDS, BYTES_A_SECOND = 5.0, 4e6
WAITING = 12  # factor from processor time to time on the clock, for other work and a slow disk
# Memory of a request in addition to that of the process: a compressed file and its text are both in memory.
MEMORY, MEMORY_A_BYTE = 2**30, 16
LARGEST_NUMBER = 16  # bytes of a complex number
COMMAND = ["-m", "haptonic.foreign.child"]
START_SECONDS = 60.0  # limit on a busy machine; an idle one takes 0.2 s
LOOK_SECONDS = 0.1  # interval between checks of the process
PIPE = 2**20  # bytes of the buffer between the processes; Linux's default of 64 kB halves the speed


@dataclass(frozen=True)
class Limits:
    """Limits of a request: processor time (s), time on the clock (s), memory (bytes)."""

    seconds: float
    waiting: float
    memory: int

    @classmethod
    def of(cls, size: int) -> Limits:
        """Limits for a file of this size in bytes."""
        seconds = SECONDS + size / BYTES_A_SECOND
        return cls(seconds, WAITING * seconds, MEMORY + MEMORY_A_BYTE * size)


def ask(parser: str, path: Path, /, *, limits: Limits | None = None, **arguments: object) -> Any:
    """Run a parser on a file and return its result.

    Parameters
    ----------
    parser : module and function of `haptonic.foreign`, such as "hdf5.tree"
    limits : of this request; by default those for a file of this size
    arguments : arguments of the function: texts, numbers, lists, arrays

    Raises
    ------
    ChannelError : the parser raised an error, crashed, or exceeded the time limit
    OSError : the file does not exist, or may not be read
    ResourceError : no process can be started, or it exceeded the memory limit
    """
    with path.open("rb") as file:
        limits = limits or Limits.of(os.fstat(file.fileno()).st_size)
    question = {
        "parser": parser, "path": str(path.absolute()), "arguments": arguments,
        "seconds": limits.seconds, "memory": limits.memory,
    }  # fmt: skip
    with _turn:
        while True:
            reader = _reader()
            fresh = not reader.asked
            try:
                answer = reader.answer(question, limits)
                break
            except _EndedError as error:
                _end()
                # an earlier file may have damaged the memory of the process; then try again
                if fresh or error.reason:
                    raise _error_for(path, error, limits) from error
            except MemoryError as error:  # in this process
                _end()
                raise too_large(path, limits.memory) from error
            except BaseException:
                _end()  # a pending answer would be taken for the next one
                raise
    if "error" not in answer:
        return answer["answer"]
    if answer["error"] == "MemoryError":
        raise too_large(path, limits.memory)
    raise damaged(path, answer["error"])


def refuse_larger(path: Path, numbers: int) -> None:
    """Refuse arrays that need more memory than the limit for this file, before they are read.

    Parameters
    ----------
    numbers : count of numbers; each counts as a complex number of double precision

    Raises
    ------
    ResourceError : more memory than `Limits` allows
    OSError : the file does not exist
    """
    memory = Limits.of(path.stat().st_size).memory
    if numbers * LARGEST_NUMBER > memory:
        raise too_large(path, memory)


def too_large(path: Path, memory: int) -> ResourceError:
    """Error for a file whose content needs more memory (bytes) than the limit for its size."""
    return ResourceError.too_large(
        argument=path.name,
        given=f"a file of {path.stat().st_size} bytes whose content takes more than {memory / 1e9:.1f} GB",
        allowed=f"at most {MEMORY / 1e9:.1f} GB and {MEMORY_A_BYTE} bytes for each byte of the file",
        cause="it is damaged, or contains far more than one scan or one set of records",
        next_step="export fewer points or a shorter band, or copy the file again",
    )


def damaged(path: Path, fault: str) -> ChannelError:
    """Error for a file that its parser cannot read."""
    is_empty = path.is_file() and path.stat().st_size == 0
    return ChannelError.unreadable(
        argument=path.name,
        given="an empty file" if is_empty else fault,
        allowed="a complete file of the format in its name",
        cause="it is damaged, its copy was interrupted, or its format is not that of its name",
        next_step="copy or export it again, or check it in another program",
    )


def _error_for(path: Path, error: _EndedError, limits: Limits) -> Exception:
    # killed, but not by us: the system does so when it runs out of memory
    if error.reason == "memory" or (not error.reason and error.code == -getattr(signal, "SIGKILL", 0)):
        return too_large(path, limits.memory)
    if error.reason == "time":
        return damaged(path, f"not read within {limits.seconds:.0f} s")
    return damaged(path, "its parser crashed")


class _EndedError(Exception):
    """The process ended during a request; the reason is ours ("time", "memory"), or empty."""

    def __init__(self, reason: str, code: int) -> None:
        super().__init__(reason)
        self.reason, self.code = reason, code


class _Request:
    """Limits of a request, its end, and the reason why the process was killed during it."""

    def __init__(self, limits: Limits) -> None:
        self.limits, self.done, self.reason = limits, threading.Event(), ""


class _Reader:
    """A reading process, and the thread that watches it."""

    def __init__(self) -> None:
        self.asked = False
        self._requests = SimpleQueue[_Request | None]()
        try:
            # a new command instead of fork or multiprocessing: it copies no locks and runs no user's script
            self.process = subprocess.Popen(
                [sys.executable, "-P", *COMMAND],
                stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, bufsize=0,
                env=_environment(),
            )  # fmt: skip
        except OSError as error:
            raise _not_started(str(error)) from error
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        self.to, self.back = self.process.stdin, self.process.stdout
        # one thread for all requests: to start one takes as long as to read a channel
        threading.Thread(target=self._watch, daemon=True).start()
        _widened(self.to.fileno(), self.back.fileno())
        try:
            with self._watched(Limits(START_SECONDS, START_SECONDS, MEMORY)):
                wire.receive(self.back)
        except _EndedError as error:
            self.end()
            raise _not_started(f"it ended at once (exit code {self.process.returncode})") from error

    def answer(self, question: dict[str, Any], limits: Limits) -> dict[str, Any]:
        """Answer to a request.

        Raises
        ------
        _EndedError : the process ended
        """
        self.asked = True
        with self._watched(limits):
            wire.send(self.to, question)
            answer: dict[str, Any] = wire.receive(self.back)
        return answer

    @contextmanager
    def _watched(self, limits: Limits) -> Iterator[None]:
        """Watch the process from a thread, because a hang in C code blocks all signals except SIGKILL."""
        request = _Request(limits)
        self._requests.put(request)
        try:
            yield
        except (EOFError, BrokenPipeError) as error:
            code = self.process.wait()
            if not request.reason and code == -getattr(signal, "SIGXCPU", 0):  # the system's limit came first
                request.reason = "time"
            raise _EndedError(request.reason, code) from error
        finally:
            request.done.set()

    def _watch(self) -> None:
        while (request := self._requests.get()) is not None:
            if not request.done.wait(LOOK_SECONDS):
                self._limit(request)

    def _limit(self, request: _Request) -> None:
        """Kill the process if a request exceeds its limits."""
        import psutil  # imported here, because most requests are answered before

        limits, waited, before = request.limits, LOOK_SECONDS, None
        while not request.done.wait(LOOK_SECONDS):
            waited += LOOK_SECONDS
            try:
                process = psutil.Process(self.process.pid)
                times, memory = process.cpu_times(), process.memory_info().rss
            except psutil.Error:  # it has ended
                return
            used = times.user + times.system
            before = used if before is None else before
            if used - before > limits.seconds or waited > limits.waiting:
                request.reason = "time"
            elif memory > limits.memory + MEMORY // 4:  # the process itself takes 60 MB to 150 MB
                request.reason = "memory"
            if request.reason:
                self.process.kill()
                return

    def end(self) -> None:
        self.process.kill()
        self.close()

    def close(self) -> None:
        """Close the pipes; the process ends at the end of its input, and so does the thread."""
        self._requests.put(None)
        for pipe in (self.to, self.back):
            pipe.close()
        self.process.wait()


def _environment() -> dict[str, str]:
    """Environment of the process: the same import path, and one thread."""
    home = str(Path(__file__).parents[2])
    places = os.pathsep.join([home, *(place for place in sys.path if place and place != home)])
    return os.environ | {"PYTHONPATH": places, "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}


def _widened(*pipes: int) -> None:
    try:
        from fcntl import F_SETPIPE_SZ, fcntl
    except ImportError:  # only Linux has pipes of a chosen size
        return
    try:
        for pipe in pipes:
            fcntl(pipe, F_SETPIPE_SZ, PIPE)
    except OSError:  # the limit of the user is reached
        return


def _not_started(why: str) -> ResourceError:
    return ResourceError.worker(
        argument="process that reads files",
        given=why,
        allowed="a second process of Python beside this one",
        cause="the machine allows no more processes, or has no memory for one",
        next_step="end other programs, or lift the limit on processes (ulimit -u)",
    )


_turn = threading.Lock()
_readers: list[_Reader] = []  # at most one


def _reader() -> _Reader:
    if _readers and _readers[0].process.poll() is not None:
        _end()
    if not _readers:
        _readers.append(_Reader())
    return _readers[0]


def _end() -> None:
    while _readers:
        _readers.pop().end()


def _leave_to_the_parent() -> None:
    """After a fork, leave the process to the parent, with any request in progress."""
    global _turn
    _turn = threading.Lock()
    while _readers:
        reader = _readers.pop()
        reader.process.returncode = 0  # the parent waits for it, not this process
        for pipe in (reader.to, reader.back):
            pipe.close()


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_leave_to_the_parent)
atexit.register(_end)
