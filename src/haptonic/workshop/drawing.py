"""A dimensioned drawing of a part on A3: its plan, a section through a row of pillars, a list of their kinds
and of patches, notes and a title block.

It is a DXF document: plan and section in model space, the sheet with its dimensions in paper space. PDF, SVG
and PNG are pictures of that sheet.
"""

from __future__ import annotations

import datetime
import io
import re
from collections.abc import Mapping, Set
from pathlib import Path

import matplotlib as mpl
import numpy as np
from scipy.spatial import cKDTree

from haptonic.atomic import refuse_overwrite, write_atomically
from haptonic.cell import Disc, Pillar
from haptonic.cell.outlines import Scaled
from haptonic.cell.sectioned import LENGTHS
from haptonic.cell.stack import Feature, Stack
from haptonic.materials import OrthotropicMaterial
from haptonic.names import counted, listed
from haptonic.plots.style import DOTS_PER_INCH, styled
from haptonic.workshop.dimensions import checked_tolerances, degrees, disc_text, disc_width, number, text_of
from haptonic.workshop.dxf import outlines, reproducible
from haptonic.workshop.part import Part
from haptonic.workshop.plan import draw_plan, letter
from haptonic.workshop.section import Row, draw_section, nearest, pitch_of
from haptonic.workshop.shape import MM, PillarShape, dimensions, heights
from haptonic.workshop.sheet import SIZE, SMALL, Box, Sheet, shortened, text_width

TIMES = " \N{MULTIPLICATION SIGN} "
GENERAL = "ISO 2768-m"  # for dimensions without a tolerance: medium, which any mill keeps
SHORTEST = 0.5e-3  # m, below which ISO 2768 gives no tolerances
FRAME = 10.0  # mm
AROUND = 9  # nearest pillars that are searched for the narrowest gap, the pillar itself included
BLOCK = (180.0, 36.0)  # size of the title block, mm
PLAN: Box = (12.0, 52.0, 250.0, 285.0)
SECTION: Box = (250.0, 100.0, 408.0, 285.0)
LISTS = (234.0, 97.0, 170.0)  # left, top and width
MOST_LINES = 8  # of the list
LEAST_SIZE = 0.5  # of a long text in the title block, relative to its usual size


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
    why_none : reason in the notes if there are no tolerances
    date : shown in the title block; without a date, the same part always gives the same file

    Raises
    ------
    StudyError : a tolerance of a dimension that the cell lacks, or one that is not positive
    """
    tolerances = checked_tolerances(part.source, tolerances or {})
    short = [abs(each.value) < SHORTEST for each in dimensions(part.source) if not each.is_angle]
    with reproducible():
        sheet = Sheet.of(outlines(part), title, date)
        left, bottom, right, top = FRAME, FRAME, sheet.size[0] - FRAME, sheet.size[1] - FRAME
        sheet.line([(left, bottom), (right, bottom), (right, top), (left, top)], close=True)
        plan = draw_plan(sheet, PLAN, part, tolerances)
        section = draw_section(sheet, SECTION, part, tolerances)
        for box, text in ((PLAN, f"Plan   {plan}"), (SECTION, f"Section along x   {section}")):
            sheet.text((0.5 * (box[0] + box[2]), box[3] - 4), text, 3.0, "CENTER")
        _title_block(sheet, title, {
            "MATERIAL" if len(part.materials) == 1 else "PLATE MATERIAL": part.cell.material.name,
            "MASS": f"{1e3 * part.mass:.3g} g",
            "PLATE": _size(part),
            "PILLARS AND DISCS": part.parts,
            "GENERAL TOLERANCES": "none" if all(short) else GENERAL,
            "UNITS": "dimensions in mm",
            "SCALE": str(plan),
            "DATE": date.isoformat() if date else "",
        })  # fmt: skip
        notes = _advice(part)
        if not tolerances:
            notes.insert(0, f"No dimension has a tolerance of its own{why_none and ': '}{why_none}.")
        if any(short):
            notes.append("ISO 2768 begins at 0.5 mm: a shorter dimension has its own tolerance or none.")
        sheet.notes(
            (FRAME + 3, FRAME + BLOCK[1] + 1),
            "NOTES",
            {str(1 + k): note for k, note in enumerate(notes)},
            right - BLOCK[0] - left - 8,
        )
        if lines := _kinds(part, tolerances):
            sheet.notes(LISTS[:2], "PILLARS, DISCS AND PATCHES", lines, LISTS[2])
    return sheet


def _size(part: Part) -> str:
    """Sides and thickness of the plate, and the angle of an oblique piece."""
    width, depth, angle = part.sides
    text = TIMES.join(number(side / MM) for side in (width, depth, part.cell.thickness))
    return text if angle is None else f"{text}, angle {degrees(angle)}"


def _kinds(part: Part, tolerances: Mapping[str, float]) -> dict[str, str]:
    """Number, sizes and distances of each kind of feature by its letter, and each patch by its name."""
    lines = {}
    for kind, (feature, places) in enumerate(part.standing):
        table = part.table(feature)
        half = tolerances if table else {}
        if isinstance(feature, Stack):
            discs = enumerate(feature.discs, start=1)
            texts = [
                counted(len(places), "disc stack"),
                *(_disc(disc, part, f"{table}disc[{number}]", half) for number, disc in discs),
            ]
        else:
            sizes = _sizes(part, feature, f"{table}pillar", half)
            texts = [f"{len(places)} {_named(feature)}", *sizes]
        for along, axis in enumerate("xy"):
            if step := nearest(places, along)[1]:
                dimension = pitch_of(part, step, along)
                texts.append(f"next along {axis} {text_of(dimension, half.get(dimension.name or ''))}")
        lines[letter(kind)] = ", ".join(texts)
    for mark in part.marks:
        if mark.layer == "PATCH":
            low, high = mark.line.min(axis=0), mark.line.max(axis=0)
            pairs = (0.5 * (low + high), high - low)
            at, size = (", ".join(number(side / MM) for side in pair) for pair in pairs)
            lines[mark.name] = f"centre {at}, size {size}, {mark.note}"
    if (more := len(lines) - MOST_LINES) > 0:
        return dict(list(lines.items())[:MOST_LINES]) | {"…": f"{more} more: see the DXF file"}
    return lines


def _sizes(part: Part, pillar: Pillar, table: str, half: Mapping[str, float]) -> list[str]:
    """Every number of a pillar, with its tolerance."""
    texts = []
    for dimension in heights(part.cell.thickness, pillar, table)[1:]:
        if dimension.name:
            word = re.sub(r"[._]", " ", dimension.name.removeprefix(f"{table}.")) + " "
            word = word.replace("diameter ", pillar.form.sign or f"{pillar.form.width} ")
            texts.append(word + text_of(dimension, half.get(dimension.name)))
    if pillar.point:
        texts.append(_corners(pillar.radius / MM, pillar))
    return [*texts, pillar.material.name] if pillar.material else texts


def _disc(disc: Disc, part: Part, at: str, half: Mapping[str, float]) -> str:
    """A disc with its numbers, its ends above the plate's top, and its material."""
    thickness = part.source.thickness
    width = disc_width(disc, thickness, at, half)
    texts = [f"{_named(disc)} disc {disc.form.sign or f'{disc.form.width} '}{width}"]
    texts += [f"{name.replace('_', ' ')} {disc_text(name, value, at, half)}"
              for name in (*LENGTHS, "draft", "turn") if (value := getattr(disc, name))]  # fmt: skip
    if disc.point:
        texts.append(_corners(disc.radius, disc))
    ends = zip(("low", "high"), disc.ends(thickness), strict=True)
    low, high = (disc_text(name, end - thickness, at, half) for name, end in ends)
    solid = "empty" if disc.empty else (disc.material or part.cell.material).name
    return f"{' '.join(texts)} from {low} to {high} {solid}"


def _named(section: Pillar | Disc) -> str:
    return f"{section.section} of {section.sides} sides" if section.sides else section.section


def _corners(half_width: float, section: Pillar | Disc) -> str:
    corners = half_width * section.outline.corners
    return "corners x, y: " + "; ".join(f"{number(x)}, {number(y)}" for x, y in corners)


def write_drawing(path: Path, sheet: Sheet, *, overwrite: bool = False) -> Path:
    """Write a drawing from `part_drawing` as a PDF of one page, or as DXF, SVG or PNG by the path's suffix.

    Raises
    ------
    ResourceError : the file exists and ``overwrite`` is False, or it cannot be written
    """
    refuse_overwrite(path, overwrite)
    kind = path.suffix[1:].lower()
    with reproducible(), styled():
        mpl.rcParams["pdf.fonttype"] = 42  # keeps text as text, which can be searched and copied
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
        room = column - 3
        size = SIZE * min(1.0, max(LEAST_SIZE, 0.98 * room / max(text_width(value, SIZE), SMALL)))
        sheet.text((x, y + 2.5), shortened(value, room, size), size)


def _first_angle(sheet: Sheet, x: float, y: float) -> None:
    """Symbol of the method of projection (ISO 5456-2): a cone from its side, and from its left."""
    sheet.line([(x - 9, y - 1.5), (x - 9, y + 1.5), (x - 2, y + 3), (x - 2, y - 3)], "THIN", close=True)
    for radius in (1.5, 3.0):
        sheet.space.add_circle((x + 5, y), radius, dxfattribs={"layer": "THIN"})
    sheet.line([(x - 10.5, y), (x - 0.5, y)], "AXIS")
    sheet.line([(x + 1, y), (x + 9, y)], "AXIS")
    sheet.line([(x + 5, y - 4), (x + 5, y + 4)], "AXIS")


def _advice(part: Part) -> list[str]:
    """Notes for the workshop, beside the dimensions."""
    if part.cell.is_mirrored:
        notes = ["The lower face has the same pillars at the same places (layers BELOW in the DXF)."]
    else:
        flat = "flat beside its holes" if part.source.hole_below else "flat"
        notes = [f"The face at the bottom of the section is touched: keep it {flat}, no marks, no chamfer."]
    for solid in part.materials:
        if isinstance(solid, OrthotropicMaterial):
            at = f"at {degrees(solid.turn)} to x, anticlockwise" if solid.turn else "along x"
            notes.append(f"Axis 1 of {solid.name} lies {at}, its axis 3 along the normal.")
    row = Row.of(part)
    if len(row.solids(part)) > 1:
        notes.append("Each hatch of the section is a material; the list names them.")
    notes += _not_shown(part, {feature for feature, _ in row.features})
    bodies = [PillarShape.of(pillar) for pillar, _ in part.pillars]
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
            "Positions are from the lower left corner; the DXF file has all axes (CENTRE) and edges (PLATE)."
        )
        notes.append(
            "Thin outlines in the plan are plain regions and glued patches, for reference; they are no edges."
        )
    if any(mark.layer == "HELD" for mark in part.marks):
        notes.append(
            "Thick lines beside the edge show where the plate is supported in use (HELD in the DXF)."
        )
    return notes


def _not_shown(part: Part, shown: Set[Feature]) -> list[str]:
    """Notes on kinds of pillars and stacks that the section does not show, and where their heights are."""
    hidden = [kind for kind, (feature, _) in enumerate(part.standing) if feature not in shown]
    notes = []
    for place, kinds in (
        ("the list gives their heights", [kind for kind in hidden if kind < MOST_LINES]),
        ("the STEP file has their heights", [kind for kind in hidden if kind >= MOST_LINES]),
    ):
        if kinds:
            notes.append(f"The section does not show {listed([letter(kind) for kind in kinds])}: {place}.")
    return notes


def _room(part: Part, bodies: list[PillarShape]) -> float | None:
    """Half the narrowest gap between two pillars; an upper bound for corners that face each other."""
    if part.count is not None:
        return 0.5 * min(part.cell.ways(range(len(part.cell.pillars)))) if bodies else None
    gaps = []
    for k, (_, places) in enumerate(part.pillars):
        for other, (_, others) in enumerate(part.pillars[: k + 1]):
            number = cKDTree(others).query(places, k=min(AROUND, len(others)))[1].reshape(len(places), -1)
            away = np.unique(np.round(others[number] - places[:, None], 9).reshape(-1, 2), axis=0)
            away = away[away.any(axis=1)]
            if len(away):
                gap_of, beside = (Scaled(bodies[n].outline, bodies[n].widest) for n in (k, other))
                gaps.append(float(gap_of.gap_to(beside, away).min()))
    return 0.5 * min(gaps) if gaps else None
