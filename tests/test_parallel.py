"""Work side by side: in order, bounded in what waits, and stopped by an error or by whoever turns away."""

import math
import re
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
from threadpoolctl import threadpool_info, threadpool_limits

from haptonic.parallel import each, finished, one_thread, streamed, threads


@pytest.mark.parametrize("count", ["1", "3"])
def test_results_come_in_the_order_of_the_items(count, monkeypatch):
    monkeypatch.setenv("OMP_NUM_THREADS", count)
    assert threads() == int(count)

    def slow(item: int) -> tuple[int, set[int]]:
        time.sleep(0.01 * (item % 3 == 0))
        np.eye(3) @ np.eye(3)
        libraries = [library for library in threadpool_info() if library["user_api"] == "blas"]
        # earlier tests may have loaded MKL, which is limited where it is called, and libraries of meshers
        ours = (own for own in libraries if re.search("numpy|scipy", own["filepath"]))
        return item**2, {own["num_threads"] for own in ours}

    with threadpool_limits(2):
        results = each(slow, range(12))
    assert [square for square, _ in results] == [item**2 for item in range(12)]
    assert all(limits == {1} for _, limits in results), "linear algebra inside has one thread"
    assert each(slow, []) == []


def test_libraries_are_searched_for_only_once(monkeypatch):
    """A search beside a thread that loads a library can wait for ever."""
    with one_thread():
        pass
    monkeypatch.setattr("haptonic.parallel.ThreadpoolController", None)
    # other tests load libraries of meshers, which are not those of linear algebra here
    ours = {library["filepath"] for library in threadpool_info() if "scipy" in library["filepath"]}
    with threadpool_limits(2), one_thread():
        limits = {library["filepath"]: library["num_threads"] for library in threadpool_info()}
    assert {limits[path] for path in ours} == {1}


def test_an_error_stops_what_has_not_begun(monkeypatch):
    monkeypatch.setenv("OMP_NUM_THREADS", "2")
    begun = []

    def work(item: int) -> None:
        begun.append(item)
        if item == 0:
            raise ValueError("no")
        time.sleep(0.05)

    with pytest.raises(ValueError, match="no"):
        each(work, range(40))
    assert len(begun) < 10


@pytest.mark.parametrize(("workers", "ahead"), [(0, 1), (1, 2), (2, 5)])
def test_no_more_items_are_taken_than_may_wait(workers, ahead):
    taken, done = [], []

    def items():
        for item in range(30):
            taken.append(item)
            yield item

    for result in streamed(lambda item: item, items(), workers, ahead):
        done.append(result)
        assert len(taken) - len(done) < ahead
    assert done == list(range(30))


INTERRUPTED = """
import signal, threading, time, types
from concurrent.futures import _base
from haptonic.parallel import streamed

signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell lets jobs in the background ignore it


class Locked(threading.Condition):
    def __enter__(self):
        entered = super().__enter__()
        if threading.current_thread() is threading.main_thread():
            signal.raise_signal(signal.SIGINT)
        return entered

_base.threading = types.SimpleNamespace(**vars(threading) | {"Condition": Locked})
try:
    list(streamed(lambda item: time.sleep(0.1), range(4), 2, 2))
except KeyboardInterrupt:
    print("interrupted")
"""


def test_ctrl_c_while_a_future_has_its_lock_ends_the_threads():
    """Python would leave the future locked, and its thread would wait for it for ever."""
    script = [sys.executable, "-c", INTERRUPTED]
    run = subprocess.run(script, capture_output=True, text=True, timeout=20, check=False)
    assert (run.stdout, run.stderr) == ("interrupted\n", "")


def test_whoever_turns_away_leaves_nothing_to_be_begun():
    begun, release = [], threading.Event()

    def work(item: int) -> int:
        begun.append(item)
        if item:
            release.wait(5)
        return item

    results = streamed(work, range(30), 2, 20)
    threading.Timer(0.2, release.set).start()
    assert next(results) == 0
    results.close()
    assert len(begun) < 10


@pytest.mark.parametrize("workers", [0, 2])
def test_processes_give_each_result_once_and_take_no_item_early(workers):
    taken, done = [], {}

    def items():
        for item in range(9):
            taken.append(item)
            yield f"{item}!", item

    for key, result in finished(math.factorial, items(), workers, math.factorial):
        done[key] = result
        assert len(taken) - len(done) <= max(workers, 1)
    assert done == {f"{item}!": math.factorial(item) for item in range(9)}
