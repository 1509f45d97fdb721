"""Claim: how time and memory grow with the unknowns of the mesh, orders 2 to 8, and with pillars."""

from __future__ import annotations

import json
import sys

import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg as spla
from record import STUDY, apart, fresh, peak_memory, timed, write
from threadpoolctl import threadpool_limits

import haptonic
from haptonic.bloch import Resolution
from haptonic.bloch.pencil import Periodic
from haptonic.cell import PlacedTile, UnitCell
from haptonic.lattice import Lattice
from haptonic.superelement import Superelement, Tiling, condense, condense_by_parts

ORDERS = (2, 3, 4, 5, 6, 7, 8)
PILLARS = ((1, 1), (2, 1), (2, 2), (3, 2), (3, 3), (4, 4), (6, 6))  # columns and rows of a supercell
ORDER_OF_PILLARS, BANDS = 4, 10
AWAY = 0.1  # of the lowest eigenvalue of a cell with its trace held: how far below zero the shift lies


def repeated(cell: UnitCell, superelement: Superelement, columns: int, rows: int) -> Tiling:
    """The tiling of a supercell of equal cells."""
    pitch = cell.lattice.pitch
    whole = UnitCell(Lattice.rectangular(columns * pitch, rows * pitch), cell.thickness, cell.material)
    steps = [np.array([i, j]) for j in range(rows) for i in range(columns)]
    placed = [PlacedTile(cell, np.eye(3), pitch * step) for step in steps]
    return Tiling.of(whole, placed, [superelement] * len(placed))


def lowest(tiling: Tiling, kappa: np.ndarray, count: int) -> np.ndarray:
    """Eigenvalues of a tiling of many tiles, (rad/s)^2, by Lanczos's method on sparse matrices."""
    periodic = Periodic.of(tiling)
    turn = np.exp(1j * (periodic.shift @ kappa))
    spread = sp.csr_array((turn, (np.concatenate(tiling.own), periodic.number[np.concatenate(tiling.own)])))
    order = np.concatenate(tiling.own)
    K, M = (
        sp.csc_array(spread.conj().T @ _in_order(forms, order) @ spread)
        for forms in ([tile.stiffness for tile in tiling.tiles], [tile.mass for tile in tiling.tiles])
    )
    tile = tiling.tiles[0]
    softest = float(np.diag(tile.stiffness)[tile.trace_size :].min())
    start = np.random.default_rng(0).standard_normal(K.shape[0])
    return np.sort(spla.eigsh(K, count, M, sigma=-AWAY * softest, v0=start, return_eigenvectors=False))


def _in_order(forms: list[np.ndarray], order: np.ndarray) -> sp.csr_array:
    """Forms of the tiles side by side, as the unknowns of the tiling are ordered."""
    apart = sp.coo_array(sp.block_diag(forms))
    return sp.csr_array((apart.data, (order[apart.row], order[apart.col])), shape=apart.shape)


def several(columns: int, rows: int) -> dict[str, float]:
    """A supercell each of whose pillars is condensed by itself, and its lowest bands at one wavevector."""
    cell, resolution = haptonic.load(STUDY).cell, Resolution(ORDER_OF_PILLARS, 1)
    plan = resolution.plan(cell)

    def condensed() -> Superelement:
        return condense_by_parts(fresh(cell), plan, resolution.steps, measured=False)

    def joined(superelement: Superelement) -> tuple[Tiling, np.ndarray]:
        tiling = repeated(cell, superelement, columns, rows)
        return tiling, lowest(tiling, np.array([1.0, 2.0]), BANDS)

    with threadpool_limits(1):
        joined(condensed())  # index work and libraries
        pillars = columns * rows
        first, cells = timed(lambda: [condensed() for _ in range(pillars)])
        second, (tiling, _) = timed(lambda: joined(cells[-1]))
    return {
        "pillars": pillars,
        "unknowns": pillars * cells[0].mesh.unknowns,
        "condensed_unknowns": len(Periodic.of(tiling).free),
        "condense_s": first,
        "bands_s": second,
        "total_s": first + second,
        "peak_memory_bytes": peak_memory(),
    }


def cost_of(order: int) -> dict[str, float]:
    cell, resolution = haptonic.load(STUDY).cell, Resolution(order, 1)
    plan = resolution.plan(cell)
    condense(cell, plan, resolution.steps, measured=False)  # the index work of the topology
    seconds, superelement = timed(
        lambda: condense(cell, plan, resolution.steps, measured=False), repeats=3 if order < 6 else 1
    )
    return {
        "order": order,
        "unknowns": superelement.mesh.unknowns,
        "trace": superelement.trace_size,
        "condense_s": seconds,
        "peak_memory_bytes": peak_memory(),
        "memory_estimated_bytes": resolution.memory(cell),
    }


def exponent(rows: list[dict[str, float]], name: str) -> float:
    """Slope of a quantity against the unknowns, both in logarithms."""
    unknowns, values = (np.log([row[key] for row in rows]) for key in ("unknowns", name))
    return float(np.polyfit(unknowns, values, 1)[0])


if __name__ == "__main__":
    if len(sys.argv) > 1:
        numbers = [int(text) for text in sys.argv[1:]]
        print(json.dumps(cost_of(*numbers) if len(numbers) == 1 else several(*numbers)))
    else:
        orders = [apart(__file__, order) for order in ORDERS]
        pillars = [apart(__file__, *shape) for shape in PILLARS]
        write(
            "cost_growth",
            {
                "rows": orders,
                "exponent": exponent(orders[2:], "condense_s"),
                "order_of_pillars": ORDER_OF_PILLARS,
                "bands": BANDS,
                "pillars": pillars,
                "exponent_of_pillars": exponent(pillars, "total_s"),
            },
        )
