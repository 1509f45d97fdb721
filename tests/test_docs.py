"""Whatever the documents print is executed."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from daily import daily
from haptonic.analyses import NAMES
from haptonic.cli import commands
from haptonic.study import load

ROOT = Path(__file__).parent.parent
BLOCK = re.compile(r"```(\w+)\n(.*?)```", re.DOTALL)


def blocks(document: str, language: str) -> list[str]:
    found = [text for kind, text in BLOCK.findall((ROOT / document).read_text("utf-8")) if kind == language]
    assert found, f"{document} has no {language} block"
    return found


PRINTED = {
    "README.md": "Complete gap from 42.181 ± 0.018 to 49.52 ± 0.03 kHz, between bands 6 and 7.\n",
    "docs/channels.md": "['Fz'] N 1000.0 0.5\n",
    "docs/design.md": "['cell.pillar.diameter', 'cell.pillar.height']\n",
    "docs/export.md": "",
    "docs/mirror.md": "56.9 kHz, 15 dB per row\n",
    "docs/plate.md": "180 pillars on 127 x 140 mm\n",
    "docs/scan.md": "simulated: 280 points, contrast within 0.5 dB: True\n",
    "docs/verdict.md": "material.youngs_modulus = 7e+10\nplate.loss_factor = 0.002\n"
    "plate.actuator[1].bond.thickness = 5e-05\n",
}


@pytest.mark.parametrize("document", daily(PRINTED, *PRINTED.keys() - {"docs/scan.md"}))
def test_printed_python_runs_and_says_what_it_should(document, tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("HAPTONIC_STORE", str(tmp_path / "store"))
    monkeypatch.chdir(tmp_path)
    (tmp_path / "studies").symlink_to(ROOT / "studies")
    for text in blocks(document, "python"):
        exec(compile(text, document, "exec"), {})
    assert capsys.readouterr().out == PRINTED[document]


@pytest.mark.parametrize("document", PRINTED)
def test_the_printed_commands_exist(document):
    lines = [line for text in blocks(document, "sh") for line in text.splitlines() if line]
    targets = set(re.findall(r"^(\w+):", (ROOT / "Makefile").read_text(), re.MULTILINE))
    known = {name.split()[0] for name in [*NAMES, *commands.NAMES]}
    for line in lines:
        program, what, *rest = shlex.split(line, comments=True)
        assert what in (targets if program == "make" else known), line
        for word in rest:
            assert not word.endswith(".toml") or (ROOT / word).exists(), line


def test_pictures_of_the_pages_show_no_formula_s_code():
    pictures = sorted((ROOT / "docs").rglob("images/*.svg"))
    assert pictures
    assert not [one.name for one in pictures if "mathdefault" in one.read_text("utf-8")]


def test_the_images_and_pages_that_documents_name_exist():
    for document in [ROOT / "README.md", *(ROOT / "docs").glob("*.md")]:
        for target in re.findall(r"\]\((?!https?:)([^)#]+)\)", document.read_text("utf-8")):
            assert (document.parent / target).exists(), f"{document.name}: {target}"


def test_the_reference_study_loads_without_a_warning():
    study = load(ROOT / "studies" / "touchpad.toml")
    assert study.carrier == 60e3
    assert len(study.sweep_settings) == 2
