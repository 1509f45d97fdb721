"""The table of analyses: what can be asked of a study, one file each.

`NAMES` is the one list of them. The command line, ``study.run("bands")``, the report and whatever is to come
read it; a new analysis is a module here with an ``ANALYSIS``, and its line below.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

from haptonic.errors import StudyError

if TYPE_CHECKING:  # to list the analyses, none of them and nothing that they need is loaded
    from haptonic.analyses.analysis import Analysis

# name: what it gives, a sentence; in the order of the help. "simulate scan" is the module simulate_scan
NAMES = {
    "plan": "Map and sizes of a study, with time and memory of each command, before anything is computed.",
    "bands": "Band diagram, gaps and mode shapes of the unit cell.",
    "compare": "Bands of two studies or results, or of another program's table over those of a study.",
    "sweep": "Complete gaps along the study's sweeps.",
    "reproduce": "All analyses of the study, and one report that compares them with reference values.",
    "layers": "Insertion loss of rows of cells between plain plates, and the number of rows for the carrier.",
    "waveguide": "Width, length and frequency of a waveguide between two such mirrors.",
    "ribbon": "Waves along columns of cells side by side: projected bands, and modes of guides and edges.",
    "design": "The cell whose gap holds the carrier with the widest margin, within the study's [design].",
    "tolerance": "Probability that the gap contains the carrier, the size that matters most, and the loosest "
    "tolerances.",
    "export": "Files for the workshop, of the plate or a piece of lattice; all of them if none is named. The "
    "drawing has tolerances, or a note that explains why there are none.",
    "plate": "Vibration of the finite plate: response, localisation, energies, impedance, modes.",
    "feel": "Friction under a finger on the plate: a map, reductions, and whether people notice them.",
    "chirp": "The drive of a scan as WAV, CSV and HDF5, and the points in the order of the stage.",
    "scan": "Analysis of a scan: responses, maps, contrast, the gap, waves; and agreement with a model.",
    "protocol": "Order of friction trials: list, printed sheet, metronome, and how many participants are "
    "needed.",
    "friction": "Coefficients of friction from force records, and tests of their reduction.",
    "verdict": "The response of a scan compared again with the model of its plate: new unknowns, no records.",
    "simulate friction": "Strokes of simulated participants, as a folder that `haptonic friction` reads.",
    "simulate scan": "A simulated scan of the study's plate. Everything is marked as simulated.",
}


def named(name: str) -> Analysis:
    """An analysis by its name; its module is imported now.

    Raises
    ------
    StudyError : there is none of this name
    """
    if name not in NAMES:
        raise StudyError.unknown("name of the analysis", name, NAMES, "there is no such analysis")
    found: Analysis = import_module(f"haptonic.analyses.{name.replace(' ', '_')}").ANALYSIS
    return found


__all__ = ["NAMES", "named"]
