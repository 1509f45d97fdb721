"""The table of analyses; each is a module of this package.

`NAMES` is their only list. The command line, ``study.run("bands")`` and the report read it. A new analysis
needs a module here with an ``ANALYSIS``, and a line in `NAMES`. `SYNONYMS` has words that are
refused with the name of an analysis.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

from haptonic.errors import StudyError

if TYPE_CHECKING:  # the table of names imports no analysis, and none of its libraries
    from haptonic.analyses.analysis import Analysis

# name: result, in one sentence, in the order of the help. "simulate scan" is the module simulate_scan
NAMES = {
    "plan": "Map of the plate and time and memory of each command, before anything is computed.",
    "bands": "Band diagram, gaps and mode shapes of the unit cell.",
    "compare": "Bands of two studies or results, or of another program's table over those of a study.",
    "sweep": "Complete gaps along the study's sweeps.",
    "reproduce": "All analyses of the study, and one report that compares them with reference values.",
    "layers": "Insertion loss of rows of cells between plain plates, and the number of rows for the carrier.",
    "waveguide": "Width, length and frequency of a waveguide between two mirrors of cells.",
    "ribbon": "Waves along columns of cells side by side: projected bands, and modes of guides and edges.",
    "design": "The cell whose gap contains the carrier with the widest margin, within the study's [design].",
    "tolerance": "Probability that the gap contains the carrier, the size that matters most, and the loosest "
    "tolerances.",
    "export": "Files for the workshop, of the plate or a piece of lattice; all of them if none is named. The "
    "drawing has tolerances, or a note that explains why there are none.",
    "plate": "Vibration of the finite plate: response, localisation, energies, impedance, modes.",
    "feel": "Friction under a finger on the plate: a map, reductions, and whether people notice them.",
    "chirp": "The drive of a scan as WAV, CSV and HDF5, and its points in the order of measurement.",
    "scan": "Analysis of a scan: responses, maps, contrast, the gap, waves; and agreement with a model.",
    "protocol": "Order of friction trials: list, printed sheet, metronome, and how many participants are "
    "needed.",
    "friction": "Coefficients of friction from force records, and tests of their reduction.",
    "verdict": "Comparison of a measured response with the model, with chosen numbers fitted to it.",
    "simulate friction": "Strokes of simulated participants, as a folder that `haptonic friction` reads.",
    "simulate scan": "A simulated scan of the study's plate. Everything is marked as simulated.",
}

SYNONYMS = {  # word that people try: name of its analysis
    "report": "reproduce",
    "gap": "bands",
    "gaps": "bands",
    "dispersion": "bands",
    "optimize": "design",
    "optimise": "design",
}


def named(name: str) -> Analysis:
    """Import the module of an analysis and return its record.

    Raises
    ------
    StudyError : no analysis has this name
    """
    if name not in NAMES:
        meant = SYNONYMS.get(name)
        raise StudyError.unknown(
            "name of the analysis", name, NAMES, "no analysis has this name", slip=meant is None,
            next_step=f'write "{meant}"' if meant else "choose one of these",
        )  # fmt: skip
    analysis: Analysis = import_module(f"haptonic.analyses.{name.replace(' ', '_')}").ANALYSIS
    return analysis


__all__ = ["NAMES", "SYNONYMS", "named"]
