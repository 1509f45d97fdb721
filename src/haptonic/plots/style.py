"""Common style of all pictures: size, type, colours that everybody can distinguish, and output."""

from __future__ import annotations

import io
import re
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import wraps
from pathlib import Path
from typing import Any, Literal, ParamSpec

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import Collection, PathCollection
from matplotlib.colors import Colormap
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.text import Text
from matplotlib.ticker import (
    FixedFormatter,
    FixedLocator,
    FuncFormatter,
    LogFormatterSciNotation,
    MaxNLocator,
)

from haptonic.atomic import refuse_overwrite, write_atomically
from haptonic.names import latex
from haptonic.paths import inside, target
from haptonic.plots.labels import move_labels_apart
from haptonic.plots.looks import PAGE, PICTURE_KINDS, choice
from haptonic.units import frequency_scale

P = ParamSpec("P")

CENTIMETRE = 1 / 2.54  # inch, in which matplotlib counts
WIDTH = PAGE.width
DOTS_PER_INCH = PAGE.dots
PASSES = 2  # of the layout: ticks and so the widths of their labels change with the size of the axes
TICK = 0.39  # length of a tick, and its distance from its label, over the size of the type
PLAIN = (1e-3, 1e4)  # numbers that a short logarithmic axis shows without powers of ten
FINE = 0.94  # type of ticks and legends over that of labels

INK = "#222222"
PALE_INK = "#8a8a8a"
GAP = "#f3d9a4"
GAP_EDGE = "#855a12"  # also the colour of its text: contrast 6 on white
CARRIER = "#b3123f"
BEYOND = "#e4e4e4"  # where nothing was computed

# After Okabe and Ito, without their yellow, which is too pale for a line on white.
BLUE, SKY, GREEN, ORANGE, RED, PURPLE = "#0072B2", "#56B4E9", "#009E73", "#E69F00", "#D55E00", "#CC79A7"

Dashes = Literal["-"] | tuple[float, tuple[float, ...]]
SOLID: Dashes = "-"
DASHED: Dashes = (0, (5, 2))
DOTTED: Dashes = (0, (1.2, 1.4))
DASH_DOTTED: Dashes = (0, (6, 1.6, 1.2, 1.6))
DASH_DOT_DOTTED: Dashes = (0, (5, 1.5, 1.2, 1.5, 1.2, 1.5))

_STYLE: dict[str, Any] = {
    "font.family": "DejaVu Sans",  # comes with matplotlib: the same picture on every machine
    "axes.titlesize": "medium",
    "figure.titlesize": "medium",
    "axes.labelsize": "medium",
    "axes.linewidth": 0.7,
    "axes.edgecolor": INK,
    "axes.labelcolor": INK,
    "text.color": INK,
    "xtick.color": INK,
    "ytick.color": INK,
    "legend.frameon": False,
    "lines.linewidth": 1.3,
    "hatch.linewidth": 0.6,
    "figure.facecolor": "white",
    "savefig.facecolor": "white",
    "text.hinting": "none",  # a text is as wide at any resolution, so that the layout stays the same
    "text.parse_math": False,  # a name may contain dollar signs; our own formulas switch it on
    "figure.dpi": 100,
    "svg.fonttype": "path",
    "pdf.fonttype": 42,  # publishers refuse fonts of type 3
    "svg.hashsalt": "haptonic",  # the same picture is the same file
}


@contextmanager
def styled() -> Iterator[None]:
    """The common style, for as long as the block lasts, independent of the user's settings."""
    with mpl.rc_context(), warnings.catch_warnings():
        # a name in another script: the picture shows a box in its place
        warnings.filterwarnings("ignore", r"Glyph .* missing from", UserWarning)
        mpl.rcdefaults()
        mpl.rcParams.update(_STYLE)  # type: ignore[arg-type]  # the stubs want literal keys
        size = choice().look.type
        sizes: dict[str, Any] = {"font.size": size, "legend.fontsize": FINE * size}
        for axis in ("xtick", "ytick"):
            sizes[f"{axis}.labelsize"] = FINE * size
            sizes |= {f"{axis}.major.{part}": TICK * size for part in ("size", "pad")}
        mpl.rcParams.update(sizes)  # type: ignore[arg-type]
        yield


def drawn(make: Callable[P, Figure]) -> Callable[P, Figure]:
    """Draw a figure in the common style and arrange its parts; on axes of a user, in the user's style."""

    @wraps(make)
    def inside(*args: P.args, **kwargs: P.kwargs) -> Figure:
        ax = kwargs.get("ax")
        if isinstance(ax, Axes) and ax.get_figure() is not None:
            with mpl.rc_context({"text.parse_math": False}), _safe_in_latex(ax):  # see _STYLE
                figure = make(*args, **kwargs)
            _allow_powers(ax)
            return figure
        with styled():
            figure = make(*args, **kwargs)
            weigh(figure, choice().look.type / PAGE.type)
            # otherwise the number of ticks would follow the settings at the time of writing
            for axes in figure.axes:
                axes.tick_params(labelsize=mpl.rcParams["xtick.labelsize"])
            suit_units(figure)
            arrange(figure)  # ticks and their labels are made late: make them in this style
            return figure

    return inside


def _allow_powers(axes: Axes) -> None:
    """Let numbers at ticks contain formulas, such as the powers of a logarithmic axis; names may not."""
    for axis in (axes.xaxis, axes.yaxis):
        if not isinstance(axis.get_major_formatter(), FixedFormatter):
            for tick in (*axis.get_major_ticks(), *axis.get_minor_ticks()):
                tick.label1.set_parse_math(True)


@contextmanager
def _safe_in_latex(axes: Axes) -> Iterator[None]:
    """Escape the texts that the block writes if LaTeX sets the type, so that it reads no commands in them."""
    before = {id(text): text.get_text() for text in axes.findobj(Text)}
    yield
    if not mpl.rcParams["text.usetex"]:
        return
    for text in axes.findobj(Text):
        assert isinstance(text, Text)
        if text.get_text() != before.get(id(text), ""):
            text.set_text(latex(text.get_text()))
    for axis in (axes.xaxis, axes.yaxis):
        own = axis.get_major_formatter()
        if isinstance(own, FuncFormatter | PowersOfTen):  # names of places, or our powers of ten
            axis.set_major_formatter(FuncFormatter(lambda x, pos, own=own: latex(own(x, pos))))


def weigh(figure: Figure, factor: float) -> None:
    """Make lines and markers thinner or thicker, as the type is smaller or larger than on a page."""
    if factor == 1.0:
        return
    for part in figure.findobj(Line2D):
        part.set_linewidth(factor * part.get_linewidth())
        part.set_markersize(factor * part.get_markersize())
    for patch in figure.findobj(Patch):
        patch.set_linewidth(factor * patch.get_linewidth())
    for group in figure.findobj(Collection):
        group.set_linewidth([factor * width for width in np.atleast_1d(group.get_linewidth())])
        if isinstance(group, PathCollection) and not group.get_rasterized():  # those fill a plate as they are
            group.set_sizes(factor**2 * group.get_sizes())


def suit_units(figure: Figure) -> None:
    """Show the ticks of all axes and colour bars in the chosen unit, or in MHz, GHz, µm or nm if that suits.

    The drawn values stay in kHz, mm and rad/mm; labels of ticks and the unit in the axis's name change.
    """
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            name = axis.get_label().get_text()
            unit = next((known for known in (*TICKS, *OF_SI) if f"({known})" in name), None)
            if unit is None or axis.get_scale() != "linear":
                continue
            low, high = axis.get_view_interval()
            suited, scale = _shown_unit(unit, max(abs(low), abs(high)))
            if suited == unit:
                continue
            most = min(6, max(3, len(axis.get_majorticklocs()) - 1))
            locator = MaxNLocator(nbins=most, steps=[1, 2, 2.5, 5, 10])
            places = np.asarray(locator.tick_values(low * scale, high * scale)) / scale
            axis.set_major_locator(FixedLocator([place for place in places if low <= place <= high]))
            axis.set_major_formatter(FuncFormatter(lambda x, _, scale=scale: f"{x * scale:.6g}"))
            if "ω" in suited:  # a ratio is the quantity itself
                name = name.replace(f"frequency ({unit})", suited)
            axis.get_label().set_text(name.replace(f"({unit})", f"({suited})"))


def _length_scale(largest: float) -> tuple[str, float]:
    """Unit for lengths up to ``largest`` (mm), and the factor from mm to it."""
    return ("mm", 1.0) if largest >= 0.5 else ("µm", 1e3) if largest >= 5e-4 else ("nm", 1e6)


def _frequency_scale(largest: float) -> tuple[str, float]:
    """Unit for frequencies up to ``largest`` (kHz), and the factor from kHz to it."""
    unit, scale = frequency_scale(1e3 * largest)
    return unit, 1e3 * scale


def _shown_unit(unit: str, largest: float) -> tuple[str, float]:
    """Unit in which an axis drawn in a unit is shown, and the factor to it."""
    quantity, factor = OF_SI.get(unit, ("", 1.0))
    wanted = choice().units.get(quantity)
    if wanted is not None:
        return wanted.name, factor / wanted.factor
    return TICKS[unit](largest) if unit in TICKS else (unit, 1.0)


OF_SI = {"kHz": ("Hz", 1e3), "rad/mm": ("rad/m", 1e3)}  # units of drawn axes whose unit can be chosen
TICKS = {"kHz": _frequency_scale, "mm": _length_scale}


def arrange(figure: Figure) -> None:
    """Give the parts of a figure their places, which they keep in every file format."""
    engine = figure.get_layout_engine()
    if engine is not None:
        for _ in range(PASSES):
            engine.execute(figure)
            for axes in figure.axes:  # their height has changed
                move_labels_apart(axes)
    figure.stale = False


class Drawing(Figure):
    """A figure that a notebook shows without any magic, at its size on paper.

    dots : of its PNG, per inch
    """

    def __init__(self, **how: Any) -> None:
        """Make one in the look that was chosen."""
        super().__init__(**how)
        self.dots = choice().look.dots

    def _repr_png_(self) -> tuple[bytes, dict[str, int]]:
        wide, high = (round(96 * inches) for inches in self.get_size_inches())  # px of CSS
        return rendered(self, "png"), {"width": wide, "height": high}


def blank(height: float, width: float = WIDTH) -> Drawing:
    """An empty figure whose parts do not overlap; its size in cm is that on a page, see `Look`."""
    look = choice().look
    return _empty(width / WIDTH * look.width, height * look.tall, "constrained")


def suited(tall: float, lines: float, width: float = 1.0) -> Drawing:
    """An empty figure for panels that keep their form.

    Parameters
    ----------
    tall : height of all panels, in widths of a whole figure; lines : of type above and below them
    width : of the figure, in the same widths
    """
    look = choice().look
    height = tall * look.width + lines * 1.4 * look.type / 72 / CENTIMETRE
    return _empty(width * look.width, height, "compressed")


def _empty(width: float, height: float, layout: Literal["constrained", "compressed"]) -> Drawing:
    return Drawing(figsize=(width * CENTIMETRE, height * CENTIMETRE), layout=layout)


SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


class PowersOfTen(LogFormatterSciNotation):
    """Labels of a logarithmic axis in plain text; below two decades plain numbers, such as 0.4 and 3."""

    def __call__(self, x: float, pos: Any = None) -> str:
        """The label of a place, such as 10⁻³; empty where matplotlib gives none."""
        formula = super().__call__(x, pos)
        assert self.axis is not None, "a formatter is asked by its axis"
        low, high = sorted(self.axis.get_view_interval())
        if formula and PLAIN[0] <= low and high < min(PLAIN[1], 100 * low * (1 - 1e-9)):
            return f"{x:.6g}"
        text = re.sub(r"\^\{(.*?)\}", lambda power: power[1].translate(SUPERSCRIPTS), formula)
        return re.sub(r"\$|\\mathdefault|[{}]", "", text).replace(r"\times", "\N{MULTIPLICATION SIGN}")


def logarithmic(axes: Axes, *, across: bool = False) -> None:
    """Give axes a logarithmic height, and ``across`` a logarithmic width too."""
    axes.set_yscale("log")
    if across:
        axes.set_xscale("log")
    for axis in (axes.yaxis, axes.xaxis)[: 1 + across]:
        axis.set_major_formatter(PowersOfTen())
        axis.set_minor_formatter(PowersOfTen(labelOnlyBase=False, minor_thresholds=(1, 0.4)))


def perceptual() -> Colormap:
    """Colours for an amount: even steps look even, also in grey and to the colour-blind."""
    return mpl.colormaps["viridis"]


def shades(count: int, *, signed: bool = False) -> list[list[int]]:
    """Red, green and blue, 0 to 255, of steps along `perceptual`, or along `diverging` if ``signed``."""
    scale = diverging() if signed else perceptual()
    colours: list[list[int]] = scale(np.linspace(0, 1, count), bytes=True)[:, :3].tolist()
    return colours


def amount() -> Colormap:
    """Colours for an amount on paper: nothing is white, much is dark; even steps look even in grey too."""
    return mpl.colormaps["Blues"]


def diverging() -> Colormap:
    """Colours for a signed amount: blue below zero, white there, red above, also for the colour-blind."""
    return mpl.colormaps["RdBu_r"]


def save(figure: Figure, folder: Path, name: str, *, overwrite: bool = False) -> list[Path]:
    """Write a figure as ``name.svg`` and ``name.png`` into a folder; each file whole or not at all.

    Returns
    -------
    the two paths

    Raises
    ------
    ResourceError : the name leads out of the folder, or is taken and ``overwrite`` is False, or the folder
        cannot be written
    """
    paths = [inside(target(folder, "folder"), f"{name}.{kind}") for kind in PICTURE_KINDS]
    for path in paths:
        refuse_overwrite(path, overwrite)
    for path, kind in zip(paths, PICTURE_KINDS, strict=True):
        content = rendered(figure, kind)
        write_atomically(path, lambda temporary, content=content: temporary.write_bytes(content))  # type: ignore[misc]
    return paths


def rendered(figure: Figure, kind: str) -> bytes:
    """The figure as the bytes of a file of this kind, ``svg``, ``pdf`` or ``png``."""
    stream = io.BytesIO()
    with styled():
        if figure.stale:
            arrange(figure)
        engine = figure.get_layout_engine()
        figure.set_layout_engine(None)  # with one, every file is arranged again, twice
        try:
            metadata = {"svg": {"Date": None}, "pdf": {"CreationDate": None}}.get(kind)
            dots = figure.dots if isinstance(figure, Drawing) else DOTS_PER_INCH
            figure.savefig(stream, format=kind, dpi=dots, metadata=metadata)
        finally:
            figure.set_layout_engine(engine)
            figure.stale = False  # another resolution moved nothing
    return stream.getvalue()
