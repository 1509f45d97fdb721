"""Outlines seen from above as a DXF file, in mm, for two-dimensional milling programs."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import ezdxf
import numpy as np
from ezdxf.document import Drawing
from ezdxf.layouts import BaseLayout

from haptonic.arrays import Array
from haptonic.atomic import refuse_overwrite, write_atomically
from haptonic.cell.outlines import Outline
from haptonic.workshop.part import Part
from haptonic.workshop.shape import PillarShape

MILLIMETRES = 4  # code of the header variable $INSUNITS
MARK = 0.1  # half the length of a centre mark, in diameters of the pillar
BELOW = " BELOW"  # end of the names of layers for the lower face

# layer: colour in AutoCAD's table, and plotted line width, hundredths of a millimetre
LAYERS = {
    "PLATE": (7, 50), "CELL": (8, 9), "REGION": (8, 9), "PATCH": (6, 18), "HELD": (4, 70),
    "PILLAR": (1, 18), "FILLET": (3, 9), "STEP": (5, 9), "HOLE": (1, 35), "DISC": (3, 18), "CENTRE": (2, 9),
}  # fmt: skip


def write_dxf(path: Path, part: Part, *, overwrite: bool = False) -> Path:
    """Write the outlines of a part; the same part always gives the same file.

    Layers: PLATE its edge and the edges of its holes, PILLAR the pillars at their foot without the fillet,
    FILLET where fillets meet the plate, STEP the pillars above their step, HOLE discs that are empty within
    the plate, DISC all other discs, CENTRE a cross on each axis; layers of pillars on the lower face end in
    BELOW. For reference: CELL the borders of cells, REGION those of plain plate, PATCH those of glued
    patches, HELD the supported sides. A layer without content is left out.

    Raises
    ------
    ResourceError : the file exists and ``overwrite`` is False, or it cannot be written
    """
    refuse_overwrite(path, overwrite)
    with reproducible():
        write_atomically(path, outlines(part).saveas)
    return path


@contextmanager
def reproducible() -> Iterator[None]:
    """Leave out dates and random identifiers, by ezdxf's setting for the whole process."""
    before = ezdxf.options.write_fixed_meta_data_for_testing
    ezdxf.options.write_fixed_meta_data_for_testing = True
    try:
        yield
    finally:
        ezdxf.options.write_fixed_meta_data_for_testing = before


def outlines(part: Part) -> Drawing:
    """Make a document with the outlines of a part in its model space."""
    document = ezdxf.new("R2010", units=MILLIMETRES)
    space = document.modelspace()
    for mark in part.marks:  # first, so that edges lie on top of them
        line, closed = mark.line.tolist(), bool((mark.line[0] == mark.line[-1]).all())
        space.add_lwpolyline(line[: len(line) - closed], close=closed, dxfattribs={"layer": mark.layer})
    for loop in part.outline:
        space.add_lwpolyline(loop.tolist(), close=True, dxfattribs={"layer": "PLATE"})
    for pillar, places in part.pillars:
        body, arm = PillarShape.of(pillar), MARK * pillar.diameter
        for x, y in places.tolist():
            for face in ("", BELOW)[: part.cell.copies]:
                for layer, half_width in body.outlines.items():
                    add_outline(space, body.outline, (x, y), half_width, layer + face)
            _add_cross(space, (x, y), arm)
    for stack, places in part.stacks:
        for x, y in places.tolist():
            for border, is_hole in stack.edges():
                add_outline(space, border.outline, (x, y), border.half_width, "HOLE" if is_hole else "DISC")
            _add_cross(space, (x, y), 2 * MARK * stack.rim.half_width)
    used = {entity.dxf.layer for entity in space}
    for name, (colour, width) in LAYERS.items():
        for layer in sorted(used & {name, name + BELOW}):
            document.layers.add(layer, color=colour, lineweight=width)
    return document


def _add_cross(space: BaseLayout, place: tuple[float, float], arm: float) -> None:
    x, y = place
    space.add_line((x - arm, y), (x + arm, y), dxfattribs={"layer": "CENTRE"})
    space.add_line((x, y - arm), (x, y + arm), dxfattribs={"layer": "CENTRE"})


def add_outline(
    space: BaseLayout, outline: Outline, centre: tuple[float, float] | Array, half_width: float, layer: str
) -> None:
    """Add a horizontal cut as a circle, an ellipse or a closed polyline of straight sides and arcs."""
    x, y = (float(coordinate) for coordinate in centre)
    look = {"layer": layer}
    if outline.joints:
        joints = outline.at(np.arange(outline.joints, dtype=float)).tolist()
        line = [
            (x + half_width * a, y + half_width * b, bulge)
            for (a, b), bulge in zip(joints, outline.bulges.tolist(), strict=True)
        ]
        space.add_lwpolyline(line, format="xyb", close=True, dxfattribs=look)
        return
    (large, small), (a, b) = outline.half_axes
    if large == small:
        space.add_circle((x, y), half_width * large, dxfattribs=look)
    else:
        axis = (half_width * large * a, half_width * large * b)
        space.add_ellipse((x, y), axis, small / large, dxfattribs=look)
