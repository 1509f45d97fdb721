"""Limits of processor time that follow the machine: a slow one gets more of it."""

import time
from collections.abc import Iterator
from contextlib import contextmanager

# Seconds that `_reference_work` takes on the machine for which the limits of the tests were chosen.
USUAL = 0.15


@contextmanager
def within(seconds: float) -> Iterator[None]:
    """Fail when the block takes more than these seconds on a machine that is as fast as the usual one."""
    start = time.process_time()
    yield
    took = time.process_time() - start
    if took > seconds:
        slower = max(_reference_work() / USUAL, 1.0)
        assert took < seconds * slower, f"{took:.1f} s; the machine is {slower:.1f} times slower"


def _reference_work() -> float:
    """Processor time of a fixed piece of work: half a million numbers are written and read."""
    start = time.process_time()
    text = ",".join(map(str, range(500_000)))
    assert sum(map(float, text.split(","))) > 0
    return time.process_time() - start
