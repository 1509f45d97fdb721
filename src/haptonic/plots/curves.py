"""Smooth curves of a band diagram through its computed frequencies."""

from __future__ import annotations

import json
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from haptonic.arrays import Array, Ints
from haptonic.bloch.bands import lattice_of
from haptonic.later import xarray as xr

PIECES = 8  # straight pieces of a curve between two wavevectors


@dataclass(frozen=True)
class BandCurve:
    """One of the curves of a diagram; each runs along the whole path.

    It follows a branch through crossings. Where a branch ends and another one begins, the curve goes on
    in the order of the frequencies.

    band : (n,) column of its mode at each wavevector, from 0
    branch : (n,) number of the branch there
    distance, frequency : (PIECES (n - 1) + 1,) rad/m and Hz; every PIECES-th point is a computed one
    """

    band: Ints
    branch: Ints
    distance: Array
    frequency: Array


def curves(dataset: xr.Dataset) -> list[BandCurve]:
    """Curves through the frequencies of a diagram, with its group velocities as their slopes.

    Between two wavevectors a curve is the cubic polynomial with the frequencies and slopes at both ends.
    Where the slope at one end is not defined (rigid-body motion, modes of one frequency at a corner), it is a
    parabola with the other three numbers, and without group velocities a straight line. If another mode
    crosses the last band from above, they are the tangents up to where they meet.
    """
    distance, frequency = dataset["distance"].values, dataset["frequency"].values
    branch = dataset["branch"].values
    before, after = _slopes(dataset)
    step = np.diff(distance)
    share = np.arange(PIECES) / PIECES
    places = np.append((distance[:-1, None] + step[:, None] * share).ravel(), distance[-1])
    rows, last = np.arange(len(distance)), frequency.shape[1] - 1
    smooth = []
    for band in _followed(branch):
        values, number = frequency[rows, band], branch[rows, band]
        ends = after[rows, band][:-1] * step, before[rows, band][1:] * step
        heights = _cubic(values, *_defined(np.diff(values), *ends), share)
        # the last band changes its branch where the one above, which was not computed, crosses it
        entered = (number[1:] != number[:-1]) & (band[1:] == last) & (band[:-1] == last)
        tangents = _lower_tangent(values, *ends, share)
        kinked = entered & (tangents[:, 0] == values[:-1]) & (values[1:] <= values[:-1] + ends[0])
        heights = np.where(kinked[:, None], tangents, heights)
        smooth.append(BandCurve(band, number, places, np.append(heights.ravel(), values[-1])))
    return smooth


def _followed(branch: Ints) -> list[Ints]:
    """(n,) columns of the modes of each curve, for all curves."""
    column = np.arange(branch.shape[1])
    followed = [column]
    for old, new in pairwise(branch):
        after = np.full(len(column), -1)
        same, there = np.nonzero(old[:, None] == new)
        after[same] = there
        after[after < 0] = np.setdiff1d(np.arange(len(new)), there)  # both in the order of frequencies
        followed.append(after[followed[-1]])
    return list(np.stack(followed, axis=1))


def _slopes(dataset: xr.Dataset) -> tuple[Array, Array]:
    """(n, k) slopes towards the wavevector before and the one after, Hz m/rad; NaN where not defined."""
    frequency = dataset["frequency"].values
    if "group_velocity" not in dataset:
        return np.full_like(frequency, np.nan), np.full_like(frequency, np.nan)
    velocity = dataset["group_velocity"].values / (2 * np.pi)
    wavevector = lattice_of(dataset).wavevector(dataset["kappa"].values)
    along = np.diff(wavevector, axis=0)
    along /= np.linalg.norm(along, axis=1)[:, None]
    before, after = np.concatenate([along[:1], along]), np.concatenate([along, along[-1:]])
    towards_before, towards_after = (np.einsum("nka,na->nk", velocity, side) for side in (before, after))
    # modes of one frequency are combined for the segment after a corner, and may mix in the one before;
    # within the errors they may also be mixed by the mesh, which has not all symmetries of the cell
    corners = json.loads(dataset.attrs["path_corners"])[1:-1]
    error = dataset["frequency_error"].values[corners]
    close = np.diff(frequency[corners], axis=1) < error[:, 1:] + error[:, :-1]
    mixed = np.pad(close, ((0, 0), (1, 0))) | np.pad(close, ((0, 0), (0, 1)))
    for towards in (towards_before, towards_after):
        towards[corners] = np.where(mixed, np.nan, towards[corners])
    return towards_before, towards_after


def _defined(rise: Array, first: Array, last: Array) -> tuple[Array, Array]:
    """Changes per step at both ends of each step; those of a parabola or line where not defined."""
    started, ended = (
        np.where(np.isfinite(own), own, np.where(np.isfinite(other), 2 * rise - other, rise))
        for own, other in ((first, last), (last, first))
    )
    return started, ended


def _cubic(values: Array, first: Array, last: Array, share: Array) -> Array:
    """(n - 1, PIECES) heights between values (n,), with the changes per step at both ends of each step."""
    a, b, c, d = (x[:, None] for x in (values[:-1], np.diff(values), first, last))
    hermite = a + b * share**2 * (3 - 2 * share) + c * share * (1 - share) ** 2 - d * share**2 * (1 - share)
    return np.asarray(hermite)


def _lower_tangent(values: Array, first: Array, last: Array, share: Array) -> Array:
    """(n - 1, PIECES) the lower one of the tangents at both ends of each step."""
    a, b, c, d = (x[:, None] for x in (values[:-1], values[1:], first, last))
    return np.asarray(np.fmin(a + c * share, b - d * (1 - share)))
