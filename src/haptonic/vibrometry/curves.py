"""Single measured curves put together to one frequency response on common lines."""

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
from haptonic.response import FrequencyResponse, Reference

SAME_LINE = 1e-4  # of the line spacing: files hold the spacing with six digits
AXES = {1: "x", 2: "y", 3: "z"}


@dataclass(frozen=True, eq=False)
class Curve:
    """One curve of one point, in SI units.

    source : what to call it in a report, such as "dataset 12"
    point : name of the point
    axis : +-1, +-2 or +-3 for x, y and z; negative against the axis
    kind : a response or its coherence
    frequency, values : (line,)
    motion : what moves; of a coherence it says nothing
    reference : what it is divided by; empty for a coherence
    estimator : H1, H2 or Hv, if the file says which
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
    """One response from curves. The notes name what does not fit the most frequent lines and unit.

    Parameters
    ----------
    places : of the points; one without is dropped
    reference : which reference, if the file has several; its name or its name and unit
    estimator : which estimator, if the file has several

    Raises
    ------
    ScanError : several references and none chosen, or nothing is left
    """
    curves = _ascending(curves, notes)
    measured = [curve for curve in curves if curve.kind == "response"]
    measured = _of_one_reference(measured, reference, notes)
    measured = _of_one_estimator(measured, estimator, notes)
    measured = _kept(measured, notes, _not_finite)
    measured = _kept(measured, notes, lambda curve: None if curve.point in places else "no coordinates")
    measured = _on_common_lines(measured, notes)
    measured = _once_each(measured, notes, places)
    if not measured:
        raise nothing_left(notes)
    motion = Counter(curve.motion for curve in measured).most_common(1)[0][0]
    if len({curve.motion for curve in measured}) > 1:
        notes.remark(f"displacements, velocities and accelerations are mixed; all were turned into {motion}")
    # The value knows velocity and displacement only.
    target: Literal["velocity", "displacement"] = "displacement" if motion == "displacement" else "velocity"
    if motion == "acceleration":
        notes.remark("accelerations were divided by i omega: the response is a velocity")
    lines = measured[0].frequency
    below = 1 if lines[0] == 0 and any(steps(curve.motion, target) < 0 for curve in measured) else 0
    if below:
        notes.remark("the line at 0 Hz was left out: there is nothing to divide by")
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


REMEDIES = (  # a word of the reason, the likely cause, the next step in Python and for a command
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
    """The error of a file of which no point can be used."""
    reasons = notes.first_reasons()
    cause = "the file holds something else than a scan, or only its geometry, or was cut short"
    next_step = command = "export the frequency responses of all points together with their coordinates"
    for word, of_word, in_python, for_command in REMEDIES:
        if notes.dropped and all(word in one.reason for one in notes.dropped):
            cause, next_step, command = of_word, in_python, for_command
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


def _of_one_reference(curves: list[Curve], asked: str | None, notes: Notebook) -> list[Curve]:
    """The curves of the reference that was asked for, or of the only one that there is."""
    known = list(dict.fromkeys(curve.reference for curve in curves))
    named = [one for one in known if one]
    if asked is None and len(known) <= 1:
        return curves
    if asked is None and len(named) == 1:
        chosen = named
    else:
        chosen = [one for one in known if asked in (str(one), one.name)]
    if len(chosen) != 1:
        option = str(named[0] if named else "A1, V")
        raise ScanError.unknown(
            "reference", asked, map(str, known),
            "the file holds responses to several references" if asked is None else "the name is misspelt",
            allowed="one of " + "; ".join(f'"{one}"' for one in known),
            next_step=f"choose one: read_scan(path, reference={option!r})",
            command=f"haptonic scan {shlex.quote(str(notes.path))} --reference {shlex.quote(option)}",
        )  # fmt: skip
    taken = [curve for curve in curves if curve.reference == chosen[0]]
    if chosen[0]:
        notes.remark(f'responses to "{chosen[0]}" were taken')
    if chosen[0] and (rest := sum(not curve.reference for curve in curves)):
        notes.remark(f"{rest} spectra without a reference were not used")
    elif asked is not None and len(taken) < len(curves):
        notes.remark(f"{len(curves) - len(taken)} curves of other references were not used")
    return taken


def _of_one_estimator(curves: list[Curve], asked: str, notes: Notebook) -> list[Curve]:
    """The curves of the estimator that was asked for, or else of the first one that there is."""
    known = list(dict.fromkeys(curve.estimator for curve in curves if curve.estimator))
    if not known:
        return curves
    chosen = asked if asked in known else min(known)
    notes.remark(f"transfer functions {chosen} were taken" + (f", not {asked}" if chosen != asked else ""))
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


def _kept(curves: list[Curve], notes: Notebook, refuse: Callable[[Curve], str | None]) -> list[Curve]:
    """The curves for which ``refuse`` gives no reason; the others are named."""
    kept = []
    for curve in curves:
        reason = refuse(curve)
        if reason:
            notes.drop(f"point {curve.point} ({curve.source})", reason)
        else:
            kept.append(curve)
    return kept


def _not_finite(curve: Curve) -> str | None:
    """Why the numbers of a curve cannot be used."""
    bad = np.count_nonzero(~np.isfinite(curve.values))
    if bad:
        return f"{bad} of its {len(curve.values)} numbers are not finite"
    lines = curve.frequency
    if not (len(lines) and np.isfinite(lines).all()):
        return "its frequencies are not finite"
    if lines[0] < 0:
        return "it has frequencies below zero"
    if (again := np.flatnonzero(np.diff(lines) <= 0)).size:
        return f"the frequency {lines[again[0]]:g} Hz twice, with other values"
    return None


def _on_common_lines(curves: list[Curve], notes: Notebook) -> list[Curve]:
    """Those on the most frequent set of lines."""
    groups: dict[tuple[int, str, str], list[Curve]] = defaultdict(list)
    for curve in curves:
        ends = (f"{curve.frequency[0]:.5e}", f"{curve.frequency[-1]:.5e}")
        groups[len(curve.frequency), *ends].append(curve)
    if not groups:
        return []
    common = max(groups.values(), key=len)[0].frequency
    step = (common[-1] - common[0]) / max(len(common) - 1, 1)
    return _kept(curves, notes, lambda curve: _other_lines(curve.frequency, common, step))


def _other_lines(lines: Array, common: Array, step: float) -> str | None:
    slack = SAME_LINE * step + 1e-5 * common[-1] if step else 1e-5 * common[-1]
    if len(lines) == len(common) and np.abs(lines - common).max() <= slack:
        return None
    return (
        f"{len(lines)} lines from {lines[0]:g} to {lines[-1]:g} Hz, where the scan has "
        f"{len(common)} from {common[0]:g} to {common[-1]:g} Hz"
    )


def _once_each(curves: list[Curve], notes: Notebook, places: Mapping[str, Point]) -> list[Curve]:
    """The first curve of each point and direction, and the first point at each place."""
    first: dict[tuple[str, int], Curve] = {}
    there: dict[tuple[float, float], str] = {}
    kept = []
    for curve in curves:
        place = places[curve.point]
        owner = there.setdefault((place.x, place.y), curve.point)
        other = first.setdefault((curve.point, abs(curve.axis)), curve)
        if owner != curve.point:
            notes.drop(f"point {curve.point} ({curve.source})", f"lies where point {owner} lies")
        elif other is not curve:
            same = np.array_equal(other.values, curve.values)
            what = "the same again" if same else "other values"
            notes.drop(f"point {curve.point} ({curve.source})", f"measured twice, {what}; the first is used")
        else:
            kept.append(curve)
    return kept


def _points_and_axes(curves: list[Curve], notes: Notebook) -> tuple[list[str], list[int]]:
    """Points that were measured in all directions of the scan, and these directions."""
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
    """(line, point) when every point has one on the same lines, else nothing and a remark."""
    found: dict[str, Curve] = {}
    for curve in curves:
        found.setdefault(curve.point, curve)
    usable = {
        name: np.real(found[name].values)
        for name in names
        if name in found and np.shape(found[name].values) == np.shape(like.values)
    }
    usable = {name: c for name, c in usable.items() if np.isfinite(c).all() and c.min() >= 0 and c.max() <= 1}
    if len(usable) == len(names):
        return np.stack([usable[name][below:] for name in names], axis=1)
    if curves:
        notes.remark(f"coherence left out: only {len(usable)} of {len(names)} points have a usable one")
    return None
