"""Outlines seen from above as a DXF file, in mm: what a milling program is made from in two dimensions."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import ezdxf
import numpy as np
from ezdxf.document import Drawing
from ezdxf.layouts import Modelspace

from haptonic.cell import UnitCell
from haptonic.store import refuse_overwrite, write_atomically
from haptonic.workshop.shape import Array, centres, corner_grid, in_mm, plate_outline

MILLIMETRES = 4  # code of the header variable $INSUNITS
MARK = 0.1  # half the length of a centre mark, in diameters of the pillar

# layer: colour of AutoCAD's table
LAYERS = {"PLATE": 7, "CELL": 8, "PILLAR": 1, "FILLET": 3, "STEP": 5, "CENTRE": 2}


def write_dxf(
    path: Path, cell: UnitCell, columns: int = 1, rows: int = 1, *, overwrite: bool = False
) -> Path:
    """Write the outlines of a plate of ``columns`` x ``rows`` cells; the same plate is the same file.

    Layers: PLATE its outline, CELL the borders of its cells, PILLAR the pillars at their foot without the
    fillet, FILLET where fillets meet the plate, STEP the pillars above their step, CENTRE a cross on each
    axis. A layer without content is left out.

    Raises
    ------
    GeometryError : a number of columns or rows that is not a positive integer
    ResourceError : the file exists and ``overwrite`` is False, or it cannot be written
    """
    refuse_overwrite(path, overwrite)
    scaled = in_mm(cell, columns, rows)
    with _reproducible():
        document = ezdxf.new("R2010", units=MILLIMETRES)
        space = document.modelspace()
        _draw_plate(space, scaled, columns, rows)
        _draw_pillars(space, scaled, columns, rows)
        _name_layers(document)
        write_atomically(path, document.saveas)
    return path


@contextmanager
def _reproducible() -> Iterator[None]:
    """Without dates and random identifiers, which ezdxf leaves out at a setting for the whole process."""
    before = ezdxf.options.write_fixed_meta_data_for_testing
    ezdxf.options.write_fixed_meta_data_for_testing = True
    try:
        yield
    finally:
        ezdxf.options.write_fixed_meta_data_for_testing = before


def _draw_plate(space: Modelspace, cell: UnitCell, columns: int, rows: int) -> None:
    outline = plate_outline(cell, columns, rows).tolist()
    space.add_lwpolyline(outline, close=True, dxfattribs={"layer": "PLATE"})
    corners = corner_grid(cell, columns, rows)
    for line in [*corners, *corners.swapaxes(0, 1)]:  # whole lines: two cells share their border
        space.add_line(line[0].tolist(), line[-1].tolist(), dxfattribs={"layer": "CELL"})


def _draw_pillars(space: Modelspace, cell: UnitCell, columns: int, rows: int) -> None:
    pillar = cell.pillar
    if pillar is None:
        return
    half_widths = {"PILLAR": pillar.radius}
    if pillar.arc is not None:
        half_widths["FILLET"] = pillar.arc.centre[0]
    if pillar.step is not None:
        half_widths["STEP"] = 0.5 * pillar.step.diameter
    for centre in centres(cell, columns, rows):
        for layer, half_width in half_widths.items():
            _draw_outline(space, centre, half_width, pillar.section == "round", layer)
        _draw_mark(space, centre, MARK * pillar.diameter)


def _draw_outline(space: Modelspace, centre: Array, half_width: float, is_round: bool, layer: str) -> None:
    if is_round:
        space.add_circle(centre.tolist(), half_width, dxfattribs={"layer": layer})
        return
    corners = centre + half_width * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    space.add_lwpolyline(corners.tolist(), close=True, dxfattribs={"layer": layer})


def _draw_mark(space: Modelspace, centre: Array, half_length: float) -> None:
    x, y = centre.tolist()
    space.add_line((x - half_length, y), (x + half_length, y), dxfattribs={"layer": "CENTRE"})
    space.add_line((x, y - half_length), (x, y + half_length), dxfattribs={"layer": "CENTRE"})


def _name_layers(document: Drawing) -> None:
    used = {entity.dxf.layer for entity in document.modelspace()}
    for name, colour in LAYERS.items():
        if name in used:
            document.layers.add(name, color=colour)
