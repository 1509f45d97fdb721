from .drawing import cell_drawing as cell_drawing
from .drawing import write_drawing as write_drawing
from .dxf import write_dxf as write_dxf
from .step import solid as solid
from .step import volume_of_step as volume_of_step
from .step import write_step as write_step
from .stl import surface as surface
from .stl import write_stl as write_stl
