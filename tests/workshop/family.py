"""Cells with a pillar of every kind, and some of extreme proportions."""

import math
from itertools import product

import numpy as np

from haptonic.cell import Pillar, Step, UnitCell
from haptonic.lattice import Lattice
from haptonic.materials import IsotropicMaterial, material
from haptonic.plate.layout.grid import Layout
from haptonic.plate.layout.parts import Actuator, Bond, Plate
from haptonic.plate.layout.supports import Support

MM = 1e-3
METAL = IsotropicMaterial(70e9, 0.33, 2700.0, 0.001, name="metal")
SQUARE = Lattice.square(7 * MM)
RECTANGLE = Lattice.rectangular(7 * MM, 9 * MM)


def cell(pillar: Pillar | None, lattice: Lattice = SQUARE, thickness: float = 1.5 * MM) -> UnitCell:
    return UnitCell(lattice, thickness, METAL, pillar)


def member(section: str, draft: float, fillet: float, step: Step | None) -> UnitCell:
    pillar = Pillar(3.5 * MM, 9 * MM, section, math.radians(draft), fillet, step)
    return cell(pillar, RECTANGLE)


FAMILY = {
    f"{section} draft {draft} fillet {fillet} step {bool(step)}": member(section, draft, fillet, step)
    for section, draft, fillet, step in product(
        ("round", "square"), (0, 2, -3), (0.0, 0.5 * MM), (None, Step(2 * MM, 5 * MM))
    )
} | {"no pillar": cell(None)}

EXTREME = {
    "reference": cell(Pillar(3.5 * MM, 14.7 * MM)),
    "slender": cell(Pillar(2 * MM, 16 * MM, draft=0.008), Lattice.square(2.2 * MM), 0.4 * MM),
    "hair": cell(Pillar(0.3 * MM, 12 * MM, fillet=0.1 * MM, step=Step(0.2 * MM, 0.3 * MM)), SQUARE, 0.2 * MM),
    "flat": cell(
        Pillar(18 * MM, 0.6 * MM, "round", 0.02, 0.1 * MM, Step(10 * MM, 0.3 * MM)),
        Lattice.square(20 * MM),
        0.3 * MM,
    ),
    "flat and undercut": cell(
        Pillar(16 * MM, 0.6 * MM, "square", -0.1, 0.1 * MM, Step(10 * MM, 0.3 * MM)),
        Lattice.square(20 * MM),
        0.3 * MM,
    ),
    "wide cell": cell(Pillar(1.5 * MM, 3 * MM), Lattice.rectangular(16 * MM, 4 * MM)),
}


def volume(cell: UnitCell, cells: int = 1) -> float:
    """Closed form, m^3."""
    return cells * (cell.lattice.area * cell.thickness + (cell.pillar.volume if cell.pillar else 0.0))


def enclosed(points, triangles) -> float:
    """Volume by the divergence theorem, of triangles that run anticlockwise when seen from outside."""
    a, b, c = np.moveaxis(points[triangles], 1, 0)
    return float(np.einsum("ij,ij->", a, np.cross(b, c)) / 6)


def is_watertight(triangles) -> bool:
    """Whether each edge has exactly two triangles, which run along it in opposite directions."""
    edges = np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    directed = set(map(tuple, edges.tolist()))
    return len(directed) == len(edges) and all((b, a) in directed for a, b in directed)


SLIM = Pillar(2 * MM, 8 * MM, "square", fillet=0.4 * MM, step=Step(1.5 * MM, 5 * MM))
OWN = cell(Pillar(3 * MM, 9 * MM, fillet=0.3 * MM, draft=0.01), RECTANGLE)
LATTICES = {"lattice": OWN, "slim": cell(SLIM, RECTANGLE), "tall": cell(Pillar(3.5 * MM, 11 * MM), RECTANGLE)}


def plate(
    rows: str,
    actuators: tuple[Actuator, ...] = (),
    kind: type[Layout] = Layout,
    supports: tuple[Support, ...] = (),
) -> Plate:
    """A map: o, s and t are tiles of lattices, digits those of regions, a point is none; rows from above."""
    names = {"o": "lattice", "s": "slim", "t": "tall", ".": None}
    tiles = tuple(tuple(names.get(c, c) for c in row) for row in reversed(rows.split()))
    x, y = (
        tuple(side * k for k in range(n + 1)) for side, n in ((7 * MM, len(tiles[0])), (9 * MM, len(tiles)))
    )
    used = {name for row in tiles for name in row}
    cells = {name: cell for name, cell in LATTICES.items() if name in used}
    return Plate(kind(tiles, x, y, cells, 1.5 * MM, METAL), supports, actuators)


GLUE = Bond(50e-6, material("silver-epoxy"))
PATCH = Actuator("A1", (24.5 * MM, 4 * MM), (6 * MM, 5 * MM, 0.5 * MM), material("pzt-5a"), GLUE)
HOLDS = (
    Support("corners", "clamped", length=8 * MM),
    Support("left", "simple"),
    Support("top", "spring", stiffness=1e12),
)
PLATES = {
    "touchpad": plate("ooo1111ooo2222ooo " * 6, (PATCH,)),
    "hole and cut corner": plate("ooo1ss. ooo1sst oo..sst ooo1sst", (PATCH,), supports=HOLDS),
    "plain": plate("11 11"),
    "long": plate("o" * 40),
}
