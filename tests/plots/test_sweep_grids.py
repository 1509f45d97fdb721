"""The map of a sweep over two expressions."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr

from haptonic import plots

HEIGHTS, RATIOS = (13e-3, 14e-3, 16e-3), (0.4, 0.6)


@pytest.fixture(scope="module")
def dataset() -> xr.Dataset:
    """Six designs: with two gaps, an uncertain one, none, a failed one, and with one gap each."""
    height, ratio = (axis.ravel() for axis in np.meshgrid(HEIGHTS, RATIOS, indexing="ij"))
    lower = np.array(
        [[50e3, 80e3], [61e3, np.nan], [np.nan] * 2, [np.nan] * 2, [40e3, np.nan], [55e3, np.nan]]
    )
    upper = np.array(
        [[58e3, 90e3], [62e3, np.nan], [np.nan] * 2, [np.nan] * 2, [46e3, np.nan], [67e3, np.nan]]
    )
    error = np.where(np.isfinite(lower), 100.0, np.nan)
    error[1] = 800.0
    searched = np.full(6, 1e5)
    searched[3] = np.nan
    data = xr.Dataset(
        {
            "value": ("step", height, {"units": "m"}),
            "second_value": ("step", ratio, {"units": "1"}),
            "gap_lower": (("step", "gap_slot"), lower),
            "gap_upper": (("step", "gap_slot"), upper),
            "gap_lower_error": (("step", "gap_slot"), error),
            "gap_upper_error": (("step", "gap_slot"), error),
            "searched_up_to": ("step", searched),
        }
    )
    data.attrs = {
        "expression": "cell.pillar.height", "second_expression": "cell.pillar.diameter / cell.pitch",
        "own_value": 14.5e-3, "own_second_value": 0.5, "carrier_hz": 60e3,
    }  # fmt: skip
    return data


def artists(figure, gid):
    return next(artist for axes in figure.axes for artist in axes.get_children() if artist.get_gid() == gid)


def test_colours_are_widths_of_certain_gaps(dataset):
    widths = artists(plots.sweep_grid(dataset), "width").get_array()
    assert widths.filled(0.0) == pytest.approx(np.array([[10.0, 0.0, 6.0], [0.0, 0.0, 12.0]]))
    assert widths.mask.sum() == 3  # an uncertain gap, no gap, and a failed design


def test_marks_are_at_their_designs(dataset):
    figure = plots.sweep_grid(dataset)
    places = {name: artists(figure, name).get_xydata().tolist() for name in ("carrier", "failed", "own")}
    assert places == {"carrier": [[16.0, 0.6]], "failed": [[14.0, 0.6]], "own": [[14.5, 0.5]]}


def test_ticks_are_at_the_values_of_few_designs(dataset):
    axes = plots.sweep_grid(dataset).axes[0]
    assert [text.get_text() for text in axes.get_xticklabels()] == ["13", "14", "16"]
    assert axes.get_yticks() == pytest.approx(RATIOS)


def test_the_star_of_the_study_leaves_its_circle_visible(dataset):
    dataset = dataset.assign_attrs(own_value=16e-3, own_second_value=0.6)
    figure = plots.sweep_grid(dataset)
    star, circle = artists(figure, "own"), artists(figure, "carrier")
    assert star.get_xydata().tolist() == circle.get_xydata().tolist()
    assert star.get_zorder() < circle.get_zorder()
    assert star.get_markersize() > 2 * circle.get_markersize()


def legend(figure) -> list[str]:
    return [text.get_text() for each in (*figure.legends, figure.axes[0].get_legend()) if each
            for text in each.get_texts()]  # fmt: skip


def test_the_legend_lists_only_marks_that_occur(dataset):
    every = ["carrier 60 kHz inside a gap", "could not be computed", "no certain complete gap", "this study"]
    assert legend(plots.sweep_grid(dataset)) == every
    sound = dataset.isel(step=[0, 4, 5, 0, 4, 5]).assign_attrs(own_value=99.0, carrier_hz=1.0)
    for name in ("value", "second_value"):
        sound[name] = ("step", dataset[name].values, dataset[name].attrs)
    assert legend(plots.sweep_grid(sound)) == []
    assert legend(plots.sweep_grid(sound.assign_attrs(carrier_hz=57e3))) == ["carrier 57 kHz inside a gap"]


def test_the_map_ends_half_a_step_beyond_the_outer_designs(dataset):
    """Also if the study's own design lies outside."""
    dataset = dataset.assign_attrs(own_value=30e-3)
    axes = plots.sweep_grid(dataset).axes[0]
    assert axes.get_xlim() == pytest.approx((12.5, 17.0))
    assert axes.get_ylim() == pytest.approx((0.3, 0.7))


def test_axes_have_names_and_units(dataset):
    axes, bar = plots.sweep_grid(dataset).axes
    assert axes.get_xlabel() == "pillar height (mm)"
    assert axes.get_ylabel() == "pillar diameter / pitch (dimensionless)"
    assert bar.get_ylabel() == "width of the widest complete gap (kHz)"
