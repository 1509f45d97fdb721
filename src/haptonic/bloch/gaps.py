"""Band gaps: complete gaps from the whole irreducible zone, partial gaps from the path."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from haptonic.arrays import Array, Ints
from haptonic.bloch.model import BlochModel
from haptonic.bloch.symmetry import WAVES, Waves
from haptonic.bloch.tracking import Diagram
from haptonic.errors import StudyError
from haptonic.lattice import Lattice
from haptonic.units import Hertz, format_quantity, hz_text, to_si

COARSE_DIVISIONS = 12  # of the irreducible zone's sides in the first sampling
DOUBT = 0.5  # relative deviation allowed between the change of a band and its slope at a corner
FLAT = 0.05  # slope at a corner, as a share of the steepest, below which the corner gives no bound
STILL = 1e-6  # the same where symmetry requires a slope of zero
RISE = 2.5  # slope over secant beyond which a curve may exceed an end with zero slope: 2 parabola, 3 cubic
INSIDE = np.array([(i, j, 6 - i - j) for i in range(7) for j in range(7 - i)]) / 6.0  # of a triangle
BETWEEN = np.array([(i, 12 - i) for i in range(13)]) / 12.0  # of a part of a line
SEARCH_GOAL = 1e-4  # relative uncertainty of an edge at which the search stops
MOST_SAMPLES = 600  # wavevectors; beyond them the remaining uncertainty is added to the error


@dataclass(frozen=True)
class Gap:
    """Frequencies without waves of given wavevectors, between two neighbouring bands.

    between : numbers, from 1, of the bands below and above among bands of its waves
    lower, upper : edges, Hz; lower_error, upper_error : bounds of their errors, Hz
    lower_kappa, upper_kappa : phases (rad) at which the edges were found
    complete : True for a gap of every direction and every wave; otherwise ``direction`` is the segment of the
        path, or "all" if the whole irreducible zone was searched for ``waves`` of one parity
    samples : number of sampled wavevectors
    """

    between: tuple[int, int]
    lower: Hertz
    upper: Hertz
    lower_error: Hertz
    upper_error: Hertz
    lower_kappa: tuple[float, float]
    upper_kappa: tuple[float, float]
    complete: bool
    direction: str
    samples: int
    waves: Waves = "all"

    @property
    def below(self) -> int:
        """Number of the band below."""
        return self.between[0]

    @property
    def edges(self) -> tuple[float, float]:
        """Lower and upper edge, Hz."""
        return self.lower, self.upper

    @property
    def width(self) -> float:
        return self.upper - self.lower

    @property
    def centre(self) -> float:
        return 0.5 * (self.lower + self.upper)

    @property
    def certain(self) -> bool:
        """True if the gap is wider than the errors of its edges."""
        return self.width > self.lower_error + self.upper_error

    @property
    def relative_error(self) -> float:
        """Larger relative error of the two edges."""
        return max(self.lower_error / self.lower, self.upper_error / self.upper)

    def margin(self, frequency: float | str) -> float:
        """Distance of a frequency from the nearer edge minus its error, Hz; negative outside the gap."""
        frequency = to_si(frequency, "Hz", "frequency") if isinstance(frequency, str) else frequency
        return min(frequency - self.lower - self.lower_error, self.upper - self.upper_error - frequency)

    def holds(self, frequency: float | str) -> bool:
        """True if a frequency lies inside the gap by more than the errors of its edges."""
        return self.margin(frequency) > 0


def ceilings(corners: Array, value: Array, slope: Array, inside: Array) -> Array:
    """(t,) highest frequencies that a band may have between corners of triangles, or between ends of lines.

    Between corners k_v, a band f with gradients g_v there is assumed to stay below

        min over v of  f(k_v) + g_v . (k - k_v) + DOUBT |g_v . (k - k_v)|,

    planes that touch the band and rise a little faster. This also applies to the lower of two crossing bands.
    A corner with little slope gives no bound unless it is the highest one. If its slope is zero, which
    symmetry requires at some wavevectors, it may be a minimum between two maxima: then it gives no bound if a
    band with the slope of another corner would rise above it.

    corners : (t, v, 2); value : (t, v); slope : (t, v, 2); inside : (s, v) shares of the corners
    """
    away = np.einsum("sv,tvk->tsk", inside, corners)[:, :, None] - corners[:, None]
    change = np.einsum("tsvk,tvk->tsv", away, slope)
    planes = value[:, None] + change + DOUBT * np.abs(change)
    steepness = np.linalg.norm(slope, axis=2)
    steepest = steepness.max(axis=1, keepdims=True)
    rise = np.einsum("tvwk,twk->tvw", corners[:, :, None] - corners[:, None], slope)  # at v, from w on
    exceeded = (rise > RISE * (value[:, :, None] - value[:, None])).any(axis=2)
    unbound = (steepness <= FLAT * steepest) & (value < value.max(axis=1, keepdims=True))
    unbound |= (steepness <= STILL * steepest) & exceeded
    planes = np.where(unbound[:, None], np.inf, planes)
    return np.asarray(np.maximum(value.max(axis=1), planes.min(axis=2).max(axis=1)))


class ZoneSampling:
    """Frequencies at wavevectors of the irreducible zone, on triangles refined near the edges of gaps.

    Mutable: samples are added during the search for edges. Used in this module only.
    """

    def __init__(self, model: BlochModel) -> None:
        self.model = model
        kappa, self.triangles = model.cell.zone.triangles(COARSE_DIVISIONS)
        self.kappa: list[Array] = []
        self.frequency: list[Array] = []
        self.slope: list[Array] = []
        self._middle: dict[tuple[int, int], int] = {}
        for point in kappa:
            self._add(point)

    def _add(self, kappa: Array) -> int:
        sample = self.model.sampled(kappa)
        self.kappa.append(kappa)
        self.frequency.append(sample.frequency)
        self.slope.append(sample.slope)
        return len(self.kappa) - 1

    def edge(self, band: int, sign: int, relative: float | None = None) -> tuple[float, Array, float]:
        """Highest (sign = +1) or lowest (-1) frequency of a band over the zone.

        Triangles that could exceed the best value (`ceilings`) are halved until no triangle can exceed it by
        more than the goal, ``relative`` or by default `SEARCH_GOAL`.

        Returns
        -------
        frequency : Hz; kappa : (2,) its wavevector; doubt : Hz, largest excess of an unsampled value
        """
        while True:
            value = sign * np.array([f[band] for f in self.frequency])
            slope = sign * np.array([s[band] for s in self.slope])
            corners = np.array(self.kappa)[self.triangles]
            ceiling = ceilings(corners, value[self.triangles], slope[self.triangles], INSIDE)
            best = int(value.argmax())
            doubt = float(ceiling.max() - value[best])
            goal = (relative or SEARCH_GOAL) * abs(value[best])
            if doubt <= goal or len(self.kappa) >= MOST_SAMPLES:
                return float(sign * value[best]), self.kappa[best], doubt
            sides = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)
            self._halve(np.flatnonzero(ceiling > value[best] + goal), sides)

    def _halve(self, chosen: Ints, sides: Array) -> None:
        remaining = np.delete(self.triangles, chosen, axis=0)
        new = []
        for number in chosen:
            longest = int(sides[number].argmax())
            a, b, c = np.roll(self.triangles[number], -longest)
            key = (int(min(a, b)), int(max(a, b)))
            if key not in self._middle:
                self._middle[key] = self._add(0.5 * (self.kappa[a] + self.kappa[b]))
            m = self._middle[key]
            new += [(a, m, c), (m, b, c)]
        self.triangles = np.concatenate([remaining, np.array(new, dtype=np.int64)])


def complete_gaps(model: BlochModel, count: int | None = None) -> tuple[Gap, ...]:
    """Gaps between neighbouring bands over the whole irreducible zone, lowest first.

    Only the first ``count`` bands are used; by default all.

    A gap narrower than its errors may not exist; it is listed as not certain. It is omitted if it is also
    narrower than the resolution of the search, as bands that touch by symmetry would appear as such a gap.
    """
    zone = ZoneSampling(model)
    gaps = []
    for band in range((count or model.count) - 1):
        frequency = np.array(zone.frequency)
        if frequency[:, band].max() >= frequency[:, band + 1].min():
            continue  # finer sampling can only reduce the distance of the bands
        lower, lower_kappa, lower_doubt = zone.edge(band, +1)
        upper, upper_kappa, upper_doubt = zone.edge(band + 1, -1)
        gap = Gap(
            between=(band + 1, band + 2),
            lower=lower,
            upper=upper,
            lower_error=float(model.solve(lower_kappa).error[band]) + lower_doubt,
            upper_error=float(model.solve(upper_kappa).error[band + 1]) + upper_doubt,
            lower_kappa=_phases(lower_kappa),
            upper_kappa=_phases(upper_kappa),
            complete=True,
            direction="all",
            samples=len(zone.kappa),
        )
        doubt = lower_doubt + upper_doubt  # bands that touch between samples give a gap no wider than this
        if gap.width > doubt and (gap.certain or gap.width > SEARCH_GOAL * gap.centre):
            gaps.append(gap)
    return tuple(gaps)


def parity_gaps(model: BlochModel, complete: tuple[Gap, ...]) -> tuple[Gap, ...]:
    """Gaps of one parity over the whole irreducible zone, if the plate's middle plane is a mirror.

    Waves of the other parity pass such a gap. Gaps are listed if they are certain and not within a complete
    gap.
    """
    return tuple(
        replace(gap, complete=False, waves=WAVES[parity])
        for parity, half in model.halves.items()
        for gap in complete_gaps(model.parts[parity], half.count)
        if gap.certain and not any(_within(gap, covering) for covering in complete)
    )


def _within(gap: Gap, other: Gap) -> bool:
    """True if a gap exceeds another by no more than the errors of its edges."""
    return other.lower <= gap.lower + gap.lower_error and gap.upper <= other.upper + gap.upper_error


def gap_at(gaps: Iterable[Gap], frequency: float) -> Gap | None:
    """Widest complete gap that contains a frequency (Hz) by more than the errors of its edges, or None.

    This is the definition of "the gap at the carrier" in the whole program.
    """
    containing = [gap for gap in gaps if gap.complete and gap.holds(frequency)]
    return max(containing, key=lambda gap: gap.width, default=None)


def common_gap(gaps: Iterable[Gap | None]) -> Gap | None:
    """Frequencies inside all gaps that contain one frequency; None if any of them is missing.

    Each edge keeps the error, the wavevector and the band of its own gap.
    """
    every = list(gaps)
    there = [gap for gap in every if gap is not None]
    if not there or len(there) < len(every):
        return None
    below, above = max(there, key=lambda gap: gap.lower), min(there, key=lambda gap: gap.upper)
    return replace(
        below,
        between=(below.between[0], above.between[1]),
        upper=above.upper,
        upper_error=above.upper_error,
        upper_kappa=above.upper_kappa,
    )


def shared_gaps(lattices: Iterable[Iterable[Gap]]) -> tuple[tuple[float, float], ...]:
    """Edges (Hz) of the frequencies that lie in a complete gap of every lattice, lowest first."""
    chosen = product(*([gap for gap in gaps if gap.complete] for gaps in lattices))
    common = [gap for gap in map(common_gap, chosen) if gap is not None]
    return tuple(sorted(gap.edges for gap in common if gap.lower < gap.upper))


def widest_gap(gaps: Iterable[Gap]) -> Gap | None:
    """The widest complete gap that is wider than the errors of its edges."""
    sure = [gap for gap in gaps if gap.complete and gap.certain]
    return max(sure, key=lambda gap: gap.width, default=None)


def need_gap_at(gaps: Sequence[Gap], carrier: float) -> Gap:
    """Return the gap at the carrier (Hz); see `gap_at`.

    Raises
    ------
    StudyError : no gap contains the carrier
    """
    gap, widest = gap_at(gaps, carrier), widest_gap(gaps)
    if gap is not None:
        return gap
    if any(gap.complete and gap.lower < carrier < gap.upper for gap in gaps):
        cause = "a complete gap contains it, but only within the errors of its edges"
        next_step = "compute the edges more exactly: a smaller [bands] accuracy, or a finer [mesh]"
    else:
        nearest = f"; the widest is {hz_text(widest.lower, widest.upper, form='.2f')}" if widest else ""
        cause = f"no complete gap of the cell contains the carrier{nearest}"
        next_step = (
            "find a cell for this carrier with `haptonic design`, or look higher, with more bands "
            "([bands] count)"
        )
    raise StudyError.no_answer(
        argument="carrier",
        given=format_quantity(carrier, "Hz"),
        allowed="a frequency in a complete gap of the cell, by more than the errors of its edges",
        cause=cause,
        next_step=next_step,
    )


def partial_gaps(lattice: Lattice, diagram: Diagram, complete: tuple[Gap, ...]) -> tuple[Gap, ...]:
    """Certain gaps for the wavevectors of one segment of the path, without complete gaps.

    The error of an edge includes the possible excess of its band between two samples (`ceilings`).
    """
    of_complete = {gap.between for gap in complete}
    path, gaps = diagram.path, []
    wavevector, slope = lattice.wavevector(path.kappa), np.nan_to_num(diagram.velocity) / (2 * np.pi)

    def excess(inside: slice, band: int, sign: int) -> float:
        """Largest excess (Hz) of a band over its samples on a segment: above (sign = +1) or below (-1)."""
        value = sign * diagram.frequency[inside, band]
        corners, at_corners, slope_there = (
            np.stack([samples[:-1], samples[1:]], axis=1)
            for samples in (wavevector[inside], value, sign * slope[inside, band])
        )
        return float(ceilings(corners, at_corners, slope_there, BETWEEN).max() - value.max())

    pieces = zip(path.corners, path.corners[1:], path.labels, path.labels[1:], strict=False)
    for start, stop, first, last in pieces:
        inside = slice(start, stop + 1)
        frequency, error = diagram.frequency[inside], diagram.error[inside]
        for band in range(frequency.shape[1] - 1):
            low, high = int(frequency[:, band].argmax()), int(frequency[:, band + 1].argmin())
            lower, upper = float(frequency[low, band]), float(frequency[high, band + 1])
            if (band + 1, band + 2) in of_complete or lower >= upper:
                continue
            gap = Gap(
                between=(band + 1, band + 2),
                lower=lower,
                upper=upper,
                lower_error=float(error[low, band]) + excess(inside, band, +1),
                upper_error=float(error[high, band + 1]) + excess(inside, band + 1, -1),
                lower_kappa=_phases(path.kappa[inside][low]),
                upper_kappa=_phases(path.kappa[inside][high]),
                complete=False,
                direction=f"{first}-{last}",
                samples=stop - start + 1,
            )
            gaps += [gap] if gap.certain else []
    return tuple(gaps)


def listed_gaps(model: BlochModel, diagram: Diagram, complete: tuple[Gap, ...]) -> tuple[Gap, ...]:
    """Complete gaps, those of one parity, and those of segments of the path."""
    return (*complete, *parity_gaps(model, complete), *partial_gaps(model.cell.lattice, diagram, complete))


def _phases(kappa: Array) -> tuple[float, float]:
    return float(kappa[0]), float(kappa[1])
