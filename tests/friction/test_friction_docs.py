"""Code on the pages about friction, and examples of docstrings, are executed."""

import doctest
import re
import shlex
from pathlib import Path

import pandas as pd
import pytest
from typer.testing import CliRunner

from haptonic.cli.app import app
from haptonic.friction.lubrication import parameters
from haptonic.friction.signals import measured
from haptonic.results import FrictionResult
from trial_folders import simulated, written

DOCS = Path(__file__).parents[2] / "docs"
TEXT = "\n".join((DOCS / name).read_text("utf-8") for name in ("friction.md", "trials.md"))
BIBLIOGRAPHY = DOCS / "references.bib"
SOURCE = Path(parameters.__file__).parents[1]


def test_the_printed_python_runs_and_prints_the_expected_text(capsys):
    blocks = re.findall(r"```python\n(.*?)```", TEXT, re.DOTALL)
    assert len(blocks) == 2
    for text in blocks:
        exec(compile(text, "friction", "exec"), {})
    output = capsys.readouterr().out
    assert "load_sharing [0.88 0.43 0.03]" in output
    assert "55 % against 11 %: 3.3 times the amplitude" in output
    assert "felt in time below Q = 193" in output
    assert "WG1, 3 participants: the difference is significant" in output
    assert "WG2, 3 participants: " in output


def test_the_printed_section_and_commands_run(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    tables = re.findall(r"```toml\n(.*?)```", TEXT, re.DOTALL)
    (section,) = (table for table in tables if "[trials]" in table)
    records = simulated(2, 4, 8)
    folder = written(
        tmp_path / "trials",
        records,
        change=lambda signals: signals | {"Fz": -1e3 * signals["Fz"], "Fy": 1e3 * signals["Fy"]},
    )
    (folder / "study.toml").write_text(section)
    lines = [
        line
        for block in re.findall(r"```bash\n(.*?)```", TEXT, re.DOTALL)
        for line in block.splitlines()
        if line.startswith("haptonic friction")
    ]
    assert len(lines) == 2
    monkeypatch.setattr(FrictionResult, "blocks", lambda self: ([], 0))
    for line in lines:
        words = shlex.split(line)[1:]
        done = CliRunner().invoke(app, [*words, "--workers", "0", "--overwrite"], catch_exceptions=False)
        assert done.exit_code == 0, done.stderr
    table = pd.read_csv(tmp_path / "results" / "friction" / "trials.csv")
    counts = table["excluded"].isna().to_numpy()
    assert counts.sum() == len(records) - 1  # one is declared not to count
    assert table["friction"].to_numpy()[counts] == pytest.approx(measured(records)["friction"].values[counts])


def test_the_printed_commands_run(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "studies").symlink_to(DOCS.parent / "studies")
    lines = [
        shlex.split(line, comments=True)[1:]
        for block in re.findall(r"```sh\n(.*?)```", TEXT, re.DOTALL)
        for line in block.splitlines()
    ]
    assert len(lines) >= 2
    for line in lines:
        ran = CliRunner().invoke(app, line, catch_exceptions=False)
        assert ran.exit_code == 0, ran.stderr


def test_docstring_examples():
    results = doctest.testmod(parameters)
    assert results.attempted >= 1
    assert not results.failed


def test_every_cited_source_is_in_the_bibliography():
    known = set(re.findall(r"^@\w+\{([^,]+),", BIBLIOGRAPHY.read_text("utf-8"), re.MULTILINE))
    cited = set()
    for file in SOURCE.rglob("*.py"):
        text = re.sub(r"# type: ignore.*", "", file.read_text("utf-8"))
        cited |= set(re.findall(r"\[([a-z]+[a-z-]*-[a-z0-9-]+|[a-z]+\d{4})\]", text))
    assert {"wiertlewski2016", "vezzoli2017", "daunizeau-haptics"} <= cited <= known
