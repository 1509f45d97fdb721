"""Cells from files: solids of a STEP file, meshed by Netgen, or a mesh, assembled by NGSolve.

Both libraries run in the reading process, so that a crash becomes an ordinary error. Lengths are in units of
a tenth of the pitch; the plate's lower face is at z = 0, the centre of the tile at x = y = 0.
"""

from __future__ import annotations

from functools import lru_cache
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.foreign.meshes import MeshPeriod
from haptonic.foreign.periods import SAME, SAME_VOLUME, DrawnPeriod

ROUNDING = 1e-8  # values below are rounding errors of values near one


def inspected(path: str, turns: NDArray[Any], **drawn: Any) -> dict[str, Any]:
    """Contents of a file for one period of a plate.

    Parameters
    ----------
    turns : (n, 2, 2) orthogonal maps of the plane
    drawn : see `period_of`

    Returns
    -------
    ``names`` of the solids, or of the groups of a mesh, for materials; ``problem``, empty if they form a
    period, otherwise its kind, with its ``number``, ``place`` and ``text``. For a period also ``parts``,
    names of the parts that may have different materials, with ``volumes``, m^3; ``kept`` (n,) True for each
    map that leaves them unchanged; ``elements`` before refinement, as the number of tetrahedra with as many
    unknowns; ``whole_below`` True if the plate's lower face is whole and nothing lies below it; ``straight``
    True for a mesh whose edges are all straight
    """
    period = period_of(path, **drawn)
    whole = not period.problem
    return {
        "names": period.names,
        "problem": period.problem,
        "number": float(period.number),
        "place": period.place,
        "text": period.text,
        "parts": period.part_names if whole else [],
        "volumes": [volume * period.metres**3 for volume in period.volumes] if whole else [],
        "kept": np.array([period.is_kept(turn) for turn in turns] if whole else [], dtype=np.uint8),
        "elements": period.elements if whole else 0.0,
        "whole_below": whole and _is_whole_below(period),
        "straight": whole and period.is_straight,
    }


def assembled(
    path: str,
    order: int,
    rings: int,
    stiffness: NDArray[Any],
    density: NDArray[Any],
    along: NDArray[Any],
    upward: NDArray[Any],
    inside: NDArray[Any],
    **drawn: Any,
) -> dict[str, Any]:
    """Matrices of a period on elements of an order; meshes of solids are refined towards singular edges.

    Parameters
    ----------
    drawn : see `period_of`
    rings : number of subdivisions of elements at such edges
    stiffness, density : (solids, 6, 6) Pa and (solids,) kg/m^3
    along, upward : places of the trace's nodes on each piece of a side and through the thickness, from 0 to 1
    inside : the same of nodes along either axis of an element of the order

    Returns
    -------
    In SI units: ``stiffness`` of (component, scalar unknown) and ``mass`` of scalar unknowns, each as rows,
    columns and values; ``lateral`` scalar unknowns on the lateral faces and ``trace`` (lateral, levels x
    places), their values from those of the trace; ``above`` like the mass, for the parts beyond the plate's
    faces; ``points`` (n, 3) of the surface, ``cells`` (m, 4) quadrilaterals of it, seen from outside
    anticlockwise, ``lower`` (faces, n, n) nodes of quadrilaterals on the face at z = 0, and ``shown``, values
    at the points from unknowns; ``degree`` of the polynomial of each scalar unknown, see `_degrees`;
    ``near`` like the stiffness, of elements near singular edges, None if these may be all.
    """
    import ngsolve as ng

    period = period_of(path, **drawn)
    mesh = period.elements_of(order, rings)
    metres = period.metres
    scalar = ng.H1(mesh, order=order)
    names = [f"part{number}" for number in range(len(period.part_names))]
    heavy = mesh.MaterialCF(dict(zip(names, density.tolist(), strict=True)))
    tensors = [ng.CF(tuple(matrix.ravel().tolist()), dims=(6, 6)) for matrix in stiffness]
    hooke = mesh.MaterialCF(dict(zip(names, tensors, strict=True)))
    vector = ng.VectorH1(mesh, order=order)
    u, v = vector.TnT()
    work = ng.InnerProduct(hooke * _strain(ng.Grad(u)), _strain(ng.Grad(v)))
    form = ng.BilinearForm(work * ng.dx).Assemble()
    marked = period.near_edges(mesh)
    near = None
    if marked is not None:
        near = _triplets(ng.BilinearForm(work * ng.dx(definedonelements=marked)).Assemble(), metres)
    a, b = scalar.TnT()
    mass = ng.BilinearForm(heavy * a * b * ng.dx).Assemble()
    beyond = ng.IfPos(ng.z - period.thickness, 1.0, ng.IfPos(ng.z, 0.0, 1.0))
    above = ng.BilinearForm(beyond * heavy * a * b * ng.dx).Assemble()
    lateral, trace = _trace(mesh, scalar, period, along, upward)
    points, cells, lower, shown = _surface(mesh, scalar, inside)
    return {
        "stiffness": _triplets(form, metres),
        "mass": _triplets(mass, metres**3),
        "above": _triplets(above, metres**3),
        "unknowns": scalar.ndof,
        "lateral": lateral,
        "trace": trace,
        "points": points * metres,
        "cells": cells,
        "lower": lower,
        "shown": shown,
        "degree": _degrees(mesh, scalar, order),
        "near": near,
    }


def _degrees(mesh: Any, scalar: Any, order: int) -> NDArray[np.int64]:
    """Degree of the polynomial of each scalar unknown; lower ones than ``order - 2`` count as of this degree.

    Polynomials are hierarchical: in any field of a lower order, their values are zero.
    """
    import ngsolve as ng

    degree = np.full(scalar.ndof, order)
    for lower in range(order - 1, max(order - 3, 0), -1):
        below = ng.GridFunction(ng.H1(mesh, order=lower))
        values = below.vec.FV().NumPy()
        values[:] = np.random.default_rng(0).uniform(1.0, 2.0, len(values))
        embedded = ng.GridFunction(scalar)
        embedded.Set(below)
        degree[np.abs(embedded.vec.FV().NumPy()) > ROUNDING] = lower
    return degree


def period_of(
    path: str,
    *,
    digest: str,
    tile: NDArray[Any],
    vectors: NDArray[Any],
    thickness: float,
    unit: float,
    with_material: list[str],
) -> DrawnPeriod | MeshPeriod:
    """One period of a plate from the solids of a STEP file, or from a mesh.

    Parameters
    ----------
    digest : of the file, so that a changed file is read again
    tile : (sides, 2) corners of the repeated polygon, anticlockwise; vectors : (2, 2) translations;
        thickness : of the plate, all in m
    unit : unit of length of a mesh, m; zero for a STEP file, which contains its unit
    with_material : groups of a mesh for which materials are given
    """
    polygon, steps = (tuple(map(tuple, np.asarray(rows).tolist())) for rows in (tile, vectors))
    return _period(path, digest, polygon, steps, float(thickness), float(unit), tuple(with_material))


@lru_cache(maxsize=2)
def _period(
    path: str,
    digest: str,
    tile: tuple[tuple[float, ...], ...],
    vectors: tuple[tuple[float, ...], ...],
    thickness: float,
    unit: float,
    with_material: tuple[str, ...],
) -> DrawnPeriod | MeshPeriod:
    shape = np.array(tile), np.array(vectors), thickness
    return MeshPeriod(path, *shape, unit, with_material) if unit else DrawnPeriod(path, *shape)


def _strain(gradient: Any) -> Any:
    """Strain in Voigt's order 11, 22, 33, 23, 13, 12, shear as angles."""
    import ngsolve as ng

    pairs = ((1, 2), (0, 2), (0, 1))
    return ng.CF((
        *(gradient[k, k] for k in range(3)), *(gradient[i, j] + gradient[j, i] for i, j in pairs)
    ))  # fmt: skip


def _triplets(form: Any, factor: float) -> dict[str, Any]:
    values, columns, starts = form.mat.CSR()
    return {
        "values": factor * np.array(values),
        "columns": np.array(columns, dtype=np.int32),
        "starts": np.array(starts, dtype=np.int64),
    }


def _trace(
    mesh: Any, scalar: Any, period: DrawnPeriod | MeshPeriod, along: NDArray[Any], upward: NDArray[Any]
) -> tuple[NDArray[np.int64], NDArray[Any]]:
    """Unknowns on the lateral faces, and their values (unknowns, levels x places) by value of the trace.

    A trace is a polynomial along each side piece and through the thickness, given by its values at the nodes;
    the unknowns are its least-squares projection.
    """
    import ngsolve as ng
    import scipy.sparse as sp
    import scipy.sparse.linalg as sparse_linalg

    marked = scalar.GetDofs(mesh.Boundaries("side.*"))
    lateral = np.flatnonzero([marked[number] for number in range(scalar.ndof)])
    a, b = scalar.TnT()
    form = ng.BilinearForm(a * b * ng.ds("side.*")).Assemble()  # keeps its matrix alive
    values, columns, starts = form.mat.CSR()
    gram = sp.csr_matrix((np.array(values), np.array(columns), np.array(starts)))[lateral][:, lateral]
    of_power = [np.linalg.inv(np.vander(nodes, increasing=True)) for nodes in (along, upward)]
    order, levels, count = len(along) - 1, len(upward), len(period.pieces)
    moments = np.zeros((len(lateral), levels, count * order))
    for number, (start, end) in enumerate(period.pieces):
        step = (end - start) / np.sum((end - start) ** 2)
        s = (ng.x - start[0]) * step[0] + (ng.y - start[1]) * step[1]
        powers = np.empty((len(lateral), order + 1, levels))
        for i, j in product(range(order + 1), range(levels)):
            work = ng.LinearForm(
                s**i * (ng.z / period.thickness) ** j * b * ng.ds(f"side{number}", bonus_intorder=order)
            )
            powers[:, i, j] = work.Assemble().vec.FV().NumPy()[lateral]
        values_of_piece = np.einsum("nij,ia,jl->nla", powers, *of_power)
        places = (number * order + np.arange(order + 1)) % (count * order)
        for place, values_there in zip(places.tolist(), np.moveaxis(values_of_piece, 2, 0), strict=True):
            moments[:, :, place] += values_there
    solved = sparse_linalg.splu(gram.tocsc()).solve(moments.reshape(len(lateral), -1))
    return lateral, np.asarray(solved)


def _surface(
    mesh: Any, scalar: Any, inside: NDArray[Any]
) -> tuple[NDArray[Any], NDArray[np.int64], NDArray[np.int64], dict[str, Any]]:
    """Points of the surface, quadrilaterals between them, faces at z = 0, and values at the points.

    A triangle is three quadrilaterals. Those at z = 0 have nodes at shares ``inside`` (n,) of either axis, so
    many that the polynomials of elements, and of their curved edges, follow from values there.

    Returns
    -------
    points (k, 3), cells (m, 4), lower (faces, n, n), numbers of points, and values there from unknowns
    """
    import ngsolve as ng

    third, halves = (1 / 3, 1 / 3), {(0, 1): (0.5, 0.5), (1, 2): (0.0, 0.5), (2, 0): (0.5, 0.0)}
    corners = ((1.0, 0.0), (0.0, 1.0), (0.0, 0.0))
    quarters = {
        3: [(corners[k], halves[k, (k + 1) % 3], third, halves[(k + 2) % 3, k]) for k in range(3)],
        4: [((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0))],
    }
    coarse = {3: np.array([0.0, 1.0]), 4: np.array([0.0, 0.5, 1.0])}
    grids = {
        (sides, is_lower): np.stack([_grid(np.array(each), nodes) for each in quarters[sides]])
        for sides in quarters
        for is_lower, nodes in ((False, coarse[sides]), (True, inside))
    }
    number: dict[tuple[int, ...], int] = {}
    points: list[NDArray[Any]] = []
    rows: list[tuple[int, list[int], NDArray[Any]]] = []
    cells: list[NDArray[np.int64]] = []
    lower: list[NDArray[np.int64]] = []
    place, normal = ng.CF((ng.x, ng.y, ng.z)), ng.specialcf.normal(3)
    of_face = mesh.ngmesh.FaceDescriptors()
    for element in mesh.Elements(ng.BND):
        face = of_face[element.index]
        if face.domin and face.domout:
            continue  # between two solids
        is_lower = all(abs(mesh[vertex].point[2]) < SAME for vertex in element.vertices)
        local = grids[len(element.vertices), is_lower]
        places = local.reshape(-1, 2).tolist()
        mapped = mesh.GetTrafo(element)(
            ng.IntegrationRule([(*at, 0.0) for at in places], [1.0] * len(places))
        )
        here, outward = np.array(place(mapped)), np.array(normal(mapped))[-1]
        own = []
        for at, spot in zip(places, here, strict=True):
            key = tuple(np.round(spot / SAME).astype(int).tolist())
            if key not in number:
                number[key] = len(points)
                points.append(spot)
                shape = np.array(scalar.GetFE(element).CalcShape(*at))
                rows.append((number[key], list(scalar.GetDofNrs(element)), shape))
            own.append(number[key])
        numbers, spots = np.array(own).reshape(local.shape[:3]), here.reshape(*local.shape[:3], 3)
        a, b, c = spots[0, 0, 0], spots[0, -1, 0], spots[0, -1, -1]
        turn = np.cross(b - a, c - a) @ outward * (-1.0 if face.domin == 0 else 1.0)
        around = (numbers[:, :-1, :-1], numbers[:, 1:, :-1], numbers[:, 1:, 1:], numbers[:, :-1, 1:])
        cells.append(np.stack(around if turn > 0 else around[::-1], axis=-1).reshape(-1, 4))
        if is_lower:
            lower.extend(numbers)
    return np.array(points), np.concatenate(cells), np.array(lower).reshape(-1, len(inside), len(inside)), {
        "rows": np.concatenate([np.full(len(shape), row) for row, _, shape in rows]),
        "columns": np.concatenate([np.array(dofs) for _, dofs, _ in rows]),
        "values": np.concatenate([shape for _, _, shape in rows]),
    }  # fmt: skip


def _grid(corners: NDArray[Any], shares: NDArray[Any]) -> NDArray[Any]:
    """(n, n, 2) places in a quadrilateral (4, 2) at shares (n,) of either axis, from 0 to 1."""
    weights = np.stack([1 - shares, shares])
    return np.asarray(np.einsum("ai,bj,abc->ijc", weights, weights, corners[[[0, 3], [1, 2]]]))


def _is_whole_below(period: DrawnPeriod | MeshPeriod) -> bool:
    """Return True if the face at z = 0 fills the tile and nothing lies below it."""
    import ngsolve as ng

    mesh = period.elements_of(1, 0)
    at_zero = ng.IfPos(SAME - ng.z, 1.0, 0.0)
    area = float(ng.Integrate(at_zero, mesh, ng.BND, definedon=mesh.Boundaries("inner.*")))
    lowest = min(vertex.point[2] for vertex in mesh.vertices)
    (x, y), (next_x, next_y) = period.corners.T, np.roll(period.corners, -1, axis=0).T
    whole = 0.5 * float((x * next_y - y * next_x).sum())
    return lowest > -SAME and area > (1 - SAME_VOLUME) * whole
