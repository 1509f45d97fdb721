"""Names to the right of the axes."""

from __future__ import annotations

from itertools import permutations

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.text import Text
from seeing import artists

from haptonic import plots
from haptonic.plots import style
from haptonic.plots.labels import label_right
from simulated import reference_bands


def test_no_leader_crosses_the_text_of_another_name():
    names = [
        (185.0, "complete gap\n181.7 ± 0.9\nto 188.8 ± 0.9 kHz"),
        (155.0, "complete gap\n144.4 ± 0.5\nto 165.3 ± 0.6 kHz"),
        (153.0, "gap of\nantisymmetric\nwaves"),
        (40.0, "carrier\n40 kHz"),
    ]
    with style.styled():
        figure = style.blank(11.5)
        axes = figure.subplots()
        axes.set_ylim(0, 188.8)
        label_right(axes, [(height, text, style.INK) for height, text in names])
        FigureCanvasAgg(figure).draw()
    labels = artists(figure, "label right")
    assert len(labels) == len(names)
    for text, other in permutations(labels, 2):
        leader = text.arrow_patch.get_path().transformed(text.arrow_patch.get_transform())
        assert not leader.intersects_bbox(Text.get_window_extent(other), filled=False), other.get_text()


def test_names_stay_apart_when_the_layout_makes_the_axes_lower():
    with style.styled():
        figure = style.blank(13)
        axes = figure.subplots()
        axes.set_ylim(0, 120)
        label_right(
            axes, [(45.9, "complete gap\n42.2\nto 49.5 kHz", style.INK), (46, "carrier\n46 kHz", style.INK)]
        )
        figure.suptitle("\n".join(["a long title"] * 15))
        style.arrange(figure)
        FigureCanvasAgg(figure).draw()
        first, second = (Text.get_window_extent(label) for label in artists(figure, "label right"))
    assert not first.overlaps(second)


def test_names_of_two_gaps_of_a_density_of_states_are_on_lines_of_their_own():
    bands = reference_bands()
    bands["gap_complete"][:2] = True
    with style.styled():
        figure = plots.density_of_states(bands)
        FigureCanvasAgg(figure).draw()
        names = [Text.get_window_extent(name) for name in artists(figure, "name above")]
    assert len(names) > 1
    assert not any(first.overlaps(second) for first, second in permutations(names, 2))
