"""Settings of a scan with a laser vibrometer: drive, points, instrument."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from haptonic.fields import INLINE, Frequency, Quantity, ascending, described, problem, setting, size
from haptonic.units import format_quantity
from haptonic.vibrometry.chirp import Kind
from haptonic.vibrometry.instrument import Instrument

CLAMPS = "clamps"  # name for all clamped corners


@described("scan", kw_only=True)
class ScanSettings:
    """Settings of a scan of the plate with a laser vibrometer."""

    lowest: Frequency = setting(1e3, "Lower end of the drive's band.", title="Lowest frequency")
    highest: Frequency = setting(100e3, "Upper end of the drive's band.", title="Highest frequency")
    rate: Annotated[float, Quantity("Hz", at_least=10.0, at_most=1e9, typical=(1e4, 1e7))] = setting(
        250e3, "Sample rate of drive and vibrometer.", title="Sample rate"
    )
    record: Annotated[float, Quantity("s", above=0.0, at_most=100.0, typical=(1e-3, 2.0))] = setting(
        0.02, "Length of one period of the drive; its inverse is the line spacing."
    )
    averages: Annotated[int, Field(ge=1, le=10_000, strict=True)] = setting(
        4, "Periods that are recorded at each point."
    )
    signal: Kind = setting("chirp", "A periodic sweep, or lines of equal size with low peaks.")
    grid: Annotated[float, size(50e-6, 20e-3)] = setting(
        2e-3, "Distance of neighbouring points on the flat face."
    )
    skip: Annotated[str, Field(max_length=400, strict=True)] = setting(
        CLAMPS, "Regions or lattices without points, with commas between; clamps: clamped corners."
    )
    instrument: Annotated[Instrument, INLINE] = setting(Instrument(), "The vibrometer and its converter.")

    def __post_init__(self) -> None:
        ascending(self.lowest, self.highest, "sweep")
        if self.highest > 0.5 * self.rate:
            raise problem(
                "out-of-range",
                format_quantity(self.highest, "Hz"),
                f"at most {format_quantity(0.5 * self.rate, 'Hz')}, half the sample rate",
                "higher frequencies cannot be sampled",
                "lower it, or raise the rate",
                at="highest",
            )
        if not 8 <= self.lines <= 1e6 or self.rate * self.record > 1e8:
            raise problem(
                "out-of-range",
                format_quantity(self.record, "s"),
                f"a period with 8 to 1e6 lines between the frequencies; here {self.lines:.3g}",
                "the period was given in another unit",
                'write it like record = "20 ms"',
                at="record",
            )

    @property
    def lines(self) -> float:
        """Approximate number of lines of its spectrum between the two frequencies."""
        return (self.highest - self.lowest) * self.record
