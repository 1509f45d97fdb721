"""The band diagram: frequency along the edge of the irreducible zone."""

from __future__ import annotations

import json
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from haptonic.arrays import Array, Ints
from haptonic.errors import HaptonicError
from haptonic.later import xarray as xr
from haptonic.plots import style
from haptonic.plots.looks import AxisUnit, choice, colours
from haptonic.plots.stage import stage
from haptonic.plots.text import WavevectorUnit, band_text
from haptonic.units import hz_text

LEAST_SHOWN = 0.4  # of the frequencies, for plain bands to end where the last one is lowest
MARK_EVERY = 5  # wavevectors between two markers on a curve


@dataclass(frozen=True)
class CurveStyle:
    """Colour, dashes and marker of the curves of one character."""

    colour: str
    dashes: style.Dashes
    marker: str


CURVE_STYLES = {
    "pillar bending 1": CurveStyle(style.BLUE, style.SOLID, "o"),
    "pillar bending 2": CurveStyle(style.RED, style.SOLID, "s"),
    "pillar bending 3": CurveStyle(style.SKY, style.DASHED, "v"),
    "pillar bending 4+": CurveStyle("#7a4b00", style.DASH_DOT_DOTTED, "P"),
    "torsion": CurveStyle(style.GREEN, style.DASH_DOTTED, "D"),
    "longitudinal": CurveStyle(style.PURPLE, style.DOTTED, "^"),
    "plate flexural": CurveStyle(style.INK, style.SOLID, ""),
    "plate in-plane": CurveStyle(style.ORANGE, style.DASHED, "X"),
}
RIGID = "rigid body"
HATCHES = {"symmetric": "////", "antisymmetric": "\\\\\\\\"}


@style.drawn
def dispersion(
    dataset: xr.Dataset,
    carrier_hz: float | None = None,
    title: str = "",
    *,
    natures: bool = False,
    wavevectors: WavevectorUnit | None = None,
    ax: Axes | None = None,
) -> Figure:
    """Bands along the path; complete gaps shaded, the carrier dashed.

    Gaps of one parity in the plate's middle plane are hatched. A curve follows a branch through crossings.

    Parameters
    ----------
    dataset : from `haptonic.bloch.bands_dataset`
    carrier_hz : drive frequency, Hz
    natures : draw each mode in the colour, dashes and marker of its nature, also where this changes
        along a branch
    wavevectors : unit of the length of the path, which is then written below the corners
    """
    on = stage(ax, 11.5)
    axes = on.axes
    distance = dataset["distance"].values
    frequency = dataset["frequency"].values / 1e3
    axes.set_xlim(distance[0], distance[-1])
    axes.set_ylim(0, shown_up_to(dataset, carrier_hz, whole=natures) / 1e3)
    for lower, upper, _, _ in complete_gaps(dataset):
        axes.axhspan(lower / 1e3, upper / 1e3, facecolor=style.GAP, edgecolor="none", zorder=0, gid="gap")
    for (lower, upper), waves in parity_gaps(dataset):
        axes.axhspan(
            lower / 1e3, upper / 1e3, facecolor="none", edgecolor=style.GAP_EDGE, hatch=HATCHES[waves],
            linewidth=0.0, alpha=0.35, zorder=0, gid=f"gap {waves}",
        )  # fmt: skip
    present = _draw_branches(axes, dataset, distance, frequency, None if natures else colours([style.INK])[0])
    mark_corners(axes, dataset, wavevectors)
    axes.set_ylabel("frequency (kHz)")
    if title:
        axes.set_title(title, parse_math=False)
    if natures:
        for name in present:
            stroke = CURVE_STYLES[name]
            axes.plot([], [], color=stroke.colour, ls=stroke.dashes, marker=stroke.marker, ms=3.5, label=name)
        on.legend(ncols=min(3, max(1, len(present))), handlelength=3.4)
    labels = [(centre, text, style.GAP_EDGE) for centre, text in _gap_labels(dataset)]
    labels += [
        (0.5 * sum(edges) / 1e3, f"gap of\n{waves}\nwaves", style.GAP_EDGE)
        for edges, waves in parity_gaps(dataset)
    ]
    if carrier_hz is not None:
        axes.axhline(carrier_hz / 1e3, color=style.CARRIER, ls=style.DASHED, lw=1.1, gid="carrier", zorder=4)
        labels.append((carrier_hz / 1e3, f"carrier\n{hz_text(carrier_hz, form='g')}", style.CARRIER))
    style.label_right(axes, labels, lines=3)
    return on.figure


def shown_up_to(dataset: xr.Dataset, carrier_hz: float | None, *, whole: bool = False) -> float:
    """Upper end of the axis of frequencies, Hz; ``whole`` : up to the highest frequency of the last band."""
    frequency = dataset["frequency"].values
    lowest, highest = frequency[:, -1].min(), frequency.max()
    # below the lowest frequency of the last band no band is missing; of few bands that leaves too little
    top = 1.03 * highest if whole or lowest < LEAST_SHOWN * highest else lowest
    return float(top if carrier_hz is None or carrier_hz <= top else 1.05 * carrier_hz)


def complete_gaps(dataset: xr.Dataset) -> list[tuple[float, float, float, float]]:
    """Edges and the bounds of their errors of the complete gaps, Hz, lowest first."""
    chosen = dataset["gap_complete"].values.astype(bool)
    names = ("gap_lower", "gap_upper", "gap_lower_error", "gap_upper_error")
    columns = [dataset[name].values[chosen] for name in names]
    return sorted((float(a), float(b), float(c), float(d)) for a, b, c, d in zip(*columns, strict=True))


def parity_gaps(dataset: xr.Dataset) -> list[tuple[tuple[float, float], str]]:
    """Edges (Hz) of the gaps of one parity, and of which waves they are."""
    columns = (dataset[f"gap_{name}"].values for name in ("lower", "upper", "waves"))
    every = zip(*columns, strict=True)
    return [((float(low), float(high)), str(waves)) for low, high, waves in every if waves != "all"]


def _gap_labels(dataset: xr.Dataset) -> list[tuple[float, str]]:
    return [
        (
            0.5 * (lower + upper) / 1e3,
            "complete gap\n" + band_text(lower, lower_error, upper, upper_error).replace(" to ", "\nto "),
        )
        for lower, upper, lower_error, upper_error in complete_gaps(dataset)
    ]


def mark_corners(axes: Axes, dataset: xr.Dataset, unit: WavevectorUnit | None = None) -> None:
    """Name the corners of the irreducible zone below the axes, with a line at each.

    With a unit, or one that was chosen for all axes, the length of the path up to each corner is below its
    name.

    Raises
    ------
    HaptonicError : another unit
    """
    corners = json.loads(dataset.attrs["path_corners"])
    places = dataset["distance"].values[corners]
    for place in places[1:-1]:
        axes.axvline(place, color=style.PALE_INK, lw=0.6, zorder=1)
    labels = json.loads(dataset.attrs["path_labels"])
    of_path = choice().units.get("rad/m")
    if unit is not None:
        per_metre = {"rad/m": 1.0, "pi/a": np.pi / float(dataset.attrs["pitch_m"])}
        if unit not in per_metre:
            cause = "wavevectors have no such unit here"
            raise HaptonicError.unknown("wavevectors", str(unit), list(per_metre), cause)
        of_path = AxisUnit(unit.replace("pi", "π"), per_metre[unit])
    if of_path is None:
        axes.set_xticks(places, labels)
        axes.set_xlabel("wavevector")
        return
    lengths = places / of_path.factor
    axes.set_xticks(places, [f"{label}\n{length:.3g}" for label, length in zip(labels, lengths, strict=True)])
    axes.set_xlabel(f"length of the path ({of_path.name})")


def _draw_branches(
    axes: Axes, dataset: xr.Dataset, distance: Array, frequency: Array, color: str | None
) -> list[str]:
    """Draw all curves, in one colour or by their characters; names of these, in the order of the legend."""
    names = json.loads(dataset.attrs["character_names"])
    branch, character = dataset["branch"].values, dataset["character"].values
    seen: set[str] = set()
    for number in np.unique(branch):
        rows, columns = np.nonzero(branch == number)
        for part in np.split(np.arange(len(rows)), np.flatnonzero(np.diff(rows) > 1) + 1):
            i, j = rows[part], columns[part]
            if color is not None:
                axes.plot(distance[i], frequency[i, j], color=color, lw=1.1, gid=f"branch {number}", zorder=3)
                continue
            kind = _without_rigid(character[i, j], names.index(RIGID))
            for start, stop in _runs(kind):
                name = names[kind[start]]
                if name == RIGID:  # nothing else on this branch: points at zero frequency
                    continue
                seen.add(name)
                x, y = _stretched(distance[i], frequency[i, j], start, stop)
                stroke = CURVE_STYLES[name]
                marked = np.flatnonzero(i[start:stop] % MARK_EVERY == 2) + (start > 0)
                axes.plot(
                    x, y, color=stroke.colour, ls=stroke.dashes, marker=stroke.marker, ms=2.8,
                    markevery=marked.tolist(), gid=f"branch {number} {name}", zorder=3,
                )  # fmt: skip
    return [name for name in CURVE_STYLES if name in seen]


def _without_rigid(kind: Ints, rigid: int) -> Ints:
    """At zero frequency, where a mode is a rigid motion, take the name that the branch has next to it."""
    known = np.flatnonzero(kind != rigid)
    if not len(known):
        return kind
    nearest = known[np.abs(np.arange(len(kind))[:, None] - known).argmin(axis=1)]
    return np.asarray(kind[nearest])


def _runs(kind: Ints) -> list[tuple[int, int]]:
    """(start, stop) of the stretches of equal numbers."""
    ends = np.flatnonzero(np.diff(kind)) + 1
    return list(zip([0, *ends.tolist()], [*ends.tolist(), len(kind)], strict=True))


def _stretched(x: Array, y: Array, start: int, stop: int) -> tuple[Array, Array]:
    """Points start to stop, with half of the step to each neighbour of another colour."""
    before = [0.5 * (start - 1 + start)] if start else []
    after = [stop - 0.5] if stop < len(x) else []
    places = np.array([*before, *range(start, stop), *after])
    index = np.arange(len(x))
    return np.interp(places, index, x), np.interp(places, index, y)
