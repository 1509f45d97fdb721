"""Checks of the parameters that a design or a tolerance varies, for the cell of a study."""

from __future__ import annotations

from collections.abc import Mapping

from haptonic.cell import UnitCell
from haptonic.design.discs import reason_fixed
from haptonic.design.parameters import FILLET, values_of
from haptonic.design.settings import DesignSettings
from haptonic.design.tolerance import ToleranceSettings
from haptonic.errors import StudyError
from haptonic.fields import handed_on, problem
from haptonic.fields.keys import Key, key_of
from haptonic.units import format_quantity


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
