"""Pictures of the lattice as a mirror: what is drawn where, and that it can be read."""

from __future__ import annotations

import dataclasses

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from seeing import Drawn, artists, assert_readable, shown_texts

from daily import daily
from haptonic import plots
from simulated import reference_guides, simulated_mirror

ONE_FAMILY = ("SH0",)
DATASETS = {
    "usual": {},
    "one row": {"rows": 1},
    "twelve rows": {"rows": 12},
    "twenty rows of one wave": {"rows": 20, "families": ONE_FAMILY},
    "one wave": {"rows": 1, "families": ONE_FAMILY},
    "two waves": {"families": ("A0", "SH0")},
    "no gap": {"gap": []},
    "oblique": {"angle": 0.5, "rows": 2},
    "elsewhere": {"carrier_hz": 90e3, "gap": [100e3, 120e3]},
}


def guide(width: float = 32e-3, fixed_line: float = 1e-3) -> Figure:
    position = np.linspace(-0.5 * width, 0.5 * width, 101)
    return plots.guide(position, np.cos(np.pi * position / (width + 2 * fixed_line)), 0.1, width, fixed_line)


PICTURES = {
    **{
        f"decay, {name}": (lambda k=DATASETS[name]: plots.decay(simulated_mirror(**k)))
        for name in ("usual", "no gap", "elsewhere")
    },
    **{f"layers, {name}": (lambda k=k: plots.layers(simulated_mirror(**k))) for name, k in DATASETS.items()},
    "guide": guide,
    "guide, narrow": lambda: guide(0.9e-3, 2e-3),
    "guide, held in front": lambda: guide(120e-3, -1e-3),
    "guide, real": lambda: reference_guides().plot(),
}
# one of each kind, the longest texts and the most curves
DAILY = ("decay, usual", "layers, twelve rows", "guide, narrow")
pictured = pytest.mark.parametrize("name", daily(PICTURES, *DAILY))


@pytest.fixture(scope="module")
def drawn() -> Drawn:
    return Drawn(PICTURES)


@pictured
def test_no_text_lies_on_another_or_leaves_the_picture(drawn, name):
    assert_readable(drawn[name])


@pictured
def test_axes_name_what_they_show_with_its_unit(drawn, name):
    panels = drawn[name].axes
    for axes in panels:
        assert axes.get_xlabel() or axes is not panels[-1]
        assert axes.get_ylabel() or axes is not panels[0]
        for label in {axes.get_xlabel(), axes.get_ylabel()} - {"", "rows"}:
            unit = label[label.rindex("(") + 1 : label.rindex(")")]
            assert unit in {"kHz", "dB", "dB per row", "mm", "dimensionless"}, label


@pytest.mark.parametrize("name", ["decay, usual", "layers, twelve rows", "guide"])
def test_type_and_panels_are_large_enough_to_read(drawn, name):
    figure = drawn[name]
    shrink = min(1.0, 12 / 2.54 / figure.get_figwidth())
    FigureCanvasAgg(figure).draw()
    for axes in figure.axes:
        sizes = [axes.xaxis.label.get_fontsize(), *(t.get_fontsize() for t in axes.get_xticklabels())]
        sizes += [text.get_fontsize() for legend in figure.legends for text in legend.get_texts()]
        assert min(sizes) * shrink > 6.5
        box = axes.get_position()
        assert box.width * figure.get_figwidth() * 2.54 > 1.5, "cm"
        assert box.height * figure.get_figheight() * 2.54 > 1.5, "cm"


@pictured
def test_gap_and_carrier_are_named_above_the_axes_where_they_are_in_view(drawn, name):
    written = [text for text, _ in shown_texts(drawn[name])]
    assert any("complete gap 50.0 to 60.0 kHz" in text for text in written) == bool(
        artists(drawn[name], "gap")
    )
    assert ("carrier 58 kHz" in written) == bool(artists(drawn[name], "carrier"))


@pytest.mark.parametrize("kind", ["decay", "layers"])
def test_gap_and_carrier_are_marked_where_they_are_in_every_panel(drawn, kind):
    figure = drawn[f"{kind}, usual"]
    gaps, carriers = artists(figure, "gap"), artists(figure, "carrier")
    assert len(gaps) == {"decay": 2, "layers": 3}[kind]
    for gap, carrier in zip(gaps, carriers, strict=True):
        assert gap.axes is carrier.axes
        assert (gap.get_x(), gap.get_x() + gap.get_width()) == pytest.approx((50.0, 60.0))
        assert set(carrier.get_xdata()) == {58.0}


@pytest.mark.parametrize("kind", ["decay", "layers"])
def test_no_gap_is_marked_where_there_is_none_or_where_it_is_not_in_view(drawn, kind):
    assert not artists(drawn[f"{kind}, no gap"], "gap")
    assert artists(drawn[f"{kind}, no gap"], "carrier")
    assert not artists(drawn[f"{kind}, elsewhere"], "gap")
    assert not artists(drawn[f"{kind}, elsewhere"], "carrier")


class TestDecay:
    def test_waves_that_propagate_are_below_and_evanescent_ones_above(self, drawn):
        depth, phases = drawn["decay, usual"].axes
        (moving,) = artists(drawn["decay, usual"], "propagating")
        assert moving.axes is phases
        places = moving.get_xdata()
        assert len(places) == 15  # of 21 frequencies, six lie in the gap
        assert not ((places >= 50) & (places <= 60)).any()
        (others,) = artists(drawn["decay, usual"], "others")
        assert others.axes is depth
        decibels = {round(float(10 * np.log10(np.exp(2 * depth))), 9) for depth in (0.5, 2.0)}
        assert {round(float(level), 9) for level in others.get_ydata()} <= decibels

    def test_normal_incidence_is_a_curve_and_all_directions_a_band(self, drawn):
        data = simulated_mirror()
        (curve,) = artists(drawn["decay, usual"], "normal")
        assert curve.get_xdata() == pytest.approx(data["frequency"].values / 1e3)
        assert curve.get_ydata() == pytest.approx(data["attenuation"].values[:, 0])
        (band,) = artists(drawn["decay, usual"], "range")
        reached = band.get_paths()[0].get_extents()
        assert (reached.y0, reached.y1) == pytest.approx((0, 20))  # 4 dB times 1 to 5

    def test_the_decay_at_the_carrier_is_a_number(self, drawn):
        (point,) = artists(drawn["decay, usual"], "number")
        assert (float(point.get_xdata()[0]), float(point.get_ydata()[0])) == pytest.approx((58.0, 4.0))
        assert "4.0 dB per row" in [text for text, _ in shown_texts(drawn["decay, usual"])]
        assert not artists(drawn["decay, elsewhere"], "number")

    def test_the_decay_at_the_carrier_has_its_error(self):
        data = simulated_mirror(carrier_attenuation_error_db=0.165)
        assert "4.00 ± 0.17 dB per row" in [text for text, _ in shown_texts(plots.decay(data))]

    def test_a_spectrum_in_which_nothing_decays_is_drawn(self):
        data = simulated_mirror()
        data["attenuation"][:] = 0.0
        assert plots.decay(data).axes[0].get_ylim()[1] >= 1.0


class TestLayers:
    def test_a_panel_for_each_wave_that_comes(self, drawn):
        named = ("usual", "two waves", "one wave")
        labels = {name: [a.get_ylabel() for a in drawn[f"layers, {name}"].axes[::2]] for name in named}
        assert labels["usual"] == [f"{family} (dB)" for family in ("A0", "S0", "SH0")]
        assert labels["two waves"] == [f"{family} (dB)" for family in ("A0", "SH0")]
        assert labels["one wave"] == ["SH0: transmitted (dB)"]

    @pytest.mark.parametrize(("name", "rows"), [("one row", 1), ("usual", 6), ("twelve rows", 12)])
    def test_a_curve_for_each_number_of_rows(self, drawn, name, rows):
        """All kinds of transmitted waves together: the n-th kind decays by 5 n dB per row within the gap."""
        figure = drawn[f"layers, {name}"]
        for number, (axes, beside) in enumerate(zip(figure.axes[::2], figure.axes[1::2], strict=True)):
            curves = [line for line in axes.lines if line.get_gid() == "rows"]
            assert len(curves) == rows
            points = [line for line in beside.lines if line.get_gid() == "at carrier"]
            assert [point.get_color() for point in points] == [line.get_color() for line in curves]
            for k, (line, point) in enumerate(zip(curves, points, strict=True)):
                inside = (line.get_xdata() > 49) & (line.get_xdata() < 61)
                level = -5.0 * (number + 1) * (k + 1)
                assert line.get_ydata()[inside] == pytest.approx(np.full(6, level))
                assert line.get_ydata()[~inside] == pytest.approx(np.zeros(15), abs=1e-9)
                place = float(point.get_xdata()[0]), float(point.get_ydata()[0])
                assert place == pytest.approx((k + 1, level))

    def test_every_curve_has_contrast_with_the_paper(self, drawn):
        for line in drawn["layers, twelve rows"].axes[0].lines[:12]:
            rgb = np.array(mpl.colors.to_rgb(line.get_color()))
            light = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
            assert 1.05 / (light @ [0.2126, 0.7152, 0.0722] + 0.05) > 2.0

    def test_curves_are_in_view_down_to_the_floor(self, drawn):
        for axes in drawn["layers, usual"].axes[::2]:
            lowest = min(line.get_ydata().min() for line in axes.lines if line.get_gid() == "rows")
            assert axes.get_ylim()[0] == pytest.approx(max(lowest, -100.0), abs=10.0)
            assert axes.get_ylim()[0] <= max(lowest, -100.0)
        assert drawn["layers, twelve rows"].axes[4].get_ylim()[0] == pytest.approx(-106.0)

    def test_curves_that_go_on_below_the_axis_are_marked_and_others_are_not(self, drawn):
        figure = drawn["layers, twelve rows"]
        marks = [mark for mark in artists(figure, "cut") if mark.axes is figure.axes[4]]
        curves = [line for line in figure.axes[4].lines if line.get_gid() == "rows"]
        below = [line for line in curves if line.get_ydata().min() < figure.axes[4].get_ylim()[0]]
        assert len(below) == 5  # rows 8 to 12 of SH0, -120 to -180 dB
        assert [mark.get_color() for mark in marks] == [line.get_color() for line in below]
        others = [mark.axes for mark in artists(figure, "cut") if mark not in marks]
        assert others == [figure.axes[2]] * 2  # rows 11 and 12 of S0, -110 and -120 dB
        assert all(50 <= mark.get_xdata()[0] <= 60 for mark in marks)
        (legend,) = figure.legends
        assert [text.get_text() for text in legend.get_texts()] == ["the curve goes on below the axis"]
        assert not artists(drawn["layers, usual"], "cut")
        assert not drawn["layers, usual"].legends

    def test_rows_that_transmit_everything_are_drawn(self):
        data = simulated_mirror()
        data["transmitted"][:] = 0.25
        low, high = plots.layers(data).axes[0].get_ylim()
        assert low <= -10
        assert high > 0

    def test_the_angle_is_named(self, drawn):
        assert drawn["layers, usual"].get_supylabel() == "transmitted, normal incidence"
        assert "incident at 28.6° from the normal" in drawn["layers, oblique"].get_supylabel()
        assert drawn["layers, one wave"].get_supylabel() == "normal incidence"

    def test_the_direction_of_the_rows_is_named_unless_it_is_the_usual_one(self):
        other = plots.layers(simulated_mirror(along=np.array([1, -1])))
        assert other.get_supylabel().startswith("transmitted, rows along [1, -1], normal incidence")


class TestGuide:
    def test_the_mode_ends_where_the_lattice_begins(self, drawn):
        (axes,) = drawn["guide"].axes
        (curve,) = (line for line in axes.lines if "amplitude" in line.get_label())
        assert (curve.get_xdata().min(), curve.get_xdata().max()) == pytest.approx((-16.0, 16.0))
        sides = sorted(sorted((p.get_x(), p.get_x() + p.get_width())) for p in axes.patches)
        assert (sides[0][1], sides[1][0]) == pytest.approx((-16.0, 16.0))
        assert axes.get_ylim()[0] == 0.0

    @pytest.mark.parametrize(
        ("name", "line"), [("guide", 17.0), ("guide, narrow", 2.45), ("guide, held in front", 59.0)]
    )
    def test_the_fixed_lines_are_where_they_are_and_in_view(self, drawn, name, line):
        (axes,) = drawn[name].axes
        places = sorted(artist.get_xdata()[0] for artist in axes.lines if len(artist.get_xdata()) == 2)
        assert places == pytest.approx([-line, line])
        low, high = axes.get_xlim()
        assert low < places[0]
        assert places[1] < high

    def test_the_curve_goes_on_into_the_lattices_if_their_motion_is_known(self):
        position = np.linspace(-16e-3, 16e-3, 101)
        beyond = np.linspace(-44e-3, 44e-3, 177)
        falling = 0.1 * np.exp(-(np.abs(beyond) - 16e-3) / 4e-3)
        figure = plots.guide(
            position, np.cos(np.pi * position / 34e-3), 0.1, 32e-3, 1e-3, lattice=(beyond, falling),
            title="mode 0x17 at 56.90 kHz",
        )  # fmt: skip
        (axes,) = figure.axes
        left, right = artists(figure, "in the lattice")
        (between,) = (line for line in axes.lines if "amplitude" in line.get_label())
        assert (left.get_xdata()[-1], right.get_xdata()[0]) == pytest.approx((-16.0, 16.0))
        assert right.get_ydata()[0] == between.get_ydata()[-1]
        assert right.get_xdata()[1:] == pytest.approx(1e3 * beyond[beyond > 16e-3])
        assert right.get_ydata()[1:] == pytest.approx(falling[beyond > 16e-3])
        assert left.get_ydata() == pytest.approx(right.get_ydata()[::-1])
        at_end = np.interp(axes.get_xlim()[1], right.get_xdata(), right.get_ydata())
        assert at_end < 0.01
        assert axes.get_title() == "mode 0x17 at 56.90 kHz"
        assert_readable(figure)

    def test_the_picture_of_a_result_has_the_motion_that_was_computed(self):
        guides = reference_guides()
        half, grid = 0.5 * guides.best.mode.width, ("waveguide", "across", "along")
        across = np.linspace(-2 * half, 2 * half, 81)
        field = np.outer(1.0 / (1.0 + (across / half) ** 2), [1.0, 0.0])
        shape = (len(guides.strips), 1, 1)
        data = guides.dataset.assign(
            mode_real=(grid, np.tile(0.6 * field, shape)), mode_imag=(grid, np.tile(0.8 * field, shape)),
            across=("across", across),
        )  # fmt: skip
        (_, right) = artists(dataclasses.replace(guides, dataset=data).plot(), "in the lattice")
        assert len(right.get_xdata()) > 2
        assert right.get_ydata()[-1] == pytest.approx(0.2)  # at twice the half width
        assert not artists(guides.plot(), "in the lattice")

    def test_the_picture_of_a_result_names_its_mode_and_frequency(self, drawn):
        assert drawn["guide, real"].axes[0].get_title().startswith("mode 0x")
        assert drawn["guide, real"].axes[0].get_title().endswith("kHz")

    def test_the_legend_names_each_thing_once(self, drawn):
        (legend,) = drawn["guide"].legends
        written = [text.get_text() for text in legend.get_texts()]
        assert sorted(written) == ["amplitude of the mode", "equivalent fixed line", "lattice"]
