"""Reduction of meshes to tiles: cells of a lattice, plain plate, and blocks with attached parts."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from types import MappingProxyType

import numpy as np

from haptonic.arrays import Array, Ints
from haptonic.cell import HexMesh, MeshPlan, TileShape
from haptonic.cell.brickwork import Steps
from haptonic.cell.mesh import trace_shares
from haptonic.cell.quadrature import lobatto
from haptonic.later import linalg as la, sparse as sp
from haptonic.plate.body.bonds import Bonded
from haptonic.plate.body.skeleton import TraceOrders, rim_fields
from haptonic.plate.body.surface import flat_faces
from haptonic.plate.body.tile import OnMesh, Tile
from haptonic.plate.body.unreduced import Body
from haptonic.plate.layout.keys import PLATE
from haptonic.solvers import Pattern, chosen
from haptonic.superelement import condense, condense_solid
from haptonic.superelement.interior import MISSED

SNAPSHOTS = (0.5, 1.0)  # besides 0, of the square of the highest frequency, for blocks
MISSED_BY_BLOCK = 3e-4  # of a block's strongest response, root of energy, below which a direction is omitted
# Blocks of the Krylov space of the interior, see `haptonic.superelement.interior`. At fine orders, the error
# of a frequency of a thick plate was 1.2e-4 with blocks of 20 and 6e-5 with 30, which take 1 to 5 % longer
# on the prototype.
STEPS, BLOCK = 3, 30


def cell_tile(
    shape: TileShape,
    plan: MeshPlan,
    steps: Steps,
    orders: TraceOrders,
    highest: float,
    missed: float = MISSED,
) -> Tile:
    """Reduce a brick of a lattice, or plain plate, to a tile for frequencies up to ``highest`` (Hz).

    steps : between the lines of the layout across it, m; elements of the plan end at each of them
    """
    condense_tile = condense if shape.solid is None else condense_solid
    whole = condense_tile(shape, plan, STEPS, block=BLOCK, measured=False)
    mesh = whole.mesh
    body = whole.projected(_onto_rim(plan, steps, whole.levels, orders)).with_few_modes(highest, missed)
    to_cell = body.fields
    corner = np.append(-shape.corners[0], 0.0)
    inside = OnMesh(
        size=to_cell.shape[1],
        points=mesh.points + corner,
        subcells=_corners(family.nodes for family in mesh.topology.families)
        if isinstance(mesh, HexMesh)
        else mesh.linear_subcells(),
        faces=tuple(flat_faces(mesh)) if isinstance(mesh, HexMesh) else (mesh.lower,),
        lift=lambda unknowns: whole.lifted(to_cell @ unknowns),
    )
    return Tile.plain(body, inside)


def _onto_rim(plan: MeshPlan, steps: Steps, levels: int, orders: TraceOrders) -> Array:
    """Matrix from the trace of a tile to that of a condensed cell (level, place, component)."""
    side = trace_shares(plan)
    # positions in edges: where sides of the tile, anticlockwise from the lower left, lie between the lines
    ends = [np.concatenate([[0.0], np.cumsum(sizes) / sum(sizes)]) for sizes in steps]
    ends = [*ends, *(1 - end[::-1] for end in ends)]
    first = np.cumsum([0, *(len(end) - 1 for end in ends)])
    along = np.concatenate([
        start + np.interp(side, end, np.arange(len(end)))
        for start, end in zip(first[:-1], ends, strict=True)
    ])  # fmt: skip
    height = 0.5 * (1 + lobatto(levels - 1)[0])
    where, up = np.tile(along, levels), np.repeat(height, len(along))
    return rim_fields(int(first[-1]), orders, where, up)


def block_tile(
    body: Body,
    x: Sequence[float],
    y: Sequence[float],
    thickness: float,
    loads: Mapping[str, Array],
    orders: TraceOrders,
    highest: float,
    bonded: Mapping[str, Bonded] = MappingProxyType({}),
    missed: float = MISSED_BY_BLOCK,
) -> Tile:
    """Reduce a body, plain plate or a cell with attached parts, to a tile up to ``highest`` (Hz).

    Parameters
    ----------
    body : unreduced; x, y : lines between the tiles in it, m; thickness : of the plate, m
    loads : further drives by name, (3 nodes,) force per unit of drive
    bonded : by actuator, bodies with other bonds, for which the tile is valid as well
    missed : see `MISSED_BY_BLOCK`
    """
    drives = {**body.drive, **loads}
    onto = _rim_of_body(body, x, y, thickness, orders)
    size, trace = len(body.mass), onto.shape[1]
    held = (3 * body.rim[:, None] + np.arange(3)).ravel()
    inside = np.setdiff1d(np.arange(size), held)
    force = (
        np.array([drive[inside] for drive in drives.values() if drive[inside].any()])
        .reshape(-1, len(inside))
        .T
    )
    mass = body.mass[inside]
    interior, coupling = _split(body, onto, (held, inside))
    static, seen, pushed = _snapshots(interior, coupling, force, mass, highest, SNAPSHOTS)
    total = sp.csr_array(sum(body.stiffness.values()))
    on_trace = onto.T @ (total[held][:, held] @ onto) + coupling.T @ static
    least = [np.zeros(seen.shape[1])]
    for other in (end for bonds in bonded.values() for end in (bonds.bodies[0], bonds.bodies[-1])):
        split = _split(other, onto, (held, inside))
        own, more, _ = _snapshots(*split, force, other.mass[inside], highest, ())
        seen = np.hstack([seen, more, own - static])
        pushed = np.hstack([pushed, interior @ more, interior @ (own - static)])
        # a small difference needs less accuracy
        least += [np.zeros(more.shape[1]), np.sqrt(np.diag(on_trace))]
    fields, values = _main_directions(seen, pushed, mass, np.concatenate(least), missed)
    basis = np.zeros((size, trace + len(values)))
    basis[held, :trace], basis[inside, :trace], basis[inside, trace:] = onto, static, fields
    parts = {part: _projected(form, basis) for part, form in body.stiffness.items() if part != PLATE}
    # the sum of all parts needs no product, because the fields are orthogonal to the static responses
    parts[PLATE] = la.block_diag(on_trace, np.diag(values)) - sum(parts.values())
    corner = np.array([x[0], y[0], 0.0])
    return Tile(
        stiffness=parts,
        mass=basis.T @ (body.mass[:, None] * basis),
        values=values,
        drive={name: basis.T @ drive for name, drive in drives.items()},
        capacitance=body.capacitance,
        inside=OnMesh(
            size=basis.shape[1],
            points=body.points - corner,
            subcells=_corners(body.elements.values()),
            faces=body.faces,
            lift=lambda unknowns: np.asarray(basis @ unknowns).reshape(len(body.points), 3, -1),
        ),
        bonds={name: bonds.projected(name, basis) for name, bonds in bonded.items()},
    )


def _split(body: Body, onto: Array, split: tuple[Ints, Ints]) -> tuple[sp.csr_array, Array]:
    """Stiffness (inside, inside), and (inside, trace) between the interior and the trace.

    onto : (held, trace) displacement of the rim; split : unknowns of the rim, and all others
    """
    held, inside = split
    rows = sp.csr_array(sum(body.stiffness.values()))[inside]
    return sp.csr_array(rows[:, inside]), np.asarray(rows[:, held] @ onto)


def _snapshots(
    interior: sp.csr_array,
    coupling: Array,
    force: Array,
    mass: Array,
    highest: float,
    shares: Sequence[float],
) -> tuple[Array, Array, Array]:
    """Static responses to a trace, and other fields for the basis of a tile.

    interior, coupling : see `_split`; force : (inside, k) of the drives; mass : (inside,)
    shares : of the square of the highest frequency, beside 0

    Returns
    -------
    static responses (inside, trace), other fields (inside, k), and the stiffness times these
    """
    pattern, numbers = _upper(interior)
    solver = chosen()(pattern)
    if solver.factorise(numbers, definite=False):  # one analysis serves the shifted ones too
        raise np.linalg.LinAlgError("the stiffness of a block is not definite")
    answers = solver.solve(np.hstack([-coupling, force]))
    trace = coupling.shape[1]
    static = answers[:, :trace]
    inertia = mass[:, None] * static
    diagonal = pattern.indptr[:-1]
    seen, pushed = [answers[:, trace:], solver.solve(inertia)], [force, inertia]
    loads = np.hstack([inertia, force])
    for share in shares:
        heavy = share * (2 * np.pi * highest) ** 2 * mass
        shifted = numbers.copy()
        shifted[diagonal] -= heavy
        solver.factorise(shifted, definite=False)
        seen.append(solver.solve(loads))
        pushed.append(loads + heavy[:, None] * seen[-1])
    return static, np.hstack(seen), np.hstack(pushed)


def _rim_of_body(
    body: Body, x: Sequence[float], y: Sequence[float], thickness: float, orders: TraceOrders
) -> Array:
    """(3 rim nodes, trace) displacement of a body's rim from that of the trace."""
    points = body.points[body.rim]
    columns, rows = len(x) - 1, len(y) - 1
    # positions in tiles, then along the rim anticlockwise from the lower left corner
    across = np.interp(points[:, 0], x, np.arange(columns + 1))
    up = np.interp(points[:, 1], y, np.arange(rows + 1))
    where = np.select(
        [up == 0, across == columns, up == rows],
        [across, columns + up, columns + rows + (columns - across)],
        2 * columns + rows + (rows - up),
    )
    edges = 2 * (columns + rows)
    return rim_fields(edges, orders, where % edges, points[:, 2] / thickness)


def _main_directions(
    fields: Array, pushed: Array, mass: Array, least: Array, missed: float
) -> tuple[Array, Array]:
    """Few fields that nearly span given ones (proper orthogonal decomposition in the energy norm).

    With the norm ``|x|^2 = x^T K x`` they are the main eigenvectors of ``x_a^T K x_b / (|x_a| |x_b|)``. So
    all fields (size, k) have equal weight, but for those smaller than ``least`` (k,). ``pushed`` is K times
    them.

    Returns
    -------
    (size, r) fields, orthonormal in mass and orthogonal in stiffness, and (r,) their stiffnesses, ascending
    """
    gram = fields.T @ pushed
    size = np.maximum(np.sqrt(np.diag(gram)), least)
    weights, turn = la.eigh(gram / size / size[:, None])
    significant = weights > missed**2 * weights[-1]
    # unit energy each
    fields = fields @ (turn[:, significant] / np.sqrt(weights[significant]) / size[:, None])
    weights, turn = la.eigh(fields.T @ (mass[:, None] * fields))
    return np.asarray(fields @ (turn[:, ::-1] / np.sqrt(weights[::-1]))), 1 / weights[::-1]


def _projected(part: sp.csr_array, basis: Array) -> Array:
    """(n, n) stiffness of a part with few nonzero rows of a basis (size, n)."""
    rows = np.flatnonzero(np.diff(part.indptr))
    of_rows = basis[rows]
    return np.asarray(of_rows.T @ (part[rows][:, rows] @ of_rows))


def _upper(matrix: sp.csr_array) -> tuple[Pattern, Array]:
    """Upper triangle of a symmetric matrix."""
    upper = sp.csr_array(sp.triu(matrix))
    upper.sort_indices()
    return Pattern(upper.indptr.astype(np.int32), upper.indices.astype(np.int32)), upper.data


def _corners(elements: Iterable[Ints]) -> Ints:
    """(elements, 8) corners of elements (k, n1, n2, n3), in VTK's order."""
    turn = [(0, 0), (-1, 0), (-1, -1), (0, -1)]
    return np.concatenate([
        np.stack([nodes[:, a, b, c] for c in (0, -1) for a, b in turn], axis=-1) for nodes in elements
    ])  # fmt: skip
