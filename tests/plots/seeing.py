"""What can be seen in a figure, for tests of pictures."""

from __future__ import annotations

import io
from collections.abc import Callable, Mapping
from itertools import combinations

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

from haptonic.plots import rendered


class Drawn(dict[str, Figure]):
    """Pictures by name; each is drawn when a test first asks for it."""

    def __init__(self, makers: Mapping[str, Callable[[], Figure]]) -> None:
        super().__init__()
        self.makers = makers

    def __missing__(self, name: str) -> Figure:
        self[name] = self.makers[name]()
        return self[name]


def artists(figure: Figure, gid: str) -> list:
    return list(figure.findobj(lambda a: a.get_gid() == gid))


def shown_texts(figure: Figure) -> list:
    """(text, box in pixels) of everything that is written in a figure."""
    FigureCanvasAgg(figure).draw()
    artists = [text for legend in figure.legends for text in legend.get_texts()]
    for axes in figure.axes:
        artists += [*axes.texts]
        if not axes.axison:
            artists.append(axes.title)
            continue
        artists += [axes.title, axes.xaxis.label, axes.yaxis.label]
        for axis in (axes.xaxis, axes.yaxis):
            low, high = sorted(axis.get_view_interval())
            slack = 1e-9 * (high - low)
            for tick in axis.get_major_ticks():
                if low - slack <= tick.get_loc() <= high + slack:
                    artists += [tick.label1, tick.label2]
    seen = [text for text in artists if text.get_visible() and text.get_text().strip()]
    return [(text.get_text(), text.get_window_extent()) for text in seen]


def assert_readable(figure: Figure) -> None:
    """No text lies on another one or leaves the picture, neither here nor in what is written."""
    pixels = np.asarray(Image.open(io.BytesIO(rendered(figure, "png"))).convert("L"))
    assert (pixels[[0, -1]] == 255).all(), "something reaches the upper or lower border"
    assert (pixels[:, [0, -1]] == 255).all(), "something reaches the left or right border"
    texts = shown_texts(figure)
    assert len(texts) > 5
    width, height = figure.canvas.get_width_height()
    for text, box in texts:
        assert box.x0 >= -1, text
        assert box.y0 >= -1, text
        assert box.x1 <= width + 1, text
        assert box.y1 <= height + 1, text
    for (first, a), (second, b) in combinations(texts, 2):
        across = min(a.x1, b.x1) - max(a.x0, b.x0)
        up = min(a.y1, b.y1) - max(a.y0, b.y0)
        assert across < 1 or up < 1, (first, second)
