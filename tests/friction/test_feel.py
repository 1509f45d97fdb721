"""What a finger feels, from amplitudes that are known."""

import math
from dataclasses import replace

import numpy as np
import pytest
import xarray as xr
from hypothesis import given, settings, strategies as st

from five_parts import refusing
from haptonic.bloch import Gap
from haptonic.cell import Pillar, UnitCell
from haptonic.errors import StudyError
from haptonic.friction.lubrication import (
    CUE_THRESHOLD,
    WEBER_FRACTION,
    Fingertip,
    Touch,
    intermittent_friction,
    shared_friction,
)
from haptonic.friction.lubrication.on_plate import FrictionOnPlate, Reduction
from haptonic.lattice import Lattice
from haptonic.materials import material
from haptonic.plate.layout.grid import Layout
from haptonic.plate.layout.parts import Force, Plate
from haptonic.plate.layout.sampling import driven_regions
from haptonic.plate.vibration.touch import whole_finger_by_region
from haptonic.results.feel.requirements import FAR, drive_in_gap, requirements
from haptonic.results.feel.value import Feel

ALUMINIUM = material("aluminium-paper")
CELL = UnitCell(Lattice.square(7e-3), 1.5e-3, ALUMINIUM, Pillar(3.5e-3, 14.7e-3))
ROW = ("A", "A", "A", "o", "B", "B", "B")
LINES = tuple(7e-3 * np.arange(8))
LAYOUT = Layout((ROW,) * 4, LINES, tuple(7e-3 * np.arange(5)), {"o": CELL}, 1.5e-3, ALUMINIUM)
PLATE = Plate(LAYOUT, forces=(Force("F", (10e-3, 14e-3), None),), loss_factor=1e-3)
FREE, LOADED = 10e-9, np.array([10e-9, 8e-9, 6e-9, 3e-9])  # m per newton on A; a tenth of it on B
QUALITY = np.array([600.0, 500.0, 400.0, 200.0])


def gap(lower, upper, error=0.0):
    return Gap(
        between=(6, 7), lower=lower, upper=upper, lower_error=error, upper_error=error,
        lower_kappa=(0.0, 0.0), upper_kappa=(0.0, 0.0), complete=True, direction="all", samples=1,
    )  # fmt: skip


def response_of(drive=150.0, idle=0.1, speed=0.078, **finger):
    axes = [np.arange(1e-3, end, 2e-3) for end in (LINES[-1], LAYOUT.y[-1])]
    x, y = (axis.ravel() for axis in np.meshgrid(*axes))
    region = np.where(x < 21e-3, "A", np.where(x > 28e-3, "B", ""))
    share = np.where(region == "A", 1.0, np.where(region == "B", idle, 0.5))
    loaded = xr.Dataset(
        {
            "amplitude": (("load", "point"), LOADED[:, None] * share),
            "quality": (("load", "point"), QUALITY[:, None] * np.ones(len(x))),
        },
        coords={
            "load": ["free", "low", "value", "high"],
            "x": ("point", x), "y": ("point", y), "region": ("point", region),
        },
        attrs={"frequency_hz": 58.8e3, "reference": "F, N", "solver_error": 1e-4, "haptonic_version": "0"},
    )  # fmt: skip
    skin = Fingertip().having(**finger) if finger else Fingertip()
    return felt_on(loaded, 10e-3, Touch(58.8e3, 0.5, speed), skin, drive)


def felt_on(loaded, diameter, touch, skin, drive):
    return FrictionOnPlate(
        loaded=loaded,
        below=whole_finger_by_region(loaded, LAYOUT, diameter),
        driven=driven_regions(PLATE),
        touch=touch,
        skin=skin,
        drive=drive,
    )


@settings(max_examples=6, deadline=None)
@given(st.floats(5.0, 400.0), st.floats(0.05, 0.9))
def test_friction_is_that_of_the_models_at_each_amplitude(drive, idle):
    on_plate = response_of(drive, idle)
    friction = on_plate.at_points()
    for region, share in (("A", 1.0), ("B", idle)):
        amplitude = LOADED[2] * share * drive
        exact = float(shared_friction(amplitude, on_plate.touch, on_plate.skin.values))
        at = friction.isel(point=int(np.flatnonzero(on_plate.below[region])[0]))
        assert float(at["amplitude"]) == pytest.approx(amplitude)
        assert float(at["value"]) == pytest.approx(exact, abs=2e-3)
        assert float(at["low"]) <= float(at["value"]) <= float(at["high"])
        assert on_plate.reductions()[region].value == pytest.approx(1 - exact, abs=2e-3)


def test_where_the_plate_strikes_the_skin_the_other_model_answers():
    on_plate = response_of(1000.0, film_share=5e-4)
    amplitude = LOADED[2] * 1000.0
    assert math.isnan(shared_friction(amplitude, on_plate.touch, on_plate.skin.values))
    exact = float(intermittent_friction(amplitude, on_plate.touch, on_plate.skin.values))
    assert on_plate.reductions()["A"].value == pytest.approx(1 - exact, abs=2e-3)


def test_damping_widens_the_interval_to_the_right_sides():
    outer = response_of().reductions()["A"]
    narrow = response_of()
    narrow.loaded["amplitude"][1:] = narrow.loaded["amplitude"][2]
    inner = narrow.reductions()["A"]
    assert outer.low < inner.low < inner.value < inner.high < outer.high
    assert outer.value == pytest.approx(inner.value)


@settings(max_examples=5, deadline=None)
@given(st.floats(0.02, 0.9))
def test_the_drive_for_a_reduction_gives_it(reduction):
    on_plate = response_of()
    drive = on_plate.drive_for(reduction, "A")
    assert response_of(drive).reductions()["A"].value == pytest.approx(reduction, abs=1e-3)
    # a tenth of the amplitude needs ten times the drive, if there is one
    idle = on_plate.drive_for(reduction, "B")
    assert idle == pytest.approx(10 * drive, rel=1e-3) if idle else 10 * drive > 9e3


def test_a_reduction_that_no_drive_gives():
    on_plate = response_of()
    on_plate.loaded["amplitude"][:] = 0.0
    assert on_plate.drive_for(0.5, "A") is None


@pytest.mark.parametrize("reduction", [0.0, 1.0, 55.0, -0.1, math.nan])
def test_a_reduction_that_is_no_share_is_refused(reduction):
    with refusing(StudyError, "out-of-range", "reduction"):
        response_of().drive_for(reduction, "A")


def test_places_are_those_where_the_whole_finger_lies_on_the_region():
    on_plate = response_of()
    x, y = on_plate.loaded["x"].values, on_plate.loaded["y"].values
    inside = on_plate.below["A"]
    assert inside.any()
    for edge in (x, 21e-3 - x, y, 28e-3 - y):  # the plate's rim and the lattice
        assert edge[inside].min() >= 5e-3 - 1.1e-3
    assert ((x > 6e-3) & (x < 15e-3) & (y > 6e-3) & (y < 22e-3) <= inside).all()
    wide = felt_on(on_plate.loaded, 40e-3, on_plate.touch, on_plate.skin, 1.0)
    np.testing.assert_array_equal(wide.below["A"], on_plate.loaded["region"].values == "A")


def test_times_and_ratios_are_those_with_a_finger():
    on_plate = response_of(idle=0.25)
    assert on_plate.driven == ("A",)
    assert on_plate.ratio == {"B": pytest.approx(4.0)}
    assert on_plate.quality() == pytest.approx(400)
    assert on_plate.constant == pytest.approx(400 / (math.pi * 58.8e3))
    assert on_plate.rise == pytest.approx(math.log(9) * on_plate.constant)
    margin = on_plate.margins["B"]
    assert margin.stopped == pytest.approx(1 - margin.idle / margin.driven)


def test_far_from_every_mode_the_time_is_not_determined():
    far = response_of()
    far.loaded["quality"][:] = math.nan
    assert math.isnan(far.rise)
    assert math.isnan(far.constant)
    time = Feel(PLATE, {"lattice": gap(52e3, 60e3)}, far).requirements[-2]
    assert (time.colour, time.reason.split(":")[0]) == ("amber", "not determined")


@pytest.mark.parametrize(
    ("strengths", "driven"), [((1, 1), ("A", "B")), ((0, 2), ("B",)), ((1, 0), ("A",)), ((0, 0), ("A", "B"))]
)
def test_every_region_that_a_drive_moves_is_driven_and_to_be_felt(strengths, driven):
    forces = [
        Force(f"F{x}", (x, 14e-3), None, force) for x, force in zip((10e-3, 38e-3), strengths, strict=True)
    ]
    assert driven_regions(replace(PLATE, forces=tuple(forces))) == driven
    demands = requirements(GOOD, driven, FAST, FAST, drive_in_gap(56e3, None))[:2]
    assert [demand.what for demand in demands] == [
        f"{name} is {'felt clearly' if name in driven else 'not felt'}" for name in "AB"
    ]


def test_files_list_assumptions_and_are_marked_as_simulated():
    data = Feel(PLATE, {"lattice": gap(52e3, 60e3)}, response_of(contact_gap=4e-6)).dataset
    assert data.attrs["origin"] == "simulated"
    assert '"mark": "given"' in data.attrs["assumptions"]
    assert '"mark": "assumed"' in data.attrs["assumptions"]
    assert data["amplitude"].attrs["units"] == "m"


# -- traffic lights -----------------------------------------------------------------------------------

FAST, SLOW = 0.5 * CUE_THRESHOLD, 2 * CUE_THRESHOLD
GOOD = {"A": Reduction(0.5, 0.4, 0.6), "B": Reduction(0.02, 0.0, 0.05)}
WANTED = FAR * WEBER_FRACTION


@pytest.mark.parametrize(
    ("changes", "colours"),
    [
        ({}, ["green", "green", "green", "green"]),
        ({"A": Reduction(0.5, WANTED - 0.01, 0.6)}, ["amber", "green", "green", "green"]),
        ({"A": Reduction(WANTED - 0.01, 0.0, 0.6)}, ["red", "green", "green", "green"]),
        ({"B": Reduction(0.02, 0.0, WEBER_FRACTION + 0.01)}, ["green", "amber", "green", "green"]),
        ({"B": Reduction(WEBER_FRACTION + 0.01, 0.0, 0.2)}, ["green", "red", "green", "green"]),
    ],
)
def test_regions_are_judged_by_their_whole_interval(changes, colours):
    lights = requirements(GOOD | changes, ("A",), FAST, FAST, drive_in_gap(56e3, gap(52e3, 60e3)))
    assert [light.colour for light in lights] == colours


@pytest.mark.parametrize(("rise", "constant", "colour"), [
    (FAST, FAST, "green"), (SLOW, FAST, "amber"), (SLOW, SLOW, "red"),
])  # fmt: skip
def test_the_time_is_judged_by_both_definitions(rise, constant, colour):
    assert requirements(GOOD, ("A",), rise, constant, drive_in_gap(56e3, None))[2].colour == colour


@pytest.mark.parametrize("around", [None, gap(52e3, 55e3), gap(57e3, 60e3), gap(52e3, 56.02e3, 50.0)])
def test_a_drive_outside_of_the_gap_is_red(around):
    """Errors of the edges counted, as everywhere."""
    assert drive_in_gap(56e3, around).colour == "red"


def test_the_lattice_without_a_gap_is_named_if_another_has_one():
    plate_gaps = {"lattice": gap(52e3, 60e3), "holes": None}
    *_, of_gap = Feel(PLATE, plate_gaps, response_of()).requirements
    assert of_gap.reason == "no gap of holes contains it by more than its errors"
    *_, of_none = Feel(PLATE, dict.fromkeys(plate_gaps), response_of()).requirements
    assert of_none.reason == "no gap contains it by more than its errors"
