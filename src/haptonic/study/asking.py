"""The tables of the study file that ask for more than bands: a mirror, a design, its tolerances."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Annotated, Literal

from pydantic import Field, ValidationInfo, field_validator

from haptonic.design.brief import Finger
from haptonic.design.parameters import UNITS
from haptonic.design.tolerance import Spread
from haptonic.errors import nearest
from haptonic.fields import LARGEST, SMALLEST, Quantity, described, number_of, problem
from haptonic.units import format_quantity, shown

Frequency = Annotated[float, Quantity("Hz", at_least=1.0, at_most=1e9, typical=(1e3, 1e6))]
Length = Annotated[float, Quantity("m", at_least=SMALLEST, at_most=LARGEST)]


def ascending(lowest: float | None, highest: float | None, what: str) -> None:
    """Refuse two ends of a range of frequencies, Hz, in the wrong order."""
    if lowest is not None and highest is not None and lowest >= highest:
        raise problem(
            format_quantity(highest, "Hz"),
            f"more than the lowest frequency, {format_quantity(lowest, 'Hz')}",
            f"the two ends of the {what} are exchanged or equal",
            "exchange them",
            at="highest",
        )


@described("layers", kw_only=True)
class LayersSection:
    """What is asked of a mirror of several rows of cells between two plates."""

    count: Annotated[int, Field(ge=1, le=20, strict=True)] = Field(
        default=6, title="Rows", description="The most that are computed; all fewer ones are as well."
    )
    lowest: Frequency | None = Field(
        default=None, title="Lowest frequency", description="Of the spectrum; else 0.6 of the carrier."
    )
    highest: Frequency | None = Field(
        default=None, title="Highest frequency", description="Of the spectrum; else 1.4 of the carrier."
    )
    points: Annotated[int, Field(ge=2, le=5000, strict=True)] = Field(
        default=161, title="Frequencies", description="In the spectrum, both ends included."
    )
    angle: Annotated[float, Quantity("rad", at_least=0.0, below=0.5 * math.pi, typical=(0.0, 1.5))] = Field(
        default=0.0,
        title="Angle of incidence",
        description="Between the incident wave and the normal of the rows.",
    )

    def __post_init__(self) -> None:
        ascending(self.lowest, self.highest, "spectrum")


@described("waveguide", kw_only=True)
class WaveguideSection:
    """A strip of plain plate between two mirrors."""

    mode: str = Field(
        default="0x17",
        title="Mode",
        description="Nodal lines across the strip, and intervals between nodal lines along it.",
        pattern=r"^[0-9]{1,2}x[0-9]{1,3}$",
    )
    width: Length | None = Field(
        default=None,
        title="Width",
        description="Of the plain strip; else the one that puts the mode at the carrier.",
    )
    rows: Annotated[int, Field(ge=1, le=1000, strict=True)] | None = Field(
        default=None, title="Length in cells", description="Of the strip; else several are compared."
    )
    ends: Literal["free", "mirror"] = Field(
        default="free",
        title="Ends",
        description="Of the strip: edges of the plate, or closed by the mirror as well.",
    )

    @property
    def nodal_lines(self) -> tuple[int, int]:
        """Nodal lines across, and intervals along."""
        across, along = self.mode.split("x")
        return int(across), int(along)


def once(names: Sequence[str], at: str) -> None:
    """Refuse a parameter that two tables are about."""
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        raise problem(
            f"{twice[0]}, twice", "every parameter once", "a table was copied", "remove one of them", at=at
        )


@described("", kw_only=True)
class OfNumber:
    """A table about one number of the study; others of its values are in the unit of that number."""

    parameter: str = Field(
        title="Parameter",
        description="By its name in this file; tables of one name count from 1.",
        strict=True,
    )

    @classmethod
    def unit_of(cls, path: str) -> str | None:
        """SI unit of a number that the table can be about: one of the cell; None of any other."""
        return UNITS.get(path)

    @classmethod
    def known(cls) -> Sequence[str]:
        """Paths of such numbers."""
        return tuple(UNITS)

    @field_validator("parameter")
    @classmethod
    def _known(cls, path: str) -> str:
        if cls.unit_of(path) is None:
            guess = nearest(path, cls.known())
            raise problem(
                shown(path),
                f"one of {', '.join(cls.known())}",
                "no number of this name can be changed here",
                f'write "{guess}"' if guess else "choose one of the list",
            )
        return path

    @field_validator("start", "stop", "spread", mode="plain", check_fields=False)
    @classmethod
    def _in_its_unit(cls, value: object, info: ValidationInfo) -> float:
        if "parameter" not in info.data:  # refused already; without it the unit is not known
            return 0.0
        return number_of(value, cls.unit_of(info.data["parameter"]) or "", info.context)

    @property
    def unit(self) -> str:
        """SI unit of the number; empty when it is dimensionless."""
        return self.unit_of(self.parameter) or ""


@described("design.vary", kw_only=True)
class VarySection(OfNumber):
    """A number of the cell that the design may change."""

    start: float = Field(alias="from", title="Lowest value", description="With its unit, if it has one.")
    stop: float = Field(alias="to", title="Highest value", description="With its unit, if it has one.")

    def __post_init__(self) -> None:
        if not self.start < self.stop:
            raise problem(
                format_quantity(self.stop, self.unit),
                f"more than the lowest value, {format_quantity(self.start, self.unit)}",
                "the bounds contradict each other",
                "exchange them, or leave the parameter out to keep its value",
                at="to",
            )


@described("design", kw_only=True)
class DesignSection:
    """What a design may change, and what the workshop and the finger allow."""

    vary: tuple[VarySection, ...] = Field(
        default=(), title="Parameters", description="What the design may change.", max_length=12
    )
    starts: Annotated[int, Field(ge=1, le=1024, strict=True)] = Field(
        default=48,
        title="Starts",
        description="Designs, the study's own among them, that are looked at first.",
    )
    climbs: Annotated[int, Field(ge=1, le=64, strict=True)] = Field(
        default=3,
        title="Climbs",
        description="How many of the best starts are improved; more while none reaches the carrier.",
    )
    steps: Annotated[int, Field(ge=1, le=200, strict=True)] = Field(
        default=12, title="Steps", description="Designs computed in each climb at most."
    )
    slenderness: Annotated[float, Quantity("", at_least=0.1, at_most=100.0, typical=(1.0, 10.0))] | None = (
        Field(default=None, title="Slenderness", description="Largest height of a pillar over its diameter.")
    )
    tool: Length | None = Field(
        default=None, title="End mill", description="Its diameter: the least gap between two pillars."
    )
    reach: Length | None = Field(
        default=None,
        title="Reach",
        description="How deep the end mill can cut: the largest height of a pillar.",
    )
    finger_force: Annotated[float, Quantity("N", above=0.0, at_most=1e3, typical=(0.1, 20.0))] | None = Field(
        default=None, title="Force of a finger", description="In the middle of a waveguide of the span given."
    )
    finger_span: Length | None = Field(
        default=None, title="Span", description="Width of the waveguide that bears the finger."
    )
    finger_deflection: Length | None = Field(
        default=None, title="Deflection", description="How far the plate may give way; limits its thickness."
    )
    pitches: Annotated[int, Field(ge=2, le=40, strict=True)] = Field(
        default=6,
        title="Pitches",
        description="How many are compared between the bounds of the pitch for the front.",
    )

    def __post_init__(self) -> None:
        once([one.parameter for one in self.vary], "vary")
        given = (self.finger_force, self.finger_span, self.finger_deflection)
        if None in given and given != (None, None, None):
            raise problem(
                "only some of finger_force, finger_span and finger_deflection",
                "all three of them, or none",
                "one of them was left out",
                "add the others",
                at="finger_force",
            )

    @property
    def finger(self) -> Finger | None:
        """What the plate has to bear."""
        if self.finger_force is None or self.finger_span is None or self.finger_deflection is None:
            return None
        return Finger(self.finger_force, self.finger_span, self.finger_deflection)


@described("tolerance.of", kw_only=True)
class SpreadSection(OfNumber):
    """How much a number of the cell differs from one plate, or one pillar, to the next."""

    spread: float = Field(
        title="Spread", description="Standard deviation of a normal, half-width of a uniform distribution."
    )
    distribution: Literal["normal", "uniform"] = Field(
        default="normal", title="Distribution", description="Normal ones are cut off at three deviations."
    )
    per: Literal["batch", "pillar"] = Field(
        default="batch",
        title="Per",
        description="Whether all pillars of a plate differ alike, or each by itself.",
    )

    def frozen(self) -> Spread:
        """The spread as the core computes with it."""
        return Spread(self.parameter, self.spread, self.distribution, self.per)

    def __post_init__(self) -> None:
        if not self.spread > 0:
            raise problem(
                format_quantity(self.spread, self.unit), "a positive spread",
                "it is zero or has the wrong sign", "give a positive one, or leave it out", at="spread",
            )  # fmt: skip
        if self.per == "pillar" and not self.parameter.startswith("cell.pillar."):
            raise problem(
                self.parameter, 'per = "batch" for whatever is not of the pillar',
                "pillars of one plate have it in common", 'write per = "batch"', at="per",
            )  # fmt: skip


@described("tolerance", kw_only=True)
class ToleranceSection:
    """How much the parts differ, and how sure the gap has to hold the carrier."""

    of: tuple[SpreadSection, ...] = Field(
        default=(), title="Spreads", description="What differs, and how much.", max_length=12
    )
    margin: Annotated[float, Quantity("Hz", at_least=0.0, at_most=1e9)] = Field(
        default=0.0, title="Margin", description="Least distance of the carrier from the gap's edges."
    )
    confidence: Annotated[float, Quantity("", above=0.0, below=1.0, typical=(0.9, 0.9999))] = Field(
        default=0.99, title="Confidence", description="Share of plates that have to keep the margin."
    )
    pillars: Annotated[int, Field(ge=1, le=10**7, strict=True)] = Field(
        default=180, title="Pillars", description="On a plate; each of them has to keep the margin."
    )
    samples: Annotated[int, Field(ge=16, le=4096, strict=True)] = Field(
        default=64, title="Samples", description="Designs that are computed."
    )

    def __post_init__(self) -> None:
        once([one.parameter for one in self.of], "of")
