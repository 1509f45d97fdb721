"""From force records to a table of trials: filters, steady part, friction, and what was left out and why."""

from haptonic.friction.signals.filters import FILTERS, design_frequency, smoothed
from haptonic.friction.signals.measuring import REASONS, Measured, Rules, exclusions, measure, measured
from haptonic.friction.signals.record import Label, Record
from haptonic.friction.signals.tables import read_records, read_trials, write_trials

__all__ = [
    "FILTERS",
    "REASONS",
    "Label",
    "Measured",
    "Record",
    "Rules",
    "design_frequency",
    "exclusions",
    "measure",
    "measured",
    "read_records",
    "read_trials",
    "smoothed",
    "write_trials",
]
