"""Fields of guided waves on the flat face: across the plain strip and the first rows beside it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from haptonic.arrays import Array, Complex
from haptonic.bloch.face_grid import STEPS, FaceGrid, middles
from haptonic.bloch.guide import GuidedMode
from haptonic.bloch.layers import Interface
from haptonic.bloch.row_fields import SlabFields
from haptonic.bloch.rows import CondensedRows
from haptonic.bloch.wall import Wall
from haptonic.gate import titled
from haptonic.later import xarray as xr

ROWS = 4  # of the lattice that are drawn on each side
NORMAL = 2  # component of the displacement


def guides_dataset(lattice: CondensedRows, modes: Sequence[GuidedMode]) -> xr.Dataset:
    """Normal displacement of guided waves, largest 1, on one grid over the widest strip and one period."""
    step = float(lattice.rows.turn[0] @ lattice.rows.step)
    half = 0.5 * max(mode.width for mode in modes) + ROWS * step
    count = 2 * round(half / lattice.rows.period * STEPS)
    across, along = middles(-half, 2 * half, count), middles(0.0, lattice.rows.period, STEPS)
    right = across[count // 2 :]
    fields = []
    for mode in modes:
        of_right = guided_field(lattice, mode, right, along)
        whole = np.concatenate([(-1) ** mode.nodal_lines * of_right[::-1], of_right])
        fields.append(whole / whole.ravel()[np.abs(whole).argmax()])
    field = np.array(fields).astype(np.complex64)
    of_grid = ("waveguide", "across", "along")
    variables = {
        "mode_real": (of_grid, field.real, "1", "normal displacement in phase, largest 1"),
        "mode_imag": (of_grid, field.imag, "1", "normal displacement a quarter period earlier"),
        "phase": (
            of_grid[:1], np.array([mode.wavenumber for mode in modes]) * lattice.rows.period, "rad",
            "phase of the wave from one period of the rows to the next",
        ),
        "present": (of_grid[1:], np.ones(field.shape[1:], dtype=np.int8), "1", "1 where the plate is"),
        "across": ("across", across, "m", "position from the middle of the strip"),
        "along": ("along", along, "m", "position along the strip"),
    }  # fmt: skip
    return titled(variables)


def guided_field(lattice: CondensedRows, mode: GuidedMode, across: Array, along: Array) -> Complex:
    """(across, along) normal displacement at positions from the middle of the strip to the right, m.

    The waves of the plain plate that form the mode meet the right wall. Their motion at the edge is that of
    waves of the lattice, which decay from slab to slab.
    """
    rows, omega, phase = lattice.rows, mode.omega, mode.wavenumber * lattice.rows.period
    interface = Interface.of(lattice, mode.wavenumber)
    wall = Wall.of(interface, omega)
    assert wall is not None, "a guided mode has a wall"
    field = np.zeros((len(across), len(along)), dtype=complex)
    end = 0.5 * mode.width - lattice.setback
    inside = across < end
    harmonics = wall.motion(mode.width, mode.nodal_lines, across[inside])
    start = float(lattice.line[0] @ rows.turn[1])
    waves = np.exp(1j * np.outer(interface.tangential[: len(harmonics)], along - start))
    field[inside] = harmonics.T @ waves
    behind = interface.mirror(omega)
    incoming = np.zeros(len(behind.incoming), dtype=complex)
    incoming[wall.members] = wall.arriving(mode.width, mode.nodal_lines)
    reflection = behind.reflection() @ incoming
    at_line = behind.incoming.waves.displacement @ incoming + behind.outgoing.waves.displacement @ reflection
    amplitudes = behind.transmission(behind.reflection()) @ incoming
    inner = behind.lattice.displacement * amplitudes
    edge = 0.5 * mode.width - rows.middle  # from positions of the rows to positions in the guide
    slab = SlabFields.of_rows(lattice, phase)
    far = int(np.ceil((across.max() - end) / (rows.reach * float(rows.turn[0] @ rows.step)))) + 1
    for number in range(-1, far):  # a face that is not straight begins within the slab before it
        passed = inner * np.exp(number * behind.lattice.exponent)
        if number < 0:
            if not lattice.fillers:
                continue
            _, tiling = lattice.fillers[0]
            piece = SlabFields.of(
                tiling, lattice.ends(phase)[0], phase, (lattice.line, lattice.face), rows.turn
            )
            motion = piece.motion(omega, (interface.trace @ at_line)[:, None], inner.sum(axis=1)[:, None])
            shift = np.zeros(2)
        else:
            piece = slab
            motion = slab.motion(
                omega,
                passed.sum(axis=1)[:, None],
                (passed * np.exp(behind.lattice.exponent)).sum(axis=1)[:, None],
            )
            shift = number * rows.reach * rows.turn @ rows.step
        position = (piece.face.position + shift)[:, ::-1]
        grid = FaceGrid.of(
            along, across - edge, position, piece.face.triangles, np.array([[rows.period, 0.0]])
        )
        values = grid.values(motion[:, NORMAL], np.array([1j * phase]))[0].T
        there = grid.present.T.astype(bool) & ~inside[:, None]
        field[there] = values[there]
    return field
