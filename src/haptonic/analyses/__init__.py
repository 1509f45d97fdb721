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
    "plan": "What a study describes, its map and sizes, and what each command will cost, before anything is "
    "computed.",
    "bands": "Band diagram, gaps and mode shapes of the unit cell.",
    "compare": "Bands of two studies or results beside each other, or of another program's table over ours.",
    "sweep": "Complete gaps along the study's sweeps.",
    "reproduce": "Everything the study describes, and one report that sets it beside reference values.",
    "layers": "What rows of cells let through between two plain plates, and how many of them the carrier "
    "needs.",
    "waveguide": "Width, length and frequency of a waveguide between two such mirrors.",
    "ribbon": "Waves along columns of cells side by side: projected bands, and what a guide or edge holds.",
    "design": "The cell whose gap holds the carrier with the widest margin, within the study's [design].",
    "tolerance": "The chance that the gap holds the carrier, the size that matters most, and the loosest "
    "tolerances.",
    "export": "Files for the workshop, of the plate or a piece of lattice; all of them if none is named. The "
    "drawing has the tolerances found, or says why not.",
    "plate": "How the finite plate vibrates: response, localisation, energies, impedance, modes.",
    "feel": "What a finger feels of the plate: a map of friction, reductions, whether they are noticed.",
    "chirp": "The drive of a scan as WAV, CSV and HDF5, and the points in the order of the stage.",
    "scan": "Analyse a scan: responses, maps, contrast, the gap in it, waves; and how well a model fits.",
    "protocol": "Order of friction trials: list, printed sheet, metronome, and how many participants are "
    "needed.",
    "friction": "Coefficients of friction from force records, and what they prove.",
    "verdict": "A response that a scan has given, once more against its plate's model: new unknowns, no "
    "records.",
    "simulate friction": "Made-up strokes of made-up people, as a folder that `haptonic friction` reads; all "
    "simulated.",
    "simulate scan": "What a laser vibrometer would record of the study's plate. Everything is marked as "
    "simulated.",
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
