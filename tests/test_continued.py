"""A long run of tests in several sittings."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

TESTS = """
from pathlib import Path
def test_sound(): pass
def test_repaired(): assert Path("repaired").exists()
"""


def ran(folder, workers):
    command = [sys.executable, "-m", "pytest", "-q", "-p", "continued", "-p", "no:cacheprovider"]
    done = subprocess.run(
        [*command, "-n", workers, "--continued", "passed", "test_two.py"],
        cwd=folder, capture_output=True, text=True,
        env={**os.environ, "PYTHONPATH": str(Path(__file__).parent)},
    )  # fmt: skip
    return done.stdout.splitlines()[-1].partition(" in ")[0]


# a worker process does not report what it leaves out
@pytest.mark.parametrize(("workers", "second"), [("0", "1 passed, 1 deselected"), ("2", "1 passed")])
def test_what_passed_is_left_out_until_all_have_passed(tmp_path, workers, second):
    (tmp_path / "test_two.py").write_text(TESTS)
    assert ran(tmp_path, workers) == "1 failed, 1 passed"
    assert (tmp_path / "passed").read_text() == "test_two.py::test_sound\n"
    (tmp_path / "repaired").touch()
    assert ran(tmp_path, workers) == second
    assert ran(tmp_path, workers) == "2 passed"
