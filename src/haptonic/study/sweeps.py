"""The table of the study file for sweeps of designs."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import cache
from itertools import product
from typing import Annotated, ClassVar

from pydantic import Field, ValidationInfo, field_validator

from haptonic.bloch.settings import BandSettings
from haptonic.cell import UnitCell
from haptonic.errors import shown
from haptonic.fields import (
    CARRIER,
    Aliases,
    ByPattern,
    ExpressedNumber,
    absent,
    described,
    meant,
    needed,
    number_of,
    number_of_any_unit,
    problem,
    setting,
    table,
)
from haptonic.fields.expressions import NAMED
from haptonic.fields.quantity import collected
from haptonic.materials import PiezoelectricMaterial
from haptonic.study.vary import Expression, check_names, parse
from haptonic.units import format_quantity

MOST_DESIGNS = 1000  # of one sweep


@cache
def numeric_parameters() -> Mapping[str, str]:
    """SI unit of every parameter that an expression can name, by path: the inputs of the bands."""
    keys = table(UnitCell, "cell.") | table(BandSettings, "bands.")
    units = {path + "[]" * (key.count > 1): key.unit for path, key in keys.items() if key.quantity}
    return ByPattern({"carrier": CARRIER.unit, **units})


def can_vary(path: str, cell: UnitCell) -> bool:
    """True for a number of the study that an expression can name.

    The geometry of a CAD file is fixed, and no file can give another ceramic as the material of a cell.
    """
    is_of_file = cell.solid is not None and path.startswith("cell.") and not path.startswith("cell.solid.")
    owner = cell.materials.get(path.removeprefix("cell.").rpartition(".")[0])
    return path in numeric_parameters() and not is_of_file and not isinstance(owner, PiezoelectricMaterial)


def named_in(expression: Expression) -> list[str]:
    """Named parameters in an expression, ``parameters.a``."""
    return [name for name, _ in expression.powers if name.startswith(NAMED)]


@described("sweep.second", kw_only=True)
class SweepAxis:
    """Expression of parameters that varies from one value to another, in even steps."""

    aliases: ClassVar[Aliases] = {
        **meant("vary", "parameter", "param", "variable", "key", "name"),
        **meant("from", "start", "low", "lowest", "min", "first"),
        **meant("to", "stop", "end", "high", "highest", "max", "last"),
        **meant("steps", "num", "n", "points", "count", "number"),
        **absent(
            "values", "list", "step", "increment", cause="a sweep has evenly spaced values",
            next_step='write from, to and steps, such as from = "10 mm", to = "16 mm", steps = 7',
        ),
    }  # fmt: skip

    vary: str = needed(
        "Expression to vary; its first parameter changes.",
        title="Expression",
        strict=True,
        examples=["cell.pillar.height"],
    )
    start: float = Field(
        alias="from",
        title="First value",
        description="First value of the expression, with its unit.",
        examples=["10 mm"],
    )
    stop: float = Field(
        alias="to",
        title="Last value",
        description="Last value of the expression, with its unit.",
        examples=["16 mm"],
    )
    steps: Annotated[int, Field(ge=2, le=MOST_DESIGNS, strict=True)] = setting(
        25, "Number of designs, both ends included."
    )

    @field_validator("vary")
    @classmethod
    def _names_parameters(cls, text: str) -> str:
        with collected():
            expression = parse(text)
            for name, _ in expression.powers:
                if "." not in name:
                    raise problem(
                        "unknown", shown(name), f'names of numbers, such as "cell.pitch" or "{NAMED}{name}"',
                        "a named parameter is written with its table", f'write "{NAMED}{name}"',
                    )  # fmt: skip
            named = dict.fromkeys(named_in(expression), "")  # the study has their names and units
            check_names(expression, ByPattern({**numeric_parameters(), **named}), {})
        return text

    @field_validator("start", "stop", mode="plain")
    @classmethod
    def _has_dimension(cls, value: object, info: ValidationInfo) -> float:
        if "vary" not in info.data:  # already refused; the dimension is then unknown
            return 0.0
        if named_in(parse(info.data["vary"])):
            return number_of_any_unit(value)
        return number_of(value, parse(info.data["vary"]).unit(numeric_parameters()), info.context)

    def __post_init__(self) -> None:
        if self.start == self.stop:
            raise problem(
                "conflict",
                format_quantity(self.stop, self.unit),
                "a last value that differs from the first",
                "all designs would be the same",
                "change one end of the sweep, or remove it",
                at="to",
            )

    @property
    def names_parameters(self) -> bool:
        """True if the expression uses named parameters, whose units only the study has."""
        return bool(named_in(self.expression))

    @property
    def expression(self) -> Expression:
        return parse(self.vary)

    @property
    def unit(self) -> str:
        """SI unit of ``start``, ``stop`` and ``values``; empty for dimensionless values."""
        if self.names_parameters:
            ends = (self.start, self.stop)
            return next((end.unit for end in ends if isinstance(end, ExpressedNumber) and end), "")
        return self.expression.unit(numeric_parameters())

    @property
    def values(self) -> tuple[float, ...]:
        """Value of the expression at every step, in SI units, both ends included."""
        last = self.steps - 1
        inner = ((self.start * (last - step) + self.stop * step) / last for step in range(1, last))
        return (self.start, *inner, self.stop)


@described("sweep", kw_only=True)
class SweepSettings(SweepAxis):
    """Designs along one expression of parameters, or over all combinations of two."""

    second: SweepAxis | None = setting(
        None, "Another expression; every combination of the values of both is a design."
    )

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.second is None:
            return
        if self.second.expression.varied == self.expression.varied:
            raise problem(
                "repeated",
                self.second.expression.varied,
                "another first parameter than that of the sweep",
                "both expressions would change the same parameter",
                "vary another parameter, or remove this table",
                at="second.vary",
            )
        if self._names_varied(self, self.second) and self._names_varied(self.second, self):
            raise problem(
                "conflict",
                f"{self.vary} and {self.second.vary}",
                "two expressions of which one at least leaves out the first parameter of the other",
                "neither parameter can be found before the other",
                "write one of them without the first parameter of the other",
                at="second.vary",
            )
        if self.count > MOST_DESIGNS:
            raise problem(
                "too-large",
                f"{self.steps} times {self.second.steps} designs",
                f"at most {MOST_DESIGNS} designs in a sweep",
                "every combination of both values is a design",
                "take fewer steps in one of them",
                at="second.steps",
            )

    @staticmethod
    def _names_varied(axis: SweepAxis, other: SweepAxis) -> bool:
        """True if the expression of an axis names the parameter that another axis changes."""
        return other.expression.varied in dict(axis.expression.powers)

    @property
    def axes(self) -> tuple[SweepAxis, ...]:
        """The expressions that vary, one or two."""
        return (self,) if self.second is None else (self, self.second)

    @property
    def order(self) -> tuple[int, ...]:
        """Positions of the axes in the order in which their parameters are found."""
        if self.second is None:
            return (0,)
        return (1, 0) if self._names_varied(self, self.second) else (0, 1)

    @property
    def count(self) -> int:
        """Number of designs."""
        return math.prod(axis.steps for axis in self.axes)

    @property
    def designs(self) -> tuple[tuple[float, ...], ...]:
        """Values of the expressions (SI) at each design; those of the second change fastest."""
        return tuple(product(*(axis.values for axis in self.axes)))
