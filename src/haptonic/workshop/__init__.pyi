from .drawing import cell_drawing, write_drawing
from .dxf import write_dxf
from .step import solid, volume_of_step, write_step
from .stl import surface, write_stl

__all__ = [
    "cell_drawing",
    "solid",
    "surface",
    "volume_of_step",
    "write_drawing",
    "write_dxf",
    "write_step",
    "write_stl",
]
