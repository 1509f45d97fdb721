"""Pictures of scans show the numbers that were given."""

from __future__ import annotations

import numpy as np
import pytest
import xarray as xr
from seeing import artists, shown_texts

from haptonic import plots
from haptonic.vibrometry import Edge, LatticeGap, MeasuredGap, Quality, drive
from haptonic.vibrometry.guides import Guiding
from haptonic.vibrometry.theory import guided

LINES = 1e3 * np.arange(40.0, 71.0)


def texts(figure) -> str:
    return " | ".join(text for text, _ in shown_texts(figure))


def test_the_drive_and_its_band():
    signal = drive(low=20e3, high=60e3, sample_rate=200e3, duration=5e-3, amplitude=60.0)
    above, below = plots.drive_signal(signal).axes
    assert above.lines[0].get_ydata().max() <= 60
    assert above.get_xlim() == (0, 5)
    spectrum, *edges = below.lines
    assert [line.get_xdata()[0] for line in edges] == [20, 60]
    level = np.interp([10, 40, 90], spectrum.get_xdata(), spectrum.get_ydata())
    assert level[1] > -6 > -15 > max(level[0], level[2])


def test_the_contrast_and_the_gap_s_uncertainty():
    gap = MeasuredGap(52e3, 60e3, 500.0, 1500.0, 0, 0, 0, 20)
    figure = plots.measured_contrast(LINES, {"A over B": LINES / 1e3}, gap, (53e3, 59e3), origin="simulated")
    assert sorted(tuple(line.get_xdata()) for line in artists(figure, "error")) == [
        (51.5, 52.5),
        (58.5, 61.5),
    ]
    (line,) = artists(figure, "range")
    assert tuple(line.get_xdata()) == (52, 60)
    (shade,) = artists(figure, "gap")
    assert (shade.get_x(), shade.get_x() + shade.get_width()) == (53, 59)
    assert "simulated contrast" in texts(figure)
    assert "high contrast 52.0 ± 0.5 to 60.0 ± 1.5 kHz" in texts(figure)
    assert "computed gap 53.0 to 59.0 kHz" in texts(figure)


def test_a_decay_map_marks_the_gap_edge():
    fades = xr.DataArray(
        np.outer(LINES / 10e3, [1.0, 2.0, 3.0]), dims=("frequency", "phase"),
        coords={"frequency": LINES, "phase": [0.0, np.pi / 2, np.pi]},
    )  # fmt: skip
    gap = LatticeGap(Edge(53e3, 600.0), None, ("no upper edge: why",))
    figure = plots.decay_map(fades, gap, (52.5e3, 60e3), origin="simulated")
    (least,) = artists(figure, "least")
    assert least.get_ydata()[5:-5] == pytest.approx(LINES[5:-5] / 10e3)  # the phase that decays least
    (half,) = artists(figure, "half")
    assert half.get_paths()[0].get_extents().y1 == pytest.approx(2.5 * 6.9, rel=0.02)  # of 1, 2 and 3
    (error,) = {tuple(line.get_xdata()) for line in artists(figure, "error")}
    assert error == pytest.approx((52.4, 53.6))
    assert "lower edge (experimental) 53.0 ± 0.6 kHz" in texts(figure)
    assert "computed gap 52.5 to 60.0 kHz" in texts(figure)
    assert "simulated" in texts(figure)


def test_waves_and_dispersion():
    wavenumber = np.linspace(-500, 500, 41)
    amplitude = np.ones((len(LINES), 41))
    amplitude[10, 30] = 50.0
    waves = xr.DataArray(
        amplitude, dims=("frequency", "wavenumber"), coords={"frequency": LINES, "wavenumber": wavenumber}
    )
    curve = (np.array([40e3, 70e3]), np.array([200.0, 300.0]))
    figure = plots.wave_map(waves, curve, (np.zeros(0), np.zeros(0)), region="WG1", origin="simulated")
    axes = figure.axes[0]
    drawn = axes.collections[0].get_array()
    assert np.unravel_index(np.argmax(drawn), drawn.shape) == (10, 30 * drawn.shape[1] // 41)
    # there and back: a standing wave is both
    assert [line.get_xdata().tolist() for line in axes.lines] == [[0.2, 0.3], [-0.2, -0.3]]
    assert "along the region WG1" in texts(figure)
    assert "no mode of the guide in the gap" in texts(figure)
    assert "simulated" in texts(figure)
    bar = figure.axes[-1]
    named = [label.get_text() for label in bar.get_yticklabels()]
    assert {"10⁻²", "10⁻¹", "10⁰"} <= set(named)
    assert not any("$" in label for label in named)


def test_a_guide_with_a_mode_and_one_of_which_nothing_is_computed_have_no_such_entry():
    waves = xr.DataArray(
        np.ones((len(LINES), 41)), dims=("frequency", "wavenumber"),
        coords={"frequency": LINES, "wavenumber": np.linspace(-500, 500, 41)},
    )  # fmt: skip
    mode = (np.array([52e3, 58e3]), np.array([250.0, 260.0]))
    for given in (mode, None):
        figure = plots.wave_map(waves, None, given, region="WG1", origin="simulated")
        assert "no mode" not in texts(figure)
        assert len(figure.axes[0].lines) == (2 if given else 0)


@pytest.mark.parametrize("points", [24, 25])
def test_a_map_of_waves_has_the_values_between_the_wavenumbers(points):
    """As if the rows were padded with more zeros, for an odd and an even number of points."""
    place = 2e-3 * np.arange(points)
    motion = np.exp(-310j * place) + 0.5 * np.exp(150j * place) + 0.1 * np.exp(700j * place)
    motion = motion * np.hanning(points + 2)[1:-1]

    def shown(padded: int) -> xr.DataArray:
        k = np.fft.fftshift(2 * np.pi * np.fft.fftfreq(padded * points, 2e-3))
        amplitude = np.fft.fftshift(np.abs(np.fft.fft(motion, padded * points)))
        lines = np.array([50e3, 51e3])
        return xr.DataArray(
            np.stack([amplitude, amplitude]), dims=("frequency", "wavenumber"),
            coords={"frequency": lines, "wavenumber": k},
        )  # fmt: skip

    (image,) = plots.wave_map(shown(4), None, None, region="WG1", origin="measured").axes[0].collections
    drawn, exact = np.asarray(image.get_array())[0], shown(4 * len(image.get_array()[0]) // (4 * points))
    assert len(drawn) >= 1000
    wanted = exact.values[0] / exact.values.max()
    assert drawn == pytest.approx(np.maximum(wanted, 1e-2), rel=2e-3)
    edges = np.asarray(image.get_coordinates())[0, :, 0]
    assert 0.5 * (edges[1:] + edges[:-1]) == pytest.approx(exact["wavenumber"].values / 1e3, abs=1e-9)


def test_a_loud_line_among_very_many_is_drawn():
    lines, wavenumber = 10.0 * np.arange(1, 2501), np.linspace(-500, 500, 9)
    amplitude = np.full((2500, 9), 0.1)
    amplitude[1234, 4] = 1.0
    waves = xr.DataArray(
        amplitude, dims=("frequency", "wavenumber"), coords={"frequency": lines, "wavenumber": wavenumber}
    )
    figure = plots.wave_map(waves, None, None, region="WG1", origin="measured")
    drawn = figure.axes[0].collections[0].get_array()
    assert len(drawn) <= 600
    assert (drawn == 1).sum() == 1


def test_decay_beside_the_computed_one():
    rows = {"decay": 0 * LINES + 6, "low": 0 * LINES + 4, "high": 0 * LINES + 8}
    decay = xr.Dataset(
        {name: ("frequency", values) for name, values in rows.items()}, coords={"frequency": LINES},
        attrs={"confidence": 0.95},
    )  # fmt: skip
    phases = [0.0, 0.5 * np.pi, np.pi]
    fades = xr.Dataset(
        {"attenuation": (("frequency", "phase"), np.outer(LINES, [1, 2, 3]))},
        coords={"frequency": LINES, "phase": phases},
    )
    figure = plots.measured_decay(decay, fades, (52e3, 60e3), origin="simulated")
    for words in ("phase 0 ", "phase 0.5 π", "phase π", "95 % interval", "simulated"):
        assert words in texts(figure)


def test_bad_points_are_marked():
    places = np.stack(np.meshgrid(np.arange(4.0), np.arange(3.0)), axis=-1).reshape(-1, 2) * 1e-3
    flags = [()] * 10 + [("dropout",), ("dropout", "repaired")]
    coherence = np.full(12, 0.97)
    coherence[3] = np.nan
    quality = Quality(tuple(map(str, range(12))), np.zeros(12), np.zeros(12), coherence, tuple(flags))
    figure = plots.point_quality(places, quality, origin="simulated")
    assert "dropout (2)" in texts(figure)
    assert "repaired (1)" in texts(figure)
    shown = figure.axes[0].collections[0]
    assert len(shown.get_offsets()) == 11
    assert np.asarray(shown.get_array()) == pytest.approx(np.full(11, 0.03))  # 1 less the coherence
    unknown = Quality(quality.names, quality.clipped, quality.frozen, np.full(12, np.nan), ((),) * 12)
    assert len(plots.point_quality(places, unknown, origin="measured").axes) == 1


def test_a_guide_without_a_mode_differs_from_one_that_was_not_computed():
    waves = xr.Dataset(
        {
            "guided_frequency": (("guide", "step"), [[np.nan, np.nan], [52e3, np.nan]]),
            "guided_wavenumber": (("guide", "step"), [[np.nan, np.nan], [250.0, np.nan]]),
        },
        coords={"width": ("guide", [8e-3, 32e-3]), "along": ("guide", ["y", "y"])},
    )

    def of_width(width: float):
        return guided(waves, Guiding("WG1", "y", width, "lattice"))

    assert [len(part) for part in of_width(8e-3)] == [0, 0]
    assert [part.tolist() for part in of_width(32e-3)] == [[52e3], [250.0]]
    assert of_width(14e-3) is None
