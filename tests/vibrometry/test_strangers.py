"""Scans of a known field in the ways of other programs: the right value or a refusal, never a wrong value."""

from __future__ import annotations

import tempfile
import warnings
from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from strangers import ARRAYS, TABLES, expected, strangers, written

from haptonic import read_scan
from haptonic.errors import HaptonicError, HaptonicWarning

SLACK = 1e-5
QUICK = settings(max_examples=30, deadline=None, suppress_health_check=list(HealthCheck))
LONG = settings(max_examples=3000, deadline=None, suppress_health_check=list(HealthCheck))


def outcome(stranger) -> str:
    """ "right", "refused", "warned" or "wrong"; a scan whose file and options are complete must be read."""
    with tempfile.TemporaryDirectory() as place, warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        path = written(stranger, Path(place))
        caught.clear()
        try:
            scan = read_scan(path, **stranger.options)
        except HaptonicError as error:
            if stranger.complete or not all(error.parts().values()):
                raise
            return "refused"
    response = scan.response
    values, quantity = expected(stranger)
    size = np.abs(values).max()
    right = (
        response.dataset.attrs["quantity"] == quantity
        and response.values[..., 0].shape == values.shape
        and np.abs(response.values[..., 0] - values).max() <= SLACK * size
        and np.allclose(response.points, np.column_stack([stranger.x, stranger.y]), rtol=0, atol=1e-9)
        and np.allclose(response.frequency, stranger.frequency, rtol=1e-6)
    )
    if right:
        return "right"
    if stranger.said or stranger.container == "uff" or "unit" in stranger.options:
        return "wrong"
    # A file without units, read by somebody who gives none: a warning, or a remark on the assumed unit.
    if any(issubclass(warning.category, HaptonicWarning) for warning in caught):
        return "warned"
    assumed = [
        remark
        for remark in scan.report.remarks
        if "unit" in remark and ("read in" in remark or "was used" in remark)
    ]
    return "assumed" if assumed else "wrong"


@QUICK
@given(strangers(ARRAYS))
def test_arrays(stranger):
    assert outcome(stranger) != "wrong"


@QUICK
@given(strangers((*TABLES, "uff")))
def test_folders_and_universal_files(stranger):
    assert outcome(stranger) != "wrong"


@pytest.mark.nightly
@pytest.mark.parametrize("container", [*ARRAYS, *TABLES, "uff"])
def test_thousands(container):
    counts: Counter[str] = Counter()

    @LONG
    @given(strangers((container,)))
    def counted(stranger):
        result = outcome(stranger)
        counts[result] += 1
        assert result != "wrong"

    counted()
    print(f"{container}: {dict(counts)}")
