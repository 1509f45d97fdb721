"""From the files of an experiment to its trials: table, files of any format, sensor, stream of records."""

from haptonic.friction.recordings.analysis import Analysed, Exclusion, analysed, traces
from haptonic.friction.recordings.sensor import Sensor, read_calibration
from haptonic.friction.recordings.trial_table import TABLE, TrialTable
from haptonic.friction.recordings.understood import Understood, understood

__all__ = [
    "TABLE",
    "Analysed",
    "Exclusion",
    "Sensor",
    "TrialTable",
    "Understood",
    "analysed",
    "read_calibration",
    "traces",
    "understood",
]
