"""Files for a workshop: the solid (STEP, STL), its outlines (DXF) and a dimensioned drawing (PDF)."""

from haptonic.workshop.drawing import cell_drawing, write_drawing
from haptonic.workshop.dxf import write_dxf
from haptonic.workshop.step import solid, volume_of_step, write_step
from haptonic.workshop.stl import Surface, surface, write_stl

__all__ = [
    "Surface",
    "cell_drawing",
    "solid",
    "surface",
    "volume_of_step",
    "write_drawing",
    "write_dxf",
    "write_step",
    "write_stl",
]
