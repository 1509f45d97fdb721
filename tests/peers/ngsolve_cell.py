"""Bloch waves of one plate-with-pillar cell with NGSolve: an independent peer for tests and benchmarks.

Nothing here comes from haptonic, and nothing is shared with it but the mathematics: an OpenCascade solid,
curved tetrahedra, hierarchical polynomials, quasi-periodic spaces, a complex Hermitian eigenproblem solved
point by point. The mesh is made once (`meshed`) and serves every wavevector (`CellModel.solve`):

    model = meshed(cell, order=3)
    model.solve((np.pi, np.pi), count=8).frequencies

The pillar's foot is a re-entrant edge where the stress is singular. Small isotropic elements cure that
slowly, so the elements that touch the edge are split towards it instead (NGSolve's geometric hp-refinement).

Threads are the caller's: `with ng.TaskManager():` around `solve` makes assembly and factorisation parallel.
Do not on a busy machine: its threads spin while they wait, and a tenth of a second becomes many seconds.

Lengths are scaled by the first pitch, stiffness by Young's modulus and mass by the density before anything
is meshed or factorised: OpenCascade's tolerances are absolute, and the matrices are then of order one.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from time import perf_counter
from typing import Any, Literal

import ngsolve as ng
import numpy as np
from netgen.occ import (
    ArcOfCircle,
    Axes,
    Axis,
    Box,
    Cylinder,
    Face,
    IdentificationType,
    OCCGeometry,
    Segment,
    Wire,
    WorkPlane,
    X,
    Y,
    Z,
    gp_Dir,
    gp_Pnt,
    gp_Trsf,
    gp_Vec,
)
from numpy.typing import NDArray
from scipy.sparse.linalg import LinearOperator, eigsh

Solver = Literal["arpack", "arnoldi"]

SHIFT = -0.01
"""Shift of the inverse in units of E / (rho pitch_x^2), about -(pitch_x omega / c)^2 of the lowest bands.
Negative, so that the shifted matrix is positive definite even where the plate is free to translate."""


FOOT_RATIO = 0.08
"""Thickness of an hp-refinement layer at the foot over that of the next one outwards."""


@dataclass(frozen=True)
class PeerCell:
    """A rectangular plate cell with a pillar at its centre, isotropic and lossless; SI units, draft in rad.

    The pillar is round or square and `diameter` wide at its foot; `fillet` is the radius of an arc that
    touches the plate's top and the pillar's side, for round pillars only. An upright pillar of another
    section has the corners (x, y) of a polygon, m, or an ellipse's half-axes and the angle of the first, rad.
    """

    pitch_x: float
    pitch_y: float
    thickness: float
    diameter: float
    height: float
    youngs_modulus: float
    poisson_ratio: float
    density: float
    section: Literal["round", "square"] = "round"
    draft: float = 0.0
    fillet: float = 0.0
    corners: tuple[tuple[float, float], ...] = ()
    ellipse: tuple[float, float, float] | None = None

    @property
    def frequency_unit(self) -> float:
        """Hz per unit of the dimensionless angular frequency: sqrt(E / rho) / (2 pi pitch_x)."""
        return float(np.sqrt(self.youngs_modulus / self.density) / (2 * np.pi * self.pitch_x))


@dataclass(frozen=True)
class BlochSolution:
    """Lowest Bloch waves at one wavevector, and what they cost."""

    kappa: tuple[float, float]
    frequencies: NDArray[np.float64]  # (count,), Hz, ascending; rigid translations at Gamma give about 0
    unknowns: int  # complex degrees of freedom after the periodic identification
    assembly_seconds: float
    factor_seconds: float  # part of eigen_seconds for "arnoldi", which factorises by itself
    eigen_seconds: float

    @property
    def seconds(self) -> float:
        """Wall time of this k-point, mesh excluded."""
        return self.assembly_seconds + self.factor_seconds + self.eigen_seconds


@dataclass(frozen=True)
class CellModel:
    """A meshed cell: all that does not depend on the wavevector."""

    cell: PeerCell
    mesh: ng.Mesh
    order: int
    mesh_seconds: float

    def solve(self, kappa: tuple[float, float], count: int, *, solver: Solver = "arpack") -> BlochSolution:
        """The `count` lowest Bloch waves with u(x + a_j) = exp(i kappa_j) u(x), kappa in radians.

        `solver` is "arpack" (SciPy's implicitly restarted Lanczos around one NGSolve factorisation) or
        "arnoldi" (NGSolve's own: one unrestarted Krylov space of twice the modes asked for).
        """
        start = perf_counter()
        space = ng.Periodic(
            ng.VectorH1(self.mesh, order=self.order, complex=True),
            phase=[complex(np.exp(1j * angle)) for angle in kappa],
        )
        stiffness, mass = _assembled(space, self.cell.poisson_ratio)
        assembled = perf_counter()
        if solver == "arnoldi":
            factorised = assembled
            squares = _arnoldi(space, stiffness, mass, count)
        else:
            inverse = _shifted_inverse(space, stiffness, mass)
            factorised = perf_counter()
            squares = _arpack(stiffness, mass, inverse, count)
        return BlochSolution(
            kappa=kappa,
            frequencies=np.sqrt(np.maximum(np.sort(squares)[:count], 0.0)) * self.cell.frequency_unit,
            unknowns=sum(space.FreeDofs()),
            assembly_seconds=assembled - start,
            factor_seconds=factorised - assembled,
            eigen_seconds=perf_counter() - factorised,
        )


def meshed(
    cell: PeerCell,
    *,
    order: int = 3,
    maxh: float | None = None,
    foot_size: float | None = None,
    foot_layers: int = 1,
) -> CellModel:
    """The cell's periodic mesh of curved elements of polynomial `order`.

    Parameters
    ----------
    maxh
        Largest element size in m; by default 1.5 plate thicknesses, at most 0.7 pillar diameters.
    foot_size
        Element size along the pillar's foot edge in m, by default a fifth of the diameter.
    foot_layers
        How many times the elements at the foot edge are split towards it, each time by `FOOT_RATIO`.
    """
    start = perf_counter()
    unit = cell.pitch_x
    pitch_x, pitch_y = 1.0, cell.pitch_y / unit
    thickness, radius, height = cell.thickness / unit, cell.diameter / 2 / unit, cell.height / unit
    maxh = min(1.5 * cell.thickness, 0.7 * cell.diameter) if maxh is None else maxh
    foot_size = 0.2 * cell.diameter if foot_size is None else foot_size

    plate = Box((-pitch_x / 2, -pitch_y / 2, 0.0), (pitch_x / 2, pitch_y / 2, thickness))
    is_plain = not (cell.draft or cell.fillet or cell.corners or cell.ellipse)
    if cell.section == "round" and is_plain:
        pillar = Cylinder((0.0, 0.0, thickness), Z, r=radius, h=height)
    else:
        pillar = _pillar(cell)
    body = plate + pillar
    if cell.fillet:
        foot_layers = 0  # no edge, no singularity
        for face in body.faces:
            inside = thickness + 1e-6 < face.center.z < thickness + cell.fillet / unit
            if inside and max(abs(face.center.x), abs(face.center.y)) < 0.49 * min(pitch_x, pitch_y):
                face.maxh = foot_size / unit
    else:
        on_top = [edge for edge in body.edges if abs(edge.center.z - thickness) < 1e-6]
        within = 0.25 * (radius + 0.5 * min(pitch_x, pitch_y)) + 0.5 * radius
        for foot in on_top:
            if max(abs(foot.center.x), abs(foot.center.y)) < within:
                foot.maxh = foot_size / unit
                foot.hpref = 1
    for name, direction, pitch in (("a1", X, pitch_x), ("a2", Y, pitch_y)):
        shift = gp_Trsf.Translation(pitch * direction)
        body.faces.Min(direction).Identify(
            body.faces.Max(direction), name, IdentificationType.PERIODIC, shift
        )

    mesh = ng.Mesh(
        OCCGeometry(body).GenerateMesh(
            maxh=maxh / unit,
            grading=0.5,
            curvaturesafety=1.0,  # at the default of 2, the pillar's curvature alone decides on the size
            parallel_meshing=False,
        )
    )
    if foot_layers:
        mesh.RefineHP(foot_layers, factor=FOOT_RATIO)
    mesh.Curve(order)
    return CellModel(cell, mesh, order, perf_counter() - start)


def meshed_sites(
    cell: PeerCell,
    vectors: NDArray[np.float64],
    places: NDArray[np.float64],
    heights: Sequence[float],
    *,
    order: int = 3,
) -> CellModel:
    """The same of a cell of any translations (2, 2), rows in m, with round pillars of the cell's diameter.

    They are at the places (n, 2), m, inside the parallelogram of the translations; ``heights`` in m.
    """
    start = perf_counter()
    unit = cell.pitch_x
    first, second = (gp_Vec(*(float(v) for v in row / unit), 0.0) for row in vectors)
    thickness, radius = cell.thickness / unit, cell.diameter / 2 / unit
    origin = gp_Pnt(0.0, 0.0, 0.0)
    corners = [origin, origin + first, origin + first + second, origin + second]
    sides = [Segment(a, b) for a, b in pairwise([*corners, origin])]
    body = Face(Wire(sides)).Extrude(thickness * Z)
    for (x, y), height in zip(places / unit, heights, strict=True):
        body += Cylinder((float(x), float(y), thickness), Z, r=radius, h=height / unit)
    for foot in body.edges:
        if abs(foot.center.z - thickness) < 1e-6 and any(
            np.hypot(foot.center.x - x, foot.center.y - y) < 0.1 * radius for x, y in places / unit
        ):
            foot.maxh = 0.2 * cell.diameter / unit
            foot.hpref = 1
    middle = 0.5 * vectors.sum(axis=0) / unit
    for name, row, shift in (("a1", 0, first), ("a2", 1, second)):
        near = middle - 0.5 * vectors[row] / unit
        low, high = (
            min(body.faces, key=lambda face, at=at: np.linalg.norm(_centre(face) - [*at, 0.5 * thickness]))
            for at in (near, near + vectors[row] / unit)
        )
        low.Identify(high, name, IdentificationType.PERIODIC, gp_Trsf.Translation(shift))
    maxh = min(1.5 * cell.thickness, 0.7 * cell.diameter)
    mesh = ng.Mesh(
        OCCGeometry(body).GenerateMesh(
            maxh=maxh / unit, grading=0.5, curvaturesafety=1.0, parallel_meshing=False
        )
    )
    mesh.RefineHP(1, factor=FOOT_RATIO)
    mesh.Curve(order)
    return CellModel(cell, mesh, order, perf_counter() - start)


def _centre(face: Any) -> NDArray[np.float64]:
    return np.array([face.center.x, face.center.y, face.center.z])


def _pillar(cell: PeerCell) -> Any:
    """Solid of a pillar with a draft, a fillet or a square section, in units of the first pitch."""
    unit = cell.pitch_x
    thickness, radius, height = cell.thickness / unit, cell.diameter / 2 / unit, cell.height / unit
    tip = radius - height * np.tan(cell.draft)
    if cell.corners:
        points = [gp_Pnt(x / unit, y / unit, thickness) for x, y in cell.corners]
        return Face(Wire([Segment(a, b) for a, b in pairwise([*points, points[0]])])).Extrude(height * Z)
    if cell.ellipse:
        along, across, turn = cell.ellipse
        large, small = max(along, across), min(along, across)
        turn += 0.0 if along == large else np.pi / 2
        plane = WorkPlane(Axes((0.0, 0.0, thickness), Z, gp_Dir(np.cos(turn), np.sin(turn), 0.0)))
        return plane.Ellipse(large / unit, small / unit).Face().Extrude(height * Z)
    if cell.section == "square":
        assert cell.draft == cell.fillet == 0, "a square pillar of this peer is a straight prism"
        return Box((-radius, -radius, thickness), (radius, radius, thickness + height))
    low, high = (0.0, 0.0, thickness), (0.0, 0.0, thickness + height)
    corners = [low, (radius, 0.0, thickness), (tip, 0.0, thickness + height), high]
    sides = [Segment(start, end) for start, end in pairwise(corners)]
    if cell.fillet:
        size = cell.fillet / unit
        # on the bisector of plate and side, whose angle is 90 degrees plus the draft
        centre = radius + size * np.tan(np.pi / 4 - cell.draft / 2)
        angle = np.pi / 2 - cell.draft  # that the arc turns through
        end = (centre - size * np.sin(angle), 0.0, thickness + size * (1 - np.cos(angle)))
        middle = (
            centre - size * np.sin(angle / 2), 0.0, thickness + size * (1 - np.cos(angle / 2)),
        )  # fmt: skip
        arc = ArcOfCircle(gp_Pnt(centre, 0.0, thickness), gp_Pnt(*middle), gp_Pnt(*end))
        sides = [Segment(low, (centre, 0.0, thickness)), arc, Segment(end, corners[2]), sides[-1]]
    face = Face(Wire([*sides, Segment(high, low)]))
    return face.Revolve(Axis(gp_Pnt(0.0, 0.0, 0.0), Z), 360)


def bloch_frequencies(
    cell: PeerCell,
    kappa: tuple[float, float],
    count: int,
    *,
    order: int = 3,
    maxh: float | None = None,
    foot_size: float | None = None,
) -> NDArray[np.float64]:
    """The `count` lowest frequencies in Hz at one wavevector; see `meshed` and `CellModel.solve`."""
    return meshed(cell, order=order, maxh=maxh, foot_size=foot_size).solve(kappa, count).frequencies


def _assembled(space: ng.FESpace, poisson: float) -> tuple[ng.BaseMatrix, ng.BaseMatrix]:
    """Stiffness and mass for E = rho = 1. The forms are bilinear: the space puts in P^H A P by itself."""
    lame_mu = 1 / (2 * (1 + poisson))
    lame_lambda = poisson / ((1 + poisson) * (1 - 2 * poisson))
    u, v = space.TnT()
    strain_u, strain_v = ng.Sym(ng.Grad(u)), ng.Sym(ng.Grad(v))
    energy = 2 * lame_mu * ng.InnerProduct(strain_u, strain_v) + lame_lambda * ng.div(u) * ng.div(v)
    return ng.BilinearForm(energy * ng.dx).Assemble().mat, ng.BilinearForm(u * v * ng.dx).Assemble().mat


def _shifted_inverse(space: ng.FESpace, stiffness: ng.BaseMatrix, mass: ng.BaseMatrix) -> ng.BaseMatrix:
    """Factorised K - SHIFT M on the master unknowns.

    Not with NGSolve's "sparsecholesky": it takes a complex matrix for symmetric, and is silently wrong here.
    MKL Pardiso's default of 16 refinement steps would make each solve ten times slower.
    """
    shifted = stiffness.CreateMatrix()
    shifted.AsVector().data = stiffness.AsVector() - SHIFT * mass.AsVector()
    shifted.inverse_flags = {"ordering": "metis", "refinement": 0}
    return shifted.Inverse(space.FreeDofs(), inverse=_direct_solver())


def _direct_solver() -> str:
    """MKL Pardiso where its library is installed, else UMFPACK; both treat the matrix as unsymmetric."""
    return "pardiso" if ng.la.BaseMatrix.GetDefaultInverseType() == "pardiso" else "umfpack"


def _arpack(stiffness: ng.BaseMatrix, mass: ng.BaseMatrix, inverse: ng.BaseMatrix, count: int) -> NDArray:
    """Eigenvalues nearest SHIFT. Slave unknowns have empty rows in M and in the inverse: no harm."""
    source, target = stiffness.CreateColVector(), stiffness.CreateColVector()

    def operator(matrix: ng.BaseMatrix) -> LinearOperator:
        def apply(values: NDArray[np.complex128]) -> NDArray[np.complex128]:
            source.FV().NumPy()[:] = values
            target.data = matrix * source
            return target.FV().NumPy().copy()

        return LinearOperator((len(source), len(source)), matvec=apply, dtype=complex)

    return eigsh(
        operator(stiffness),
        k=count + 2,  # so that a multiple eigenvalue is not cut at the end
        M=operator(mass),
        sigma=SHIFT,
        OPinv=operator(inverse),
        v0=np.random.default_rng(1).standard_normal(len(source)).astype(complex),
        tol=1e-9,
        return_eigenvectors=False,
    )


def _arnoldi(space: ng.FESpace, stiffness: ng.BaseMatrix, mass: ng.BaseMatrix, count: int) -> NDArray:
    """As `_arpack`; without restarts the last few of the modes asked for are poor, hence four more."""
    field = ng.GridFunction(space, multidim=count + 4)
    values = ng.ArnoldiSolver(
        stiffness, mass, space.FreeDofs(), list(field.vecs), shift=SHIFT, inverse=_direct_solver()
    )
    return np.real(np.array(values))
