"""The reading process: it answers requests until its input ends, within the limits of each."""

from __future__ import annotations

import importlib
import math
import os
import signal
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import Any

import psutil

from haptonic.foreign import wire

try:
    import resource
except ImportError:  # Windows; there only the other process checks the limits
    resource = None  # type: ignore[assignment]

READY = "ready"


def serve() -> None:
    """Answer each {"parser", "path", "arguments", "seconds", "memory"} with {"answer"} or {"error"}."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the asking process handles Ctrl-C and ends this one
    questions = open(os.dup(0), "rb", buffering=0)  # noqa: SIM115  open until the process ends
    answers = open(os.dup(1), "wb", buffering=0)  # noqa: SIM115
    os.dup2(2, 1)  # keep the output of parsers out of the answers
    if resource is not None:
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    wire.send(answers, READY)
    while True:
        try:
            question = wire.receive(questions)
        except EOFError:
            return
        wire.send(answers, _answered(question))


def _answered(question: dict[str, Any]) -> dict[str, Any]:
    module, _, name = question["parser"].partition(".")
    parser = getattr(importlib.import_module(f"haptonic.foreign.{module}"), name)
    try:
        with _limited(question["seconds"], question["memory"]):
            return {"answer": parser(question["path"], **question["arguments"])}
    except Exception as error:  # noqa: BLE001  third-party parsers raise any exception for a damaged file
        return {"error": type(error).__name__}


@contextmanager
def _limited(seconds: float, memory: int) -> Iterator[None]:
    """Limits of the operating system, effective in C code and without the other process."""
    if resource is None:
        yield
        return
    used, room = math.ceil(time.process_time() + seconds), psutil.Process().memory_info().vms + memory
    with _limit(resource.RLIMIT_CPU, used + 1), _limit(resource.RLIMIT_AS, room):
        yield


@contextmanager
def _limit(kind: int, soft: int) -> Iterator[None]:
    before, hard = resource.getrlimit(kind)
    limits = [limit for limit in (soft, before, hard) if limit != resource.RLIM_INFINITY]
    # macOS refuses some limits; the asking process checks them too
    with suppress(ValueError, OSError):
        resource.setrlimit(kind, (min(limits), hard))
    try:
        yield
    finally:
        with suppress(ValueError, OSError):
            resource.setrlimit(kind, (before, hard))


if __name__ == "__main__":
    serve()
    sys.exit(0)
