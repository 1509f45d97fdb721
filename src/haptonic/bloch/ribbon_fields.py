"""Fields of all modes of a ribbon on its flat face, on an even grid over one period, for views that move."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from haptonic.bloch.face_grid import FaceGrid, FlatFace, strongest
from haptonic.bloch.ribbon import RibbonModel, RibbonModes
from haptonic.gate import titled
from haptonic.later import xarray as xr


def fields_dataset(model: RibbonModel, modes_by_phase: Sequence[RibbonModes]) -> xr.Dataset:
    """Largest component of every mode on the flat face, with the largest displacement 1.

    Modes are in the order of `haptonic.bloch.ribbon_datasets.ribbon_dataset`.
    """
    face = FlatFace.of(model.fine.tiling, model.ribbon.turn)
    grid = FaceGrid.of_strip(face.position, face.triangles, model.ribbon.period)
    fields = [np.zeros((0, len(grid.across), len(grid.along)), dtype=complex)]
    components = [np.zeros(0, dtype=np.int64)]
    for modes in modes_by_phase:
        if not len(modes.frequency):
            continue
        chosen, component = strongest(face.motion(modes.fields))
        fields.append(grid.values(chosen, np.array([1j * modes.kappa])))
        components.append(component)
    field = np.concatenate(fields).astype(np.complex64)
    of_grid = ("mode", "across", "along")
    return titled({
        "mode_real": (of_grid, field.real, "1", "displacement in phase, largest 1"),
        "mode_imag": (of_grid, field.imag, "1", "displacement a quarter period earlier"),
        "mode_component": ("mode", np.concatenate(components).astype(np.int8), "1",
                           "component: 0 across the ribbon, 1 along it, 2 normal"),
        "present": (of_grid[1:], grid.present, "1", "1 where the ribbon is"),
        "across": ("across", grid.across, "m", "position across the ribbon"),
        "along": ("along", grid.along, "m", "position along the ribbon"),
    })  # fmt: skip
