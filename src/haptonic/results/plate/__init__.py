"""How a finite plate vibrates."""

from haptonic.results.plate.compute import compute_plate
from haptonic.results.plate.question import PlateQuestion
from haptonic.results.plate.value import PlateResult

__all__ = ["PlateQuestion", "PlateResult", "compute_plate"]
