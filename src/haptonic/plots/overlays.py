"""Bands of two over each other."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from haptonic.arrays import Array
from haptonic.plots import style
from haptonic.plots.stage import stage
from haptonic.plots.text import label

Bands = tuple[str, Array, Array, Sequence[tuple[float, float]]]

COLOURS = (style.BLUE, style.ORANGE)
DASHES = (style.SOLID, style.DASHED)
HATCHES = ("///", "\\\\\\")
CROSS = 3.5  # points


@style.drawn
def compared(
    sides: Sequence[Bands], labels: Sequence[str], *, crosses: bool = False, ax: Axes | None = None
) -> Figure:
    """Two sets of bands along one path, the second dashed or as crosses; their complete gaps hatched.

    Parameters
    ----------
    sides : for each its name, (wavevector,) positions on the path, (wavevector, band) frequencies, Hz, and
        the edges of its complete gaps, Hz
    labels : of the corners of the path, which positions count from 0
    crosses : whether the second is drawn at its wavevectors only
    """
    on = stage(ax, 11.5)
    axes = on.axes
    handles = []
    for number, (name, position, frequency, gaps) in enumerate(sides):
        colour, dashes = COLOURS[number], DASHES[number]
        points = crosses and number == 1
        strokes = axes.plot(
            position,
            frequency / 1e3,
            color=colour,
            ls="none" if points else dashes,
            lw=1.3,
            marker="x" if points else "",
            ms=CROSS,
            zorder=3 + number,
            gid=f"bands {number + 1}",
        )
        strokes[0].set_label(label(name))
        handles.append(strokes[0])
        for lower, upper in gaps:
            axes.axhspan(
                lower / 1e3,
                upper / 1e3,
                facecolor="none",
                edgecolor=colour,
                alpha=0.6,
                hatch=HATCHES[number],
                lw=0.0,
                zorder=number,
                gid=f"gap {number + 1}",
            )
    corners = range(len(labels))
    for corner in list(corners)[1:-1]:
        axes.axvline(corner, color=style.PALE_INK, lw=0.6, zorder=1)
    axes.set_xticks(list(corners), labels)
    axes.set_xlim(0, len(labels) - 1)
    axes.set_ylim(0, 1.03 * max(float(np.nanmax(frequency)) for _, _, frequency, _ in sides) / 1e3)
    along = " along the edge of the irreducible zone; all sides are drawn equally long"
    axes.set_xlabel("wavevector" + along * on.own)
    axes.set_ylabel("frequency (kHz)")
    on.legend(handles, ncols=2)
    return on.figure
