"""The tables of the study file about trials: how they are processed, which count, what the sensor says."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

from pydantic import AfterValidator, Field, model_validator

from haptonic.errors import HaptonicError
from haptonic.fields import Quantity, Section, problem
from haptonic.friction.recordings import AXES, Exclusion, Sensor, read_calibration
from haptonic.friction.signals import Rules
from haptonic.study.mounting import Name
from haptonic.units import format_quantity, shown, to_si

CALIBRATION = "calibration.csv"  # taken if it lies beside the trials and nothing is said

Share = Annotated[float, Quantity("", at_least=0.01, at_most=1.0)]
Force = Annotated[float, Quantity("N", at_least=0.0, at_most=100.0)]
Speed = Annotated[float, Quantity("m/s", at_least=0.0, at_most=10.0)]


def _unit_of(unit: str) -> AfterValidator:
    """Refuse what is no unit of the same dimension."""

    def checked(text: str) -> str:
        try:
            if text:
                to_si(f"1 {text}", unit, "")
        except HaptonicError as error:
            raise problem(shown(text), f'a unit, such as "m{unit}"', error.cause, error.next_step) from None
        return text

    return AfterValidator(checked)


Text = Annotated[str, Field(max_length=200, strict=True)]


class SensorSection(Section):
    """What the channels of the files are. What is left out is guessed from usual names, and reported."""

    normal: Text = Field(
        "", title="Normal force", description="Name of its channel; a minus before it turns the sign."
    )
    tangential: Text = Field("", title="Tangential force", description="Name of its channel.")
    position: Text = Field("", title="Position", description="Name of the channel along the stroke.")
    time: Text = Field("", title="Time", description="Name of its channel.")
    force_unit: Annotated[Text, _unit_of("N")] = Field(
        "", title="Unit of the forces", description="Else the one that the file says, or N."
    )
    position_unit: Annotated[Text, _unit_of("m")] = Field(
        "", title="Unit of the position", description="Else the one that the file says, or m."
    )
    time_unit: Annotated[Text, _unit_of("s")] = Field(
        "", title="Unit of the time", description="Else the one that the file says, or s."
    )
    rate: Annotated[float, Quantity("Hz", above=0.0, at_most=1e7, typical=(250.0, 1e5))] | None = Field(
        None, title="Sampling rate", description="Where the files have no times."
    )
    gauges: Text = Field(
        "", title="Gauges", description="Names of six raw channels, with commas, in the calibration's order."
    )
    calibration: Text = Field(
        "",
        title="Calibration",
        description="CSV file of 6 x 6 numbers beside the trials: Fx Fy Fz Tx Ty Tz for 1 V of each gauge; "
        f"else {CALIBRATION} if it is there and the files have no forces.",
    )
    largest_force: Annotated[float, Quantity("N", above=0.0, at_most=1e4)] | None = Field(
        None, title="End of the range", description="Force at which a channel is saturated."
    )
    largest_gauge: Annotated[float, Quantity("V", above=0.0, at_most=1e3)] | None = Field(
        None, title="End of the gauges", description="Voltage at which a raw channel is saturated."
    )

    @model_validator(mode="after")
    def _names_six_gauges(self) -> SensorSection:
        names = [name.strip() for name in self.gauges.split(",") if name.strip()]
        if self.gauges and len(set(names)) != 6:
            raise problem(
                shown(self.gauges), "six different names with commas between them",
                f"there are {len(set(names))}", 'write gauges = "G0, G1, G2, G3, G4, G5"', at="gauges",
            )  # fmt: skip
        axes = [name.removeprefix("-").strip() for name in (self.normal, self.tangential) if name]
        if self.calibration and not set(axes) <= set(AXES[:3]):
            raise problem(
                " and ".join(axes), "Fx, Fy or Fz where a calibration makes the forces",
                "the name of a raw channel was given", 'write normal = "Fz"', at="normal",
            )  # fmt: skip
        return self

    def frozen(self, folder: Path) -> Sensor:
        """The sensor as the reader uses it; files are looked for in a folder.

        Raises
        ------
        FrictionError : a calibration that is no matrix of full rank
        """
        path = folder / (self.calibration or CALIBRATION)
        plain = self.model_dump(exclude={"gauges", "calibration"})
        names = tuple(name.strip() for name in self.gauges.split(",") if name.strip())
        matrix = read_calibration(path) if self.calibration or path.is_file() else None
        return Sensor(**plain, gauges=names, calibration=matrix, forced=bool(self.calibration or names))


class ExcludeSection(Section):
    """Trials that do not count, declared before the data are seen."""

    participant: Name = Field(title="Participant", description="As the table of trials calls him or her.")
    block: Annotated[int, Field(ge=1, le=10**6, strict=True)] | None = Field(
        None, title="Block", description="Else all blocks."
    )
    trial: Annotated[int, Field(ge=1, le=10**6, strict=True)] | None = Field(
        None, title="Trial", description="Of the block; else all its trials."
    )
    reason: Annotated[str, Field(min_length=1, max_length=200, strict=True)] = Field(
        title="Reason", description="Stands beside the trial in every table."
    )

    @model_validator(mode="after")
    def _names_a_block(self) -> ExcludeSection:
        if self.trial is not None and self.block is None:
            raise problem(
                f"trial {self.trial} of no block", "the block as well", "trials count within a block",
                "add block = 1", at="block",
            )  # fmt: skip
        return self

    def frozen(self) -> Exclusion:
        """The exclusion as the analysis knows it."""
        return Exclusion(self.participant, self.reason, self.block, self.trial)


class TrialsSection(Section):
    """How force records become coefficients of friction, and which trials count."""

    filter: Literal["literal", "compensated", "none"] = Field(
        "literal",
        title="Filter",
        description="Two poles at 50 Hz, run both ways: as published (-6 dB there), or -3 dB there, or none.",
    )
    bias_window: Annotated[float, Quantity("s", at_least=0.0, at_most=10.0)] = Field(
        0.1, title="Window of the bias", description="At the start, without contact; 0 subtracts nothing."
    )
    threshold: Annotated[float, Quantity("N", at_least=1e-3, at_most=10.0)] = Field(
        0.1, title="Threshold", description="Normal force from which there is contact."
    )
    plateau: Share = Field(
        0.5, title="Plateau", description="How far the speed may be from its median, as a share of it."
    )
    middle: Share = Field(
        0.6, title="Middle", description="Share of the contact that counts where no position was recorded."
    )
    steady: Annotated[float, Quantity("s", at_least=0.01, at_most=60.0)] = Field(
        0.1, title="Steady part", description="Shortest time that has to be left."
    )
    force: tuple[Force, Force] = Field(
        (0.1, 5.0), title="Force", description="Lowest and highest mean normal force of a trial that counts."
    )
    speed: tuple[Speed, Speed] = Field(
        (0.01, 0.5), title="Speed", description="Lowest and highest mean speed of a trial that counts."
    )
    driven: Name | None = Field(
        None, title="Driven waveguide", description="Else the plate's, or the one with the largest reduction."
    )
    exclude: tuple[ExcludeSection, ...] = Field(
        (), title="Exclusions", description="Trials that do not count.", max_length=1000
    )
    sensor: SensorSection = Field(SensorSection(), title="Sensor", description="What the channels are.")

    @model_validator(mode="after")
    def _ascends(self) -> TrialsSection:
        for name, unit in (("force", "N"), ("speed", "m/s")):
            low, high = getattr(self, name)
            if not low < high:
                raise problem(
                    f"{format_quantity(low, unit)}, {format_quantity(high, unit)}", "the lower limit first",
                    "the limits are exchanged or equal", "exchange them", at=name,
                )  # fmt: skip
        return self

    def rules(self) -> Rules:
        """The rules as the analysis uses them."""
        return Rules(**self.model_dump(exclude={"driven", "exclude", "sensor"}))

    def exclusions(self) -> tuple[Exclusion, ...]:
        """The declared exclusions."""
        return tuple(one.frozen() for one in self.exclude)


class TrialsFile(Section):
    """A file that says how trials are processed and nothing else: not every experiment has a lattice."""

    title: str = Field("Trials", title="Title", description="Heads the page.", max_length=200, strict=True)
    trials: TrialsSection = Field(TrialsSection(), title="Trials", description="As in a study.")
