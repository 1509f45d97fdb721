"""The highest frequency that tiles resolve, against plane waves that run over tiles of plain plate."""

from functools import cache

import numpy as np
import pytest
import scipy.linalg as la
from small import ALUMINIUM, THICKNESS, drawn

from five_parts import refusing
from haptonic.bloch.plate_waves import PlainPlate
from haptonic.cell import MeshPlan, UnitCell
from haptonic.errors import HaptonicError
from haptonic.lattice import Lattice
from haptonic.plate.body.bending_waves import _bending, highest_resolved, shortest_wavelength
from haptonic.plate.body.model import PlateModel
from haptonic.plate.body.reduction import cell_tile
from haptonic.plate.body.skeleton import numbered
from haptonic.plate.body.tile_construction import Fineness
from haptonic.plate.layout.grid import Block
from haptonic.plate.layout.parts import Plate
from haptonic.plate.layout.supports import Support
from haptonic.plate.vibration.responses import map_spacing
from haptonic.plate.vibration.touch import highest

HZ = 2 * np.pi
EDGE = 8e-3


@cache
def plain_plate():
    return PlainPlate.of(UnitCell(Lattice.square(EDGE), THICKNESS, ALUMINIUM), 7)


def layout_of(edge=EDGE):
    return drawn("pp pp", *(np.linspace(0, 2 * edge, 3) for _ in range(2)))


def repeated(order, components, phase):
    """From unknowns of a period, left and below, to those of the rim of a tile."""
    block = Block((0, 1), (0, 1))
    (rim,), points = numbered(np.array([0, EDGE]), np.array([0, EDGE]), [block], order)
    own, rows = {}, []
    for place in points[rim]:
        over = np.isclose(place, EDGE)
        number = own.setdefault(tuple(np.round(place - EDGE * over, 9)), len(own))
        rows.append((number, phase if over[0] else 1.0))
    matrix = np.zeros((len(rows), len(own)), dtype=complex)
    for k, (number, turn) in enumerate(rows):
        matrix[k, number] = turn
    return np.kron(matrix, np.eye(components))


def nearest(fineness, frequency):
    """Nearest frequency, Hz, of the waves that a tile has at the wavenumber of the bending wave."""
    wavenumber = plain_plate().wavenumber(HZ * frequency, 0.0, "A0")
    cell, orders = UnitCell(Lattice.square(EDGE), THICKNESS, ALUMINIUM), fineness.trace
    tile = cell_tile(cell, MeshPlan.suited(cell, fineness.plain, 0), ((EDGE,), (EDGE,)), orders, frequency)
    phase = np.exp(1j * wavenumber * EDGE)
    whole = la.block_diag(
        repeated(orders.along, orders.per_node, phase),
        repeated(orders.shear, 2, phase),
        np.eye(len(tile.values)),
    )
    forms = (whole.conj().T @ form @ whole for form in (tile.elastic, tile.mass))
    frequencies = np.sqrt(np.maximum(la.eigh(*forms, eigvals_only=True), 0.0)) / HZ
    return frequencies[np.abs(frequencies - frequency).argmin()]


@pytest.mark.parametrize("order", [3, 4, 5])
def test_at_the_highest_frequency_bending_waves_are_a_percent_high(order):
    fineness = Fineness(along=order, plain=max(order, 4))
    limit = highest_resolved(layout_of(), fineness.trace)
    assert 0.005 < nearest(fineness, limit) / limit - 1 < 0.015
    assert nearest(fineness, 0.5 * limit) / (0.5 * limit) - 1 < 0.004


@pytest.mark.parametrize(("frequency", "allowed"), [(20e3, 2e-3), (100e3, 8e-3), (300e3, 0.02)])
def test_bending_waves_are_those_of_the_plate_in_three_dimensions(frequency, allowed):
    wavenumber = plain_plate().wavenumber(HZ * frequency, 0.0, "A0")
    for axis in (0, 1):
        assert _bending(layout_of(), wavenumber, axis) == pytest.approx(HZ * frequency, rel=allowed)
    assert shortest_wavelength(layout_of(), frequency) == pytest.approx(HZ / wavenumber, rel=allowed)


def test_maps_have_eight_points_along_the_shortest_wave_unless_these_are_too_many():
    plate = Plate(layout_of())
    wave = shortest_wavelength(plate.layout, 200e3)
    assert map_spacing(plate, 2e-3, 200e3) == pytest.approx(wave / 8)
    assert map_spacing(plate, 0.1e-3, 200e3) == 0.1e-3
    wide = Plate(layout_of(50 * EDGE))
    assert (100 * EDGE / map_spacing(wide, 20e-3, 200e3)) ** 2 == pytest.approx(20_000)


def test_a_frequency_beyond_it_is_refused_and_smaller_tiles_reach_it():
    limit = highest_resolved(layout_of(), Fineness().trace)
    held = (Support("left", "clamped"),)
    with refusing(HaptonicError, "out-of-range", "frequency") as caught:
        PlateModel.of(Plate(layout_of(), supports=held), 1.01 * limit)
    assert "8 mm" in str(caught.value)
    assert f"{int(limit / 1e3)}." in caught.value.parts()["allowed"]
    assert PlateModel.of(Plate(layout_of(), supports=held), 0.99 * limit).highest == 0.99 * limit
    assert PlateModel.of(Plate(layout_of(EDGE / 2), supports=held), 1.01 * limit)


def test_a_basis_near_a_frequency_ends_at_what_the_tiles_resolve():
    plate, limit = Plate(layout_of()), highest_resolved(layout_of(), Fineness().trace)
    assert highest(plate, 0.5 * limit) > 0.51 * limit
    assert 0.98 * limit < highest(plate, 0.98 * limit) < limit
    assert highest(plate, 1.1 * limit) == 1.1 * limit  # refused later, with this frequency


def test_a_coarse_mesh_of_the_study_is_used_up_to_two_orders_for_each_wave():
    coarse, supports = Fineness(along=2), (Support("left", "clamped"),)
    with refusing(HaptonicError, "out-of-range", "frequency") as caught:
        PlateModel.of(Plate(layout_of(), supports=supports), 1e6, coarse)
    assert "represent" in str(caught.value)
    beyond_a_percent = 1.5 * highest_resolved(layout_of(), coarse.trace)
    assert PlateModel.of(Plate(layout_of(), supports=supports), beyond_a_percent, coarse)


def test_thick_plates_of_small_tiles_are_limited_by_their_thickness():
    tiny = highest_resolved(layout_of(THICKNESS / 50), Fineness().trace)
    assert tiny == highest_resolved(layout_of(THICKNESS / 100), Fineness().trace)
    assert tiny > highest_resolved(layout_of(), Fineness().trace)
