"""Curves and shapes of universal files as the frequency responses of a scan."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from haptonic.channels import Notebook
from haptonic.channels.labels import Motion, Ratio, UnitLabel, label_of, ratio_of
from haptonic.channels.uff import Function, UffContents, uff_contents
from haptonic.channels.uff_blocks import Header, UnreadableError
from haptonic.errors import ScanError
from haptonic.response import Reference
from haptonic.vibrometry.curves import AXES, Curve, Point
from haptonic.vibrometry.readers.mapped import Mapped
from haptonic.vibrometry.readers.quantities import UnfitError, frequency_factor

__all__ = ["UffContents", "curves_of", "ratio_in", "reference_of", "uff_contents"]

RESPONSES = {4: "response", 5: "response", 12: "response", 6: "coherence"}
MOTIONS: dict[int, Motion] = {8: "displacement", 11: "velocity", 12: "acceleration"}
REFERENCES = {9: "N", 13: "N", 15: "Pa"}
SPECTRUM = 12
MOST_LISTED = 6  # points, in a message
LARGEST_PLATE = 10.0  # m; larger coordinates are in mm without a unit
_ESTIMATOR = re.compile(r"\bH([12v])\b", re.IGNORECASE)


def curves_of(contents: UffContents, given: Sequence[Point] = ()) -> tuple[list[Curve], dict[str, Point]]:
    """Responses and coherences in SI units, and positions of the points. The notes list all other curves.

    Parameters
    ----------
    given : positions of the points, in their order in the file, if the file has none
    """
    notes = contents.notes
    if contents.length is None:
        notes.remark("no data set 164: lengths without a unit were read as m, forces as N")
    places = {str(n): Point(float(p[0]), float(p[1])) for n, p in contents.nodes.items()}
    extent = max((abs(v) for p in places.values() for v in (p.x, p.y)), default=0.0)
    if extent > LARGEST_PLATE:
        notes.remark(f"points lie {extent:g} m from the origin: they are probably in mm; give length_unit")
    unused: Counter[str] = Counter()
    curves = [
        curve for function in contents.functions if (curve := _curve(function, contents, unused, bool(given)))
    ]
    for unit, count in unused.items():
        notes.remark(f"{count} spectra in {unit} were not used")
    curves += [curve for shape in _frequency_shapes(contents) for curve in shape]
    if given:
        places = points_by_order(list(dict.fromkeys(curve.point for curve in curves)), given, notes)
    # a point with an unusable curve was measured: it is listed among the dropped ones, not the missing ones
    measured = {curve.point for curve in curves} | {str(f.header.response_node) for f in contents.functions}
    if measured & places.keys():
        notes.missing.extend(name for name in places if name not in measured)
    return curves, places


def points_by_order(names: Sequence[str], given: Sequence[Point], notes: Notebook) -> dict[str, Point]:
    """Assign positions given by a user to the points of a file, in the order of the file.

    Raises
    ------
    ScanError : unequal numbers of positions and points
    """
    if len(names) != len(given):
        listed = ", ".join(names[:MOST_LISTED]) + (", ..." if len(names) > MOST_LISTED else "")
        raise ScanError.mismatch(
            argument="at",
            given=f"{len(given)} places, for {len(names)} points ({listed})",
            allowed="one place for each point of the file",
            cause="a place is missing, or the file has other points",
            next_step='give one for each point, in the order of the file: "0 mm, 0 mm; 5 mm, 0 mm"',
        )
    notes.remark("the given places were used, in the order of the points in the file")
    return dict(zip(names, given, strict=True))


def _curve(function: Function, contents: UffContents, unused: Counter[str], is_placed: bool) -> Curve | None:
    header, notes = function.header, contents.notes
    kind = RESPONSES.get(header.function)
    node = header.response_node
    name = str(node) if node else header.response_name or (function.source if is_placed else "")
    if kind is None:  # for time records, see `uff_time`
        article = "an" if function.kind.startswith("auto") else "a"
        reason = f"{article} {function.kind}, not a frequency response"
        notes.drop(f"{function.source}, point {name or '?'}", reason)
        return None
    if not name:
        notes.drop(function.source, "it does not give its point")
        notes.drop(function.source, "it does not give its point")
    if abs(header.response_axis) > 3:
        notes.drop(f"point {name} ({function.source})", "a rotation, not a motion along x, y or z")
        return None
    if header.response_axis == 0:
        notes.remark("curves without a direction were read as z, normal to the plate")
    like = Curve(
        source=function.source, point=name, axis=header.response_axis or 3, kind="coherence",
        frequency=np.empty(0), values=np.empty(0), motion="velocity", reference=Reference(),
    )  # fmt: skip
    try:
        abscissa, ordinate = function.values()
        abscissa = frequency_factor(header.abscissa.unit, Mapped({})) * abscissa
    except (UnreadableError, UnfitError) as error:
        notes.drop(f"point {name} ({function.source})", str(error))
        return None
    if kind == "coherence":
        return replace(like, frequency=abscissa, values=np.real(ordinate))
    ratio = ratio_in(header, contents)
    if ratio.over.motion is None:
        unit = header.over.unit or header.over.label or f"type {header.over.kind}"
        if header.function == SPECTRUM:  # of a reference channel, which vendors export with the responses
            unused[unit] += 1
        else:
            notes.drop(
                f"point {name} ({function.source})", f'"{unit}" is no displacement, velocity or acceleration'
            )
        return None
    if np.isrealobj(ordinate):
        notes.drop(f"point {name} ({function.source})", "real numbers: the phase is missing")
        return None
    reference = reference_of(header, ratio.under)
    values = ordinate * ratio.factor
    if header.reference_axis < 0:
        values = -values  # driven against the axis
    return replace(
        like, kind="response", frequency=abscissa, values=values, motion=ratio.over.motion,
        reference=reference, estimator="" if header.function == SPECTRUM else estimator_of(header.lines),
    )  # fmt: skip


def estimator_of(lines: Iterable[str]) -> str:
    """Estimator H1, H2 or Hv in lines of text; "" if they give none or several."""
    names = {letter.lower() for line in lines for letter in _ESTIMATOR.findall(line)}
    return f"H{names.pop()}" if len(names) == 1 else ""


def ratio_in(header: Header, contents: UffContents) -> Ratio:
    """Units of the ordinate: from its labels, else from data type and units of the file."""
    ratio = ratio_of(header.over.unit)
    over, under = ratio.over, ratio.under
    notes, length, force = contents.notes, contents.length or 1.0, contents.force or 1.0
    typed = MOTIONS.get(header.over.kind)
    if over.motion is None and typed is not None and not over.unit:
        over = UnitLabel(typed, "", 1 / length)
    elif typed is not None and over.motion is not None and typed != over.motion:
        notes.remark(f'a curve of type {typed} has the unit "{header.over.unit}"; the unit was used')
    elif over.motion is not None and contents.length not in (None, 1.0):
        assert contents.length is not None
        if not np.isclose(over.factor * contents.length, 1.0):
            notes.remark(f'the unit "{header.over.unit}" is not that of data set 164; the unit was used')
    if not under.unit:
        under = label_of(header.under.unit)
    if not under.unit and header.under.kind in REFERENCES:
        under = UnitLabel(None, REFERENCES[header.under.kind], 1 / force if header.under.kind != 15 else 1.0)
    return Ratio(over, under)


def reference_of(header: Header, under: UnitLabel) -> Reference:
    if not under.unit:
        return Reference()
    name = header.reference_name or header.under.label
    if header.reference_node:
        name = f"{header.reference_node}{AXES.get(abs(header.reference_axis), '')}"
    return Reference(name or "reference", under.unit)


def _frequency_shapes(contents: UffContents) -> Iterator[list[Curve]]:
    """Shapes at given frequencies (data set 55, analysis type 5) as curves over the frequency."""
    table: dict[tuple[int, int], list[tuple[float, complex]]] = {}
    motion: Motion | None = None
    for shape in contents.shapes:
        motion = MOTIONS.get(int(shape["spec_data_type"]))
        if int(shape["analysis_type"]) != 5 or motion is None:
            contents.notes.drop("shape (type 55)", "a mode shape or of an unknown quantity, no response")
            continue
        lengths = {len(shape[name]) for name in ("node_nums", "r1", "r2", "r3")}
        if len(lengths) != 1 or not 0 <= float(shape["freq"]) < np.inf:
            contents.notes.drop("shape (type 55)", "cut short, or at an impossible frequency")
            continue
        factor = 1 / (contents.length or 1.0)
        for axis in (1, 2, 3):
            values = np.asarray(shape[f"r{axis}"])
            for node, value in zip(shape["node_nums"], values, strict=True):
                table.setdefault((int(node), axis), []).append((float(shape["freq"]), factor * value))
    still = {axis: all(v == 0 for (_, a), row in table.items() if a == axis for _, v in row) for axis in AXES}
    for (node, axis), row in table.items():
        if still[axis]:  # a laser writes zeros for directions that it does not measure
            continue
        row.sort(key=lambda pair: pair[0])
        lines, values = np.array([f for f, _ in row]), np.array([v for _, v in row], dtype=complex)
        assert motion is not None
        yield [
            Curve(
                source="shapes (type 55)",
                point=str(node),
                axis=axis,
                kind="response",
                frequency=lines,
                values=values,
                motion=motion,
                reference=Reference(),
            )
        ]
