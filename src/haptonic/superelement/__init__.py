"""One superelement, many uses: K and M of a cell condensed onto its lateral faces."""

from haptonic.superelement.condense import Superelement, condense
from haptonic.superelement.counting import DynamicStiffness, dynamic_stiffness

__all__ = ["DynamicStiffness", "Superelement", "condense", "dynamic_stiffness"]
