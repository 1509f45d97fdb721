"""How a finite plate vibrates."""

from haptonic.results.plate.value import PlateResult

__all__ = ["PlateResult"]
