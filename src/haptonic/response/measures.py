"""Similarity of two vibrations, and levels of regions.

Shapes and responses have the points in their last axis. Amplitudes are peak values, as in the response
itself; a root mean square is taken over points, never over time.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import scipy

from haptonic.arrays import AnyComplex, Array, Bools
from haptonic.errors import ResponseError
from haptonic.later import sparse as sp, xarray as xr
from haptonic.response.checks import REST
from haptonic.response.value import FrequencyResponse

ROUNDING = 1e-9  # of a disc's radius: tolerance for points on its rim
AT_ONCE = 2_000_000  # numbers that are converted to double precision at a time


def mac(a: AnyComplex, b: AnyComplex) -> Array:
    """Modal assurance criterion |a^H b|^2 / (a^H a  b^H b) of every shape with every other [allemang2003].

    Parameters
    ----------
    a, b : (m, point), (n, point) complex or real shapes, none of them zero everywhere

    Returns
    -------
    (m, n) from 0, orthogonal, to 1, equal up to a complex factor

    Raises
    ------
    ResponseError : shapes on different points, or one that is zero everywhere
    """
    if a.ndim != 2 or b.ndim != 2 or a.shape[1] != b.shape[1]:
        raise _unlike(a, b, "two sets of shapes, (m, points) and (n, points), on the same points")
    return np.asarray(np.minimum(np.abs(_unit(a, 1).conj() @ _unit(b, 1).T) ** 2, 1.0))


def frac(a: AnyComplex, b: AnyComplex) -> Array:
    """Frequency response assurance criterion of two responses, at each point [allemang2003].

    |sum a* b|^2 / (sum |a|^2 sum |b|^2), with sums over the lines: independent of a complex factor at each
    point.

    Parameters
    ----------
    a, b : (frequency, point) on the same lines and points

    Returns
    -------
    (point,) from 0 to 1

    Raises
    ------
    ResponseError : responses of different shapes, or a point without motion
    """
    if a.ndim != 2 or a.shape != b.shape:
        raise _unlike(a, b, "two responses (frequency, point) on the same lines and points")
    alike = np.abs((_unit(a, 0).conj() * _unit(b, 0)).sum(axis=0)) ** 2
    return np.asarray(np.minimum(alike, 1.0))


def rms(response: FrequencyResponse, region: str) -> xr.DataArray:
    """Root mean square over the points of a region, against frequency, in the units of the response.

    The amplitudes of all directions at a point are combined like the components of a vector.

    Raises
    ------
    ResponseError : no point in that region
    """
    return spectrum(response, _mean_square(response, response.inside(region)) ** 0.5, response.units)


def average_spectrum(response: FrequencyResponse) -> xr.DataArray:
    """Root mean square over all points, against frequency, in the units of the response."""
    everywhere = np.ones(response.dataset.sizes["point"], dtype=bool)
    return spectrum(response, _mean_square(response, everywhere) ** 0.5, response.units)


def contrast(response: FrequencyResponse, over: str, under: str) -> xr.DataArray:
    """Level of a region over another one, see `power_contrast`.

    Parameters
    ----------
    over, under : names of regions; one of them may be "rest", all points outside of the other

    Returns
    -------
    (frequency,) dB; infinite where one of them does not move

    Raises
    ------
    ResponseError : a region without points
    """
    upper, lower = (_mean_square(response, mask) for mask in sides(response, over, under))
    return spectrum(response, power_contrast(upper, lower), "dB")


def power_contrast(over: Array, under: Array) -> Array:
    """Contrast of two mean squares: 10 log10(over / under), that is 20 log10 of the ratio of their roots, dB.

    It is infinite where one of them is zero, and NaN where both are zero or one is negative. This is the only
    formula for levels of regions, whether they are computed, measured or corrected for noise.
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(10 * np.log10(over) - 10 * np.log10(under))


def sides(response: FrequencyResponse, over: str, under: str) -> tuple[Bools, Bools]:
    """(points,) masks of the two regions that are compared; one of them may be "rest", see `contrast`.

    Raises
    ------
    ResponseError : a region without points
    """
    upper, lower = (
        ~response.inside(other) if name == REST else response.inside(name)
        for name, other in ((over, under), (under, over))
    )
    for name, mask in ((over, upper), (under, lower)):
        if not mask.any():
            raise ResponseError.missing(
                argument="region",
                given=f'"{name}"',
                allowed="a region with points in it",
                cause="all points lie in the other region",
                next_step="compare with a region, or measure outside of them as well",
            )
    return upper, lower


def along(values: Mapping[str, xr.DataArray], dimension: str) -> xr.DataArray:
    """Concatenate arrays with equal axes along a dimension of their names."""
    names = xr.DataArray(np.array(list(values), dtype=str), dims=dimension, name=dimension)
    return xr.concat(list(values.values()), names, combine_attrs="drop_conflicts").rename(None)


def disc_average(response: FrequencyResponse, diameter: float) -> xr.DataArray:
    """Amplitude under a finger: root mean square over the disc around every point.

    The finger is wider than the lobes of the vibration. The film of air below it depends on the square of the
    local amplitude and not on its sign, so amplitudes are averaged, not the vibration itself, whose
    neighbouring lobes would cancel. At the plate's edge, only points on the plate count.

    Parameters
    ----------
    diameter : diameter of the disc, m; the rim belongs to the disc

    Returns
    -------
    (frequency, point) real, in the units of the response

    Raises
    ------
    ResponseError : the diameter is not positive
    """
    if not (np.isfinite(diameter) and diameter > 0):
        raise ResponseError.out_of_range(
            argument="diameter",
            given=f"{diameter} m",
            allowed="a positive length",
            cause="a size was left at zero or has the wrong sign",
            next_step="give the width of the contact, such as 0.01 m",
        )
    points = response.points
    near = discs(points, diameter)
    counts = np.array([len(members) for members in near])
    ends = np.concatenate([[0], np.cumsum(counts)])
    share = np.repeat(1.0 / counts, counts)
    averaging = sp.csr_array((share, np.concatenate(near), ends), shape=(len(points), len(points)))
    amplitude = np.sqrt(averaging @ squares(response.values).T).T
    old = response.dataset["response"]
    return xr.DataArray(
        amplitude,
        dims=("frequency", "point"),
        coords={name: c for name, c in old.coords.items() if "direction" not in c.dims},
        attrs={"units": response.units},
        name="amplitude",
    )


def discs(points: Array, diameter: float) -> list[list[int]]:
    """For each of points (k, 2), m, the indices of points on a disc around it, its rim included."""
    near: list[list[int]] = (
        scipy.spatial.cKDTree(points)
        .query_ball_point(points, 0.5 * diameter * (1 + ROUNDING), return_sorted=True)
        .tolist()
    )
    return near


def cmif(responses: Sequence[FrequencyResponse]) -> xr.DataArray:
    """Complex mode indication function: squared singular values of the response matrix [shih1988].

    Its peaks are modes; as many values are large at a peak as modes coincide there.

    Parameters
    ----------
    responses : one for each reference, on the same lines, points and directions

    Returns
    -------
    (frequency, value) in descending order, as many values as references

    Raises
    ------
    ResponseError : no response, or responses of different shapes
    """
    if not responses or len({response.values.shape for response in responses}) != 1:
        raise ResponseError.mismatch(
            argument="responses",
            given=", ".join(str(response.values.shape) for response in responses) or "none",
            allowed="one response for each reference, on the same lines, points and directions",
            cause="the responses come from different scans or computations",
            next_step="cut them to the same lines (between) and points (of_region)",
        )
    matrix = np.stack([r.values.reshape(len(r.frequency), -1) for r in responses], axis=-1)
    values = np.linalg.svd(matrix, compute_uv=False).astype(np.float64) ** 2
    lines = responses[0].dataset["frequency"]
    squared = f"({responses[0].units})^2"
    return xr.DataArray(
        values,
        dims=("frequency", "value"),
        coords={"frequency": lines},
        attrs={"units": squared},
        name="cmif",
    )


def _unit(shapes: AnyComplex, axis: int) -> AnyComplex:
    """Shapes of unit length, in double precision; refuses a zero shape."""
    largest = np.abs(shapes).max(axis=axis, keepdims=True)
    if not (largest > 0).all():
        raise ResponseError.no_answer(
            argument="shape",
            given=f"zero everywhere, in {np.count_nonzero(largest == 0)} of {largest.size}",
            allowed="a shape that is not zero",
            cause="points that are clamped, or a line at 0 Hz",
            next_step="leave these points or lines out",
        )
    scaled = (shapes / largest).astype(np.complex128)  # scaled first, so that no square over- or underflows
    return np.asarray(scaled / np.linalg.norm(scaled, axis=axis, keepdims=True))


def _unlike(a: AnyComplex, b: AnyComplex, allowed: str) -> ResponseError:
    return ResponseError.mismatch(
        argument="shapes",
        given=f"{a.shape} and {b.shape}",
        allowed=allowed,
        cause="they come from different meshes or scans, or one has an axis too many",
        next_step="take both on the same points, and one direction",
    )


def squares(values: AnyComplex) -> Array:
    """(frequency, point) squared length of the vector at every point, in double precision."""
    real, imaginary = values.real.astype(np.float64), values.imag.astype(np.float64)
    return np.asarray((real**2 + imaginary**2).sum(axis=2))


def _mean_square(response: FrequencyResponse, mask: Bools) -> Array:
    values = response.values
    lines = max(1, AT_ONCE // values[0].size)
    parts = (squares(values[i : i + lines, mask]).mean(axis=1) for i in range(0, len(values), lines))
    return np.concatenate(list(parts))


def spectrum(response: FrequencyResponse, values: Array, units: str) -> xr.DataArray:
    """(frequency,) values with the lines of a response."""
    lines = {"frequency": response.dataset["frequency"]}
    return xr.DataArray(values, dims=("frequency",), coords=lines, attrs={"units": units})
