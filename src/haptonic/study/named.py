"""Named parameters of a study, and the numbers that depend on them by expressions."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from haptonic.design.discs import with_joined
from haptonic.design.links import Links
from haptonic.errors import HaptonicError, StudyError
from haptonic.fields import ExpressedNumber
from haptonic.fields.expressions import NAMED
from haptonic.fields.keys import leaves
from haptonic.fields.writing import parameters_of


def expressed_numbers(study: Any) -> Iterator[tuple[str, ExpressedNumber]]:
    """Numbers of a study with an expression that still gives their value, by path."""
    scope = parameters_of(study)
    for path, number, _ in leaves(study):
        if scope.contains(number):
            yield path, number


def with_dependents(study: Any, values: Mapping[str, Any]) -> dict[str, Any]:
    """Changes of numbers, by path, and of the numbers that move with them.

    These are ends of discs that meet, and numbers whose expressions use a changed parameter. A number that is
    changed itself does not follow its expression any more.

    Raises
    ------
    StudyError : an expression without a value for the changed parameters
    """
    values = with_joined(study.cell, values)
    changed = {path.removeprefix(NAMED): v for path, v in values.items() if path.startswith(NAMED)}
    if not changed:
        return values
    old = parameters_of(study)
    new = old.changed(changed)
    moved = {f"{NAMED}{name}": new.texts[name] for name in changed}
    for path, number in expressed_numbers(study):
        if path not in values and old.uses(number.text) & changed.keys():
            moved[path] = number.text
    for path, text in moved.items():
        try:
            reason = new.problems.get(path.removeprefix(NAMED)) if path.startswith(NAMED) else None
            if reason is not None:
                raise reason
            moved[path] = new.expressed(text)
        except HaptonicError as error:
            raise error.changed(StudyError, argument=path) from None
    return {**values, **moved}


def varied_parameters(study: Any) -> set[str]:
    """Names of the parameters that sweeps, the design or tolerances of a study vary."""
    paths = {axis.expression.varied for sweep in study.sweep_settings for axis in sweep.axes}
    paths |= {table.parameter for table in (*study.design_settings.vary, *study.tolerance_settings.of)}
    return {path.removeprefix(NAMED) for path in paths if path.startswith(NAMED)}


def varied_expressions(study: Any) -> dict[str, str]:
    """Texts of the numbers that depend on varied parameters: other texts would give other designs."""
    names, scope = varied_parameters(study), parameters_of(study)
    if not names:
        return {}
    return {path: n.text for path, n in expressed_numbers(study) if scope.uses(n.text) & names}


def expressions_of(study: Any) -> dict[str, str]:
    """Expressions of the numbers of a study, by path; quantities as such are left out."""
    texts = {path: number.expression for path, number in expressed_numbers(study)}
    return {path: text for path, text in texts.items() if text}


def links_of(study: Any) -> Links:
    """Expressions of the numbers of a study's cell, if its design or its tolerances vary a parameter."""
    if not varied_parameters(study):
        return Links()
    texts = {name: value.text or repr(float(value)) for name, value in study.named_parameters.items()}
    return Links(texts, {
        path: number.text for path, number in expressed_numbers(study)
        if path.startswith(("cell.", "material."))
    })  # fmt: skip
