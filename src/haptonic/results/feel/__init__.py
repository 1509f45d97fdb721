"""What a finger feels of a plate's vibration."""

from haptonic.results.feel.loading import compute_loaded
from haptonic.results.feel.value import Feel

__all__ = ["Feel", "compute_loaded"]
