"""Pictures of ribbons: names of what is drawn, colours that are clear on white, a field without corners."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr
from seeing import artists, assert_readable

from haptonic import plots
from haptonic.plots.ribbons import dark_on_white

PHASES, PERIOD, PITCH = np.linspace(0, np.pi, 9), 12e-3, 10e-3
COLUMNS = 6


def simulated_ribbon(crystals: int = 2, apart: float = 0.0, carrier: float = 100e3) -> xr.Dataset:
    """A mode at 100 kHz between two bulk bands, on an oblique ribbon."""
    bulk = np.array([80e3, 104e3]) + apart * np.arange(crystals)[:, None, None] + 0 * PHASES[:, None]
    column, along = np.meshgrid(np.arange(COLUMNS + 1), np.arange(5), indexing="ij")
    across = PITCH * column.ravel()
    place = np.column_stack([across, PERIOD * (0.25 * along.ravel() + 0.5 * column.ravel())])
    corner = (5 * np.arange(COLUMNS)[:, None] + np.arange(4)).ravel()
    triangles = np.concatenate([corner[:, None] + [0, 1, 5], corner[:, None] + [1, 5, 6]])
    wave = np.exp(1j * 0.6 * np.pi * place[:, 1] / PERIOD - abs(across - 3 * PITCH) / PITCH)
    return xr.Dataset(
        {
            "wavevector_phase": ("wavevector", PHASES),
            "bulk_lower": (("crystal", "wavevector", "bulk_band"), bulk),
            "bulk_upper": (("crystal", "wavevector", "bulk_band"), bulk + 16e3),
            "phase": ("mode", PHASES), "frequency": ("mode", np.full(9, 100e3)),
            "group_velocity": ("mode", np.zeros(9)), "guide_share": ("mode", np.linspace(0, 1, 9)),
            "field_position": (("node", "axis"), place),
            "field_triangle": (("triangle", "vertex"), triangles),
            "field_real": ("node", wave.real), "field_imag": ("node", wave.imag),
            "field_frequency": 100e3, "field_phase": 0.6 * np.pi, "field_component": 2,
        },
        coords={"cell_name": (("line", "column"), [["left"] * 3 + ["right"] * 3])},
        attrs={"range_hz": [95e3, 106e3], "period": PERIOD, "kind": "edge", "carrier_hz": carrier},
    )  # fmt: skip


def legend(figure):
    return [text.get_text() for legend in figure.legends for text in legend.get_texts()]


def test_carrier_and_bulk_bands_are_named():
    figure = plots.projected(simulated_ribbon())
    assert legend(figure) == ["bulk bands of both crystals", "not computed", "carrier 100 kHz"]
    assert_readable(figure)


def test_each_crystal_has_its_own_shade_unless_they_are_mirror_images():
    assert legend(plots.projected(simulated_ribbon(1)))[:1] == ["bulk bands"]
    two = legend(plots.projected(simulated_ribbon(apart=1e3)))
    assert two[:2] == ["bulk bands of crystal 1", "bulk bands of crystal 2"]


def test_every_colour_of_a_mode_has_a_contrast_of_3_on_white():
    shares = dark_on_white()(np.linspace(0, 1, 50))[:, :3]
    linear = np.where(shares <= 0.04045, shares / 12.92, ((shares + 0.055) / 1.055) ** 2.4)
    assert (1.05 / (linear @ [0.2126, 0.7152, 0.0722] + 0.05)).min() > 2.95


def test_the_field_of_an_oblique_ribbon_fills_its_axes():
    data = simulated_ribbon()
    figure = plots.ribbon_field(data)
    axes = figure.axes[0]
    copies = [part for part in axes.collections if hasattr(part, "_triangulation")]
    low, high = np.array(axes.get_xlim()), 1e3 * PITCH * COLUMNS
    for across in (0.0, high):
        ends = [part._triangulation.x[np.isclose(part._triangulation.y, across)] for part in copies]
        assert min(end.min() for end in ends) <= low[0] + 1e-9
        assert max(end.max() for end in ends) >= low[1] - 1e-9
    (edge,) = artists(figure, "edge")
    assert edge.get_ydata()[0] == pytest.approx(0.5 * high)
    assert_readable(figure)


def test_the_bar_of_a_field_is_as_high_as_the_axes():
    figure = plots.ribbon_field(simulated_ribbon())
    figure.canvas.draw()
    axes = figure.axes[0]
    (bar,) = axes.child_axes
    assert bar.get_window_extent().height == pytest.approx(axes.get_window_extent().height, rel=1e-6)
