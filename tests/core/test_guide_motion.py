"""Wavenumbers and nodal lines of guided modes: exact strips, and one guide of several numbers of columns."""

from dataclasses import replace

import numpy as np
import pytest
from strategies import ALUMINIUM
from test_ribbon import MM

from haptonic.bloch.resolution import Resolution
from haptonic.bloch.ribbon import RibbonModel
from haptonic.bloch.ribbon_modes import GuideMotion
from haptonic.cell import Ribbon, UnitCell
from haptonic.lattice import Lattice

NARROW = UnitCell(Lattice.rectangular(6 * MM, 6 * MM), 1 * MM, ALUMINIUM)
WIDE = replace(NARROW, lattice=Lattice.rectangular(18 * MM, 6 * MM))
BEAM = np.array([22.373, 61.673])  # (k w)^2 of a beam with free ends: two nodal lines, three


def motions(ribbon, resolution, kappa, low, high):
    model = RibbonModel.of(ribbon, resolution)
    modes = model.solve(kappa, low, high)
    return modes.frequency, *GuideMotion(model).harmonics(modes)


@pytest.mark.parametrize("ribbon", [Ribbon((WIDE,)), Ribbon((NARROW,) * 3)], ids=["one wide", "three"])
def test_modes_across_a_strip_have_the_lines_of_a_beam(ribbon):
    frequency, wavenumber, lines = motions(ribbon, Resolution(4, 0), 0.0, 5e3, 60e3)
    bending = ALUMINIUM.youngs_modulus * MM**3 / 12 / (1 - ALUMINIUM.poisson_ratio**2)
    beam = BEAM / (2 * np.pi * (18 * MM) ** 2) * np.sqrt(bending / (ALUMINIUM.density * MM))
    for number, of_beam in enumerate(beam):
        nearest = int(np.abs(frequency - of_beam).argmin())
        assert frequency[nearest] == pytest.approx(of_beam, rel=0.05), "a beam that does not shear"
        assert (lines[nearest], wavenumber[nearest]) == (2 + number, 0.0)


def test_a_shear_wave_across_a_strip_has_no_nodal_lines_of_normal_motion():
    frequency, _, lines = motions(Ribbon((WIDE,)), Resolution(4, 0), 0.0, 5e3, 130e3)
    modulus = ALUMINIUM.youngs_modulus / (2 * (1 + ALUMINIUM.poisson_ratio))
    half_a_wave = np.sqrt(modulus / ALUMINIUM.density) / (2 * 18 * MM)
    assert np.isnan(lines[np.abs(frequency - half_a_wave).argmin()])
    assert np.isnan(lines).sum() == 1


def test_waves_at_the_end_of_the_zone_have_its_wavenumber_on_a_coarse_mesh():
    frequency, wavenumber, _ = motions(Ribbon((NARROW,) * 3), Resolution(3, 0), np.pi, 30e3, 90e3)
    assert len(frequency) >= 6
    assert wavenumber == pytest.approx(np.full(len(frequency), np.pi / (6 * MM)))
