"""Cases of a parametrised test of which some run every day and the others in `make nightly`."""

from collections.abc import Iterable
from typing import Any

import pytest


def daily(cases: Iterable[Any], *every_day: Any) -> list[Any]:
    """Cases for `pytest.mark.parametrize`: all but those that run every day are marked as nightly.

    A case is the value of one argument, or a tuple of as many values as the test has arguments.
    """
    cases = list(cases)
    assert all(case in cases for case in every_day)
    return [
        case
        if case in every_day
        else pytest.param(*(case if isinstance(case, tuple) else (case,)), marks=pytest.mark.nightly)
        for case in cases
    ]
