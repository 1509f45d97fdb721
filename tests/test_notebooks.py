"""Pages of the site that are notebooks: cells run, pictures have words, reference values their source."""

from __future__ import annotations

import ast
import html
import json
import re
import sys
import tomllib
from pathlib import Path
from types import SimpleNamespace

import pytest

import haptonic
from haptonic import progress
from haptonic.plots.style import Drawing
from haptonic.study import loads
from haptonic.study.template import templates
from quick import QUICK_CELL
from test_docs import PRINTED

DOCS = Path(__file__).parents[1] / "docs"
NOTEBOOKS = {
    page.stem: page.read_text("utf-8")
    for page in sorted(DOCS.glob("*.md"))
    if "file_format: mystnb" in page.read_text("utf-8")
}
CELL = re.compile(r"^```\{code-cell\} python\n(?:---\n(.*?)---\n)?(.*?)^```$", re.DOTALL | re.MULTILINE)


def cells(name: str) -> list[tuple[str, str]]:
    """(options, code) of each."""
    return [match.groups("") for match in CELL.finditer(NOTEBOOKS[name])]


def run(name: str, codes: list[str]) -> dict[str, object]:
    """All of them in one namespace, as a notebook does; a picture must be shown without magic."""
    space: dict[str, object] = {}
    for code in codes:
        tree = ast.parse(code)
        shown = ast.Expression(tree.body.pop().value) if isinstance(tree.body[-1], ast.Expr) else None
        exec(compile(tree, name, "exec"), space)
        if shown is not None:
            value = eval(compile(shown, name, "eval"), space)
            assert not hasattr(value, "savefig") or isinstance(value, Drawing), name
    return space


@pytest.fixture(autouse=True)
def _elsewhere(tmp_path, monkeypatch):
    monkeypatch.setenv("HAPTONIC_STORE", str(tmp_path / "store"))
    monkeypatch.chdir(tmp_path)


@pytest.mark.nightly
def test_the_first_steps_of_the_tutorial(capsys):
    text = NOTEBOOKS["tutorial"].split("## 3.")[0]
    space = run("tutorial", [match[2] for match in CELL.finditer(text)])
    assert space["bands"].gaps[0].holds(46e3)
    apart = re.search(r"([\d.]+) % apart on average", space["beside"].summary()[0])
    assert float(apart[1]) == pytest.approx(1.0, abs=0.05)  # both are within 0.5 % of the truth
    assert "12 mm: 42.2 to 49.5 kHz, carrier inside: True" in capsys.readouterr().out


def test_the_tables_of_the_tutorial_are_the_study_of_its_cells():
    """Commands that ended a step had failed, for nothing had written what they need."""
    (tables,) = re.findall(r"^```toml\n(.*?)^```", NOTEBOOKS["tutorial"], re.DOTALL | re.MULTILINE)
    written = loads(f"{templates()['bare-cell']}\n{tables}")
    space: dict[str, object] = {"hp": haptonic}
    for _, code in cells("tutorial"):
        for line in ast.parse(code).body:
            if isinstance(line, ast.Assign) and ast.unparse(line.value).startswith("hp.Study("):
                exec(ast.unparse(line), space)
    same, other = (tomllib.loads(study.to_toml()) for study in (written, space["study"]))
    for table in ("carrier", "cell", "plate", "touch", "scan", "protocol"):
        assert same[table] == other[table]


def test_the_first_page_has_the_code_and_the_answer_of_the_readme():
    """`test_docs.py` executes that of the README and compares its answer."""
    answers, codes = [], []
    for page in (DOCS / "index.md", DOCS.parent / "README.md"):
        text = page.read_text("utf-8")
        answers += re.findall(r"^\*(Complete gap.*)\*$", text, re.MULTILINE)
        codes += re.findall(r"```python\n(.*?)```", text, re.DOTALL)
    assert codes[1] == codes[0].replace("study.bands()", "print(study.bands().summary()[0])")
    assert answers == [PRINTED["README.md"].strip()] * 2


@pytest.mark.nightly
def test_every_layer_by_itself(capsys):
    run("library", [code for _, code in cells("library")])
    printed = capsys.readouterr().out
    assert "complete gap from 52.5 to 60.2 kHz" in printed
    assert "280 points, 61 frequencies, simulated" in printed
    assert "the difference is significant across participants" in printed


@pytest.mark.nightly
@pytest.mark.parametrize("name", ["gallery", "tutorial"])
@pytest.mark.filterwarnings("ignore::haptonic.HaptonicWarning")
def test_every_cell(name):
    assert run(name, [code for _, code in cells(name)])


@pytest.mark.nightly
def test_differences_on_the_page_of_validation_are_within_the_error_estimates():
    space = run("validation", [code for _, code in cells("validation")])
    assert len(space["rows"]) == 6
    for solid, where, _, difference, estimate in space["rows"]:
        assert float(difference) < (float(estimate) if estimate else 4e-4), (solid, where)


def test_reference_values_on_the_page_of_validation_are_those_of_the_tests():
    values = {}
    for _, code in cells("validation"):
        for line in ast.parse(code).body:
            if (
                isinstance(line, ast.Assign)
                and line.targets[0].id.isupper()
                and line.targets[0].id != "PHASES"
            ):
                values[line.targets[0].id] = ast.literal_eval(line.value)
    data = {
        name: json.loads((DOCS.parent / "tests/data" / f"{name}.json").read_text("utf-8"))
        for name in ("reference_cell", "empty_lattice", "simply_supported_plate")
    }
    cell, waves = data["reference_cell"], data["empty_lattice"]["points"]
    assert values["CELL"] == {here: cell[there][:10] for here, there in zip("ΓXM", "GXM", strict=True)}
    for here, there in (("Γ", "Gamma"), ("middle of Γ-X", "G-X mid")):
        assert values["PLATE_WAVES"][here] == [wave["hz"] for wave in waves[there]][:11]
    assert values["THICK_PLATE"] == [mode["hz"] for mode in data["simply_supported_plate"]["modes"]]


def test_the_gallery_is_one():
    assert sum("alt:" in options for options, _ in cells("gallery")) >= 15


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_every_picture_has_words_of_its_own(name):
    pictures = [
        (options, code) for options, code in cells(name) if re.search(r"plot\([^\n]*\)\Z", code.strip())
    ]
    words = [re.search(r"alt: (.*)", options)[1] for options, _ in pictures]
    assert all(len(text) > 40 for text in words), "what would somebody miss who does not see it?"
    assert len(set(words)) == len(words)


def test_a_notebook_shows_how_far_long_work_is_and_nothing_stays(monkeypatch):
    shown: list[dict[str, str]] = []
    line = SimpleNamespace(update=lambda data, raw: shown.append(data))

    def display(data, raw, display_id):
        shown.append(data)
        return line

    kernel = SimpleNamespace(kernel=object())
    notebook = SimpleNamespace(get_ipython=lambda: kernel, display=SimpleNamespace(display=display))

    def texts_after(*steps: tuple[object, ...]) -> list[str]:
        with progress.in_notebook("sweep") as update:
            for step in steps:
                update(*step)
        return [data["text/plain"] for data in shown]

    assert texts_after((1, 8)) == []  # no notebook
    monkeypatch.setitem(sys.modules, "IPython", notebook)
    assert texts_after((1, 8)) == []  # done in a moment
    monkeypatch.setattr(progress, "PATIENCE", 0.0)
    monkeypatch.setattr(progress, "PAUSE", 0.0)
    assert texts_after((0, 0, "<b>"), (3, 8)) == ["sweep <b>", "sweep 3 of 8", ""]
    assert "&lt;b&gt;" in shown[0]["text/html"]
    assert 'value="3" max="8"' in shown[1]["text/html"]


def test_a_study_shows_itself():
    study = loads(QUICK_CELL)
    assert len(repr(study)) < 200
    assert f"a square lattice in {study.cell.material.name}" in repr(study)
    seen = study._repr_html_()
    (written,) = re.findall("<pre>(.*)</pre>", seen, re.DOTALL)
    assert loads(html.unescape(written)) == study
