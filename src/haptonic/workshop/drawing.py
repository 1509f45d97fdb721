"""A dimensioned drawing of a part: a piece of lattice on A4 by the views of one cell, a whole plate on A3 by
its plan, a section and a list of its pillars; notes and a title block.

It is a DXF document: the part's outlines in model space, the sheet in paper space. PDF, SVG and PNG are
pictures of that sheet.
"""

from __future__ import annotations

import datetime
import io
from collections.abc import Mapping
from pathlib import Path

import matplotlib as mpl
import numpy as np
from scipy.spatial import cKDTree

from haptonic.cell.outlines import Scaled
from haptonic.plots.style import DOTS_PER_INCH, spread, styled
from haptonic.store import refuse_overwrite, write_atomically
from haptonic.workshop.dimensions import checked_tolerances, number
from haptonic.workshop.dxf import outlines, reproducible
from haptonic.workshop.lists import draw_lists, letter
from haptonic.workshop.part import Part
from haptonic.workshop.shape import MM, PillarShape
from haptonic.workshop.sheet import A3, A4, APART, SIZE, SMALL, Sheet, View, shortened, text_width
from haptonic.workshop.views import Box, draw_isometric, draw_plan, draw_plate, draw_section

TIMES = "\N{MULTIPLICATION SIGN}"
GENERAL = "ISO 2768-m"  # for dimensions without a tolerance of their own: medium, which a mill keeps unasked
FRAME = 10.0  # mm
AROUND = 9  # nearest pillars among which the narrowest gap is sought, the pillar itself among them
BLOCK = (180.0, 36.0)  # size of the title block, mm
BESIDE = 1.2  # mm between an edge and the line that says how it is held
SAMPLE = 12.0  # mm of such a line in the legend
# on A4, of a piece
PLAN: Box = (12.0, 117.0, 110.0, 198.0)
PLATE: Box = (12.0, 50.0, 110.0, 115.0)
SECTION: Box = (110.0, 48.0, 226.0, 198.0)
ISOMETRIC: Box = (226.0, 48.0, 285.0, 198.0)
# on A3, of a whole plate
WIDE_PLAN: Box = (12.0, 112.0, 250.0, 285.0)
LEGEND = (14.0, 109.5)  # where it begins
LISTS: Box = (14.0, 48.0, 272.0, 108.0)
WIDE_SECTION: Box = (250.0, 136.0, 408.0, 285.0)
WIDE_ISOMETRIC: Box = (275.0, 48.0, 408.0, 136.0)


def part_drawing(
    part: Part,
    title: str,
    *,
    tolerances: Mapping[str, float] | None = None,
    why_none: str = "",
    date: datetime.date | None = None,
) -> Sheet:
    """A part as a technical drawing to scale.

    Parameters
    ----------
    tolerances : half-widths by the dimension's name in a study, such as ``cell.pillar.diameter``: m, or rad
        for the draft; they are shown as ``3.500 ±0.020``
    why_none : said in the notes if there are no tolerances
    date : shown in the title block; without one, the same part is the same file at any time

    Raises
    ------
    StudyError : a tolerance of what the cell does not have, or one that is not positive
    GeometryError : pillars that the views do not show, see `workshop.part.hidden`
    """
    part.need_shown(drawn=True)
    tolerances = checked_tolerances(part.cell.scaled(1 / MM), tolerances or {})
    with reproducible():
        by_cell = part.count is not None and part.cell.is_simple and part.cell.is_upright
        sheet = Sheet.of(outlines(part), A4 if by_cell else A3, title, date)
        left, bottom, right, top = FRAME, FRAME, sheet.size[0] - FRAME, sheet.size[1] - FRAME
        sheet.line([(left, bottom), (right, bottom), (right, top), (left, top)], close=True)
        view, numbers = (_piece if by_cell else _plate)(sheet, part, tolerances)
        _title_block(sheet, title, {
            "MATERIAL": part.cell.material.name,
            "MASS": f"{1e3 * part.volume / MM**3 * part.cell.material.density:.3g} g",
            "PLATE": f" {TIMES} ".join(number(side / MM) for side in part.size),
            **numbers,
            "GENERAL TOLERANCES": GENERAL,
            "UNITS": "dimensions in mm",
            "SCALE": str(view),
            "DATE": date.isoformat() if date else "",
        })  # fmt: skip
        notes = _advice(part)
        if not tolerances:
            notes.insert(0, f"No dimension has a tolerance of its own{why_none and ': '}{why_none}.")
        width = sheet.size[0] - BLOCK[0] - 2 * FRAME - 8
        sheet.notes((FRAME + 3, FRAME + BLOCK[1] - 1), notes, width)
    return sheet


def _piece(sheet: Sheet, part: Part, tolerances: Mapping[str, float]) -> tuple[View, dict[str, str]]:
    """Views of one cell, and where the cells lie; the view whose scale is that of the sheet, and numbers."""
    assert part.count is not None
    cell, (columns, rows) = part.cell, part.count
    alone = columns * rows == 1
    draw_plan(sheet, (*PLAN[:1], PLATE[1], *PLAN[2:]) if alone else PLAN, cell, tolerances, alone)
    if not alone:
        draw_plate(sheet, PLATE, part, f"Plate, {columns} {TIMES} {rows} cells")
    size = (float(cell.lattice.a1[0]), cell.thickness)
    section = draw_section(sheet, SECTION, size, cell.pillar, tolerances, alone)
    draw_isometric(sheet, ISOMETRIC, Part.piece(cell.scaled(1 / MM)))
    return section, _number_of_cells(part)


def _number_of_cells(part: Part) -> dict[str, str]:
    if part.count is None:
        return {"NUMBER OF PILLARS": str(part.pillars)}
    columns, rows = part.count
    alone = columns * rows == 1
    return {"NUMBER OF CELLS": "1" if alone else f"{columns} {TIMES} {rows} = {columns * rows}"}


def _plate(sheet: Sheet, part: Part, tolerances: Mapping[str, float]) -> tuple[View, dict[str, str]]:
    """The same of a whole plate, or of other cells: its plan, a section, how it looks, and its lists."""
    plan = draw_plate(sheet, WIDE_PLAN, part, "Plate")
    _name_marks(sheet, plan, part)
    _draw_held(sheet, plan, part)
    several = len(part.standing) > 1
    if several:
        _name_kinds(sheet, plan, part)
    pillar = part.standing[0][0] if part.standing else None
    width, name = min(part.cell.lattice.pitch, *part.size), "Section"
    if pillar is not None:
        width = max(width, 3 * PillarShape.of(pillar).widest)
        name += f" of a pillar{several * ' A'}"
    table = (pillar and part.table(pillar)) or "pillar"  # of another lattice: nothing there has tolerances
    size = (width, part.cell.thickness)
    draw_section(sheet, WIDE_SECTION, size, pillar, tolerances, False, name, table)
    draw_isometric(sheet, WIDE_ISOMETRIC, part)
    draw_lists(sheet, LISTS, part, tolerances)
    return plan, _number_of_cells(part)


def _name_marks(sheet: Sheet, view: View, part: Part) -> None:
    """Write the names of regions and patches into them, where there is room."""
    taken: list[Box] = []
    named = [mark for mark in part.marks if mark.layer in ("REGION", "PATCH")]
    for mark in sorted(named, key=lambda one: one.layer):  # patches come first: they lie on regions
        low, high = (view.place(*end(mark.line, axis=0)) for end in (np.min, np.max))
        if mark.layer == "PATCH":
            taken.append((*low, *high))
        width, x = text_width(mark.name) + 2, 0.5 * (low[0] + high[0])
        for share in (0.5, 0.75, 0.25, 0.9, 0.1):
            y = low[1] + share * (high[1] - low[1])
            box = (x - 0.5 * width, y - SIZE, x + 0.5 * width, y + SIZE)
            others = taken[:-1] if mark.layer == "PATCH" else taken
            fits = low[0] < box[0] and box[2] < high[0] and low[1] < box[1] and box[3] < high[1]
            if fits and not any(_meet(box, other) for other in others):
                sheet.text((x, y - 0.5 * SIZE), mark.name, align="CENTER")
                taken.append(box)
                break


def _draw_held(sheet: Sheet, view: View, part: Part) -> None:
    """A thick line beside each side that is held, and below the plan what these lines mean."""
    meaning = {}
    for mark in part.marks:
        if mark.layer != "HELD":
            continue
        ends = np.array([view.place(*end) for end in mark.line.tolist()])
        along = ends[1] - ends[0]
        outward = np.array([along[1], -along[0]]) / np.hypot(*along)  # the plate lies to the left
        sheet.line(ends + BESIDE * outward, mark.name.upper())
        meaning[mark.name] = f"{mark.name}{mark.note}"
    x, y = LEGEND
    for name, text in meaning.items():
        sheet.line([(x, y + 0.5 * SIZE), (x + SAMPLE, y + 0.5 * SIZE)], name.upper())
        sheet.text((x + SAMPLE + 2, y), text)
        x += SAMPLE + text_width(text) + 8


def _meet(one: Box, other: Box) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


def _name_kinds(sheet: Sheet, view: View, part: Part) -> None:
    """Point to the rightmost pillar of each kind, with its letter."""
    edge = view.place(*part.corners[1])[0]
    tips = []
    for pillar, places in part.standing:
        x, y = places[np.lexsort((places[:, 1], places[:, 0]))[-1]]
        tips.append(view.place(float(x) + PillarShape.of(pillar).foot, float(y)))
    low, high = (view.place(*corner)[1] for corner in part.corners)
    lines = spread([tip[1] for tip in tips], APART, low, max(high, low + APART * len(tips)))
    for k, (tip, y) in enumerate(zip(tips, lines, strict=True)):
        sheet.leader(tip, (edge + 5, y), letter(k), 1)


def write_drawing(path: Path, sheet: Sheet, *, overwrite: bool = False) -> Path:
    """Write what `part_drawing` drew as a PDF of one page; as DXF, SVG or PNG if the path ends so.

    Raises
    ------
    ResourceError : the file exists and ``overwrite`` is False, or it cannot be written
    """
    refuse_overwrite(path, overwrite)
    kind = path.suffix[1:].lower()
    with reproducible(), styled():
        mpl.rcParams["pdf.fonttype"] = 42  # text stays text: it can be searched and copied
        if kind == "dxf":
            write_atomically(path, sheet.document.saveas)
            return path
        date = sheet.date
        created = datetime.datetime.combine(date, datetime.time()) if date else None
        metadata = {"svg": {"Date": date and date.isoformat()}, "png": {}}.get(
            kind, {"CreationDate": created}
        )
        stream = io.BytesIO()
        sheet.figure().savefig(
            stream, format=kind if kind in ("svg", "png") else "pdf", dpi=DOTS_PER_INCH,
            metadata={"Title": sheet.title, **metadata},
        )  # fmt: skip
    write_atomically(path, lambda temporary: temporary.write_bytes(stream.getvalue()))
    return path


def _title_block(sheet: Sheet, title: str, fields: Mapping[str, str]) -> None:
    left, bottom = sheet.size[0] - FRAME - BLOCK[0], FRAME
    right, top = left + BLOCK[0], bottom + BLOCK[1]
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


def _advice(part: Part) -> list[str]:
    """What somebody who makes the part has to know beside its dimensions."""
    notes = ["The face at the bottom of the section is touched: keep it flat, no marks, no chamfer."]
    bodies = [PillarShape.of(pillar) for pillar, _ in part.standing]
    room = _room(part, bodies)
    if room is not None:
        notes.append(
            f"Between two pillars, side to side, {number(2 * room / MM, 3)}: tool radius at most "
            f"{number(room / MM, 3)}."
        )
    arcs = sorted({(body.arc.radius, body.form.width) for body in bodies if body.arc})
    if any(body.arc is None for body in bodies):
        notes.append("No fillet at the foot: tool with a sharp corner.")
    for radius, width in arcs:
        notes.append(
            f"Fillet radius is the tool's corner radius, {number(radius / MM)}. "
            f"The {width} at the foot is that of the side continued to the plate."
        )
    if not all(body.is_free_above(*body.side[0].tolist()) for body in bodies):
        notes.append("Undercut: the pillar becomes wider towards its top.")
    if any(body.outline.joints and body.arc is not None for body in bodies):
        notes.append("The fillets of neighbouring sides meet in a mitre.")
    if part.count is not None and not part.cell.is_simple:
        steps = " and ".join(f"({x:.4g}, {y:.4g})" for x, y in part.cell.lattice.vectors)
        notes.append(f"Cells repeat after {steps}; the DXF file has all axes (CENTRE), from the middle on.")
    if part.count is None:
        notes.append(
            "Places count from the lower left corner; the DXF file has all axes (CENTRE) and edges (PLATE)."
        )
        notes.append(
            "Thin outlines in the plan are plain regions and glued patches, for reference: no edges."
        )
    if any(mark.layer == "HELD" for mark in part.marks):
        notes.append("Thick lines beside the edge show where the plate is held in use (HELD in the DXF).")
    return notes


def _room(part: Part, bodies: list[PillarShape]) -> float | None:
    """Half the narrowest gap between two pillars; of corners that face each other at most that."""
    if part.count is not None:
        return 0.5 * min(part.cell.ways(range(len(part.cell.pillars)))) if bodies else None
    gaps = []
    for k, (_, places) in enumerate(part.standing):
        for other, (_, others) in enumerate(part.standing[: k + 1]):
            number = cKDTree(others).query(places, k=min(AROUND, len(others)))[1].reshape(len(places), -1)
            away = np.unique(np.round(others[number] - places[:, None], 9).reshape(-1, 2), axis=0)
            away = away[away.any(axis=1)]
            if len(away):
                mine, beside = (Scaled(bodies[n].outline, bodies[n].widest) for n in (k, other))
                gaps.append(float(mine.gap_to(beside, away).min()))
    return 0.5 * min(gaps) if gaps else None
