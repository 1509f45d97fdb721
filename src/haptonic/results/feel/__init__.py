"""What a finger feels of a plate's vibration."""

from haptonic.results.feel.value import Feel

__all__ = ["Feel"]
