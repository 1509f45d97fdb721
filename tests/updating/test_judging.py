"""What a verdict makes of a scan before it compares, and by which contrast."""

import numpy as np
import pytest
from small_plate import LINES, POINTS, plate

from five_parts import refusing
from haptonic.analyses.verdict import _on_plate
from haptonic.errors import ScanError
from haptonic.plate.vibration.region_measures import contrasts
from haptonic.response import FrequencyResponse
from haptonic.results.verdict import BEFORE, MEASURED, Verdict
from haptonic.updating.agreement import together
from haptonic.vibrometry.on_plate import region_levels


def scan(points):
    points = np.array(points)
    return FrequencyResponse.of(
        np.ones((3, len(points), 1), complex), frequency=LINES[:3], x=points[:, 0].copy(),
        y=points[:, 1].copy(), reference="F, N", origin="measured",
    )  # fmt: skip


CORNERS = [(0, 0), (21e-3, 0), (0, 14e-3), (21e-3, 14e-3)]


def test_points_get_the_names_of_their_regions_and_those_on_a_lattice_none():
    """The plate's border belongs to it, a border between tiles to the right and the upper one."""
    inside = [*CORNERS, (5e-3, 5e-3), (14e-3, 7e-3)]
    located, left_out = _on_plate(plate(), scan([*inside, (21.1e-3, 5e-3), (5e-3, -1e-6)]))
    assert left_out == 2
    assert located.points == pytest.approx(np.array(inside))
    assert located.dataset["region"].values.tolist() == ["p", "", "p", "", "p", ""]


def test_a_scan_of_another_place_is_refused():
    with refusing(ScanError, "mismatch", "points", "5 of 9"):
        _on_plate(plate(), scan([*CORNERS, *(np.array([(k, 50) for k in range(5)]) * 1e-3)]))


def test_a_plate_its_scan_and_a_verdict_mean_the_same_by_contrast():
    """The computed response comes without names of regions: its points are those of the scan."""
    louder, on = np.where(POINTS[:, 0] < 14e-3, 10.0, 1.0), plate(drive=(5e-3, 5e-3))  # 20 dB
    measured, _ = _on_plate(on, scan(POINTS))
    values = measured.dataset["response"] * louder[:, None]
    measured = FrequencyResponse(measured.dataset.assign(response=values))
    measured, computed = together(measured, scan(POINTS))
    verdict = Verdict(
        plate=on, responses={MEASURED: measured, BEFORE: computed}, agreements={}, ranges={}, fit=None,
        recomputed=None, left_out=0, study=None, inputs={},
    )  # fmt: skip
    of_plate, (of_scan, _), both = contrasts(measured, "p"), region_levels(measured, "p"), verdict.contrasts()
    (pair,) = of_plate.keys() & both.keys() & set(of_scan["pair"].values)
    assert pair == "p over the rest"
    for levels in (of_plate[pair].values, of_scan["contrast"].values[0], both[pair][MEASURED]):
        assert levels == pytest.approx(20.0, abs=1e-9)
    assert both[pair][BEFORE] == pytest.approx(0.0, abs=1e-9)
