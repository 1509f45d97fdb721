"""Criteria of responses that are alike but for what they are blind to."""

import numpy as np
import pytest
from small_plate import LINES, response

from five_parts import refusing
from haptonic.errors import ScanError
from haptonic.response import FrequencyResponse
from haptonic.updating.agreement import agreement, normal_of, together


def changed(scan, values=None, *, frequency=None, shift=0.0, keep=slice(None), **others):
    data = scan.dataset
    values = scan.values if values is None else values
    return FrequencyResponse.of(
        values[:, keep], frequency=scan.frequency if frequency is None else frequency,
        x=data["x"].values[keep] + shift, y=data["y"].values[keep].copy(),
        reference=others.get("reference", data.attrs["reference"]), origin="measured",
        direction=others.get("direction", ("z",)), region=data["region"].values[keep].tolist(),
    )  # fmt: skip


def test_equal_responses_agree_in_everything():
    compared = agreement(response(), response(), "operating shapes")
    assert compared.frac == pytest.approx(np.ones(len(compared.frac)))
    assert compared.unexplained == 0
    assert len(compared.pairs) == len(compared.measured.frequency) >= 3
    assert np.diag(compared.mac) == pytest.approx(np.ones(len(compared.mac)))


def test_a_factor_for_each_point_is_not_seen_by_the_criterion_but_by_the_energy():
    """FRAC is blind to it, shapes and energies are not."""
    factors = np.random.default_rng(0).uniform(0.5, 2, len(response().points)) * np.exp(1j)
    scaled = changed(response(), response().values * factors[:, None])
    compared = agreement(scaled, response(), "operating shapes")
    assert compared.frac == pytest.approx(np.ones(len(factors)))
    assert compared.unexplained > 0.1
    assert (np.diag(compared.mac) < 0.99).any()


def test_displacement_is_compared_as_displacement():
    compared = agreement(response().displacement(), response(), "operating shapes")
    assert compared.unexplained == pytest.approx(0, abs=1e-12)


def test_a_point_at_rest_has_no_criterion():
    values = response().values.copy()
    values[:, 3] = 0
    compared = agreement(changed(response(), values), response(), "operating shapes")
    assert np.flatnonzero(np.isnan(compared.frac)).tolist() == [3]


def test_common_lines_and_points_are_found():
    whole = response()
    part = changed(whole, whole.values[50:90], frequency=LINES[50:90], shift=1e-4, keep=slice(2, 9))
    scan, computed = together(part, whole)
    assert scan.frequency == pytest.approx(LINES[50:90])
    assert computed.points == pytest.approx(scan.points)
    assert normal_of(scan) == pytest.approx(normal_of(computed))
    assert agreement(scan, computed, "operating shapes").unexplained == 0


@pytest.mark.parametrize(
    ("others", "argument", "given"),
    [
        ({"frequency": LINES + 0.3}, "computed", "0 of 146 measured lines"),
        ({"shift": 1.4e-3}, "computed", "0 of 35 measured points"),
        ({"reference": "U, V"}, "reference", "per V, per N"),
        ({"reference": ""}, "reference", "not divided by the drive, per N"),
    ],
)
def test_what_has_nothing_in_common_is_refused(others, argument, given):
    with refusing(ScanError, "mismatch", argument, given):
        together(changed(response(), **others), response())


def test_motion_in_the_plane_alone_is_refused():
    with refusing(ScanError, "missing", "direction"):
        normal_of(changed(response(), direction=("x",)))
