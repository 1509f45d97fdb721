"""Vibration of a finite plate."""

from haptonic.results.plate.value import PlateResult

__all__ = ["PlateResult"]
