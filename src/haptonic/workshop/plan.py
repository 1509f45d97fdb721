"""Plan view of a cell on a drawing."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise

import numpy as np

from haptonic.cell import Pillar, UnitCell
from haptonic.workshop.shape import Array, straight_side
from haptonic.workshop.sheet import Kind, Label, Sheet

Box = tuple[float, float, float, float]  # left, bottom, right, top, mm

_SCALES = [step * 10.0**power for power in range(3, -4, -1) for step in (5, 2, 1)]  # ISO 5455
_ROOM = (46.0, 18.0, 12.0, 16.0)  # for dimensions: left, below, right, above
_TURN = np.linspace(0, 2 * np.pi, 181)
ROUND = np.stack([np.cos(_TURN), np.sin(_TURN)], axis=1)
SQUARE = np.array([[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0], [1.0, 1.0]])


def fitting_scale(width: float, height: float, box: Box, room: Box) -> tuple[float, str]:
    """Largest standard scale at which a body fits into a box with room around it, and its name."""
    across = (box[2] - box[0] - room[0] - room[2]) / width
    up = (box[3] - box[1] - room[1] - room[3]) / height
    scale = next((s for s in _SCALES if s <= min(across, up)), _SCALES[-1])
    return scale, f"{scale:g} : 1" if scale >= 1 else f"1 : {1 / scale:g}"


def draw_plan(sheet: Sheet, box: Box, cell: UnitCell, texts: Mapping[str, str], alone: bool) -> str:
    """Draw the cell (lengths in mm) as seen from above; ``alone``: its sides are edges of the plate.

    Returns
    -------
    the scale, such as ``5 : 1``
    """
    width, depth = cell.lattice.a1[0], cell.lattice.a2[1]
    scale, name = fitting_scale(width, depth, box, _ROOM)
    half = 0.5 * scale * np.array([width, depth])
    centre = np.array([
        0.5 * (box[0] + _ROOM[0] + box[2] - _ROOM[2]), 0.5 * (box[1] + _ROOM[1] + box[3] - _ROOM[3])
    ])  # fmt: skip
    (left, low), (right, high) = centre - half, centre + half
    sheet.line(centre + half * SQUARE, "outline" if alone else "period")
    if cell.pillar is not None:
        _draw_edges(sheet, cell.pillar, centre, scale)
    _draw_cutting_plane(sheet, centre, left, right)
    sheet.line([(centre[0], low - 3), (centre[0], high + 3)], "axis")
    sheet.across(low - 10, (left, right), low, texts["cell.pitch"])
    lane = left - 14
    sheet.upright(lane, [(low, left), (high, left)])
    upright = Label(texts.get("cell.pitch_y", texts["cell.pitch"]), (lane, centre[1]))
    sheet.labels(lane - 2.5, -1, [upright], low, high)
    sheet.text((centre[0], box[3] - 2), f"Plan of one cell   {name}", 10.0, ha="center")
    return name


def _draw_edges(sheet: Sheet, pillar: Pillar, centre: Array, scale: float) -> None:
    """Every edge as seen from above; thin where a fillet runs out smoothly, dashed where it is hidden."""
    shape = ROUND if pillar.section == "round" else SQUARE
    side = straight_side(pillar)
    smooth = 0
    if pillar.arc is not None:
        side, smooth = np.concatenate([[pillar.arc.at(0.0)], side]), 2
    for k, (half_width, _) in enumerate(side):
        # seen twice when the side is upright: drawn once, for its upper end
        if any(abs(other - half_width) < 1e-9 * pillar.diameter for other in side[k + 1 :, 0]):
            continue
        hidden = (side[k + 1 :, 0] > half_width).any()
        kind: Kind = "hidden" if hidden else "thin" if k < smooth and k + 1 < len(side) else "outline"
        upright = smooth and k and abs(side[k - 1, 0] - half_width) < 1e-9 * pillar.diameter
        sheet.line(centre + scale * half_width * shape, "outline" if upright and not hidden else kind)
    if pillar.section == "square":
        for (one, low), (other, high) in pairwise(side):
            if one > other and high > low:
                for corner in SQUARE[:4]:
                    sheet.line([centre + scale * one * corner, centre + scale * other * corner], "thin")


def _draw_cutting_plane(sheet: Sheet, centre: Array, left: float, right: float) -> None:
    sheet.line([(left - 3, centre[1]), (right + 3, centre[1])], "axis")
    for x, out in ((left - 3, -1), (right + 3, 1)):
        end = x + out * 3
        sheet.line([(x, centre[1]), (end, centre[1])])
        sheet.line([(end, centre[1]), (end, centre[1] + 4)], "thin")
        sheet.arrow((end, centre[1] + 6), (0, 1))
        sheet.text((end + out * 3, centre[1]), "A", 10.0, ha="center", bold=True)
