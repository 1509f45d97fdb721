"""Names to the right of the axes."""

from __future__ import annotations

from itertools import permutations

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.text import Text
from seeing import artists

from haptonic.plots import style


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
        style.label_right(axes, [(height, text, style.INK) for height, text in names], lines=3)
        FigureCanvasAgg(figure).draw()
    labels = artists(figure, "label right")
    assert len(labels) == len(names)
    for text, other in permutations(labels, 2):
        leader = text.arrow_patch.get_path().transformed(text.arrow_patch.get_transform())
        assert not leader.intersects_bbox(Text.get_window_extent(other), filled=False), other.get_text()
