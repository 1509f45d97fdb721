"""No NaN and no infinity leaves the program as a result, by whichever door, unless it is declared."""

import json
import math

import numpy as np
import pytest
import xarray as xr
from hypothesis import given, strategies as st

from five_parts import refusing
from haptonic.errors import NumericalError
from haptonic.friction.signals import write_trials
from haptonic.gate import declared, json_from, json_of, passed
from haptonic.jobs import Task, run_all
from haptonic.response import FrequencyResponse
from haptonic.response.files import write
from haptonic.results.common import stamped, write_netcdf
from haptonic.store import Store, content_key

PARTS = {"code", "argument", "given", "allowed", "cause", "next_step"}
NONE = [math.nan, math.inf, -math.inf]


@st.composite
def results(draw: st.DrawFn):
    """A dataset of finite numbers, text and integers, and the names of its places for floats."""
    shape = draw(st.tuples(st.integers(1, 4), st.integers(1, 4)))
    kind = draw(st.sampled_from([np.float64, np.float32, np.complex128]))
    return xr.Dataset(
        {
            "values": (("row", "column"), np.ones(shape, kind), {"units": "Hz", "bound": 1.0}),
            "single": 2.0,
            "count": ("row", np.arange(shape[0])),
            "name": ("row", np.array(["a"] * shape[0])),
        },
        coords={"place": ("row", np.linspace(0, 1, shape[0]))},
        attrs={"error": 0.5, "gap": [1.0, 2.0], "title": "drawn"},
    )


@st.composite
def spoilt(draw: st.DrawFn):
    """A result with a number that is none somewhere, where it is, and what it is."""
    data, bad = draw(results()), draw(st.sampled_from(NONE))
    where = draw(st.sampled_from(["values", "single", "place", "values.bound", "error", "gap"]))
    if where == "values.bound":
        data["values"].attrs["bound"] = bad
    elif where in data.attrs:
        data.attrs[where] = [1.0, bad] if where == "gap" else bad
    else:
        array = data[where].values.copy()
        array.flat[draw(st.integers(0, array.size - 1))] = bad
        data[where] = data[where].copy(data=array)
    return data, where, bad


@given(results())
def test_finite_results_pass(data):
    assert passed(data) is data


@given(spoilt())
def test_a_number_that_is_none_is_refused_wherever_it_is(case):
    data, where, bad = case
    with pytest.raises(NumericalError) as caught:
        passed(data)
    assert set(caught.value.parts()) == PARTS
    assert all(caught.value.parts().values())
    assert caught.value.argument == f"result {where}"
    assert str(bad) in caught.value.given


@given(spoilt())
def test_a_declared_nan_passes_and_infinity_never_does(case):
    data, where, bad = case
    if where in data.attrs:
        data.attrs["nan_means"] = "nothing there"
    elif where in data.variables:
        data = declared(data, **{where: "nothing there"})
    if math.isnan(bad) and where != "values.bound":
        assert passed(data) is data
    else:
        with pytest.raises(NumericalError):
            passed(data)


def spoilt_result(_argument=None):
    return xr.Dataset({"frequency_error": ("band", np.array([1.0, np.nan]))})


def spoilt_response():
    """A response whose noise went wrong after it was made."""
    response = FrequencyResponse.of(
        np.ones((2, 3, 1), complex), frequency=[1.0, 2.0], x=np.arange(3.0), y=np.zeros(3), direction=["z"],
        quantity="velocity", reference="A1, V", origin="simulated", title="", inputs={},
    )  # fmt: skip
    return FrequencyResponse(response.dataset.assign(frequency_error=("frequency", [1.0, np.nan])))


def spoilt_trials():
    return xr.Dataset({"friction": ("stroke", [0.5, np.nan]), "frequency_error": ("stroke", [1.0, np.inf])})


def test_trials_that_were_left_out_have_no_friction(tmp_path):
    trials = spoilt_trials().drop_vars("frequency_error")
    write_trials(trials, tmp_path / "trials.nc")
    with xr.open_dataset(tmp_path / "trials.nc", engine="h5netcdf") as back:
        assert "nan_means" in back["friction"].attrs
    assert "nan_means" not in trials["friction"].attrs


def test_every_door_has_the_gate(tmp_path):
    store, key = Store(tmp_path / "store"), content_key({"kind": "spoilt"})
    doors = {
        "the store": lambda: store.put(key, spoilt_result()),
        "a stamp": lambda: stamped(spoilt_result(), {}),
        "a file": lambda: write_netcdf(spoilt_result(), tmp_path / "spoilt.nc"),
        "a response": lambda: write(spoilt_response(), tmp_path / "spoilt.nc"),
        "trials": lambda: write_trials(spoilt_trials(), tmp_path / "spoilt.nc"),
    }
    for door in doors.values():
        with refusing(NumericalError, "inaccurate", "result frequency_error"):
            door()
    assert key not in store
    assert not (tmp_path / "spoilt.nc").exists()


def test_one_spoilt_design_of_many_is_an_error_and_the_others_are_kept(tmp_path):
    def design(number):
        return spoilt_result() if number == 1 else xr.Dataset({"edge": float(number)})

    tasks = [Task({"number": number}, number) for number in range(3)]
    outcomes = run_all(design, tasks, store=Store(tmp_path))
    assert [outcome.dataset is None for outcome in outcomes] == [False, True, False]
    assert isinstance(outcomes[1].error, NumericalError)


json_values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.text() | st.floats(allow_nan=False, allow_infinity=False),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(), inner, max_size=3),
)


@given(json_values)
def test_plain_values_come_back_from_json(values):
    assert json.loads(json_of(values)) == values


@given(json_values, st.sampled_from(NONE), st.integers(0, 2))
def test_json_refuses_nan_and_names_its_place(values, bad, place):
    row = [1.0, 2.0, 3.0]
    row[place] = bad
    with pytest.raises(NumericalError) as caught:
        json_of({"of": values, "bands": {"error_hz": row}})
    assert set(caught.value.parts()) == PARTS
    assert all(caught.value.parts().values())
    assert caught.value.argument == f"result bands.error_hz[{place}]"


@pytest.mark.parametrize("text", ["", "{", "[1, 2", "[" * 100_000])
def test_json_of_others_is_read_or_no_json(text):
    with pytest.raises(ValueError, match=r"Expecting|deep"):
        json_from(text)
