"""Numbers and names as they are shown."""

import pytest
from hypothesis import given, strategies as st
from matplotlib.figure import Figure

from haptonic.plots import style
from haptonic.plots.text import band_text, label, readable, scaled_unit, short
from haptonic.units import uncertain


@pytest.mark.parametrize(
    ("frequency", "error", "text"),
    [
        (52510.1, 41.5, "52.51 ± 0.05"),
        (60214.6, 9.0, "60.215 ± 0.009"),
        (60214.6, 96.0, "60.2 ± 0.1"),
        (72050.5, 101.6, "72.05 ± 0.11"),
        (60214.6, 2300.0, "60 ± 3"),
        (106396e3, 385e3, "106400 ± 400"),
        (7658.0, 0.0, "7.658"),
        (7658.0, 1e-9, "7.658000 ± 0.000001"),
    ],
)
def test_a_frequency_with_its_bound(frequency, error, text):
    assert uncertain(frequency / 1e3, error / 1e3) == text


@given(st.floats(1.0, 1e6), st.floats(1e-2, 1e4))
def test_the_shown_bound_is_never_smaller_than_the_bound_nor_much_larger(frequency, error):
    shown = uncertain(frequency / 1e3, error / 1e3).split(" ± ")[1]
    assert float(shown) * 1e3 >= error * (1 - 1e-6)
    assert float(shown) * 1e3 <= 1.5 * error * (1 + 1e-6)


@pytest.mark.parametrize(
    ("lower", "upper", "text"),
    [
        ((55357.0, 29.0), (61958.8, 19.6), "55.36 ± 0.03 to 61.959 ± 0.020 kHz"),
        ((54710.0, 67.0), (65300.0, 96.0), "54.71 ± 0.07 to 65.3 ± 0.1 kHz"),
        ((54.36e6, 1e4), (61.2e6, 2e4), "54.36 ± 0.01 to 61.20 ± 0.02 MHz"),
        ((52000.0, 0.0), (60000.0, 0.0), "52.000 to 60.000 kHz"),
        ((6934.96, 1.75), (346735.3, 1253.6), "6.9350 ± 0.0018 to 346.7 ± 1.3 kHz"),
        ((52000.0, 30.0), (60000.0, 1e-9), "52.00 ± 0.03 to 60.000000 ± 0.000001 kHz"),
    ],
)
def test_each_edge_of_a_range_is_rounded_as_in_a_table(lower, upper, text):
    assert band_text(*lower, *upper) == text


@given(st.floats(1.0, 1e4), st.floats(1.0, 1e4))
def test_no_bound_of_a_range_is_smaller_than_the_bound_or_much_larger(low, high):
    shown = band_text(50e3, low, 60e3, high).removesuffix(" kHz").split(" to ")
    assert shown == [uncertain(50, low / 1e3), uncertain(60, high / 1e3)]
    for text, bound in zip(shown, (low, high), strict=True):
        assert bound * (1 - 1e-6) <= 1e3 * float(text.split(" ± ")[1]) <= 1.5 * bound * (1 + 1e-6)


def test_expressions_in_words():
    assert readable("cell.pillar.diameter / cell.pitch") == "pillar diameter / pitch"
    assert readable("material.youngs_modulus") == "Young's modulus"
    assert readable("cell.disc[2].diameter / cell.pitch") == "disc 2 diameter / pitch"
    assert readable("cell.site[1].disc[2].low") == "disc 2 low of site 1"
    assert readable("material.youngs_modulus / material.density") == "Young's modulus / density"
    assert readable("material.poisson_ratio * cell.pitch_y") == "Poisson ratio * pitch along y"
    assert readable("cell.pillar.step.diameter") == "pillar step diameter"
    assert scaled_unit("1") == ("dimensionless", 1.0)
    assert scaled_unit("m") == ("mm", 1e3)
    assert scaled_unit("kg/m^3") == ("kg/m^3", 1.0)


@pytest.mark.parametrize(
    ("low", "high", "labels"),
    [
        (1e-6, 1e-3, {"10⁻⁵", "10⁻⁴"}),
        (2e-5, 7e-5, {"2\N{MULTIPLICATION SIGN}10⁻⁵"}),
        (1, 300, {"10⁰"}),
        (0.35, 3.5, {"0.4", "3"}),
        (2e-3, 7e-3, {"0.002"}),
        (1, 30, {"1", "10"}),
    ],
)
def test_powers_of_ten_are_plain_text(low, high, labels):
    """Pictures parse no formulas, because a name may hold dollar signs."""
    with style.styled():
        axes = Figure().add_subplot()
        axes.plot([0, 1], [low, high])
        style.logarithmic(axes)
        axes.get_figure().draw_without_rendering()
        shown = {tick.get_text() for which in (False, True) for tick in axes.get_yticklabels(minor=which)}
    assert labels <= shown
    assert not set("$\\{}") & set("".join(shown))


def test_long_names_keep_their_beginning_and_their_end():
    assert short("WG1") == "WG1"
    assert short("twelve chars") == "twelve chars"
    names = [short(f"a long name of region {number}") for number in (1, 2)]
    assert names == ["a lon…ion 1", "a lon…ion 2"]
    assert short("_region") == label("_region")
