"""Checks of the parameters that sweeps, a design or a tolerance vary, for the cell of a study."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from haptonic.cell import UnitCell
from haptonic.design.discs import reason_fixed
from haptonic.design.parameters import FILLET, values_of
from haptonic.design.settings import DesignSettings
from haptonic.design.tolerance import ToleranceSettings
from haptonic.errors import HaptonicError, StudyError, shown
from haptonic.fields import ExpressedNumber, handed_on, problem
from haptonic.fields.keys import Key, key_of
from haptonic.study.sweeps import SweepAxis, SweepSettings
from haptonic.study.vary import check_names
from haptonic.units import format_quantity

if TYPE_CHECKING:
    from haptonic.study.schema import Description

SAME = 1e-9  # relative difference of an expression from its value at a step
VARY = "sweep.vary"


def check_varied(
    design: DesignSettings, tolerance: ToleranceSettings, cell: UnitCell, absent: Mapping[str, str],
    keys: Mapping[str, Key],
) -> None:  # fmt: skip
    """Refuse parameters that the cell does not have, and designs that could not be written as a study.

    Parameters
    ----------
    absent : parameters that the study does not give, and why
    keys : the keys of a study, by path
    """
    values = values_of(cell)
    varied = {f"design.vary[{i}]": vary.parameter for i, vary in enumerate(design.vary, start=1)}
    varied |= {f"tolerance.of[{i}]": spread.parameter for i, spread in enumerate(tolerance.of, start=1)}
    for at, path in varied.items():
        if path not in values:
            if (fixed := reason_fixed(cell, path)) is not None:
                cause, next_step = fixed
                raise problem(
                    "conflict",
                    path, "a number that leaves the order of the discs as it is", cause, next_step,
                    at=f"{at}.parameter",
                )  # fmt: skip
            cause = "the cell of this study does not have it"
            next_step = "give it in [cell] first, or leave this table out"
            at = f"{at}.parameter"
            raise handed_on(StudyError.unknown(at, path, values, cause, slip=False, next_step=next_step))
    for i, vary in enumerate(design.vary, start=1):
        at, path = f"design.vary[{i}]", vary.parameter
        if path in absent:
            raise problem(
                "missing",
                path, "a parameter that this study gives", absent[path],
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


def check_sweeps(study: Description) -> None:
    """Refuse sweeps whose expressions have no value in a study, and those that reach an impossible design."""
    for row, sweep in enumerate(study.sweep_settings, start=1):
        for axis, table_name in zip(sweep.axes, ("", "second."), strict=False):
            _check_axis(study, axis, f"sweep[{row}].{table_name}")
        for step, values in enumerate(sweep.designs, start=1):
            try:
                study._design(sweep, values)
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
                    "narrow the range between from and to",
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
    StudyError : numbers of the expression depend on each other through named parameters
    """
    for axis, value in zip(sweep.axes, values, strict=True):
        if not math.isclose(axis.expression.value(parameters), value, rel_tol=SAME):
            raise StudyError.conflict(
                argument=VARY,
                given=shown(axis.vary),
                allowed="an expression whose other numbers do not depend on the number that varies",
                cause="a number in it follows a named parameter that this sweep changes as well",
                next_step="vary the parameter alone, or exchange the two expressions",
            )
