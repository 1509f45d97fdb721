"""Settings of a fit: unknown numbers of a plate, and the part of the measurement to fit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Annotated

from pydantic import Field

from haptonic.fields import Frequency, NumberRange, ascending, described, once, problem, setting
from haptonic.plate import Plate
from haptonic.units import format_quantity
from haptonic.updating.parameters import UNITS, YOUNG, unit_of, values_of

KNOWN = (*UNITS, "plate.actuator[1].bond.thickness")


@described("fit.vary")
class Unknown(NumberRange):
    """A number that is fitted to a measurement, starting from the plate's value."""

    @classmethod
    def unit_of(cls, path: str) -> str | None:
        """SI unit of a number of a plate that can be fitted; None for other paths."""
        return unit_of(path)

    @classmethod
    def known(cls) -> Sequence[str]:
        """Paths of the numbers that can be fitted."""
        return KNOWN

    def __post_init__(self) -> None:
        if not 0 < self.low < self.high:
            raise problem(
                "conflict",
                f"{format_quantity(self.low, self.unit)} to {format_quantity(self.high, self.unit)}",
                "two positive values, the lower one first",
                "the bounds contradict each other",
                "exchange them, or leave the parameter out to keep its value",
                at="to",
            )


@described("fit", kw_only=True)
class FitSettings:
    """Range of a measurement that is compared, and numbers that are fitted to it."""

    lowest: Frequency | None = setting(
        None, "Start of the compared range; by default that of the measurement.", title="Lowest frequency"
    )
    highest: Frequency | None = setting(
        None, "End of the compared range; by default that of the measurement.", title="Highest frequency"
    )
    points: Annotated[int, Field(ge=3, le=10_000, strict=True)] = setting(
        60, "Number of points whose response is fitted, drawn evenly from all."
    )
    vary: tuple[Unknown, ...] = setting((), "Numbers to fit.", title="Unknowns", max_length=12)

    def __post_init__(self) -> None:
        ascending(self.lowest, self.highest, "range")
        once(self.vary, "vary")

    def check(self, plate: Plate | None, absent: Mapping[str, str]) -> None:
        """Refuse unknowns that are missing in a study, or whose value lies outside of their bounds.

        ``absent`` gives, by name, the reason for a missing number.
        """
        of_plate = {} if plate is None else values_of(plate)
        given = {name: value for name, value in of_plate.items() if name not in absent}
        for number, unknown in enumerate(self.vary, start=1):
            at, name = f"fit.vary[{number}]", unknown.parameter
            if name not in given:
                cause = absent.get(name, "this study does not give it")
                next_step = "give it in this study, as the value to begin with, or leave this table out"
                if name == YOUNG and plate is not None and name not in of_plate:
                    cause = "a modulus is fitted only to a plate of a single isotropic material"
                    next_step = (
                        "leave this table out; constants of crystals and of several materials are kept"
                    )
                raise problem("missing", name, "a number of this study", cause, next_step, f"{at}.parameter")
            value = given[name]
            low, high = (format_quantity(end, unknown.unit) for end in (unknown.low, unknown.high))
            if not unknown.low <= value <= unknown.high:
                raise problem(
                    "conflict",
                    format_quantity(value, unknown.unit),
                    f"between {low} and {high}",
                    f"the fit begins with {name} of this study, which its bounds leave out",
                    "widen the bounds, or change the value",
                    at=at,
                )
