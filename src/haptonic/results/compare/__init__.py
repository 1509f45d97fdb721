"""Two sets of bands beside each other."""

from haptonic.results.compare.sides import BandSet, of_dataset, of_file, of_table, path_in
from haptonic.results.compare.value import Comparison

__all__ = ["BandSet", "Comparison", "of_dataset", "of_file", "of_table", "path_in"]
