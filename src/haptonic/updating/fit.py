"""Fit of unknown numbers of a plate to its measured response, by least squares on a small model.

The small model, a `Family`, is extended by the plate's response at the end of each fit,
until it is accurate there.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from haptonic.arrays import Array, Complex, Ints
from haptonic.errors import ScanError
from haptonic.plate import Fineness, Plate, PlateModel
from haptonic.plate.vibration.parameter_family import Anchor, Family, anchored
from haptonic.progress import Progress, silent
from haptonic.units import format_quantity, in_percent
from haptonic.updating.intervals import Uncertainty, uncertainty
from haptonic.updating.match import Match, MeasuredResponse, Space
from haptonic.updating.parameters import LOSS, bonds_of
from haptonic.updating.settings import Unknown

ANCHORS = 3  # sets of numbers with exact responses in the first small model
ROUNDS = 6  # at most, of fit and extension
STRANGE = 4.0  # ratio of a point's rms residual to that of the median point, above which it is left out
NARROW = 0.2  # half of an interval over its value; narrower intervals are given in per cent
AT_BOUND = 1e-3  # share of the range: a number closer to a bound has stopped there
# A number at its bound that data would not determine in a range so many times as wide was not stopped by the
# bound: a support as stiff as a wall, 5.4 ranges, in contrast to a modulus beyond its range, 1.8.
WIDER = 5.0
UNEXPLAINED = 0.5  # largest share of the measured energy that a fit may leave unexplained


@dataclass(frozen=True)
class Fitted:
    """A number after the fit, SI.

    interval_95 : None if the data do not determine the number
    remark : reason for a missing interval
    """

    name: str
    unit: str
    start: float
    low: float
    high: float
    value: float
    interval_95: tuple[float, float] | None
    remark: str

    @property
    def range_text(self) -> str:
        """The interval as text, or the reason why it is missing."""
        if self.interval_95 is None:
            return self.remark
        low, high = self.interval_95
        if high < (1 + NARROW) * self.value:
            return f"± {in_percent(high / self.value - 1, form='.2g')}"
        return f"{format_quantity(low, self.unit)} to {format_quantity(high, self.unit)}"


@dataclass(frozen=True, eq=False)
class Fit:
    """Result of a fit.

    plate : plate with the fitted numbers
    numbers : each of them
    before, after : (lines, points) computed response with the starting and with the fitted numbers
    unexplained_before, unexplained : shares of the measured energy that these responses lack
    left_out : indices of points whose residuals are far above those of the others
    uncertainty : of the logarithms of the numbers
    error : relative error of the small model's response near the fitted numbers, against that from new tiles;
        it is corrected: the difference was added to the small model, and the numbers fitted again
    anchors : number of exact responses in the small model
    """

    plate: Plate
    numbers: tuple[Fitted, ...]
    before: Complex
    after: Complex
    unexplained_before: float
    unexplained: float
    left_out: Ints
    uncertainty: Uncertainty
    error: float
    anchors: int


@dataclass(frozen=True, eq=False)
class SmallModel:
    """Model of a plate for all values of its unknowns, from exact responses for some of them.

    model : model whose tiles serve all values
    anchors : exact responses
    frequency : (lines,) Hz
    points : (points, 2) of the flat face, m
    drives : complex amplitudes by name, V or N
    tolerance : relative error of the exact responses
    """

    space: Space
    model: PlateModel
    anchors: tuple[Anchor, ...]
    frequency: Array
    points: Array
    drives: Mapping[str, complex]
    tolerance: float

    @classmethod
    def of(
        cls,
        plate: Plate,
        unknowns: Sequence[Unknown],
        frequency: Array,
        points: Array,
        drives: Mapping[str, complex],
        tolerance: float,
        fineness: Fineness | None = None,
        progress: Progress = silent,
    ) -> SmallModel:
        """Make the model of a plate with the starting values; ``progress`` receives a text on each step.

        Raises
        ------
        HaptonicError : lines that cannot be computed with this tolerance
        """
        progress(0, 0, "tiles")
        bonds = bonds_of(plate, {unknown.parameter: (unknown.low, unknown.high) for unknown in unknowns})
        model = PlateModel.of(plate, float(frequency[-1]), fineness, bonds)
        space = Space(plate, unknowns)
        small = cls(
            space=space,
            model=model,
            anchors=(),
            frequency=frequency,
            points=points,
            drives=drives,
            tolerance=tolerance,
        )
        # the loss factor stays: fields of a plate with hardly any loss are expensive, and add nothing
        moved = np.array([unknown.parameter != LOSS for unknown in unknowns])
        tried = np.unique(np.vstack([np.zeros(len(unknowns)), moved * space.spread(ANCHORS - 1)]), axis=0)
        for number, x in enumerate(tried, start=1):
            progress(number, len(tried), "responses for sets of numbers")
            small = small.knowing(x)
        return small

    def knowing(self, x: Array) -> SmallModel:
        """A copy with the exact response for further numbers, given as logarithms over the start."""
        plate = self.space.plate_at(x)
        more = anchored(self.model, plate, self.drives, self.frequency, self.tolerance, self.points)
        return replace(self, anchors=(*self.anchors, more))

    def anew(self, x: Array) -> Complex:
        """(lines, points) displacement for other numbers, from tiles computed for these alone, m."""
        plate, lines = self.space.plate_at(x), self.frequency
        model = PlateModel.of(plate, float(lines[-1]), self.model.fineness)
        return anchored(model, plate, self.drives, lines, self.tolerance, self.points).displacement

    def match(self, data: MeasuredResponse) -> Match:
        """Compare with a measurement at the same lines and points."""
        return Match(self.space, Family.spanned(self.model, self.anchors, self.drives, self.points), data)


def fitted(small: SmallModel, data: MeasuredResponse, progress: Progress = silent) -> Fit:
    """Fit the unknown numbers of a plate to a measurement at the lines and points of its small model.

    Raises
    ------
    ScanError : no set of numbers explains the measurement
    HaptonicError : lines that cannot be computed with the tolerance of the small model
    """
    progress(0, 0, "search")
    match = small.match(data)
    start = np.zeros(len(small.space.unknowns))
    before = match.response(start)
    x = match.searched()
    strange = _strange(match, x)
    data = data.without(strange)
    for number in range(1, ROUNDS + 1):
        match = small.match(data)
        x = match.improved(match.of_complex, x)
        progress(0, 0, f"check {number}")
        small = small.knowing(x)
        error = _apart(match.response(x), data.seen(small.anchors[-1].displacement))
        unexplained = match.unexplained(x)
        if error < small.tolerance or (number > 1 and unexplained > UNEXPLAINED):
            break
    if unexplained > UNEXPLAINED:
        raise _unlike(unexplained, small, data, before)
    progress(0, 0, "the same with new tiles")
    exact = data.seen(small.anew(x))
    match = replace(match, defect=exact - match.response(x))
    x = match.improved(match.of_complex, x)
    after = match.response(x)
    intervals = uncertainty(match.jacobian(x), match.misfit(x))
    return Fit(
        plate=small.space.plate_at(x), numbers=_numbers(small.space, x, intervals), before=before,
        after=after,
        unexplained_before=data.unexplained(before),
        unexplained=data.unexplained(after), left_out=strange, uncertainty=intervals,
        error=_apart(after - match.defect, after), anchors=len(small.anchors),
    )  # fmt: skip


def _apart(response: Complex, exact: Complex) -> float:
    """Relative distance of two responses."""
    return float(np.linalg.norm(response - exact) / np.linalg.norm(exact))


def _strange(match: Match, x: Array) -> Ints:
    """Indices of points whose residuals are far above those of the others."""
    used = np.flatnonzero(match.data.used)
    size = np.sqrt((np.abs(match.misfit(x)) ** 2).mean(axis=0))
    return np.asarray(used[size > STRANGE * np.median(size)])


def _numbers(space: Space, x: Array, intervals: Uncertainty) -> tuple[Fitted, ...]:
    numbers, names = [], [unknown.parameter for unknown in space.unknowns]
    lost = intervals.half > 0.5 * (space.high - space.low)
    for k, (unknown, start) in enumerate(zip(space.unknowns, space.start.tolist(), strict=True)):
        value = min(max(start * float(np.exp(x[k])), unknown.low), unknown.high)
        half = float(intervals.half[k])
        low, high = float(space.low[k]), float(space.high[k])
        remark = ""
        is_at_bound = min(x[k] - low, high - x[k]) < AT_BOUND * (high - low)
        if is_at_bound and half < 0.5 * WIDER * (high - low):
            remark = "stopped at its bound"
        elif lost[k]:
            remark = "not determined by the data"
            if tied := [names[other] for other in intervals.tied(k) if lost[other]]:
                remark = f"determined only together with {' and '.join(tied)}"
        interval = None if remark else (value * float(np.exp(-half)), value * float(np.exp(half)))
        numbers.append(
            Fitted(
                name=unknown.parameter,
                unit=unknown.unit,
                start=start,
                low=unknown.low,
                high=unknown.high,
                value=value,
                interval_95=interval,
                remark=remark,
            )
        )
    return tuple(numbers)


def _unlike(unexplained: float, small: SmallModel, data: MeasuredResponse, before: Complex) -> ScanError:
    """Error for a measurement that the plate explains with no numbers within their bounds."""
    cause, next_step = _misread(small, data, before) or (
        "another plate, points that are turned or mirrored, another reference than the drive, narrow bounds",
        "compare the maps of `haptonic scan` and `haptonic plate`; register the scan; widen [fit.vary]",
    )
    return ScanError.no_answer(
        argument="fit",
        given=f"a best fit that leaves {in_percent(unexplained)} of the measured energy unexplained",
        allowed=f"at most {in_percent(UNEXPLAINED)}",
        cause=cause,
        next_step=next_step,
    )


def _misread(small: SmallModel, data: MeasuredResponse, before: Complex) -> tuple[str, str] | None:
    """Cause and remedy if the plate explains another reading of the measured numbers, at any scale."""
    turn = 1j * data.omega[:, None]
    unit = "give the unit of the response (--unit)"
    read, other = ("velocity", "displacement") if data.velocity else ("displacement", "velocity")
    readings: tuple[tuple[Complex, str, str], ...] = (
        (data.response, "the unit is another one, or the voltage", unit),
        (data.response.conj(), "its phases have the opposite sign, as for exp(-i omega t)", "conjugate it"),
        (-data.response, "the motion was measured against z", "reverse the sign of the response"),
        (data.response * (turn if data.velocity else 1 / turn), f"it is a {other}, read as a {read}", unit),
    )
    for response, cause, next_step in readings:
        size = float(np.linalg.norm(response) / np.linalg.norm(before))
        match = small.match(replace(data, response=response / size))
        fit = match.response(match.searched())
        scale = float(np.vdot(fit, match.data.response).real / np.vdot(fit, fit).real)
        if match.data.unexplained(scale * fit) < UNEXPLAINED:
            power = round(np.log10(scale * size))  # the fit of the loss factor leaves the scale uncertain
            return (
                f"{cause}; it is about {10.0**power:g} times the computed one" if power else cause,
                next_step,
            )
    return None
