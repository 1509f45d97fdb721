"""Where a scan looks along guides and into the mirror, and the waves that are computed there."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import xarray as xr

from bricks import ALUMINIUM, CELLS, PITCH, THICKNESS, laid
from haptonic.bloch import Gap
from haptonic.bloch.candidates import bloch_model
from haptonic.bloch.guide import strip_mode
from haptonic.bloch.mirrors import condensed_rows
from haptonic.cell import Pillar, UnitCell
from haptonic.lattice import Lattice
from haptonic.plate.layout.parts import Force, Plate
from haptonic.response import FrequencyResponse
from haptonic.store import Store
from haptonic.study import loads
from haptonic.vibrometry.guides import guides_of, mirror_beside, strips_of, without_mode
from haptonic.vibrometry.on_plate import lattice_gap
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
        assert (mirror.depth, mirror.inwards, mirror.rows, mirror.repeat) == ("x", 1, 2, 1)
        assert (mirror.start, mirror.pitch) == pytest.approx((21e-3, 7e-3))
        back = mirror_beside(layout, "WG2")
        assert (back.depth, back.inwards, back.start) == ("x", -1, pytest.approx(35e-3))
        points = np.array([[22e-3, 10e-3], [34e-3, 20e-3], [20e-3, 10e-3], [36e-3, 10e-3]])
        assert mirror.area.holds(points).tolist() == [True, True, False, False]
        assert np.array_equal(mirror.area.holds(points), back.area.holds(points))

    def test_rows_of_the_same_lattice_lie_beside_every_guide(self, study):
        layout = study.mounted_plate().layout
        strips = strips_of(layout, mirror_beside(layout, "WG1"))
        assert sorted((strip.start, strip.inwards, strip.rows) for strip in strips) == [
            (pytest.approx(7e-3), -1, 1), (pytest.approx(35e-3), -1, 2), (pytest.approx(49e-3), 1, 1),
        ]  # fmt: skip
        assert [strip.period for strip in strips] == pytest.approx([7e-3] * 3)

    def test_guides_run_along_their_longer_side(self, study):
        first, second = guides_of(study.mounted_plate().layout)
        assert (first.region, first.along, first.width, first.lattice) == (
            "WG1",
            "y",
            pytest.approx(14e-3),
            "lattice",
        )
        assert second.region == "WG2"
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


class TestOtherLattices:
    """Rows that are offset, or of several sites, as the plate's bricks have them."""

    AROUND = "oooooo oooooo oooooo oooooo pppppp oooooo oooooo oooooo"
    BESIDE = "oooopoooo " * 5

    def test_rows_of_a_triangular_lattice(self):
        """Across its rows it begins where the letters do, along them behind half a brick."""
        layout = laid(self.AROUND, CELLS["triangular"])
        above = mirror_beside(layout, "p")
        both = strips_of(layout, above)
        assert sorted(strip.rows for strip in both) == [3, 4]
        high = np.sqrt(0.75) * PITCH
        assert (above.depth, above.rows, above.inwards, above.symmetric) == ("y", 4, 1, True)
        assert (above.period, above.pitch, above.repeat) == pytest.approx((PITCH, high, 2))
        assert (above.start, above.face) == pytest.approx((4 * high, 4 * high))
        # whole bricks only: half of one is missing at either end of every other row
        assert (above.area.x, above.area.width) == pytest.approx((0.5 * PITCH, 5 * PITCH))
        (guide,) = guides_of(layout)
        assert (guide.along, guide.lattice) == ("x", "o")
        assert guide.width == pytest.approx(high)

        layout = laid(self.BESIDE, CELLS["triangular"])
        (guide,), beside = guides_of(layout), mirror_beside(layout, "p")
        assert (beside.depth, beside.rows, beside.repeat) == ("x", 6, 2)
        assert (beside.period, beside.pitch) == pytest.approx((2 * high, 0.5 * PITCH))
        # the first column lies half a pitch inside, and its tiles reach a quarter towards the guide
        assert beside.spacing == pytest.approx(np.sqrt(high * PITCH))
        assert guide.width == pytest.approx(1.5 * PITCH)
        for mirror in strips_of(layout, beside):
            inside = mirror.area.holds(np.array([(x, y) for x, y, _ in layout.standing]))
            assert inside.sum() == 3 * 4 + 2 * 3  # four of every other row, on the rim as well, and three

    def test_a_lattice_without_mirror_symmetry_gives_no_gap_and_no_guide(self):
        """Unequal pillars of a honeycomb change places in a mirror along x, and not in one along y."""
        lying, standing = (laid(text, CELLS["honeycomb"]) for text in (self.AROUND, self.BESIDE))
        assert [guide.lattice for guide in guides_of(lying) + guides_of(standing)] == [None, "o"]
        assert not mirror_beside(lying, "p").symmetric
        response = FrequencyResponse.of(
            np.ones((1, 1, 1), complex),
            frequency=[1e3],
            x=[0.0],
            y=[0.0],
            reference="A1, V",
            origin="simulated",
        )
        plate = Plate(lying, forces=(Force("F", (3 * PITCH, 3.5 * lying.y[-1] / 8)),))
        gap = lattice_gap(response, plate, xr.Dataset())
        assert "not their own mirror images" in gap.reasons[0]

    def test_offset_rows_give_the_decay_of_waves_and_no_gap_edge(self):
        layout, data = laid(self.BESIDE, CELLS["triangular"]), xr.Dataset()
        lines = [np.arange(0, ends[-1], 1.5e-3) for ends in (layout.x, layout.y)]
        x, y = (axis.ravel() for axis in np.meshgrid(*lines))
        values = np.random.default_rng(1).normal(size=(3, len(x), 1)) + 0j
        response = FrequencyResponse.of(
            values, frequency=[1e3, 2e3, 3e3], x=x, y=y, reference="F, N", origin="simulated"
        )
        gap = lattice_gap(response, Plate(layout, forces=(Force("F", (4.5 * PITCH, 2 * PITCH)),)), data)
        assert np.isfinite(data["row_decay"]).all()
        assert (gap.lower, gap.upper) == (None, None)
        assert "rows are offset" in gap.reasons[0]

    def test_no_mode_is_computed_if_a_border_cuts_a_row(self):
        """A row of a kagome lattice begins with single pillars; below the guide pairs lie beside it."""
        layout = laid(self.AROUND, CELLS["kagome"])
        assert [guide.lattice for guide in guides_of(layout)] == [None]
        assert without_mode(layout) == ["no mode computed along p: its border cuts a row of the lattice o"]
        assert without_mode(laid(self.AROUND, CELLS["triangular"])) == []
        both = {strip.inwards: strip.face for strip in strips_of(layout, mirror_beside(layout, "p"))}
        assert both[-1] is None
        assert both[1] is not None


class TestWaves:
    @pytest.mark.nightly
    def test_a_plate_in_two_bases_has_the_same_waves(self, study, monkeypatch):
        """A row of rectangles with two pillars attenuates as two triangular rows do; guides are alike."""
        monkeypatch.setattr("haptonic.vibrometry.theory.DECAYS", 2)
        monkeypatch.setattr("haptonic.vibrometry.theory.STEPS", 1)
        monkeypatch.setattr("haptonic.vibrometry.theory.REACH", (0.97, 0.97))
        pillar, settings = Pillar(3.5e-3, 14.7e-3), study.bands_settings
        triangular = UnitCell(Lattice.triangular(PITCH), THICKNESS, ALUMINIUM, pillar)
        rectangular = UnitCell(
            Lattice.rectangular(PITCH, np.sqrt(3) * PITCH), THICKNESS, ALUMINIUM,
            site=({"at": (0.0, 0.0), "pillar": pillar}, {"at": (0.5, 0.5), "pillar": pillar}),
        )  # fmt: skip
        gap = Gap((6, 7), 56e3, 62e3, 0.0, 0.0, (0.0, 0.0), (0.0, 0.0), True, "", 9)
        waves = []
        for cell, text in (
            (triangular, "oooo oooo" + 4 * " pppp" + " oooo oooo"),
            (rectangular, "oooo pppp pppp oooo"),
        ):
            layout = laid(text, cell)
            guides = [replace(guide, lattice="o") for guide in guides_of(layout)]
            assert guides[0].width == pytest.approx(2 * np.sqrt(3) * PITCH)
            mirror = mirror_beside(layout, "p")
            waves.append(computed_waves(layout, settings, (40e3, 70e3), gap, guides, mirror))
        single, double = waves
        assert float(single["attenuation"].max()) > 5
        assert double["attenuation"].values == pytest.approx(2 * single["attenuation"].values, abs=1e-3)
        assert np.isfinite(single["guided_frequency"].values).all()
        for name in ("guided_frequency", "guided_wavenumber"):
            assert double[name].values == pytest.approx(single[name].values, rel=1e-5, nan_ok=True)

    def test_the_guide_s_mode_is_that_of_a_strip_as_long_as_it_needs(self, study):
        """The mode at a wavenumber is that of a strip with free ends whose length fits it."""
        layout, gap = (
            study.mounted_plate().layout,
            Gap((6, 7), 56e3, 62e3, 0.0, 0.0, (0.0, 0.0), (0.0, 0.0), True, "", 9),
        )
        guides = [replace(guide, along="y", width=32e-3, lattice="lattice") for guide in guides_of(layout)]
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
