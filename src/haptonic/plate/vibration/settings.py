"""Settings of a plate's vibration."""

from __future__ import annotations

from typing import Annotated

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from haptonic.fields import FASTEST, Quantity, ascending, described, setting, size, unchecked

ResponseFrequency = Annotated[float, Quantity("Hz", at_least=1.0, at_most=FASTEST, typical=(1.0, FASTEST))]


@described("plate.response", kw_only=True)
class ResponseSettings:
    """Settings of the plate's vibration."""

    lowest: ResponseFrequency = setting(100.0, "Lower limit of the response.", title="Lowest frequency")
    highest: ResponseFrequency = setting(100e3, "Upper limit of the response.", title="Highest frequency")
    points: Annotated[int, Field(ge=2, le=1_000_001, strict=True)] = setting(
        1001, "Number of frequencies of the response, both ends included.", title="Frequencies"
    )
    tolerance: Annotated[float, Quantity("", at_least=1e-10, at_most=0.1, typical=(1e-8, 1e-2))] = setting(
        1e-3, "Largest allowed relative error of the field at every frequency.", title="Field error"
    )
    grid: Annotated[float, size(1e-9, 20e-3)] = setting(
        2e-3, "Distance of neighbouring points on the flat face."
    )

    def __post_init__(self) -> None:
        ascending(self.lowest, self.highest, "response")

    @property
    def frequencies(self) -> NDArray[np.float64]:
        """(points,) evenly spaced lines of the response, Hz."""
        return np.linspace(self.lowest, self.highest, self.points)

    def single(self, frequency: float) -> ResponseSettings:
        """Restrict the settings to one frequency, Hz."""
        return unchecked(self, lowest=frequency, highest=frequency, points=1)
