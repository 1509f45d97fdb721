"""Energy of a mode's highest polynomials as an estimate of its error, against a finer mesh.

    python surplus.py                        # drawn cells with discs for ten minutes, the cheapest first
    python surplus.py --pillars --minutes 30 # the cells of pillars.py

In each element a displacement is a sum of products of hierarchical polynomials: ends and integrated
Legendre polynomials. ``E_dk`` is the energy of the part with degree k along the local axis d. Of a mode of
unit energy with the highest degrees p_d, the surplus ``sum_d E_dp`` estimates the relative error of the
eigenvalue, twice that of the frequency. It needs no mesh of lower order and has no measured factor. Known
limits: a trace with fewer levels than the mesh, and interiors that are not resolved, have errors of their
own, which no element shows.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from functools import cache

import numpy as np
from discs import FEATURES, INTERIOR, JUDGED, MODES, REFERENCE, SHARES, TRUNCATED, UNSURE, drawn, in_order
from numpy.polynomial import legendre
from pillars import CELLS, MM
from record import write

from haptonic.arrays import Array, Complex, Fields, Ints
from haptonic.bloch import Resolution
from haptonic.bloch.centred import lattice_pencil
from haptonic.bloch.pencil import hertz
from haptonic.cell import Pillar, UnitCell
from haptonic.cell.quadrature import lobatto
from haptonic.elements import element_matrices
from haptonic.errors import HaptonicError
from haptonic.later import linalg as la
from haptonic.materials import Material, material
from haptonic.parallel import one_thread
from haptonic.superelement import Tiling

ALONG = ("qa,xabckm->xqbckm", "qb,xabckm->xaqckm", "qc,xabckm->xabqkm")  # a matrix on each local axis


@cache
def highest(order: int) -> Array:
    """(order + 1, order + 1) part of the highest hierarchical polynomial in values at the nodes."""
    values = legendre.legvander(lobatto(order)[0], order)
    values[:, 2:] -= values[:, :-2].copy()  # integrated Legendre polynomials, zero at both ends
    return np.outer(values[:, order], np.linalg.inv(values)[order])


def energies(points: Array, nodes: Ints, solid: Material, fields: Fields) -> tuple[Array, Array]:
    """Energies of fields (n, 3, m) in elements: (3, m) of their highest polynomials, (m,) in all."""
    matrices = element_matrices(points, nodes, solid)
    first, second = matrices.pairs

    def energy(values: Fields) -> Array:
        at_nodes = values.reshape(len(nodes), -1, *fields.shape[1:])
        pairs = (
            np.einsum("kim,kij,kjm->m", each[first].conj(), stiffness, each[second], optimize=True)
            for each, stiffness in zip(at_nodes, matrices.stiffness, strict=True)
        )
        return np.asarray(sum(pairs).real)

    values = fields[nodes]
    surplus = [
        energy(np.einsum(rule, highest(count - 1), values))
        for rule, count in zip(ALONG, nodes.shape[1:], strict=True)
    ]
    return np.array(surplus), energy(values)


def surplus(tiling: Tiling, fields: Complex) -> Array:
    """(m,) energy of the highest polynomials of modes (n, m) of the tiling, relative to their energy."""
    lifted, start = tiling.lifted(fields), 0
    high, whole = np.zeros(fields.shape[1]), np.zeros(fields.shape[1])
    for placed, tile in zip(tiling.joint.placed, tiling.tiles, strict=True):
        for mesh in tile.meshes:
            of_mesh = placed.turn.T @ lifted[start : start + len(mesh.points)]
            start += len(mesh.points)
            for family in mesh.topology.families:
                for region in np.unique(family.region):
                    nodes = family.nodes[family.region == region]
                    parts, energy = energies(mesh.points, nodes, tile.cell.solids[int(region)], of_mesh)
                    high, whole = high + parts.sum(axis=0), whole + energy
    return np.asarray(high / whole)


def modes(cell: UnitCell, mesh: Resolution) -> Iterator[tuple[Array, Tiling, Complex]]:
    """Frequencies (MODES,), Hz, and modes at each wavevector."""
    tiling = Tiling.condensed(cell, mesh.plans(cell), *INTERIOR, measured=False)
    pencil = lattice_pencil(tiling)
    for share in SHARES:
        kappa = np.pi * share
        values, vectors = la.eigh(*pencil.at(kappa), subset_by_index=[0, MODES - 1])
        yield hertz(values), tiling, pencil.periodic.expanded(pencil.free(vectors, kappa), kappa)


@dataclass(frozen=True)
class Row:
    """A cell on one mesh: ratios of the surplus to twice the relative distance to the finer mesh."""

    cell: str
    mesh: str
    frequencies: int
    least: float
    median: float
    off: float


def survey(name: str, cell: UnitCell, meshes: Sequence[str]) -> Iterator[Row]:
    """Compare the surplus of a cell on each mesh with the distance to the finer mesh."""
    with one_thread():
        fine, lower = (
            np.array([frequency for frequency, *_ in modes(cell, Resolution(order, 2))])
            for order in (REFERENCE, REFERENCE - 1)
        )
        unsure = UNSURE * np.abs(fine - lower) + TRUNCATED * fine
        for mesh in meshes:
            used = Resolution(*(int(part) for part in mesh.split("-")))
            found = [(frequency, surplus(tiling, fields)) for frequency, tiling, fields in modes(cell, used)]
            off = np.abs(np.array([frequency for frequency, _ in found]) - fine)
            judged = (off > unsure) & (fine > 1e-4 * fine.max()) & (np.arange(MODES) < JUDGED)
            if judged.any():
                relative = off[judged] / fine[judged]
                ratio = np.array([share for _, share in found])[judged] / (2 * relative)
                yield Row(
                    cell=name, mesh=mesh, frequencies=int(judged.sum()), least=float(ratio.min()),
                    median=float(np.median(ratio)), off=float(relative.max()),
                )  # fmt: skip


def cells(seed: int, count: int, *, with_pillars: bool) -> Iterator[tuple[str, UnitCell]]:
    """Names and cells in the order of the survey."""
    if with_pillars:
        solid = material("aluminium-2017a")
        for name, (lattice, thickness, pillar) in CELLS.items():
            assert isinstance(pillar, Pillar)
            yield name, UnitCell(lattice, thickness * MM, solid, pillar)
    else:
        for number in in_order(count, seed, FEATURES):
            feature, cell = drawn(seed, number)
            yield f"{seed}-{number} {feature}, {cell.lattice.name}", cell


def main(seed: int, count: int, minutes: float, meshes: Sequence[str], *, with_pillars: bool) -> None:
    """Survey cells, and store the ratios."""
    rows: list[Row] = []
    start = time.monotonic()
    for name, cell in cells(seed, count, with_pillars=with_pillars):
        if time.monotonic() - start > 60 * minutes:
            break
        try:
            for row in survey(name, cell, meshes):
                rows.append(row)
                print(
                    f"{row.cell}, {row.mesh}: off {row.off:.1e}, ratio {row.least:.2f}, {row.median:.1f}",
                    flush=True,
                )
        except HaptonicError as error:
            print(f"{name}: refused, {error.cause}", flush=True)
    write(
        "surplus_of_pillars" if with_pillars else "surplus_of_discs",
        {
            "seed": seed, "cells": len({row.cell for row in rows}),
            "frequencies": sum(row.frequencies for row in rows), "least": min(row.least for row in rows),
            "median": float(np.median([row.median for row in rows])), "rows": [asdict(row) for row in rows],
        },
    )  # fmt: skip


if __name__ == "__main__":
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--pillars", action="store_true")
    parser.add_argument("--cells", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--minutes", type=float, default=10.0)
    parser.add_argument("--meshes", nargs="+", default=["3-1", "4-1"])
    given = parser.parse_args()
    main(given.seed, given.cells, given.minutes, given.meshes, with_pillars=given.pillars)
