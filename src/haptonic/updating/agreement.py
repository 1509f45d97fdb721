"""Agreement of a measured and a computed response."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy

from haptonic.arrays import Array, Complex
from haptonic.errors import ScanError
from haptonic.gate import declared
from haptonic.later import xarray as xr
from haptonic.response import FrequencyResponse, frac, mac
from haptonic.updating.shapes import How, Pair, Shapes, pairs, shapes_of

NEAR = 0.25  # of the distance of neighbouring points: points closer than this are the same
UNRESOLVED = dict.fromkeys(("measured_damping", "computed_damping"), "the lines are too far apart")
SAME = 1e-6  # of a frequency: lines closer than this are the same


@dataclass(frozen=True, eq=False)
class Agreement:
    """Agreement of two responses at the same points and lines.

    frac : (points,) frequency response assurance criterion; NaN at points that do not move
    unexplained : share of the measured energy that the computed response lacks
    measured, computed : shapes
    mac : modal assurance criterion of each measured with each computed shape
    pairs : corresponding shapes
    """

    frac: Array
    unexplained: float
    measured: Shapes
    computed: Shapes
    mac: Array
    pairs: tuple[Pair, ...]


def agreement(measured: FrequencyResponse, computed: FrequencyResponse, how: How) -> Agreement:
    """Compare the normal motion of two responses; see `together`."""
    velocity = measured.dataset.attrs["quantity"] == "velocity"
    measured_motion = normal_of(measured)
    computed_motion = normal_of(computed.velocity() if velocity else computed.displacement())
    moving = (measured_motion != 0).any(axis=0) & (computed_motion != 0).any(axis=0)
    criterion = np.full(len(moving), np.nan)
    criterion[moving] = frac(measured_motion[:, moving], computed_motion[:, moving])
    first, second = (
        shapes_of(measured.frequency, values, how) for values in (measured_motion, computed_motion)
    )
    both = len(first.frequency) and len(second.frequency)
    return Agreement(
        frac=criterion,
        unexplained=float(
            (np.abs(measured_motion - computed_motion) ** 2).sum() / (np.abs(measured_motion) ** 2).sum()
        ),
        measured=first,
        computed=second,
        mac=mac(first.shape, second.shape) if both else np.zeros((len(first.shape), len(second.shape))),
        pairs=tuple(pairs(first, second)),
    )


def paired(result: Agreement) -> xr.Dataset:
    """(pair) frequencies of corresponding shapes, their difference, damping, and MAC."""
    first, second = ([getattr(pair, which) for pair in result.pairs] for which in ("first", "second"))
    measured, computed = result.measured.frequency[first], result.computed.frequency[second]
    numbers = {
        "measured": (measured, "Hz"), "computed": (computed, "Hz"),
        "frequency_difference": (computed / measured - 1, "1"), "mac": ([p.mac for p in result.pairs], "1"),
        "measured_damping": (result.measured.damping[first], "1"),
        "computed_damping": (result.computed.damping[second], "1"),
    }  # fmt: skip
    table = xr.Dataset({name: ("pair", values, {"units": u}) for name, (values, u) in numbers.items()})
    return declared(table, **UNRESOLVED)


def normal_of(response: FrequencyResponse) -> Complex:
    """(lines, points) motion along z, in double precision.

    Raises
    ------
    ScanError : no motion along z
    """
    directions = [str(name) for name in response.dataset["direction"].values]
    if "z" not in directions:
        raise ScanError.missing(
            argument="direction",
            given=", ".join(directions),
            allowed="a response with motion along z, normal to the plate",
            cause="the scan has motion in the plate only, or its directions have other names",
            next_step="export the direction normal to the plate as z",
        )
    return np.asarray(response.values[..., directions.index("z")], np.complex128)


def together(
    measured: FrequencyResponse, computed: FrequencyResponse
) -> tuple[FrequencyResponse, FrequencyResponse]:
    """Two responses at their common lines and points.

    Raises
    ------
    ScanError : fewer than three common lines or points, or responses per different units
    """
    per = [response.reference.unit for response in (measured, computed)]
    if per[0] != per[1]:
        units = [f"per {unit}" if unit else "not divided by the drive" for unit in per]
        raise _apart("reference", ", ".join(units), "one unit for both")
    lines = np.searchsorted(computed.frequency, measured.frequency * (1 - SAME))
    lines = np.minimum(lines, len(computed.frequency) - 1)
    common = np.abs(computed.frequency[lines] / np.maximum(measured.frequency, SAME) - 1) < SAME
    spacing, _ = scipy.spatial.cKDTree(computed.points).query(computed.points, k=min(2, len(computed.points)))
    distance, partner = scipy.spatial.cKDTree(computed.points).query(measured.points)
    near = distance <= NEAR * float(np.median(spacing[..., -1]))
    if common.sum() < 3 or near.sum() < 3:
        raise _apart(
            "computed",
            f"{common.sum()} of {len(common)} measured lines, {near.sum()} of {len(near)} measured points",
            "a computed response at three or more lines and points of the measurement",
        )
    rows = np.flatnonzero(common)
    first = measured.dataset.isel(frequency=rows, point=np.flatnonzero(near))
    second = computed.dataset.isel(frequency=lines[rows], point=partner[near])
    second = second.assign_coords({name: first[name] for name in ("frequency", "x", "y")})
    return FrequencyResponse(first), FrequencyResponse(second)


def _apart(argument: str, given: str, allowed: str) -> ScanError:
    return ScanError.mismatch(
        argument=argument,
        given=given,
        allowed=allowed,
        cause="it was computed on another grid, or the scan is not registered to the plate",
        next_step="give the study alone: its plate is then computed at the measured lines and points",
    )
