"""Designs that a search has found, with all that it has seen on the way."""

from haptonic.results.design.front import compute_front
from haptonic.results.design.search import compute_design
from haptonic.results.design.value import Design

__all__ = ["Design", "compute_design", "compute_front"]
