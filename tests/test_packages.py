"""Packages whose names are loaded when they are asked for."""

from __future__ import annotations

import importlib
import subprocess
import sys
from pathlib import Path

import pytest

import haptonic

ROOT = Path(haptonic.__file__).parent
LAZY = sorted(
    "haptonic" + str(stub.parent)[len(str(ROOT)) :].replace("/", ".") for stub in ROOT.rglob("__init__.pyi")
)
# of which each takes a twentieth of a second or more
HEAVY = (
    "dask",
    "distributed",
    "ezdxf",
    "h5py",
    "jinja2",
    "matplotlib",
    "pandas",
    "pint",
    "scipy.linalg",
    "scipy.optimize",
    "scipy.signal",
    "scipy.spatial",
    "scipy.stats",
    "statsmodels",
    "xarray",
)
LATTICE = ROOT / "templates" / "bare_cell.toml"
SAID = f"print(*[name for name in {HEAVY} if name in sys.modules], file=sys.stderr)"


@pytest.mark.parametrize("name", LAZY)
def test_every_name_is_there_and_no_module_hides_it(name):
    package = importlib.import_module(name)
    folder = Path(package.__file__).parent
    modules = {path.stem for path in folder.iterdir()}
    assert package.__all__, "the stub lists what there is"
    for one in package.__all__:
        assert one not in modules, f"importing {name}.{one} would replace the name by the module"
        assert getattr(package, one) is not None


def ran(code: str, *arguments: str) -> set[str]:
    """Of the heavy libraries, those that a process has loaded when it ends."""
    code = f"import atexit, sys; atexit.register(lambda: {SAID})\n{code}"
    done = subprocess.run(
        [sys.executable, "-c", code, *arguments], capture_output=True, text=True, check=True
    )
    return set(done.stderr.splitlines()[-1].split())


@pytest.mark.parametrize(
    "asked", ["--help", "keys plate", "materials", "plan STUDY --out FOLDER", "bands STUDY --dry-run"]
)
def test_a_command_needs_no_library_that_only_other_commands_need(asked, tmp_path):
    """What is loaded is the same on every machine, unlike the time that it takes."""
    words = asked.replace("STUDY", str(LATTICE)).replace("FOLDER", str(tmp_path / "out")).split()
    assert ran("from haptonic.cli import main; main()", *words) <= {"pint"}  # for the units of a study


def test_every_command_knows_its_options_before_it_loads_what_computes():
    assert ran("from haptonic import analyses\nfor name in analyses.NAMES: analyses.named(name)") == set()
