"""A file that cannot be written is an error after which the process goes on and ends as it should."""

from __future__ import annotations

import os
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

from daily import daily
from quick import QUICK_CELL

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="there is no limit on file sizes there")

# As a disk that is full: a limit on the size of files fails the same writes, with another number.
SCRIPT = """
    import resource, signal, sys
    from functools import partial
    from pathlib import Path
    import numpy as np, xarray as xr
    from haptonic.errors import ResourceError
    from haptonic.friction.simulation.files import write_h5
    from haptonic.response import FrequencyResponse, Reference, write
    from haptonic.results import write_netcdf
    from haptonic.atomic import write_atomically
    from haptonic.vibrometry.exports import write_mat_records
    from haptonic.vibrometry.readers.hdf5 import write_records
    from haptonic.vibrometry.records import InMemory, TimeScan

    rng = np.random.default_rng(0)
    samples = rng.standard_normal((12, 3, 600)).astype(np.float32)
    names, x = tuple(map(str, range(12))), np.arange(12.0)
    records = TimeScan(InMemory(samples, samples), names, x, 0 * x, 3, 600, 200e3, Reference("A1", "V"))
    numbers = rng.standard_normal((50, 40, 3)) + 0j
    response = FrequencyResponse.of(
        numbers[..., :1].astype(np.complex64), frequency=np.arange(50) + 1.0, x=np.arange(40.0),
        y=np.zeros(40), reference="A1, V", origin="simulated", region=[""] * 40, title="", inputs={},
    )
    sets = {f"v{k}": ("n", rng.standard_normal(300)) for k in range(40)}
    writers = {
        "dataset.nc": partial(write_netcdf, xr.Dataset(sets, attrs={"a": "b"})),
        "response.nc": partial(write, response),
        "records.h5": partial(write_records, records),
        "records.mat": partial(write_mat_records, records),
        "forces.h5": partial(write_h5, {name: rng.standard_normal(4000) for name in ("time", "Fx", "Fz")}),
    }
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    folder, limit = Path(sys.argv[1]), int(sys.argv[2])
    resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
    for name, writer in writers.items():
        try:
            write_atomically(folder / name, writer)
            print("whole", name)
        except ResourceError as error:
            assert not (folder / name).exists()
            print(error.cause)
    print(*folder.iterdir())
"""


@pytest.mark.parametrize("limit", daily([0, 1, 700, 3000, 20_000, 70_000], 0, 70_000))
def test_hdf5_files_that_do_not_fit(tmp_path: Path, limit: int) -> None:
    script = tmp_path / "script.py"
    script.write_text(textwrap.dedent(SCRIPT))
    (tmp_path / "out").mkdir()
    done = subprocess.run(
        [sys.executable, str(script), str(tmp_path / "out"), str(limit)],
        capture_output=True, text=True, timeout=60, check=False,
    )  # fmt: skip
    assert done.stderr == ""
    assert done.returncode == 0
    assert done.stdout.count("the file is larger than the system lets you write") >= (
        5 if limit < 5000 else 1
    )
    assert ".haptonic" not in done.stdout


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no device that is always full")
@pytest.mark.parametrize(
    "words", daily(["keys", "materials --json", "--version", "--help"], "keys", "--version")
)
def test_a_full_disk_behind_standard_output_is_reported(words):
    with Path("/dev/full").open("w") as full:
        done = subprocess.run(
            [sys.executable, "-m", "haptonic", *words.split()],
            stdout=full, stderr=subprocess.PIPE, text=True, check=False,
        )  # fmt: skip
    assert done.returncode == 2
    assert "Traceback" not in done.stderr
    assert done.stderr.startswith("standard output: got ")
    assert "code: unwritable" in done.stderr


@pytest.mark.parametrize("read", ["nothing", "disk"])
def test_files_are_written_if_nobody_reads_the_answer(tmp_path, read):
    """As behind ``| head``, or on a disk that has room for the files only."""
    (tmp_path / "my.toml").write_text(QUICK_CELL, "utf-8")
    command = [sys.executable, "-m", "haptonic", "bands", "my.toml", "--out", "out"]
    if read == "nothing":
        reader, writer = os.pipe()
        os.close(reader)
    else:
        writer = os.open("/dev/full", os.O_WRONLY)
    done = subprocess.run(
        command, stdout=writer, stderr=subprocess.PIPE, text=True, cwd=tmp_path, check=False
    )
    os.close(writer)
    assert (tmp_path / "out").is_dir()
    assert done.returncode == (0 if read == "nothing" else 2)
    assert ("code: unwritable" in done.stderr) == (read == "disk")
    assert "Traceback" not in done.stderr


def test_a_terminal_without_a_letter_shows_another(monkeypatch):
    monkeypatch.setenv("PYTHONIOENCODING", "ascii")
    done = subprocess.run(
        [sys.executable, "-m", "haptonic", "keys", "touch"], capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert "?m" in done.stdout
