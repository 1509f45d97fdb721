"""Lines of equal frequency over the zone: those that are resolved, with values that are right."""

from __future__ import annotations

import numpy as np
from matplotlib.contour import ContourSet
from matplotlib.tri import Triangulation
from seeing import artists, assert_readable

from haptonic import plots
from haptonic.bloch.zone import ZoneSurface
from simulated import reference_bands


def beside_plateau():
    """Band 6 is flat near Γ, and rises from 50 to 50.5 kHz within less than the distance of two samples."""
    data = reference_bands()
    away = np.linalg.norm(data["zone_kappa"].values, axis=1)
    data["zone_frequency"][:, 5] = (
        50e3 + 25e3 * np.clip(away - 1.4, 0, 0.02) + 900 * np.maximum(away - 1.42, 0)
    )
    return data


def levels(figure) -> list[ContourSet]:
    return [drawn for drawn in artists(figure, "levels") if isinstance(drawn, ContourSet)]


def sharp(line: np.ndarray) -> float:
    """Share of points at which a line turns by more than 15 degrees, and back at the next one."""
    step = np.diff(line, axis=0)
    step = step[np.linalg.norm(step, axis=1) > 1e-9]
    turn = np.angle(np.exp(1j * np.diff(np.angle(step @ [1, 1j]))))
    return float(np.mean((turn[1:] * turn[:-1] < 0) & (np.abs(turn[1:]) > 0.26) & (np.abs(turn[:-1]) > 0.26)))


def test_a_line_beside_a_plateau_is_left_out_and_others_are_drawn():
    data = beside_plateau()
    surface = ZoneSurface.of_dataset(data)
    k, triangles, number = surface.unfolded()
    plane = Triangulation(*(k.T / 1e3), triangles)
    axes = plots.iso_frequency(data, bands=(6,)).axes[0]
    near = axes.tricontour(plane, surface.frequency[number, 5] / 1e3, levels=[50.4])
    assert sharp(near.get_paths()[0].vertices) > 0.2  # such a line would be jagged
    (drawn,) = levels(plots.iso_frequency(data, bands=(6,)))
    assert len(drawn.levels) >= 4
    assert 50.5 < min(drawn.levels) < 51.0
    for path in drawn.get_paths():
        assert sharp(path.vertices) < 0.2


def test_lines_have_their_values_and_these_are_readable():
    data = reference_bands()
    figure = plots.iso_frequency(data)
    assert_readable(figure)
    surface = ZoneSurface.of_dataset(data)
    k, _, number = surface.unfolded()
    for axes, band in zip((axes for axes in figure.axes if axes.get_title()), (1, 6), strict=True):
        values = [text for text in axes.texts if text.get_gid() == "level"]
        assert len(values) >= 2
        for text in values:
            near = np.linalg.norm(k / 1e3 - text.get_position(), axis=1).argsort()[:8]
            there = surface.frequency[number[near], band - 1] / 1e3
            assert there.min() <= float(text.get_text()) <= there.max()


def test_a_flat_band_is_drawn_without_lines():
    data = reference_bands()
    data["zone_frequency"][:, 5] = 50e3
    assert not levels(plots.iso_frequency(data, bands=(6,)))
