"""Packages whose names are loaded when they are asked for."""

from __future__ import annotations

import importlib
import subprocess
import sys
from pathlib import Path

import pytest

import haptonic
from daily import daily

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
SAID = f"print(*[name for name in {HEAVY} if sys.modules.get(name)], file=sys.stderr)"


@pytest.mark.parametrize("name", LAZY)
def test_every_name_is_there_and_no_module_hides_it(name):
    package = importlib.import_module(name)
    folder = Path(package.__file__).parent
    modules = {path.stem for path in folder.iterdir()}
    assert package.__all__, "the stub lists what there is"
    for public in package.__all__:
        assert public not in modules, f"importing {name}.{public} would replace the name by the module"
        assert getattr(package, public) is not None


def ran(code: str, *arguments: str) -> set[str]:
    """The heavy libraries that a process has loaded when it ends."""
    code = f"import atexit, sys; atexit.register(lambda: {SAID})\n{code}"
    done = subprocess.run(
        [sys.executable, "-c", code, *arguments], capture_output=True, text=True, check=True
    )
    return set(done.stderr.splitlines()[-1].split())


@pytest.mark.parametrize(
    "asked",
    daily(
        ["--help", "keys plate", "materials", "plan STUDY --out FOLDER", "bands STUDY --dry-run"],
        "--help",
        "plan STUDY --out FOLDER",
        "bands STUDY --dry-run",
    ),
)
def test_a_command_needs_no_library_that_only_other_commands_need(asked, tmp_path):
    """What is loaded is the same on every machine, unlike the time that it takes."""
    words = asked.replace("STUDY", str(LATTICE)).replace("FOLDER", str(tmp_path / "out")).split()
    assert ran("from haptonic.cli import main; main()", *words) <= {"pint"}  # for the units of a study


@pytest.mark.nightly
def test_the_program_does_not_load_what_only_xarray_asks_for(tmp_path):
    """Dask, which this environment has, and pint, until somebody needs them."""
    study = str(LATTICE.with_name("touchpad.toml"))
    loaded = ran("from haptonic.cli import main; main()", "protocol", study, "--out", str(tmp_path / "out"))
    assert {"matplotlib", "xarray"} <= loaded
    assert not {"dask", "distributed", "pint"} & loaded


def test_what_was_left_out_is_admitted():
    done = (
        "from haptonic.later import leave_out; leave_out(); from haptonic.units import to_si; "
        "from haptonic import jobs; jobs.CONNECT_SECONDS = 0.5; from haptonic.jobs import _remote_workers\n"
        "assert to_si('1 inch', 'm', 'pitch') == 0.0254\n"
        "try: _remote_workers('tcp://127.0.0.1:1').__enter__()\n"
        "except Exception as error: assert 'not running' in str(error), error"
    )
    assert {"dask", "distributed", "pint"} <= ran(done)


def test_no_installed_package_is_searched_for_plug_ins_of_pydantic():
    ran(
        "import importlib.metadata as metadata\n"
        "from haptonic.later import leave_out; leave_out()\n"
        "metadata.distributions = None  # a search would call it\n"
        "import haptonic.study.schema"
    )


def test_every_command_knows_its_options_before_it_loads_what_computes():
    assert ran("from haptonic import analyses\nfor name in analyses.NAMES: analyses.named(name)") == set()
