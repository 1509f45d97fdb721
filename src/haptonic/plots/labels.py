"""Names to the right of the axes, moved apart."""

from __future__ import annotations

from collections.abc import Sequence

import matplotlib as mpl
from matplotlib.axes import Axes
from matplotlib.font_manager import FontProperties
from matplotlib.text import Annotation

LABEL_RIGHT = "label right"


def label_right(axes: Axes, labels: Sequence[tuple[float, str, str]]) -> None:
    """Write (height in data units, text, colour) to the right of the axes, moved apart where needed.

    Each leader ends at the left edge of its text, so it crosses no other text.
    """
    size = FontProperties(size=mpl.rcParams["legend.fontsize"]).get_size_in_points()
    for height, text, colour in labels:
        axes.annotate(
            text,
            xy=(1.0, height),
            xytext=(2 * size, height),
            xycoords=("axes fraction", "data"),
            textcoords=("offset points", "data"),
            va="center",
            ha="left",
            color=colour,
            fontsize=size,
            gid=LABEL_RIGHT,
            arrowprops={
                "arrowstyle": "-", "color": colour, "lw": 0.7, "shrinkA": 2, "shrinkB": 0, "relpos": (0, 0.5),
            },
            annotation_clip=False,
        )  # fmt: skip
    move_labels_apart(axes)


def move_labels_apart(axes: Axes) -> None:
    """Give the labels of `label_right` places for the present height of the axes."""
    labels = [text for text in axes.texts if isinstance(text, Annotation) and text.get_gid() == LABEL_RIGHT]
    figure = axes.get_figure(root=True)
    if not labels or figure is None:
        return
    (low, high), size = axes.get_ylim(), float(labels[0].get_fontsize())
    lines = max(label.get_text().count("\n") + 1 for label in labels)
    apart = 1.35 * lines * size / (72 * axes.bbox.height / figure.dpi) * (high - low)
    places = spread([label.xy[1] for label in labels], apart, low + 0.5 * apart, high - 0.5 * apart)
    for label, place in zip(labels, places, strict=True):
        label.set_position((label.get_position()[0], place))


def spread(places: Sequence[float], apart: float, low: float, high: float) -> list[float]:
    """Places moved as little as needed so that neighbours are ``apart`` and all lie in [low, high]."""
    order = sorted(range(len(places)), key=lambda i: places[i])
    apart = min(apart, (high - low) / max(len(places) - 1, 1))
    clusters: list[tuple[float, list[int]]] = []  # centre, members from below
    for i in order:
        centre, members = places[i], [i]
        while clusters:
            centre = min(max(centre, low + _half(members, apart)), high - _half(members, apart))
            below, others = clusters[-1]
            if centre - _half(members, apart) - (below + _half(others, apart)) >= apart * (1 - 1e-9):
                break
            clusters.pop()
            members = others + members
            first = sum(places[m] - apart * k for k, m in enumerate(members)) / len(members)
            centre = first + _half(members, apart)
        centre = min(max(centre, low + _half(members, apart)), high - _half(members, apart))
        clusters.append((centre, members))
    moved = list(places)
    for centre, members in clusters:
        for k, member in enumerate(members):
            moved[member] = centre - _half(members, apart) + apart * k
    return moved


def _half(members: Sequence[int], apart: float) -> float:
    return 0.5 * apart * (len(members) - 1)
