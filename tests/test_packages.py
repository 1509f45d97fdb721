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
HEAVY = ("matplotlib", "scipy.stats", "scipy.signal", "ezdxf", "distributed")


@pytest.mark.parametrize("name", LAZY)
def test_every_name_is_there_and_no_module_hides_it(name):
    package = importlib.import_module(name)
    folder = Path(package.__file__).parent
    modules = {path.stem for path in folder.iterdir()}
    assert package.__all__, "the stub lists what there is"
    for one in package.__all__:
        assert one not in modules, f"importing {name}.{one} would replace the name by the module"
        assert getattr(package, one) is not None


def test_a_command_starts_without_the_libraries_that_it_may_not_need():
    code = f"import sys, haptonic.cli.app; print(*[name for name in {HEAVY} if name in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == []
