"""Fields of all modes of a ribbon on its flat face, on an even grid over one period, for views that move."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from haptonic.arrays import Array, Complex, Ints
from haptonic.bloch.ribbon import RibbonModel, RibbonModes
from haptonic.later import xarray as xr

STEPS = 16  # of the grid along a period; a guided wave has a few per wavelength at the end of the zone
EDGE = 1e-9  # share by which a point may lie outside a triangle due to rounding


@dataclass(frozen=True)
class FaceGrid:
    """Even grid over one period of a ribbon, with linear interpolation from the nodes of its flat face.

    across, along : positions of the grid, m; the ribbon runs along the second
    nodes, weights : (g, 3) corners of the triangle around each of g points, and their weights; 0 outside
    shift : (g,) periods from the point to this triangle
    """

    across: Array
    along: Array
    nodes: Ints
    weights: Array
    shift: Ints

    @classmethod
    def of(cls, position: Array, triangles: Ints, period: float) -> Self:
        """Make the grid for nodes at positions (n, 2), across and along, and triangles (t, 3)."""
        step = period / STEPS
        start, stop = position[:, 0].min(), position[:, 0].max()
        count = max(2, round((stop - start) / step))
        across = start + (np.arange(count) + 0.5) * (stop - start) / count
        along = position[:, 1].min() + (np.arange(STEPS) + 0.5) * step
        points = np.stack(np.meshgrid(across, along, indexing="ij"), axis=-1).reshape(-1, 2)
        nodes = np.zeros((len(points), 3), dtype=np.int64)
        weights, shift = np.zeros((len(points), 3)), np.zeros(len(points), dtype=np.int64)
        reach = int(np.ceil(np.ptp(position[:, 1]) / period - EDGE))  # tiles of oblique lattices lean
        for triangle in triangles:
            corner, *others = position[triangle]
            inverse = np.linalg.inv(np.transpose(np.array(others) - corner))
            low, high = position[triangle].min(axis=0), position[triangle].max(axis=0)
            for periods in range(reach):
                moved = points + np.array([0.0, periods * period])
                near = np.flatnonzero(((moved >= low) & (moved <= high)).all(axis=1))
                two = (moved[near] - corner) @ inverse.T
                shares = np.column_stack([1 - two.sum(axis=1), two])
                inside = near[(shares >= -EDGE).all(axis=1)]
                nodes[inside], shift[inside] = triangle, periods
                weights[inside] = shares[(shares >= -EDGE).all(axis=1)]
        return cls(across=across, along=along, nodes=nodes, weights=weights, shift=shift)

    def values(self, field: Complex, kappa: float) -> Complex:
        """(k, across, along) values of fields (n, k) of waves with a phase (rad) from period to period."""
        there = np.einsum("gc,gck->gk", self.weights, field[self.nodes])
        there *= np.exp(-1j * kappa * self.shift)[:, None]
        return np.moveaxis(there.reshape(len(self.across), len(self.along), -1), -1, 0)


def flat_face(model: RibbonModel) -> tuple[Ints, Array, Ints]:
    """Nodes (n,) on the flat face, their positions (n, 2) across and along (m), and triangles (t, 3)."""
    tiling, ribbon = model.fine.tiling, model.ribbon
    points = tiling.points
    faces = tiling.linear_subcells()[:, :4]
    faces = faces[(np.abs(points[faces, 2]) < 1e-9 * ribbon.period).all(axis=1)]
    nodes, corners = np.unique(faces, return_inverse=True)
    corners = corners.reshape(-1, 4)
    triangles = np.concatenate([corners[:, :3], corners[:, [0, 2, 3]]])
    return nodes, points[nodes, :2] @ ribbon.turn.T, triangles


def fields_dataset(model: RibbonModel, modes_by_phase: Sequence[RibbonModes]) -> xr.Dataset:
    """Largest component of every mode on the flat face, with the largest displacement 1.

    Modes are in the order of `haptonic.bloch.ribbon_datasets.ribbon_dataset`.
    """
    tiling, ribbon = model.fine.tiling, model.ribbon
    nodes, position, triangles = flat_face(model)
    grid = FaceGrid.of(position, triangles, ribbon.period)
    fields = [np.zeros((0, len(grid.across), len(grid.along)), dtype=complex)]
    components = [np.zeros(0, dtype=np.int64)]
    for modes in modes_by_phase:
        if not len(modes.frequency):
            continue
        motion = tiling.lifted(modes.fields)[nodes]  # (nodes, 3, modes)
        motion[:, :2] = np.einsum("xy,nyk->nxk", ribbon.turn, motion[:, :2])
        strongest = np.linalg.norm(motion, axis=0).argmax(axis=0)
        chosen = np.take_along_axis(motion, strongest[None, None], axis=1)[:, 0]
        place = np.abs(chosen).argmax(axis=0)
        chosen = chosen / np.take_along_axis(chosen, place[None], axis=0)
        fields.append(grid.values(chosen, modes.kappa))
        components.append(strongest)
    field = np.concatenate(fields).astype(np.complex64)
    of_grid = ("mode", "across", "along")
    there = grid.weights.any(axis=1).reshape(len(grid.across), -1)
    return xr.Dataset(
        {
            "mode_real": (of_grid, field.real, _titled("1", "displacement in phase, largest 1")),
            "mode_imag": (of_grid, field.imag, _titled("1", "displacement a quarter period earlier")),
            "mode_component": ("mode", np.concatenate(components).astype(np.int8),
                               _titled("1", "component: 0 across the ribbon, 1 along it, 2 normal")),
            "present": (of_grid[1:], there.astype(np.int8), _titled("1", "1 where the ribbon is")),
        },
        coords={
            "across": ("across", grid.across, _titled("m", "position across the ribbon")),
            "along": ("along", grid.along, _titled("m", "position along the ribbon")),
        },
    )  # fmt: skip


def _titled(unit: str, title: str) -> dict[str, str]:
    return {"units": unit, "long_name": title}
