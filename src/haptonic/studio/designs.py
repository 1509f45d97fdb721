"""Text of a design that an analysis has computed, so that it can be opened in the editor."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path

from haptonic.design.discs import with_joined
from haptonic.errors import HaptonicError
from haptonic.studio.editing import changed, steps_of
from haptonic.study import Study
from haptonic.study.loading import examined
from haptonic.units import format_quantity

SAME = 1e-9  # relative difference of a number that is read again from its text
DIGITS = 10  # of a written number: enough for `SAME`, too few for 0.44000000000000006


def design_text(text: str, changes: Mapping[str, float], folder: Path) -> str:
    """The text of a study with other numbers (SI, by path) and the ends of discs that meet them.

    Comments and all other tables stay. If the text gives such a number in another way, such as by the name
    of a material, the whole study is written again.

    Raises
    ------
    HaptonicError : the text is no study, or the numbers do not fit it
    """
    study, _, problems = examined(text, Study, folder)
    if study is None:
        raise problems[0]
    changes = with_joined(study.cell, changes)
    units, own = study.units(), study.parameters()
    result = text
    try:
        for path, value in changes.items():
            if not _same(own.get(path), value):
                unit = units[path]
                written = (
                    format_quantity(value, unit, digits=DIGITS) if unit else float(f"{value:.{DIGITS}g}")
                )
                result = changed(result, steps_of(path), written)
    except (HaptonicError, KeyError):
        result = ""
    design, _, _ = examined(result, Study, folder)
    if design is not None and all(_same(design.parameters().get(path), v) for path, v in changes.items()):
        return result
    return study.with_parameters(changes).to_toml()


def _same(given: float | None, wanted: float) -> bool:
    return given is not None and math.isclose(given, wanted, rel_tol=SAME)
