"""Numbers of a cell that follow the named parameters of a study, by their expressions."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from haptonic.design.parameters import UNITS
from haptonic.errors import HaptonicError
from haptonic.fields.expressions import NAMED, ExpressedNumber, Scope
from haptonic.later import xarray as xr

LOSSES = ".loss_factor"  # end of the path of a number that lossless bands do not depend on
UNITS_OF_NAMED = "units_of_named"


def units_of(parameters: xr.DataArray) -> dict[str, str]:
    """SI units of the parameters on the axis of a result, by path."""
    named: dict[str, str] = json.loads(parameters.attrs.get(UNITS_OF_NAMED, "{}"))
    paths = map(str, parameters.values)
    return {path: named[path] if path in named else UNITS[path] for path in paths}


@dataclass(frozen=True)
class Links:
    """Expressions that lead from named parameters to the numbers of a cell.

    parameters : texts by name; expressions : texts by path of a number of the cell
    """

    parameters: Mapping[str, str] = field(default_factory=dict)
    expressions: Mapping[str, str] = field(default_factory=dict)

    @cached_property
    def scope(self) -> Scope:
        """The parameters, in which the expressions have values."""
        return Scope(self.parameters)

    def own(self, path: str) -> ExpressedNumber:
        """Value of a named parameter in the study; SI, with its unit."""
        return self.scope.expressed(path.removeprefix(NAMED))

    def unit(self, path: str) -> str:
        """SI unit of a number of the cell or of a named parameter."""
        return self.own(path).unit if path.startswith(NAMED) else UNITS[path]

    def attributes(self, paths: Sequence[str]) -> dict[str, str]:
        """Attributes of an axis of parameters: the units of the named ones, for `units_of`."""
        units = {path: self.unit(path) for path in paths if path.startswith(NAMED)}
        return {UNITS_OF_NAMED: json.dumps(units)} if units else {}

    def dependents(self, path: str) -> dict[str, str]:
        """Expressions of the numbers that change with a named parameter, by path."""
        name = path.removeprefix(NAMED)
        return {at: text for at, text in self.expressions.items() if name in self.scope.uses(text)}

    def numbers(self, values: Mapping[str, float]) -> dict[str, float]:
        """Numbers of the cell for values of parameters: its own, and those that follow named ones.

        Raises
        ------
        HaptonicError : an expression without a value there; its argument is the path of the number
        """
        plain = {path: value for path, value in values.items() if not path.startswith(NAMED)}
        named = {path: values[path] for path in values.keys() - plain.keys()}
        if not named:
            return plain
        scope = self._at(named)
        moved = dict.fromkeys(at for path in named for at in self.dependents(path))
        return {at: self._value(scope, at) for at in moved} | plain

    def directions(self, values: Mapping[str, float]) -> dict[str, dict[str, float]]:
        """Derivatives of the numbers of the cell with respect to each named parameter in ``values``."""
        named = {path: value for path, value in values.items() if path.startswith(NAMED)}
        if not named:
            return {}
        scope = self._at(named)
        directions: dict[str, dict[str, float]] = {}
        for path in named:
            name, moved = path.removeprefix(NAMED), {}
            for at, text in self.dependents(path).items():
                slope = scope.value(text).slopes.get(name)
                if slope and not at.endswith(LOSSES):
                    moved[at] = float(slope)
            directions[path] = moved
        return directions

    def _at(self, named: Mapping[str, float]) -> Scope:
        return self.scope.changed({
            path.removeprefix(NAMED): self.own(path).changed(value) for path, value in named.items()
        })  # fmt: skip

    def _value(self, scope: Scope, at: str) -> float:
        try:
            return float(scope.expressed(self.expressions[at]))
        except HaptonicError as error:
            raise error.changed(type(error), argument=at) from None
