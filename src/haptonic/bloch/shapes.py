"""Modes at one wavevector on all nodes of the cell."""

from __future__ import annotations

import numpy as np

from haptonic.arrays import Array
from haptonic.bloch.character import characters
from haptonic.bloch.model import BlochModel
from haptonic.bloch.symmetry import MIDDLE
from haptonic.gate import describe
from haptonic.later import xarray as xr


def mode_shapes(model: BlochModel, kappa: Array) -> xr.Dataset:
    """Fields of all modes at one wavevector on the meshes of all tiles, with linear sub-cells for drawing."""
    tiling = model.fine.tiling
    solution = model.solve(kappa)
    shapes = model.displacement(solution)
    largest = np.abs(shapes).max(axis=(0, 1))
    turned = shapes / largest
    for k in range(turned.shape[2]):  # choose the phase with the largest real part
        square = (turned[..., k] ** 2).sum()
        turned[..., k] *= np.exp(-0.5j * np.angle(square))
    named = characters(tiling, solution.fields)
    dataset = xr.Dataset(
        {
            "node_position": (("node", "xyz"), tiling.points),
            "subcell": (("cell", "corner"), tiling.linear_subcells()),
            "mode_frequency": ("mode", solution.frequency),
            "mode_error": ("mode", solution.error),
            "mode_name": ("mode", named.name),
            "mode_parity": ("mode", model.fine.parity(solution.modes)),
            "mode_kappa": ("axis", kappa),
            "mode_real": (("mode", "node", "xyz"), np.moveaxis(turned.real, 2, 0).astype(np.float32)),
            "mode_imag": (("mode", "node", "xyz"), np.moveaxis(turned.imag, 2, 0).astype(np.float32)),
        }
    )
    describe(dataset, {
        "node_position": ("m", "position of the mesh's nodes"),
        "subcell": ("1", "eight corners of linear cells between nodes"),
        "mode_frequency": ("Hz", "frequency"),
        "mode_error": ("Hz", "bound of the frequency's error"),
        "mode_name": ("1", "character, a position in character_names"),
        "mode_parity": ("1", MIDDLE),
        "mode_kappa": ("rad", "phases k . a1 and k . a2"),
        "mode_real": ("1", "displacement in phase, largest component 1"),
        "mode_imag": ("1", "displacement a quarter period earlier"),
    })  # fmt: skip
    return dataset
