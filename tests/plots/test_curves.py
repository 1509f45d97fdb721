"""Curves of a band diagram: through all computed frequencies, smooth between them, and whole."""

from __future__ import annotations

import json
from typing import ClassVar

import numpy as np
import pytest
import xarray as xr
from seeing import artists, assert_readable, shown_texts

from haptonic import plots
from haptonic.bloch.bands import lattice_of
from haptonic.plots import style
from haptonic.plots.curves import PIECES, curves
from simulated import reference_bands

KHZ = 1e3


def levels(kappa: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(n, 3) frequencies of three waves, Hz, and (n, 3, 2) their slopes in the phases.

    The first two cross; the third enters from above and crosses the second.
    """
    (x, y), ones = kappa.T, np.ones(len(kappa))
    waves = [
        (20 * ones - 9 * np.cos(x) - 2 * np.cos(y), 9 * np.sin(x), 2 * np.sin(y)),
        (21 * ones + 6 * np.cos(x) + 3 * np.cos(y), -6 * np.sin(x), -3 * np.sin(y)),
        (26 * ones + 12 * np.cos(x + 1.2), -12 * np.sin(x + 1.2), 0 * ones),
    ]
    values = np.stack([wave[0] for wave in waves], axis=1)
    return KHZ * values, KHZ * np.stack([np.stack(wave[1:], axis=1) for wave in waves], axis=1)


def simulated(count: int) -> xr.Dataset:
    """The lowest bands of `levels` along the path of the reference cell."""
    given = reference_bands()
    kappa = given["kappa"].values
    values, slopes = levels(kappa)
    order = np.argsort(values, axis=1, kind="stable")[:, :count]
    velocity = 2 * np.pi * slopes @ lattice_of(given).vectors
    of_modes = ("wavevector", "band")
    return xr.Dataset(
        {
            "distance": given["distance"],
            "kappa": given["kappa"],
            "frequency": (of_modes, np.take_along_axis(values, order, 1)),
            "frequency_error": (of_modes, np.full(order.shape, 1e-3)),
            "group_velocity": ((*of_modes, "axis"), np.take_along_axis(velocity, order[..., None], 1)),
            "branch": (of_modes, order),
        },
        attrs=given.attrs,
    )


def between(data: xr.Dataset) -> np.ndarray:
    """(places, 3) the same waves at all places of the drawn curves."""
    places = curves(data)[0].distance
    kappa = [np.interp(places, data["distance"], data["kappa"][:, axis]) for axis in range(2)]
    return levels(np.stack(kappa, axis=1))[0]


def test_curves_contain_all_computed_frequencies():
    data = reference_bands()
    drawn = np.stack([curve.frequency[::PIECES] for curve in curves(data)], axis=1)
    assert np.sort(drawn, axis=1) == pytest.approx(data["frequency"].values, abs=1e-6)
    for curve in curves(data):
        assert curve.distance[::PIECES] == pytest.approx(data["distance"].values)


def test_a_curve_is_near_the_wave_between_the_wavevectors_and_crosses_others():
    data = simulated(3)
    exact, places = between(data), curves(data)[0].distance
    straight = np.stack([np.interp(places, places[::PIECES], wave[::PIECES]) for wave in exact.T], axis=1)
    most = np.abs(straight - exact).max()
    assert most > 50.0  # the picture that would be drawn without slopes
    for curve in curves(data):
        (number,) = set(curve.branch)
        assert np.abs(curve.frequency - exact[:, number]).max() < 0.02 * most
    assert np.any(curves(data)[0].band != curves(data)[0].band[0])  # there is a crossing


def test_slopes_are_those_of_the_segment_on_both_sides_of_a_corner():
    data = simulated(3)
    corner = PIECES * json.loads(data.attrs["path_corners"])[1]
    exact = between(data)
    near = exact[corner - 1 : corner + 2, 0]
    (curve,) = (curve for curve in curves(data) if curve.branch[0] == 0)
    assert np.diff(curve.frequency[corner - 1 : corner + 2]) == pytest.approx(np.diff(near), rel=0.02)


def test_a_wave_that_enters_from_above_meets_the_last_band_in_a_corner():
    data = simulated(2)
    exact = np.sort(between(data), axis=1)[:, :2]
    drawn = np.stack([curve.frequency for curve in curves(data)], axis=1)
    assert len(set(curves(data)[0].branch) | set(curves(data)[1].branch)) == 3
    assert np.abs(np.sort(drawn, axis=1) - exact).max() < 100.0
    smooth = data.drop_vars("group_velocity")
    cut = np.sort(np.stack([curve.frequency for curve in curves(smooth)], axis=1), axis=1)
    assert np.abs(cut - exact).max() > 200.0


def test_without_velocities_curves_are_straight_between_the_wavevectors():
    data = reference_bands().drop_vars("group_velocity")
    for curve in curves(data):
        straight = np.interp(curve.distance, curve.distance[::PIECES], curve.frequency[::PIECES])
        assert curve.frequency == pytest.approx(straight)


def test_modes_mixed_at_a_corner_give_no_slope():
    data = reference_bands()
    before = np.stack([curve.frequency for curve in curves(data)])
    corner = json.loads(data.attrs["path_corners"])[2]
    data["group_velocity"][corner, 5:7] = 1e5
    apart = np.abs(np.stack([curve.frequency for curve in curves(data)]) - before).max()
    assert apart > KHZ  # they are 8 kHz apart there, so their velocities are used
    data["frequency_error"][corner, 5:7] = 10 * KHZ
    mixed = np.abs(np.stack([curve.frequency for curve in curves(data)]) - before).max()
    assert mixed < KHZ


def test_no_mode_is_left_out_of_the_picture_of_natures():
    """At every wavevector and between any two, as many curves as bands, also where a branch ends."""
    data = reference_bands()
    corners = json.loads(data.attrs["path_corners"])
    kinds = [json.loads(data.attrs["character_names"])[k] for k in data["character"].values.ravel()]
    assert kinds.count("rigid body") == 6  # at Γ, where a curve has the name that it has next to it
    ended = [len(set(data["branch"].values[:, band])) for band in range(data.sizes["band"])]
    assert max(ended) > 1
    figure = plots.dispersion(data, natures=True)
    lines = [line for line in figure.axes[0].lines if (line.get_gid() or "").startswith("branch")]
    distance = data["distance"].values
    for place in (*(distance[:-1] + 0.3 * np.diff(distance)), distance[corners[0]], distance[corners[-1]]):
        slack = 1e-9 * distance[-1]
        over = [
            line for line in lines if line.get_xdata()[0] - slack <= place <= line.get_xdata()[-1] + slack
        ]
        assert len(over) == data.sizes["band"], place
    for line in lines:
        assert len(line.get_xdata()) > 1


class TestRangeOfTheLastBand:
    """Of 7 bands, the last closes the gap, and the lowest frequency of it is the gap's upper edge."""

    SEVEN: ClassVar = {"band": slice(7)}

    @pytest.mark.parametrize("natures", [False, True])
    def test_the_band_above_the_gap_is_in_view(self, natures):
        seven = reference_bands().isel(self.SEVEN)
        figure = plots.dispersion(seven, natures=natures)
        upper = float(seven["gap_upper"][0]) / KHZ
        assert float(seven["frequency"][:, -1].min()) / KHZ == pytest.approx(upper, rel=1e-3)
        assert figure.axes[0].get_ylim()[1] >= 1.1 * upper

    def test_the_range_in_which_bands_are_missing_is_grey_and_named(self):
        seven = reference_bands().isel(self.SEVEN)
        figure = plots.dispersion(seven)
        (patch,) = artists(figure, "beyond")
        lowest = float(seven["frequency"][:, -1].min()) / KHZ
        assert patch.get_y() == pytest.approx(lowest)
        assert patch.get_y() + patch.get_height() >= figure.axes[0].get_ylim()[1]
        assert patch.get_facecolor()[:3] == pytest.approx((0.894,) * 3, abs=1e-3)
        assert style.BEYOND == "#e4e4e4"
        assert "bands above band 7 are missing" in [text for text, _ in shown_texts(figure)]
        assert_readable(figure)

    def test_nothing_is_named_where_no_band_is_missing(self):
        figure = plots.dispersion(reference_bands())
        (patch,) = artists(figure, "beyond")
        assert patch.get_y() > figure.axes[0].get_ylim()[1]
        assert not figure.legends
