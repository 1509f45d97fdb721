"""Claim: how time and memory grow with the unknowns of the mesh, orders 2 to 8."""

from __future__ import annotations

import json
import subprocess
import sys

import numpy as np
from record import STUDY, peak_memory, timed, write

import haptonic
from haptonic.bloch import Resolution
from haptonic.superelement import condense

ORDERS = (2, 3, 4, 5, 6, 7, 8)


def one(order: int) -> dict[str, float]:
    cell, resolution = haptonic.load(STUDY).unit_cell(), Resolution(order, 1)
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


if __name__ == "__main__":
    if len(sys.argv) > 1:
        print(json.dumps(one(int(sys.argv[1]))))
    else:
        rows = [
            json.loads(
                subprocess.run(
                    [sys.executable, __file__, str(order)], capture_output=True, text=True, check=True
                ).stdout.splitlines()[-1]
            )
            for order in ORDERS
        ]
        write("cost_growth", {"rows": rows, "exponent": exponent(rows[2:], "condense_s")})
