"""Band gaps: complete ones from the whole irreducible zone, partial ones from the path."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from haptonic.arrays import Array, Ints
from haptonic.bloch.model import BlochModel
from haptonic.bloch.pencil import eigenpairs, hertz
from haptonic.bloch.symmetry import WAVES, Waves
from haptonic.bloch.tracking import Diagram
from haptonic.errors import StudyError
from haptonic.units import Hertz, format_quantity, hz_text

COARSE_DIVISIONS = 12  # of the irreducible zone's sides in the first sampling
DOUBT = 0.5  # share by which a band may rise more, or fall less, than its slope at a corner says
FLAT = 0.05  # slope at a corner, as a share of its triangle's steepest, that tells nothing of the inside
INSIDE = np.array([(i, j, 6 - i - j) for i in range(7) for j in range(7 - i)]) / 6.0  # of a triangle
SEARCH_GOAL = 1e-4  # relative; the search for an edge stops when it can move by no more than this
MOST_SAMPLES = 600  # wavevectors; when they are used up the remaining doubt goes into the error


@dataclass(frozen=True)
class Gap:
    """Frequencies that no wave of some wavevectors has, between two neighbouring bands.

    between : numbers of the bands below and above, counted from 1, among those of its waves
    lower, upper : edges, Hz; lower_error, upper_error : bounds of their errors, Hz
    lower_kappa, upper_kappa : phases (rad) at which the edges were found
    complete : True when it holds for every direction and every wave; else ``direction`` names the segment of
        the path, or is "all" where the whole irreducible zone was searched for ``waves`` of one parity
    samples : wavevectors that the claim rests on
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
    def width(self) -> float:
        return self.upper - self.lower

    @property
    def centre(self) -> float:
        return 0.5 * (self.lower + self.upper)

    @property
    def certain(self) -> bool:
        """Whether the gap is wider than the doubt about its edges."""
        return self.width > self.lower_error + self.upper_error

    @property
    def relative_error(self) -> float:
        """Of the worse edge."""
        return max(self.lower_error / self.lower, self.upper_error / self.upper)

    def margin(self, frequency: float) -> float:
        """How far inside of the nearer edge a frequency lies, errors counted, Hz; negative outside."""
        return min(frequency - self.lower - self.lower_error, self.upper - self.upper_error - frequency)

    def holds(self, frequency: float) -> bool:
        """Whether a frequency lies inside, errors counted."""
        return self.margin(frequency) > 0


class ZoneSampling:
    """Frequencies at wavevectors of the irreducible zone, on triangles that are halved where it matters.

    Grows while edges are searched; nothing outside this module holds one.
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
        values, modes = eigenpairs(self.model.fine.pencil, kappa, self.model.count)
        self.kappa.append(kappa)
        self.frequency.append(hertz(values))
        self.slope.append(np.nan_to_num(self.model.gradient(kappa, modes)))
        return len(self.kappa) - 1

    def edge(self, band: int, sign: int) -> tuple[float, Array, float]:
        """Highest (sign = +1) or lowest (-1) frequency of a band over the zone.

        Inside a triangle with corners kappa_v a band f, of gradient g_v there, is taken to stay below

            min over v of  f(kappa_v) + g_v . (kappa - kappa_v) + DOUBT |g_v . (kappa - kappa_v)|,

        planes that touch it and rise a little more than it does; that also holds where it is the lower of
        two bands that cross. A corner where the band is level, as symmetry makes it at some, is asked only
        if it is the highest of its triangle. Triangles that could beat the best value found are halved until
        none can by more than the goal.

        Returns
        -------
        frequency : Hz; kappa : (2,) where; doubt : Hz, by how much a value not seen may exceed it
        """
        while True:
            value = sign * np.array([f[band] for f in self.frequency])
            slope = sign * np.array([s[band] for s in self.slope])
            corners = np.array(self.kappa)[self.triangles]
            at_corners = value[self.triangles]
            away = np.einsum("sv,tvk->tsk", INSIDE, corners)[:, :, None] - corners[:, None]
            change = np.einsum("tsvk,tvk->tsv", away, slope[self.triangles])
            planes = at_corners[:, None] + change + DOUBT * np.abs(change)
            steepness = np.linalg.norm(slope[self.triangles], axis=2)
            flat = steepness <= FLAT * steepness.max(axis=1, keepdims=True)
            flat &= at_corners < at_corners.max(axis=1, keepdims=True)
            planes = np.where(flat[:, None], np.inf, planes)  # the two others know better
            ceiling = np.maximum(at_corners.max(axis=1), planes.min(axis=2).max(axis=1))
            best = int(value.argmax())
            doubt = float(ceiling.max() - value[best])
            goal = SEARCH_GOAL * abs(value[best])
            if doubt <= goal or len(self.kappa) >= MOST_SAMPLES:
                return float(sign * value[best]), self.kappa[best], doubt
            sides = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)
            self._halve(np.flatnonzero(ceiling > value[best] + goal), sides)

    def _halve(self, chosen: Ints, sides: Array) -> None:
        kept = np.delete(self.triangles, chosen, axis=0)
        new = []
        for number in chosen:
            longest = int(sides[number].argmax())
            a, b, c = np.roll(self.triangles[number], -longest)
            key = (int(min(a, b)), int(max(a, b)))
            if key not in self._middle:
                self._middle[key] = self._add(0.5 * (self.kappa[a] + self.kappa[b]))
            m = self._middle[key]
            new += [(a, m, c), (m, b, c)]
        self.triangles = np.concatenate([kept, np.array(new, dtype=np.int64)])


def complete_gaps(model: BlochModel) -> tuple[Gap, ...]:
    """Gaps between neighbouring bands that hold over the whole irreducible zone, lowest first.

    One that is narrower than its errors may not exist and is listed all the same, as not certain; but not if
    it is also too narrow for the search of the zone, which bands look like that symmetry makes touch.
    """
    zone = ZoneSampling(model)
    gaps = []
    for band in range(model.count - 1):
        frequency = np.array(zone.frequency)
        if frequency[:, band].max() >= frequency[:, band + 1].min():
            continue  # finer sampling can only bring the bands closer
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
        doubt = lower_doubt + upper_doubt  # bands that touch somewhere between the samples look like this
        if gap.width > doubt and (gap.certain or gap.width > SEARCH_GOAL * gap.centre):
            gaps.append(gap)
    return tuple(gaps)


def parity_gaps(model: BlochModel, complete: tuple[Gap, ...]) -> tuple[Gap, ...]:
    """Gaps of one parity in the plate's middle plane over the whole irreducible zone, where that is a mirror.

    Waves of one parity pass what is a gap for the other. Listed as far as they are certain, and more than a
    complete one.
    """
    return tuple(
        replace(gap, complete=False, waves=WAVES[parity])
        for parity, half in model.halves.items()
        for gap in complete_gaps(half)
        if gap.certain and not any(_within(gap, one) for one in complete)
    )


def _within(gap: Gap, other: Gap) -> bool:
    """Whether a gap reaches beyond another by no more than the errors of its edges."""
    return other.lower <= gap.lower + gap.lower_error and gap.upper <= other.upper + gap.upper_error


def gap_at(gaps: Iterable[Gap], frequency: float) -> Gap | None:
    """The gap that holds a frequency (Hz): complete, with its edges' errors counted; of several the widest.

    This is what "the gap that holds the carrier" means everywhere.
    """
    holding = [gap for gap in gaps if gap.complete and gap.holds(frequency)]
    return max(holding, key=lambda gap: gap.width, default=None)


def widest_gap(gaps: Iterable[Gap]) -> Gap | None:
    """The widest complete gap that is wider than the errors of its edges."""
    sure = [gap for gap in gaps if gap.complete and gap.certain]
    return max(sure, key=lambda gap: gap.width, default=None)


def need_gap_at(gaps: Sequence[Gap], carrier: float) -> Gap:
    """The gap that holds the carrier (Hz); see `gap_at`.

    Raises
    ------
    StudyError : there is none
    """
    gap, widest = gap_at(gaps, carrier), widest_gap(gaps)
    if gap is None:
        nearest = f"; the widest is {hz_text(widest.lower, widest.upper, form='.2f')}" if widest else ""
        raise StudyError.no_answer(
            argument="carrier",
            given=format_quantity(carrier, "Hz"),
            allowed="a frequency in a complete gap of the cell, by more than the errors of its edges",
            cause=f"no complete gap of the cell holds it{nearest}",
            next_step="find a cell for this carrier with `haptonic design`, or look higher, with more bands "
            "([bands] count)",
        )
    return gap


def partial_gaps(diagram: Diagram, complete: tuple[Gap, ...]) -> tuple[Gap, ...]:
    """Gaps for the wavevectors of one segment of the path only, as far as they are certain and not complete.

    The doubt of an edge is what its band could still do between two samples, by the slopes there.
    """
    known = {gap.between for gap in complete}
    path, gaps = diagram.path, []
    pieces = zip(path.corners, path.corners[1:], path.labels, path.labels[1:], strict=False)
    for start, stop, first, last in pieces:
        inside = slice(start, stop + 1)
        step = np.diff(path.distance[inside]).max()
        speed = np.nan_to_num(np.linalg.norm(diagram.velocity[inside], axis=2)) / (2 * np.pi)
        frequency, error = diagram.frequency[inside], diagram.error[inside]
        for band in range(frequency.shape[1] - 1):
            low, high = int(frequency[:, band].argmax()), int(frequency[:, band + 1].argmin())
            lower, upper = float(frequency[low, band]), float(frequency[high, band + 1])
            if (band + 1, band + 2) in known or lower >= upper:
                continue
            gap = Gap(
                between=(band + 1, band + 2),
                lower=lower,
                upper=upper,
                lower_error=float(error[low, band] + 0.5 * step * speed[low, band]),
                upper_error=float(error[high, band + 1] + 0.5 * step * speed[high, band + 1]),
                lower_kappa=_phases(path.kappa[inside][low]),
                upper_kappa=_phases(path.kappa[inside][high]),
                complete=False,
                direction=f"{first}-{last}",
                samples=stop - start + 1,
            )
            gaps += [gap] if gap.certain else []
    return tuple(gaps)


def _phases(kappa: Array) -> tuple[float, float]:
    return float(kappa[0]), float(kappa[1])
