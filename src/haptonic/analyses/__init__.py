"""The table of analyses: what can be asked of a study, one file each.

`NAMES` is the one list of them. The command line, ``study.run("bands")``, the report and whatever is to come
read it; a new analysis is a module here with an ``ANALYSIS``, and its name below.
"""

from __future__ import annotations

from importlib import import_module

from haptonic.analyses.analysis import Analysis
from haptonic.errors import StudyError

# in the order of the help; "twin scan" is the module twin_scan
NAMES = (
    "bands",
    "sweep",
    "reproduce",
    "layers",
    "waveguide",
    "design",
    "tolerance",
    "export",
    "plate",
    "feel",
    "chirp",
    "scan",
    "protocol",
    "friction",
    "verdict",
    "twin friction",
    "twin scan",
)


def analysis(name: str) -> Analysis:
    """An analysis by its name; its module is imported now.

    Raises
    ------
    StudyError : there is none of this name
    """
    if name not in NAMES:
        raise StudyError.unknown("name of the analysis", name, NAMES, "there is no such analysis")
    found = import_module(f"haptonic.analyses.{name.replace(' ', '_')}").ANALYSIS
    assert isinstance(found, Analysis), name
    return found


__all__ = ["NAMES", "Analysis", "analysis"]
