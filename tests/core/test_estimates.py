"""Estimates of errors over designs that are drawn: what each part of them claims, and the whole."""

import re
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from truth import KAPPA, Drawn, drawn, plain_plate, truth, wavevectors

from daily import daily
from haptonic.bloch import BlochModel, Resolution
from haptonic.bloch.candidates import bloch_model
from haptonic.bloch.centred import CentredPencil
from haptonic.bloch.mesh_levels import starting_level
from haptonic.bloch.pencil import eigenpairs
from haptonic.bloch.resolution import LEVELS
from haptonic.bloch.settings import BandSettings
from haptonic.bloch.truncation import REST, TRUSTED_TRUNCATION, interior_error, largest_truncation, ranked
from haptonic.cell import MeshPlan, Pillar, UnitCell
from haptonic.cell.pillar_parts import Step
from haptonic.errors import ResourceError
from haptonic.lattice import Lattice
from haptonic.materials import material
from haptonic.superelement import Tiling, condense_by_parts
from haptonic.superelement.condense import on_each

SEED = 5
SEEN = KAPPA[[0, 2, 5]]


def hertz(cell, plan: MeshPlan, count: int) -> np.ndarray:
    """Frequencies on a mesh whose interior keeps several hundred fields."""
    pencil = CentredPencil.of(Tiling.single(condense_by_parts(cell, plan, 5, block=40, measured=False)))
    return np.sqrt([eigenpairs(pencil, kappa, count)[0] for kappa in SEEN]) / (2 * np.pi)


@pytest.mark.nightly
@pytest.mark.parametrize(
    "number",
    [4, 9, 13, 15],  # some take a minute and more
)
def test_truncation_errors_of_many_bands_bound_what_the_interior_omits(number):
    """25 bands, among them those of a pillar that hardly moves the cell's sides."""
    cell, resolution, count = drawn(SEED, number).cell, Resolution(2, 1, 3, 24), 25
    exact = hertz(cell, resolution.for_bands(cell, count).plan(cell), count)
    model = BlochModel.of(cell, resolution, count, measured=False)
    while largest_truncation(model.fine.tiling, count)[0] > TRUSTED_TRUNCATION:
        model = BlochModel.of(cell, model.resolution.grown(), count, measured=False)
    pencil = model.fine.whole
    for kappa, expected in zip(SEEN, exact, strict=True):
        values, modes = eigenpairs(pencil, kappa, count + 2)
        fields = pencil.fields(modes, kappa)
        frequency = np.sqrt(values) / (2 * np.pi)
        lost = interior_error(values, on_each(model.fine.tiling.truncation, fields))
        assert (frequency[:count] - expected <= ranked(frequency, lost)[:count] + 1e-5 * expected).all()


@pytest.mark.nightly
@pytest.mark.parametrize("ratio", [1.0, 1.72])
def test_a_quarter_turn_resolves_the_neck_between_pillars_of_any_lattice(ratio):
    """A neck lies on the longer side of its cell, of which it is a smaller part than of the shorter."""
    lattice = Lattice.rectangular(7e-3, ratio * 7e-3)
    cell = UnitCell(lattice, 0.2e-3, material("aluminium-2017a"), Pillar(5.95e-3, 0.7e-3))
    plan = Resolution(3, 1).plan(cell)
    here = hertz(cell, plan, 10)
    finer = hertz(cell, replace(plan, order=plan.order + 2), 10)
    assert (np.abs(here / finer - 1)[finer > REST * finer.max()] < 1.2e-2).all()


@pytest.mark.nightly
def test_the_error_at_crossing_gaps_beside_square_pillars_is_bounded():
    """Against order 7 with two rings, half a million unknowns: order 4 estimated 0.73 of its error."""
    finer = {  # Hz by phases and band
        (0.0, np.pi): {0: 13445.4, 11: 504585.8, 13: 582631.1},
        (np.pi, 0.0): {12: 579583.3},
        (np.pi, np.pi): {11: 516645.7},
    }
    lattice = Lattice.rectangular(3.7363027654333503e-3, 4.503567597544592e-3)
    pillar = Pillar(3.4903098153032737e-3, 0.5578126472228378e-3, section="square")
    cell = UnitCell(lattice, 0.1400846910132193e-3, material("aluminium-2017a"), pillar)
    model = BlochModel.of(cell, Resolution(4, 1, 4, 22), 15, measured=False)
    for kappa, bands in finer.items():
        solution = model.solve(np.array(kappa))
        for band, frequency in bands.items():
            assert solution.error[band] > abs(solution.frequency[band] - frequency)


@pytest.mark.nightly
def test_what_more_of_the_interior_mends_is_not_laid_on_the_mesh():
    """A slender pillar has many modes of its own; finer meshes with as short an interior show none."""
    pillar = Pillar(1.5e-3, 38e-3)
    cell = UnitCell(Lattice.rectangular(7e-3, 8.9e-3), 0.7e-3, material("aluminium-2017a"), pillar)
    model = bloch_model(cell, BandSettings(24, accuracy=5e-3))
    assert model.resolution.order == LEVELS[starting_level(5e-3)].order
    assert model.resolution.steps > LEVELS[starting_level(5e-3)].steps


@pytest.mark.nightly
@pytest.mark.parametrize("thickness", [0.1, 0.3])
def test_a_mesh_resolves_the_waves_of_the_bands_that_are_asked_for(thickness):
    """Twenty bands of a plain plate, whose waves are shorter than those of ten."""
    cell = UnitCell(Lattice.square(7e-3), thickness * 7e-3, material("aluminium-2017a"))
    frequency = hertz(cell, Resolution(5, 1).for_bands(cell, 20).plan(cell), 20)
    exact = np.array([plain_plate(cell, kappa, 20) for kappa in SEEN])
    assert frequency[exact > REST * exact.max()] == pytest.approx(exact[exact > REST * exact.max()], rel=2e-3)


def share_of_estimate(cell, resolution: Resolution, **finer: int) -> np.ndarray:
    """What some of a mesh's orders change when they are raised to ``finer``, over the estimates."""
    plan = resolution.plan(cell)
    here, there = (hertz(cell, way, 10) for way in (plan, replace(plan, **finer)))
    model = BlochModel.of(cell, resolution, 10, measured=False)
    return np.abs(here - there) / [model.solve(kappa).error for kappa in SEEN]


def assert_less_is_left_along_a_tapered_pillar(height, draft, fillet):
    """A lower order along the pillar changes frequencies less than lower orders in all other directions.

    If not, the estimate is the lower mesh's error along the pillar, tens of times that of the finer mesh.
    """
    width = 3e-3
    pillar = Pillar(width, height * width, draft=np.radians(draft), fillet=fillet * width)
    cell = UnitCell(Lattice.triangular(7e-3), 1.7e-3, material("brass"), pillar)
    plan = Resolution(4, 1).plan(cell)
    lower = plan.lowered(cell)
    here, along, others = (
        hertz(cell, mesh_plan, 10)
        for mesh_plan in (plan, replace(plan, along=lower.along), replace(lower, along=plan.along))
    )
    assert np.linalg.norm(along / here - 1) < np.linalg.norm(others / here - 1)


@pytest.mark.nightly
def test_a_lower_mesh_is_not_judged_by_what_it_leaves_along_a_tapered_pillar():
    assert_less_is_left_along_a_tapered_pillar(3.5, 2.0, 0.1)


@pytest.mark.nightly
@settings(max_examples=2)
@given(st.floats(0.5, 4.0), st.floats(1.0, 6.0), st.floats(0.05, 0.15))
def test_a_lower_mesh_is_not_judged_by_what_it_leaves_along_any_tapered_pillar(height, draft, fillet):
    assert_less_is_left_along_a_tapered_pillar(height, draft, fillet)


@pytest.mark.nightly
@pytest.mark.parametrize(
    ("seed", "number", "order"),
    [(223, 67, 4), *((SEED, number, 3) for number in (3, 11, 19, 13))],
)
def test_polynomials_along_a_tapered_pillar_are_not_what_limits_a_mesh(seed, number, order):
    """Three orders more along z alone change less than half of the estimate.

    For number 67 they changed three times the estimate when the mesh had one order less, and the mesh for the
    error one less again: bending of one parity gains nothing from every other order.
    """
    cell, resolution = drawn(seed, number).cell, Resolution(order, 1)
    assert cell.pillar.draft
    along = resolution.plan(cell).along + 3
    assert (share_of_estimate(cell, resolution, along=along) < 1 / 2).all()


@pytest.mark.nightly
@pytest.mark.parametrize("number", [0, 1015])
def test_the_error_of_the_order_around_a_pillar_is_bounded(number):
    """Fields of one parity within a quarter turn gain nothing from every other order."""
    cell, resolution = drawn(131, number).cell, Resolution(4, 1, 3)
    plan = resolution.plan(cell)
    assert plan.blocks == 1
    assert (share_of_estimate(cell, resolution, order=plan.order + 2) < 1 / 2).all()


@pytest.mark.nightly
def test_the_error_of_a_plate_beside_a_fillet_in_a_narrow_neck_is_bounded():
    """One order more through the plate moved 0.9 of it: no elements lead from the arc to the thickness."""
    cell, resolution = drawn(227, 146).cell, Resolution(3, 1, 4, 22)
    upward = resolution.plan(cell).upward + 1
    assert (share_of_estimate(cell, resolution, upward=upward) < 1 / 2).all()


@pytest.mark.nightly
def test_more_layers_along_a_stepped_pillar_change_next_to_nothing():
    """Those next to the edges are short; with a long one below the step 6e-4 were left in every band."""
    pillar = Pillar(1e-3, 12e-3, step=Step(0.6e-3, 6e-3))
    cell = UnitCell(Lattice.square(5e-3), 1e-3, material("steel"), pillar)
    plan = Resolution(4, 1).plan(cell)
    more = replace(plan, pillar_layers=plan.pillar_layers + 4, step_layers=plan.step_layers + 4)
    here, there = (hertz(cell, way, 10) for way in (plan, more))
    assert (np.abs(here / there - 1)[there > REST * there.max()] < 1e-4).all()


LONG_WAVES = np.array([[0.02, 0.01], [0.05, 0.0], [0.15, 0.1], [0.4, 0.2]])  # phases, rad


@pytest.mark.parametrize(
    "lattice", daily([Lattice.square(6e-3), Lattice.triangular(6e-3)], Lattice.triangular(6e-3))
)
def test_errors_of_long_waves_decrease_like_their_frequencies(lattice):
    """Rotations of the cell were counted as errors: 2 % of a flexural wave at 59 Hz, instead of 0.2 %."""
    cell = UnitCell(lattice, 1e-3, material("brass"), pillar=Pillar(3e-3, 12e-3))
    model, finer = (BlochModel.of(cell, Resolution(order, 1), 3, measured=False) for order in (3, 4))
    for kappa in LONG_WAVES:
        wave, better = model.solve(kappa), finer.solve(kappa)
        difference = np.abs(wave.frequency - better.frequency)
        assert (difference <= wave.error + better.error).all()
        moving = wave.frequency > 20
        assert (wave.error[moving] < 0.003 * wave.frequency[moving]).all()


@given(st.lists(st.tuples(st.floats(1, 2), st.floats(0, 0.3), st.floats(0, 1)), min_size=2, max_size=8))
def test_a_band_is_the_mode_of_its_rank(modes):
    """Modes that are each within their error give bands that are, also where they change places."""
    frequency, error, share = np.array(sorted(modes)).T
    bands = np.sort(frequency - share * error)
    assert (frequency - bands <= ranked(frequency, error) + 1e-12).all()


@pytest.mark.parametrize("order", daily([4, 5], 4))
def test_errors_of_poorly_resolved_waves_are_bounded(order):
    """The tenth band of this plate is 1.7 % off at order 4, 3 % from the order below."""
    cell = drawn(57, 87).cell
    model = BlochModel.of(cell, Resolution(order, 1), 10, measured=False)
    for kappa in wavevectors(cell)[1:4]:
        solution, exact = model.solve(kappa), plain_plate(cell, kappa, 10)
        assert (np.abs(solution.frequency - exact) <= solution.error).all()


def test_the_estimate_bounds_what_a_small_interior_leaves_out():
    """Against the interior that is two steps larger, on the same mesh."""
    cell, kappa, small = drawn(2, 7).cell, np.array([1.3, 0.6]), Resolution(2, 0, 2, 4)
    few, many = (BlochModel.of(cell, mesh, 8, measured=False) for mesh in (small, small.grown(2)))
    here, there = few.solve(kappa), many.solve(kappa)
    lost = here.frequency - there.frequency
    estimated = interior_error(
        (2 * np.pi * here.frequency) ** 2, on_each(few.fine.tiling.truncation, here.fields)
    )
    assert (lost <= estimated + 1e-9 * here.frequency).all()
    assert estimated.max() < 4 * lost.max()


@pytest.mark.nightly
@pytest.mark.parametrize("number", [7, 15])
@pytest.mark.parametrize(("count", "accuracy"), [(20, 5e-4), (12, 2e-3)])
def test_a_plain_plate_is_answered_within_its_estimate(number, count, accuracy):
    """Rayleigh and Lamb know the truth, whatever the mesh and the interior's space."""
    cell = drawn(SEED, number).cell
    model = bloch_model(cell, BandSettings(count, accuracy=accuracy))
    for kappa in wavevectors(cell):
        exact, solution = plain_plate(cell, kappa, count), model.solve(kappa)
        moving = exact > 2 * REST * exact[-1]
        true = np.abs(solution.frequency - exact)[moving]
        assert (true <= solution.error[moving] + 1e-7 * exact[moving]).all()
        assert (true <= accuracy * exact[moving]).all()


@pytest.mark.nightly
def test_the_rim_resolves_what_a_foot_near_it_does():
    """A thick plate whose pillars nearly touch: no other direction, and no lower order, showed this error."""
    cell = UnitCell(Lattice.square(7e-3), 3.5e-3, material("aluminium-2017a"), Pillar(6.35e-3, 2.8e-3))
    plan = Resolution(3, 1).plan(cell)
    levels = (plan.near_rim, plan.near_rim + 2, 0)
    here, finer, coarser = (hertz(cell, replace(plan, near_rim=each), 10) for each in levels)
    moving = finer > REST * finer.max()
    assert (here / finer - 1)[moving].max() < 2e-4 < 7e-4 < (coarser / finer - 1)[moving].max()


def assert_the_truth_is_within(question: Drawn, model: BlochModel | None = None) -> None:
    """Check the model that is chosen, or one that need not reach the accuracy asked for."""
    exact = truth(question)
    assert exact is not None, "no reference fits"
    if model is None:
        model = bloch_model(question.cell, BandSettings(question.count, accuracy=question.accuracy))
    solutions = [model.solve(kappa) for kappa in wavevectors(question.cell)]
    moving = exact.frequency > 2 * REST * exact.frequency.max()
    true = np.abs(np.array([s.frequency for s in solutions]) - exact.frequency)
    estimate = np.array([s.error for s in solutions])
    assert (true <= estimate + exact.uncertainty)[moving].all()


@pytest.mark.nightly
@pytest.mark.parametrize(
    ("seed", "number", "order"),
    [
        (57, 5, 3),
        (57, 22, 4),
        (57, 77, 3),
        (57, 88, 3),
        (57, 1004, 4),
        (227, 75, 5),
        (241, 42, 3),
        (241, 94, 4),
        (241, 246, 3),
    ],
)
def test_estimates_hold_of_a_first_mesh(seed, number, order):
    """The mesh would have answered another accuracy; its estimate was 0.3 to 0.9 of these designs' error."""
    question = drawn(seed, number)
    first = BlochModel.of(question.cell, Resolution(order, 1, 4, 24), question.count, measured=False)
    assert_the_truth_is_within(question, first)


@pytest.mark.nightly
@pytest.mark.usefixtures("alone")
@pytest.mark.parametrize("number", [6, 7, 8, 10])
def test_estimates_hold_for_cheap_designs(number):
    """The benchmark ``estimates_hold`` in small; number 6 was below the truth once."""
    assert_the_truth_is_within(drawn(2, number))


# the references of number 4 would have 640,000 unknowns; number 28 has a step too
@pytest.mark.nightly
@pytest.mark.usefixtures("alone")
@pytest.mark.parametrize("number", [*range(4), *range(5, 16), 28])
def test_estimates_hold_for_drawn_designs(number):
    """What is refused is asked for again as the refusal allows, and answered then."""
    question = drawn(11, number)
    try:
        model = bloch_model(question.cell, BandSettings(question.count, accuracy=question.accuracy))
    except ResourceError as refusal:
        allowed = re.match(r"(\S+) or more for this cell", refusal.allowed)
        if allowed is None:
            pytest.skip(refusal.allowed)
        question = replace(question, accuracy=float(allowed[1]))
        model = bloch_model(question.cell, BandSettings(question.count, accuracy=question.accuracy))
    assert_the_truth_is_within(question, model)
