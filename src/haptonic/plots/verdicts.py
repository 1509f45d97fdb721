"""A measurement beside its model: spectra and contrast, criterion of shapes, criterion of every point."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from matplotlib.ticker import MaxNLocator

from haptonic.arrays import Array
from haptonic.plate.layout.grid import Layout
from haptonic.plots import style
from haptonic.plots.looks import choice
from haptonic.plots.plates import region_borders
from haptonic.plots.spectra import curves, finished
from haptonic.plots.stage import stage
from haptonic.updating.agreement import Agreement

MOST_NUMBERS = 16  # shapes along either side, beyond which the numbers of a matrix are not written
DARK = 0.6  # criterion above which numbers are written in ink, on the bright end of the colours
LOOKS = ((style.INK, style.SOLID), (style.SKY, style.DASHED), (style.RED, style.DASH_DOTTED))
MARKER = 35.0  # cm over the root of the number of points: size of a mark, so that neighbours leave no seam


@style.drawn
def before_after(
    frequency: Array,
    spectra: Mapping[str, Array],
    contrasts: Mapping[str, Mapping[str, Array]],
    *,
    units: str,
) -> Figure:
    """Average spectra above contrasts, the measurement in black with the models on top.

    Parameters
    ----------
    frequency : (lines,) Hz
    spectra : by label, the measurement first, (lines,) in ``units``
    contrasts : by pair of regions, the same labels, (lines,) dB; a panel for each pair
    """
    rows = 1 + len(contrasts)
    figure = style.blank(4.4 * rows + 1.9)
    panels = figure.subplots(rows, 1, sharex=True, squeeze=False)[:, 0]
    handles = curves(panels[0], frequency, spectra, LOOKS)
    style.logarithmic(panels[0])
    panels[0].set_ylabel(f"rms over all points\n({units})")
    for axes, (pair, levels) in zip(panels[1:], contrasts.items(), strict=True):
        curves(axes, frequency, levels, LOOKS)
        axes.axhline(0, color=style.PALE_INK, lw=0.6, zorder=1)
        axes.set_ylabel(f"{pair}\n(dB)")
    finished(panels[-1], frequency)
    figure.legend(handles=handles, loc="outside lower center", ncols=2)
    return figure


@style.drawn
def mac_matrix(of: Agreement, *, measured: str, computed: str, ax: Axes | None = None) -> Figure:
    """Criterion (MAC) of every measured shape with every computed one; pairs have a frame.

    measured, computed : labels of the axes
    """
    rows, columns = of.mac.shape
    on = stage(ax, min(3.6 + 0.62 * rows, 16.0) + 1.6, min(max(5.6 + 0.75 * columns, 9.0), 19.0))
    axes = on.axes
    image = axes.imshow(of.mac, cmap=style.perceptual(), norm=Normalize(0, 1), aspect="auto", gid="mac")
    if max(rows, columns) <= MOST_NUMBERS:
        for i in range(rows):
            for j in range(columns):
                value = of.mac[i, j]
                colour = style.INK if value > DARK else "white"
                axes.text(j, i, f"{value:.2f}", ha="center", va="center", color=colour, fontsize="small",
                          gid="number in a cell")  # fmt: skip
    for pair in of.pairs:
        axes.add_patch(
            Rectangle((pair.second - 0.5, pair.first - 0.5), 1, 1, fill=False, edgecolor=style.RED, lw=1.8,
                      gid="pair")
        )  # fmt: skip
    every = max(1, -(-max(rows, columns) // 24))
    for axis, shapes in ((axes.yaxis, of.measured), (axes.xaxis, of.computed)):
        places = np.arange(0, len(shapes.frequency), every)
        axis.set_ticks(places, [f"{f / 1e3:.2f}" for f in shapes.frequency[places]])
    axes.tick_params(axis="x", rotation=90)
    axes.set_xlabel(f"{computed} (kHz)")
    axes.set_ylabel(f"{measured} (kHz)")
    axes.set_title(f"MAC of {of.measured.how}; pairs framed")
    on.figure.colorbar(image, ax=axes, label="MAC (dimensionless)")
    return on.figure


@style.drawn
def frac_maps(points: Array, frac: Mapping[str, Array], layout: Layout, *, measured: str) -> Figure:
    """Criterion (FRAC) at every point of the plate, a map for each model.

    Parameters
    ----------
    points : (points, 2) m; frac : by model, (points,); NaN is not drawn
    measured : name of the measurement
    """
    ratio = (layout.y[-1] - layout.y[0]) / (layout.x[-1] - layout.x[0])
    wide = (choice().look.width - 2.0) / max(len(frac), 2)
    figure = style.suited(min(0.85 / max(len(frac), 2) * ratio, 1.1), 9)
    panels = figure.subplots(1, len(frac), sharey=True, squeeze=False)[0]
    size = min(MARKER * 28.0 / np.sqrt(len(points)) * wide / style.WIDTH, 14.0) ** 2 / 4
    for axes, (name, values) in zip(panels, frac.items(), strict=True):
        marks = axes.scatter(
            1e3 * points[:, 0], 1e3 * points[:, 1], c=values, s=size, cmap=style.perceptual(),
            norm=Normalize(0, 1), marker="s", linewidths=0, gid="frac", rasterized=True,
        )  # fmt: skip
        for region in layout.regions:
            axes.add_collection(
                LineCollection(region_borders(layout, region), colors=style.INK, linewidths=0.9)
            )
        axes.set(
            aspect="equal", xlim=(1e3 * layout.x[0], 1e3 * layout.x[-1]),
            ylim=(1e3 * layout.y[0], 1e3 * layout.y[-1]), xlabel="x (mm)",
        )  # fmt: skip
        axes.xaxis.set_major_locator(MaxNLocator(4))
        axes.set_title(f"{name}\nmedian {np.nanmedian(values):.3f}")
    panels[0].set_ylabel("y (mm)")
    figure.colorbar(
        marks, ax=list(panels), location="bottom", shrink=0.6, aspect=30, pad=0.02,
        label=f"FRAC of {measured}\nand model (dimensionless)",
    )  # fmt: skip
    return figure
