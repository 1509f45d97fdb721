"""What JSON and tables are made of: every number with its unit, every name as a key, no silent NaN."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Annotated

import numpy as np
import pytest
import xarray as xr
from hypothesis import given, strategies as st

from five_parts import refusing
from haptonic import analyses
from haptonic.errors import NumericalError
from haptonic.gate import WORD, json_of
from haptonic.response.measures import along
from haptonic.results.plain import attributes, named, plain, split
from haptonic.results.result import Result
from haptonic.results.table import Column, Table
from haptonic.units import Hertz, In, share_text
from hostile import names

UNITS = {
    "Hz": "_hz",
    "m/s": "_m_per_s",
    "m/s/V": "_m_per_s_per_v",
    "dB/row": "_db_per_row",
    "1": "",
    "": "",
}


@st.composite
def datasets(draw):
    """Some variables on dimensions of which some have names."""
    sizes = {dimension: draw(st.integers(0, 3)) for dimension in ("a", "b", "c")}
    coords = {
        dimension: np.array(draw(st.lists(names, min_size=size, max_size=size, unique=True)), dtype=str)
        for dimension, size in sizes.items()
        if draw(st.booleans())
    }
    variables = {}
    for number, unit in enumerate(draw(st.lists(st.sampled_from(list(UNITS)), min_size=1, max_size=3))):
        dims = draw(st.permutations(list(sizes)))[: draw(st.integers(0, 3))]
        values = np.arange(float(np.prod([sizes[d] for d in dims]))).reshape([sizes[d] for d in dims])
        variables[f"v{number}"] = dims, values + draw(st.sampled_from([0, 0.5])), {"units": unit}
    return xr.Dataset(variables, coords=coords)


def at(content, array, place):
    """The number that JSON has at a place of an array."""
    for dimension, number in zip(array.dims, place, strict=True):
        has_names = dimension in array.coords
        content = content[array[dimension].values[number] if has_names else number]
    return content


@given(datasets())
def test_every_number_is_stored_once_under_its_name_and_unit(data):
    content = json.loads(json.dumps(plain(data)))
    assert set(content) == {f"{name}{UNITS[array.attrs['units']]}" for name, array in data.items()}
    for name, array in data.items():
        for place in np.ndindex(array.shape):
            assert at(content[named(name, array.attrs["units"])], array, place) == array.values[place]


@given(datasets())
def test_what_was_split_comes_together_again(data):
    for array in data.values():
        if array.dims and array.dims[0] in array.coords and array.size:
            parts = split(array, array.dims[0])
            assert list(parts) == array[array.dims[0]].values.tolist()
            assert (along(parts, array.dims[0]).values == array.values).all()


def test_nothing_is_split_from_nothing():
    assert split(None, "pair") == {}


def test_a_nan_is_none_where_it_is_declared_and_refused_elsewhere():
    values = "x", [1.0, np.nan], {"units": "Hz"}
    data = xr.Dataset({"silent": values, "known": values})
    data["known"].attrs[WORD] = "it was not measured"
    assert plain(data)["known_hz"] == [1.0, None]
    with refusing(NumericalError, "inaccurate", "result silent_hz[1]"):
        json_of(plain(data))


def test_a_complex_number_is_two():
    data = xr.Dataset({"z": ("part", [1 + 2j], {"units": "ohm"})}, coords={"part": ["A1"]})
    assert plain(data) == {"z_ohm": {"A1": {"real": 1.0, "imag": 2.0}}}
    assert plain(np.array([3j])) == {"real": [0.0], "imag": [3.0]}


@dataclass(frozen=True)
class Inner:
    lower: Hertz
    level: Annotated[float, In("dB")]


def test_names_of_a_dataclass_contain_its_units():
    assert plain({"gap": Inner(1.0, 2.0), "none": None}) == {
        "gap": {"lower_hz": 1.0, "level_db": 2.0}, "none": None,
    }  # fmt: skip


def test_attributes_that_contain_json_are_decoded():
    data = xr.Dataset(attrs={"inputs": '{"a": [1]}', "reference": "[A1], V", "mesh": 3})
    assert attributes(data) == data.attrs | {"inputs": {"a": [1]}}
    silent = data.assign_attrs({"mode_hz": np.nan, WORD: "no mode near this frequency"})
    assert attributes(silent)["mode_hz"] is None
    assert np.isnan(attributes(data.assign_attrs(mode_hz=np.nan))["mode_hz"])


@pytest.mark.parametrize("name", analyses.NAMES)
def test_no_result_has_a_json_of_its_own(name):
    kinds = [kind for kind in analyses.named(name).result.__mro__ if "to_json" in vars(kind)]
    assert kinds == [Result]


class TestTable:
    DATA = xr.Dataset(
        {
            "frequency": ("line", [1e3, 2e3], {"units": "Hz"}),
            "doubt": ("line", [10.0, 20.0], {"units": "Hz"}),
            "rms": (("line", "region"), [[1.0, 2.0], [3.0, 4.0]], {"units": "m/s/V"}),
            "share": ("line", [0.5, np.nan], {"units": "1"}),
            "low": ("line", [0.4, np.nan]), "high": ("line", [0.6, np.nan]),
        },
        coords={"region": ["WG1", "{}"]},
    )  # fmt: skip

    def test_units_errors_ends_and_names_come_from_the_dataset(self):
        columns = (
            Column("frequency", shown="kHz", form=".2f", error="doubt"),
            Column("rms of {}", form=".0f", of="rms"),
            Column("share", shown="%", form=".0f", ends=("low", "high")),
        )
        table = Table.of("lines", self.DATA, "line", columns)
        assert table.head == ("frequency / kHz", "rms of WG1 / (m/s/V)", "rms of {} / (m/s/V)", "share / %")
        assert table.texts[0] == ("1.00 ± 0.01", "1", "2", "50 (40 to 60)")
        assert table.to_dataframe()["error of frequency (Hz)"].tolist() == [10.0, 20.0]

    def test_a_share_has_the_digits_of_its_sentence(self):
        data = self.DATA.assign(low=("line", [0.49, 0.0]), high=("line", [0.515, 0.74])).fillna(0.56)
        share = Column("share", shown="%", form=".0f", ends=("low", "high"))
        assert Table.of("lines", data, "line", (share,)).texts == [
            ("50.0 (49.0 to 51.5)",),
            ("56 (0 to 74)",),
        ]
        assert share_text(0.5, 0.49, 0.515) == "50.0 % (49.0 to 51.5 %)"
        assert share_text(0.56, 0.0, 0.74) == "56 % (0 to 74 %)"
