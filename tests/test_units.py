"""Text with a unit in and out: exact, and deaf to everything that is not one number and one unit."""

import math
from decimal import Decimal

import pytest
from hypothesis import given, settings, strategies as st

from each import each
from haptonic import units
from haptonic.errors import HaptonicError, shown
from haptonic.units import PREFIXES_OF, format_quantity, registry, to_si

POWERS = {"nm": -9, "µm": -6, "um": -6, "mm": -3, "cm": -2, "m": 0, "km": 3}
decimals = st.builds(
    lambda whole, power: Decimal(whole).scaleb(power), st.integers(0, 10**25), st.integers(-30, 30)
)
finite = st.floats(allow_nan=False, allow_infinity=False)


@each(
    ("text", "unit", "value"),
    [
        ("7 mm", "m", 0.007),
        ("14.7 mm", "m", 0.0147),
        ("7mm", "m", 0.007),
        ("  3.5   mm ", "m", 0.0035),
        (".5 mm", "m", 0.0005),
        ("+1.5e-3 m", "m", 0.0015),
        ("-7 mm", "m", -0.007),
        ("1 inch", "m", 0.0254),
        ("7 µm", "m", 7e-6),
        ("7 \u03bcm", "m", 7e-6),
        ("60 kHz", "Hz", 60e3),
        ("70 GPa", "Pa", 70e9),
        ("70 N/mm^2", "Pa", 70e6),
        ("70 kN/mm**2", "Pa", 70e9),
        ("2700 kg/m^3", "kg/m^3", 2700.0),
        ("2700 kg/m³", "kg/m^3", 2700.0),
        ("2.7 g/cm^3", "kg/m^3", 2700.0),
        ("36 km/hour", "m/s", 10.0),
        ("60 V", "V", 60.0),
        ("0.2 kV", "V", 200.0),
        ("1e12 N/m^3", "N/m^3", 1e12),
        ("1000 N/mm³", "N/m^3", 1e12),
        ("10 N s/m", "N s/m", 10.0),
        ("10 N·s/m", "N s/m", 10.0),
        ("10 kg/s", "N s/m", 10.0),
        ("2 N/mm", "N/m", 2000.0),
        ("5 g", "kg", 0.005),
        (0.33, "", 0.33),
        ("0.33", "", 0.33),
        (0, "m", 0.0),
    ],
)
def test_reads_quantity_as_the_nearest_float(text, unit, value):
    assert to_si(text, unit, "x") == value


@settings(deadline=None)
@given(decimals, st.sampled_from(sorted(POWERS)))
def test_scaling_is_rounded_once(number, name):
    expected = float(number.scaleb(POWERS[name])) if number else 0.0
    assert to_si(f"{number:e} {name}", "m", "x") == expected


@pytest.mark.parametrize("unit", sorted(PREFIXES_OF))
def test_table_of_prefixes_agrees_with_pint(unit):
    for name, factor in units._table(unit).items():
        assert registry().Quantity(1, name).to(unit).magnitude == factor


HOSTILE = [
    "10**10**10 m",
    "7 mm * 3",
    "7 * 3 mm",
    "7 (mm)",
    "7 mm; import os",
    "__import__('os').system('true') m",
    "7 m^99999999",
    "7 mm mm^^2",
    "9" * 70 + "e99999999 m",
    "7 " + "m*" * 5000 + "m",
    "7 " + "(" * 70 + "m",
    "",
    "   ",
    "\n",
    "mm",
    "7,5 mm",
    "1_000 mm",
    "0x10 mm",
    "\uff17 mm",
    "7 \uff4d\uff4d",
    "7 mm\u200b",
    "7 mm\0",
    "\u0667 mm",
    "7 %",
    "nan mm",
    "-inf m",
    "infinity",
    "--7 mm",
    "7 mm 8 mm",
]


@each("text", HOSTILE)
@each("unit", ["m", ""])
def test_refuses_other_text_before_pint_sees_it(text, unit, monkeypatch):
    def unreachable():
        raise AssertionError("pint was asked")

    monkeypatch.setattr(units, "registry", unreachable)
    with pytest.raises(HaptonicError) as caught:
        to_si(text, unit, "cell.pitch")
    parts = caught.value.parts()
    assert parts["argument"] == "cell.pitch"
    assert all(parts.values())
    assert len(str(caught.value)) < 500
    assert str(caught.value).isprintable() or "\n  " in str(caught.value)


@each(
    ("value", "unit", "cause"),
    [
        ("1e400 m", "m", "too large"),
        ("1e308 Tm", "m", "too large"),
        ("1e-400 m", "m", "too small"),
        ("1e999999999 m", "m", "power of ten"),
        (10**400, "", "too large"),
        (math.nan, "", "not a finite"),
        (math.inf, "m", "not a finite"),
        (7, "m", "unit is missing"),
        ("7", "m", "unit is missing"),
        ("7 kHz", "m", "not a unit of length"),
        ("7 degC", "m", "not a unit of length"),
        ("7 dB", "m", "not a unit of length"),
        ("7 rad", "m", "not a unit of length"),
        ("7 N/m", "N/m^3", "not a unit of stiffness per area"),
        ("7 N/m", "N s/m", "not a unit of damping"),
        ("7 N", "N/m", "not a unit of stiffness"),
        ("7 N", "V", "not a unit of voltage"),
        ("7 N", "kg", "not a unit of mass"),
        ("7 mn", "m", "not a known unit"),
        ("0.3 mm", "", "unit where none belongs"),
        ("0.3 rad", "", "unit where none belongs"),
        (True, "", "wrong type"),
        (None, "m", "wrong type"),
        ([7, "mm"], "m", "wrong type"),
        ({"value": 7}, "m", "wrong type"),
        (b"7 mm", "m", "wrong type"),
    ],
)
def test_names_the_cause(value, unit, cause):
    with pytest.raises(HaptonicError) as caught:
        to_si(value, unit, "x")
    assert cause in caught.value.cause


@each(("text", "unit", "nearest"), [("70 gpa", "Pa", "GPa"), ("8 mn", "m", "mm"), ("8 kHx", "Hz", "kHz")])
def test_suggests_the_unit_that_differs_in_case_or_in_one_letter(text, unit, nearest):
    with pytest.raises(HaptonicError) as caught:
        to_si(text, unit, "x")
    assert f'"{nearest}" is the nearest' in caught.value.next_step


@settings(deadline=None)
@given(st.text(max_size=100))
def test_any_text_is_read_or_refused(text):
    try:
        value = to_si(text, "m", "x")
    except HaptonicError:
        return
    assert math.isfinite(value)


@each(
    ("value", "unit", "text"),
    [
        (0.007, "m", "7 mm"),
        (60_000, "Hz", "60 kHz"),
        (70e9, "Pa", "70 GPa"),
        (60_217.34, "Hz", "60.22 kHz"),
        (0.0147, "m", "14.7 mm"),
        (0.99996, "m", "1 m"),
        (-0.0035, "m", "-3.5 mm"),
        (25e-6, "m", "25 µm"),
        (0.0, "m", "0 m"),
        (2700.0, "kg/m^3", "2700 kg/m^3"),
        (0.33, "", "0.33"),
        (5e-12, "m", "0.005 nm"),
        (math.nan, "m", "nan m"),
        (math.inf, "", "inf"),
    ],
)
def test_writes_for_people(value, unit, text):
    assert format_quantity(value, unit) == text


def test_writes_in_the_unit_that_is_preferred():
    assert format_quantity(0.14, "m", prefer="m") == "0.14 m"
    assert format_quantity(58_800, "Hz", prefer="Hz") == "58800 Hz"
    assert format_quantity(math.pi / 1000, "m", prefer="mm", digits=6) == "3.14159 mm"


@pytest.mark.parametrize(
    ("unit", "digits", "text"), [("rad", None, "0 rad"), ("rad", 4, "0 deg"), ("m", 4, "0 m")]
)
def test_zero_has_no_sign(unit, digits, text):
    assert format_quantity(-0.0, unit, digits=digits) == text


@pytest.mark.parametrize("unit", sorted(units.EXAMPLES))
def test_examples_are_read(unit):
    assert to_si(units.EXAMPLES[unit], unit, "x") > 0


@settings(deadline=None)
@given(finite, st.sampled_from(["m", "Hz", "Pa", "kg/m^3", "m/s", "V", "N/m^3", "N s/m", ""]))
def test_written_with_all_digits_it_reads_back_the_same(value, unit):
    assert to_si(format_quantity(value, unit, digits=None), unit, "x") == value


@settings(deadline=None)
@given(st.floats(min_value=1e-9, max_value=1e12), st.sampled_from(["m", "Hz", "Pa"]))
def test_written_with_four_digits_it_is_within_half_of_the_last(value, unit):
    written = Decimal(to_si(format_quantity(value, unit), unit, "x"))
    assert abs(written - Decimal(value)) <= Decimal(value) * Decimal("0.5001e-3")


def test_shown_is_short_and_never_fails():
    assert shown("mm" * 1000).startswith("'mmmm")
    assert len(shown("mm" * 1000)) <= 60
    deep: dict[str, object] = {}
    for _ in range(100_000):
        deep = {"a": deep}
    assert shown(deep) == "{'a': {'a': {...}}}"
    assert "bits" in shown(16**10_000)
    assert shown(7.0) == "7.0"


@pytest.mark.parametrize(
    ("given", "unit", "complete"),
    [
        ("44", "Hz", "44 kHz"), ("44000", "Hz", "44000 Hz"), (" 6 ", "m", "6 mm"), (6, "m", "6 mm"),
        ("0.006", "m", "0.006 m"), (0.1, "m", "0.1 mm"), ("1500", "m", "1500 µm"), ("3", "rad", "3 deg"),
        ("70", "Pa", "70 GPa"), ("1e390", "m", "1e390 nm"), ("4", "N s/m", "4 N s/m"),
    ],
)  # fmt: skip
def test_a_number_without_a_unit_is_repeated_with_the_unit_that_is_probably_meant(given, unit, complete):
    with pytest.raises(HaptonicError) as caught:
        to_si(given, unit, "x")
    assert caught.value.next_step.endswith(f'"{complete}"')


@pytest.mark.parametrize(
    ("unit", "value"), [("m", 'a number with its unit, such as "7 mm"'), ("", "a plain number")]
)
def test_a_percentage_is_refused_with_the_absolute_value_as_the_next_step(unit, value):
    with pytest.raises(HaptonicError) as caught:
        to_si("1 %", unit, "tolerance.of[1].spread")
    assert caught.value.next_step.startswith(f"write the absolute value as {value}")
