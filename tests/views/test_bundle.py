"""The committed programs of the pages are what their sources give."""

import filecmp
import os
import shutil
import subprocess
from pathlib import Path

import pytest

import haptonic

WEB = Path(__file__).parents[2] / "web"
BUNDLE = Path(haptonic.__file__).parent / "views/bundle"
LARGEST = 1_000_000  # bytes of all programs, compressed
IN_CI = "CI" in os.environ


@pytest.fixture(autouse=True)
def _node():
    if not IN_CI and (shutil.which("npm") is None or not (WEB / "node_modules/esbuild").is_dir()):
        pytest.skip("the packages of web/ are not installed: run npm ci there")


def run(*command: str) -> None:
    done = subprocess.run(command, cwd=WEB, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def test_sources_give_the_committed_programs(tmp_path: Path):
    run("node", "build.mjs", str(tmp_path))
    built = {path.name for path in tmp_path.iterdir()}
    assert built == {path.name for path in BUNDLE.iterdir()}
    _, changed, failed = filecmp.cmpfiles(tmp_path, BUNDLE, built, shallow=False)
    assert not changed + failed, "run make web and commit the programs"


def test_sources_have_no_error_of_type():
    run("npx", "--no-install", "tsc", "--noEmit")


def test_programs_are_small(tmp_path: Path):
    archive = shutil.make_archive(str(tmp_path / "bundle"), "gztar", BUNDLE)
    assert Path(archive).stat().st_size < LARGEST


def test_every_package_in_the_programs_has_its_licence():
    text = (BUNDLE / "LICENCES.txt").read_text("utf-8")
    for package in ("preact", "@preact/signals", "three", "uplot"):
        assert f"\n{package} " in f"\n{text}"
    assert text.count("MIT") >= 4
