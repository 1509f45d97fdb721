"""Waves in a scan: wavenumbers along a guide, and the decay through the lattice."""

from __future__ import annotations

import warnings
from typing import Literal

import numpy as np
import scipy

from haptonic.errors import HaptonicWarning, ScanError
from haptonic.later import xarray as xr
from haptonic.response import FrequencyResponse
from haptonic.units import in_percent

Axis = Literal["x", "y"]

PADDED = 4  # times the length of the guide: a finer map, not a higher resolution
LINES = 256  # that are transformed at a time
HIGH = 0.85  # of the largest wavenumber; beyond, waves may be aliased
SUSPECT = 0.1  # share of the energy there that causes a warning
SAME_COLUMN = 1e-6  # of the extent: points within it lie at the same depth


def grid_step(response: FrequencyResponse) -> float:
    """Median distance of a point to its nearest neighbour, m."""
    distance, _ = scipy.spatial.cKDTree(response.points).query(response.points, k=2)
    return float(np.median(distance[:, 1]))


def warn_if_aliased(step: float, wavelength: float, what: str = "the shortest wave") -> bool:
    """Warn, and return True, if a grid is too coarse for a wavelength: steps above half of it.

    Parameters
    ----------
    step, wavelength : m
    """
    aliased = step > wavelength / 2 * (1 + 1e-9)
    if aliased:
        warnings.warn(
            f"steps of {step * 1e3:.4g} mm are more than half of {what}, {wavelength * 1e3:.4g} mm: it shows "
            f"with a wrong, longer wavelength; scan with steps below {wavelength / 2 * 1e3:.4g} mm",
            HaptonicWarning,
            stacklevel=2,
        )
    return aliased


def wavenumber_map(response: FrequencyResponse, region: str, along: Axis) -> xr.DataArray:
    """Amplitude against frequency and wavenumber along a guide, by a spatial transform of every row.

    Rows with a missing point are left out and counted in the attributes; missing data are not interpolated.
    The phase convention is that of all Bloch waves in haptonic: exp(i omega t + i k x), so a wave of positive
    wavenumber travels towards smaller coordinates.

    Parameters
    ----------
    region : name of the guide's region, on a regular grid
    along : axis of the guide

    Returns
    -------
    (frequency, wavenumber) root mean square over the rows, weighted by a Hann window scaled to preserve the
    amplitude of a wave; wavenumber in rad/m, from -pi/step; attributes step (m), rows, rows_left_out

    Raises
    ------
    ScanError : fewer than eight points along the guide, or no whole row
    ResponseError : an unknown region, or points that are not on a regular grid
    """
    grid = (
        response.of_region(region)
        .grid()
        .transpose("frequency", "direction", {"x": "y", "y": "x"}[along], along)
    )
    values, place = np.asarray(grid.values), np.asarray(grid[along].values)
    # (frequency, row and direction, place)
    rows = np.moveaxis(values, 2, 1).reshape(len(values), -1, len(place))
    whole = np.isfinite(rows).all(axis=(0, 2))
    if len(place) < 8 or not whole.any():
        raise ScanError.too_few(
            argument=f'region "{region}"',
            given=f"{len(place)} points along {along}, {int(whole.sum())} rows without a missing point",
            allowed="eight points or more along the guide, and at least one whole row of them",
            cause="the guide runs along the other axis, or points of every row were dropped",
            next_step=f'choose along="{ {"x": "y", "y": "x"}[along] }", or repair the points first',
        )
    step = float(place[1] - place[0])
    weight = np.hanning(len(place) + 2)[1:-1]
    count = PADDED * len(place)
    amplitude = np.empty((len(rows), count))
    for start in range(0, len(rows), LINES):
        weighted = rows[start : start + LINES, whole] * (weight / weight.sum())
        spectrum = np.fft.fft(weighted, n=count, axis=2)
        amplitude[start : start + LINES] = np.sqrt((np.abs(spectrum) ** 2).mean(axis=1))
    wavenumber = np.fft.fftshift(2 * np.pi * np.fft.fftfreq(count, step))
    notes = {"step": step, "rows": int(whole.sum()), "rows_left_out": int((~whole).sum())}
    amplitudes = xr.DataArray(
        np.fft.fftshift(amplitude, axes=1),
        dims=("frequency", "wavenumber"),
        coords={
            "frequency": response.dataset["frequency"],
            "wavenumber": ("wavenumber", wavenumber, {"units": "rad/m"}),
        },
        attrs={"units": response.units} | notes,
        name="amplitude",
    )
    energy = amplitudes.values**2
    share = float(energy[:, np.abs(wavenumber) > HIGH * np.pi / step].sum() / max(energy.sum(), 1e-300))
    if share > SUSPECT:
        warnings.warn(
            f"{in_percent(share)} of the energy lies within 15 % of the largest wavenumber that steps of "
            f"{step * 1e3:.4g} mm resolve: shorter waves are probably aliased; scan with smaller steps",
            HaptonicWarning,
            stacklevel=2,
        )
    return amplitudes


def lattice_decay(
    response: FrequencyResponse,
    region: str,
    *,
    depth: Axis,
    start: float,
    pitch: float,
    inwards: Literal[1, -1] = 1,
    confidence: float = 0.95,
) -> xr.Dataset:
    """Attenuation of a vibration by a lattice from row to row, by a straight line through levels in dB.

    Energies are averaged over points of equal depth. The field within the cells is not modelled: it is part
    of the residual, and therefore of the confidence interval.

    Parameters
    ----------
    region : name of the lattice's region
    depth : axis into the lattice
    start, pitch : position of the front of the lattice, and depth of a row along that axis, m
    inwards : -1 if the lattice lies towards smaller coordinates
    confidence : level of the interval

    Returns
    -------
    ``decay``, ``error`` (standard), ``low``, ``high`` in dB per row against frequency; positive for
    attenuation

    Raises
    ------
    ScanError : fewer than three depths inside the lattice, or a size that is not positive
    ResponseError : an unknown region
    """
    part = response.of_region(region)
    place = inwards * (part.points[:, 0 if depth == "x" else 1] - start)
    if not (pitch > 0 and 0 < confidence < 1):
        given = f"pitch {pitch:g} m, confidence {confidence:g}"
        raise _wrong("pitch", given, "a positive pitch, a confidence between 0 and 1")
    inside = place >= -SAME_COLUMN * pitch
    order = np.argsort(place[inside], kind="stable")
    ascending = place[inside][order]
    extent = max(float(np.ptp(ascending)), pitch) if len(ascending) else pitch
    column = np.cumsum(np.diff(ascending, prepend=-np.inf) > SAME_COLUMN * extent) - 1
    count = int(column[-1]) + 1 if len(column) else 0
    if count < 3:
        raise _wrong("region", f"{count} depths in it beyond the start", "points at three depths or more")
    cells = np.bincount(column, ascending) / np.bincount(column) / pitch
    energy = (np.abs(part.values.astype(np.complex128)) ** 2).sum(axis=2)[:, inside][:, order]
    share = np.zeros((energy.shape[1], count))
    share[np.arange(len(column)), column] = 1 / np.bincount(column)[column]
    means = energy @ share
    if not (means > 0).all():
        raise _wrong("region", "depths without any vibration", "a vibration everywhere, even if only noise")
    level = 10 * np.log10(means)
    x = cells - cells.mean()
    slope = level @ x / (x @ x)
    residual = level - level.mean(axis=1, keepdims=True) - slope[:, None] * x
    error = np.sqrt((residual**2).sum(axis=1) / (count - 2) / (x @ x))
    reach = float(scipy.stats.t.ppf(0.5 + confidence / 2, count - 2)) * error
    lines = {"frequency": response.dataset["frequency"]}
    rows = {"decay": -slope, "error": error, "low": -slope - reach, "high": -slope + reach}
    return xr.Dataset(
        {name: ("frequency", values, {"units": "dB/row"}) for name, values in rows.items()},
        coords=lines,
        attrs={"region": region, "confidence": confidence, "depths": count, "pitch": pitch},
    )


def _wrong(argument: str, given: str, allowed: str) -> ScanError:
    return ScanError.out_of_range(
        argument=f"lattice_decay.{argument}",
        given=given,
        allowed=allowed,
        cause="the depth is the other axis, the start lies behind the lattice, or lengths are in mm",
        next_step="give the coordinates of the plate in m, and the direction inwards (1 or -1)",
    )
