"""A block of the plate reduced to its rim and a few modes: one for all blocks that are alike."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy.linalg as la
from numpy.typing import NDArray

from haptonic.cell import MeshPlan, UnitCell
from haptonic.plate.skeleton import TraceOrders, rim_values
from haptonic.cell.quadrature import lobatto
from haptonic.superelement import condense

Array = NDArray[np.float64]

EXACT = 1.5  # interior modes up to this multiple of the highest frequency are all kept
SAMPLED = (0.3, 0.55, 0.8, 1.0)  # of the square of the highest frequency, where the others must serve
KRYLOV_STEPS, KRYLOV_BLOCK = 3, 20


@dataclass(frozen=True, eq=False)
class Tile:
    """Unknowns: the trace (place on the rim, level, component), then amplitudes of modes that have none.

    stiffness : by part (n, n), N/m; mass : (n, n), kg
    values : (m,) squares of the modes' angular frequencies with the rim at rest; modal masses are 1
    drive : by name (n,) force per unit of drive
    lifted : (nodes, 3, k) displacement on its mesh from unknowns (n, k)
    """

    stiffness: Mapping[str, Array]
    mass: Array
    values: Array
    drive: Mapping[str, Array]
    lifted: Callable[[Array], Array]

    @property
    def size(self) -> int:
        return len(self.mass)

    @property
    def trace_size(self) -> int:
        return self.size - len(self.values)

    @cached_property
    def elastic(self) -> Array:
        """(n, n) stiffness of all parts together."""
        return np.asarray(sum(self.stiffness.values()))

    def dynamic(self, shift: float) -> tuple[Array, Array]:
        """Stiffness K - shift M seen by the trace, and what modes are per trace: c = X b."""
        trace = self.trace_size
        matrix = self.elastic - shift * self.mass
        coupling = matrix[trace:, :trace]
        answer = -coupling / (self.values - shift)[:, None]
        return matrix[:trace, :trace] + coupling.T @ answer, answer


def compressed(stiffness: Array, mass: Array, trace: int, loads: Array, highest: float, tolerance: float) -> Array:
    """Basis of the few modes that answer a smooth trace and given loads up to a highest frequency.

    The unknowns are (trace, modes), the modes' own stiffness diagonal and uncoupled from the trace, their masses 1.
    Modes of the band itself are kept; of the others only what the trace's inertia and the loads excite
    (proper orthogonal decomposition of their answers).

    Returns
    -------
    (modes, kept), orthonormal in mass and orthogonal in stiffness
    """
    values = np.diag(stiffness)[trace:]
    top = (2 * np.pi * highest) ** 2
    near = values < EXACT**2 * top
    weights = np.sqrt(values)
    scale = la.cholesky(stiffness[:trace, :trace] + top * mass[:trace, :trace], lower=False)
    coupling = la.solve_triangular(scale, mass[:trace, trace:], trans=1).T  # (modes, directions of unit energy)
    force = loads[trace:] / np.maximum(np.linalg.norm(loads[trace:] / weights[:, None], axis=0), 1e-300)
    answers = [force / weights[:, None]]
    for share in SAMPLED:
        gain = (weights / (values - share * top))[:, None]
        answers += [share * top * coupling * gain, force * gain]
    sampled = np.hstack(answers)
    sampled[near] = 0.0
    left, sizes, _ = la.svd(sampled, full_matrices=False)
    few = left[:, sizes > tolerance] / weights[:, None]
    basis = np.hstack([np.eye(len(values))[:, near], few])
    _, turn = la.eigh(basis.T @ (values[:, None] * basis), basis.T @ basis)
    return basis @ turn


def cell_tile(cell: UnitCell, plan: MeshPlan, orders: TraceOrders, highest: float, tolerance: float) -> Tile:
    """A cell of a lattice, or a rectangle of plain plate, as a tile."""
    whole = condense(cell, plan, KRYLOV_STEPS, block=KRYLOV_BLOCK, measured=False)
    trace, side = whole.trace_size, plan.side
    # places of the superelement's rim, level by level, from those of the tile's
    share = 0.5 * (1 + lobatto(plan.order)[0][:-1])
    along = ((np.arange(4 * plan.blocks)[:, None] + share) / plan.blocks).ravel()
    height = 0.5 * (1 + lobatto(whole.levels - 1)[0])
    where, up = np.tile(along, whole.levels), np.repeat(height, 4 * side)
    onto = np.kron(rim_values(4, orders, where, up), np.eye(3))
    basis = la.block_diag(onto, np.eye(whole.size - trace))
    stiffness, mass = (basis.T @ form @ basis for form in (whole.stiffness, whole.mass))
    own = onto.shape[1]
    modes = compressed(stiffness, mass, own, np.zeros((len(mass), 0)), highest, tolerance)
    basis = la.block_diag(onto, modes)
    kept = la.block_diag(np.eye(own), modes)
    stiffness, mass = (kept.T @ form @ kept for form in (stiffness, mass))
    return Tile(
        stiffness={"plate": stiffness},
        mass=mass,
        values=np.diag(stiffness)[own:].copy(),
        drive={},
        lifted=lambda unknowns: whole.lifted(basis @ unknowns),
    )
