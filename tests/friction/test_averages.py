"""What is said of a reduction agrees with its sign."""

import re

from hypothesis import assume, given, strategies as st

from haptonic.friction.phrases import change

shares = st.floats(-1.5, 1.0)


@given(shares, shares, shares)
def test_friction_falls_or_rises_by_what_is_positive(one, two, three):
    low, value, high = sorted((one, two, three))
    said = re.fullmatch(
        r"friction (falls|rises) by ([\d.]+) % \((-?[\d.]+) to (-?[\d.]+) %\)",
        change(value, low, high),
    )
    assert said, "no minus sign in front of what it falls or rises by"
    digits = len(said[2].partition(".")[2])
    assert digits == (high - low < 0.04), "narrow intervals have a decimal"
    number, first, last = map(float, said.groups()[1:])
    sign = {"falls": 1, "rises": -1}[said[1]]
    assert abs(sign * number - 100 * value) <= 0.5 * 10**-digits + 1e-9
    assert first <= number <= last, "the interval is of the same thing"
    assume(number)
    assert (said[1] == "falls") == (value > 0)
