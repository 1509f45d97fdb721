"""The report's chapter on friction trials, from made-up records."""

import re
from types import SimpleNamespace

import pytest
import xarray as xr

from haptonic.friction.recordings import Sensor
from haptonic.friction.signals import Rules
from haptonic.friction.words import averages
from haptonic.report import Absent, Chapter, Results, paper
from haptonic.report.chapters.trials import chapter
from haptonic.results import compute_friction
from trial_folders import made_up, written


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    folder = written(tmp_path_factory.mktemp("trials"), made_up(2, 4, 6))
    return compute_friction(folder, Sensor(), Rules(), driven="WG1")


@pytest.mark.parametrize("of_the_paper", [True, False])
def test_the_papers_numbers_stand_beside_ours_where_they_belong(result, monkeypatch, of_the_paper):
    monkeypatch.setattr(paper, "is_its_cell", lambda study: of_the_paper)
    made = chapter(Results(SimpleNamespace(), xr.Dataset(), trials=result))
    assert isinstance(made, Chapter)
    words = " ".join(made.findings)
    for share in paper.FRICTION.values():
        assert (f"the paper measured {100 * share:.0f} %" in words) == of_the_paper
    first = re.search(r"WG1: friction falls by (\d+) %", words)
    assert float(first[1]) == pytest.approx(100 * result.found.reductions["WG1"].value, abs=0.51)
    assert len(made.tables[0].rows) == 6
    assert result.found.conclusions[0] in made.findings
    assert averages() in made.paragraphs


def test_what_is_simulated_says_so(result, monkeypatch):
    monkeypatch.setattr(paper, "is_its_cell", lambda study: False)
    measured = chapter(Results(SimpleNamespace(), xr.Dataset(), trials=result))
    result.trials.attrs["origin"] = "simulated"
    simulated = chapter(Results(SimpleNamespace(), xr.Dataset(), trials=result))
    assert "Nobody was measured" in simulated.paragraphs[0]
    assert "Nobody" not in " ".join(measured.paragraphs)
    assert all(picture.caption.startswith("Simulated") for picture in simulated.pictures)


def test_without_trials_the_chapter_is_absent():
    assert isinstance(chapter(Results(SimpleNamespace(), xr.Dataset())), Absent)
