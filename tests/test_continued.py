"""A long run of tests in several sittings."""

import os
import subprocess
import sys
from pathlib import Path

TESTS = """
from pathlib import Path
def test_sound(): pass
def test_repaired(): assert Path("repaired").exists()
"""


def ran(folder):
    command = [sys.executable, "-m", "pytest", "-q", "-p", "continued", "-p", "no:cacheprovider"]
    done = subprocess.run(
        [*command, "--continued", "passed", "test_two.py"],
        cwd=folder, capture_output=True, text=True,
        env={**os.environ, "PYTHONPATH": str(Path(__file__).parent)},
    )  # fmt: skip
    return done.stdout.splitlines()[-1].partition(" in ")[0]


def test_what_passed_is_left_out_until_all_have_passed(tmp_path):
    (tmp_path / "test_two.py").write_text(TESTS)
    assert ran(tmp_path) == "1 failed, 1 passed"
    assert (tmp_path / "passed").read_text() == "test_two.py::test_sound\n"
    (tmp_path / "repaired").touch()
    assert ran(tmp_path) == "1 passed, 1 deselected"
    assert ran(tmp_path) == "2 passed"
