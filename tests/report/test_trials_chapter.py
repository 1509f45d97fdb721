"""The report's chapter on friction trials, from simulated records."""

import re
from types import SimpleNamespace

import pytest

from haptonic.analyses.friction import compute_friction
from haptonic.friction.phrases import averages
from haptonic.friction.recordings import Sensor
from haptonic.friction.signals import Rules
from haptonic.report import Absent, Chapter, Results
from haptonic.report.chapters.trials import chapter
from haptonic.results.references import References
from trial_folders import simulated, written


@pytest.fixture(scope="module")
def result(tmp_path_factory):
    folder = written(tmp_path_factory.mktemp("trials"), simulated(2, 4, 6))
    return compute_friction(folder, Sensor(), Rules(), driven="WG1")


KNOWN = References(friction={"driven": 0.55, "idle": 0.11, "stopped": 0.8})


@pytest.mark.parametrize("known", [KNOWN, None])
def test_known_measured_numbers_are_printed_next_to_ours(result, known):
    written = chapter(Results(SimpleNamespace(), {"friction": result}, references=known))
    assert isinstance(written, Chapter)
    words = " ".join(written.findings)
    for share in KNOWN.friction.values():
        assert (f"measured: {100 * share:.0f} %" in words) == (known is not None)
    first = re.search(r"WG1: friction falls by (\d+) %", words)
    assert float(first[1]) == pytest.approx(100 * result.found.reductions["WG1"].value, abs=0.51)
    assert len(written.tables[0].rows) == 6
    assert result.found.conclusions[0] in written.findings
    assert averages() in written.paragraphs


def test_simulated_results_are_marked(result):
    measured = chapter(Results(SimpleNamespace(), {"friction": result}))
    result.trials.attrs["origin"] = "simulated"
    simulated = chapter(Results(SimpleNamespace(), {"friction": result}))
    assert "sensor are simulated" in simulated.paragraphs[0]
    assert "simulated" not in " ".join(measured.paragraphs)
    assert all(picture.caption.startswith("Simulated") for picture in simulated.pictures)


def test_without_trials_the_chapter_is_absent():
    assert isinstance(chapter(Results(SimpleNamespace(), {})), Absent)


def test_trials_without_the_driven_region_of_the_plate_are_analysed_with_a_remark(tmp_path, result):
    folder = written(tmp_path / "trials", simulated(2, 4, 6))
    other = compute_friction(folder, Sensor(), Rules(), of_plate="A")
    assert other.found.driven == "WG1"
    assert any("no trial was on A, the driven region of the plate" in remark for remark in other.remarks())
    own = compute_friction(folder, Sensor(), Rules(), of_plate="WG2")
    assert own.found.driven == "WG2"
    assert not any("driven region" in remark for remark in own.remarks())
