"""Dependence of a gap's edges on the design: exact slopes, and the bands next to the gap over the zone."""

from __future__ import annotations

from collections.abc import Sequence
from types import MappingProxyType

import numpy as np

from haptonic.arrays import Array
from haptonic.bloch import Gap
from haptonic.bloch.exact import exact_modes
from haptonic.bloch.pencil import eigenpairs
from haptonic.cell import UnitCell
from haptonic.design.quick import QuickDesign
from haptonic.design.sensitivity import Directions, sensitivity
from haptonic.design.tolerance import Surface, terms_needed
from haptonic.later import xarray as xr

DIVISIONS = 10  # of the irreducible zone's sides, for the bands next to the gap


def edge_slopes(
    cell: UnitCell, gap: Gap, paths: Sequence[str], directions: Directions = MappingProxyType({})
) -> Array:
    """(parameters, 2) exact slopes of a gap's lower and upper edge, Hz per SI unit.

    ``paths`` and ``directions`` are those of `haptonic.design.sensitivity.eigenvalue_derivatives`.

    If an edge is degenerate, its modes split as a parameter changes: the lower edge follows the steepest
    slope, the upper edge the least steep one.
    """
    band = gap.between[0]
    quick = QuickDesign.of(cell, band + 2)
    fine, columns = quick.model.fine, []
    for number, kappa, pick in ((band, gap.lower_kappa, -1), (band + 1, gap.upper_kappa, 0)):
        # from the same mesh: on another mesh the frequency may be nearer to a neighbouring band
        value = eigenpairs(fine.pencil, np.array(kappa), number)[0][-1]
        modes = exact_modes(quick.shared, np.array(kappa), float(np.sqrt(value)))
        derivatives = sensitivity(quick.shared, modes, paths, directions)
        columns.append([derivatives.slopes[path][pick] for path in paths])
    return np.array(columns).T


def beside_dataset(argument: tuple[Sequence[UnitCell], Gap]) -> xr.Dataset:
    """The bands next to a gap for several designs, over the zone; the task of a worker."""
    cells, gap = argument
    band = gap.between[0]
    frequencies = []
    for cell in cells:
        model = QuickDesign.of(cell, band + 2).model
        grid, _ = cell.zone.triangles(DIVISIONS)
        wavevectors = (*grid, np.array(gap.lower_kappa), np.array(gap.upper_kappa))
        # the gap's wavevectors may lie slightly outside the zone of a design with other angles
        frequency = [model.frequencies(kappa)[band - 1 : band + 1] for kappa in wavevectors]
        frequencies.append(np.array(frequency).T)
    return xr.Dataset({"frequency": (("design", "side", "wavevector"), np.array(frequencies))})


def linear(gap: Gap, per_width: Array) -> Surface:
    """The edges of a gap to first order in the deviations."""
    coefficients = np.zeros((terms_needed(len(per_width)), 2, 1))
    coefficients[0, :, 0] = gap.edges
    coefficients[1 : len(per_width) + 1, :, 0] = per_width
    return Surface(coefficients, np.zeros(2))
