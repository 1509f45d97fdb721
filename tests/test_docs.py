"""Whatever the documents print is executed."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from daily import daily
from haptonic.analyses import NAMES
from haptonic.cli import commands
from haptonic.study import load, templates

ROOT = Path(__file__).parent.parent
BLOCK = re.compile(r"```(\w+)\n(.*?)```", re.DOTALL)


def blocks(document: str, language: str) -> list[str]:
    texts = [text for kind, text in BLOCK.findall((ROOT / document).read_text("utf-8")) if kind == language]
    assert texts, f"{document} has no {language} block"
    return texts


def new_studies(document: str) -> dict[str, str]:
    """Template of each file that the page's commands write with `haptonic new TEMPLATE FILE`."""
    text = (ROOT / document).read_text("utf-8")
    return {
        file: name for name, file in re.findall(r"^haptonic new ([\w-]+) (\S+\.toml)", text, re.MULTILINE)
    }


def write_studies(document: str) -> None:
    """Write these studies into the working directory, as their reader does."""
    for file, name in new_studies(document).items():
        Path(file).write_text(templates()[name], "utf-8")


PRINTED = {
    "README.md": "Complete gap from 42.19 ± 0.03 to 49.53 ± 0.04 kHz, between bands 6 and 7.\n",
    "docs/channels.md": "['Fz'] N 1000.0 0.5\n",
    "docs/design.md": "['cell.pillar.diameter', 'cell.pillar.height']\n",
    "docs/export.md": "",
    "docs/mirror.md": "56.9 kHz, 15 dB per row\n",
    "docs/plate.md": "180 pillars on 127 x 140 mm\n",
    "docs/scan.md": "simulated: 280 points, contrast within 0.5 dB: True\n",
    "docs/start.md": "Complete gap from 42.19 ± 0.05 to 49.54 ± 0.07 kHz, between bands 6 and 7.\n",
    "docs/verdict.md": "material.youngs_modulus = 7e+10\nplate.loss_factor = 0.002\n"
    "plate.actuator[1].bond.thickness = 5e-05\n",
}


@pytest.mark.parametrize("document", daily(PRINTED, *PRINTED.keys() - {"docs/scan.md"}))
def test_python_in_the_pages_prints_the_shown_output(document, tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("HAPTONIC_STORE", str(tmp_path / "store"))
    monkeypatch.chdir(tmp_path)
    write_studies(document)
    for text in blocks(document, "python"):
        exec(compile(text, document, "exec"), {})
    assert capsys.readouterr().out == PRINTED[document]


@pytest.mark.parametrize("document", PRINTED)
def test_the_printed_commands_exist(document):
    lines = [line for text in blocks(document, "sh") for line in text.splitlines() if line]
    targets = set(re.findall(r"^(\w+):", (ROOT / "Makefile").read_text(), re.MULTILINE))
    known = {name.split()[0] for name in [*NAMES, *commands.NAMES]}
    for line in lines:
        program, what, *_ = shlex.split(line, comments=True)
        assert what in (targets if program == "make" else known), line


USER_PAGES = sorted(
    f"docs/{name}.md"
    for caption, names in re.findall(
        r":caption: ([\w -]+)\n.*?\n\n(.*?)```", (ROOT / "docs/index.md").read_text("utf-8"), re.DOTALL
    )
    if caption != "Developers"
    for name in names.split()
)


@pytest.mark.parametrize("document", USER_PAGES)
def test_a_reader_of_a_page_has_the_studies_that_it_names(document):
    """An installation has no folder of studies: a page writes its studies itself, or takes the reader's."""
    page = (ROOT / document).read_text("utf-8")
    assert not re.findall(r"\bstudies/\S*", page)
    theirs = {*new_studies(document), "my.toml", "other.toml", "study.toml"}
    for line in re.findall(r"^haptonic .*", page, re.MULTILINE):
        _program, what, *rest = shlex.split(line, comments=True)
        files = {Path(word).name for word in rest if word.endswith(".toml") and what != "new"}
        assert files <= theirs, line


def test_pictures_of_the_pages_show_no_formula_s_code():
    pictures = sorted((ROOT / "docs").rglob("images/*.svg"))
    assert pictures
    assert not [picture.name for picture in pictures if "mathdefault" in picture.read_text("utf-8")]


def test_the_images_and_pages_that_documents_name_exist():
    for document in [ROOT / "README.md", *(ROOT / "docs").glob("*.md")]:
        for target in re.findall(r"\]\((?!https?:)([^)#]+)\)", document.read_text("utf-8")):
            assert (document.parent / target).exists(), f"{document.name}: {target}"


def test_every_image_is_shown_by_a_page_and_drawn_by_a_script():
    pages = "".join(page.read_text("utf-8") for page in [ROOT / "README.md", *(ROOT / "docs").glob("*.md")])
    drawn = "".join(
        (ROOT / script).read_text("utf-8") for script in ("docs/draw_figures.py", "benchmarks/render.py")
    )
    for stem in {image.stem for image in (ROOT / "docs" / "images").iterdir()}:
        assert f"images/{stem}." in pages, stem
        name = re.sub("^badge-|-page$", "", stem)  # scripts write "{name}-page.png"
        assert f'"{name}"' in drawn or stem in drawn or stem.startswith("verify-"), stem


def test_the_reference_study_loads_without_a_warning():
    study = load(ROOT / "studies" / "touchpad.toml")
    assert study.carrier == 60e3
    assert len(study.sweep_settings) == 2
