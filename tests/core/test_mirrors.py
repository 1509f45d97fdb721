"""Spectra of a mirror against the bands of the pencil, conservation of energy and the interface itself."""

from functools import cache

import numpy as np
import pytest
import xarray as xr
from coarse import lattice, rows
from hypothesis import given, strategies as st

from daily import daily
from five_parts import refusing
from haptonic.bloch import bloch_pencil
from haptonic.bloch.layers import OUTGOING, Interface
from haptonic.bloch.mirrors import (
    PHASES,
    SHOWN_WAVES,
    Incidence,
    first_reaching,
    mirror_dataset,
    scattering_at,
)
from haptonic.bloch.pencil import eigenpairs
from haptonic.bloch.plate_waves import FAMILIES, PlainPlate
from haptonic.errors import StudyError
from haptonic.superelement import Tiling

FREQUENCY = np.array([30e3, 45e3, 57e3, 90e3])  # Hz; only the third lies in the complete gap
OBLIQUE = 0.5  # rad
DECIBELS = 20 / np.log(10)  # of one neper


@cache
def spectrum(angle: float = 0.0, loss_factor: float = 0.0) -> xr.Dataset:
    return mirror_dataset(rows(), FREQUENCY, Incidence(angle, 3, loss_factor))


@cache
def bands(phase: float) -> np.ndarray:
    """(steps, 12) frequencies of the pencil, Hz, for phases from 0 to pi across the rows."""
    pencil, across = bloch_pencil(Tiling.single(lattice())), np.linspace(0.0, np.pi, 31)
    values = [eigenpairs(pencil, np.array([kappa, phase]), 12)[0] for kappa in across]
    return np.sqrt(np.maximum(values, 0.0)) / (2 * np.pi)


def crossings(phase: float, frequency: float) -> int:
    """How often the bands pass a frequency, found without asking for a wave at that frequency."""
    above = bands(phase) > frequency
    assert above[:, -1].all(), "bands enough"
    return int((above[1:] != above[:-1]).sum())


def test_waves_that_propagate_belong_to_bands_and_every_band_has_its_wave():
    data, pencil = spectrum(), bloch_pencil(Tiling.single(lattice()))
    counts = []
    for row, frequency in enumerate(FREQUENCY):
        moving = np.flatnonzero(data["kappa_imag"].values[row] < 1e-7)
        counts.append(len(moving))
        for kappa in data["kappa_real"].values[row, moving]:
            bands = np.sqrt(np.abs(eigenpairs(pencil, np.array([kappa, 0.0]), 20)[0])) / (2 * np.pi)
            assert np.abs(bands / frequency - 1).min() < 1e-8
    assert counts == [crossings(0.0, frequency) for frequency in FREQUENCY]
    assert max(counts) >= 3
    assert counts[2] == 0


def test_waves_are_sorted_by_reach_and_the_first_one_sets_the_attenuation():
    data = spectrum()
    decay = data["kappa_imag"].values
    assert decay.shape == (len(FREQUENCY), SHOWN_WAVES)
    assert (np.diff(decay) > -1e-7).all()  # waves that propagate have rounding for an imaginary part
    assert decay.min() > -1e-7
    attenuation = data["attenuation"].sel(phase=0.0).values
    assert attenuation == pytest.approx(DECIBELS * decay[:, 0], abs=1e-5)
    assert attenuation[2] > 1.0


@pytest.mark.parametrize("column", [0, 2, 4])
def test_the_attenuation_is_zero_exactly_where_there_is_a_band(column):
    attenuation = spectrum()["attenuation"].values[:, column]
    there = [crossings(PHASES[column], frequency) > 0 for frequency in FREQUENCY]
    assert [value == 0.0 for value in attenuation] == there
    assert not there[2]


@pytest.mark.parametrize("angle", [0.0, OBLIQUE])
def test_without_loss_energies_add_up(angle):
    data = spectrum(angle)
    for name in ("reflected", "transmitted"):
        assert (data[name].values >= 0).all()
        assert (data[name].max("rows") > 1e-3).any("outgoing").all()  # every incident wave leaves somewhere
    whole = (data["reflected"] + data["transmitted"]).sum("outgoing").values
    assert whole == pytest.approx(np.ones((len(FREQUENCY), 3, 3)), abs=1e-9)


@pytest.mark.parametrize("angle", daily([0.0, OBLIQUE], 0.0))
def test_loss_takes_energy_the_more_the_greater_it_is(angle):
    shares = [
        1 - (data["reflected"] + data["transmitted"]).sum("outgoing").values
        for data in (spectrum(angle, loss_factor) for loss_factor in (1e-4, 2e-4, 1e-2))
    ]
    assert (shares[0] > 0).all()
    assert shares[1] == pytest.approx(2 * shares[0], rel=0.1)
    # Where a resonance is narrower than the loss the rows take less of a greater one; here none is.
    assert (shares[2] > shares[1]).all()
    assert (shares[2] < 1).all()


@pytest.mark.parametrize(("angle", "loss_factor"), [(0.0, 0.0), (OBLIQUE, 1e-2)])
def test_energies_are_those_of_the_interface_that_the_wave_meets(angle, loss_factor):
    data, omega = spectrum(angle, loss_factor), 2 * np.pi * FREQUENCY[2]
    for family in FAMILIES:
        here = Interface.met_by(rows(), omega, family, angle)
        expected = here.scattering(omega, 3, (family,), loss_factor)
        energies = data.sel(frequency=FREQUENCY[2], incident=family)
        for name in ("reflected", "transmitted"):
            assert energies[name].dims == ("rows", "outgoing")
            assert energies[name].values == pytest.approx(getattr(expected, name)[:, 0], abs=1e-9)


def test_axes_are_named_with_their_units():
    data = spectrum()
    assert data["rows"].values.tolist() == [1, 2, 3]
    assert data["incident"].values.tolist() == list(FAMILIES)
    assert data["outgoing"].values.tolist() == list(OUTGOING)
    assert data["frequency"].values == pytest.approx(FREQUENCY)
    units = {"frequency": "Hz", "phase": "rad", "kappa_real": "rad", "attenuation": "dB", "transmitted": "1"}
    assert {name: data[name].attrs["units"] for name in units} == units


def test_a_wave_that_does_not_propagate_has_no_energies(monkeypatch):
    """The three families of a plate do at any frequency, so that one of them is taken away."""
    wavenumber = PlainPlate.wavenumber

    def without_s0(self, omega, angle, family):
        return None if family == "S0" else wavenumber(self, omega, angle, family)

    monkeypatch.setattr(PlainPlate, "wavenumber", without_s0)
    data = mirror_dataset(rows(), FREQUENCY[2:3], Incidence(OBLIQUE, 2, 0.0))
    for name in ("reflected", "transmitted"):
        assert np.isnan(data[name].sel(incident="S0")).all()
        assert np.isfinite(data[name].sel(incident=["A0", "SH0"])).all()
    assert list(scattering_at(rows(), 57e3, Incidence(OBLIQUE, 2, 0.0))) == ["A0", "SH0"]


def test_incidence_parallel_to_the_rows_is_refused():
    with refusing(StudyError, "out-of-range", "layers.angle"):
        scattering_at(rows(), 57e3, Incidence(0.5 * np.pi, 1, 0.0))


@given(st.lists(st.floats(-1.0, 100.0), max_size=12), st.floats(0.0, 90.0))
def test_from_the_first_row_that_reaches_a_goal_all_reach_it(insulation, goal):
    rows = first_reaching(insulation, goal)
    reach = [all(value >= goal for value in insulation[start:]) for start in range(len(insulation))]
    assert rows == (reach.index(True) + 1 if True in reach else None)


@pytest.mark.parametrize(
    ("insulation", "rows"),
    [([20.0], 1), ([19.9], None), ([10, 30, 15, 20, 25], 4), ([30, 40, 19], None), ([30, 40, 50], 1)],
)
def test_insulation_that_falls_again_has_not_reached_its_goal(insulation, rows):
    assert first_reaching(np.array(insulation, dtype=float), 20.0) == rows
