"""The tables of the study file about trials: how they are processed, which count, what the sensor says."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from pydantic import AfterValidator, Field

from haptonic.errors import FrictionError, HaptonicError
from haptonic.fields import Name, Quantity, described, problem
from haptonic.friction.recordings import AXES, Exclusion, Sensor, read_calibration
from haptonic.friction.signals import Rules
from haptonic.units import shown, to_si

CALIBRATION = "calibration.csv"  # taken if it lies beside the trials and nothing is said


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


@described("trials.sensor", kw_only=True)
class SensorSection:
    """What the channels of the files are. What is left out is guessed from usual names, and reported."""

    normal: Text = Field(
        default="", title="Normal force", description="Name of its channel; a minus before it turns the sign."
    )
    tangential: Text = Field(default="", title="Tangential force", description="Name of its channel.")
    position: Text = Field(default="", title="Position", description="Name of the channel along the stroke.")
    time: Text = Field(default="", title="Time", description="Name of its channel.")
    force_unit: Annotated[Text, _unit_of("N")] = Field(
        default="", title="Unit of the forces", description="Else the one that the file says, or N."
    )
    position_unit: Annotated[Text, _unit_of("m")] = Field(
        default="", title="Unit of the position", description="Else the one that the file says, or m."
    )
    time_unit: Annotated[Text, _unit_of("s")] = Field(
        default="", title="Unit of the time", description="Else the one that the file says, or s."
    )
    rate: Annotated[float, Quantity("Hz", above=0.0, at_most=1e7, typical=(250.0, 1e5))] | None = Field(
        default=None, title="Sampling rate", description="Where the files have no times."
    )
    gauges: Text = Field(
        default="",
        title="Gauges",
        description="Names of six raw channels, with commas, in the calibration's order.",
    )
    calibration: Text = Field(
        default="",
        title="Calibration",
        description="CSV file of 6 x 6 numbers beside the trials: Fx Fy Fz Tx Ty Tz for 1 V of each gauge; "
        f"else {CALIBRATION} if it is there and the files have no forces.",
    )
    largest_force: Annotated[float, Quantity("N", above=0.0, at_most=1e4)] | None = Field(
        default=None, title="End of the range", description="Force at which a channel is saturated."
    )
    largest_gauge: Annotated[float, Quantity("V", above=0.0, at_most=1e3)] | None = Field(
        default=None, title="End of the gauges", description="Voltage at which a raw channel is saturated."
    )

    def __post_init__(self) -> None:
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

    def frozen(self, folder: Path) -> Sensor:
        """The sensor as the reader uses it; files are looked for in a folder.

        Raises
        ------
        FrictionError : a calibration that is no matrix of full rank
        """
        path = folder / (self.calibration or CALIBRATION)
        plain = {name: one for name, one in vars(self).items() if name not in {"gauges", "calibration"}}
        names = tuple(name.strip() for name in self.gauges.split(",") if name.strip())
        matrix = read_calibration(path) if self.calibration or path.is_file() else None
        return Sensor(**plain, gauges=names, calibration=matrix, forced=bool(self.calibration or names))


@described("trials", FrictionError)
class Trials(Rules):
    """How force records become coefficients of friction, and which trials count."""

    driven: Name | None = Field(
        default=None,
        title="Driven waveguide",
        description="Else the plate's, or the one with the largest reduction.",
    )
    exclude: tuple[Exclusion, ...] = Field(
        default=(), title="Exclusions", description="Trials that do not count.", max_length=1000
    )
    sensor: SensorSection = Field(
        default=SensorSection(), title="Sensor", description="What the channels are."
    )


@described("", kw_only=True)
class TrialsFile:
    """A file that says how trials are processed and nothing else: not every experiment has a lattice."""

    title: str = Field(
        default="Trials",
        title="Title",
        description="Heads the page.",
        max_length=200,
        strict=True,
    )
    trials: Trials = Field(default=Trials(), title="Trials", description="As in a study.")
