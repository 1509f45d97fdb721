"""How a finite plate vibrates."""

from haptonic.results.plate.compute import compute_plate
from haptonic.results.plate.value import PlateResult

__all__ = ["PlateResult", "compute_plate"]
