"""Friction of strokes: means of the conditions, reductions with intervals, every trial as a small plot."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.patches import Patch, Rectangle
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.friction.lubrication import WEBER_FRACTION
from haptonic.friction.signals.record import EVERYBODY
from haptonic.friction.statistics import IntervalEstimate
from haptonic.friction.statistics.summary import Condition
from haptonic.later import xarray as xr
from haptonic.plots import style
from haptonic.plots.looks import colours
from haptonic.plots.marks import above
from haptonic.plots.stage import stage
from haptonic.plots.text import label
from haptonic.units import in_percent

LOOKS = ((style.BLUE, "o"), (style.ORANGE, "s"), (style.GREEN, "^"), (style.PURPLE, "D"), (style.SKY, "v"))
MOST_PEOPLE = 12  # whose means are beside those of all
MOST_NAMED = 30  # who have a name beside their reductions
COLUMNS = 6  # of trials on a sheet


@style.drawn
def conditions(summaries: Sequence[Condition], *, origin: str, ax: Axes | None = None) -> Figure:
    """Mean friction of every condition with one standard deviation of trials, by participant and of all.

    A line leads from the mean without vibration, hollow, to that with it, filled.
    """
    guides = list(dict.fromkeys(condition.waveguide for condition in summaries))
    people = list(dict.fromkeys(condition.participant for condition in summaries))
    if len(people) > MOST_PEOPLE + 1:
        people = [EVERYBODY]
    on = stage(ax, 8.0)
    axes = on.axes
    shown = {
        (condition.participant, condition.waveguide, condition.actuation): condition
        for condition in summaries
        if condition.used
    }
    tints = colours([colour for colour, _ in LOOKS])
    step = 0.8 / (2 * len(guides))
    for place, person in enumerate(people):
        for g, guide in enumerate(guides):
            marker = LOOKS[g % len(LOOKS)][1]
            look: dict[str, Any] = {
                "color": tints[g % len(tints)],
                "marker": marker,
                "ms": 5,
                "mew": 1.0,
                "capsize": 0,
            }
            line = []
            for a, side in enumerate(("off", "on")):
                condition = shown.get((person, guide, side))
                if condition is None:
                    continue
                x, (mean, deviation) = place - 0.4 + step * (2 * g + a + 0.5), condition.friction
                known = deviation if np.isfinite(deviation) else None
                face = look["color"] if side == "on" else "white"
                points = axes.errorbar(x, mean, known, mfc=face, elinewidth=0.9, zorder=3, **look)
                points.lines[0].set_gid(f"{person} {guide} {side}")
                line.append((x, mean))
            if len(line) == 2:
                axes.plot(*zip(*line, strict=True), color=look["color"], lw=1.2, zorder=2)
    short = "all" if len(people) > 1 else EVERYBODY  # beside the others' names
    axes.set_xticks(range(len(people)), [short if name == EVERYBODY else name for name in people])
    axes.set_xlim(-0.55, len(people) - 0.45)
    axes.set_ylim(bottom=0)
    axes.set_ylabel(f"{origin} coefficient of friction")
    if EVERYBODY in people and len(people) > 1:
        axes.axvline(people.index(EVERYBODY) - 0.5, color=style.PALE_INK, lw=0.7)
    handles: list[Artist] = []
    for g, guide in enumerate(guides):
        colour, marker = tints[g % len(tints)], LOOKS[g % len(LOOKS)][1]
        handles += axes.plot([], [], marker, color=colour, label=label(guide))
    for face, words in (("white", "vibration off"), (style.INK, "vibration on")):
        handles += axes.plot([], [], "o", color=style.INK, mfc=face, label=words)
    on.legend(handles, ncols=4)
    return on.figure


@style.drawn
def reductions(
    population: Mapping[str, IntervalEstimate],
    own: Mapping[tuple[str, str], IntervalEstimate],
    *,
    origin: str,
    published: Mapping[str, float] | None = None,
    ax: Axes | None = None,
) -> Figure:
    """Reduction of every participant and of the population, with 95 % intervals.

    Parameters
    ----------
    population : by waveguide
    own : by waveguide and participant, intervals from the scatter of the participant's trials
    published : reductions by waveguide, as hollow marks beside those of the population
    """
    people = list(dict.fromkeys(name for _, name in own))
    rows = [*people, EVERYBODY]
    named = len(people) <= MOST_NAMED
    on = stage(ax, 4.0 + 0.75 * min(len(rows), MOST_NAMED))
    axes = on.axes
    tints = colours([colour for colour, _ in LOOKS])
    for g, (guide, whole) in enumerate(population.items()):
        colour, marker = tints[g % len(tints)], LOOKS[g % len(LOOKS)][1]
        shift = 0.16 * (g - 0.5 * (len(population) - 1))
        for row, person in enumerate(rows):
            estimate = whole if person == EVERYBODY else own.get((guide, person))
            if estimate is None:
                continue
            y = row + shift
            if np.isfinite(estimate.low):
                axes.plot([100 * estimate.low, 100 * estimate.high], [y, y], color=colour, lw=1.6, zorder=2)
            bold = person == EVERYBODY
            axes.plot(
                100 * estimate.value, y, marker, color=colour, ms=7 if bold else 5, zorder=3,
                label=label(guide) if row == 0 else None, gid=f"{guide} {person}",
            )  # fmt: skip
        if published and guide in published:
            axes.plot(
                100 * published[guide], len(people) + 0.35, marker, color=colour, mfc="white", ms=6, zorder=3,
                label=label(f"{guide}, published"), gid=f"{guide} published",
            )  # fmt: skip
    axes.axhline(len(people) - 0.5, color=style.PALE_INK, lw=0.7)
    axes.axvline(0, color=style.INK, lw=0.7)
    axes.axvline(100 * WEBER_FRACTION, color=style.CARRIER, ls=style.DASHED, lw=1.0, gid="weber")
    words = f"just noticed, {in_percent(WEBER_FRACTION)}"
    above(axes, [(100 * WEBER_FRACTION, words, style.CARRIER)])
    axes.set_yticks(range(len(rows)) if named else [len(people)], rows if named else [EVERYBODY])
    axes.set_ylim(len(rows) - 0.4, -0.6)
    axes.set_xlabel(f"{origin} reduction of friction, 95 % interval (%)")
    on.legend(ncols=4)
    return on.figure


@style.drawn
def trial_sheet(trials: xr.Dataset, traces: xr.Dataset, *, origin: str) -> Figure:
    """Every trial of a block as a small plot: both forces, its steady part, and why it does not count.

    One system of axes with the trials in its cells: thirty of them would take a second to draw.

    Parameters
    ----------
    trials : of one participant and block, see `haptonic.friction.signals.measured`
    traces : of those that could be read, see `haptonic.friction.recordings.traces`
    """
    trials = trials.sortby("trial")
    count = trials.sizes["stroke"]
    rows = -(-count // COLUMNS)
    figure = style.blank(1.6 + 2.1 * rows, 18.0)
    axes = figure.subplots()
    place = {int(number): row for row, number in enumerate(traces["trial"].values)}
    forces = {name: traces[name].values for name in ("normal", "tangential")}
    high = float(np.nanmax([np.nanquantile(np.abs(force), 0.999) for force in forces.values()], initial=0.1))
    lasts = float(np.nanmax(traces["time"].values, initial=1e-3))
    for k in range(count):
        trial = trials.isel(stroke=k)
        x, y = k % COLUMNS, rows - 1 - k // COLUMNS
        reason = str(trial["excluded"].values)
        axes.add_patch(_cell(x, y, "#fbe9e2" if reason else "#f5f7f9"))
        row = place.get(int(trial["trial"]))
        if row is not None:
            at = x + 0.04 + 0.88 * traces["time"].values[row] / lasts
            curves = [force[row] for force in forces.values()]
            _curves(axes, at, curves, traces["steady"].values[row], y, high)
        number = "" if reason else f"  {float(trial['friction']):.2f}"
        guide = f"{int(trial['trial'])}: {trial['waveguide'].values} {trial['actuation'].values}{number}"
        axes.text(x + 0.03, y + 0.9, guide, fontsize=6.5, va="center")
        if reason:
            axes.text(x + 0.03, y + 0.06, reason, fontsize=6, va="center", color=style.CARRIER)
    axes.set_xlim(0, COLUMNS)
    axes.set_ylim(0, rows)
    axes.set_axis_off()
    person, block = trials["participant"].values[0], int(trials["block"].values[0])
    axes.set_title(f"{person}, block {block}{_mark(origin)}")
    for name, colour in (("normal force", style.BLUE), ("tangential force", style.ORANGE)):
        axes.plot([], [], color=colour, label=name)
    axes.plot([], [], color=style.GREEN, lw=4, alpha=0.5, label="steady part")
    figure.legend(
        loc="outside lower center", ncols=3,
        title=f"green: {2 * high:.2g} N high about zero; cell: {lasts:.2g} s wide; number: friction",
        title_fontsize=7,
    )  # fmt: skip
    return figure


def _cell(x: int, y: int, colour: str) -> Patch:
    return Rectangle((x + 0.01, y + 0.01), 0.96, 0.96, facecolor=colour, edgecolor="none", zorder=0)


def _curves(
    axes: Axes, at: Array, forces: Sequence[Array], steady: NDArray[np.bool_], y: int, high: float
) -> None:
    middle, scale = y + 0.46, 0.36 / high
    axes.plot(at[[0, -1]], [middle, middle], color=style.PALE_INK, lw=0.4, zorder=1)
    colours = (style.BLUE, style.ORANGE)
    lines = [np.column_stack([at, middle + scale * np.clip(force, -high, high)]) for force in forces]
    axes.add_collection(LineCollection(lines, colors=colours, linewidths=0.8, zorder=3), autolim=False)
    if steady.any():
        edges = np.flatnonzero(np.diff(np.concatenate([[0], steady.astype(int), [0]])))
        for start, stop in edges.reshape(-1, 2):
            axes.fill_between(
                at[start:stop], y + 0.1, y + 0.82, color=style.GREEN, alpha=0.18, lw=0, zorder=1
            )


def _mark(origin: str) -> str:
    return ", simulated" if origin == "simulated" else ""
