"""Paths from users: whatever they name, the answer is five parts, and nothing waits for ever."""

from __future__ import annotations

import os
import signal
import socket
from pathlib import Path

import pytest
from matplotlib.figure import Figure

from each import each
from haptonic import load, plots, read_scan
from haptonic.analyses import named
from haptonic.analyses.friction import compute_friction
from haptonic.analyses.simulate_friction import read_amplitudes
from haptonic.cli.running import folder_for
from haptonic.errors import HaptonicError
from haptonic.friction.recordings import Sensor, read_calibration
from haptonic.friction.signals import Rules
from haptonic.paths import source, target
from haptonic.response import read
from haptonic.results.common import refuse_taken
from haptonic.store import Store
from haptonic.study import load_trials

SECONDS = 20  # a pipe that nobody writes to would take for ever

READERS = {
    "load": load,
    "load_trials": load_trials,
    "read_scan": read_scan,
    "response": read,
    "friction": lambda path: compute_friction(path, Sensor(), Rules()),
    "amplitudes": read_amplitudes,
}
NO_PATHS = {
    "none": None,
    "number": 5,
    "bytes": b"study.toml",
    "list": ["study.toml"],
    "empty": "",
    "nul": "a\0b",
}
NO_NAMES = {
    "nobody": "~nosuchuser/x",
    "long": "a" * 300,
    "long part": f"here/{'a' * 300}/x",
    "endless": "a/" * 3000,
}
ODD = ("pipe", "socket", "zero", "null", "memory", "loop")


@pytest.fixture(autouse=True)
def soon():
    def late(*_):
        raise TimeoutError("it waits")

    before = signal.signal(signal.SIGALRM, late)
    signal.alarm(SECONDS)
    yield
    signal.alarm(0)
    signal.signal(signal.SIGALRM, before)


def odd(kind: str, folder: Path) -> Path:
    """Something that has a path and is no file."""
    path = folder / f"{kind}.toml"
    match kind:
        case "pipe":
            os.mkfifo(path)
        case "socket":
            with socket.socket(socket.AF_UNIX) as listener:
                listener.bind(str(path))
        case "loop":
            path.symlink_to(path)
        case _:
            return Path({"zero": "/dev/zero", "null": "/dev/null", "memory": "/proc/self/mem"}[kind])
    return path


def five_parts_of(call, *arguments):
    with pytest.raises(HaptonicError) as error:
        call(*arguments)
    assert all(part.strip() for part in error.value.parts().values())
    return error.value


@pytest.mark.parametrize("kind", ODD)
@pytest.mark.parametrize("reader", READERS)
def test_what_is_no_file_is_refused(reader, kind, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # the name of a socket has to be short
    five_parts_of(READERS[reader], odd(kind, tmp_path))


@pytest.mark.parametrize("kind", ODD)
def test_a_file_inside_a_folder_is_looked_at_like_any_other(kind, tmp_path, monkeypatch):
    """A point of a scan is left out with its reason; a calibration is refused."""
    monkeypatch.chdir(tmp_path)
    source = odd(kind, tmp_path)
    (tmp_path / "point.csv").symlink_to(source)
    (tmp_path / "good.csv").write_text("frequency,real,imaginary\n1e3,1,0\n2e3,1,1\n")
    (tmp_path / "geometry.csv").write_text("file,x,y\npoint.csv,0,0\ngood.csv,1e-3,0\n")
    report = read_scan(tmp_path).report
    assert report.points == 1
    assert [part.what for part in report.dropped] == ["file point.csv"]
    assert five_parts_of(read_calibration, tmp_path / "point.csv").argument == "trials.sensor.calibration"


@each("kind", NO_PATHS | NO_NAMES)
@each("reader", READERS)
def test_what_is_no_path_is_refused(reader, kind):
    five_parts_of(READERS[reader], (NO_PATHS | NO_NAMES)[kind])


@pytest.mark.parametrize("kind", NO_PATHS | NO_NAMES)
def test_nothing_is_written_to_what_is_no_path(kind):
    given = (NO_PATHS | NO_NAMES)[kind]
    five_parts_of(target, given)
    five_parts_of(plots.save, Figure(), given, "plan")


@pytest.mark.parametrize("kind", NO_NAMES)
def test_an_impossible_store_is_refused(kind, monkeypatch):
    monkeypatch.setenv("HAPTONIC_STORE", NO_NAMES[kind])
    assert five_parts_of(Store.default).argument == "HAPTONIC_STORE"


@pytest.mark.parametrize("kind", NO_NAMES)
def test_an_impossible_output_folder_is_refused_before_the_work(kind):
    def out():
        folder = folder_for(named("bands"), Path("study.toml"), Path(NO_NAMES[kind]), False)
        refuse_taken(folder, ["bands.nc"], overwrite=False)

    five_parts_of(out)


def test_a_study_with_the_longest_name_has_a_folder_or_five_parts():
    five_parts_of(folder_for, named("bands"), Path(f"{'a' * 250}.toml"), None, False)


def test_good_paths_are_paths(tmp_path, monkeypatch):
    file = tmp_path / "s.toml"
    file.write_text("x")
    assert source(str(file), "study") == source(file, "study") == file
    assert source(tmp_path, "folder") == tmp_path
    assert source(tmp_path / "missing", "study") == tmp_path / "missing"
    monkeypatch.setenv("HOME", str(tmp_path))
    assert target("~/out") == tmp_path / "out"
    monkeypatch.chdir(tmp_path)
    Path("~nosuchuser").mkdir()
    assert target("~nosuchuser") == Path("~nosuchuser")
