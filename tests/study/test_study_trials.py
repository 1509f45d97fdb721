"""The section about trials: what it makes of what was written, alone or in a study."""

from dataclasses import fields
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from five_parts import refusing
from haptonic.errors import FrictionError, StudyError
from haptonic.friction.recordings import Exclusion, Sensor
from haptonic.friction.signals import Rules
from haptonic.study import TrialSettings, load_trials, loads

ALONE = """
[trials]
filter = "none"
bias_window = "50 ms"
force = ["300 mN", "2 N"]
speed = ["5 cm/s", "0.2 m/s"]
[trials.sensor]
normal = "-Fz"
gauges = "a, b,c,d, e, f"
calibration = "m.csv"
largest_gauge = "5000 mV"
[[trials.exclude]]
participant = "P1"
reason = "ill"
"""


def rules_in(section):
    return Rules(**{field.name: getattr(section, field.name) for field in fields(Rules)})


def test_the_defaults_are_those_of_the_analysis():
    section = TrialSettings()
    assert rules_in(section) == Rules()
    assert section.exclude == ()
    assert section.sensor == Sensor()
    assert section.sensor.matrix(Path("nowhere")) is None


def test_a_file_with_trials_alone(tmp_path):
    path = tmp_path / "rules.toml"
    path.write_text(ALONE)
    section, study = load_trials(path)
    assert study is None
    assert rules_in(section) == Rules("none", 0.05, force=(0.3, 2.0), speed=(0.05, 0.2))
    assert section.exclude == (Exclusion("P1", "ill"),)
    with refusing(FrictionError, "not-found", "trials.sensor.calibration"):
        section.sensor.matrix(tmp_path)
    pd.DataFrame(2 * np.eye(6)).to_csv(tmp_path / "m.csv", header=False, index=False)
    sensor = section.sensor
    assert sensor.gauges == "a, b,c,d, e, f"
    assert sensor.matrix(tmp_path) == pytest.approx(2 * np.eye(6))
    assert (sensor.normal, sensor.largest_gauge) == ("-Fz", 5.0)
    path.write_text(ALONE.replace("bias_window", "bias_windw"))
    with refusing(StudyError, "unknown", "trials.bias_windw"):
        load_trials(path)


def test_in_a_study(edited, tmp_path):
    path = tmp_path / "study.toml"
    path.write_text(edited(("[[sweep]]", ALONE + "[[sweep]]")))
    section, study = load_trials(path)
    assert study is not None
    assert section == study.trials
    assert loads(study.to_toml()) == study


def test_trials_decide_no_result_that_is_kept(edited):
    """Another threshold must not make the plate be computed again."""
    plain, other = loads(edited()), loads(edited(("[[sweep]]", ALONE + "[[sweep]]")))
    assert plain != other
    assert plain.inputs() == other.inputs()
