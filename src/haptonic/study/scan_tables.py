"""The table of the study file about a scan with a laser vibrometer: its drive, its points, the instrument."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from haptonic.fields import Quantity, described, problem, size
from haptonic.study.asking import Frequency, ascending
from haptonic.units import format_quantity
from haptonic.vibrometry.instrument import Instrument
from haptonic.vibrometry.question import ScanQuestion

Velocity = Annotated[float, Quantity("m/s", above=0.0, at_most=1e3, typical=(1e-7, 10.0))]


@described("scan", kw_only=True)
class ScanSection:
    """How a laser vibrometer scans the plate."""

    lowest: Frequency = Field(
        default=1e3, title="Lowest frequency", description="That the drive sweeps through."
    )
    highest: Frequency = Field(
        default=100e3, title="Highest frequency", description="That the drive sweeps through."
    )
    rate: Annotated[float, Quantity("Hz", at_least=10.0, at_most=1e9, typical=(1e4, 1e7))] = Field(
        default=250e3, title="Sample rate", description="Of drive and vibrometer."
    )
    record: Annotated[float, Quantity("s", above=0.0, at_most=100.0, typical=(1e-3, 2.0))] = Field(
        default=0.02,
        title="Record",
        description="Length of one period of the drive; lines lie its inverse apart.",
    )
    averages: Annotated[int, Field(ge=1, le=10_000, strict=True)] = Field(
        default=4, title="Averages", description="Periods that are recorded at each point."
    )
    signal: Literal["chirp", "multisine"] = Field(
        default="chirp",
        title="Signal",
        description="A periodic sweep, or lines of equal size with low peaks.",
    )
    grid: Annotated[float, size(50e-6, 20e-3)] = Field(
        default=2e-3, title="Grid", description="Distance of neighbouring points on the flat face."
    )
    skip: Annotated[str, Field(max_length=400, strict=True)] = Field(
        default="clamps",
        title="Skip",
        description="Regions or lattices without points, with commas between; clamps: held corners.",
    )
    bits: Annotated[int, Field(ge=4, le=32, strict=True)] = Field(
        default=16, title="Bits", description="Of the converter that records the vibrometer."
    )
    noise: Annotated[float, Quantity("m/s", at_least=0.0, at_most=1e3, typical=(0.0, 1e-2))] = Field(
        default=5e-5, title="Noise", description="Of the vibrometer, root mean square of the samples."
    )
    full_scale: Velocity | None = Field(
        default=None,
        title="Range",
        description="Largest velocity of the vibrometer; else 1.25 of what comes.",
    )
    dropouts: Annotated[float, Quantity("", at_least=0.0, below=1.0, typical=(0.0, 0.1))] = Field(
        default=0.005,
        title="Dropouts",
        description="Share of points at which the laser loses the surface.",
    )
    delay: Annotated[float, Quantity("s", at_least=0.0, at_most=1.0, typical=(0.0, 1e-3))] = Field(
        default=0.0,
        title="Delay",
        description="Of the vibrometer behind the drive; the analysis takes it out.",
    )
    bandwidth: Frequency | None = Field(
        default=None,
        title="Bandwidth",
        description="-3 dB of its first-order low-pass; the analysis takes it out.",
    )

    def __post_init__(self) -> None:
        ascending(self.lowest, self.highest, "sweep")
        if self.highest > 0.5 * self.rate:
            raise problem(
                format_quantity(self.highest, "Hz"),
                f"at most {format_quantity(0.5 * self.rate, 'Hz')}, half the sample rate",
                "higher frequencies cannot be sampled", "lower it, or raise the rate", at="highest",
            )  # fmt: skip
        lines = (self.highest - self.lowest) * self.record
        if not 8 <= lines <= 1e6 or self.rate * self.record > 1e8:
            raise problem(
                format_quantity(self.record, "s"),
                f"a period with 8 to 1e6 lines between the frequencies; here {lines:.3g}",
                "the period was given in another unit", 'write it like record = "20 ms"', at="record",
            )  # fmt: skip

    @property
    def skipped(self) -> tuple[str, ...]:
        """Names of what has no points."""
        return tuple(name for part in self.skip.split(",") if (name := part.strip()))

    def frozen(self) -> ScanQuestion:
        """The scan as the results compute with it."""
        return ScanQuestion(
            lowest=self.lowest, highest=self.highest, rate=self.rate, record=self.record,
            averages=self.averages, signal=self.signal, grid=self.grid, skip=self.skipped,
            instrument=Instrument(
                bits=self.bits, noise=self.noise, full_scale=self.full_scale, dropouts=self.dropouts,
                delay=self.delay, bandwidth=self.bandwidth,
            ),
        )  # fmt: skip
