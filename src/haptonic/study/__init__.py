"""The study file: read, checked, written; one immutable value for everything that a run computes with."""

from haptonic.study.keys import Key, table
from haptonic.study.loading import load, load_trials, loads
from haptonic.study.plate_tables import PlateSection
from haptonic.study.runs import Study
from haptonic.study.scan_tables import ScanSection
from haptonic.study.schema import SweepSection
from haptonic.study.sections import BandsSection, CellSection, MaterialSection, MeshSection, PillarSection
from haptonic.study.trial_tables import TrialsSection
from haptonic.study.vary import solve

__all__ = [
    "BandsSection",
    "CellSection",
    "Key",
    "MaterialSection",
    "MeshSection",
    "PillarSection",
    "PlateSection",
    "ScanSection",
    "Study",
    "SweepSection",
    "TrialsSection",
    "load",
    "load_trials",
    "loads",
    "solve",
    "table",
]
