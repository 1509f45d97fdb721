"""Numbers of a small plate from simulated measurements of it."""

from dataclasses import replace

import numpy as np
import pytest
from small_plate import EDGES, LINES, LOSS, UNKNOWNS, YOUNG, measured, plate, small

from five_parts import refusing
from haptonic.errors import ScanError
from haptonic.materials import material
from haptonic.plate import Actuator, Bond
from haptonic.updating.fit import SmallModel, fitted
from haptonic.updating.match import Match, MeasuredResponse, Unknown
from haptonic.updating.parameters import bonds_of, changed, unit_of, values_of

TRUE = {YOUNG: 73e9, LOSS: 9e-3, EDGES: 8e11}


def test_numbers_can_be_read_and_changed():
    patch = Actuator("A", (3e-3, 3e-3), (3e-3, 3e-3, 1e-3), material("pzt-4"), Bond(4e-5, material("epoxy")))
    whole = replace(plate(), actuators=(replace(patch, name="B", bond=None), patch))
    bond = "plate.actuator[2].bond.thickness"
    assert values_of(whole) == {YOUNG: 70e9, LOSS: 6e-3, EDGES: 3e11, bond: 4e-5}
    new = {YOUNG: 71e9, LOSS: 7e-3, EDGES: 4e11, bond: 5e-5}
    other = changed(whole, new)
    assert values_of(other) == new
    assert other.layout.cells["o"].material.youngs_modulus == 71e9
    assert changed(other, values_of(whole)) == whole
    assert bonds_of(whole, {bond: (1e-5, 1e-4), YOUNG: (1.0, 2.0)}) == {"A": (1e-5, 1e-4)}
    assert [unit_of(name) for name in (bond, LOSS, "plate.loss")] == ["m", "", None]


def test_a_fit_finds_the_numbers_and_the_spoiled_point():
    data = measured(*TRUE.values())
    spoiled = data.response.copy()
    spoiled[:, 4] *= 0.3
    fit = fitted(small(), replace(data, response=spoiled))
    assert fit.left_out.tolist() == [4]
    for number in fit.numbers:
        assert number.interval_95[0] < TRUE[number.name] < number.interval_95[1], number
        assert number.interval_95[1] < 1.02 * number.interval_95[0]
    assert fit.unexplained == pytest.approx(1e-4, rel=0.1), "what is left is the noise"
    assert fit.unexplained_before > 0.5
    assert fit.uncertainty.independent
    assert values_of(fit.plate) == {number.name: number.value for number in fit.numbers}


def test_slopes_of_the_residuals_are_their_derivatives():
    """By an independent step, ten thousand times as long, of fourth order."""
    data = measured(*TRUE.values())
    match, x, h = small().match(data), np.array([0.01, 0.2, 0.3]), 0.01
    for k, unit in enumerate(np.eye(3)):
        far, near = (
            match.misfit(x + step * unit) - match.misfit(x - step * unit) for step in (2 * h * 0.1, h * 0.1)
        )
        slope = (8 * near - far) / (12 * h * 0.1)
        assert match.jacobian(x)[..., k] == pytest.approx(slope, abs=1e-3 * np.abs(slope).max())


@pytest.mark.nightly
def test_a_spring_as_stiff_as_a_wall_is_not_determined():
    """Between two stiffnesses that both hold the edge at rest, nothing moves."""
    stiff = plate(3e17)
    unknowns = (Unknown(YOUNG, 63e9, 77e9), Unknown(EDGES, 1e17, 1e18))
    of = small()
    model = SmallModel.of(stiff, unknowns, of.frequency, of.points, of.drives, 1e-3, of.model.fineness)
    exact = model.anchors[0].displacement
    data = MeasuredResponse.of(of.frequency, of.points, exact * (1 + 1e-3j), False, of.drives)
    fit = fitted(model, data)
    young, edges = fit.numbers
    assert young.interval_95 is not None
    assert edges.interval_95 is None
    assert edges.range_text == edges.remark == "not determined by the data"


@pytest.mark.nightly
def test_a_number_beyond_its_bound_stops_there():
    unknowns = (Unknown(YOUNG, 69e9, 71e9), UNKNOWNS[1])
    fit = fitted(small(unknowns), measured(72e9))
    assert fit.numbers[0].remark == "stopped at its bound"
    assert fit.numbers[0].value == pytest.approx(71e9, rel=1e-3)
    assert fit.numbers[0].value <= 71e9
    assert fit.numbers[0].interval_95 is None
    assert fit.numbers[1].interval_95 is not None


def test_another_plate_is_refused():
    data = measured()
    other = replace(data, response=np.roll(data.response, 3, axis=1)[::-1])
    with refusing(ScanError, "no-answer", "fit", "unexplained"):
        fitted(small(), other)


@pytest.mark.parametrize(
    ("change", "cause"),
    [
        (np.conj, "exp(-i omega t)"),
        (lambda response: 1e3 * response, "1000 times"),
        pytest.param(np.negative, "against z", marks=pytest.mark.nightly),
        pytest.param(
            lambda response: response / (2j * np.pi * LINES[:, None]),
            "displacement",
            marks=pytest.mark.nightly,
        ),
    ],
    ids=["conjugate", "millimetres", "opposite sign", "displacement"],
)
def test_a_misread_measurement_is_recognised(change, cause):
    data = measured(*TRUE.values())
    with refusing(ScanError, "no-answer", "fit", cause):
        fitted(small(), replace(data, response=change(data.response)))


def test_noise_is_weighed_by_line_and_by_point():
    """A coherence made of a noise that is a product of both is turned back into it."""
    data = measured(share=0.0)
    chance = np.random.default_rng(2)
    lines, points = chance.uniform(0.5, 2, len(data.frequency)), chance.uniform(0.5, 2, len(data.points))
    noise = 0.1 * np.abs(data.response).mean() * np.outer(lines, points)
    power = np.abs(data.response) ** 2
    weight = MeasuredResponse.of(
        data.frequency, data.points, data.response, True, data.drives, power / (power + noise**2)
    ).weight
    assert weight * noise == pytest.approx(np.full(noise.shape, (weight * noise).mean()), rel=1e-3)


def test_points_without_weight_do_not_count():
    data = measured(*TRUE.values())
    broken = data.response.copy()
    broken[:, 2] = 1e3
    match, expected = (
        small().match(response)
        for response in (replace(data, response=broken).without(np.array([2])), data.without(np.array([2])))
    )
    x = np.array([0.02, 0.1, 0.1])
    for residual in (Match.of_complex, Match.of_magnitudes, Match.of_spectra):
        assert residual(match, x) == pytest.approx(residual(expected, x), rel=1e-9)
    assert match.unexplained(x) == pytest.approx(expected.unexplained(x))
