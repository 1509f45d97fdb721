"""The sentence on a reduction agrees with its sign."""

import re

from hypothesis import assume, given, strategies as st

from haptonic.friction.phrases import change

shares = st.floats(-1.5, 1.0)


@given(shares, shares, shares)
def test_friction_falls_or_rises_by_what_is_positive(a, b, c):
    low, value, high = sorted((a, b, c))
    match = re.fullmatch(
        r"friction (falls|rises) by ([\d.]+) % \((-?[\d.]+) to (-?[\d.]+) %\)",
        change(value, low, high),
    )
    assert match, "no minus sign in front of what it falls or rises by"
    digits = len(match[2].partition(".")[2])
    assert digits == (high - low < 0.04), "narrow intervals have a decimal"
    number, first, last = map(float, match.groups()[1:])
    sign = {"falls": 1, "rises": -1}[match[1]]
    assert abs(sign * number - 100 * value) <= 0.5 * 10**-digits + 1e-9
    assert first <= number <= last, "the interval is of the same thing"
    assume(number)
    assert (match[1] == "falls") == (value > 0)
