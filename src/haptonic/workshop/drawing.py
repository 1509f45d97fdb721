"""A dimensioned drawing of a plate on a sheet A4: views of one cell, where the cells lie, notes, title block.

It is a DXF document: the plate's outlines in model space, the sheet in paper space. PDF, SVG and PNG are
pictures of that sheet.
"""

from __future__ import annotations

import datetime
import io
from collections.abc import Mapping
from pathlib import Path

import matplotlib as mpl

from haptonic.cell import UnitCell
from haptonic.plots.style import DOTS_PER_INCH, styled
from haptonic.store import refuse_overwrite, write_atomically
from haptonic.workshop.dimensions import checked_tolerances, number
from haptonic.workshop.dxf import outlines, reproducible
from haptonic.workshop.shape import PillarShape, in_mm
from haptonic.workshop.sheet import A4, SIZE, SMALL, Sheet, shortened
from haptonic.workshop.views import Box, draw_isometric, draw_plan, draw_plate, draw_section

TIMES = "\N{MULTIPLICATION SIGN}"
GENERAL = "ISO 2768-m"  # for dimensions without a tolerance of their own: medium, which a mill keeps unasked
FRAME = 10.0  # mm
BLOCK: Box = (107.0, FRAME, A4[0] - FRAME, 46.0)  # title block
PLAN: Box = (12.0, 117.0, 110.0, 198.0)
PLATE: Box = (12.0, 50.0, 110.0, 115.0)
SECTION: Box = (110.0, 48.0, 226.0, 198.0)
ISOMETRIC: Box = (226.0, 48.0, 285.0, 198.0)


def cell_drawing(
    cell: UnitCell,
    title: str,
    columns: int = 1,
    rows: int = 1,
    *,
    tolerances: Mapping[str, float] | None = None,
    why_none: str = "",
    date: datetime.date | None = None,
) -> Sheet:
    """One cell of a plate of ``columns`` x ``rows``, and the plate, as a technical drawing to scale on A4.

    Parameters
    ----------
    tolerances : half-widths by the dimension's name in a study, such as ``cell.pillar.diameter``: m, or rad
        for the draft; they are shown as ``3.500 ±0.020``
    why_none : said in the notes if there are no tolerances
    date : shown in the title block; without one, the same cell is the same file at any time

    Raises
    ------
    GeometryError : a number of columns or rows that is not a positive integer, or a cell that is not a
        rectangle
    StudyError : a tolerance of what the cell does not have, or one that is not positive
    """
    tolerances = checked_tolerances(cell, tolerances or {})
    scaled = in_mm(cell, columns, rows)
    scaled.check_simple("the drawing")
    with reproducible():
        sheet = Sheet.of(outlines(scaled, columns, rows))
        left, bottom, right, top = FRAME, FRAME, A4[0] - FRAME, A4[1] - FRAME
        sheet.line([(left, bottom), (right, bottom), (right, top), (left, top)], close=True)
        alone = columns * rows == 1
        plan = (*PLAN[:1], PLATE[1], *PLAN[2:]) if alone else PLAN
        draw_plan(sheet, plan, scaled, tolerances, alone)
        if not alone:
            draw_plate(sheet, PLATE, scaled, columns, rows)
        section = draw_section(sheet, SECTION, scaled, tolerances, alone)
        draw_isometric(sheet, ISOMETRIC, scaled)
        volume = cell.lattice.area * cell.thickness + (cell.pillar.volume if cell.pillar else 0.0)
        sides = (columns * cell.lattice.a1[0], rows * cell.lattice.a2[1])
        _title_block(sheet, title, {
            "MATERIAL": cell.material.name,
            "MASS": f"{1e3 * columns * rows * volume * cell.material.density:.3g} g",
            "PLATE": f" {TIMES} ".join(number(side) for side in sides),
            "NUMBER OF CELLS": "1" if alone else f"{columns} {TIMES} {rows} = {columns * rows}",
            "GENERAL TOLERANCES": GENERAL,
            "UNITS": "dimensions in mm",
            "SCALE": str(section),
            "DATE": date.isoformat() if date else "",
        })  # fmt: skip
        notes = _advice(cell)
        if not tolerances:
            notes.insert(0, f"No dimension has a tolerance of its own{why_none and ': '}{why_none}.")
        sheet.notes((FRAME + 3, BLOCK[3] - 1), notes, BLOCK[0] - FRAME - 8)
    return sheet


def write_drawing(
    path: Path,
    cell: UnitCell,
    title: str,
    columns: int = 1,
    rows: int = 1,
    *,
    tolerances: Mapping[str, float] | None = None,
    why_none: str = "",
    date: datetime.date | None = None,
    overwrite: bool = False,
) -> Path:
    """Write `cell_drawing` as a PDF of one page; as DXF, SVG or PNG if the path ends so.

    Raises
    ------
    GeometryError, StudyError : as `cell_drawing`
    ResourceError : the file exists and ``overwrite`` is False, or it cannot be written
    """
    refuse_overwrite(path, overwrite)
    sheet = cell_drawing(cell, title, columns, rows, tolerances=tolerances, why_none=why_none, date=date)
    kind = path.suffix[1:].lower()
    with reproducible(), styled():
        mpl.rcParams["pdf.fonttype"] = 42  # text stays text: it can be searched and copied
        if kind == "dxf":
            write_atomically(path, sheet.document.saveas)
            return path
        created = datetime.datetime.combine(date, datetime.time()) if date else None
        metadata = {"svg": {"Date": date and date.isoformat()}, "png": {}}.get(
            kind, {"CreationDate": created}
        )
        stream = io.BytesIO()
        sheet.figure().savefig(
            stream, format=kind if kind in ("svg", "png") else "pdf", dpi=DOTS_PER_INCH,
            metadata={"Title": title, **metadata},
        )  # fmt: skip
    write_atomically(path, lambda temporary: temporary.write_bytes(stream.getvalue()))
    return path


def _title_block(sheet: Sheet, title: str, fields: Mapping[str, str]) -> None:
    left, bottom, right, top = BLOCK
    row, column = (top - bottom) / 3, (right - left) / 4
    sheet.line([(left, bottom), (left, top), (right, top)])
    for k in (1, 2):
        sheet.line([(left, bottom + k * row), (right, bottom + k * row)], "THIN")
    for k in (1, 2, 3):
        sheet.line([(left + k * column, bottom), (left + k * column, bottom + 2 * row)], "THIN")
    size = 3.5
    room = right - left - 26
    sheet.text((left + 2, top - 0.5 * (row + size)), shortened(title, room, size, bold=True), size, bold=True)
    _first_angle(sheet, right - 11, top - 0.5 * row)
    for k, (name, value) in enumerate(fields.items()):
        x, y = left + (k % 4) * column + 2, bottom + (1 - k // 4) * row
        sheet.text((x, y + row - SMALL - 1.3), name, SMALL)
        sheet.text((x, y + 2.5), shortened(value, column - 3, SIZE), SIZE)


def _first_angle(sheet: Sheet, x: float, y: float) -> None:
    """Symbol of the method of projection (ISO 5456-2): a cone from its side, and from its left."""
    sheet.line([(x - 9, y - 1.5), (x - 9, y + 1.5), (x - 2, y + 3), (x - 2, y - 3)], "SEEN", close=True)
    for radius in (1.5, 3.0):
        sheet.space.add_circle((x + 5, y), radius, dxfattribs={"layer": "SEEN"})
    sheet.line([(x - 10.5, y), (x - 0.5, y)], "AXIS")
    sheet.line([(x + 1, y), (x + 9, y)], "AXIS")
    sheet.line([(x + 5, y - 4), (x + 5, y + 4)], "AXIS")


def _advice(cell: UnitCell) -> list[str]:
    """What somebody who makes the plate has to know beside its dimensions; lengths in m."""
    notes = ["The face at the bottom of the section is touched: keep it flat, no marks, no chamfer."]
    pillar = cell.pillar
    if pillar is None:
        return notes
    body = PillarShape.of(pillar)
    room = cell.inradius - body.widest
    notes.append(
        f"Between two pillars, side to side, {number(2 * room, 3)}: tool radius at most {number(room, 3)}."
    )
    if body.arc is None:
        notes.append("No fillet at the foot: tool with a sharp corner.")
    else:
        notes.append(
            f"Fillet radius is the tool's corner radius, {number(body.arc.radius)}. "
            f"The {body.form.width} at the foot is that of the side continued to the plate."
        )
    if not body.is_free_above(*body.side[0].tolist()):
        notes.append("Undercut: the pillar becomes wider towards its top.")
    if body.form.corners and body.arc is not None:
        notes.append("The fillets of neighbouring sides meet in a mitre.")
    return notes
