"""An analysis is one file and one line: a toy has its command, its help, its JSON, its method, its files."""

from __future__ import annotations

import json
import re
import sys

import pytest
from typer.testing import CliRunner

import haptonic
import toy
from haptonic.analyses import NAMES
from haptonic.cli.app import app
from haptonic.errors import StudyError
from haptonic.studio.answers import answer_of
from haptonic.studio.offers import as_command, offered, offers
from haptonic.study.computing import AnalysisMethod
from quick import QUICK_CELL

WIDE = {"COLUMNS": "200", "NO_COLOR": "1"}
# Bands of a plain plate and no more: other chapters of the report are tested elsewhere.
BARE = (
    QUICK_CELL.split("[cell.pillar]")[0].replace('carrier = "60 kHz"\n', "")
    + "[bands]\ncount = 2\npoints = 8\n"
)


@pytest.fixture
def added(monkeypatch):
    """The one line."""
    studies = haptonic.Study  # has methods for the names that there are when it is imported
    monkeypatch.setitem(sys.modules, "haptonic.analyses.toy", toy)
    monkeypatch.setitem(NAMES, "toy", "Count, as a toy does.")
    monkeypatch.setattr(studies, "toy", AnalysisMethod("toy", studies.run), raising=False)
    offers.cache_clear()
    yield
    offers.cache_clear()


def ran(*words):
    done = CliRunner().invoke(app, list(map(str, words)), env=WIDE, catch_exceptions=False)
    assert done.exit_code == 0, done.output
    return done.stdout


@pytest.mark.usefixtures("added")
class TestAddedAnalysis:
    def test_it_has_a_command_with_help_of_its_own(self):
        assert "Count, as a toy does." in ran("--help")
        output = ran("toy", "--help")
        assert all(
            words in output for words in ("--number", "How far to count.", "LENGTH", "--out", "--json")
        )

    def test_it_answers_people_and_machines(self, study, tmp_path):
        out = tmp_path / "out"
        output = ran("toy", study(), "--number", 3, "--length", "2 mm", "--out", out)
        assert "It counts to 3." in output
        assert "way / mm" in output
        assert "4.00" in output
        assert {path.name for path in out.iterdir()} == {"toy.nc", "toy.svg", "toy.png"}
        answer = json.loads(ran("toy", study(), "--length", "2 mm", "--json"))
        assert answer == {
            "summary": ["It counts to 2."], "number": 2, "length_m": 2e-3, "steps": {"number": [0, 1]},
            "warnings": [],
        }  # fmt: skip

    def test_dry_run_and_plan_print_cost_of_a_new_analysis(self, study):
        assert json.loads(ran("toy", study(), "--number", 4, "--dry-run", "--json"))["processor_s"] == 8.0
        assert json.loads(ran("plan", study(), "--json"))["data"]["processor_time_s"]["toy"] == 4.0

    def test_the_studio_offers_it_with_options_and_answer(self, study):
        (toys,) = [offer for offer in offers() if offer["name"] == "toy"]
        assert toys["help"] == "Count, as a toy does."
        assert [(each["name"], each["form"], each["unit"], each["default"]) for each in toys["options"]] == [
            ("number", "int", "", 2), ("length", "text", "m", 1e-3),
        ]  # fmt: skip
        assert as_command(offered("toy"), "my.toml", {"number": 3}) == "haptonic toy my.toml --number 3"
        answer, view = answer_of(haptonic.load(study()).toy())
        assert answer["summary"] == ["It counts to 2."]
        assert [picture["name"] for picture in answer["pictures"]] == ["toy"]
        assert view is None

    def test_it_refuses_to_overwrite(self, study, tmp_path):
        out = tmp_path / "out"
        ran("toy", study(), "--out", out)
        again = CliRunner().invoke(app, ["toy", str(study()), "--out", str(out)], env=WIDE)
        assert again.exit_code == 2
        ran("toy", study(), "--out", out, "--overwrite")

    def test_a_study_has_it_as_a_method(self, study):
        loaded = haptonic.load(study())
        result = loaded.toy(length="3 mm")
        assert (result.number, result.length) == (2, 3e-3)
        assert repr(result) == "<Toy: It counts to 2.>"
        assert "<table>" in result._repr_html_()
        assert re.search(
            r'<img src="data:image/png;base64,[^"]{100,}" alt="Simulated numbers."', result._repr_html_()
        )
        assert result.to_dataframe()["way (m)"].tolist() == [0.0, 3e-3]
        assert result.tables()[0].written("csv").splitlines()[0] == "number,way (m)"
        assert loaded.run("toy", number=5).number == 5
        assert "toy" in dir(loaded)

    def test_an_option_that_it_has_not_is_refused_with_the_nearest(self, study):
        with pytest.raises(StudyError) as caught:
            haptonic.load(study()).toy(nmber=3)
        assert "number" in caught.value.next_step
        assert all(caught.value.parts().values())

    @pytest.mark.usefixtures("empty_pictures")
    def test_it_is_in_the_report(self, tmp_path):
        out = tmp_path / "out"
        (tmp_path / "bare.toml").write_text(BARE, "utf-8")
        ran("reproduce", tmp_path / "bare.toml", "--out", out)
        page = (out / "report.html").read_text()
        assert "A toy" in page
        assert "It counts to 2." in page


def test_without_the_line_there_is_none(study):
    assert CliRunner().invoke(app, ["toy", str(study())], env=WIDE).exit_code == 2
    with pytest.raises(AttributeError):
        _ = haptonic.load(study()).toy
