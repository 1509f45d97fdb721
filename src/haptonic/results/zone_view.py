"""Bands over the whole zone, for the interactive view of bands."""

from __future__ import annotations

from typing import Any

import numpy as np

from haptonic.bloch.zone import ZoneSurface
from haptonic.later import xarray as xr


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
    return data[["zone_kappa", "zone_frequency", "zone_error"]].assign(images)


def zone_corners(data: xr.Dataset) -> dict[str, Any]:
    """Corners of the irreducible zone by name, rad/m."""
    zone = ZoneSurface.of_dataset(data).zone
    corners = zone.lattice.wavevector(np.array(list(zone.corner_phases.values())))
    return dict(zip(zone.corner_phases, corners.tolist(), strict=True))
