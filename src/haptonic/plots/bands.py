"""The band diagram: frequency along the edge of the irreducible zone."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.colors import to_hex, to_rgba
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Rectangle

from haptonic.arrays import Array, Ints
from haptonic.errors import HaptonicError
from haptonic.later import xarray as xr
from haptonic.plots import style
from haptonic.plots.curves import PIECES, curves
from haptonic.plots.labels import label_right
from haptonic.plots.looks import AxisUnit, choice, colours
from haptonic.plots.room import legend_on_top, name_within, room_on_top
from haptonic.plots.stage import stage
from haptonic.plots.text import WavevectorUnit, band_text
from haptonic.units import hz_text

LEAST_SHOWN = 0.4  # of the frequencies, for plain bands to end where the last one is lowest
BELOW_LAST = 0.99  # of its lowest frequency, so that the last band is not on the frame
ROOM_ABOVE = 1.12  # times the highest complete gap, of the axis of frequencies
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
    "section deformation": CurveStyle("#3a1fd1", style.DASH_DOT_DOTTED, "*"),
    "plate flexural": CurveStyle(style.INK, style.SOLID, ""),
    "plate in-plane": CurveStyle(style.ORANGE, style.DASHED, "X"),
}
RIGID = "rigid body"
TINT = 0.2  # opacity of a gap in the colour of its curves
FURTHER = "|||"  # hatch of the complete gaps of a further design
HATCHES = {"symmetric": "////", "antisymmetric": "\\\\\\\\"}


@style.drawn
def dispersion(
    dataset: xr.Dataset,
    carrier_hz: float | None = None,
    title: str = "",
    *,
    natures: bool = False,
    gaps: bool = True,
    labels: bool = True,
    label: str | None = None,
    wavevectors: WavevectorUnit | None = None,
    ax: Axes | None = None,
) -> Figure:
    """Bands along the path; complete gaps shaded, the carrier dashed.

    Gaps of one parity in the plate's middle plane are hatched. A curve follows a branch through crossings.
    Axes that already show bands between the same corners keep their corners. On axes of a user gaps are named
    where there is room, and the gaps of further designs are hatched.

    Parameters
    ----------
    dataset : from `haptonic.bloch.bands_dataset`
    carrier_hz : drive frequency, Hz
    natures : draw each mode in the colour, dashes and marker of its nature, also where this changes
        along a branch
    gaps : shade and name the gaps
    labels : write names of gaps and of the carrier; on axes of a user for everything that they show
    label : name of the curves in the legend
    wavevectors : unit of the length of the path, which is then written below the corners
    """
    on = stage(ax, 11.5)
    axes = on.axes
    corners = _corners_of(axes, dataset)
    top = shown_up_to(dataset, carrier_hz, whole=natures) / 1e3
    if corners is None:
        distance = dataset["distance"].values
        axes.set_xlim(distance[0], distance[-1])
        mark_corners(axes, dataset, wavevectors)
        axes.set_ylabel("frequency (kHz)")
    else:
        dataset = _stretched(dataset, corners)
        top = max(top, axes.get_ylim()[1] * (1 - room_on_top(axes)))
    axes.set_ylim(0 if axes.get_yscale() == "linear" else None, top)
    _shade_incomplete(axes, dataset, named=on.own)
    colour = style.INK if natures else colours([style.INK])[0]
    is_one_of_several = label is not None or corners is not None
    shade, edge = to_rgba(style.GAP), style.GAP_EDGE
    if is_one_of_several and colour != style.INK:
        shade, edge = to_rgba(colour, TINT), colour
    of_one_parity = parity_gaps(dataset) if gaps else []
    for lower, upper, _, _ in complete_gaps(dataset) if gaps else []:
        look: dict[str, Any] = {"facecolor": shade}
        if corners is not None:  # a second colour on the first one would look like a third
            look = {"facecolor": "none", "hatch": FURTHER, "alpha": 0.6}
        axes.axhspan(lower / 1e3, upper / 1e3, edgecolor=edge, linewidth=0.0, zorder=0, gid="gap", **look)
    for (lower, upper), waves in of_one_parity:
        axes.axhspan(
            lower / 1e3, upper / 1e3, facecolor="none", edgecolor=edge, hatch=HATCHES[waves],
            linewidth=0.0, alpha=0.35, zorder=0, gid=f"gap {waves}",
        )  # fmt: skip
    present = _draw_branches(axes, dataset, None if natures else colour, label)
    if title:
        axes.set_title(title, parse_math=False)
    strokes = [(name, CURVE_STYLES[name]) for name in present if natures]
    handles = [
        *(Line2D([], [], color=stroke.colour, ls=stroke.dashes, marker=stroke.marker, ms=3.5, label=name)
          for name, stroke in strokes),
        *axes.get_legend_handles_labels()[0],
    ]  # fmt: skip
    if carrier_hz is not None and not _shows_carrier(axes, carrier_hz):
        axes.axhline(carrier_hz / 1e3, color=style.CARRIER, ls=style.DASHED, lw=1.1, gid="carrier", zorder=4)
    if not on.own:
        _arrange_within(axes, handles, labels=labels)
        return on.figure
    if handles:
        on.legend(handles, ncols=min(3, len(handles)), handlelength=3.4)
    names = [(centre, text, edge) for centre, text in _gap_labels(dataset)] if gaps else []
    names += [(0.5 * sum(edges) / 1e3, f"gap of\n{waves}\nwaves", edge) for edges, waves in of_one_parity]
    if carrier_hz is not None:
        names.append((carrier_hz / 1e3, f"carrier\n{hz_text(carrier_hz, form='g')}", style.CARRIER))
    label_right(axes, names if labels else [])
    return on.figure


def _arrange_within(axes: Axes, handles: list[Artist], *, labels: bool) -> None:
    """Name gaps and carriers on axes of a user, and draw the legend above all curves."""
    ranges, top = _ranges(axes), axes.get_ylim()[1]
    lowest = [patch.get_y() for patch in _rectangles(axes) if patch.get_gid() == "beyond"]
    if lowest and (handles or top > min(lowest) * (1 + 1e-9)):
        handles = [*handles, Patch(facecolor=style.BEYOND, label="not all bands")]
    name_within(axes, ranges if labels else [])  # names to the right make the axes narrower
    ours = [line for line in axes.lines if str(line.get_gid()).startswith(("branch", "carrier"))]
    legend_on_top(axes, handles, min(top, max(float(np.max(line.get_ydata())) for line in ours)))
    name_within(axes, ranges if labels else [])


def _rectangles(axes: Axes) -> list[Rectangle]:
    return [patch for patch in axes.patches if isinstance(patch, Rectangle)]


def _ranges(axes: Axes) -> list[tuple[float, float, str, str]]:
    """Ends (kHz), name and colour of all gaps and carriers that axes show."""
    ranges = []
    for patch in _rectangles(axes):
        kind, _, waves = str(patch.get_gid()).partition(" ")
        if kind == "gap":
            low, high = patch.get_y(), patch.get_y() + patch.get_height()
            edges = hz_text(1e3 * low, 1e3 * high).replace(" to ", "\N{EN DASH}")
            ranges.append((low, high, f"{waves} waves" if waves else edges, to_hex(patch.get_edgecolor())))
    for line in axes.lines:
        if line.get_gid() == "carrier":
            height = float(np.asarray(line.get_ydata())[0])
            ranges.append((height, height, f"carrier {hz_text(1e3 * height, form='g')}", style.CARRIER))
    return ranges


def _corners_of(axes: Axes, dataset: xr.Dataset) -> Array | None:
    """Places of the corners on axes that already show bands between the same corners; None on others.

    Raises
    ------
    HaptonicError : the axes show bands between other corners
    """
    if not any(str(line.get_gid()).startswith("branch") for line in axes.lines):
        return None
    known = [text.get_text().split("\n")[0] for text in axes.get_xticklabels()]
    names = json.loads(dataset.attrs["path_labels"])
    if names == known:
        return np.asarray(axes.get_xticks())
    raise HaptonicError.conflict(
        argument="ax",
        given=f"axes with bands along {'-'.join(known)}",
        allowed=f"axes without bands, or with bands along {'-'.join(names)}",
        cause="the two lattices have other wavevectors, so that their curves cannot be compared",
        next_step="draw these bands on axes of their own",
    )


def _stretched(dataset: xr.Dataset, corners: Array) -> xr.Dataset:
    """Bands of another pitch, whose path has another length, between these corners."""
    distance = dataset["distance"]
    own = distance.values[json.loads(dataset.attrs["path_corners"])]
    return dataset.assign(distance=distance.copy(data=np.interp(distance, own, corners)))


def _shows_carrier(axes: Axes, carrier_hz: float) -> bool:
    lines = [line for line in axes.lines if line.get_gid() == "carrier"]
    return any(np.isclose(np.asarray(line.get_ydata())[0], carrier_hz / 1e3) for line in lines)


def shown_up_to(dataset: xr.Dataset, carrier_hz: float | None, *, whole: bool = False) -> float:
    """Upper end of the axis of frequencies, Hz; ``whole`` : up to the highest frequency of the last band.

    The complete gaps and the bands that close them are in view.
    """
    lowest, highest, few = _last_band(dataset)
    # below the lowest frequency of the last band no band is missing; of few bands that leaves too little
    top = 1.03 * highest if whole or few else BELOW_LAST * lowest
    top = max([top, *(ROOM_ABOVE * upper for _, upper, _, _ in complete_gaps(dataset))])
    return float(top if carrier_hz is None or carrier_hz <= top else 1.05 * carrier_hz)


def _last_band(dataset: xr.Dataset) -> tuple[float, float, bool]:
    """Lowest frequency of the last band, highest one of all (Hz), and whether only few bands are complete."""
    frequency = dataset["frequency"].values
    lowest, highest = float(frequency[:, -1].min()), float(frequency.max())
    return lowest, highest, lowest < LEAST_SHOWN * highest


def _shade_incomplete(axes: Axes, dataset: xr.Dataset, *, named: bool) -> None:
    """Shade the range of bands that were not computed, and name it for the legend if it is in view."""
    lowest, _, few = _last_band(dataset)
    top = axes.get_ylim()[1]
    if few:
        return
    name = f"bands above band {dataset.sizes['band']} are missing"
    axes.axhspan(
        lowest / 1e3, 2 * top, facecolor=style.BEYOND, edgecolor="none", zorder=-1, gid="beyond",
        label=name if named and top > lowest / 1e3 * (1 + 1e-9) else None,
    )  # fmt: skip
    axes.set_ylim(top=top)


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


def _draw_branches(axes: Axes, dataset: xr.Dataset, color: str | None, label: str | None) -> list[str]:
    """Draw all curves, in one colour or by their characters; names of these, in the order of the legend.

    ``label`` : of the first of the curves in one colour
    """
    names = json.loads(dataset.attrs["character_names"])
    character = dataset["character"].values
    seen: set[str] = set()
    for curve in curves(dataset):
        height = curve.frequency / 1e3
        if color is not None:
            gid = f"branch {curve.branch[0]}"
            axes.plot(curve.distance, height, color=color, lw=1.1, gid=gid, zorder=3, label=label)
            label = None
            continue
        kind = _without_rigid(character[np.arange(len(curve.band)), curve.band], names.index(RIGID))
        for start, stop in _runs(kind, curve.branch):
            name = names[kind[start]]
            if name == RIGID:  # nothing else on this curve: points at zero frequency
                continue
            seen.add(name)
            # with half of the step to each neighbour of another character
            low, high = max(PIECES * start - PIECES // 2, 0), PIECES * stop - PIECES // 2 + 1
            stroke = CURVE_STYLES[name]
            marked = [PIECES * i - low for i in range(start, stop) if i % MARK_EVERY == 2]
            axes.plot(
                curve.distance[low:high], height[low:high], color=stroke.colour, ls=stroke.dashes,
                marker=stroke.marker, ms=2.8, markevery=marked, gid=f"branch {curve.branch[start]} {name}",
                zorder=3,
            )  # fmt: skip
    return [name for name in CURVE_STYLES if name in seen]


def _without_rigid(kind: Ints, rigid: int) -> Ints:
    """At zero frequency, where a mode is a rigid motion, take the name that the branch has next to it."""
    known = np.flatnonzero(kind != rigid)
    if not len(known):
        return kind
    nearest = known[np.abs(np.arange(len(kind))[:, None] - known).argmin(axis=1)]
    return np.asarray(kind[nearest])


def _runs(*numbers: Ints) -> list[tuple[int, int]]:
    """(start, stop) of the stretches in which no array changes."""
    ends = np.flatnonzero(np.any([np.diff(each) != 0 for each in numbers], axis=0)) + 1
    return list(zip([0, *ends.tolist()], [*ends.tolist(), len(numbers[0])], strict=True))
