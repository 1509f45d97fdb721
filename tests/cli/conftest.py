"""A study that computes in about a second: few bands, a coarse mesh chosen by hand."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from matplotlib.figure import Figure
from typer.testing import CliRunner

from haptonic.cli.app import app
from quick import QUICK_CELL
from unseen_pictures import leave_pictures_empty

QUICK = (
    QUICK_CELL
    + """
[layers]
points = 3
count = 3

[[sweep]]
vary = "cell.pillar.diameter / cell.pitch"
from = 0.4
to = 0.6
steps = 3
"""
)

PLATE = (
    "[[sweep]]",
    """
[plate]
map = \"\"\"
o11o
\"\"\"
rows = 2
loss_factor = 5e-3

[plate.tiles]
o = "lattice"
1 = "WG"

[plate.clamp]
corners = "5 mm"

[[plate.actuator]]
name = "A1"
region = "WG"
centre = ["7 mm", "7 mm"]
size = ["6 mm", "5 mm", "0.5 mm"]
material = "pzt-4"
voltage = "10 V"

[plate.response]
lowest = "2 kHz"
highest = "20 kHz"
points = 19

[[sweep]]""",
)
LOW_CARRIER = ('carrier = "60 kHz"', 'carrier = "10 kHz"')


@dataclass(frozen=True)
class Ran:
    """How a command ended."""

    code: int
    out: str
    err: str

    @property
    def json(self) -> dict[str, Any]:
        return json.loads(self.out)


@pytest.fixture(scope="session")
def haptonic(store_folder: Path) -> Callable[..., Ran]:
    """Run the program in a process of its own, with a store of its own; warnings are errors there too."""

    def run(*arguments: object, cwd: Path | None = None, store: Path | None = None) -> Ran:
        environment = {
            **os.environ,
            "HAPTONIC_STORE": str(store or store_folder),
            "COLUMNS": "200",
            "OMP_NUM_THREADS": "1",
            "NO_COLOR": "1",
        }
        done = subprocess.run(
            [sys.executable, "-W", "error", "-m", "haptonic", *map(str, arguments)],
            capture_output=True,
            text=True,
            cwd=cwd,
            env=environment,
            timeout=300,
            check=False,
        )
        return Ran(done.returncode, done.stdout, done.stderr)

    return run


@pytest.fixture(scope="session")
def inside(store_folder: Path) -> Callable[..., Ran]:
    """Run the program in this process, which takes two seconds less; no exception but an exit is caught."""

    def run(*arguments: object, store: Path | None = None) -> Ran:
        environment = {"HAPTONIC_STORE": str(store or store_folder), "COLUMNS": "200", "NO_COLOR": "1"}
        done = CliRunner().invoke(app, list(map(str, arguments)), env=environment, catch_exceptions=False)
        return Ran(done.exit_code, done.stdout, done.stderr)

    return run


@pytest.fixture
def empty_pictures(monkeypatch: pytest.MonkeyPatch) -> dict[str, Figure]:
    return leave_pictures_empty(monkeypatch)


@pytest.fixture
def study(tmp_path: Path) -> Callable[[str], Path]:
    """Write a study file: the quick one, with pieces of text replaced."""

    def write(*changes: tuple[str, str], name: str = "quick.toml") -> Path:
        text = QUICK
        for old, new in changes:
            assert old in text, old
            text = text.replace(old, new)
        path = tmp_path / name
        path.write_text(text, encoding="utf-8")
        return path

    return write


@pytest.fixture
def plated(study: Callable[..., Path]) -> Callable[..., Path]:
    """Write a study with a small plate at a low carrier, with pieces of text replaced."""
    return lambda *changes: study(LOW_CARRIER, PLATE, *changes)
