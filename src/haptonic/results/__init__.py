"""What a run gives back: values that can be asked, drawn and written, each with the inputs that made it."""

from haptonic.results.bands import Bands, compute_bands, gap_json
from haptonic.results.common import Asked, refuse_taken, write_files, write_netcdf
from haptonic.results.design import Design, compute_design, compute_front, planned
from haptonic.results.feel import Feel, Pad, compute_loaded
from haptonic.results.friction import FrictionResult, compute_friction
from haptonic.results.guides import Guides, compute_guides
from haptonic.results.judging import VerdictQuestion, compute_verdict
from haptonic.results.layers import Layers, compute_layers, layer_tasks
from haptonic.results.plate import PlateQuestion, PlateResult, compute_plate
from haptonic.results.protocol import Plan, Task, compute_plan
from haptonic.results.runner import Runner
from haptonic.results.sweeps import Row, Sweep, compute_sweeps, design_gaps
from haptonic.results.tolerance import Tolerance, compute_tolerance
from haptonic.results.twin import FrictionTwin, friction_twin
from haptonic.results.verdict import Verdict

__all__ = [
    "Asked",
    "Bands",
    "Design",
    "Feel",
    "FrictionResult",
    "FrictionTwin",
    "Guides",
    "Layers",
    "Pad",
    "Plan",
    "PlateQuestion",
    "PlateResult",
    "Row",
    "Runner",
    "Sweep",
    "Task",
    "Tolerance",
    "Verdict",
    "VerdictQuestion",
    "compute_bands",
    "compute_design",
    "compute_friction",
    "compute_front",
    "compute_guides",
    "compute_layers",
    "compute_loaded",
    "compute_plan",
    "compute_plate",
    "compute_sweeps",
    "compute_tolerance",
    "compute_verdict",
    "design_gaps",
    "friction_twin",
    "gap_json",
    "layer_tasks",
    "planned",
    "refuse_taken",
    "write_files",
    "write_netcdf",
]
