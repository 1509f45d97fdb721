"""Gaps and drive frequencies, named beside the axes and not on the data."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import matplotlib as mpl
from matplotlib.axes import Axes

from haptonic.plots import style
from haptonic.plots.labels import label_right
from haptonic.plots.text import label
from haptonic.units import hz_text

Gap = tuple[float, float] | None

LINE = 1.3  # distance of two lines of text over its size
SIDE = 0.3  # of the width, within which a name is not centred on its place, so that it stays above the axes


def mark(
    axes: Axes, *gaps: Gap, carrier: float | None = None, along: Literal["x", "y"] = "x",
    name: str = "band gap", named: bool = True,
) -> None:  # fmt: skip
    """Shade gaps and dash the drive frequency, where they are in view; call it when the limits are set.

    Parameters
    ----------
    gaps, carrier : Hz; the axis is in kHz
    along : the axis of frequencies; names are above the axes, or to their right
    name : of each gap; named : whether to write names, once for several systems of axes
    """
    low, high = axes.get_xlim() if along == "x" else axes.get_ylim()
    names: list[tuple[float, str, str]] = []
    if carrier is not None and low <= carrier / 1e3 <= high:
        line = axes.axvline if along == "x" else axes.axhline
        line(carrier / 1e3, color=style.CARRIER, ls=style.DASHED, lw=1.1, gid="carrier", zorder=4)
        names.append((carrier / 1e3, f"carrier {hz_text(carrier, form='g')}", style.CARRIER))
    for gap in gaps:
        if gap is None or gap[0] / 1e3 >= high or gap[1] / 1e3 <= low:
            continue
        span = axes.axvspan if along == "x" else axes.axhspan
        ends = gap[0] / 1e3, gap[1] / 1e3
        span(*ends, facecolor=style.GAP, edgecolor="none", zorder=0, gid="gap")
        middle = 0.5 * (max(ends[0], low) + min(ends[1], high))
        between = " " if along == "x" else "\n"
        names.append((middle, f"{name}{between}{hz_text(*gap, form='.1f')}", style.GAP_EDGE))
    if not named:
        return
    if along == "x":
        above(axes, names)
    else:
        label_right(axes, names)


def above(axes: Axes, names: Sequence[tuple[float, str, str]], first: int = 0) -> None:
    """Write (place along x, text, colour) above the axes, each on its own line from ``first`` upwards."""
    low, high = axes.get_xlim()
    size = mpl.rcParams["font.size"]
    for number, (place, text, colour) in enumerate(names, start=first):
        share = (place - low) / (high - low)
        side = "left" if share < SIDE else "right" if share > 1 - SIDE else "center"
        axes.annotate(
            label(text), (place, 1.0), xycoords=("data", "axes fraction"),
            xytext=(0, 0.3 * size + LINE * size * number), textcoords="offset points", color=colour,
            ha=side, va="bottom", annotation_clip=False, gid="name above",
        )  # fmt: skip


def span_on_top(axes: Axes, low: tuple[float, float], high: tuple[float, float], colour: str) -> None:
    """Draw a range (kHz) as a bar on the upper edge of the axes; each end with its error, a thinner bar."""
    look = {
        "transform": axes.get_xaxis_transform(),
        "color": colour,
        "clip_on": False,
        "solid_capstyle": "butt",
    }
    axes.plot([low[0], high[0]], [1, 1], lw=4, zorder=5, gid="range", **look)  # type: ignore[arg-type]
    for end, error in (low, high):
        axes.plot([end - error, end + error], [1, 1], lw=1.6, zorder=6, gid="error", **look)  # type: ignore[arg-type]
