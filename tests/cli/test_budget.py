"""The budget on the command line and in Python, and a dry run that reports what the run would report."""

from __future__ import annotations

import re
import warnings

import pytest
from hypothesis import HealthCheck, given, settings, strategies as st

from haptonic.bloch.mesh_levels import MeshLimits
from haptonic.errors import HaptonicError, StudyError
from haptonic.study import loads
from haptonic.superelement import Tiling
from user_designs import study_of, study_text


@pytest.fixture
def stopped(monkeypatch):
    """A run that begins with a mesh ends there, with an error of its own."""

    def begin(*_, **__):
        raise StudyError.no_answer(argument="begun", given="", allowed="", cause="begun", next_step="")

    monkeypatch.setattr(Tiling, "condensed", begin)


@pytest.fixture
def memory(monkeypatch):
    """Set the memory that may be used, bytes."""

    def may_be_used(number: float) -> None:
        monkeypatch.setattr(MeshLimits, "of", classmethod(lambda cls, budget: cls(budget, number)))

    return may_be_used


def test_a_budget_for_meshes_is_offered_by_commands_that_mesh(inside):
    without = ("protocol", "chirp", "simulate friction")
    for name in ("bands", "plate", "export", "simulate scan", *without):
        help_text = inside(*name.split(), "--help").out
        assert ("--budget" in help_text) == (name not in without), name


@given(st.integers(0, 1000), st.sampled_from(["1 s", "20 s", "10 min"]), st.sampled_from([4e8, 2e9, 1e12]))
@settings(max_examples=3, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_a_dry_run_ends_as_the_run_does(inside, tmp_path, stopped, memory, number, budget, free):
    """Drawn designs; the command that a lack of time names is accepted by both."""
    memory(free)
    path = tmp_path / "drawn.toml"
    path.write_text(study_text(5, number)[1], "utf-8")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        dry = inside("bands", path, "--dry-run", "--json", "--budget", budget)
        run = inside("bands", path, "--json", "--budget", budget)
        assert run.code == 2
        if run.json["error"]["argument"] == "begun":
            assert dry.code == 0
            assert dry.json["budget_s"] == {"1 s": 1, "20 s": 20, "10 min": 600}[budget]
            return
        assert dry.code == 2
        assert dry.json["error"] == run.json["error"]
        error = run.json["error"]
        assert re.match("lack of (time|memory): ", error["cause"])
        if match := re.search(r'--budget "(.*?)"', error["next_step"]):
            assert inside("bands", path, "--dry-run", "--budget", match[1]).code == 0
            assert inside("bands", path, "--json", "--budget", match[1]).json["error"]["argument"] == "begun"


def test_the_budget_is_the_same_in_python_in_the_file_and_on_the_command_line(stopped, memory):
    memory(1e12)
    text = study_text(5, 1)[1]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        plain, written = loads(text), loads(text + '[bands]\nbudget = "2 s"\n')
    causes = []
    for ask in (lambda: plain.bands(budget="2 s"), lambda: plain.bands(budget=2.0), written.bands):
        with pytest.raises(HaptonicError) as caught:
            ask()
        causes.append(caught.value.cause)
    assert len(set(causes)) == 1
    assert causes[0].startswith("lack of time")
    with pytest.raises(HaptonicError) as caught:
        written.bands(budget="10 min")
    assert caught.value.argument == "begun"
    with pytest.raises(StudyError) as caught:
        plain.bands(budget="10 mm")
    assert caught.value.argument == "budget"


def test_a_budget_that_is_no_time_is_refused_by_its_flag(inside, study):
    ran = inside("bands", study(), "--budget", "10 mm", "--json")
    assert ran.code == 2
    assert ran.json["error"]["argument"] == "--budget"


@pytest.mark.parametrize(
    "command", ["sweep", "design", "tolerance", "layers", "waveguide", "ribbon", "reproduce"]
)
def test_every_command_that_asks_for_bands_takes_a_budget(inside, command):
    assert "--budget" in inside(command, "--help").out


def test_a_plan_reports_commands_over_budget(memory):
    memory(1e12)
    plan = study_of(5, 1).plan(budget="1 s")
    assert any("haptonic bands would be refused: lack of time" in remark for remark in plan.remarks())


def test_a_dry_run_refuses_too_few_points_for_the_zone_of_a_cell(inside, tmp_path):
    """A turned ellipse has a half-turn only, so its zone has six segments."""
    path = tmp_path / "turned.toml"
    path.write_text(
        """
material = "aluminium-2017a"
[cell]
pitch = "10 mm"
thickness = "2 mm"
[[cell.disc]]
section = "ellipse"
diameter = "8 mm"
length = "4 mm"
turn = "30 deg"
empty = true
[bands]
count = 6
points = 10
""",
        encoding="utf-8",
    )
    for how in ([], ["--dry-run"]):
        ran = inside("bands", path, "--json", *how)
        assert ran.code == 2
        assert ran.json["error"]["argument"] == "bands.points"
