"""The simulated scan of a plate that was computed, and the report's chapter on it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from five_parts import refusing
from haptonic.analyses.simulate_scan import rescanned
from haptonic.errors import HaptonicWarning, ScanError
from haptonic.report import Absent, Chapter, Results
from haptonic.report.chapters.scan import chapter
from haptonic.response import FrequencyResponse
from haptonic.results.references import References
from haptonic.store import Store
from haptonic.study import loads
from haptonic.units import uncertain
from haptonic.vibrometry.of_settings import drive_for, response_for
from haptonic.vibrometry.on_plate import contrast_range
from tiny_scan import TINY


@pytest.fixture(scope="module")
def store(tmp_path_factory):
    return Store(tmp_path_factory.mktemp("store"))


@pytest.fixture(scope="module")
def study():
    return loads(TINY)


@pytest.fixture(scope="module")
def plate(study, store):
    """Computed at 126 lines 400 Hz apart: others than those of the study's own scan."""
    question = study.scan_settings
    with pytest.warns(HaptonicWarning, match="ring-down"):
        drive = drive_for(question, study.mounted_plate())
    asked = replace(response_for(question, 1e-3, drive), points=126)
    return study.plate(settings=asked, store=store)


@pytest.fixture(scope="module")
def scan(study, plate, store):
    return rescanned(study, plate, seed=2, store=store)


def test_the_scan_returns_the_plate_that_it_was_made_of(plate, scan):
    assert scan.origin == "simulated"
    assert scan.averages == 2
    assert scan.response.frequency == pytest.approx(plate.response.frequency, rel=1e-9)
    off = scan.contrasts["WG1 over WG2"].values - plate.contrasts(plate.response)["WG1 over WG2"].values
    assert 0 < np.abs(off).max() < 0.5
    known = contrast_range(plate.response, plate.plate)
    for edge in ("lower", "upper"):
        assert abs(getattr(scan.measured, edge) - getattr(known, edge)) < getattr(known, f"{edge}_error")


@pytest.mark.parametrize("known", [References(title="the paper", figures={"scan": "Fig. 5D"}), None])
def test_the_chapter_sets_scan_and_plate_side_by_side(study, plate, scan, known):
    written = chapter(Results(study, {"plate": plate, "scan": scan}, references=known))
    assert isinstance(written, Chapter)
    assert "The records are simulated" in written.paragraphs[0]
    assert "126 lines 400 Hz apart" in written.paragraphs[0]
    assert all(picture.caption.startswith("Simulated") for picture in written.pictures)
    assert ("(Fig. 5D of the paper)" in written.pictures[0].caption) == (known is not None)
    assert len([axes for axes in written.pictures[0].figure.axes if axes.images]) == 2 * len(scan.shapes)
    levels, gaps = written.tables
    frequency = scan.shapes[0]
    ours = plate.contrasts(plate.response.at(frequency))["WG1 over WG2"]
    seen = float(scan.contrasts["WG1 over WG2"].sel(frequency=frequency))
    assert levels.rows[0] == (f"WG1 over WG2, {frequency / 1e3:.2f} kHz", float(ours[0]), seen)
    named = {row[0]: row[1:] for row in gaps.rows}
    assert named["high contrast, simulated scan (experimental)"][0].startswith(
        uncertain(scan.measured.lower / 1e3, scan.measured.lower_error / 1e3)
    )
    assert "at 126 of 126 frequencies" in written.findings[0]
    assert "at 126 of them" in written.findings[0]


def test_without_a_scan_there_is_no_chapter(study, plate):
    assert isinstance(chapter(Results(study, {"plate": plate})), Absent)
    assert isinstance(chapter(Results(study, {})), Absent)


def test_lines_that_no_periodic_drive_has_are_refused(study, plate):
    for shift in (30.0, -30.0):
        moved = plate.response.dataset.assign_coords(frequency=plate.response.frequency + shift)
        with refusing(ScanError, "out-of-range", "plate.response"):
            rescanned(study, replace(plate, response=FrequencyResponse(moved)))
