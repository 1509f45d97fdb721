"""Checks of the parameters that sweeps, a design or a tolerance vary, for the cell of a study."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from pydantic_core import PydanticCustomError

from haptonic.cell import UnitCell
from haptonic.design.discs import SLIGHT, is_divided_alike, moving_together, reason_fixed
from haptonic.design.links import LOSSES
from haptonic.design.parameters import FEATURE, FILLET, OfCell, values_of
from haptonic.errors import MOST_PROPOSED, HaptonicError, StudyError, shown
from haptonic.fields import ExpressedNumber, handed_on, problem, with_numbers
from haptonic.fields.expressions import NAMED
from haptonic.fields.keys import Key, key_of, pattern_of
from haptonic.names import listed
from haptonic.study.named import expressed_numbers, links_of
from haptonic.study.sweeps import SweepAxis, SweepSettings
from haptonic.study.vary import check_names
from haptonic.units import format_quantity

if TYPE_CHECKING:
    from haptonic.study.schema import Description

SAME = 1e-9  # relative difference of an expression from its value at a step
VARY = "sweep.vary"
ENDS = {"low": "from", "high": "to", "spread": "spread"}
HEIGHTS = {"height", "high"}  # of a pillar and of a disc
KEPT = re.compile(r"carrier|(bands|mesh|design|tolerance)\.\w+")  # numbers that a search does not change


def check_varied(study: Description, keys: Mapping[str, Key]) -> None:
    """Refuse parameters that the cell does not have, and designs that could not be written as a study.

    ``keys`` : the keys of a study, by path
    """
    design, tolerance, cell = study.design_settings, study.tolerance_settings, study.cell
    if not design.vary and not tolerance.of:
        return
    values, parameters, absent = values_of(cell), study.parameters(), study.absent_parameters()
    for name, tables in (("design.vary", design.vary), ("tolerance.of", tolerance.of)):
        for i, varied_table in enumerate(tables, start=1):
            if varied_table.names_parameter:
                others = [other.parameter for other in tables if other is not varied_table]
                _check_named(study, varied_table, others, keys, f"{name}[{i}]")
    varied = {f"design.vary[{i}]": vary.parameter for i, vary in enumerate(design.vary, start=1)}
    varied |= {f"tolerance.of[{i}]": spread.parameter for i, spread in enumerate(tolerance.of, start=1)}
    for at, path in varied.items():
        if path not in values and not path.startswith(NAMED):
            if (fixed := reason_fixed(cell, path)) is not None:
                cause, next_step = fixed
                raise problem(
                    "conflict",
                    path, "a number that leaves the order of the discs as it is", cause, next_step,
                    at=f"{at}.parameter",
                )  # fmt: skip
            cause = "the cell of this study does not have it"
            next_step = _instead(cell, path, values)
            at = f"{at}.parameter"
            raise handed_on(StudyError.unknown(at, path, values, cause, slip=False, next_step=next_step))
    for i, vary in enumerate(design.vary, start=1):
        at, path = f"design.vary[{i}]", vary.parameter
        if vary.names_parameter:
            continue
        if path not in parameters:
            raise problem(
                "missing",
                path, "a parameter that this study gives", absent[pattern_of(path)],
                "give it in this study, or leave this table out", at=f"{at}.parameter",
            )  # fmt: skip
        key = key_of(path, keys)
        assert key is not None, path
        quantity = key.quantity
        assert quantity is not None, path
        for name, value in (("from", vary.low), ("to", vary.high)):
            if not quantity.holds(value):
                raise problem(
                    "out-of-range",
                    format_quantity(value, vary.unit), f"{path} has to be {quantity.limits}",
                    "designs there would not be possible", "choose a narrower range", at=f"{at}.{name}",
                )  # fmt: skip
        if path.endswith(FILLET) and vary.low == 0:
            raise problem(
                "out-of-range",
                "0 m", "more than zero", "a sharp edge needs another mesh than any fillet",
                'choose a small radius, such as "50 um", or look for a sharp one without this table',
                at=f"{at}.from",
            )  # fmt: skip


def _instead(cell: UnitCell, path: str, values: Mapping[str, float]) -> str:
    """Next step for a number that the cell does not have: numbers of its discs, or the table to write."""
    feature = FEATURE.search(path)
    has_table = feature and path[: feature.end() - 1].removeprefix("cell.") in {
        *cell.discs,
        *(table.removeprefix("cell.") for table in cell.pillar_tables),
    }
    sizes = [other for other in values if FEATURE.search(other) and ".material." not in other]
    if feature and sizes and not has_table:  # a site has either a pillar or discs
        name = path.rpartition(".")[2]
        names = HEIGHTS if name in HEIGHTS else {name}
        alike = [other for other in sizes if other.rpartition(".")[2] in names] or sizes
        return f"write {listed(alike[:MOST_PROPOSED], 'or')}"
    table = pattern_of(path).rpartition(".")[0]
    heading = f"[[{table[:-2]}]]" if table.endswith("[]") else f"[{table}]"
    return f"give it in {heading.replace('[].', '.')} first, or leave this table out"


def _check_named(
    study: Description, table: OfCell, others: Sequence[str], keys: Mapping[str, Key], at: str
) -> None:
    """Refuse a named parameter that a design or a tolerance cannot vary.

    Parameters
    ----------
    others : parameters of the other tables of the same name
    at : path of the table
    """
    path, cell = table.parameter, study.cell
    parameters = [name for name in study.parameters() if name.startswith(NAMED)]
    if path not in parameters:
        cause = "the study has no parameter of this name"
        raise handed_on(StudyError.unknown(f"{at}.parameter", path, parameters, cause))
    links = links_of(study)
    ends = {key: getattr(table, name) for name, key in ENDS.items() if hasattr(table, name)}
    for key, end in ends.items():
        try:
            end.checked(links.unit(path))
        except StudyError as error:
            raise handed_on(error, f"{at}.{key}") from None

    def refused(cause: str, next_step: str) -> PydanticCustomError:
        allowed = "a named parameter of sizes, angles or constants of the cell that can vary"
        return problem("conflict", path, allowed, cause, next_step, at=f"{at}.parameter")

    name, scope = path.removeprefix(NAMED), links.scope
    dependents = {number: e.text for number, e in expressed_numbers(study) if name in scope.uses(e.text)}
    if clash := next((other for other in others if other in dependents), None):
        raise refused(f"{clash} follows {path}, and both would vary", f"vary {path} alone, or {clash} alone")
    if kept := next((number for number in dependents if KEPT.fullmatch(number)), None):
        raise refused(
            f"{kept} follows it, which designs and tolerances do not change", f"give {kept} a number"
        )
    direction = links.directions({path: float(links.own(path))})[path]
    if not direction:
        raise refused("no number of the cell follows it", f'write an expression, such as pitch = "{name}"')
    together = moving_together(cell)
    movable = {*values_of(cell), *(other for group in together.values() for other in group)}
    of_cell = [number for number in links.dependents(path) if not number.endswith(LOSSES)]
    if fixed := next((number for number in of_cell if number not in movable), None):
        cause = f"{fixed} follows it, and a design or a tolerance cannot change that number"
        raise refused(cause, f"give {fixed} a number, or vary {path} in a [[sweep]]")
    here = cell.numbers()
    slight = SLIGHT / max(abs(s) / (abs(here[n]) or 1.0) for n, s in direction.items())
    moved = {number: here[number] + slight * slope for number, slope in direction.items()}
    if not is_divided_alike(cell, with_numbers(cell, moved, "cell.", checked=False)):
        raise refused("some discs would no longer share an end or a border", "use it for both of them")
    if "spread" in ends:
        return
    for key, end in ends.items():
        for number, value in links.numbers({path: float(end)}).items():
            declared = key_of(number, keys)
            assert declared is not None, number
            assert declared.quantity is not None, number
            if not declared.quantity.holds(value):
                raise problem(
                    "out-of-range",
                    f"{number} = {format_quantity(value, declared.unit)}",
                    f"{number} has to be {declared.quantity.limits}",
                    "designs there would not be possible", "choose a narrower range", at=f"{at}.{key}",
                )  # fmt: skip


def check_sweeps(study: Description) -> None:
    """Refuse sweeps whose expressions have no value in a study, and those that reach an impossible design."""
    lattice = study.without_plate()
    for row, sweep in enumerate(study.sweep_settings, start=1):
        for axis, table_name in zip(sweep.axes, ("", "second."), strict=False):
            _check_axis(study, axis, f"sweep[{row}].{table_name}")
        for step, values in enumerate(sweep.designs, start=1):
            try:
                lattice._design(sweep, values)
            except HaptonicError as error:
                if error.code == "conflict" and error.argument == VARY:
                    raise handed_on(error, f"sweep[{row}].vary") from None
                reached = " and ".join(
                    f"{axis.vary} = {format_quantity(value, axis.unit)}"
                    for axis, value in zip(sweep.axes, values, strict=True)
                )
                raise problem(
                    "out-of-range",
                    f"{reached} at step {step} of {sweep.count}",
                    f"a range in which every design is possible; {error.argument}: {error.allowed}",
                    f"{error.argument} would be {error.given}: {error.cause}",
                    "narrow the range between from and to, or vary a named parameter that others follow",
                    at=f"sweep[{row}]",
                ) from None


def _check_axis(study: Description, axis: SweepAxis, at: str) -> None:
    """Refuse an expression that has no value for the study's own parameters, or ends in another unit."""
    expression, parameters = axis.expression, study.parameters()
    try:
        check_names(expression, parameters, study.absent_parameters())
        expression.value(parameters)
    except StudyError as error:
        raise handed_on(error, f"{at}vary") from None
    for key, end in (("from", axis.start), ("to", axis.stop)):
        if isinstance(end, ExpressedNumber) and axis.names_parameters:
            try:
                end.checked(expression.unit(study.units()))
            except StudyError as error:
                raise handed_on(error, f"{at}{key}") from None


def check_reached(sweep: SweepSettings, values: Sequence[float], parameters: Mapping[str, float]) -> None:
    """Refuse a design in which an expression of the sweep has another value than its step.

    Raises
    ------
    StudyError : numbers of the expression depend on each other
    """
    for axis, value in zip(sweep.axes, values, strict=True):
        if not math.isclose(axis.expression.value(parameters), value, rel_tol=SAME):
            raise StudyError.conflict(
                argument=VARY,
                given=shown(axis.vary),
                allowed="an expression whose other numbers do not depend on the number that varies",
                cause="a number in it follows a named parameter or an end of a disc that this sweep changes",
                next_step="vary one of these alone, or exchange the two expressions",
            )
