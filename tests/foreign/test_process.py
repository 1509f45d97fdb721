"""The process that reads: what goes wrong in it stays there, and what is right comes back unchanged."""

from __future__ import annotations

import multiprocessing
import os
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from io import BytesIO

import h5py
import numpy as np
import psutil
import pytest
import scipy.io
from hypothesis import given, settings, strategies as st
from hypothesis.extra import numpy as arrays

import haptonic
import haptonic.foreign.process as process
from five_parts import refusing
from haptonic.errors import ChannelError, ResourceError
from haptonic.foreign import wire
from haptonic.foreign.process import Limits, ask
from pace import within

NUMBERS = np.arange(12.0).reshape(3, 4)


@pytest.fixture
def good(tmp_path):
    with h5py.File(tmp_path / "good.h5", "w") as file:
        file["a"] = NUMBERS
    return tmp_path / "good.h5"


@pytest.fixture
def crashing(tmp_path):
    """A MATLAB file of which one byte was changed: scipy 1.17 crashes on it."""
    path = tmp_path / "crash.mat"
    scipy.io.savemat(path, {"h": np.ones((4, 8)) * 1j, "f": np.arange(8.0)})
    content = bytearray(path.read_bytes())
    content[176] = 0
    path.write_bytes(content)
    return path


@pytest.fixture
def answering(monkeypatch):
    """Let the process do something else than read: each parser is Python code."""

    def patched(code: str, before: str = "pass") -> None:
        script = (
            "from haptonic.foreign import child, hdf5\n"
            f"def tree(path):\n    {code}\n"
            f"hdf5.tree = tree\n{before}\nchild.serve()"
        )
        monkeypatch.setattr(process, "_readers", [])
        monkeypatch.setattr(process, "COMMAND", ["-c", script])

    yield patched
    process._end()


def assert_reads(path):
    assert np.array_equal(ask("hdf5.read", path, names=["a"])[0], NUMBERS)


values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text()
    | arrays.arrays(
        st.sampled_from(["<f8", ">f8", "<f4", "<c16", "<i2", ">u4", "?"]),
        arrays.array_shapes(min_dims=0, max_dims=3, min_side=0, max_side=4),
        elements=None,
    ),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(), inner, max_size=3),
    max_leaves=8,
)  # fmt: skip


def same(a, b):
    if isinstance(a, np.ndarray):
        return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()
    if isinstance(a, dict):
        return list(a) == list(b) and all(same(a[name], b[name]) for name in a)
    if isinstance(a, list):
        return len(a) == len(b) and all(map(same, a, b))
    return type(a) is type(b) and a == b


class _Raw(BytesIO):
    """Takes and gives a few bytes at a time, as a pipe may."""

    def write(self, content):
        return super().write(bytes(content[:7]))

    def readinto(self, into):
        return super().readinto(memoryview(into)[:5])


@given(values)
@settings(max_examples=50)
def test_what_is_sent_comes_back(content):
    """Whatever names a file has: "a" and "d" too, which the messages use themselves."""
    stream = _Raw()
    wire.send(stream, {"a": content, "d": [content]})
    stream.seek(0)
    assert same(wire.receive(stream), {"a": content, "d": [content]})


def test_an_array_keeps_its_order_in_memory():
    stream = _Raw()
    wire.send(stream, NUMBERS.T)
    stream.seek(0)
    assert wire.receive(stream).flags.f_contiguous


class TestFaults:
    def test_a_crash(self, crashing, good):
        with refusing(ChannelError, "unreadable", "crash.mat", "crashed"):
            ask("matlab.variables", crashing, large=10)
        assert_reads(good)

    @pytest.mark.parametrize(
        ("code", "error", "words"),
        [
            ("while True: pass", ChannelError, "not read within"),
            ("import time; time.sleep(1000)", ChannelError, "not read within"),
            ("raise KeyError(path)", ChannelError, "KeyError"),
            ("import os; os.abort()", ChannelError, "crashed"),
            ("import os; os._exit(0)", ChannelError, "crashed"),
            ("bytearray(2**33)", ResourceError, "GB"),
            ("import os, signal; os.kill(os.getpid(), signal.SIGKILL)", ResourceError, "GB"),
        ],
    )
    def test_every_end(self, good, answering, code, error, words):
        answering(code)
        with pytest.raises(error, match=words):
            ask("hdf5.tree", good, limits=Limits(seconds=0.5, waiting=1.5, memory=2**30))
        assert_reads(good)

    @pytest.mark.parametrize(
        ("code", "error", "seconds"),
        [
            ("while True: pass", ChannelError, 0.5),
            ("kept = [bytearray(2**22) for _ in iter(int, 1)]", ResourceError, 2.0),
        ],
    )
    def test_without_limits_of_the_system(self, good, answering, code, error, seconds):
        """As on Windows: then the process that asks watches alone."""
        answering(code, before="child.resource = None")
        with pytest.raises(error):
            ask("hdf5.tree", good, limits=Limits(seconds=seconds, waiting=24.0, memory=2**28))

    def test_what_an_earlier_file_did_is_not_the_next_one_s_fault(self, good, answering):
        """A process that has read other files crashes: the file is tried again in a fresh one."""
        answering(
            "import os; from pathlib import Path; mark = Path(path + '.mark')\n"
            "    if mark.exists() and mark.read_text() == str(os.getpid()): os.abort()\n"
            "    mark.write_text(str(os.getpid())); return {'read': True}"
        )
        assert ask("hdf5.tree", good) == {"read": True}
        assert ask("hdf5.tree", good) == {"read": True}

    def test_an_interrupted_question_is_not_answered_later(self, good, monkeypatch):
        ask("hdf5.tree", good)
        receive = wire.receive

        def interrupted(stream):
            monkeypatch.setattr(wire, "receive", receive)
            raise KeyboardInterrupt

        monkeypatch.setattr(wire, "receive", interrupted)
        with pytest.raises(KeyboardInterrupt):
            ask("hdf5.tree", good)
        assert_reads(good)

    def test_no_process_can_be_started(self, good, monkeypatch):
        process._end()
        monkeypatch.setattr(sys, "executable", "/no/such/python")
        with refusing(ResourceError, "worker", "process that reads files"):
            ask("hdf5.tree", good)

    def test_one_that_ends_at_once(self, good, answering, monkeypatch):
        answering("pass")
        monkeypatch.setattr(process, "COMMAND", ["-c", "raise SystemExit(3)"])
        with refusing(ResourceError, "worker", "process that reads files", "exit code 3"):
            ask("hdf5.tree", good)

    def test_a_missing_file_gives_the_usual_error(self, tmp_path):
        with pytest.raises(FileNotFoundError):
            ask("hdf5.tree", tmp_path / "no.h5")


class TestLife:
    def test_one_process_serves_many_files(self, good):
        ask("hdf5.tree", good)
        first = process._readers[0].process.pid
        with within(1.0):
            for _ in range(100):
                assert_reads(good)
        assert process._readers[0].process.pid == first

    def test_threads_take_turns(self, good):
        with ThreadPoolExecutor(8) as pool:
            list(pool.map(lambda _: assert_reads(good), range(64)))

    @pytest.mark.skipif(not hasattr(os, "fork"), reason="the system has no fork")
    @pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
    def test_after_a_fork_each_has_its_own(self, good):
        ask("hdf5.tree", good)
        before = process._readers[0].process.pid
        pids = []
        context = multiprocessing.get_context("fork")
        with process._turn:  # held by another thread, for example, while the fork happens
            there = context.SimpleQueue()
            forked = context.Process(target=_asked_there, args=(good, there))
            forked.start()
        pids.append(there.get())
        forked.join(30)
        assert forked.exitcode == 0
        assert pids[0] != before
        assert_reads(good)
        assert process._readers[0].process.pid == before

    def test_in_a_script_without_a_main_guard_and_nothing_is_left(self, good, tmp_path):
        script = tmp_path / "script.py"
        script.write_text(
            "from pathlib import Path\n"
            "import haptonic.foreign.process as process\n"
            f"process.ask('hdf5.tree', Path({str(good)!r}))\n"
            "print(process._readers[0].process.pid)\n"
        )
        # a module of the same name as a library beside the data must not be taken for it
        (tmp_path / "numpy.py").write_text("raise SystemExit('not this one')")
        home = os.path.dirname(os.path.dirname(haptonic.__file__))
        env = os.environ | {"PYTHONPATH": home}
        done = subprocess.run(
            [sys.executable, "-P", str(script)], capture_output=True, text=True, cwd=tmp_path, env=env
        )
        assert (done.returncode, done.stderr) == (0, "")
        assert not psutil.pid_exists(int(done.stdout))

    def test_it_ends_with_the_one_that_asks_however_that_ends(self, good):
        code = (
            "import os, signal, sys\nfrom pathlib import Path\nimport haptonic.foreign.process as process\n"
            f"process.ask('hdf5.tree', Path({str(good)!r}))\n"
            "print(process._readers[0].process.pid, flush=True)\nos.kill(os.getpid(), signal.SIGKILL)"
        )
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
        deadline = time.monotonic() + 10
        while psutil.pid_exists(int(done.stdout)) and time.monotonic() < deadline:
            time.sleep(0.05)
        assert (
            not psutil.pid_exists(int(done.stdout)) or psutil.Process(int(done.stdout)).status() == "zombie"
        )


def _runs(pid):
    try:
        return psutil.Process(pid).status() != psutil.STATUS_ZOMBIE
    except psutil.NoSuchProcess:
        return False


def _asked_there(path, there):
    assert_reads(path)
    there.put(process._readers[0].process.pid)
    process._end()
