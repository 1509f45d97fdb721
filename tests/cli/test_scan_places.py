"""Where a scan looks along guides and into the mirror, and the waves that are computed there."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from haptonic.bloch import Gap
from haptonic.bloch.guide import strip_mode
from haptonic.bloch.mirrors import condensed_rows
from haptonic.bloch.model import bloch_model
from haptonic.store import Store
from haptonic.study import loads
from haptonic.vibrometry.guides import guides_of, mirror_beside, strips_of
from haptonic.vibrometry.theory import computed_waves, guided
from tiny_scan import TINY


@pytest.fixture(scope="module")
def study():
    return loads(TINY)


@pytest.fixture(scope="module")
def store(store_folder):
    return Store(store_folder)


class TestPlaces:
    def test_the_mirror_lies_between_the_guides(self, study):
        layout = study.mounted_plate().layout
        mirror = mirror_beside(layout, "WG1")
        assert (mirror.depth, mirror.inwards, mirror.rows) == ("x", 1, 2)
        assert (mirror.start, mirror.pitch) == pytest.approx((21e-3, 7e-3))
        back = mirror_beside(layout, "WG2")
        assert (back.depth, back.inwards, back.start) == ("x", -1, pytest.approx(35e-3))
        points = np.array([[22e-3, 10e-3], [34e-3, 20e-3], [20e-3, 10e-3], [36e-3, 10e-3]])
        assert mirror.area.holds(points).tolist() == [True, True, False, False]
        assert np.array_equal(mirror.area.holds(points), back.area.holds(points))

    def test_rows_of_the_same_lattice_lie_beside_every_guide(self, study):
        strips = strips_of(study.mounted_plate().layout, "WG1")
        assert sorted((one.start, one.inwards, one.rows) for one in strips) == [
            (pytest.approx(7e-3), -1, 1), (pytest.approx(35e-3), -1, 2), (pytest.approx(49e-3), 1, 1),
        ]  # fmt: skip
        assert [one.period for one in strips] == pytest.approx([7e-3] * 3)

    def test_guides_run_along_their_longer_side(self, study):
        one, two = guides_of(study.mounted_plate().layout)
        assert (one.region, one.along, one.width, one.lattice) == (
            "WG1",
            "y",
            pytest.approx(14e-3),
            "lattice",
        )
        assert two.region == "WG2"
        text = TINY
        for old, new in (
            ('map = "o11oo22o"\nrows = 3', 'map = """\noooooooo\n11111111\no22oooo3\n"""'),
            ('2 = "WG2"', '2 = "WG2"\n3 = "C"'),
            ('"7 mm", "9 mm"', '"27 mm", "3.5 mm"'),
            ('size = ["9 mm", "7 mm"', 'size = ["9 mm", "5 mm"'),
        ):
            assert old in text
            text = text.replace(old, new)
        turned = loads(text)
        guides = {guide.region: guide for guide in guides_of(turned.mounted_plate().layout)}
        assert (guides["WG1"].along, guides["WG1"].lattice) == ("x", None)
        # above WG1 there is a whole row of the lattice, below there is not
        mirror = mirror_beside(turned.mounted_plate().layout, "WG1")
        assert (mirror.depth, mirror.inwards, mirror.rows) == ("y", 1, 1)


class TestWaves:
    def test_the_guide_s_mode_is_that_of_a_strip_as_long_as_it_needs(self, study):
        """The mode at a wavenumber is that of a strip with free ends whose length fits it."""
        layout, gap = (
            study.mounted_plate().layout,
            Gap((6, 7), 56e3, 62e3, 0.0, 0.0, (0.0, 0.0), (0.0, 0.0), True, "", 9),
        )
        guides = [replace(one, along="y", width=32e-3, lattice="lattice") for one in guides_of(layout)]
        mirror = mirror_beside(layout, "WG1")
        waves = computed_waves(layout, study.bands_settings, (40e3, 70e3), gap, guides, mirror)
        at, wavenumber = guided(waves, guides[0])
        assert len(at) >= 2
        assert (np.diff(at) > 0).all()
        cell = next(iter(layout.cells.values()))
        resolution = bloch_model(cell, study.bands_settings).resolution
        rows = condensed_rows(cell, resolution)
        mode = strip_mode(
            rows, width=32e-3, length=17.5 * np.pi / wavenumber[0], intervals=17, nodal_lines=0,
            between=(2 * np.pi * gap.lower, 2 * np.pi * gap.upper),
        )  # fmt: skip
        assert mode.omega / (2 * np.pi) == pytest.approx(at[0], rel=1e-9)
        # thin-plate theory is a few per cent off: k^2 = omega sqrt(12 rho (1 - nu^2) / (E h^2))
        thin = np.sqrt(2 * np.pi * waves["frequency"] * np.sqrt(12 * 2700 * (1 - 0.33**2) / 70e9) / 1.5e-3)
        ratio = waves["wavenumber"].values / thin.values
        assert ((ratio > 1.0) & (ratio < 1.1)).all()
        assert float(waves["attenuation"].max()) > 5
