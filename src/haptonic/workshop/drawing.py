"""A dimensioned drawing of one cell on a sheet A4: plan view, section, notes and title block."""

from __future__ import annotations

import datetime
import io
from collections.abc import Mapping
from pathlib import Path

import matplotlib as mpl
from matplotlib.figure import Figure

from haptonic.cell import UnitCell
from haptonic.errors import GeometryError
from haptonic.names import visible
from haptonic.plots.style import drawn, styled
from haptonic.store import refuse_overwrite, write_atomically
from haptonic.workshop.dimensions import dimension_texts, number
from haptonic.workshop.plan import draw_plan
from haptonic.workshop.section import draw_section
from haptonic.workshop.shape import in_mm
from haptonic.workshop.sheet import A4, SMALL, Sheet, shortened, wrapped

TIMES = "\N{MULTIPLICATION SIGN}"
FRAME = 10.0  # mm
BLOCK = (117.0, FRAME, A4[0] - FRAME, 43.0)  # title block: left, bottom, right, top
PLAN = (12.0, 50.0, 132.0, 194.0)
SECTION = (134.0, 50.0, 285.0, 194.0)


@drawn
def cell_drawing(
    cell: UnitCell,
    title: str,
    columns: int = 1,
    rows: int = 1,
    *,
    tolerances: Mapping[str, float] | None = None,
    why_none: str = "",
    date: datetime.date | None = None,
) -> Figure:
    """One cell of a plate of ``columns`` x ``rows`` as a technical drawing, to scale on A4.

    Parameters
    ----------
    tolerances : half-widths by the dimension's name in a study, such as ``cell.pillar.diameter``: m, or rad
        for the draft; they are shown as ``3.500 ± 0.020``
    why_none : said in the notes if there are no tolerances
    date : shown in the title block; without one, the same cell is the same file at any time

    Raises
    ------
    GeometryError : a number of columns or rows that is not a positive integer, or a cell that is not a
        rectangle
    StudyError : a tolerance of what the cell does not have, or one that is not positive
    """
    texts = dimension_texts(cell, tolerances or {})
    scaled = in_mm(cell, columns, rows)
    if scaled.lattice.a1[1] or scaled.lattice.a2[0]:
        raise GeometryError(
            argument="cell.lattice",
            given=f"a1 = {cell.lattice.a1}, a2 = {cell.lattice.a2}",
            allowed="a square or rectangular lattice along x and y",
            cause="the plan view shows its dimensions along x and y only",
            next_step="write the solid (STEP) or the outlines (DXF) instead",
        )
    sheet = Sheet()
    left, bottom, right, top = FRAME, FRAME, A4[0] - FRAME, A4[1] - FRAME
    sheet.line([(left, bottom), (right, bottom), (right, top), (left, top), (left, bottom)])
    alone = columns * rows == 1
    scales = (
        draw_plan(sheet, PLAN, scaled, texts, alone),
        draw_section(sheet, SECTION, scaled, texts, alone),
    )
    sides = [
        number(n * side)
        for n, side in zip((columns, rows), (cell.lattice.a1[0], cell.lattice.a2[1]), strict=True)
    ]
    fields = {
        "MATERIAL": visible(cell.material.name),
        "SCALE": scales[0] if scales[0] == scales[1] else f"plan {scales[0]}, A-A {scales[1]}",
        "NUMBER OF CELLS": "1" if alone else f"{columns} {TIMES} {rows} = {columns * rows}",
        "UNITS": "dimensions in mm",
        "PLATE": f" {TIMES} ".join(sides),
        **({"DATE": date.isoformat()} if date else {}),
    }
    _title_block(sheet, visible(title), fields)
    notes = _advice(cell)
    if not tolerances:
        notes.insert(0, "No dimension has a tolerance" + (f": {why_none}." if why_none else "."))
    _notes(sheet, notes)
    return sheet.figure


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
    """Write `cell_drawing` as a PDF of one page.

    Raises
    ------
    GeometryError, StudyError : as `cell_drawing`
    ResourceError : the file exists and ``overwrite`` is False, or it cannot be written
    """
    refuse_overwrite(path, overwrite)
    figure = cell_drawing(cell, title, columns, rows, tolerances=tolerances, why_none=why_none, date=date)
    created = datetime.datetime.combine(date, datetime.time()) if date else None
    stream = io.BytesIO()
    with styled():
        mpl.rcParams["pdf.fonttype"] = 42  # text stays text: it can be searched and copied
        figure.savefig(stream, format="pdf", metadata={"Title": title, "CreationDate": created})
    write_atomically(path, lambda temporary: temporary.write_bytes(stream.getvalue()))
    return path


def _title_block(sheet: Sheet, title: str, fields: Mapping[str, str]) -> None:
    left, bottom, right, top = BLOCK
    row = (top - bottom) / 3
    columns = (left, left + 66, left + 124, right)
    sheet.line([(left, bottom), (left, top), (right, top)])
    for k in (1, 2):
        sheet.line([(left, bottom + k * row), (right, bottom + k * row)], "thin")
        sheet.line([(columns[k], bottom), (columns[k], bottom + 2 * row)], "thin")
    size = 13.0
    sheet.text(
        (left + 2, top - 0.5 * row), shortened(title, right - left - 4, size, bold=True), size, bold=True
    )
    for k, (name, value) in enumerate(fields.items()):
        x, y = columns[k % 3] + 2, bottom + (1 - k // 3) * row
        sheet.text((x, y + row - 2.6), name, SMALL)
        sheet.text((x, y + 3.4), shortened(value, columns[k % 3 + 1] - x - 1, 9.0))


def _notes(sheet: Sheet, notes: list[str]) -> None:
    size, left, width = 7.5, FRAME + 3, BLOCK[0] - FRAME - 10
    y = BLOCK[3] - 1.0
    sheet.text((left, y), "NOTES", SMALL)
    for k, note in enumerate(notes):
        y -= 1.1
        for j, line in enumerate(wrapped(note, width, size)):
            y -= 3.4
            if not j:
                sheet.text((left, y), f"{k + 1}", size)
            sheet.text((left + 5, y), line, size)


def _advice(cell: UnitCell) -> list[str]:
    """What somebody who makes the plate has to know beside its dimensions; lengths in m."""
    notes = ["The face at the bottom of the section is touched: keep it flat, no marks, no chamfer."]
    pillar = cell.pillar
    if pillar is None:
        return notes
    sides = [pillar.half_width(z, k) for k, (low, high, _) in enumerate(pillar.stages) for z in (low, high)]
    room = cell.inradius - max(sides)
    notes.append(
        f"Between two pillars, side to side, {number(2 * room, 3)}: tool radius at most {number(room, 3)}."
    )
    if pillar.arc is None:
        notes.append("No fillet at the foot: tool with a sharp corner.")
    else:
        width = "diameter" if pillar.section == "round" else "width"
        notes.append(
            f"Fillet radius is the tool's corner radius, {number(pillar.fillet)}. "
            f"The {width} at the foot is that of the side continued to the plate."
        )
    if pillar.draft < 0:
        notes.append("Undercut: the pillar becomes wider towards its top.")
    if pillar.section == "square" and pillar.arc is not None:
        notes.append("The fillets of neighbouring sides meet in a mitre.")
    return notes
