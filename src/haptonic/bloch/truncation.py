"""Truncation error of the interiors of tiles, and interiors that reach a goal for it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from haptonic.arrays import Array
from haptonic.bloch.centred import lattice_pencil
from haptonic.bloch.mesh_levels import Lack, MeshLimits, growth_for
from haptonic.bloch.pencil import eigenpairs, hertz
from haptonic.bloch.resolution import Resolution
from haptonic.cell import UnitCell
from haptonic.superelement import Tiling, on_each

# Largest relative truncation error for which the first-order estimate is reliable: at an estimate of 1.4e-2
# the error was 4.7e-2, and bands had changed places. The interior need not grow below the share of the
# accuracy.
TRUSTED_TRUNCATION, TRUNCATION_SHARE = 1e-3, 0.25
FIRST_ORDER = 1.5  # largest ratio of the error to its first-order estimate, below the trusted one
MOST_GROWTH = 5  # number of enlargements of the interior
# Few modes serve up to this multiple of the highest frequency at the zone's corners, of some modes above the
# last band. Omitted modes are then above twice that frequency, and their response is at most 4/3 of the
# static one that the truncation contains.
ROOM, MODES_ABOVE = 4 / 3, 5
REST = 1e-4  # share of the highest frequency below which a mode counts as a rigid-body motion


def interior_error(values: Array, left_out: Array) -> Array:
    """(k,) first-order decrease of frequencies due to omitted interior fields, for eigenvalues (k,), Hz.

    left_out : (k,) values of the truncation form on each mode
    """
    return np.asarray(0.5 * FIRST_ORDER * values * np.abs(left_out) * hertz(values))


@dataclass(frozen=True)
class Interior:
    """A cell condensed with an interior.

    mesh : its resolution; whole : the condensed cell
    truncation : largest relative truncation error of the bands at the corners of the zone
    highest : Hz, up to which few modes of such a cell suffice for the bands and some modes above
    """

    mesh: Resolution
    whole: Tiling
    truncation: float
    highest: float


def largest_truncation(tiling: Tiling, count: int) -> tuple[float, float]:
    """Largest relative truncation error of ``count`` bands at the zone's corners.

    Also the highest frequency there, Hz, of `MODES_ABOVE` modes above the last band.
    """
    pencil = lattice_pencil(tiling)
    corners = tiling.cell.zone.corner_phases.values()
    solved = [(kappa, *eigenpairs(pencil, kappa, count + MODES_ABOVE)) for kappa in corners]
    top = max(values[-1] for _, values, _ in solved)
    solved = [(kappa, values[:count], modes[:, :count]) for kappa, values, modes in solved]
    highest = max(values[-1] for _, values, _ in solved)
    worst = 0.0
    for kappa, values, modes in solved:
        moving, frequency = values > REST**2 * highest, hertz(values)
        lost = interior_error(values, on_each(tiling.truncation, pencil.fields(modes, kappa)))
        ratio = ranked(frequency, lost)[moving] / frequency[moving]
        worst = max(worst, float(ratio.max(initial=0.0)))
    return worst, float(hertz(np.array(top)))


def ranked(frequency: Array, error: Array) -> Array:
    """(k,) errors of bands from those of k modes, lowest first, Hz.

    Bands are numbered by frequency. If the error interval of a mode reaches below lower modes, their order is
    uncertain, and the errors of these bands include this.
    """
    lowest = frequency - error
    return np.asarray(frequency - np.minimum(lowest, np.sort(lowest)))


def reach_truncation(
    cell: UnitCell,
    mesh: Resolution,
    count: int,
    *,
    goal: float,
    limits: MeshLimits,
    spent: float,
    measured: bool,
    highest: float | None = None,
) -> tuple[Interior, Lack | None]:
    """Condense a cell with an interior that reaches a truncation error, or with the largest that fits.

    An interior without a reliable error grows beyond the budget of time. The second value is the limit that
    prevented more. Once the bands are known roughly, few modes of a larger interior replace all of them;
    ``highest`` (Hz) is known from a coarser mesh.
    """
    for further in range(MOST_GROWTH, -1, -1):
        whole = Tiling.condensed(
            cell, mesh.plans(cell), mesh.steps, mesh.block, measured=measured, highest=highest
        )
        truncation, last = largest_truncation(whole, count)
        highest = ROOM * last
        reached = Interior(mesh, whole, truncation, highest)
        if truncation <= goal or not further:
            return reached, None
        wanted = mesh.grown(growth_for(truncation, goal))
        lack = limits.lack(cell, wanted, spent)
        if lack is not None and (truncation <= TRUSTED_TRUNCATION or lack.of == "memory"):
            return reached, lack
        mesh = wanted
        del whole, reached  # the next condensation needs their memory
    raise AssertionError("the last interior is returned")
