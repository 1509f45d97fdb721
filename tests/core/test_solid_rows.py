"""Rows and ribbons of cells from CAD files and meshes, against plate waves and the mesh of blocks."""

from functools import cache

import numpy as np
import pytest
from strategies import ALUMINIUM
from test_mesh_files import (
    ACROSS,
    COARSE,
    PILLAR,
    PLATE,
    SQUARE,
    STEEL,
    THICKNESS,
    TRIANGULAR,
    UPWARD,
    cell_of,
)  # fmt: skip
from test_ribbon import strip_waves

from haptonic.bloch import Resolution
from haptonic.bloch.centred import lattice_pencil
from haptonic.bloch.evanescent import bloch_waves
from haptonic.bloch.guide import Guide
from haptonic.bloch.layers import OUTGOING, Interface
from haptonic.bloch.pencil import eigenpairs
from haptonic.bloch.plate_waves import FAMILIES
from haptonic.bloch.ribbon import RibbonModel
from haptonic.bloch.rows import CondensedRows, attenuation
from haptonic.cell import Disc, Ribbon, UnitCell
from haptonic.lattice import Lattice
from haptonic.superelement import Tiling

pytest.importorskip("ngsolve")

from test_cad_files import PILLAR as ROUND, drawn

from haptonic.superelement.surplus import EDGE
from mesh_cells import hexahedra, write

LEFT = 1 / (1.5 ** (4 * EDGE) - 1)  # error of order 3 over its distance to order 2, at an edge

MM, KILOHERTZ = 1e-3, 2e3 * np.pi
OBLIQUE = 20.0  # rad/m along the rows: all three families propagate from 20 kHz on
SQUARE_PILLAR = Disc(3 * MM, low=0.0, high=4 * MM, section="square", material=STEEL)
BLOCKS = UnitCell(SQUARE, THICKNESS, ALUMINIUM, disc=(SQUARE_PILLAR,))


def three_quarters(x, y, z):
    return "plate" if z < 1.5 else "pillar" if max(abs(x), abs(y)) < 1.5 and (x > 0 or y > 0) else ""


MESHES = {
    "plate": PLATE,
    "pillar": PILLAR,
    "corner": hexahedra(ACROSS, UPWARD, three_quarters),
    "mirrored": hexahedra(ACROSS, UPWARD, lambda x, y, z: three_quarters(-x, y, z)),
}


@pytest.fixture(scope="module")
def cells(tmp_path_factory):
    """The cell of a mesh by its name."""
    folder = tmp_path_factory.mktemp("meshes")

    @cache
    def of_mesh(name):
        mesh = MESHES[name]
        parts = {"pillar": STEEL} if "pillar" in mesh[2] else {}
        return cell_of(write(folder / f"{name}.msh", *mesh), **parts)

    return of_mesh


@pytest.fixture(scope="module")
def rows(cells):
    """Rows of a mesh by its name and the order of its elements."""
    return cache(lambda name, order=2: CondensedRows.of(cells(name), Resolution(order, 0)))


def shares(here, kilohertz, along, count=3, loss_factor=0.0):
    return Interface.of(here, along).scattering(kilohertz * KILOHERTZ, count, FAMILIES, loss_factor)


class TestLayers:
    @pytest.mark.parametrize("along", [0.0, OBLIQUE])
    def test_a_mesh_of_plain_plate_transmits_every_plate_wave(self, rows, along):
        scattering = shares(rows("plate"), 40.0, along)
        for number, family in enumerate(FAMILIES):
            assert scattering.transmitted[:, number, OUTGOING.index(family)] == pytest.approx(1.0, abs=1e-4)

    def test_waves_of_a_plain_mesh_are_plate_waves(self, rows):
        """Those that propagate, and the flexural one that decays along the normal."""
        here, omega = rows("plate"), 40.0 * KILOHERTZ
        waves, _ = bloch_waves(here.slab(0.0).at(omega), omega)
        plate, _ = Interface.of(here, 0.0).plate_waves(omega)
        expected = 1j * plate.wavenumber[plate.harmonic == 0] * 7 * MM
        expected = expected[np.abs(expected.real) < 3]  # farther waves are shorter than the elements
        apart = np.abs(np.exp(waves.exponent)[:, None] - np.exp(expected))
        assert len(expected) > len(FAMILIES)
        assert apart.min(axis=0).max() < 5e-3

    def test_a_pillar_transmits_as_much_as_its_block_mesh(self, rows):
        """Insulation and decay: as far from those of the blocks as the orders of the mesh foretell."""
        coarse, fine = (self.measured(rows("pillar", order)) for order in (2, 3))
        exact = self.measured(CondensedRows.of(BLOCKS, Resolution(3, 1)))
        allowed = 2 * LEFT * np.abs(fine - coarse).max()
        assert np.abs(fine - exact).max() < allowed
        assert np.abs(fine - exact).max() < 0.5
        assert exact.max() > 5

    @staticmethod
    def measured(here):
        """Insulation and decay, dB."""
        through = [shares(here, kilohertz, along).insulation.ravel() for kilohertz in (20.0, 30.0)
                   for along in (0.0, OBLIQUE)]  # fmt: skip
        return np.concatenate([*through, attenuation(here, np.array([30.0 * KILOHERTZ]), np.array([2.0]))[0]])

    def test_energy_is_conserved_and_conversions_go_both_ways(self, rows):
        scattering = shares(rows("pillar"), 45.0, OBLIQUE)
        assert np.abs(scattering.dissipated).max() < 1e-9
        own = scattering.transmitted[:, :, : len(FAMILIES)]
        assert own == pytest.approx(own.swapaxes(1, 2), abs=1e-6)
        assert own[2, 0, 1] > 1e-4  # A0 to S0: pillars on one face convert

    def test_a_cell_transmits_one_way_as_much_as_its_mirror_image_the_other_way(self, rows):
        """Reciprocity: from the left through a cell as from the left through its image, the families
        exchanged."""
        corner, mirrored = (shares(rows(name), 45.0, 0.0) for name in ("corner", "mirrored"))
        families = slice(len(FAMILIES))
        image = mirrored.transmitted[:, :, families].swapaxes(1, 2)
        assert corner.transmitted[:, :, families] == pytest.approx(image, abs=1e-6)
        assert np.abs(corner.reflected - mirrored.reflected).max() > 1e-3

    def test_waves_that_propagate_are_those_of_the_bands(self, rows):
        here, phase, omega = rows("corner"), 0.7, 30.0 * KILOHERTZ
        right, left = bloch_waves(here.slab(phase).at(omega), omega)
        tile = here.blocks[-1][1].tiles[0]
        pencil = lattice_pencil(Tiling.single(tile))
        moving = 0
        for waves in (right, left):
            kappa = -1j * here.exponents(waves, phase)[waves.propagates]
            for phases in here.rows.phases(phase, kappa.real):
                bands = np.sqrt(np.abs(eigenpairs(pencil, phases, 10)[0]))
                assert np.abs(bands / omega - 1).min() < 1e-7
            moving += len(kappa)
        assert moving

    def test_losses_are_proportional_to_a_small_loss_factor(self, rows):
        first, second = (shares(rows("pillar"), 30.0, OBLIQUE, 3, loss) for loss in (1e-5, 2e-5))
        assert (first.dissipated > 0).all()
        assert second.dissipated == pytest.approx(2 * first.dissipated, rel=2e-2)

    @pytest.mark.nightly
    @pytest.mark.parametrize(
        ("lattice", "along"), [(SQUARE, (0, 1)), (SQUARE, (1, 1)), (TRIANGULAR, (0, 1))],
        ids=["square", "diagonal", "triangular"],
    )  # fmt: skip
    def test_a_drawn_pillar_transmits_as_much_as_its_block_mesh(self, tmp_path, lattice, along):
        """Also where a slab is several rows, and behind the plate that leads to a zigzag."""
        blocks, solids = drawn(tmp_path, lattice, ROUND)
        insulations = [
            np.concatenate([shares(here, kilohertz, OBLIQUE).insulation for kilohertz in (30.0, 60.0)])
            for here in (CondensedRows.of(cell, Resolution(3, 1), along) for cell in (blocks, solids))
        ]
        assert insulations[1] == pytest.approx(insulations[0], abs=0.15)
        assert insulations[0].max() > 5


STRIP = UnitCell(SQUARE, THICKNESS, ALUMINIUM)


def ribbon_modes(columns, phase, high, resolution=COARSE):
    return RibbonModel.of(Ribbon(columns), resolution).solve(phase, 5e3, high)


class TestRibbons:
    @pytest.mark.nightly
    def test_a_strip_of_mesh_and_plain_plate_has_its_guided_waves(self, cells):
        """Two columns, one from a mesh, against polynomials over the section of the whole strip."""
        modes = ribbon_modes((cells("plate"), STRIP), 0.9, 45e3, Resolution(3, 0))
        zone = 2 * np.pi / (7 * MM)
        waves = [strip_waves(14 * MM, THICKNESS, 0.9 / (7 * MM) + shift * zone) for shift in (-1, 0)]
        exact = np.sort(np.concatenate(waves))
        exact = exact[(exact > 5e3) & (exact < 45e3)]
        assert len(modes.frequency) == len(exact) == 3
        assert (np.abs(modes.frequency - exact) <= modes.error + 1e-5 * exact).all()
        assert modes.frequency == pytest.approx(exact, rel=1e-3)

    @pytest.mark.nightly
    def test_pillars_of_a_mesh_hold_the_waves_that_those_of_blocks_do(self, cells):
        pillar = cells("pillar")
        own = ribbon_modes((pillar, STRIP, pillar), 2.0, 45e3, Resolution(3, 0))
        exact = ribbon_modes((BLOCKS, STRIP, BLOCKS), 2.0, 45e3, Resolution(3, 1))
        assert (np.abs(own.frequency - exact.frequency) <= own.error + exact.error).all()
        assert own.frequency == pytest.approx(exact.frequency, rel=4e-2)
        share = [modes.energy[:, 0] / modes.energy.sum(axis=(1, 2))[:, None] for modes in (own, exact)]
        assert share[0] == pytest.approx(share[1], abs=0.05)

    def test_a_ribbon_and_its_mirror_image_have_the_same_waves(self, cells):
        modes = ribbon_modes((cells("corner"), STRIP), 1.3, 45e3)
        other = ribbon_modes((STRIP, cells("mirrored")), 1.3, 45e3)
        assert modes.frequency == pytest.approx(other.frequency, rel=1e-6)
        assert modes.energy[:, 0] == pytest.approx(other.energy[:, 0, ::-1], rel=1e-3)
        wrong = ribbon_modes((STRIP, cells("corner")), 1.3, 45e3)
        assert np.abs(modes.frequency / wrong.frequency - 1).max() > 1e-5


class TestGuides:
    PHASE, FREQUENCY = 1.4, 38.0  # no wave of these pillars propagates across them there

    def guide(self, rows):
        return Guide.of(rows, self.PHASE / (7 * MM))

    def width(self, rows):
        return self.guide(rows).width(self.FREQUENCY * KILOHERTZ, 0)

    def test_a_strip_between_pillars_of_a_mesh_is_as_wide_as_between_those_of_blocks(self, rows):
        coarse, fine = (self.width(rows("pillar", order)) for order in (2, 3))
        exact = self.width(CondensedRows.of(BLOCKS, Resolution(3, 1)))
        assert abs(fine - exact) < 2 * LEFT * abs(fine - coarse)
        assert fine == pytest.approx(exact, rel=6e-2)

    def test_the_ribbon_of_this_width_has_the_guides_mode(self, cells, rows):
        """Plate waves between two half-infinite mirrors against one joint of tiles."""
        half = 0.5 * self.width(rows("pillar"))
        strip = UnitCell(Lattice.rectangular(half, 7 * MM), THICKNESS, ALUMINIUM)
        columns = (*[cells("pillar")] * 5, strip, strip, *[cells("pillar")] * 5)
        model = RibbonModel.of(Ribbon(columns), COARSE)
        frequencies = model.frequencies(self.PHASE, 36e3, 40e3)
        assert np.abs(frequencies / (1e3 * self.FREQUENCY) - 1).min() < 2e-3
