from .bands import Bands as Bands
from .common import refuse_taken as refuse_taken, write_files as write_files, write_netcdf as write_netcdf
from .design import Design as Design
from .feel import Feel as Feel
from .friction import FrictionResult as FrictionResult
from .guides import Guides as Guides
from .layers import Layers as Layers
from .plate import PlateResult as PlateResult
from .protocol import TrialPlan as TrialPlan
from .result import Result as Result
from .ribbon import RibbonWaves as RibbonWaves
from .simulated_trials import SimulatedFriction as SimulatedFriction
from .sweeps import Sweep as Sweep, Sweeps as Sweeps
from .table import Column as Column, Table as Table, Uncertain as Uncertain
from .tolerance import Tolerance as Tolerance
from .verdict import Verdict as Verdict
