"""Bands over the whole zone, for the interactive view of bands."""

from __future__ import annotations

from typing import Any

import numpy as np

from haptonic.bloch.zone import ZoneSurface
from haptonic.later import xarray as xr

SAMPLES = ["zone_kappa", "zone_frequency", "zone_error"]
ZONE_SHORT = ["zone_mode_real", "zone_mode_imag"]  # stored with 16 bits
MODES = [
    "zone_velocity", "zone_velocity_error", "zone_parity", "zone_mirror", "zone_middle_parity",
    "zone_character", *ZONE_SHORT,
]  # fmt: skip


def zone_variables(data: xr.Dataset) -> xr.Dataset:
    """Frequencies at samples of the irreducible zone, and the places of these samples in the whole zone."""
    wavevector, triangles, number = ZoneSurface.of_dataset(data).unfolded()
    per_metre = {"units": "rad/m", "long_name": "wavevector"}
    images = {
        "zone_wavevector": (("image", "axis"), wavevector, per_metre),
        "zone_sample": ("image", number, {"units": "1", "long_name": "number of the sample"}),
        "zone_mesh": (
            ("image_triangle", "vertex"),
            triangles,
            {"units": "1", "long_name": "triangles of images"},
        ),
    }
    return data[[*SAMPLES, *(name for name in MODES if name in data)]].assign(images)


def zone_extra(data: xr.Dataset) -> dict[str, Any]:
    """Corners of the irreducible zone by name (rad/m), and maps of its modes to the images of a sample."""
    surface = ZoneSurface.of_dataset(data)
    zone = surface.zone
    corners = zone.lattice.wavevector(np.array(list(zone.corner_phases.values())))
    turns, signs = surface.turns()
    return {
        "zone": dict(zip(zone.corner_phases, corners.tolist(), strict=True)),
        "zone_turns": turns.tolist(),
        "zone_signs": signs.tolist(),
    }
