"""Many tasks at once: what is finished is kept, and one bad task costs only itself."""

from __future__ import annotations

import logging
import os
import signal
import socket
import subprocess
import sys
import textwrap
import threading
import time
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import psutil
import pytest
import xarray as xr

from daily import daily
from five_parts import refusing
from haptonic import jobs, parallel
from haptonic.errors import HaptonicError, ResourceError, StudyError
from haptonic.jobs import Outcome, Task, run_all
from haptonic.store import Store
from interrupts import hear_interrupts

if TYPE_CHECKING:
    from distributed import LocalCluster

Step = tuple[int, int, bool]


def square(number: float) -> xr.Dataset:
    """The computation of most tests; it also stores where it ran and with how many threads."""
    threads = [int(os.environ.get(name, "0")) for name in parallel.THREAD_LIMITS]
    return xr.Dataset(
        {"y": ((), float(number) ** 2), "threads": ("library", threads), "process": ((), os.getpid())}
    )


def moody(argument: tuple[str, int, str]) -> xr.Dataset:
    """As ``square``, unless the mood is another one."""
    mood, number, flag = argument
    if mood == "wrong":
        raise StudyError.conflict(
            argument="cell.pitch", given=number, allowed="1", cause="a slip", next_step="mend it"
        )
    if mood == "deadly" or (mood == "deadly once" and not Path(flag).exists()):
        Path(flag).touch()
        os.kill(os.getpid(), signal.SIGKILL)
    if mood == "slow":
        time.sleep(0.2)
    if mood == "buggy":
        raise ZeroDivisionError("unexpected")
    return square(number)


def no_process(*_: object, **__: object) -> None:
    raise OSError("no more processes")


def never(number: float) -> xr.Dataset:
    raise AssertionError(f"computed {number} again")


def tasks_for(numbers: list[int]) -> list[Task]:
    return [Task({"kind": "square", "number": number}, number) for number in numbers]


def moody_tasks(folder: Path, moods: list[str]) -> list[Task]:
    flags = [str(folder / f"flag {number}") for number in range(len(moods))]
    return [
        Task({"kind": "moody", "mood": mood, "number": number}, (mood, number, flag))
        for number, (mood, flag) in enumerate(zip(moods, flags, strict=True))
    ]


def result(outcome: Outcome) -> float | None:
    return None if outcome.dataset is None else outcome.dataset.y.item()


def kept(store: Store) -> int:
    return len(list(store.root.rglob("*.nc")))


@pytest.fixture
def store(tmp_path: Path) -> Store:
    return Store(tmp_path / "store")


class TestHere:
    def test_results_come_in_the_order_of_the_tasks(self, store: Store) -> None:
        steps: list[Step] = []
        run_all(square, tasks_for([5, 2]), store=store)
        outcomes = run_all(
            square, tasks_for([3, 2, 1, 5]), store=store, progress=lambda *step: steps.append(step)
        )
        assert [result(outcome) for outcome in outcomes] == [9, 4, 1, 25]
        assert [outcome.from_store for outcome in outcomes] == [False, True, False, True]
        assert steps == [(1, 4, jobs.STORED), (2, 4, jobs.STORED), (3, 4, ""), (4, 4, "")]

    def test_what_was_done_is_not_computed_again(self, store: Store) -> None:
        first = run_all(square, tasks_for([1, 2, 3]), store=store)
        again = run_all(never, tasks_for([1, 2, 3]), store=store)
        for computed, loaded in zip(first, again, strict=True):
            xr.testing.assert_identical(computed.dataset, loaded.dataset)

    def test_no_process_is_started_when_all_is_there(
        self, store: Store, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        run_all(square, tasks_for([1, 2]), store=store)
        monkeypatch.setattr(jobs, "finished", never)
        assert all(
            outcome.from_store for outcome in run_all(never, tasks_for([1, 2]), store=store, workers=2)
        )

    def test_equal_tasks_are_computed_once(self, store: Store) -> None:
        steps: list[Step] = []
        calls = []

        def counted(number: float) -> xr.Dataset:
            calls.append(number)
            return square(number)

        outcomes = run_all(
            counted, tasks_for([2, 3, 2]), store=store, progress=lambda *step: steps.append(step)
        )
        assert [result(outcome) for outcome in outcomes] == [4, 9, 4]
        assert calls == [2, 3]
        assert [done for done, _, _ in steps] == [1, 2, 3]

    def test_no_tasks(self, store: Store) -> None:
        assert run_all(never, [], store=store, workers=2) == []

    def test_an_error_of_one_task_is_its_outcome_and_is_not_stored(
        self, store: Store, tmp_path: Path
    ) -> None:
        tasks = moody_tasks(tmp_path, ["fine", "wrong", "fine"])
        outcomes = run_all(moody, tasks, store=store)
        assert [result(outcome) for outcome in outcomes] == [0, None, 4]
        assert isinstance(outcomes[1].error, StudyError)
        assert [outcome.from_store for outcome in run_all(moody, tasks, store=store)] == [True, False, True]

    def test_any_other_exception_ends_the_run_and_keeps_what_was_done(
        self, store: Store, tmp_path: Path
    ) -> None:
        with pytest.raises(ZeroDivisionError):
            run_all(moody, moody_tasks(tmp_path, ["fine", "fine", "buggy", "fine"]), store=store)
        assert kept(store) == 2

    def test_an_unusable_store_is_reported_before_the_work_and_does_not_stop_it(self, tmp_path: Path) -> None:
        (tmp_path / "file").touch()
        warned: list[int] = []

        def computed(number: float) -> xr.Dataset:
            warned.append(len(caught))
            return square(number)

        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            outcomes = run_all(computed, tasks_for([1, 3]), store=Store(tmp_path / "file" / "store"))
        assert [result(outcome) for outcome in outcomes] == [1, 9]
        assert warned[0] > 0
        assert {str(warning.message) for warning in caught} == {str(caught[0].message)}, "the same every time"
        assert "are not stored" in str(caught[0].message)

    def test_importing_it_does_not_import_dask(self) -> None:
        check = "import sys, haptonic.jobs; print('distributed' in sys.modules, 'dask' in sys.modules)"
        printed = subprocess.run([sys.executable, "-c", check], capture_output=True, text=True, check=True)
        assert printed.stdout == "False False\n"


class TestWorkers:
    def test_a_death_costs_only_the_design_it_was_on(
        self,
        store: Store,
        tmp_path: Path,
        capfd: pytest.CaptureFixture[str],
        monkeypatch: pytest.MonkeyPatch,
    ) -> None:
        """One run for all that is asked of workers on this machine: it takes seconds to start them."""
        monkeypatch.setattr(parallel, "cores", lambda: 6)
        monkeypatch.setenv("OMP_NUM_THREADS", "64")
        monkeypatch.delenv("MKL_NUM_THREADS", raising=False)
        moods = ["fine", "deadly", "fine", "wrong", "deadly once", "fine", "fine", "fine"]
        steps: list[Step] = []
        outcomes = run_all(
            moody,
            moody_tasks(tmp_path, moods),
            store=store,
            workers=2,
            progress=lambda *step: steps.append(step),
        )
        assert [result(outcome) for outcome in outcomes] == [0, None, 4, None, 16, 25, 36, 49]
        assert isinstance(outcomes[1].error, ResourceError)
        assert "died twice" in outcomes[1].error.given
        assert isinstance(outcomes[3].error, StudyError)
        assert (tmp_path / "flag 4").exists(), "the worker on task 4 was to die once"
        assert kept(store) == 6
        assert steps == [(done, 8, "") for done in range(1, 9)]
        assert capfd.readouterr() == ("", "")

        datasets = [outcome.dataset for outcome in outcomes if outcome.dataset is not None]
        processes = {dataset.process.item() for dataset in datasets}
        assert os.getpid() not in processes
        _, alive = psutil.wait_procs([psutil.Process(p) for p in processes if psutil.pid_exists(p)], 5)
        assert not alive, "a process stays behind"
        threads = {tuple(dataset.threads.values.tolist()) for dataset in datasets}
        assert threads == {(3, 3, 3)}, "six cores for two workers"
        assert os.environ["OMP_NUM_THREADS"] == "64"
        assert "MKL_NUM_THREADS" not in os.environ

    def test_any_other_exception_ends_the_run_and_keeps_what_was_done(
        self, store: Store, tmp_path: Path
    ) -> None:
        with pytest.raises(ZeroDivisionError, match="unexpected"):
            run_all(moody, moody_tasks(tmp_path, ["fine", "fine", "fine", "buggy"]), store=store, workers=1)
        assert kept(store) == 3

    def test_none_can_be_started(self, store: Store, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(parallel.multiprocessing.get_context("spawn"), "Process", no_process)
        with refusing(ResourceError, "worker", "workers"):
            run_all(square, tasks_for([1]), store=store, workers=1)

    @pytest.mark.parametrize(("workers", "scheduler"), [(-1, None), (2, "tcp://127.0.0.1:8786")])
    def test_settings_that_make_no_sense(self, store: Store, workers: int, scheduler: str | None) -> None:
        with refusing(HaptonicError, "malformed", "workers"):
            run_all(never, tasks_for([1]), store=store, workers=workers, scheduler=scheduler)


class TestScheduler:
    @contextmanager
    def cluster(self, workers: int) -> Iterator[LocalCluster]:
        """Somebody's scheduler; in this process, which is quick to start, but reached as a real one."""
        from distributed import LocalCluster

        with (
            jobs._quiet(),
            LocalCluster(
                n_workers=workers,
                threads_per_worker=1,
                processes=False,
                protocol="tcp",
                dashboard_address=None,
                silence_logs=logging.CRITICAL,
            ) as cluster,
        ):
            yield cluster

    @pytest.fixture
    def somebodys_scheduler(self) -> Iterator[str]:
        with self.cluster(workers=1) as cluster:
            yield cluster.scheduler_address

    def test_its_workers_are_used_and_left_running(
        self, store: Store, tmp_path: Path, somebodys_scheduler: str
    ) -> None:
        for moods in (["fine", "wrong", "fine"], ["fine", "wrong", "fine", "fine"]):
            tasks = moody_tasks(tmp_path, moods)
            outcomes = run_all(moody, tasks, store=store, scheduler=somebodys_scheduler)
            assert [result(outcome) for outcome in outcomes] == [0, None, 4, 9][: len(moods)]
        assert kept(store) == 3

    def test_any_other_exception_ends_the_run_and_keeps_what_was_done(
        self, store: Store, tmp_path: Path, somebodys_scheduler: str
    ) -> None:
        tasks = moody_tasks(tmp_path, ["fine", "fine", "fine", "buggy"])
        with pytest.raises(ZeroDivisionError, match="unexpected"):
            run_all(moody, tasks, store=store, scheduler=somebodys_scheduler)
        assert kept(store) == 3

    def test_a_worker_with_other_code_is_refused(self) -> None:
        assert isinstance(jobs._attempt_there(2, square, jobs.fingerprint()), xr.Dataset)
        refused = jobs._attempt_there(2, square, "0" * 64)
        assert isinstance(refused, ResourceError)
        assert "another version" in refused.given

    def test_it_has_no_workers(self, store: Store, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(jobs, "FIRST_WORKER_SECONDS", 0.3)
        with self.cluster(workers=0) as cluster, refusing(ResourceError, "worker", "scheduler"):
            run_all(square, tasks_for([1]), store=store, scheduler=cluster.scheduler_address)

    def test_it_is_lost_on_the_way(
        self, store: Store, tmp_path: Path, capfd: pytest.CaptureFixture[str]
    ) -> None:
        with self.cluster(workers=1) as cluster, refusing(ResourceError, "worker", "scheduler"):
            run_all(
                moody,
                moody_tasks(tmp_path, ["slow"] * 20),
                store=store,
                scheduler=cluster.scheduler_address,
                progress=lambda *_: cluster.close(),
            )
        assert 1 <= kept(store) < 20
        assert capfd.readouterr() == ("", "")

    @pytest.mark.parametrize(
        "address",
        [
            "tcp://127.0.0.1:{port}",
            "tls://127.0.0.1:{port}",
            "nonsense",
            "pigeon://127.0.0.1:1",
            "http://h:80",
            "",
        ],
    )
    def test_it_cannot_be_reached(self, store: Store, monkeypatch: pytest.MonkeyPatch, address: str) -> None:
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            port = taken.getsockname()[1]
        monkeypatch.setattr(jobs, "CONNECT_SECONDS", 0.5)
        before = set(threading.enumerate())
        with refusing(ResourceError, "worker", "scheduler") as caught:
            run_all(square, tasks_for([1]), store=store, scheduler=address.format(port=port))
        assert caught.value.argument == "scheduler"
        # Whatever is left would be ended by the collector, at a moment when the next client may be starting.
        assert not [thread for thread in set(threading.enumerate()) - before if thread.name == "IO loop"]


class TestInterrupted:
    SCRIPT = """
        import sys, time
        from pathlib import Path
        import xarray as xr
        from haptonic import jobs, parallel
        from haptonic.store import Store

        def slow(number):
            time.sleep(0.05 if number < 4 else 60)
            return xr.Dataset({"y": ((), float(number) ** 2)})

        def show(*words):
            print(*words, flush=True)

        def announced(start=parallel.resource_tracker.ensure_running):
            show("starting")
            start()

        parallel.resource_tracker.ensure_running = announced

        if __name__ == "__main__":
            tasks = [jobs.Task({"kind": "square", "number": number}, number) for number in range(8)]
            try:
                jobs.run_all(
                    slow, tasks, store=Store(Path(sys.argv[1])), workers=int(sys.argv[2]), progress=show
                )
            except KeyboardInterrupt:
                sys.exit(130)
    """

    # Ctrl-C whenever the main thread has the lock of a future, once four tasks are done.
    LOCKED = """
        import signal, threading, types
        from concurrent.futures import _base

        class Locked(threading.Condition):
            interrupts = False

            def __init__(self):
                super().__init__()
                self.acquire = self.__enter__

            def __enter__(self):
                entered = super().__enter__()
                if Locked.interrupts and threading.current_thread() is threading.main_thread():
                    signal.raise_signal(signal.SIGINT)
                return entered

        def show(done, *words):
            Locked.interrupts |= done == 4
            print(done, *words, flush=True)

        _base.threading = types.SimpleNamespace(**vars(threading) | {"Condition": Locked})
    """

    def start(
        self, tmp_path: Path, store: Store, workers: int, until: str, changes: str = ""
    ) -> subprocess.Popen[str]:
        """The script in a process group of its own, as a terminal runs it, up to a line that it prints."""
        script = tmp_path / "script.py"
        begin, main = textwrap.dedent(self.SCRIPT).split("if __name__")
        script.write_text(f"{begin}{textwrap.dedent(changes)}if __name__{main}")
        child = subprocess.Popen(
            [sys.executable, str(script), str(store.root), str(workers)],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            start_new_session=True,
            preexec_fn=hear_interrupts,
        )
        assert child.stdout is not None
        for line in child.stdout:
            if line.strip() == until:
                return child
        raise AssertionError(f"never printed {until!r}: {child.communicate()}")

    def assert_resumed(self, store: Store) -> None:
        """The four quick tasks are taken from the store, the slow ones are computed, now quickly."""
        outcomes = run_all(square, tasks_for(list(range(8))), store=store)
        assert [outcome.from_store for outcome in outcomes] == [True] * 4 + [False] * 4
        assert [result(outcome) for outcome in outcomes] == [number**2 for number in range(8)]

    def test_a_killed_run_goes_on_where_it_was(self, tmp_path: Path, store: Store) -> None:
        child = self.start(tmp_path, store, workers=0, until="4 8")
        child.kill()
        child.communicate()
        self.assert_resumed(store)

    @pytest.mark.skipif(sys.platform == "win32", reason="no process groups as a terminal makes them")
    @pytest.mark.parametrize("workers", daily([0, 2], 2))
    def test_ctrl_c_keeps_what_was_done(self, tmp_path: Path, store: Store, workers: int) -> None:
        child = self.start(tmp_path, store, workers, until="4 8")
        began = time.monotonic()
        os.killpg(child.pid, signal.SIGINT)
        _, noise = child.communicate(timeout=30)
        assert noise == ""
        assert child.returncode == 130
        assert time.monotonic() - began < 10, "the tasks that were running take a minute"
        self.assert_resumed(store)

    @pytest.mark.skipif(sys.platform == "win32", reason="no process groups as a terminal makes them")
    def test_ctrl_c_while_a_future_has_its_lock(self, tmp_path: Path, store: Store) -> None:
        child = self.start(tmp_path, store, workers=2, until="4 8", changes=self.LOCKED)
        _, noise = child.communicate(timeout=30)
        assert noise == ""
        assert child.returncode == 130
        self.assert_resumed(store)

    @pytest.mark.nightly
    @pytest.mark.skipif(sys.platform == "win32", reason="no process groups as a terminal makes them")
    def test_ctrl_c_while_the_workers_start(self, tmp_path: Path, store: Store) -> None:
        child = self.start(tmp_path, store, workers=2, until="starting")
        time.sleep(0.5)
        os.killpg(child.pid, signal.SIGINT)
        _, noise = child.communicate(timeout=60)
        assert noise == ""
        assert child.returncode == 130
        assert kept(store) == 0
