"""A process that has computed and is then forked, as multiprocessing does on Linux before Python 3.14."""

from __future__ import annotations

import os
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

from quick import QUICK_CELL

SCRIPT = """
    import multiprocessing, sys
    import haptonic
    from haptonic.bloch import bands_dataset
    from haptonic.bloch.settings import BandSettings, MeshSettings

    study = haptonic.load(sys.argv[1])

    def highest(count):
        data = bands_dataset(study.cell, BandSettings(count, 8, 2e-2, MeshSettings(2, 0)))
        return float(data["frequency"].max())

    here = highest(4)
    with multiprocessing.get_context("fork").Pool(1) as pool:
        there = pool.map_async(highest, [4]).get(60)
    print(here == there[0])
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="nothing is forked there")
def test_a_forked_child_computes_as_its_parent_did(tmp_path: Path) -> None:
    (tmp_path / "quick.toml").write_text(QUICK_CELL)
    (tmp_path / "script.py").write_text(textwrap.dedent(SCRIPT))
    done = subprocess.run(
        [sys.executable, "script.py", "quick.toml"], cwd=tmp_path, capture_output=True, text=True, timeout=99,
        check=False, env={**os.environ, "OMP_NUM_THREADS": "2", "PYTHONPATH": ":".join(sys.path)},
    )  # fmt: skip
    assert done.stdout == "True\n", done.stderr
