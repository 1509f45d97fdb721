from .drawing import part_drawing as part_drawing, write_drawing as write_drawing
from .dxf import write_dxf as write_dxf
from .part import Part as Part
from .step import (
    need_opencascade as need_opencascade,
    solid as solid,
    volume_of_step as volume_of_step,
    write_step as write_step,
)
from .stl import surface as surface, write_stl as write_stl
