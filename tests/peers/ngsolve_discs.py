"""Bloch waves of a plate with discs of several materials with NGSolve; see `ngsolve_cell`.

The solid of each material is cut out with OpenCascade, and all are glued, so that elements meet at the
interfaces. Elements along all edges within the cell are small, and split once towards them.
"""

from __future__ import annotations

import functools
import operator
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import ngsolve as ng
import numpy as np
from netgen.occ import Box, Cylinder, Glue, IdentificationType, OCCGeometry, X, Y, Z, gp_Trsf
from numpy.typing import NDArray

from haptonic.cell import Disc
from peers.ngsolve_cell import FOOT_RATIO, _arpack, _shifted_inverse

# Young's modulus (Pa), Poisson ratio, density (kg/m^3); or C11, C12, C44 (Pa) along x, y and z, density
Solid = tuple[float, float, float] | tuple[float, float, float, float]


@dataclass(frozen=True)
class PeerDisc:
    """A prism about the middle of the cell between two heights above the plate's lower face, m.

    solid : None where the disc is empty
    bars : widths (x, y) of rectangles about the axis that together are its section, m; none for a round one
    """

    diameter: float
    low: float
    high: float
    solid: Solid | None
    bars: tuple[tuple[float, float], ...] = ()

    @classmethod
    def of(cls, disc: Disc, thickness: float, solid: Solid | None) -> PeerDisc:
        """A disc of haptonic on a plate, of round, square or cross section."""
        width, arm = disc.diameter, disc.arm_width
        bars = {"round": (), "square": ((width, width),), "cross": ((width, arm), (arm, width))}
        return cls(width, *disc.ends(thickness), solid, bars=bars[disc.section])


def frequencies(
    pitch: float,
    thickness: float,
    plate: Solid,
    discs: Sequence[PeerDisc],
    kappas: Sequence[tuple[float, float]],
    count: int,
    *,
    order: int = 3,
    maxh: float | None = None,
    edge_size: float | None = None,
) -> NDArray[np.float64]:
    """(wavevectors, count) lowest frequencies, Hz, of a square lattice; later discs replace earlier ones."""
    modulus, density = plate[0], plate[-1]
    parts = [(Box((-0.5, -0.5, 0.0), (0.5, 0.5, thickness / pitch)), plate)]
    for disc in discs:
        tool = _solid(disc, pitch)
        parts = [(body - tool, solid) for body, solid in parts]
        if disc.solid is not None:
            parts.append((tool, disc.solid))
    for number, (body, _) in enumerate(parts):
        for solid in body.solids:
            solid.name = f"part{number}"
    whole = Glue([body for body, _ in parts])
    size = (edge_size or 0.2 * min(disc.diameter for disc in discs)) / pitch
    for edge in whole.edges:
        if max(abs(edge.center.x), abs(edge.center.y)) < 0.49:
            edge.maxh = size
            edge.hpref = 1
    for name, direction in (("a1", X), ("a2", Y)):
        whole.faces.Min(direction).Identify(
            whole.faces.Max(direction),
            name,
            IdentificationType.PERIODIC,
            gp_Trsf.Translation(1.0 * direction),
        )
    maxh = min(1.5 * thickness, 0.35 * pitch) if maxh is None else maxh
    mesh = ng.Mesh(
        OCCGeometry(whole).GenerateMesh(
            maxh=maxh / pitch, grading=0.5, curvaturesafety=1.0, parallel_meshing=False
        )
    )
    mesh.RefineHP(1, factor=FOOT_RATIO)
    mesh.Curve(order)

    def of_part(number: int) -> Any:
        return mesh.MaterialCF({f"part{k}": _constants(solid)[number] for k, (_, solid) in enumerate(parts)})

    first, mu, cubic = (of_part(number) / modulus for number in range(3))
    heavy = of_part(3) / density
    lowest = []
    for kappa in kappas:
        space = ng.Periodic(
            ng.VectorH1(mesh, order=order, complex=True), phase=[complex(np.exp(1j * k)) for k in kappa]
        )
        u, v = space.TnT()
        strain_u, strain_v = ng.Sym(ng.Grad(u)), ng.Sym(ng.Grad(v))
        energy = 2 * mu * ng.InnerProduct(strain_u, strain_v) + first * ng.div(u) * ng.div(v)
        energy += cubic * sum(strain_u[axis, axis] * strain_v[axis, axis] for axis in range(3))
        stiffness = ng.BilinearForm(energy * ng.dx).Assemble().mat
        mass = ng.BilinearForm(heavy * u * v * ng.dx).Assemble().mat
        squares = _arpack(stiffness, mass, _shifted_inverse(space, stiffness, mass), count)
        unit = np.sqrt(modulus / density) / (2 * np.pi * pitch)
        lowest.append(np.sqrt(np.maximum(np.sort(squares)[:count], 0.0)) * unit)
    return np.array(lowest)


def _constants(solid: Solid) -> tuple[float, float, float, float]:
    """Lamé's two constants, what a cubic crystal adds to them along its axes, and the density."""
    if len(solid) == 4:
        c11, c12, c44, density = solid
        return c12, c44, c11 - c12 - 2 * c44, density
    youngs, poisson, density = solid
    return (
        youngs * poisson / ((1 + poisson) * (1 - 2 * poisson)),
        youngs / (2 * (1 + poisson)),
        0.0,
        density,
    )


def _solid(disc: PeerDisc, pitch: float) -> Any:
    radius, low, high = 0.5 * disc.diameter / pitch, disc.low / pitch, disc.high / pitch
    if disc.bars:
        halves = 0.5 * np.array(disc.bars) / pitch
        boxes = [Box((-x, -y, low), (x, y, high)) for x, y in halves.tolist()]
        return functools.reduce(operator.add, boxes)
    return Cylinder((0.0, 0.0, low), Z, r=radius, h=high - low)
