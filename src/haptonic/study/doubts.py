"""Remarks on values of a study that are unusual relative to one another."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import combinations
from typing import Any

from haptonic.cell import UnitCell
from haptonic.design.discs import stacks_of
from haptonic.fields import unusual_beside
from haptonic.plate.vibration.settings import ResponseSettings
from haptonic.study.plate_tables import PlateSettings
from haptonic.units import format_quantity

# relative to the speed of shear waves over the pitch; gaps of pillars in the templates lie between 0.03 and 1
USUAL_CARRIER = (0.01, 5.0)
USUAL_PATCH = (0.01, 5.0)  # thickness of a patch relative to that of the plate
USUAL_GRID = (0.001, 3.0)  # distance of the points of a map relative to the pitch
USUAL_WIDTH = (0.02, 100.0)  # sizes of a plate's parts in its plane, relative to the pitch
LENGTH = "m"


def doubts_of(carrier: float | None, cell: UnitCell, plate: PlateSettings | None) -> dict[str, str]:
    """Remarks, by path in the study, on ends of discs, a carrier and parts of a plate that are unusual."""
    pitch = format_quantity(cell.lattice.pitch, LENGTH)
    remarks = {}
    if carrier is not None:
        solid: Any = cell.material
        natural = math.sqrt(solid.stiffness[5][5] / solid.density) / cell.lattice.pitch
        words = f"for a pitch of {pitch} in {solid.name}"
        remarks["carrier"] = unusual_beside(carrier, "Hz", USUAL_CARRIER, natural, words)
    remarks |= dict(_covered_ends(cell))
    if plate is not None:
        remarks |= dict(_of_plate(plate, cell, f"for a pitch of {pitch}"))
        remarks |= _carrier_outside(carrier, plate.response)
    return remarks


def _covered_ends(cell: UnitCell) -> Iterator[tuple[str, str]]:
    """Remarks on ends of discs inside a later disc, which replaces them there."""
    for table, stack in stacks_of(cell).items():
        for (i, disc), (j, later) in combinations(enumerate(stack.discs), 2):
            (low, high), (start, stop) = disc.ends(stack.thickness), later.ends(stack.thickness)
            same = (disc.material, disc.empty) == (later.material, later.empty)
            if same or stack.border_of(j) < stack.border_of(i):
                continue
            at, replaced = f"cell.{table}disc[{i + 1}]", f"disc {j + 1} replaces it"
            begins, ends = (format_quantity(end - stack.thickness, LENGTH) for end in (start, stop))
            if low < start < high < stop:
                yield f"{at}.high", f"has no effect above {begins}, from where {replaced}"
            if start < low < stop < high:
                yield f"{at}.low", f"has no effect below {ends}, up to where {replaced}"


def _of_plate(plate: PlateSettings, cell: UnitCell, words: str) -> Iterator[tuple[str, str]]:
    pitch, thickness = cell.lattice.pitch, cell.thickness
    for number, patch in enumerate(plate.actuator, start=1):
        at, beside = (
            f"plate.actuator[{number}].size",
            f"on a plate {format_quantity(thickness, LENGTH)} thick",
        )
        for axis in (0, 1):
            yield (
                f"{at}[{axis + 1}]",
                unusual_beside(patch.size[axis], LENGTH, USUAL_WIDTH, pitch, words),
            )
        yield f"{at}[3]", unusual_beside(patch.size[2], LENGTH, USUAL_PATCH, thickness, beside)
    for table in ("widths", "heights"):
        for name, width in getattr(plate, table).items():
            yield f"plate.{table}.{name}", unusual_beside(width, LENGTH, USUAL_WIDTH, pitch, words)
    if plate.clamp is not None:
        yield "plate.clamp.corners", unusual_beside(plate.clamp.corners, LENGTH, USUAL_WIDTH, pitch, words)
    yield "plate.response.grid", unusual_beside(plate.response.grid, LENGTH, USUAL_GRID, pitch, words)


def _carrier_outside(carrier: float | None, asked: ResponseSettings) -> dict[str, str]:
    """Remark on a response whose range does not contain the carrier."""
    if carrier is None or asked.lowest <= carrier <= asked.highest:
        return {}
    ends = f"{format_quantity(asked.lowest, 'Hz')} to {format_quantity(asked.highest, 'Hz')}"
    return {
        "plate.response": f"{ends} does not contain the carrier, {format_quantity(carrier, 'Hz')}. Set "
        "lowest and highest around it"
    }
