"""The same plate with other numbers, without new tiles, against plates made for these numbers."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from small import COARSE, LOSS, glued, plain_plate
from whole import answered

from haptonic.plate import Band, Force, Plate, PlateModel, Support
from haptonic.plate.body.bonds import Bonded
from haptonic.plate.body.parameter_update import updated
from haptonic.plate.body.unreduced import BodyOrders, body
from haptonic.plate.layout.keys import PLATE, bond as bond_of, ceramic, electric
from haptonic.plate.vibration.parameter_family import Family, anchored

HIGHEST = 40e3
POINTS = np.array([(3e-3, 4e-3), (10e-3, 12e-3), (19e-3, 5e-3)])
LINES = np.linspace(5e3, HIGHEST, 40)


def stiffer(plate, factor):
    layout = plate.layout
    material = replace(layout.material, youngs_modulus=factor * layout.material.youngs_modulus)
    return replace(plate, layout=replace(layout, material=material))


def patched(bond=50e-6, springs=3e11, factor=1.0, loss=LOSS):
    patch = glued((10.5e-3, 3.5e-3), (5e-3, 5e-3, 0.5e-3))
    plate = plain_plate(
        2,
        3,
        supports=(Support("left", "spring", stiffness=springs, loss_factor=0.05),),
        actuators=(replace(patch, bond=replace(patch.bond, thickness=bond)),),
    )
    return replace(stiffer(plate, factor), loss_factor=loss)


OTHER = {"bond": 90e-6, "springs": 1.2e12, "factor": 1.06, "loss": 8e-3}


@cache
def model():
    return PlateModel.of(patched(), HIGHEST, COARSE, {"A": (25e-6, 120e-6)})


def displacement(of, vectors):
    return (of.observed(POINTS) @ vectors).T


def apart(value, reference):
    return np.linalg.norm(value - reference) / np.linalg.norm(reference)


def test_three_thicknesses_of_a_bond_give_every_other():
    """Exactly: the bond's stiffness and the whole mass, against the mesh of that thickness."""
    layout, orders = patched().layout, BodyOrders(2, 2, 2, 2)

    def of(thickness):
        actuators = patched(thickness).actuators
        x, y = layout.x[:3], layout.y[:3]
        return body(x, y, layout.thickness, layout.material, actuators, orders, 8e-3)

    ends = np.array([20e-6, 50e-6, 125e-6])
    bonded = Bonded(ends, tuple(of(t) for t in ends), 40e-6)
    size = len(of(40e-6).mass)
    basis = np.random.default_rng(0).standard_normal((size, 3))
    glue = bonded.projected("A", basis)
    for thickness in (30e-6, 40e-6, 110e-6):
        exact = of(thickness)
        stiffness = basis.T @ (exact.stiffness[bond_of("A")] @ basis)
        interpolated = np.tensordot(glue.shares(thickness), glue.stiffness, 1)
        assert apart(interpolated, stiffness) < 1e-9
        own = basis.T @ (of(40e-6).mass[:, None] * basis) + (thickness - 40e-6) * glue.slope
        assert apart(own, basis.T @ (exact.mass[:, None] * basis)) < 1e-12
        for part in (PLATE, ceramic("A"), electric("A")):
            same = of(40e-6).stiffness[part]
            assert abs(exact.stiffness[part] - same).max() < 1e-9 * abs(same).max()


def test_answers_are_those_of_new_tiles():
    plate = patched(**OTHER)
    new = PlateModel.of(plate, HIGHEST, COARSE)
    changed = updated(model(), plate).model
    omegas = 2 * np.pi * LINES[::8]
    moved, expected = (displacement(of, answered(of, {"A": 1.0}, omegas)) for of in (changed, new))
    before = displacement(model(), answered(model(), {"A": 1.0}, omegas))
    assert apart(moved, expected) < 4e-3
    assert apart(before, expected) > 0.5, "the numbers matter"


def test_vectors_come_back_to_the_old_unknowns():
    """The same displacement, by the old model's unknowns and by the new one's."""
    other = updated(model(), patched(**OTHER))
    vectors = np.random.default_rng(1).standard_normal((model().assembly.size, 2))
    assert apart(displacement(model(), other.back(vectors)), displacement(other.model, vectors)) < 1e-10
    heavy = other.model.assembly.stiffness_times(vectors)
    assert np.einsum("nk,nk->k", vectors, heavy) == pytest.approx(
        np.einsum("nk,nk->k", other.back(vectors), whole_stiffness(other.back(vectors))), rel=1e-9
    )


def whole_stiffness(vectors):
    """Forces on the old unknowns by the stiffness of the other numbers, tile by tile."""
    plate, assembly = patched(**OTHER), model().assembly
    pieces = []
    for group, share in assembly.shares(vectors):
        parts = {
            name: part * (OTHER["factor"] if name == PLATE else 1)
            for name, part in group.tile.stiffness.items()
        }
        for name, bond in group.tile.bonds.items():
            parts[bond_of(name)] = np.tensordot(bond.shares(OTHER["bond"]), bond.stiffness, 1)
        pieces.append(np.einsum("ij,jbk->ibk", sum(parts.values()), share))
    forces = assembly.gathered(pieces)
    ratio = plate.supports[0].stiffness / model().plate.supports[0].stiffness
    forces[: assembly.free] += ratio * (assembly.foundations @ vectors[: assembly.free])
    return forces


@pytest.mark.parametrize("factor", [0.8, 1.3])
def test_a_stiffer_plate_is_a_faster_one(factor):
    """Stiffness of plate and springs times s: the answer at f sqrt(s) is the old one at f over s."""
    plate = plain_plate(2, 2, supports=(Support("left", "spring", stiffness=3e11, loss_factor=0.05),),
                        forces=(Force("F", (9e-3, 5e-3), None),))  # fmt: skip
    springs = (replace(plate.supports[0], stiffness=3e11 * factor),)
    old = PlateModel.of(plate, HIGHEST, COARSE)
    new = updated(old, replace(stiffer(plate, factor), supports=springs)).model
    omegas = 2 * np.pi * np.array([4e3, 11e3, 23e3])
    answer = answered(new, {"F": 1.0}, omegas * np.sqrt(factor))
    assert apart(factor * answer, answered(old, {"F": 1.0}, omegas)) < 1e-9


def test_a_family_answers_as_the_whole_plate():
    """Between its anchors, with other losses too, against dense solutions of all unknowns."""
    plates = [patched(30e-6, 1e11, 0.92, 4e-3), patched(100e-6, 2e12, 1.08, 4e-3)]
    drives = {"A": 1.0}
    anchors = [anchored(model(), plate, drives, LINES, 1e-3, POINTS) for plate in plates]
    family = Family.spanned(model(), anchors, drives, POINTS)
    omegas = 2 * np.pi * LINES[::6]
    asked = patched(60e-6, 5e11, 1.03, 9e-3)
    turned = updated(model(), asked).model
    exact = displacement(turned, answered(turned, drives, omegas))
    assert apart(family.poles(asked).displacement(omegas), exact) < 2e-2
    for plate, anchor in zip(plates, anchors, strict=True):
        assert apart(family.poles(plate).displacement(2 * np.pi * LINES), anchor.displacement) < 1e-3
    more = Family.spanned(
        model(), [*anchors, anchored(model(), asked, drives, LINES, 1e-3, POINTS)], drives, POINTS
    )
    assert apart(more.poles(asked).displacement(omegas), exact) < 1e-3


def test_poles_are_the_modes():
    """Light damping: frequencies of the undamped plate, damping half of its loss factor."""
    plate = Plate(plain_plate(2, 2).layout, forces=(Force("F", (9e-3, 5e-3), None),), loss_factor=1e-3)
    plate = replace(plate, supports=(Support("left", "clamped"),))
    free = PlateModel.of(plate, HIGHEST, COARSE)
    anchor = anchored(free, plate, {"F": 1.0}, np.linspace(1e3, HIGHEST, 60), 1e-3, POINTS[:1])
    square = Family.spanned(free, [anchor], {"F": 1.0}, POINTS[:1]).poles(plate).square
    lowest = np.sort_complex(square)[:3]
    values = Band.of(free, 0.0, HIGHEST).reduced.basis.values[:3]
    assert lowest.real == pytest.approx(values, rel=1e-4)
    assert lowest.imag / lowest.real == pytest.approx(np.full(3, 1e-3), rel=1e-6)
