"""Bending waves, the shortest waves of a plate: their length and the highest frequency that tiles resolve."""

from __future__ import annotations

import numpy as np
import scipy

from haptonic.errors import HaptonicError
from haptonic.plate.body.skeleton import TraceOrders
from haptonic.plate.layout.grid import Layout
from haptonic.units import format_quantity

# Phase of a bending wave along an edge, rad, at which its frequency is 1 % too high: slope per order and
# offset, measured for orders 2 to 7 along the edges
PER_ORDER, AT_FIRST = 2.7, 4.5
PER_ORDER_THROUGH = 2.25  # rad of it in the thickness for each order through that: 0.4 % high
SHEAR = np.pi**2 / 12  # Mindlin's factor for the shear stiffness of a plate


def highest_resolved(layout: Layout, orders: TraceOrders, *, roughly: bool = False) -> float:
    """Frequency of the shortest bending wave that the tiles of a plate resolve, Hz.

    ``roughly`` asks for two orders for each wave only, with which tiles distinguish its crests.
    """
    phase = np.pi * orders.along if roughly else max(PER_ORDER * orders.along - AT_FIRST, 0.0)
    along = phase / _edge(layout)
    wavenumber = min(along, PER_ORDER_THROUGH * orders.through / layout.thickness)
    return min(_bending(layout, wavenumber, axis) for axis in (0, 1)) / (2 * np.pi)


def check_resolved(layout: Layout, orders: TraceOrders, highest: float, *, roughly: bool) -> None:
    """Raise HaptonicError if bending waves of a frequency, Hz, are too short for the tiles of a plate."""
    allowed = highest_resolved(layout, orders, roughly=roughly)
    if highest > allowed:
        limit = format_quantity(0.9995 * allowed, "Hz")  # rounded, but not up
        edge = format_quantity(_edge(layout), "m")
        raise HaptonicError.out_of_range(
            argument="frequency",
            given=format_quantity(highest, "Hz"),
            allowed=f"at most {limit} on this plate, of which a tile is {edge} long",
            cause=f"bending waves above {limit} are too short for polynomials of order {orders.along} along "
            f"a tile to {'represent' if roughly else 'resolve to 1 % in frequency'}",
            next_step="ask for a lower frequency (`highest` in [plate.response], or --at), or draw plain "
            "plate with more and smaller tiles",
        )


def shortest_wavelength(layout: Layout, frequency: float) -> float:
    """Length of the shorter of the bending waves along the axes of the material at a frequency (Hz), m."""
    omega = 2 * np.pi * frequency
    lengths = []
    for axis in (0, 1):
        most = 1.0 / layout.thickness
        while _bending(layout, most, axis) < omega:
            most *= 2
        wavenumber = scipy.optimize.brentq(lambda k, axis=axis: _bending(layout, k, axis) - omega, 0.0, most)
        lengths.append(2 * np.pi / float(wavenumber))
    return min(lengths)


def _edge(layout: Layout) -> float:
    """Length of the longest edge of a tile, m."""
    return float(max(np.diff(layout.x).max(), np.diff(layout.y).max()))


def _bending(layout: Layout, wavenumber: float, axis: int) -> float:
    """Angular frequency of the bending wave with a wavenumber, rad/m, along an axis of the material.

    Mindlin 1951, doi 10.1115/1.4010217, eq. for straight-crested waves: the lower of the two branches.
    """
    thickness, tensor = layout.thickness, layout.material.stiffness
    plane = tensor[axis, axis] - tensor[axis, 2] ** 2 / tensor[2, 2]
    bend, shear = plane * thickness**3 / 12, SHEAR * tensor[4 - axis, 4 - axis] * thickness
    inertia, turning = layout.material.density * thickness, layout.material.density * thickness**3 / 12
    # the forms of deflection and slope, of stiffness and mass
    half = 0.5 * (shear * wavenumber**2 / inertia + (bend * wavenumber**2 + shear) / turning)
    product = shear * bend * wavenumber**4 / (inertia * turning)
    return float(np.sqrt(product / (half + np.sqrt(half**2 - product))))
