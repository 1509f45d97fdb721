"""Pictures with one system of axes, drawn on axes of somebody else."""

from __future__ import annotations

import inspect
import json
import re
import warnings
from functools import partial
from itertools import combinations

import matplotlib as mpl
import numpy as np
import pytest
import test_designs
import test_mirror_pictures
import test_plate_pictures
import test_verdict_pictures
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.text import Text

from five_parts import refused
from haptonic import plots
from haptonic.results.bands import Bands
from haptonic.results.result import Result
from simulated import reference_bands, reference_guides, reference_layers, simulated_sweep

MODULES = (test_designs, test_mirror_pictures, test_plate_pictures, test_verdict_pictures)
SEVERAL = re.compile("decay|friction|tolerance|.*search|impedance|maps|before|no contrast|frac|guide, real")
PICTURES = {
    "dispersion": lambda: plots.dispersion(reference_bands(), carrier_hz=60e3),
    "density": lambda: plots.density_of_states(reference_bands()),
    "sweep": lambda: plots.sweep(simulated_sweep()),
    "map": lambda: plots.map_at(test_plate_pictures.vibration(), 58.8e3, None, None, drive=60.0),
} | {name: draw for module in MODULES for name, draw in module.PICTURES.items() if not SEVERAL.match(name)}
ALONE = [name for name in plots.__all__ if "ax" in inspect.signature(getattr(plots, name)).parameters]
ALONE.remove("checked")


def on(axes: Axes, draw, monkeypatch) -> Figure:
    """Draw as always, but on these axes."""
    with monkeypatch.context() as patch:
        for name in ALONE:
            patch.setattr(plots, name, partial(getattr(plots, name), ax=axes))
        return draw()


def drawn_in(axes: Axes) -> list[str]:
    return [str(artist) for artist in axes.get_children()]


@pytest.mark.parametrize("name", PICTURES)
def test_a_picture_keeps_to_its_axes_and_to_their_style(name, monkeypatch):
    with mpl.rc_context({"axes.labelsize": 13, "axes.edgecolor": "#123456"}):
        figure = Figure(layout="constrained")
        given, other = figure.subplots(1, 2)
        before = drawn_in(other)
        assert on(given, PICTURES[name], monkeypatch) is figure
        figure.canvas.draw()
    assert drawn_in(other) == before
    assert not figure.legends
    assert given.get_xlabel()
    assert given.xaxis.label.get_fontsize() == 13
    assert to_hex(given.spines["left"].get_edgecolor()) == "#123456"


def test_what_is_drawn_is_the_same(monkeypatch):
    own = plots.sweep(simulated_sweep()).axes[0]
    given = Figure().add_subplot()
    on(given, PICTURES["sweep"], monkeypatch)
    for ours, theirs in zip(own.lines, given.lines, strict=True):
        assert np.array_equal(ours.get_xydata(), theirs.get_xydata(), equal_nan=True)
    labels = [text.get_text() for text in given.get_legend().get_texts()]
    assert labels == [text.get_text() for text in own.get_figure().legends[0].get_texts()]


def test_results_give_back_the_axes():
    left, right = Figure().subplots(1, 2)
    bands = Bands(reference_bands())
    assert bands.plot(ax=left) is left
    assert bands.plot("density_of_states", ax=right) is right
    assert "states" in right.get_ylabel()
    axes = Figure().add_subplot()
    assert reference_guides().plot(ax=axes) is axes
    assert reference_layers().plot("layers", ax=axes, incident="S0") is axes
    assert axes.get_ylabel().startswith("S0")


def test_one_wave_of_several_can_be_asked_for():
    assert [axes.get_ylabel()[:3] for axes in reference_layers().plot(incident="SH0").axes[::2]] == ["SH0"]
    refused(lambda: reference_layers().plot(incident="SH1"), "SH0", code="unknown", argument="incident")


def test_names_with_dollars_and_lines_are_texts_on_anybody_s_axes():
    axes = Figure().add_subplot()
    plots.contrast_spectrum(np.arange(3.0), {"a $ over $ b_": np.zeros(3)}, [], ax=axes)
    axes.get_figure().canvas.draw()
    assert "a $ over $ b_" in [text.get_text() for text in axes.findobj(Text)]
    assert not axes.get_legend().get_texts()[0].get_parse_math()


@pytest.mark.parametrize("name", PICTURES)
def test_latex_reads_no_command_in_what_is_written(name, monkeypatch):
    """By the rule of TeX itself: no special character that is neither escaped nor part of a formula."""
    with mpl.rc_context({"text.usetex": True}):
        axes = Figure().add_subplot()
        axes.set_title("mine: $x$")
        on(axes, PICTURES[name], monkeypatch)
        figure = axes.get_figure()
        texts = [text.get_text() for part in figure.axes for text in part.findobj(Text)]
        for axis in (axes.xaxis, axes.yaxis):
            texts += [str(axis.get_major_formatter()(place, 0)) for place in axis.get_majorticklocs()]
    assert texts
    for text in texts:
        bare = re.sub(r"\\[%&_$#{}]|\\text[a-z]+\{\}|\$[^$]*\$", "", text)
        assert bare.isascii(), text
        assert not set(bare) & set("%&_$#{}\\^~<>|"), text


def removed() -> Axes:
    axes = Figure().add_subplot()
    axes.remove()
    return axes


NO_AXES = {
    "nothing but a word": ("ax", "something else"),
    "a number": (1, "something else"),
    "the result": (Bands, "something else"),
    "a figure": (Figure(), "a figure may contain many"),
    "an axis": (Figure().add_subplot().xaxis, "an axis is one edge"),
    "several axes": (Figure().subplots(1, 2), "several axes"),
    "a list of axes": (list(Figure().subplots(1, 2)), "several axes"),
    "axes in space": (Figure().add_subplot(projection="3d"), "other directions"),
    "axes around a pole": (Figure().add_subplot(projection="polar"), "other directions"),
    "axes that were removed": (removed(), "removed"),
}


@pytest.mark.parametrize("what", NO_AXES)
@pytest.mark.parametrize("picture", ["dispersion", "modes"])
def test_an_axis_that_is_no_axis(what, picture):
    given, cause = NO_AXES[what]
    asked = [lambda: Bands(reference_bands()).plot(picture, ax=given)]
    asked += [lambda: plots.dispersion(reference_bands(), ax=given)]
    for call in asked:
        refused(call, cause, code="malformed", argument="ax")


@pytest.mark.parametrize(
    ("asked", "code", "argument", "words"),
    [
        (("modes", {"ax": Figure().add_subplot()}), "unsupported", "ax", "dispersion, natures, density"),
        (("dispersion", {"frequency": 1.0}), "unsupported", "frequency", "gaps, labels, label, wavevectors"),
        (("dispersions", {}), "unknown", "name of the picture", 'write "dispersion"'),
    ],
)
def test_what_a_picture_cannot_be_asked_for(asked, code, argument, words):
    name, how = asked
    refused(lambda: Bands(reference_bands()).plot(name, **how), words, code=code, argument=argument)


def test_bands_of_another_pitch_share_the_corners_of_the_first():
    first = reference_bands()
    second = first.assign(distance=first["distance"] * 0.8)
    axes = Figure(layout="constrained").add_subplot()
    Bands(first).plot(ax=axes, label="first")
    limits, corners = axes.get_xlim(), list(axes.get_xticks())
    Bands(second).plot(ax=axes, label="second", color="#cc0000")
    assert axes.get_xlim() == limits
    assert list(axes.get_xticks()) == corners
    ends = {line.get_xdata()[-1] for line in axes.lines if str(line.get_gid()).startswith("branch")}
    assert ends == {first["distance"].values[-1]}
    assert [text.get_text() for text in axes.get_legend().get_texts()][:2] == ["first", "second"]
    gaps = [patch for patch in axes.patches if patch.get_gid() == "gap"]
    assert len({to_hex(gap.get_edgecolor()) for gap in gaps}) == 2, "gaps of two designs look alike"
    assert [gap.get_fill() and gap.get_facecolor()[3] > 0 for gap in gaps] == [True, False]
    assert gaps[1].get_hatch()
    assert len([line for line in axes.lines if line.get_gid() == "carrier"]) <= 1


def test_bands_on_a_logarithmic_axis_keep_its_powers():
    axes = Figure(layout="constrained").add_subplot()
    axes.set_yscale("log")
    Bands(reference_bands()).plot(ax=axes)
    axes.get_figure().draw_without_rendering()
    assert 0 < axes.get_ylim()[0] < axes.get_ylim()[1]
    powers = [label for label in axes.get_yticklabels() if "$" in label.get_text()]
    assert powers
    assert all(label.get_parse_math() for label in powers)


def test_bands_without_gaps():
    figure = Bands(reference_bands()).plot(gaps=False, label="a $ b")
    axes = figure.axes[0]
    assert not [patch for patch in axes.patches if str(patch.get_gid()).startswith("gap")]
    assert not [text for text in axes.texts if "gap" in text.get_text()]
    assert [text.get_text() for text in figure.legends[0].get_texts()] == ["a $ b"]


def test_bands_along_another_path_are_not_drawn_over():
    axes = Figure().add_subplot()
    bands = reference_bands()
    Bands(bands).plot(ax=axes)
    labels = [*json.loads(bands.attrs["path_labels"])[:-2], "K", "Γ"]
    other = Bands(bands.assign_attrs(path_labels=json.dumps(labels)))
    refused(lambda: other.plot(ax=axes), "K-Γ", code="conflict", argument="ax")


def scaled(bands, factor: float):
    """Bands of a design whose frequencies are all higher."""
    names = [name for name in bands if str(name).startswith(("frequency", "gap_lower", "gap_upper"))]
    plain = [name for name in names if "kappa" not in name]
    speed = {"group_velocity": factor * bands["group_velocity"]}
    return bands.assign({name: factor * bands[name] for name in plain} | speed)


def assert_within(axes: Axes) -> None:
    """The legend lies in its axes, above all gaps, and no text lies on another or leaves the figure."""
    figure = axes.get_figure()
    renderer = figure.canvas.get_renderer()
    legend = axes.get_legend()
    box, frame = legend.get_window_extent(renderer), axes.get_window_extent(renderer)
    assert box.x0 >= frame.x0 - 1
    assert box.x1 <= frame.x1 + 1
    assert box.y1 <= frame.y1 + 1
    edges = [patch.get_y() + patch.get_height() for patch in axes.patches if patch.get_gid() == "gap"]
    assert box.y0 > axes.transData.transform((0, max(edges)))[1]
    boxes = [Text.get_window_extent(text, renderer) for text in axes.texts]  # without leaders
    for first, second in combinations([box, *boxes], 2):
        assert not first.overlaps(second)
    for text in boxes:
        assert text.x0 >= frame.x0
        assert text.x1 <= figure.bbox.x1


@pytest.mark.parametrize("panels", [1, 2])
@pytest.mark.parametrize("carrier", [None, 57e3])
def test_two_designs_can_be_read_in_a_column_and_in_half_of_one(panels, carrier):
    bands = reference_bands()
    with mpl.rc_context({"font.size": 7}):
        figure = Figure(figsize=(85 / 25.4, 65 / 25.4), layout="constrained")
        FigureCanvasAgg(figure)
        for axes in np.ravel(figure.subplots(1, panels)):
            plots.dispersion(bands, carrier, label="50 µm epoxy", ax=axes)
            plots.dispersion(scaled(bands, 1.3), carrier, label="ideal joint", ax=axes)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            figure.canvas.draw()
        for axes in figure.axes:
            assert_within(axes)
            assert axes.get_window_extent().width > 0.25 * figure.bbox.width
            texts = [text.get_text() for text in axes.texts]
            assert len(set(texts)) == len(texts)
            if panels == 1:
                assert len([text for text in texts if text.endswith("kHz")]) == 2 + (carrier is not None)


@pytest.mark.parametrize("layout", [None, "constrained"])
def test_names_are_beside_axes_only_if_the_figure_makes_room(layout):
    axes = Figure(layout=layout).add_subplot()
    narrow = reference_bands()
    narrow["gap_lower"] = narrow["gap_upper"] - 500.0
    plots.dispersion(narrow, ax=axes)
    names = [text.get_text() for text in axes.texts]
    assert names == (["59.72\N{EN DASH}60.22 kHz"] if layout else [])


def test_the_axis_of_frequencies_covers_every_design():
    axes = Figure().add_subplot()
    bands = reference_bands()
    plots.dispersion(bands, ax=axes)
    alone = axes.get_ylim()[1]
    assert alone == pytest.approx(plots.shown_up_to(bands, None) / 1e3)
    for label in ("a", "b", "c"):
        plots.dispersion(scaled(bands, 1.5), label=label, ax=axes)
        assert alone * 1.5 < axes.get_ylim()[1] < alone * 1.5 * 1.35


def test_names_can_be_left_out_and_the_shades_stay():
    bands, own = Bands(reference_bands()), Figure().add_subplot()
    pages = [bands.plot(name, labels=False).axes[0] for name in ("dispersion", "natures")]
    for axes in (*pages, bands.plot(labels=False, ax=own)):
        assert [patch for patch in axes.patches if patch.get_gid() == "gap"]
        assert not axes.texts


def test_the_help_names_every_option_of_every_picture():
    words = inspect.getdoc(Result.plot)
    options = {
        name
        for kind in kinds(Result)
        for picture in kind._pictures
        for name in inspect.signature(picture.make).parameters
    }
    assert {"gaps", "labels", "incident"} < options
    for option in options - {"self", "result", "scan"}:
        assert re.search(rf"\b{option}\b", words), option


def kinds(base: type) -> list[type]:
    return [base, *(kind for below in base.__subclasses__() for kind in kinds(below))]
