"""Power of an experiment against the number of participants."""

from __future__ import annotations

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from haptonic.later import xarray as xr
from haptonic.plots import style
from haptonic.plots.stage import stage
from haptonic.plots.text import label
from haptonic.units import in_percent

SIDES = ((style.BLUE, "o"), (style.ORANGE, "s"))


@style.drawn
def power(dataset: xr.Dataset, participants: int, *, ax: Axes | None = None) -> Figure:
    """Power against participants, for the reduction assumed on each waveguide.

    Parameters
    ----------
    dataset : variables ``power`` and ``error`` (waveguide, participants), ``reduction`` and ``needed``
        (waveguide); attributes ``wanted``, ``level`` and ``tests``; coordinate ``trials``
    participants : of the plan, marked
    """
    on = stage(ax, 9.0)
    axes = on.axes
    wanted = 100 * float(dataset.attrs["wanted"])
    for row, (colour, marker) in zip(range(dataset.sizes["waveguide"]), SIDES, strict=True):
        guide = dataset.isel(waveguide=row)
        name = f"{guide['waveguide'].item()}: {in_percent(guide['reduction'])} less friction assumed"
        axes.errorbar(
            guide["participants"].values, 100 * guide["power"].values, 200 * guide["error"].values,
            color=colour, marker=marker, ms=4, elinewidth=0.8, label=label(name),
            gid=str(guide["waveguide"].item()),
        )  # fmt: skip
    axes.axhline(wanted, color=style.PALE_INK, ls=style.DASHED, lw=1.0, label=f"required, {wanted:g} %")
    axes.axvline(participants, color=style.CARRIER, ls=style.DOTTED, lw=1.2, gid="plan",
                 label=f"this plan: {participants}")  # fmt: skip
    axes.set_ylim(0, 103)
    axes.set_xlim(0.5, float(dataset["participants"].max()) + 0.5)
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    axes.set_xlabel(f"participants, {int(dataset['trials'])} strokes each in every condition")
    axes.set_ylabel("power (%)")
    level, tests = 100 * float(dataset.attrs["level"]), int(dataset.attrs["tests"])
    axes.set_title(f"Simulated: paired t-test over participants, {tests} tests at {level:g} % together")
    on.legend(ncols=2)
    return on.figure
