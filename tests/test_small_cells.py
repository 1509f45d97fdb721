"""Cells of micrometres and nanometres: no warnings about usual sizes, and numbers in the units that suit."""

from __future__ import annotations

import warnings

import pytest
from hypothesis import given, settings, strategies as st
from matplotlib.figure import Figure

from haptonic.analyses import named
from haptonic.errors import HaptonicWarning
from haptonic.plots import style
from haptonic.plots.text import band_text
from haptonic.results.table import Column, Table
from haptonic.study import Study
from haptonic.units import hz_text, to_si
from haptonic.workshop import surface
from haptonic.workshop.part import Part

MATERIALS = ("silicon", "steel", "aluminium-paper")


def cell(pitch: float) -> dict[str, object]:
    return {
        "pitch": pitch,
        "thickness": 0.2 * pitch,
        "pillar": {"diameter": 0.5 * pitch, "height": 1.2 * pitch},
    }


# above 15 mm, the lowest of these carriers is below 10 kHz, which is no ultrasound
@given(st.floats(-6.3, -1.83), st.sampled_from(MATERIALS), st.floats(0.05, 0.5))
@settings(deadline=None, max_examples=40)
def test_a_cell_of_any_size_in_usual_proportions_is_usual(power, solid, share):
    pitch = 10.0**power
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        study = Study(cell=cell(pitch), material=solid, carrier=share * 3000 / pitch)
        assert study.unusual() == ()


@given(
    st.floats(-6.3, -1.5), st.sampled_from(["thickness", "height", "carrier"]), st.sampled_from([1e-3, 1e3])
)
@settings(deadline=None, max_examples=40)
def test_a_slip_of_a_unit_is_named_whatever_the_size_of_the_cell(power, what, slip):
    pitch = 10.0**power
    keys, carrier = cell(pitch), 0.1 * 3000 / pitch
    if what == "thickness":
        keys["thickness"] *= slip
    elif what == "height":
        keys["pillar"]["height"] *= slip
    else:
        carrier = min(max(carrier * slip, 1.0), 1e11)
    small = min(keys["thickness"], keys["pillar"]["height"])
    if not small >= 1e-9 or max(keys["thickness"], keys["pillar"]["height"]) > 1e3:
        return
    with pytest.warns(HaptonicWarning, match=r"Did you mean|is typical"):
        Study(cell=keys, material="silicon", carrier=carrier)


@given(st.floats(1e3, 9e10), st.floats(1.0, 1.3))
@settings(deadline=None, max_examples=60)
def test_a_frequency_is_shown_in_a_unit_that_reads_back(frequency, ratio):
    number, unit = hz_text(frequency, form=".6f").split()
    assert 1 <= float(number) < 1000 or unit == "GHz"
    assert to_si(f"{number} {unit}", "Hz", "f") == pytest.approx(frequency, rel=1e-3)
    low, high = hz_text(frequency, ratio * frequency, form=".6f").split(" to ")
    assert to_si(high, "Hz", "f") == pytest.approx(ratio * frequency, rel=1e-3)
    assert len(low.split()) == 1


def test_examples_of_units():
    assert hz_text(54.36e6) == "54.36 MHz"
    assert hz_text(8.9e9) == "8.9 GHz"
    assert hz_text(60e3) == "60 kHz"
    assert band_text(54.36e6, 1e4, 61.2e6, 2e4) == "54.36 ± 0.01 to 61.20 ± 0.02 MHz"


@pytest.mark.parametrize(("scale", "unit"), [(1.0, "kHz"), (1e3, "MHz"), (1e6, "GHz")])
def test_columns_and_axes_follow_their_values_and_files_keep_hertz(scale, unit):
    table = Table("t", [Column("f", "Hz", "kHz", ".2f")], [[52.5e3 * scale], [60.2e3 * scale]])
    assert table.head == (f"f / {unit}",)
    assert float(table.texts[0][0]) == pytest.approx(52.5)
    assert table.written("csv").splitlines()[0] == "f (Hz)"

    @style.drawn
    def picture() -> Figure:
        figure = style.blank(6)
        axes = figure.add_subplot()
        axes.plot([0, 1], [50 * scale, 70 * scale])
        axes.set_ylabel("frequency (kHz)")
        return figure

    (axes,) = picture().axes
    assert axes.get_ylabel() == f"frequency ({unit})"
    shown = [float(label.get_text()) for label in axes.get_yticklabels() if label.get_text()]
    assert max(shown) <= 75


@pytest.mark.parametrize("pitch", [500e-9, 100e-6, 7e-3])
def test_forecasts_and_solids_do_not_depend_on_the_size(pitch):
    plate = {
        "map": "oo1oo", "rows": 3, "tiles": {"o": "lattice", "1": "WG"}, "loss_factor": 1e-3,
        "force": [{"name": "F1", "region": "WG", "centre": [pitch / 2, pitch], "force": 1e-6}],
        "response": {"lowest": 700 / pitch, "highest": 1500 / pitch, "points": 11, "grid": pitch / 10},
    }  # fmt: skip
    study = Study(cell=cell(pitch), material="silicon", carrier=1000 / pitch, plate=plate)
    analysis = named("plate")
    assert analysis.cost(study, analysis.options()).seconds < 60
    assert len(surface(Part.piece(study.cell, 1, 1)).points) > 50
