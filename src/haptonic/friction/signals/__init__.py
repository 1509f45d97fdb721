"""From force records to a table of trials: filters, steady part, friction, excluded trials and reasons."""

from haptonic.friction.signals.filters import FILTERS, design_frequency, smoothed
from haptonic.friction.signals.measuring import measure
from haptonic.friction.signals.record import Label, Record
from haptonic.friction.signals.rules import OMISSIONS, REASONS, Measured, Rules
from haptonic.friction.signals.tables import read_records, read_trials, write_trials
from haptonic.friction.signals.trials import exclusions, measured

__all__ = [
    "FILTERS",
    "OMISSIONS",
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
