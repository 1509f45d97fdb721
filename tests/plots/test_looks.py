"""Every picture in the look of a column: 85 mm wide, type of 7 points, no text over text or over data."""

from __future__ import annotations

from itertools import chain

import pytest
import test_designs
import test_mirror_pictures
import test_plate_pictures
import test_verdict_pictures
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.text import Text
from seeing import assert_readable

from daily import daily
from five_parts import refused
from haptonic import plots
from haptonic.plots.looks import LOOKS
from haptonic.results.bands import Bands
from haptonic.results.result import Figures
from simulated import reference_bands, reference_layers, simulated_sweep

MODULES = (test_designs, test_mirror_pictures, test_plate_pictures, test_verdict_pictures)
VARIANTS = {
    "turned", "seven", "low", "notched", "two", "one", "twenty", "twelve", "without", "no", "nothing",
    "oblique", "elsewhere", "long", "narrow", "held", "real", "most", "all", "three",
}  # fmt: skip
PICTURES = {
    "dispersion": lambda: plots.dispersion(reference_bands(), carrier_hz=60e3),
    "natures": lambda: plots.dispersion(reference_bands(), carrier_hz=60e3, natures=True),
    "density": lambda: plots.density_of_states(reference_bands()),
    "iso": lambda: plots.iso_frequency(reference_bands()),
    "sweep": lambda: plots.sweep(simulated_sweep()),
} | {
    name: draw
    for name, draw in chain.from_iterable(module.PICTURES.items() for module in MODULES)
    if not VARIANTS & set(name.replace(",", "").split())
}
DAILY = ("dispersion", "layers, usual", "maps", "mac")
# of what they are written on
ON_DATA = {"region name", "name", "number in a cell", "width", "corner", "level"}


def in_look(style: str, name: str) -> Figure:
    with plots.chosen(style):
        return PICTURES[name]()


def texts_over_data(figure: Figure) -> list[str]:
    """Texts whose middle lies in a system of axes, and legends that reach into one."""
    FigureCanvasAgg(figure).draw()
    over = []
    for axes in figure.axes:
        if not axes.axison:
            continue
        box = axes.get_window_extent()
        for text in axes.texts:
            extent = text.get_window_extent()
            middle = 0.5 * (extent.x0 + extent.x1), 0.5 * (extent.y0 + extent.y1)
            if text.get_text() and text.get_gid() not in ON_DATA and box.contains(*middle):
                over.append(text.get_text())
        for legend in figure.legends:
            if legend.get_window_extent().overlaps(box):
                over += [text.get_text() for text in legend.get_texts()]
    return over


@pytest.mark.parametrize("name", daily(PICTURES, *DAILY))
def test_in_a_column_it_is_85_mm_wide_and_can_be_read(name):
    figure = in_look("column", name)
    assert figure.get_figwidth() * 25.4 <= 85.1 or "mac" in name
    assert_readable(figure)
    assert not texts_over_data(figure)
    sizes = {text.get_fontsize() for text in figure.findobj(Text) if text.get_text() and text.get_visible()}
    assert min(sizes) >= 6.5 or "mac" in name
    assert max(sizes) <= 7.0


def test_a_text_over_data_is_seen():
    figure = in_look("column", "contrast")
    figure.axes[0].text(0.5, 0.5, "here", transform=figure.axes[0].transAxes)
    assert texts_over_data(figure) == ["here"]
    figure = in_look("column", "contrast")
    figure.legend(figure.axes[0].lines[:1], ["there"], loc="center")
    assert texts_over_data(figure) == ["there"]


@pytest.mark.nightly
@pytest.mark.parametrize("style", [name for name in LOOKS if name != "column"])
@pytest.mark.parametrize("name", PICTURES)
def test_it_can_be_read_in_every_look(name, style):
    figure = in_look(style, name)
    assert_readable(figure)
    assert not texts_over_data(figure)


class TestChoices:
    def test_every_picture_has_a_style_and_legends_can_be_left_out(self):
        result = Bands(reference_bands())
        widths = [result.plot("natures", style=style).get_figwidth() * 25.4 for style in LOOKS]
        assert widths == pytest.approx([150, 85, 180, 240])
        assert result.plot("natures").legends
        assert not result.plot("natures", legend=False).legends
        assert not plots.looks.choice().colours
        assert plots.dispersion(reference_bands()).get_figwidth() * 25.4 == pytest.approx(150)

    def test_lines_are_as_heavy_as_the_type(self):
        result = Bands(reference_bands())
        page, slide = (
            next(line.get_linewidth() for line in result.plot("dispersion", style=style).axes[0].lines)
            for style in ("plain", "slide")
        )
        assert slide / page == pytest.approx(16 / 9)

    def test_colours_are_those_of_the_curves_in_their_order(self):
        layers = reference_layers()
        axes = layers.plot("layers", incident="A0", color=["red", "#00ff00"]).axes[0]
        curves = [line.get_color() for line in axes.lines if line.get_gid() == "rows"]
        usual = layers.plot("layers", incident="A0").axes[0]
        others = [line.get_color() for line in usual.lines if line.get_gid() == "rows"]
        assert curves == ["red", "#00ff00", *others[2:]]

    def test_three_numbers_are_one_colour(self):
        lines = Bands(reference_bands()).plot("dispersion", color=(0.1, 0.2, 0.3)).axes[0].lines
        assert (0.1, 0.2, 0.3) in {line.get_color() for line in lines}

    def test_frequencies_of_gaps_and_pictures_may_have_a_unit(self):
        (gap, *_) = Bands(reference_bands()).gaps
        assert gap.margin("60 kHz") == gap.margin(60e3)
        assert gap.holds("60 kHz") == gap.holds(60e3)
        refused(lambda: gap.margin("60 kN"), argument="frequency")
        figures = Figures({"maps": lambda frequency=None: frequency}, {})
        assert figures.drawn("maps", {"frequency": "60 kHz"}) == 60e3

    def test_a_result_without_pictures_is_explained(self):
        refused(lambda: Figures({}, {}).drawn(None, {}), "summary()", code="missing",
                argument="name of the picture")  # fmt: skip

    def test_on_axes_of_ones_own_legends_and_colours_hold_too(self):
        axes = Figure().add_subplot()
        reference_layers().plot("layers", ax=axes, legend=False, color="red")
        assert axes.get_legend() is None
        assert axes.lines[0].get_color() == "red"

    @pytest.mark.parametrize(
        ("asked", "code", "argument", "words"),
        [
            ({"style": "colum"}, "unknown", "style", 'write "column"'),
            ({"style": "column", "ax": Figure().add_subplot()}, "conflict", "style", "leave style out"),
            ({"color": "redd"}, "malformed", "color", "a colour of matplotlib"),
            ({"color": ["red", 7]}, "malformed", "color", "7"),
            ({"color": 7}, "malformed", "color", "7"),
            ({"name": "iso_frequency", "color": "red"}, "unsupported", "color", "leave color out"),
        ],
    )
    def test_what_cannot_be_chosen_is_refused(self, asked, code, argument, words):
        refused(lambda: Bands(reference_bands()).plot(**asked), words, code=code, argument=argument)

    def test_a_refused_picture_leaves_no_choice_behind(self):
        result = Bands(reference_bands())
        refused(lambda: result.plot("none", style="slide", color="red"), "none", code="unknown",
                argument="name of the picture")  # fmt: skip
        assert result.plot("dispersion").get_figwidth() * 25.4 == pytest.approx(150)
