"""Fields of waves in rows of a lattice on the flat face, on an even grid over one slab of rows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from haptonic.arrays import Array, Complex, Ints
from haptonic.bloch.evanescent import Slab, Waves
from haptonic.bloch.face_grid import STEPS, FaceGrid, FlatFace, middles, strongest
from haptonic.bloch.rows import CondensedRows
from haptonic.bloch.slab_boundary import SlabBoundary
from haptonic.gate import titled
from haptonic.later import xarray as xr
from haptonic.superelement import Tiling


@dataclass(frozen=True)
class SlabFields:
    """Motion of the flat face of a slab that follows from the motion of its two faces.

    boundary, slab : the slab, at a phase along it; face : in axes across and along the rows
    """

    boundary: SlabBoundary
    slab: Slab
    face: FlatFace

    @classmethod
    def of(cls, tiling: Tiling, slab: Slab, phase: float, faces: tuple[Array, Array], turn: Array) -> Self:
        """Make it for a slab of a tiling between two faces (n, 2), m."""
        return cls(SlabBoundary.of(tiling, phase, *faces), slab, FlatFace.of(tiling, turn))

    @classmethod
    def of_rows(cls, rows: CondensedRows, phase: float) -> Self:
        """Make it for one slab of the lattice."""
        faces = rows.face, rows.face + rows.rows.reach * rows.rows.step
        return cls.of(rows.blocks[-1][1], rows.slab(phase), phase, faces, rows.rows.turn)

    def motion(self, omega: float, left: Complex, right: Complex) -> Complex:
        """(nodes, 3, k) displacement across, along and normal for motions (n, k) of the faces at omega."""
        boundary, modes = self.slab.answer(omega, np.vstack([left, right]))
        tiling, first = self.face.tiling, 0
        unknowns = np.zeros((tiling.size, boundary.shape[1]), dtype=complex)
        for number, (tile, own) in enumerate(zip(tiling.tiles, tiling.own, strict=True)):
            rows, spread = self.boundary.rim(number)
            count = tile.size - tile.trace_size
            unknowns[own] = np.vstack([spread @ boundary[rows], modes[first : first + count]])
            first += count
        return self.face.motion(unknowns)


@dataclass(frozen=True)
class WaveField:
    """Fields of w waves at one frequency.

    field : (w, along the rows, across them); component : (w,) number of the component
    exponent : (w,) complex; the field is multiplied by its exponential from one slab to the next
    """

    field: Complex
    component: Ints
    exponent: Complex


@dataclass(frozen=True)
class RowFields:
    """Fields of waves of the lattice at a phase along the rows, on a grid over one slab.

    The grid is one period of the rows high, its first axis, and one slab wide.
    """

    slab: SlabFields
    grid: FaceGrid
    phase: float
    rows: CondensedRows

    @classmethod
    def of(cls, rows: CondensedRows, phase: float) -> Self:
        """Make the grid of rows."""
        slab, lattice = SlabFields.of_rows(rows, phase), rows.rows
        step = lattice.turn @ (lattice.reach * lattice.step)
        position = slab.face.position[:, ::-1]  # along the rows, then across them
        per_row = STEPS * lattice.reach
        grid = FaceGrid.of(
            middles(position[:, 0].min(), lattice.period, max(2, round(per_row * lattice.period / step[0]))),
            middles(lattice.middle, step[0], per_row),
            position, slab.face.triangles, np.array([[lattice.period, 0.0], step[::-1]]),
        )  # fmt: skip
        return cls(slab, grid, phase, rows)

    @property
    def slip(self) -> float:
        """Distance along the rows from one slab to the next, in periods."""
        lattice = self.rows.rows
        return float(lattice.turn[1] @ lattice.step * lattice.reach / lattice.period)

    def field(self, omega: float, waves: Waves) -> WaveField:
        """Strongest component of each wave to the right, see `strongest`; largest 1 on the grid."""
        motion = self.slab.motion(omega, waves.displacement, waves.displacement * np.exp(waves.exponent))
        chosen, component = strongest(motion)
        exponents = np.stack([np.full(len(waves), 1j * self.phase), waves.exponent])
        field = self.grid.values(chosen, exponents)
        return WaveField(field / np.abs(field).max(axis=(1, 2), keepdims=True), component, waves.exponent)

    def dataset(self, wave_fields: Sequence[WaveField]) -> xr.Dataset:
        """Dataset of the fields at each frequency."""
        field = np.array([each.field for each in wave_fields]).astype(np.complex64)
        exponent = np.array([each.exponent for each in wave_fields])
        of_wave = ("frequency", "wave")
        of_grid = (*of_wave, "across", "along")
        variables = {
            "wave_real": (of_grid, field.real, "1", "displacement in phase, largest 1 in a slab"),
            "wave_imag": (of_grid, field.imag, "1", "displacement a quarter period earlier"),
            "wave_component": (
                of_wave, np.array([each.component for each in wave_fields], dtype=np.int8), "1",
                "component: 0 across the rows, 1 along them, 2 normal",
            ),
            "slab_phase": (of_wave, exponent.imag, "rad", "phase from one slab to the next"),
            "slab_decay": (of_wave, -exponent.real, "1", "decay per slab, natural logarithm"),
            "slab_slip": ((), self.slip, "1", "distance of the next slab along the rows, over the period"),
            "slab_rows": ((), self.rows.rows.reach, "1", "number of rows of a slab"),
            "present": (of_grid[2:], self.grid.present, "1", "1 where the plate is"),
            "across": ("across", self.grid.across, "m", "position along the rows"),
            "along": ("along", self.grid.along, "m", "position across the rows"),
        }  # fmt: skip
        return titled(variables)
