"""Single measured curves, combined into one frequency response on common frequency lines."""

from __future__ import annotations

import shlex
from collections import Counter, defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.channels import Notebook
from haptonic.channels.labels import Motion, steps
from haptonic.errors import ScanError
from haptonic.names import counted
from haptonic.response import FrequencyResponse, Reference
from haptonic.units import hz_text

SAME_LINE = 1e-4  # of the line spacing: files give the spacing with six digits
AXES = {1: "x", 2: "y", 3: "z"}


@dataclass(frozen=True, eq=False)
class Curve:
    """One curve of one point, in SI units.

    source : name in reports, such as "dataset 12"
    point : name of the point
    axis : +-1, +-2 or +-3 for x, y and z; negative for motion against the axis
    kind : a response or its coherence
    frequency, values : (line,)
    motion : quantity that is measured; ignored for a coherence
    reference : quantity that it is divided by; empty for a coherence
    estimator : H1, H2 or Hv; empty if the file does not give it
    """

    source: str
    point: str
    axis: int
    kind: Literal["response", "coherence"]
    frequency: Array
    values: NDArray[Any]
    motion: Motion
    reference: Reference
    estimator: str = ""


@dataclass(frozen=True)
class Point:
    """Position of a point, m."""

    x: float
    y: float


def assemble(
    curves: Sequence[Curve],
    places: Mapping[str, Point],
    notes: Notebook,
    *,
    reference: str | None = None,
    estimator: str = "H1",
    origin: Literal["measured", "simulated"] = "measured",
    title: str = "",
    inputs: Mapping[str, Any] | None = None,
) -> FrequencyResponse:
    """Combine curves into one response. Curves with other lines or units than most are noted and left out.

    Parameters
    ----------
    places : coordinates of the points; points without coordinates are dropped
    reference : name, or name and unit, of the reference to use if the file has several
    estimator : estimator to use if the file has several

    Raises
    ------
    ScanError : several references and no choice, or no curve left
    """
    curves = _without_empty_lines(_ascending(curves, notes), notes)
    measured = [curve for curve in curves if curve.kind == "response"]
    measured = _of_one_reference(measured, reference, notes)
    measured = _of_one_estimator(measured, estimator, notes)
    measured = _accepted(measured, notes, _not_finite)
    measured = _accepted(measured, notes, lambda curve: None if curve.point in places else "no coordinates")
    measured = _on_common_lines(measured, notes)
    measured = _once_each(measured, notes, places)
    if not measured:
        raise nothing_left(notes)
    motion = Counter(curve.motion for curve in measured).most_common(1)[0][0]
    if len({curve.motion for curve in measured}) > 1:
        notes.remark(f"displacements, velocities and accelerations are mixed; all were turned into {motion}")
    # a response is a velocity or a displacement, never an acceleration
    target: Literal["velocity", "displacement"] = "displacement" if motion == "displacement" else "velocity"
    if motion == "acceleration":
        notes.remark("accelerations were divided by i omega: the response is a velocity")
    lines = measured[0].frequency
    below = 1 if lines[0] == 0 and any(steps(curve.motion, target) < 0 for curve in measured) else 0
    if below:
        notes.remark("the line at 0 Hz was left out: it cannot be divided by i omega")
    lines = lines[below:]
    names, axes = _points_and_axes(measured, notes)
    if not names or not lines.size:
        raise nothing_left(notes)
    row, column = {name: i for i, name in enumerate(names)}, {axis: i for i, axis in enumerate(axes)}
    values = np.empty((len(lines), len(names), len(axes)), dtype=np.complex128)
    for curve in measured:
        if curve.point in row:
            factor = np.sign(curve.axis) * (2j * np.pi * lines) ** steps(curve.motion, target)
            values[:, row[curve.point], column[abs(curve.axis)]] = factor * curve.values[below:]
    return FrequencyResponse.of(
        values,
        frequency=lines,
        x=np.array([places[name].x for name in names]),
        y=np.array([places[name].y for name in names]),
        direction=[AXES[axis] for axis in axes],
        quantity=target,
        reference=measured[0].reference,
        origin=origin,
        coherence=_coherence([c for c in curves if c.kind == "coherence"], measured[0], names, below, notes),
        title=title,
        inputs=dict(inputs or {}) | {"points": names},
    )


REMEDIES = (  # word of a reason, likely cause, next step in Python, next step as a command
    (
        "no coordinates",
        "the responses were exported without the places of their points",
        'give the places of the points: read_scan(path, at="10 mm, 5 mm; 15 mm, 5 mm")',
        'haptonic scan {path} --at "10 mm, 5 mm" (several places: with semicolons between them)',
    ),
    (
        "twice",
        "two measurements were joined, or a line was measured again",
        "leave one of the two out",
        "leave one of the two out",
    ),
    (
        "no displacement, velocity or acceleration",
        "the unit is misspelt, or that of another quantity such as the sensor's voltage",
        'export a motion, such as velocity in mm/s or (m/s)/V; or give unit="mm/s/V" if the file has none',
        "export a motion, such as velocity in mm/s or (m/s)/V; or give --unit mm/s/V if the file has none",
    ),
)


def nothing_left(notes: Notebook) -> ScanError:
    """The error for a file without a usable point."""
    reasons = notes.first_reasons()
    cause = "the file is not a scan, or has only its geometry, or was cut short"
    next_step = command = "export the frequency responses of all points together with their coordinates"
    for reason, likely, in_python, for_command in REMEDIES:
        if notes.dropped and all(reason in dropped.reason for dropped in notes.dropped):
            cause, next_step, command = likely, in_python, for_command
    return ScanError.missing(
        argument="scan",
        given=f"{notes.path}: {reasons}",
        allowed="at least one point with a measured frequency response and its coordinates",
        cause=cause,
        next_step=next_step,
        command=command.format(path=shlex.quote(str(notes.path))),
    )


def _ascending(curves: Sequence[Curve], notes: Notebook) -> list[Curve]:
    """The curves with their lines in ascending order."""
    result, turned = [], dict[str, None]()
    for curve in curves:
        lines = np.asarray(curve.frequency)
        if lines.ndim == 1 and lines.shape == np.shape(curve.values) and (np.diff(lines) <= 0).any():
            order = np.argsort(lines, kind="stable")
            lines, values = lines[order], np.asarray(curve.values)[order]
            again = np.append(False, (np.diff(lines) == 0) & (np.diff(values) == 0))
            curve = replace(curve, frequency=lines[~again], values=values[~again])
            turned[curve.point] = None
        result.append(curve)
    if turned:
        count = f"{len(turned)} points" if len(turned) > 1 else f"point {next(iter(turned))}"
        notes.remark(f"the frequencies of {count} did not ascend: the lines were sorted")
    return result


def _of_one_reference(curves: list[Curve], wanted: str | None, notes: Notebook) -> list[Curve]:
    """Curves of the wanted reference, or of the only one in the file."""
    references = list(dict.fromkeys(curve.reference for curve in curves))
    named = [candidate for candidate in references if candidate]
    if wanted is None and len(references) <= 1:
        return curves
    if wanted is None and len(named) == 1:
        chosen = named
    else:
        chosen = [candidate for candidate in references if wanted in (str(candidate), candidate.name)]
    if len(chosen) != 1:
        option = str(named[0] if named else "A1, V")
        raise ScanError.unknown(
            "reference", wanted, map(str, references),
            "the file has responses to several references" if wanted is None else "the name is misspelt",
            allowed="one of " + "; ".join(f'"{candidate}"' for candidate in references),
            next_step=f"choose one: read_scan(path, reference={option!r})",
            command=f"haptonic scan {shlex.quote(str(notes.path))} --reference {shlex.quote(option)}",
        )  # fmt: skip
    taken = [curve for curve in curves if curve.reference == chosen[0]]
    if chosen[0]:
        notes.remark(f'responses to "{chosen[0]}" were used')
    if chosen[0] and (rest := sum(not curve.reference for curve in curves)):
        notes.remark(f"{rest} spectra without a reference were not used")
    elif wanted is not None and len(taken) < len(curves):
        notes.remark(f"{len(curves) - len(taken)} curves of other references were not used")
    return taken


def _of_one_estimator(curves: list[Curve], wanted: str, notes: Notebook) -> list[Curve]:
    """Curves of the wanted estimator, or else of the first estimator in the file."""
    estimators = list(dict.fromkeys(curve.estimator for curve in curves if curve.estimator))
    if not estimators:
        return curves
    chosen = wanted if wanted in estimators else min(estimators)
    notes.remark(f"transfer functions {chosen} were used" + (f", not {wanted}" if chosen != wanted else ""))
    with_it = {(curve.point, abs(curve.axis)) for curve in curves if curve.estimator in ("", chosen)}
    rest = [curve for curve in curves if curve.estimator not in ("", chosen)]
    names = sorted({curve.estimator for curve in rest})
    other = [curve for curve in rest if (curve.point, abs(curve.axis)) in with_it]
    if other:
        notes.remark(f"{len(other)} transfer functions {' and '.join(names)} were not used (--estimator)")
    for curve in rest:
        if (curve.point, abs(curve.axis)) not in with_it:
            notes.drop(f"point {curve.point} ({curve.source})", f"no {chosen}, only {curve.estimator}")
    return [curve for curve in curves if curve.estimator in ("", chosen)]


def _accepted(curves: list[Curve], notes: Notebook, refuse: Callable[[Curve], str | None]) -> list[Curve]:
    """Curves for which ``refuse`` gives no reason; the others are noted with their reasons."""
    accepted = []
    for curve in curves:
        reason = refuse(curve)
        if reason:
            notes.drop(f"point {curve.point} ({curve.source})", reason)
        else:
            accepted.append(curve)
    return accepted


def _without_empty_lines(curves: list[Curve], notes: Notebook) -> list[Curve]:
    """Leave out lines without a number in any response, such as the one at 0 Hz of a ratio of spectra."""
    responses = [curve for curve in curves if curve.kind == "response"]
    shapes = {np.shape(curve.values) for curve in responses}
    if len(shapes) != 1 or shapes != {np.shape(curve.frequency) for curve in responses}:
        return curves
    empty = ~np.isfinite([curve.values for curve in responses]).any(axis=0)
    if not empty.any() or empty.all():
        return curves
    ends = np.unique(responses[0].frequency[empty][[0, -1]])
    notes.remark(
        f"{counted(int(empty.sum()), 'line')} without a number in any point left out: {hz_text(*ends)}"
    )
    return [
        replace(curve, frequency=curve.frequency[~empty], values=curve.values[~empty])
        if np.shape(curve.values) in shapes
        else curve
        for curve in curves
    ]


def _not_finite(curve: Curve) -> str | None:
    """Reason for refusing the numbers of a curve, or None."""
    bad = np.count_nonzero(~np.isfinite(curve.values))
    if bad:
        return f"{bad} of its {len(curve.values)} numbers are not finite"
    if not np.any(curve.values):
        return "all of its numbers are zero"
    lines = curve.frequency
    if not (len(lines) and np.isfinite(lines).all()):
        return "its frequencies are not finite"
    if lines[0] < 0:
        return "it has frequencies below zero"
    if (again := np.flatnonzero(np.diff(lines) <= 0)).size:
        return f"the frequency {lines[again[0]]:g} Hz twice, with other values"
    return None


def _on_common_lines(curves: list[Curve], notes: Notebook) -> list[Curve]:
    """Curves on the most frequent set of lines."""
    groups: dict[tuple[int, str, str], list[Curve]] = defaultdict(list)
    for curve in curves:
        ends = (f"{curve.frequency[0]:.5e}", f"{curve.frequency[-1]:.5e}")
        groups[len(curve.frequency), *ends].append(curve)
    if not groups:
        return []
    common = max(groups.values(), key=len)[0].frequency
    step = (common[-1] - common[0]) / max(len(common) - 1, 1)
    return _accepted(curves, notes, lambda curve: _other_lines(curve.frequency, common, step))


def _other_lines(lines: Array, common: Array, step: float) -> str | None:
    slack = SAME_LINE * step + 1e-5 * common[-1] if step else 1e-5 * common[-1]
    if len(lines) == len(common) and np.abs(lines - common).max() <= slack:
        return None
    return (
        f"{len(lines)} lines from {lines[0]:g} to {lines[-1]:g} Hz, where the scan has "
        f"{len(common)} from {common[0]:g} to {common[-1]:g} Hz"
    )


def _once_each(curves: list[Curve], notes: Notebook, places: Mapping[str, Point]) -> list[Curve]:
    """The first curve of each point and direction, and the first point at each position."""
    first: dict[tuple[str, int], Curve] = {}
    names: dict[tuple[float, float], str] = {}
    unique = []
    for curve in curves:
        place = places[curve.point]
        owner = names.setdefault((place.x, place.y), curve.point)
        other = first.setdefault((curve.point, abs(curve.axis)), curve)
        if owner != curve.point:
            notes.drop(f"point {curve.point} ({curve.source})", f"lies at the position of point {owner}")
        elif other is not curve:
            same = np.array_equal(other.values, curve.values)
            content = "the same again" if same else "other values"
            notes.drop(
                f"point {curve.point} ({curve.source})", f"measured twice, {content}; the first is used"
            )
        else:
            unique.append(curve)
    return unique


def _points_and_axes(curves: list[Curve], notes: Notebook) -> tuple[list[str], list[int]]:
    """Points measured in all directions of the scan, and these directions."""
    measured: dict[str, set[int]] = defaultdict(set)
    for curve in curves:
        measured[curve.point].add(abs(curve.axis))
    wanted = Counter(frozenset(axes) for axes in measured.values()).most_common(1)[0][0]
    names = []
    for name, axes in measured.items():
        if axes == wanted:
            names.append(name)
            continue
        lost = ", ".join(AXES[axis] for axis in sorted(wanted ^ axes))
        notes.drop(f"point {name}", f"directions differ from those of the scan: {lost}")
    return names, sorted(wanted)


def _coherence(
    curves: list[Curve], like: Curve, names: list[str], below: int, notes: Notebook
) -> NDArray[np.floating[Any]] | None:
    """(line, point) if every point has a coherence on the same lines, else None and a remark."""
    by_point: dict[str, Curve] = {}
    for curve in curves:
        by_point.setdefault(curve.point, curve)
    usable = {
        name: np.real(by_point[name].values)
        for name in names
        if name in by_point and np.shape(by_point[name].values) == np.shape(like.values)
    }
    usable = {name: c for name, c in usable.items() if np.isfinite(c).all() and c.min() >= 0 and c.max() <= 1}
    if len(usable) == len(names):
        return np.stack([usable[name][below:] for name in names], axis=1)
    if curves:
        notes.remark(f"coherence left out: only {len(usable)} of {len(names)} points have a valid one")
    return None
