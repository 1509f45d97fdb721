"""Pictures of a search, of its front and of tolerances: what is drawn where, and that it can be read."""

from __future__ import annotations

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from seeing import Drawn, assert_readable

from daily import daily
from haptonic import plots
from haptonic.design.parameters import UNITS
from haptonic.plots import style
from simulated import simulated_front, simulated_search, simulated_tolerance

FOUR = ("cell.pillar.diameter", "cell.pillar.height", "material.youngs_modulus", "cell.thickness")


def nothing_held():
    data = simulated_front(3)
    data["margin"][:] = -0.01
    return data


PICTURES = {
    "search": lambda: plots.search(simulated_search(), UNITS),
    "search without a gap": lambda: plots.search(simulated_search(best=-0.02), UNITS),
    "search of one design": lambda: plots.search(simulated_search(1), UNITS),
    "long search": lambda: plots.search(simulated_search(60), UNITS),
    "front": lambda: plots.front(simulated_front()),
    "front of two pitches": lambda: plots.front(simulated_front(2)),
    "front of most pitches": lambda: plots.front(simulated_front(40)),
    "front that holds nothing": lambda: plots.front(nothing_held()),
    "tolerance": lambda: plots.tolerance(simulated_tolerance(FOUR)),
    "tolerance of one": lambda: plots.tolerance(simulated_tolerance(FOUR[:1], margin=0.0)),
    "tolerance of all": lambda: plots.tolerance(simulated_tolerance(tuple(UNITS))),
}


@pytest.fixture(scope="module")
def drawn():
    return Drawn(PICTURES)


def by_gid(figure: Figure, gid: str) -> list:
    return list(figure.findobj(lambda artist: artist.get_gid() == gid))


def in_legend(figure: Figure) -> list[str]:
    (legend,) = figure.legends
    return [text.get_text() for text in legend.get_texts()]


def bars(axes, colour: str) -> list[Rectangle]:
    return [
        p for p in axes.patches if isinstance(p, Rectangle) and to_hex(p.get_facecolor()) == colour.lower()
    ]


@pytest.mark.parametrize(
    "name", daily(PICTURES, "search", "front", "front that holds nothing", "tolerance of all")
)
class TestEveryPicture:
    def test_no_text_lies_on_another_or_leaves_the_picture(self, drawn, name):
        assert_readable(drawn[name])

    def test_the_legend_is_whole_and_has_no_empty_entry(self, drawn, name):
        figure = drawn[name]
        (legend,) = figure.legends
        FigureCanvasAgg(figure).draw()
        box, width = legend.get_window_extent(), figure.canvas.get_width_height()[0]
        assert box.x0 >= -1
        assert box.x1 <= width + 1
        labels = in_legend(figure)
        assert len(set(labels)) == len(labels)
        allowed = {style.GAP, "#ffffff", style.BLUE, style.ORANGE, style.CARRIER}  # not matplotlib's own blue
        for handle in legend.get_patches():
            assert to_hex(handle.get_facecolor()) in {colour.lower() for colour in allowed}

    def test_axes_name_what_they_show_with_its_unit(self, drawn, name):
        for axes in drawn[name].axes:
            for label in (axes.get_xlabel(), axes.get_ylabel()):
                if label and "plates" not in label:
                    assert label[label.rindex("(") + 1 : label.rindex(")")] in {"kHz", "mm", "%"}

    def test_the_carrier_is_drawn_where_it_is(self, drawn, name):
        if "search" in name:
            assert "margin of 60 kHz" in drawn[name].axes[-1].get_ylabel()
            return
        (line,) = by_gid(drawn[name], "carrier")
        places = line.get_xdata() if "tolerance" in name else line.get_ydata()
        assert set(places) == {60.0}
        assert line.is_dashed()
        assert "carrier 60 kHz" in in_legend(drawn[name])

    def test_type_is_readable_when_the_picture_is_12_cm_wide(self, drawn, name):
        figure = drawn[name]
        shrink = min(1.0, 12 / 2.54 / figure.get_figwidth())
        for axes in figure.axes:
            texts = [*axes.texts, axes.xaxis.label, axes.yaxis.label, *axes.get_xticklabels()]
            assert min(text.get_fontsize() for text in [*texts, *axes.get_yticklabels()]) * shrink > 6.3

    def test_everything_drawn_lies_inside_its_axes(self, drawn, name):
        for axes in drawn[name].axes:
            (low_x, high_x), (low, high) = (sorted(limits) for limits in (axes.get_xlim(), axes.get_ylim()))
            data = [bar for bar in axes.patches if bar.get_data_transform() == axes.transData]
            for bar in data:
                assert low_x - 1e-9 <= bar.get_x() <= bar.get_x() + bar.get_width() <= high_x + 1e-9
                assert low <= bar.get_y() <= bar.get_y() + bar.get_height() <= high
                assert bar.get_y() > low or "tolerance" in name  # only a histogram starts at the frame
            assert data or axes.get_ylabel() != "frequency (kHz)" or "holds" in name or "two" in name

    def test_it_is_written(self, drawn, name, tmp_path):
        svg, png = plots.save(drawn[name], tmp_path, "picture")
        assert png.read_bytes().startswith(b"\x89PNG")
        assert svg.stat().st_size < 1e6


class TestSearch:
    def test_sizes_are_against_each_other_with_the_margin_as_colour(self, drawn):
        data = simulated_search()
        height, diameter = 1e3 * data["value"].values.T
        for stage in ("look", "climb", "polish"):
            (points,) = by_gid(drawn["search"], stage)
            own = data["stage"].values == stage
            assert np.asarray(points.get_offsets()) == pytest.approx(
                np.stack([height, diameter], axis=1)[own]
            )
            assert np.asarray(points.get_array()) == pytest.approx(100 * data["margin"].values[own])
            assert points.norm.vmin == -points.norm.vmax
        axes = drawn["search"].axes[0]
        assert (axes.get_xlabel(), axes.get_ylabel()) == ("pillar height (mm)", "pillar diameter (mm)")

    def test_the_best_design_is_ringed(self, drawn):
        data = simulated_search()
        (ring,) = by_gid(drawn["search"], "best")
        place = 1e3 * data["value"].values[int(data["margin"].values.argmax())]
        assert np.ravel(ring.get_data()) == pytest.approx(place)
        assert "best, margin 6.0 %" in in_legend(drawn["search"])
        assert set(in_legend(drawn["search of one design"])) == {"starts", "best, margin -8.0 %"}

    def test_of_one_size_the_margin_is_the_height_and_of_many_each_has_a_panel(self):
        search = simulated_search().isel(parameter=[0])
        axes = plots.search(search, UNITS).axes[0]
        assert (axes.get_xlabel(), axes.get_ylabel()) == ("pillar height (mm)", "margin (%)")
        three = simulated_search().isel(parameter=[0, 1, 1])
        three = three.assign_coords(parameter=["cell.pillar.height", "cell.pillar.diameter", "cell.pitch"])
        assert len(plots.search(three, UNITS).axes) == 3  # two panels and the scale


class TestFront:
    def test_bars_span_the_gaps_that_hold_the_carrier(self, drawn):
        data = simulated_front()
        held = data["margin"].values > 0
        assert held.tolist() == [False, False, True, True, True, True]
        shown = bars(drawn["front"].axes[0], style.GAP)
        middles = [bar.get_x() + 0.5 * bar.get_width() for bar in shown]
        assert middles == pytest.approx(data["pitch"].values[held] * 1e3)
        ends = [(bar.get_y(), bar.get_y() + bar.get_height()) for bar in shown]
        wanted = np.stack([data["lower"].values, data["upper"].values], axis=1)[held] / 1e3
        assert np.array(ends) == pytest.approx(wanted)

    def test_widths_are_printed_above_the_bars(self, drawn):
        data = simulated_front().isel(design=slice(2, None))
        texts = drawn["front"].axes[0].texts
        for text, upper, lower in zip(texts[::-1], data["upper"].values, data["lower"].values, strict=True):
            assert text.xy[1] == pytest.approx(upper / 1e3)
            assert float(text.get_text()) == pytest.approx((upper - lower) / 1e3, abs=0.051)
        assert "best gap around it; its width in kHz" in in_legend(drawn["front"])

    def test_so_many_bars_have_widths_above_some_of_them(self, drawn):
        axes = drawn["front of most pitches"].axes[0]
        assert 5 <= len(axes.texts) <= 14
        assert len(bars(axes, style.GAP)) > 25
        widest = max(bar.get_height() for bar in bars(axes, style.GAP))
        assert float(axes.texts[0].get_text()) == pytest.approx(widest, abs=0.051)  # the last has its own

    def test_pitches_that_hold_nothing_are_crossed_out(self, drawn):
        (crosses,) = by_gid(drawn["front"], "none")
        assert crosses.get_xdata() == pytest.approx([4.0, 4.8])
        assert set(crosses.get_ydata()) == {60.0}
        assert "no allowed design has a gap there" in in_legend(drawn["front"])
        assert set(in_legend(drawn["front that holds nothing"])) == {
            "carrier 60 kHz", "no allowed design has a gap there",
        }  # fmt: skip
        all_held = plots.front(simulated_front().isel(design=slice(2, None)))
        assert not by_gid(all_held, "none")
        assert len(in_legend(all_held)) == 2


class TestTolerance:
    def test_the_histograms_hold_all_plates(self, drawn):
        data = simulated_tolerance(FOUR)
        for side, name in enumerate(("lower edge", "upper edge")):
            filled = [bar for bar in by_gid(drawn["tolerance"], name) if bar.get_height() > 0]
            assert sum(bar.get_height() for bar in filled) == data.sizes["plate"]
            edges = data["drawn"].values[:, side] / 1e3
            assert min(bar.get_x() for bar in filled) <= edges.min()
            assert max(bar.get_x() + bar.get_width() for bar in filled) >= edges.max() - 1e-9
            assert to_hex(filled[0].get_facecolor()) == (style.BLUE, style.ORANGE)[side].lower()

    def test_the_margin_is_shaded_if_there_is_one(self, drawn):
        (span,) = by_gid(drawn["tolerance"], "margin")
        assert (span.get_x(), span.get_x() + span.get_width()) == pytest.approx((59.5, 60.5))
        assert "margin 0.5 kHz" in in_legend(drawn["tolerance"])
        assert not by_gid(drawn["tolerance of one"], "margin")
        assert not any("margin" in label for label in in_legend(drawn["tolerance of one"]))

    @pytest.mark.parametrize(
        ("name", "paths"),
        [("tolerance", FOUR), ("tolerance of one", FOUR[:1]), ("tolerance of all", tuple(UNITS))],
    )
    def test_bars_and_diamonds_are_the_shares(self, drawn, name, paths):
        data, axes = simulated_tolerance(paths), drawn[name].axes[1]
        for side, colour in enumerate((style.BLUE, style.ORANGE)):
            lengths = [bar.get_width() for bar in bars(axes, colour)]
            assert lengths == pytest.approx(100 * data["total_index"].values[:, side])
            diamonds = axes.lines[side]
            assert diamonds.get_marker() == "D"
            assert diamonds.get_xdata() == pytest.approx(100 * data["first_order_share"].values[:, side])
            places = [bar.get_y() + 0.5 * bar.get_height() for bar in bars(axes, colour)]
            assert diamonds.get_ydata() == pytest.approx(places)
            assert not diamonds.get_clip_on()  # one at zero is seen as a whole
        assert "to first order" in in_legend(drawn[name])
        assert axes.get_xlim()[0] == 0
        low, high = axes.get_ylim()
        assert low > high  # the first on top

    def test_parameters_are_named_in_words(self, drawn):
        names = [label.get_text() for label in drawn["tolerance of all"].axes[1].get_yticklabels()]
        assert len(set(names)) == len(UNITS)
        assert {"Young's modulus", "Poisson ratio", "density", "pitch along y", "pillar step height"} < set(
            names
        )
        assert not any("." in name or "_" in name or "material" in name for name in names)
