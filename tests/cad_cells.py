"""Cells of discs as a CAD program would draw them: STEP files with a named solid for each material."""

import math
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from netgen import occ

from haptonic.cell import UnitCell
from haptonic.materials import Material

TO_MM = 1e3


def prism(corners: np.ndarray, low: float, high: float) -> Any:
    """An upright prism over a polygon (n, 2), m."""
    places = [occ.Pnt(x * TO_MM, y * TO_MM, low * TO_MM) for x, y in corners.tolist()]
    edges = [occ.Segment(a, b) for a, b in pairwise([*places, places[0]])]
    return occ.Prism(occ.Face(occ.Wire(edges)), occ.Vec(0, 0, (high - low) * TO_MM))


def cone(diameter: float, low: float, high: float, draft: float) -> Any:
    """A round body about the z axis between two heights, narrower at the upper one by a draft, rad."""
    radius, height = 0.5 * diameter, high - low
    if not draft:
        return occ.Cylinder(occ.Pnt(0, 0, low), occ.Z, r=radius, h=height)
    top = radius - height * math.tan(draft)
    return occ.Cone(occ.Axes((0, 0, low), occ.Z), radius, top, height, 2 * math.pi)


def step_of(
    cell: UnitCell, path: Path, corners: np.ndarray | None = None
) -> tuple[Path, dict[str, Material]]:
    """Write round discs, with and without draft, and square ones of a cell on one site.

    Also returns the materials of solids by name.

    corners : (n, 2) of another part of the lattice about the site, m
    """
    plate = prism(cell.corners if corners is None else corners, 0.0, cell.thickness)
    parts: list[tuple[Any, Material]] = [(plate, cell.material)]
    for disc in cell.disc:
        low, high = disc.ends(cell.thickness)
        if disc.section == "square":
            half = disc.diameter / 2
            tool = prism(half * np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]), low, high)
        else:
            tool = cone(disc.diameter * TO_MM, low * TO_MM, high * TO_MM, disc.draft)
        parts = [(body - tool, solid) for body, solid in parts]
        if not disc.empty:
            parts.append((tool, disc.material or cell.material))
    by_material: dict[str, tuple[Any, Material]] = {}
    for body, solid in parts:
        before = by_material.get(solid.name)
        by_material[solid.name] = (before[0] + body if before else body, solid)
    bodies = []
    for number, (body, _) in enumerate(by_material.values()):
        for solid in body.solids:
            solid.name = f"part {number}"
        bodies.append(body)
    (occ.Glue(bodies) if len(bodies) > 1 else bodies[0]).WriteStep(str(path))
    return path, {f"part {number}": solid for number, (_, solid) in enumerate(by_material.values())}
