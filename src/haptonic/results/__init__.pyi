from .bands import Bands, compute_bands
from .common import refuse_taken, write_files, write_netcdf
from .design import Design, compute_design, compute_front
from .feel import Feel
from .friction import FrictionResult, compute_friction
from .guides import Guides, compute_guides
from .layers import Layers, compute_layers
from .plate import PlateResult, compute_plate
from .protocol import TrialPlan
from .result import Result
from .ribbon import RibbonWaves
from .runner import Runner, design_gaps
from .simulated_trials import SimulatedFriction, simulated_friction
from .sweeps import Sweep, Sweeps
from .table import Column, Table, Uncertain
from .tolerance import Tolerance
from .verdict import Verdict

__all__ = [
    "Bands",
    "Column",
    "Design",
    "Feel",
    "FrictionResult",
    "Guides",
    "Layers",
    "PlateResult",
    "Result",
    "RibbonWaves",
    "Runner",
    "SimulatedFriction",
    "Sweep",
    "Sweeps",
    "Table",
    "Tolerance",
    "TrialPlan",
    "Uncertain",
    "Verdict",
    "compute_bands",
    "compute_design",
    "compute_friction",
    "compute_front",
    "compute_guides",
    "compute_layers",
    "compute_plate",
    "design_gaps",
    "refuse_taken",
    "simulated_friction",
    "write_files",
    "write_netcdf",
]
