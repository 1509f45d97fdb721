"""Axes for a picture with one system of axes: those of a new figure, or axes of a user."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from haptonic.errors import HaptonicError, shown
from haptonic.plots import style
from haptonic.plots.looks import choice

Handle = Artist | tuple[Artist, ...]  # a tuple is one entry of a legend with several marks

FULL = 0.96  # of the width of a figure, for a legend: its text is measured to a pixel for each letter


@dataclass(frozen=True)
class Stage:
    """One system of axes.

    own : whether the figure is ours, with room for a legend below the axes and a head above them
    """

    axes: Axes
    own: bool

    @property
    def figure(self) -> Figure:
        """The figure that the axes belong to."""
        figure = self.axes.get_figure(root=True)
        assert figure is not None
        return figure

    def legend(self, handles: Sequence[Handle] | None = None, ncols: int = 3, **look: Any) -> None:
        """Draw a legend of the handles, or of all labelled curves: below new axes, within axes of a user."""
        known = self.axes.get_legend_handles_labels()[0] if handles is None else list(handles)
        if self.own:
            below(self.figure, known, ncols, **look)
        elif known and choice().legend:
            self.axes.legend(handles=known, **look)


def below(figure: Figure, handles: Sequence[Handle], ncols: int = 3, **look: Any) -> None:
    """Explain the handles below a figure, in as many columns as its width has room for, up to ``ncols``.

    Handles that are explained there already come first.
    """
    if not handles or not choice().legend:
        return
    for legend in figure.legends.copy():
        for handle, text in zip(legend.legend_handles, legend.get_texts(), strict=True):
            assert handle is not None, "a legend without a handle"
            handle.set_label(text.get_text())
        handles = [*filter(None, legend.legend_handles), *handles]
        legend.remove()
    for columns in range(min(ncols, len(handles)), 0, -1):
        legend = figure.legend(handles=list(handles), loc="outside lower center", ncols=columns, **look)
        if columns == 1 or legend.get_window_extent().width < FULL * figure.bbox.width:
            return
        legend.remove()


def stage(ax: Axes | None, height: float, width: float = style.WIDTH, **how: Any) -> Stage:
    """The axes that were given, or new ones in a figure of a size in cm; ``how`` is for these.

    Raises
    ------
    HaptonicError : see `checked`
    """
    if ax is not None:
        return Stage(checked(ax), own=False)
    return Stage(style.blank(height, width).add_subplot(**how), own=True)


@style.drawn
def painted(paint: Callable[[Stage], object], height: float, *, ax: Axes | None = None, **how: Any) -> Figure:
    """A picture with one system of axes, in the common style, that a function paints.

    So a result may have a picture of its own without a module here.

    Parameters
    ----------
    height, ax, how : see `stage`
    """
    on = stage(ax, height, **how)
    paint(on)
    return on.figure


def checked(ax: object) -> Axes:
    """Axes that a picture can be drawn on.

    Raises
    ------
    HaptonicError : something else, axes in space or around a pole, or some that no figure has any more
    """
    given, cause, step = "", "it is something else", "figure, ax = matplotlib.pyplot.subplots(), then ax=ax"
    if isinstance(ax, Axes):
        if ax.name != "rectilinear":
            given = f"{ax.name} axes"
            cause = "these have other directions than to the right and upwards"
        elif ax.get_figure() is None:
            given = "axes that belong to no figure"
            cause = "they were removed from it, or it was cleared"
        else:
            return ax
    elif isinstance(ax, Figure):
        cause = "a figure may contain many axes, or none"
        step = "ax=figure.add_subplot(), or one of figure.axes"
    elif hasattr(ax, "get_major_ticks"):
        cause, step = "an axis is one edge of the axes, with its ticks", "ax=axis.axes"
    elif hasattr(ax, "__len__") and not isinstance(ax, str):
        cause, step = "subplots(rows, columns) gives several axes", "choose one of them: ax=axes[0]"
    raise HaptonicError.malformed(
        argument="ax",
        given=given or shown(ax),
        allowed="one matplotlib.axes.Axes in a plane, or nothing for a figure of its own",
        cause=cause,
        next_step=step,
    )
