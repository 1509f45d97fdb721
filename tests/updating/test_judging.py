"""What a verdict makes of a scan before it compares."""

import numpy as np
import pytest
from small_plate import LINES, plate

from haptonic.analyses.verdict import _on_plate
from haptonic.errors import ScanError
from haptonic.response import FrequencyResponse


def scan(points):
    points = np.array(points)
    return FrequencyResponse.of(
        np.ones((3, len(points), 1), complex), frequency=LINES[:3], x=points[:, 0].copy(),
        y=points[:, 1].copy(), reference="F, N", origin="measured",
    )  # fmt: skip


CORNERS = [(0, 0), (21e-3, 0), (0, 14e-3), (21e-3, 14e-3)]


def test_points_get_the_names_of_their_tiles():
    """The plate's border belongs to it, a border between tiles to the right and the upper one."""
    inside = [*CORNERS, (5e-3, 5e-3), (14e-3, 7e-3)]
    found, left_out = _on_plate(plate(), scan([*inside, (21.1e-3, 5e-3), (5e-3, -1e-6)]))
    assert left_out == 2
    assert found.points == pytest.approx(np.array(inside))
    assert found.dataset["region"].values.tolist() == ["p", "o", "p", "o", "p", "o"]


def test_a_scan_of_another_place_is_refused():
    with pytest.raises(ScanError, match="5 of 9 beside the plate"):
        _on_plate(plate(), scan([*CORNERS, *(np.array([(k, 50) for k in range(5)]) * 1e-3)]))
