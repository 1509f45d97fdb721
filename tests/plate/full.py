"""A plate in full 3D: the meshes of all tiles glued together at their rims, and nothing reduced.

On each edge between tiles there is one polynomial field, as fine as the cells' own meshes; every mesh takes
the values of its rim from it. Nothing of `skeleton`, `tile`, `reduction` and what builds on them is used.
"""

from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
from numpy.polynomial.legendre import leggauss
from scipy.sparse.linalg import LinearOperator, eigsh, gmres, splu

from core.brute import assembled
from haptonic.cell import MeshPlan, UnitCell, mesh_cell
from haptonic.cell.quadrature import interpolation, lobatto
from haptonic.lattice import Lattice
from haptonic.plate.body.surface import flat_faces, surface_weights
from haptonic.plate.body.unreduced import BodyOrders, body
from haptonic.plate.layout.keys import PLATE, bond, ceramic, electric
from haptonic.solvers import Pattern, chosen


@dataclass(frozen=True)
class Piece:
    """One mesh, its points in the frame of the plate."""

    points: np.ndarray
    stiffness: dict
    mass: np.ndarray
    faces: list
    box: tuple
    drive: dict
    capacitance: dict


@dataclass(frozen=True)
class Full:
    """Free unknowns of the whole. pieces, spread : meshes, and their displacement from the unknowns"""

    plate: object
    stiffness: dict
    mass: sp.csc_array
    drive: dict
    capacitance: dict
    pieces: list
    spread: list

    @property
    def elastic(self):
        return sp.csc_array(sum(self.stiffness.values()))

    @property
    def size(self):
        return self.mass.shape[0]

    def observed(self, where):
        """(k, size) normal displacement at points of the flat face."""
        rows = []
        for point in where:
            piece, spread = next(
                (piece, spread)
                for piece, spread in zip(self.pieces, self.spread, strict=True)
                if (piece.box[0] - 1e-12 <= point).all() and (point <= piece.box[1] + 1e-12).all()
            )
            weights = surface_weights(piece.points, piece.faces, np.clip(point, *piece.box)[None])
            rows.append(sp.kron(weights, [[0.0, 0.0, 1.0]]) @ spread)
        return sp.csr_array(sp.vstack(rows))


def _single(layout, block, cell_order, rings, plain_order):
    """A brick of a lattice, or a tile of plain plate."""
    (left, *_, right), (bottom, *_, top) = layout.lines(block)
    laid = layout.bricks.get(block.tiles[0])
    if laid is not None:
        tile = layout.brick(layout.at(block.tiles[0]), laid.number)
        shares = np.concatenate([(np.array(own) - own[0]) / np.ptp(own) for own in layout.lines(block)])
        fits = (n for n in range(1, 5) if np.abs(n * shares - np.round(n * shares)).max() < 1e-6)
        plan = MeshPlan.suited(tile, cell_order, rings).divided(next(fits), cell_order + 2)
    else:
        lattice = Lattice.rectangular(right - left, top - bottom)
        tile = UnitCell(lattice, layout.thickness, layout.material)
        plan = MeshPlan.suited(tile, plain_order, 0)
    mesh = mesh_cell(tile, plan)
    K, mass = assembled(mesh, *tile.solids)
    points = mesh.points + np.array([left, bottom, 0.0]) - np.append(tile.corners[0], 0.0)
    box = np.array([left, bottom]), np.array([right, top])
    return Piece(points, {PLATE: K}, mass, flat_faces(mesh), box, {}, {})


def _with_patch(layout, actuator, tiles, along, through):
    """The rectangle of tiles below a patch as one mesh."""
    rows, columns = (sorted({tile[axis] for tile in tiles}) for axis in (0, 1))
    x, y = layout.x[columns[0] : columns[-1] + 2], layout.y[rows[0] : rows[-1] + 2]
    orders = BodyOrders(along, through, 2, 3)
    longest = 1.01 * max(np.diff(x).max(), np.diff(y).max())
    mesh = body(x, y, layout.thickness, layout.material, [actuator], orders, longest)
    box = np.array([x[0], y[0]]), np.array([x[-1], y[-1]])
    return Piece(
        mesh.points, dict(mesh.stiffness), mesh.mass, list(mesh.faces), box, dict(mesh.drive),
        dict(mesh.capacitance),
    )  # fmt: skip


def full(plate, cell_order, rings, plain_order):
    """Glue a plate whose supports are clamps of whole edges; at most one patch, forces anywhere.

    Orders and rings as in `haptonic.cell.MeshPlan.suited`; that of plain plate is not below the cells'.
    """
    layout = plate.layout
    taken, pieces = [], []
    for actuator in plate.actuators:
        (x, y), (width, height, _) = actuator.centre, actuator.size
        taken = layout.under((x - width / 2, y - height / 2, x + width / 2, y + height / 2))
        pieces.append(_with_patch(layout, actuator, taken, plain_order + 1, plain_order))
    for block in layout.blocks:
        if block.tiles[0] not in taken:
            pieces.append(_single(layout, block, cell_order, rings, plain_order))
    glue = _Glue(layout, cell_order + 2, cell_order)
    count = 0
    raw = []
    for piece in pieces:
        rim, inner, weights = glue.tied(piece)
        raw.append((rim, inner, weights, count))
        count += len(inner)
    # edges inside a patch's mesh carry nothing
    used = np.concatenate([columns for _, _, weights, _ in raw for columns, _ in weights])
    moving = np.setdiff1d(used, list(glue.held(plate.supports)))
    free = np.concatenate([moving, len(glue.number) + np.arange(count)])
    spread = []
    for piece, (rim, inner, weights, start) in zip(pieces, raw, strict=True):
        P = sp.lil_array((len(piece.points), len(glue.number) + count))
        P[inner, len(glue.number) + start + np.arange(len(inner))] = 1.0
        for row, (columns, values) in zip(rim, weights, strict=True):
            P[row, columns] = values
        spread.append(sp.csr_array(sp.kron(sp.csr_array(P)[:, free], sp.eye_array(3))))
    stiffness, drive, mass = {}, {}, 0
    for piece, P in zip(pieces, spread, strict=True):
        for part, K in piece.stiffness.items():
            stiffness[part] = stiffness.get(part, 0) + P.T @ K @ P
        drive |= {name: P.T @ vector for name, vector in piece.drive.items()}
        mass = mass + P.T @ sp.diags_array(piece.mass) @ P
    capacitance = {name: c for piece in pieces for name, c in piece.capacitance.items()}
    whole = Full(plate, stiffness, sp.csc_array(mass), drive, capacitance, pieces, spread)
    for force in plate.forces:
        size = (0.0, 0.0) if force.size is None else force.size
        nodes, weights = leggauss(8)  # enough for the polynomials on a part of a face
        places = np.array([[0.5 * size[0] * a, 0.5 * size[1] * b] for a in nodes for b in nodes])
        shares = np.outer(weights, weights).ravel() / 4
        drive[force.name] = whole.observed(np.array(force.centre) + places).T @ shares
    return whole


class _Glue:
    """Numbers of points on the edges between tiles by their coordinates, in nanometres."""

    def __init__(self, layout, along, through):
        self.layout, self.along, self.through = layout, along, through
        self.number = {}
        for i, j in np.ndindex(layout.rows, layout.columns):
            if layout.at((i, j)) is None:
                continue
            left, bottom, right, top = layout.bounds((i, j))
            for start, end in (
                ((left, bottom), (right, bottom)), ((left, top), (right, top)),
                ((left, bottom), (left, top)), ((right, bottom), (right, top)),
            ):  # fmt: skip
                for key in self._keys(np.array(start), np.array(end)):
                    self.number.setdefault(key, len(self.number))

    def _keys(self, start, end):
        along, up = (0.5 * (1 + lobatto(order)[0]) for order in (self.along, self.through))
        for share in along:
            x, y = start + share * (end - start)
            for height in up:
                yield self._key(x, y, height * self.layout.thickness)

    @staticmethod
    def _key(*place):
        return tuple(int(np.round(value * 1e9)) for value in place)

    def _on_edge(self, start, end, share, height):
        along = interpolation(lobatto(self.along)[0], np.array([2 * share - 1]))[0]
        up = interpolation(lobatto(self.through)[0], np.array([2 * height - 1]))[0]
        columns = [self.number[key] for key in self._keys(np.array(start), np.array(end))]
        weights = np.outer(along, up).ravel()
        return columns, weights

    def tied(self, piece):
        """Nodes on the sides of a mesh, all others, and for each of the first (numbers, weights)."""
        low, high = piece.box
        x, y, z = piece.points.T
        close = 1e-9 * (high - low).max()
        in_plate = z <= self.layout.thickness * (1 + 1e-9)
        on_x = in_plate & ((np.abs(x - low[0]) < close) | (np.abs(x - high[0]) < close))
        on_y = in_plate & ((np.abs(y - low[1]) < close) | (np.abs(y - high[1]) < close))
        rim, inner = np.flatnonzero(on_x | on_y), np.flatnonzero(~(on_x | on_y))
        weights = []
        for node in rim:
            across, lines = (0, self.layout.y) if on_x[node] else (1, self.layout.x)
            place, fixed = piece.points[node, 1 - across], piece.points[node, across]
            # of a corner of the box: the edge on the side of the mesh
            inwards = np.clip(place, low[1 - across] + 1e-6, high[1 - across] - 1e-6)
            k = int(np.searchsorted(lines, inwards, side="right")) - 1
            start, end = np.full(2, fixed), np.full(2, fixed)
            start[1 - across], end[1 - across] = lines[k], lines[k + 1]
            share = (place - lines[k]) / (lines[k + 1] - lines[k])
            weights.append(self._on_edge(start, end, share, z[node] / self.layout.thickness))
        return rim, inner, weights

    def held(self, supports):
        """Numbers at rest: whole sides of the map."""
        layout = self.layout
        for support in supports:
            assert support.hold == "clamped"
            ends = {"left": (0, layout.x[0]), "right": (0, layout.x[-1]),
                    "bottom": (1, layout.y[0]), "top": (1, layout.y[-1])}  # fmt: skip
            axis, where = ends[support.where]
            for key, number in self.number.items():
                if key[axis] == int(np.round(where * 1e9)):
                    yield number


# -- solutions ------------------------------------------------------------------------------------


def factorised(K):
    """A function that solves with a symmetric matrix, real or complex, by SciPy alone."""
    return splu(sp.csc_array(K), permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True}).solve


def quickly_factorised(K):
    """The same by the product's sparse solver, for large real matrices."""
    upper = sp.csr_array(sp.triu(K))
    upper.sort_indices()
    solver = chosen()(Pattern(upper.indptr.astype(np.int32), upper.indices.astype(np.int32)))
    solver.factorise(upper.data, definite=False)
    return lambda right: solver.solve(right.reshape(len(right), -1)).reshape(right.shape)


def frequencies(whole, count, near, factorise=factorised):
    """(count,) nearest to a frequency, Hz, ascending."""
    K, shift = whole.elastic, (2 * np.pi * near) ** 2
    solve = LinearOperator(K.shape, factorise(K - shift * whole.mass), dtype=float)
    start = np.random.default_rng(1).standard_normal(whole.size)
    values = eigsh(K, count, whole.mass, sigma=shift, OPinv=solve, v0=start, return_eigenvectors=False)
    return np.sort(np.sqrt(np.maximum(values, 0))) / (2 * np.pi)


def dynamic(whole, omega):
    """Complex dynamic stiffness with the losses of plate, glue and ceramic."""
    plate = whole.plate
    factors = {PLATE: 1 + 1j * plate.loss_factor}
    for actuator in plate.actuators:
        solid, name = actuator.material, actuator.name
        factors[bond(name)] = 1 + 1j * actuator.bond.material.loss_factor
        factors[ceramic(name)] = 1 + 1j * solid.loss_factor
        factors[electric(name)] = 1 / (1 - 1j * solid.clamped_loss)
    return sum(factors[part] * K for part, K in whole.stiffness.items()) - omega**2 * whole.mass


def answer(whole, load, omega):
    """(size,) by a direct complex solution."""
    return factorised(dynamic(whole, omega))(load.astype(complex))


def answer_by_iteration(whole, load, omega):
    """(size,) for large plates: the lossless plate, factorised, preconditions; residual 1e-8."""
    Z = dynamic(whole, omega)
    solve = quickly_factorised(whole.elastic - omega**2 * whole.mass)

    def precondition(right):
        return solve(np.ascontiguousarray(right.real)) + 1j * solve(np.ascontiguousarray(right.imag))

    inverse = LinearOperator(Z.shape, precondition, dtype=complex)
    solution, failed = gmres(Z, load.astype(complex), M=inverse, rtol=1e-8, restart=60, maxiter=60)
    assert not failed
    return solution


def fields_on(whole, model, vectors):
    """Displacement (3 nodes, k) of a reduced model on the pieces of the whole; None where meshes differ.

    vectors : (size, k) of the model's assembly
    """
    layout, displaced = model.plate.layout, {}
    for group, share in model.assembly.shares(vectors):
        for number, own in zip(group.blocks, share.swapaxes(0, 1), strict=True):
            block = model.assembly.skeleton.blocks[number]
            corner = np.array([layout.x[block.columns[0]], layout.y[block.rows[0]], 0.0])
            lifted = group.tile.inside.lifted(own)
            for key, value in zip(_rounded(group.tile.inside.points + corner), lifted, strict=True):
                displaced[key] = value
    everywhere = []
    for piece in whole.pieces:
        keys = _rounded(piece.points)
        known = all(key in displaced for key in keys)
        everywhere.append(np.concatenate([displaced[key] for key in keys]) if known else None)
    return everywhere


def _rounded(points):
    return [tuple(row) for row in np.round(points * 1e9).astype(np.int64)]


def energy_error(whole, model, exact, vectors, omega):
    """Error of one answer of a model in the energy norm of the whole's meshes, relative, and the share of
    the meshes' energy in which it was found: where nodes coincide.
    """
    error = size = seen = 0.0
    for piece, P, own in zip(
        whole.pieces, whole.spread, fields_on(whole, model, vectors[:, None]), strict=True
    ):
        u = P @ exact
        K, M = sum(piece.stiffness.values()), piece.mass

        def norm(field, K=K, M=M):
            return float((field.conj() @ (K @ field)).real + omega**2 * (M * np.abs(field) ** 2).sum())

        size += norm(u)
        if own is not None:
            seen += norm(u)
            error += norm(own[:, 0] - u)
    return np.sqrt(error / seen), seen / size
