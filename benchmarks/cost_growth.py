"""Claim: how time and memory grow with the unknowns of the mesh, orders 2 to 8, and with pillars."""

from __future__ import annotations

import json
import subprocess
import sys

import numpy as np
from record import STUDY, fresh, peak_memory, timed, write
from threadpoolctl import threadpool_limits

import haptonic
from haptonic.bloch import Resolution
from haptonic.bloch.supercell import Supercell
from haptonic.superelement import Superelement, condense, condense_by_parts

ORDERS = (2, 3, 4, 5, 6, 7, 8)
PILLARS = ((1, 1), (2, 1), (2, 2), (3, 2), (3, 3), (4, 4), (6, 6))  # columns and rows of a supercell
ORDER_OF_PILLARS, BANDS = 4, 10


def several(columns: int, rows: int) -> dict[str, float]:
    """A supercell each of whose pillars is condensed by itself, and its lowest bands at one wavevector."""
    cell, resolution = haptonic.load(STUDY).cell, Resolution(ORDER_OF_PILLARS, 1)
    plan = resolution.plan(cell)

    def condensed() -> Superelement:
        return condense_by_parts(fresh(cell), plan, resolution.steps, measured=False)

    def joined(one: Superelement) -> tuple[Supercell, np.ndarray]:
        supercell = Supercell.of([[one] * columns] * rows)
        return supercell, supercell.eigenpairs(np.array([1.0, 2.0]), BANDS)[0]

    with threadpool_limits(1):
        joined(condensed())  # index work and libraries
        pillars = columns * rows
        first, cells = timed(lambda: [condensed() for _ in range(pillars)])
        second, (supercell, _) = timed(lambda: joined(cells[-1]))
    return {
        "pillars": pillars,
        "unknowns": pillars * cells[0].mesh.unknowns,
        "condensed_unknowns": supercell.size,
        "condense_s": first,
        "bands_s": second,
        "total_s": first + second,
        "peak_memory_bytes": peak_memory(),
    }


def one(order: int) -> dict[str, float]:
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
        "memory_foreseen_bytes": resolution.memory(cell),
    }


def exponent(rows: list[dict[str, float]], name: str) -> float:
    """Slope of a quantity against the unknowns, both in logarithms."""
    unknowns, values = (np.log([row[key] for row in rows]) for key in ("unknowns", name))
    return float(np.polyfit(unknowns, values, 1)[0])


def apart(*given: int) -> dict[str, float]:
    """One measurement in a process of its own, for the sake of its peak memory."""
    done = subprocess.run(
        [sys.executable, __file__, *map(str, given)], capture_output=True, text=True, check=True
    )
    return json.loads(done.stdout.splitlines()[-1])


if __name__ == "__main__":
    if len(sys.argv) > 1:
        numbers = [int(text) for text in sys.argv[1:]]
        print(json.dumps(one(*numbers) if len(numbers) == 1 else several(*numbers)))
    else:
        orders, pillars = [apart(order) for order in ORDERS], [apart(*shape) for shape in PILLARS]
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
