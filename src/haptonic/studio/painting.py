"""Facts from which the page draws and paints the plate of a study, without any computation."""

from __future__ import annotations

from typing import Any

from haptonic.analyses import plan
from haptonic.analyses.options import NoOptions
from haptonic.analyses.runner import Runner
from haptonic.errors import HaptonicError
from haptonic.plate.layout.drawing import drawing_of
from haptonic.plate.layout.parts import Actuator, Finger, Force, Plate
from haptonic.results.plan import border_text
from haptonic.study import Study
from haptonic.study.plate_tables import LATTICE
from haptonic.study.plating import lattices, lines_of_map, plate_of
from haptonic.workshop import Part

FIRST = {"map": "oooooo\n" * 4, "tiles": {"o": LATTICE}}  # of a study without a plate


def painting(study: Study) -> dict[str, Any] | None:
    """Lines of the map, outlines, parts, mass and remarks of the study's plate; None without a plate.

    ``x`` and ``y`` are the lines between the letters of the map, m; ``lattices`` are the names that mean a
    lattice; ``parts`` are everything that can be moved, with the steps to its table, its centre on the plate
    and the corner that its key counts from.
    """
    section = study.plate_settings
    if section is None:
        return None
    plate = plate_of(section, study.cell)
    x, y = lines_of_map(section, study.cell)
    tables: dict[str, tuple[Actuator | Force, ...]] = {
        "actuator": section.actuator, "force": section.force,
    }  # fmt: skip
    given: list[tuple[list[str | int], Actuator | Force | Finger]] = [
        (["plate", table, number], part)
        for table, parts in tables.items()
        for number, part in enumerate(parts)
    ]
    given += [(["plate", "finger"], section.finger)] if section.finger else []
    placed = [*plate.drives, *([plate.finger] if plate.finger else [])]
    parts = [
        {
            "steps": steps,
            "name": getattr(part, "name", "finger"),
            "centre": list(on_plate.centre),
            "corner": [on_plate.centre[axis] - part.centre[axis] for axis in (0, 1)],
            "size": list(getattr(part, "size", None) or ()),
            "diameter": getattr(part, "diameter", None),
        }
        for (steps, part), on_plate in zip(given, placed, strict=True)
    ]
    return {
        "x": x,
        "y": y,
        "lattices": [name for name, _ in lattices(section.cell, study.cell, "plate.cell")],
        "parts": parts,
        "clamp": section.clamp and section.clamp.corners,
        "mass": _mass(plate, study),
        "contents": plate.layout.parts,
        "remarks": border_text(plate.layout),
        **drawing_of(plate),
    }


def _mass(plate: Plate, study: Study) -> float | None:
    """Mass of plate and pillars without patches, kg; None for cells of a file and for too many pillars."""
    if any(cell.solid is not None for cell in plate.layout.cells.values()):
        return None
    try:
        return Part.whole(plate, study.cell).mass
    except HaptonicError:  # too many pillars for a drawing, or tiles that touch at a corner only
        return None


def forecast(study: Study) -> list[dict[str, Any]]:
    """Name, class of time and memory of every command that `haptonic plan` lists, or why it is refused."""
    costs = plan.compute(study, NoOptions(), Runner()).costs
    return [
        {
            "command": name,
            "time": cost.time,
            "memory": cost.gigabytes,
            "refusal": "" if cost.refusal is None else cost.refusal.cause,
        }
        for name, cost in costs.items()
    ]
