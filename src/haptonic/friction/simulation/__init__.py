"""Simulated experiment: force records of strokes with a known friction, for testing the analysis.

All its results are labelled as simulated.
"""

from haptonic.friction.simulation.film import Film, explaining, film_of
from haptonic.friction.simulation.strokes import Experiment, Stroke, recorded, strokes
from haptonic.friction.simulation.truth import Person, Trial, Truth, coefficients, people, trials

__all__ = [
    "Experiment",
    "Film",
    "Person",
    "Stroke",
    "Trial",
    "Truth",
    "coefficients",
    "explaining",
    "film_of",
    "people",
    "recorded",
    "strokes",
    "trials",
]
