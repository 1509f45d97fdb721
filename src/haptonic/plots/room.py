"""Names and legends within axes of a user, where there is room by the size of their type.

The layout of the user's figure is made later, so texts are estimated and not measured.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

import matplotlib as mpl
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.font_manager import FontProperties

from haptonic.plots.labels import LABEL_RIGHT, label_right
from haptonic.plots.looks import choice
from haptonic.plots.marks import LINE
from haptonic.plots.plates import HALO
from haptonic.plots.text import LETTER

LABEL_WITHIN = "label within"
LEGEND = "legend with a share of the height of"
HANDLE = 5.0  # width of a handle with its distances to texts, over the size of the type
BESIDE = 0.4  # of the width of the axes, that a name to the right of them may have
ROOM = 0.5  # of the height of the axes, that a legend may have


def _points(axes: Axes) -> tuple[float, float, float]:
    """Width and height of axes and size of the type of names in them, points."""
    figure = axes.get_figure(root=True)
    assert figure is not None, "axes that belong to no figure"
    size = FontProperties(size=mpl.rcParams["legend.fontsize"]).get_size_in_points()
    return 72 * axes.bbox.width / figure.dpi, 72 * axes.bbox.height / figure.dpi, size


def name_within(axes: Axes, ranges: Sequence[tuple[float, float, str, str]]) -> None:
    """Write (low, high, text, colour) of ranges of heights in place of the names that the axes have.

    A name is in the highest free part of its range; a line, a range of no height, has the parts beside it.
    Without room there it is to the right of wide axes if their figure makes room, and is left out otherwise.
    """
    for earlier in [text for text in axes.texts if text.get_gid() in (LABEL_WITHIN, LABEL_RIGHT)]:
        earlier.remove()
    wide, tall, size = _points(axes)
    has_layout = axes.figure.get_layout_engine() is not None  # otherwise names are cut, or on other axes
    line = LINE * size * axes.get_ylim()[1] / tall
    spans = [(low, high) for low, high, _, _ in ranges]
    free = [
        (bottom, top)
        for bottom, top in pairwise(sorted({edge for span in spans for edge in span}))
        if top - bottom >= line and any(low <= bottom and top <= high for low, high in spans)
    ]
    right = []
    for low, high, text, colour in ranges:
        parts = [
            part for part in free if (low <= part[0] and part[1] <= high) or (low == high and low in part)
        ]
        width = LETTER * size * len(text)
        if parts and width <= wide:
            bottom, top = max(parts, key=lambda part: part[1] - part[0])
            free.remove((bottom, top))
            axes.text(
                0.5, 0.5 * (bottom + top), text, transform=axes.get_yaxis_transform(), color=colour,
                fontsize=size, ha="center", va="center", path_effects=HALO, gid=LABEL_WITHIN,
            )  # fmt: skip
        elif width <= BESIDE * wide and has_layout:
            right.append((0.5 * (low + high), text, colour))
    label_right(axes, right)


def legend_on_top(axes: Axes, handles: Sequence[Artist], clear: float) -> None:
    """Draw a legend that is not wider than the axes, in room above a height that it leaves clear."""
    if not handles or not choice().legend:
        return
    wide, tall, size = _points(axes)
    right = [len(text.get_text()) for text in axes.texts if text.get_gid() == LABEL_RIGHT]
    wide -= LETTER * size * max(right, default=0)
    longest = max(len(str(handle.get_label())) for handle in handles)
    columns = max(1, min(len(handles), int(wide / ((LETTER * longest + HANDLE) * size))))
    share = min((1.5 * math.ceil(len(handles) / columns) + 1.5) * size / tall, ROOM)
    axes.legend(handles=handles, loc="upper center", ncols=columns).set_gid(f"{LEGEND} {share}")
    axes.set_ylim(top=max(axes.get_ylim()[1], clear / (1 - share)))


def room_on_top(axes: Axes) -> float:
    """Share of the height of axes that the legend of `legend_on_top` has."""
    legend = axes.get_legend()
    gid = str(legend.get_gid()) if legend else ""
    return float(gid.removeprefix(LEGEND)) if gid.startswith(LEGEND) else 0.0
