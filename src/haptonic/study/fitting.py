"""The table of the study file that says what is not known of a plate."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Annotated

from pydantic import Field

from haptonic.fields import described, problem
from haptonic.plate import Plate
from haptonic.study.asking import Frequency, OfNumber, ascending, once
from haptonic.units import format_quantity
from haptonic.updating.match import Unknown
from haptonic.updating.parameters import UNITS, unit_of, values_of

KNOWN = (*UNITS, "plate.actuator[1].bond.thickness")


@described("fit.vary", kw_only=True)
class UnknownSection(OfNumber):
    """A number that is fitted to a measurement, beginning with the value in this file."""

    start: float = Field(alias="from", title="Lowest value", description="With its unit, if it has one.")
    stop: float = Field(alias="to", title="Highest value", description="With its unit, if it has one.")

    @classmethod
    def unit_of(cls, path: str) -> str | None:
        """SI unit of a number of a plate that can be fitted; None of any other."""
        return unit_of(path)

    @classmethod
    def known(cls) -> Sequence[str]:
        """Paths of such numbers."""
        return KNOWN

    def __post_init__(self) -> None:
        if not 0 < self.start < self.stop:
            raise problem(
                f"{format_quantity(self.start, self.unit)} to {format_quantity(self.stop, self.unit)}",
                "two positive values, the lower one first", "the bounds contradict each other",
                "exchange them, or leave the parameter out to keep its value", at="to",
            )  # fmt: skip


@described("fit", kw_only=True)
class FitSection:
    """What a measurement is compared with, and what is fitted to it."""

    lowest: Frequency | None = Field(
        default=None, title="Lowest frequency", description="That is compared; else that of the measurement."
    )
    highest: Frequency | None = Field(
        default=None, title="Highest frequency", description="That is compared; else that of the measurement."
    )
    points: Annotated[int, Field(ge=3, le=10_000, strict=True)] = Field(
        default=60, title="Points", description="Whose response is fitted, drawn evenly from all."
    )
    vary: tuple[UnknownSection, ...] = Field(
        default=(), title="Unknowns", description="What is fitted.", max_length=12
    )

    def __post_init__(self) -> None:
        ascending(self.lowest, self.highest, "range")
        once([one.parameter for one in self.vary], "vary")

    @property
    def unknowns(self) -> tuple[Unknown, ...]:
        """As the library computes with them."""
        return tuple(Unknown(one.parameter, one.start, one.stop) for one in self.vary)

    def check(self, plate: Plate | None, absent: Mapping[str, str]) -> None:
        """Refuse unknowns that the study does not give, or whose value lies outside of their bounds.

        ``absent`` says, by name, why the study does not give a number.
        """
        there = {} if plate is None else values_of(plate)
        there = {name: value for name, value in there.items() if name not in absent}
        for number, one in enumerate(self.vary, start=1):
            at = f"fit.vary[{number}]"
            if one.parameter not in there:
                raise problem(
                    one.parameter, f"one of {', '.join(there) or 'none, without a [plate]'}",
                    absent.get(one.parameter, "this study does not give it"),
                    "give it in this study, as the value to begin with, or leave this table out",
                    at=f"{at}.parameter",
                )  # fmt: skip
            value = there[one.parameter]
            low, high = (format_quantity(end, one.unit) for end in (one.start, one.stop))
            if not one.start <= value <= one.stop:
                raise problem(
                    format_quantity(value, one.unit), f"between {low} and {high}",
                    f"the fit begins with {one.parameter} of this study, which its bounds leave out",
                    "widen the bounds, or change the value", at=at,
                )  # fmt: skip
