"""What the drawing of a whole plate lists beside its views: kinds of pillars, and patches."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np

from haptonic.arrays import Array
from haptonic.cell import Pillar
from haptonic.workshop.dimensions import FINEST, text_of
from haptonic.workshop.part import Mark, Part
from haptonic.workshop.shape import Dimension, heights, sides
from haptonic.workshop.sheet import SIZE, SMALL, Sheet, shortened
from haptonic.workshop.views import Box

ROW = 5.0  # mm
PILLARS = {
    "PILLAR": 12.0, "NUMBER": 14.0, "WIDTH": 30.0, "HEIGHT": 30.0, "FILLET": 30.0, "STEP, WIDTH": 30.0,
    "STEP, HEIGHT": 27.0, "DRAFT": 29.0, "APART ALONG x, y": 56.0,
}  # fmt: skip
PATCHES = {"PATCH": 39.0, "CENTRE x, y": 48.0, "SIZE ALONG x, y": 48.0, "THICKNESS, MATERIAL": 123.0}


def letter(number: int) -> str:
    """What a kind of pillar is called: A, B, ..., Z, A1, ..."""
    rounds, place = divmod(number, 26)
    return chr(ord("A") + place) + (str(rounds) if rounds else "")


def draw_lists(sheet: Sheet, box: Box, part: Part, tolerances: Mapping[str, float]) -> None:
    """Kinds of pillars with number and sizes; then where patches are glued."""
    kinds = [
        [
            letter(k),
            str(len(places)),
            *_sizes(part, pillar, tolerances),
            _apart(part, pillar, places, tolerances),
        ]
        for k, (pillar, places) in enumerate(part.standing)
    ]
    patches = [_patch(mark) for mark in part.marks if mark.layer == "PATCH"]
    room = int((box[3] - box[1]) / ROW) - bool(kinds) - bool(patches)
    kinds, more = _fitted(kinds, room - min(len(patches), 2))
    patches, others = _fitted(patches, room - len(kinds))
    top = box[3]
    if kinds:
        top = _draw(sheet, (box[0], top), PILLARS, kinds, more) - 0.5 * ROW
    if patches:
        _draw(sheet, (box[0], top), PATCHES, patches, others)


def _fitted(rows: list[list[str]], room: int) -> tuple[list[list[str]], str]:
    """So many as there is room for, and what is said of the others."""
    if len(rows) <= room:
        return rows, ""
    return rows[: room - 1], f"and {len(rows) - room + 1} more: see the DXF file"


def _draw(
    sheet: Sheet,
    corner: tuple[float, float],
    columns: Mapping[str, float],
    rows: Sequence[Sequence[str]],
    more: str,
) -> float:
    """A table below and to the right of a place; the height where it ends."""
    x, top = corner
    right, low = x + sum(columns.values()), top - ROW * (1 + len(rows) + bool(more))
    for k in range(len(rows) + 2):
        sheet.line([(x, top - k * ROW), (right, top - k * ROW)], "THIN")
    for name, cells in zip(columns, zip(*rows, strict=True), strict=True):
        sheet.text((x + 1.5, top - ROW + 1.6), name, SMALL)
        for k, cell in enumerate(cells):
            place = (x + 1.5, top - (k + 2) * ROW + 1.3)
            sheet.text(place, shortened(cell, columns[name] - 3, SIZE), SIZE)
        x += columns[name]
    if more:
        sheet.text((corner[0] + 1.5, low + 1.3), more, SIZE)
    return low


def _sizes(part: Part, pillar: Pillar, tolerances: Mapping[str, float]) -> list[str]:
    """Texts of the dimensions of a kind; those of the study's own cell have tolerances."""
    table = part.table(pillar)
    own, at = (tolerances, table) if table else ({}, "")
    shown = {one.name: one for one in heights(part.cell.thickness, pillar, at)}
    sign = pillar.form.sign
    signs = {
        "diameter": sign,
        "height": "",
        "fillet": "R",
        "step.diameter": sign,
        "step.height": "",
        "draft": "",
    }
    return [
        text_of(one, own.get(path), sign) if (one := shown.get(path := f"{at}.{name}")) else "\N{EN DASH}"
        for name, sign in signs.items()
    ]


def _apart(part: Part, pillar: Pillar, places: Array, tolerances: Mapping[str, float]) -> str:
    """Smallest distances between axes in one row, and in one column."""
    own, texts = tolerances if part.table(pillar) else {}, []
    for along, side in zip((0, 1), sides(part.cell), strict=True):
        line = np.round(places, FINEST)  # axes in one line are so up to rounding
        line = line[np.lexsort((line[:, along], line[:, 1 - along]))]
        steps = np.diff(line, axis=0)
        steps = steps[steps[:, 1 - along] == 0, along]
        apart = float(steps.min()) if len(steps) else math.nan
        is_side = math.isclose(apart, side.value, abs_tol=10**-FINEST)
        one = Dimension(side.name, apart, side.kind)
        texts.append(
            text_of(one, own.get(side.name or "") if is_side else None) if len(steps) else "\N{EN DASH}"
        )
    return ", ".join(texts)


def _patch(mark: Mark) -> list[str]:
    low, high = mark.line.min(axis=0), mark.line.max(axis=0)
    pairs = (0.5 * (low + high), high - low)
    return [mark.name, *(", ".join(f"{number:.{FINEST}f}".rstrip("0").rstrip(".") for number in pair)
                         for pair in pairs), mark.note]  # fmt: skip
