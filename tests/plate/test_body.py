"""Plain plate with patches: exact thick plate, laminated beam, invariants of every part."""

import json
from dataclasses import fields, replace
from pathlib import Path

import numpy as np
import pytest
import scipy.sparse as sp
from fields import factorised, patch, settled, total
from hypothesis import given, settings, strategies as st
from scipy.sparse.linalg import LinearOperator, eigsh

from haptonic.materials import IsotropicMaterial, PiezoelectricMaterial, material
from haptonic.plate.body.unreduced import BodyOrders, body, free_patch, loss_factors
from haptonic.plate.layout.grid import Layout
from haptonic.plate.layout.keys import PLATE, bond, ceramic, electric
from haptonic.plate.layout.parts import Bond, Plate
from motions import rigid_motions, unit_strains

ALUMINIUM, CERAMIC, GLUE = material("aluminium-paper"), material("pzt-4"), material("silver-epoxy")
ORDERS = BodyOrders(along=2, plate=2, bond=1, ceramic=2)
GLUED = patch(CERAMIC, (5e-3, 4e-3, 0.7e-3), (5e-3, 4e-3), Bond(0.1e-3, GLUE))
BARE = patch(material("pzt-5a"), (3e-3, 5e-3, 0.5e-3), (11e-3, 4.5e-3), name="B")
SOLIDS = {
    PLATE: ALUMINIUM,
    bond("A"): GLUE,
    ceramic("A"): CERAMIC,
    ceramic("B"): BARE.material,
}
VOLUMES = {  # m^3
    PLATE: 13e-3 * 8e-3 * 2e-3,
    bond("A"): 5e-3 * 4e-3 * 0.1e-3,
    ceramic("A"): 5e-3 * 4e-3 * 0.7e-3,
    ceramic("B"): 3e-3 * 5e-3 * 0.5e-3,
}


def block(x=(0.0, 8e-3, 13e-3), y=(0.0, 8e-3), orders=ORDERS, longest=4e-3):
    return body(x, y, 2e-3, ALUMINIUM, (GLUED, BARE), orders, longest)


def test_a_thick_plate_has_its_exact_frequencies():
    """60 x 45 x 6 mm, no motion along the side faces; twenty modes to 78 kHz."""
    path = Path(__file__).parents[1] / "data/simply_supported_plate.json"
    exact = [mode["hz"] for mode in json.loads(path.read_text("utf-8"))["modes"]]
    plate = body((0.0, 60e-3), (0.0, 45e-3), 6e-3, ALUMINIUM, (), BodyOrders(6, 5, 1, 1), longest=16e-3)
    assert set(plate.stiffness) == {PLATE}
    x, y, _ = plate.points.T
    held = np.zeros((len(plate.points), 3), dtype=bool)
    for across, along, end in ((x, 1, 60e-3), (y, 0, 45e-3)):
        side = (across == 0.0) | (across == end)
        held[side, along] = held[side, 2] = True
    assert np.array_equal(np.flatnonzero(held.any(axis=1)), plate.rim)
    free = np.flatnonzero(~held.ravel())
    K = total(plate)[free][:, free]
    solve = LinearOperator(K.shape, factorised(K).solve, dtype=float)
    start = np.random.default_rng(1).standard_normal(len(free))
    squared = eigsh(
        K, 20, sp.diags_array(plate.mass[free]), sigma=0.0, v0=start, OPinv=solve, return_eigenvectors=False
    )
    assert np.sort(np.sqrt(squared)) / (2 * np.pi) == pytest.approx(exact, rel=1e-6)


def test_every_part_is_symmetric_and_leaves_rigid_motions_alone():
    block_of_all = block()
    motions = rigid_motions(block_of_all.points).T
    assert set(block_of_all.stiffness) == {*SOLIDS, electric("A"), electric("B")}
    for part in [*block_of_all.stiffness.values(), total(block_of_all)]:
        scale = abs(part).max()
        assert abs(part - part.T).max() < 1e-14 * scale
        assert np.abs(part @ motions).max() < 1e-13 * scale
    for drive in block_of_all.drive.values():
        reach = np.abs(drive) @ np.abs(motions)
        assert np.abs(drive @ motions).max() < 1e-12 * reach.max()


def test_the_whole_has_no_other_free_motion_and_stores_energy():
    small = BodyOrders(1, 1, 1, 2)
    values = np.linalg.eigvalsh(total(block(orders=small, longest=1.0)).toarray())
    assert (np.abs(values[:6]) < 1e-12 * values[-1]).all()
    assert values[6] > 1e-6 * values[-1]


def test_mass_and_its_centre_are_those_of_the_boxes():
    mesh = block()
    mass = mesh.mass.reshape(-1, 3)
    assert (mass == mass[:, :1]).all()
    expected = {part: SOLIDS[part].density * volume for part, volume in VOLUMES.items()}
    centres = {
        PLATE: (6.5e-3, 4e-3, 1e-3),
        bond("A"): (5e-3, 4e-3, 2.05e-3),
        ceramic("A"): (5e-3, 4e-3, 2.45e-3),
        ceramic("B"): (11e-3, 4.5e-3, 2.25e-3),
    }
    assert mass[:, 0].sum() == pytest.approx(sum(expected.values()), rel=1e-12)
    moment = sum(expected[part] * np.array(centres[part]) for part in expected)
    assert mass[:, 0] @ mesh.points == pytest.approx(moment, rel=1e-12)


def lines(end):
    """Lines between tiles: the ends and a few anywhere between, as close as they like to a patch's edge."""
    return st.lists(st.floats(0.01, 0.99), max_size=3).map(
        lambda shares: [0.0, *sorted({round(s, 3) * end for s in shares}), end]
    )


@settings(max_examples=15)
@given(lines(13e-3), lines(8e-3), st.sampled_from([2e-3, 5e-3, 1.0]), st.integers(1, 2))
def test_linear_fields_are_exact_wherever_the_lines_run(x, y, longest, along):
    """Energy of each part is that of its constants, and inside each part the stress is in balance."""
    mesh = block(x, y, replace(ORDERS, along=along), longest)
    fields = unit_strains(mesh.points)
    ends = {PLATE: (0.0, 2e-3), ceramic("A"): (2.1e-3, 2.8e-3)}
    for part, solid in SOLIDS.items():
        K = mesh.stiffness[part]
        energy = fields @ (K @ fields.T) / VOLUMES[part]
        assert np.abs(energy - solid.stiffness).max() < 1e-9 * solid.stiffness.max()
    for part, (low, high) in ends.items():
        own = np.unique(mesh.elements[part])
        on_skin = np.isclose(mesh.points[:, 2], low) | np.isclose(mesh.points[:, 2], high)
        for axis in (0, 1):
            place = mesh.points[:, axis]
            on_skin |= np.isclose(place, place[own].min()) | np.isclose(place, place[own].max())
        forces = (mesh.stiffness[part] @ fields.T).reshape(-1, 3, 6)
        inside = np.setdiff1d(own, np.flatnonzero(on_skin))
        assert len(inside) or along == 1
        assert np.abs(forces[inside]).max(initial=0) < 1e-9 * np.abs(forces).max()


@settings(max_examples=10)
@given(lines(13e-3), lines(8e-3))
def test_charge_of_a_uniform_strain_is_that_of_the_constants(x, y):
    """Strains along the axes make no field between joined electrodes: Q = -(e S)_3 times the area."""
    mesh = block(x, y)
    fields = unit_strains(mesh.points)[[0, 1, 2, 5]]
    for actuator in (GLUED, BARE):
        e = np.array(actuator.material.coupling)[2, [0, 1, 2, 5]]
        area = actuator.size[0] * actuator.size[1]
        assert fields @ mesh.drive[actuator.name] == pytest.approx(-e * area, rel=1e-9, abs=1e-12 * area)
        field = mesh.stiffness[electric(actuator.name)]
        assert np.abs(field @ fields.T).max() < 1e-9 * abs(field).max() * np.abs(fields).max()
        eps = actuator.material.permittivity[2][2]
        assert mesh.capacitance[actuator.name] == pytest.approx(eps * area / actuator.size[2], rel=1e-9)


def test_nodes_lie_once_at_each_place_and_elements_fill_the_boxes():
    x, y = (0.0, 8e-3, 13e-3), (0.0, 3e-3, 8e-3)
    mesh = block(x, y, longest=2.2e-3)
    assert len(np.unique(mesh.points.round(9), axis=0)) == len(mesh.points)
    used = np.concatenate([nodes.ravel() for nodes in mesh.elements.values()])
    assert np.array_equal(np.unique(used), np.arange(len(mesh.points)))
    through = {PLATE: 2, bond("A"): 1, ceramic("A"): 2, ceramic("B"): 2}
    for part, nodes in mesh.elements.items():
        assert nodes.shape[1:] == (3, 3, through[part] + 1)
        extent = mesh.points[nodes[:, -1, -1, -1]] - mesh.points[nodes[:, 0, 0, 0]]
        assert (extent > 0).all()
        assert extent[:, :2].max() <= 2.2e-3 * (1 + 1e-12)
        assert extent.prod(axis=1).sum() == pytest.approx(VOLUMES[part], rel=1e-12)
    for axis, between in ((0, (*x, 2.5e-3, 7.5e-3, 9.5e-3, 12.5e-3)), (1, (*y, 2e-3, 6e-3, 7e-3))):
        borders = mesh.points[mesh.elements[PLATE][:, [0, -1]][:, :, [0, -1], 0], axis]
        for line in between:
            assert np.isclose(borders, line, atol=1e-12).any()


def test_the_flat_face_and_the_rim_are_where_the_plate_ends():
    mesh = block()
    (face,) = mesh.faces
    assert (mesh.points[face, 2] == 0.0).all()
    corners = mesh.points[face[:, [0, -1]][:, :, [0, -1]]]
    area = np.prod(corners[:, -1, -1, :2] - corners[:, 0, 0, :2], axis=1)
    assert area.sum() == pytest.approx(13e-3 * 8e-3)
    x, y, z = mesh.points.T
    at_side = (np.isin(x, (0.0, 13e-3)) | np.isin(y, (0.0, 8e-3))) & (z <= 2e-3)
    assert np.array_equal(mesh.rim, np.flatnonzero(at_side))


def test_an_edge_on_a_line_is_that_line_whatever_the_rounding():
    x = (0.0, 0.3, 0.9)
    on_line = patch(CERAMIC, (0.2, 0.2, 1e-3), (0.4, 0.5))
    assert on_line.centre[0] - on_line.size[0] / 2 != x[1]
    mesh = body(x, (0.0, 1.0), 2e-3, ALUMINIUM, (on_line,), BodyOrders(1, 1, 1, 1), longest=1.0)
    assert len(mesh.elements[PLATE]) == 3 * 3
    assert sorted(set(mesh.points[:, 0])) == [0.0, 0.3, 0.5, 0.9]
    assert (0.1 + 0.2) / 0.1 > 3.0  # as computed, yet three elements will do
    evenly = body((0.0, 0.1 + 0.2), (0.0, 0.1), 2e-3, ALUMINIUM, (), BodyOrders(1, 1, 1, 1), longest=0.1)
    assert len(evenly.elements[PLATE]) == 3
    beside = replace(on_line, centre=(0.4 + 1e-6, 0.5))  # a micrometre apart is apart
    mesh = body(x, (0.0, 1.0), 2e-3, ALUMINIUM, (beside,), BodyOrders(1, 1, 1, 1), longest=1.0)
    assert len(mesh.elements[PLATE]) == 4 * 3


def test_patches_that_leave_the_block_or_overlap_are_a_mistake_of_the_caller():
    with pytest.raises(AssertionError, match="leaves"):
        body((0.0, 7e-3), (0.0, 8e-3), 2e-3, ALUMINIUM, (GLUED,), ORDERS, 4e-3)
    with pytest.raises(AssertionError, match="overlap"):
        body((0.0, 13e-3), (0.0, 8e-3), 2e-3, ALUMINIUM, (GLUED, replace(GLUED, name="C")), ORDERS, 4e-3)
    touching = replace(GLUED, name="C", centre=(10e-3, 4e-3))
    mesh = body((0.0, 13e-3), (0.0, 8e-3), 2e-3, ALUMINIUM, (GLUED, touching), ORDERS, 4e-3)
    shared = np.intersect1d(mesh.elements[ceramic("A")], mesh.elements[ceramic("C")])
    assert len(shared) == 0  # side by side, yet not one piece


def curvature_of_laminate(layers, bending_stiffening, force):
    """Curvature of a free strip that bends into a cylinder, 1/m.

    layers : (thickness, modulus) from below; the last one is driven and varies its stress with a modulus
        ``bending_stiffening`` times higher than its mean stress
    force : that the driven layer adds, N/m
    """
    heights = np.cumsum([0.0, *(thickness for thickness, _ in layers)])
    middle = (heights[1:] + heights[:-1]) / 2
    thick, moduli = np.array(layers).T
    own = moduli * thick**3 / 12
    own[-1] *= bending_stiffening
    stretch, mixed = (moduli * thick).sum(), (moduli * thick * middle).sum()
    bend = (moduli * thick * middle**2 + own).sum()
    # stress resultants of the strain e - k z vanish: stretch e - mixed k = force, mixed e - bend k = force z
    _, curvature = np.linalg.solve([[stretch, -mixed], [mixed, -bend]], [force, force * middle[-1]])
    return curvature


@pytest.mark.parametrize("glued", [False, True])
def test_a_strip_bends_as_a_laminate(glued):
    """Wide strip, S_2 = 0 and T_3 = 0, far from its ends.

    Bending leaves D_3 uniform through the ceramic: what varies of its stress meets the modulus at constant D.
    """
    length, width, plate, bond, thickness = 20e-3, 1e-3, 1.0e-3, 0.05e-3, 0.8e-3
    glue = Bond(bond, GLUE) if glued else None
    actuator = patch(CERAMIC, (length, width, thickness), (length / 2, width / 2), glue)
    mesh = body(
        (0.0, length), (0.0, width), plate, ALUMINIUM, (actuator,), BodyOrders(3, 3, 2, 3), longest=1.25e-3
    )
    u = settled(mesh, 100.0 * mesh.drive["A"], 3 * np.arange(len(mesh.points)) + 1).reshape(-1, 3)
    x, y, z = mesh.points.T
    (lowest,) = np.nonzero((y == 0.0) & (z == 0.0) & (np.abs(x - length / 2) < 2.6e-3))
    bow = 2 * np.polyfit(x[lowest] / length, u[lowest, 2], 2)[0] / length**2

    c, e, eps = CERAMIC.stiffness, np.array(CERAMIC.coupling)[2], CERAMIC.permittivity[2][2]
    modulus = c[0, 0] - c[0, 2] ** 2 / c[2, 2]
    charge = e[0] - c[0, 2] * e[2] / c[2, 2]
    stiffening = 1 + charge**2 / (eps + e[2] ** 2 / c[2, 2]) / modulus
    layers = [(plate, plane_strain(ALUMINIUM)), (bond, plane_strain(GLUE)), (thickness, modulus)]
    # T_1 = modulus S_1 - charge E_3 with E_3 = -V / t
    expected = curvature_of_laminate(layers if glued else layers[::2], stiffening, -charge * 100.0)
    assert expected < 0  # the patch above spreads at a positive voltage, so the ends of the strip go down
    assert bow == pytest.approx(expected, rel=1e-5 if glued else 1e-8)  # glue carries the ends farther in


def plane_strain(solid):
    return solid.youngs_modulus / (1 - solid.poisson_ratio**2)


def test_loss_factors_are_those_of_the_constants_they_scale():
    """What a real factor on the permittivity does, a complex one does."""
    glued = patch(CERAMIC, bond=Bond(0.1e-3, GLUE))
    layout = Layout((("tile",),), (0.0, 1.0), (0.0, 1.0), {}, 2e-3, ALUMINIUM)
    factors = loss_factors(Plate(layout, actuators=(glued, replace(BARE, voltage=0.0)), loss_factor=0.002))
    assert set(factors) == {PLATE, bond("A"), ceramic("A"), electric("A"), ceramic("B"), electric("B")}
    assert factors[PLATE] == 1 + 0.002j
    assert factors[bond("A")] == 1 + 1j * GLUE.loss_factor
    assert factors[ceramic("A")] == 1 + 1j * CERAMIC.loss_factor
    lossy = 1 - 1j * CERAMIC.clamped_loss
    assert factors[electric("A")] == 1 / lossy
    assert all(factor.imag > 0 for factor in factors.values())  # power is lost, not won
    ratio = 1.7

    class More(PiezoelectricMaterial):
        permittivity = CERAMIC.permittivity * ratio

    more = More(**{field.name: getattr(CERAMIC, field.name) for field in fields(CERAMIC)})
    usual, other = (free_patch(replace(glued, material=solid), ORDERS, 4e-3) for solid in (CERAMIC, more))
    scale = abs(usual.stiffness[electric("A")]).max()
    assert abs(other.stiffness[electric("A")] - usual.stiffness[electric("A")] / ratio).max() < 1e-12 * scale
    assert other.capacitance["A"] == pytest.approx(usual.capacitance["A"] * ratio, rel=1e-12)
    assert other.drive["A"] == pytest.approx(usual.drive["A"], abs=1e-12 * np.abs(usual.drive["A"]).max())


def test_a_free_patch_is_the_ceramic_of_a_body():
    alone = free_patch(BARE, ORDERS, 1.0)
    whole = body((9.5e-3, 12.5e-3), (2e-3, 7e-3), 2e-3, ALUMINIUM, (BARE,), ORDERS, 1.0)
    own = np.unique(whole.elements[ceramic("B")])
    order = np.lexsort(whole.points[own].T[::-1].round(9))
    own = own[order]
    placed = alone.points + np.array([0.0, 0.0, 2e-3])
    assert whole.points[own] == pytest.approx(placed[np.lexsort(placed.T[::-1].round(9))])
    unknowns = (3 * own[:, None] + np.arange(3)).ravel()
    sorted_alone = np.lexsort(alone.points.T[::-1].round(9))
    ours = (3 * sorted_alone[:, None] + np.arange(3)).ravel()
    for part in (ceramic("B"), electric("B")):
        difference = whole.stiffness[part][unknowns][:, unknowns] - alone.stiffness[part][ours][:, ours]
        assert abs(difference).max() < 1e-11 * abs(alone.stiffness[part]).max()
    assert whole.drive["B"][unknowns] == pytest.approx(alone.drive["B"][ours], abs=1e-9)
    assert whole.capacitance["B"] == pytest.approx(alone.capacitance["B"])


def test_a_stiffer_plate_moves_less_under_the_same_voltage():
    """Second law of the drive: between free and clamped, the charge falls as the plate gets stiffer."""
    charges = []
    for young in (1e6, 70e9, 1e13):
        plate = IsotropicMaterial(young, 0.33, 2700.0, name="plate")
        mesh = body((2e-3, 8e-3), (1e-3, 7e-3), 2e-3, plate, (GLUED,), ORDERS, 4e-3)
        u = settled(mesh, mesh.drive["A"])
        charges.append(mesh.capacitance["A"] + mesh.drive["A"] @ u)
    assert charges[0] > charges[1] > charges[2] > mesh.capacitance["A"]
