"""Two sets of bands drawn over each other."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from haptonic.arrays import Array
from haptonic.plots import style
from haptonic.plots.looks import colours
from haptonic.plots.stage import Stage, stage
from haptonic.plots.text import label

Bands = tuple[str, Array, Array, Sequence[tuple[float, float]]]

COLOURS = (style.BLUE, style.ORANGE)
DASHES = (style.SOLID, style.DASHED)
HATCHES = ("///", "\\\\\\")
CROSS = 3.5  # points
RIGID = 0.02  # of the highest frequency, below which a share of the frequency has no meaning


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
    on, residual = _with_residual(ax)
    axes = on.axes
    tints = colours(COLOURS)
    handles = []
    for number, (name, position, frequency, gaps) in enumerate(sides):
        colour, dashes = tints[number], DASHES[number]
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
    along = ", all sides of the zone equally long"
    axes.set_ylabel("frequency (kHz)")
    if residual is None:
        axes.set_xlabel("wavevector")
    else:
        _draw_residual(residual, sides, tints[1])
        residual.set_xlabel("wavevector" + along)
        for corner in list(corners)[1:-1]:
            residual.axvline(corner, color=style.PALE_INK, lw=0.6, zorder=1)
    on.legend(handles, ncols=2)
    return on.figure


def _with_residual(ax: Axes | None) -> tuple[Stage, Axes | None]:
    """Axes of the bands, and below them those of the differences, in a figure of our own."""
    if ax is not None:
        return stage(ax, 0.0), None
    bands, residual = style.blank(13.0).subplots(2, 1, sharex=True, height_ratios=(3, 1))
    return Stage(bands, own=True), residual


def _draw_residual(axes: Axes, sides: Sequence[Bands], colour: str) -> None:
    """The second side less the first, in percent, at the wavevectors of the second."""
    (_, first, ours, _), (_, second, theirs, _) = sides
    count = min(ours.shape[1], theirs.shape[1])
    here = np.stack([np.interp(second, first, ours[:, band]) for band in range(count)], axis=1)
    moving = here > RIGID * np.nanmax(here)
    off = 100 * np.where(moving, theirs[:, :count] / np.where(moving, here, 1.0) - 1, np.nan)
    axes.axhline(0, color=style.INK, lw=0.7, zorder=1)
    axes.plot(second, off, ".", ms=2.5, color=colour, gid="residual", clip_on=True)
    axes.set_ylabel("difference (%)")
