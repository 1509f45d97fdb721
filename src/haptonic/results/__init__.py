"""What a run gives back: values that can be asked, drawn and written, each with the inputs that made it."""

from haptonic.results.bands import Bands, compute_bands, gap_json
from haptonic.results.common import Asked, refuse_taken, write_files, write_netcdf
from haptonic.results.design import Design, compute_design, compute_front, planned
from haptonic.results.guides import Guides, compute_guides
from haptonic.results.judging import VerdictQuestion, compute_verdict
from haptonic.results.layers import Layers, compute_layers, layer_tasks
from haptonic.results.plate import PlateQuestion, PlateResult, compute_plate
from haptonic.results.runner import Runner
from haptonic.results.sweeps import Row, Sweep, compute_sweeps, design_gaps
from haptonic.results.tolerance import Tolerance, compute_tolerance
from haptonic.results.verdict import Verdict

__all__ = [
    "Asked",
    "Bands",
    "Design",
    "Guides",
    "Layers",
    "PlateQuestion",
    "PlateResult",
    "Row",
    "Runner",
    "Sweep",
    "Tolerance",
    "Verdict",
    "VerdictQuestion",
    "compute_bands",
    "compute_design",
    "compute_front",
    "compute_guides",
    "compute_layers",
    "compute_plate",
    "compute_sweeps",
    "compute_tolerance",
    "compute_verdict",
    "design_gaps",
    "gap_json",
    "layer_tasks",
    "planned",
    "refuse_taken",
    "write_files",
    "write_netcdf",
]
