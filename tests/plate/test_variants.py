"""Plates with one thing changed, and what the report says of them."""

from dataclasses import replace

import numpy as np
import pytest
import xarray as xr
from haptonic.report.guide_shifts import AS_IT_IS, DRIVEN
from small import COARSE, LOSS, drawn, glued

from haptonic.materials import material
from haptonic.plate.parts import Force, Plate
from haptonic.report.chapters.plate import _shift_findings, _shifts_tables
from haptonic.results.plate.variants import (
    Look,
    guide_mode,
    mode_shifts,
    resonance,
    with_material,
    with_rows,
)
from haptonic.store import Store

TWO_GUIDES = Plate(
    drawn("o1oo2o"), actuators=(glued((10.5e-3, 3.5e-3), (5e-3, 4e-3, 0.5e-3)),), loss_factor=LOSS
)


def strip(columns=8):
    """A free strip of plain plate."""
    return Plate(drawn("p" * columns), loss_factor=LOSS)


@pytest.mark.parametrize("rows", [0, 1, 2, 5])
def test_rows_of_lattice_come_and_go(rows):
    beyond = Force("F", (31e-3, 3.5e-3), None)
    plate = with_rows(replace(TWO_GUIDES, forces=(beyond,)), "1", "2", rows)
    (row,) = plate.layout.tiles
    assert "".join(row) == "o1" + "o" * rows + "2o"
    assert np.diff(plate.layout.x) == pytest.approx(np.full(4 + rows, 7e-3))
    assert plate.actuators == TWO_GUIDES.actuators
    assert not plate.forces, "it would act somewhere else"


def test_another_material_is_that_of_plate_and_pillars():
    other = material("steel")
    plate = with_material(TWO_GUIDES, other)
    assert plate.layout.material is other
    assert all(cell.material is other for cell in plate.layout.cells.values())
    assert plate.layout.tiles == TWO_GUIDES.layout.tiles


def test_a_mode_is_found_by_its_name():
    """The first two bending modes of a free beam (Euler and Bernoulli), thirty times as long as thick."""
    length, beta = 56e-3, np.array([4.73004, 7.85320])
    layout = strip().layout
    speed = np.sqrt(layout.material.youngs_modulus / layout.material.density)
    expected = beta**2 * layout.thickness / np.sqrt(12) / length**2 * speed / (2 * np.pi)
    for name, frequency in zip(("0x1", "0x2"), expected, strict=True):
        look = Look(0.7 * frequency, 1.3 * frequency, name, 1e-3, 1e-3)
        assert guide_mode(strip(), "p", look, COARSE) == pytest.approx(frequency, rel=0.025)
    assert np.isnan(guide_mode(strip(), "p", replace(look, name="5x5"), COARSE))


def test_shifts_are_kept_and_told(tmp_path):
    plates = {AS_IT_IS: (strip(), COARSE), "longer": (strip(9), COARSE)}
    look, store, done = Look(1.2e3, 3.5e3, "0x1", 1e-3, 1e-3), Store(tmp_path), []
    found = mode_shifts(plates, "p", look, store, {}, lambda: done.append(None))
    short, long = found["mode_frequency"].values
    assert long / short == pytest.approx((8 / 9) ** 2, rel=0.01)
    again = mode_shifts(plates, "p", look, store, {}, lambda: done.append(None))
    assert len(done) == 2
    xr.testing.assert_identical(found, again)
    assert mode_shifts(plates, "p", look, store, {"other": 1}, lambda: done.append(None)) is not found
    assert len(done) == 4


def test_a_driven_guide_resonates_at_its_peak():
    """Plain plate all over, so quick; the loudest line is a maximum of the region's own response."""
    patch = glued((10.5e-3, 3.5e-3), (5e-3, 4e-3, 0.5e-3))
    plate = Plate(drawn("11112222"), actuators=(patch,), loss_factor=0.02)
    frequency, level = resonance(plate, Look(2.0e3, 3.2e3, "", 2e-3, 1e-2), "1", "2")
    length, speed = 56e-3, np.sqrt(70e9 / 2700.0)
    beam = 4.73004**2 * 1.5e-3 / np.sqrt(12) / length**2 * speed / (2 * np.pi)
    assert frequency == pytest.approx(beam, rel=0.06)  # the patch stiffens and loads it
    assert abs(level) < 3, "both halves of a free beam move alike"


def test_the_report_tells_every_shift():
    frequencies = [57e3, 56.43e3, 58.71e3, np.nan]
    labels = [AS_IT_IS, DRIVEN, "thicker", "lost"]
    shifts = xr.Dataset({"mode_frequency": ("plate", frequencies)}, coords={"plate": labels})
    (said,) = _shift_findings(shifts)
    assert "3.2 % above" in said
    assert f"{DRIVEN}: -1.0 %" in said
    assert "thicker: +3.0 %" in said
    assert "lost" not in said
    (shown,) = _shifts_tables(shifts)
    assert shown.rows[2] == ("thicker", "58.71 kHz", "+3.00 %")
    assert shown.rows[3] == ("lost", "not found", "")
    assert not _shift_findings(None)
    assert not _shifts_tables(None)
