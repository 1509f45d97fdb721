"""The drive of a scan, and the points that it visits."""

from __future__ import annotations

from haptonic.analyses.analysis import Analysis, NoOptions
from haptonic.results.runner import Runner
from haptonic.results.scan.excitation import Excitation
from haptonic.study.schema import Description


def compute(study: Description, options: NoOptions, runner: Runner) -> Excitation:
    """One period of the drive, and the plan for the study's plate if it has one.

    Raises
    ------
    ScanError : settings that do not fit together
    """
    return Excitation.of(study.scan_settings, study.mounted_plate() if study.finite_plate else None)


ANALYSIS = Analysis(
    name="chirp",
    help="The drive of a scan as WAV, CSV and HDF5, and the points in the order of the stage.",
    result=Excitation,
    compute=compute,
)
