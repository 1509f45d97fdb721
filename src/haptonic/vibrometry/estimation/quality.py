"""Quality of the records of each point, and repair of bad points from their neighbours."""

from __future__ import annotations

import json
from collections.abc import Collection
from dataclasses import dataclass, replace

import numpy as np
import scipy
from numpy.typing import NDArray

from haptonic.arrays import Array
from haptonic.channels.signals import Samples
from haptonic.errors import ScanError
from haptonic.response import FrequencyResponse

NEAR_FULL = 0.999  # of the full scale: a sample beyond it is clipped
FROZEN = 0.01  # of a record: a longer run of equal samples means that the laser lost the surface
LOW = 0.8  # median coherence below which a point is flagged
NEIGHBOURS = 4  # of a point on a square grid
FLAGS = ("saturated", "dropout", "low coherence", "repaired")


@dataclass(frozen=True, eq=False)
class Quality:
    """Quality of the points of an estimate.

    names : names of the points
    clipped : (point,) share of clipped samples
    frozen : (point,) longest run of equal samples over the length of a record
    coherence : (point,) median over the lines; NaN for a single average
    flags : flags of each point, out of "saturated", "dropout", "low coherence" and "repaired"
    """

    names: tuple[str, ...]
    clipped: Array
    frozen: Array
    coherence: Array
    flags: tuple[tuple[str, ...], ...]

    def flagged(self, *flags: str) -> NDArray[np.bool_]:
        """(point,) True for points with one of these flags, or with any flag if none is given."""
        wanted = set(flags or FLAGS)
        return np.array([bool(wanted & set(point_flags)) for point_flags in self.flags])


def assessed(names: tuple[str, ...], clipped: Array, frozen: Array, coherence: Array) -> Quality:
    """Set the flags that follow from the measures."""
    flags = []
    for share, run, median in zip(clipped, frozen, coherence, strict=True):
        conditions = [("saturated", share > 0), ("dropout", run > FROZEN), ("low coherence", median < LOW)]
        flags.append(tuple(name for name, bad in conditions if bad))
    return Quality(names=names, clipped=clipped, frozen=frozen, coherence=coherence, flags=tuple(flags))


def clipped_share(response: Samples, full_scale: float | None) -> Array:
    """(point,) share of samples at the full scale, or in a flat top if the full scale is unknown.

    Parameters
    ----------
    response : (point, repeat, sample) as stored
    """
    if full_scale is not None:
        most = NEAR_FULL * full_scale
        share = np.zeros(len(response))
        # most points have none, and an extreme is found much faster than samples are compared
        for point in np.flatnonzero(
            (response.max(axis=(1, 2)) >= most) | (response.min(axis=(1, 2)) <= -most)
        ):
            share[point] = np.mean((response[point] >= most) | (response[point] <= -most))
        return share
    share = np.zeros(len(response))
    for sign in (1, -1):
        top = response.max(axis=2, keepdims=True) if sign == 1 else response.min(axis=2, keepdims=True)
        at = (response == top) & (top != 0)
        # three samples in a row at the largest value, which a free vibration does not have
        in_row = at[..., :-2] & at[..., 1:-1] & at[..., 2:]
        has_flat_top = in_row.any(axis=2, keepdims=True)
        share += (at & has_flat_top).mean(axis=(1, 2))
    return share


def frozen_share(response: Samples) -> Array:
    """(point,) longest run of equal consecutive samples, over the length of a record.

    Equal samples on a coarse comb are searched first: a long run needs several of them.
    """
    samples = response.shape[2]
    stride = max(1, int(0.25 * FROZEN * samples))
    comb = response[..., ::stride]
    suspects = (comb[..., 1:] == comb[..., :-1]).any(axis=2) if stride > 1 else np.ones(comb.shape[:2], bool)
    longest = np.zeros(len(response))
    for point, repeat in np.argwhere(suspects):
        record = response[point, repeat]
        edges = np.flatnonzero(np.diff(record) != 0)
        run = np.diff(np.concatenate([[-1], edges, [samples - 1]])).max()
        longest[point] = max(longest[point], run / samples if run > 1 else 0.0)
    return longest


def check_flags(flags: Collection[str]) -> None:
    """Refuse unknown names of flags."""
    for flag in flags:
        if flag not in FLAGS:
            raise ScanError.unknown("flags", flag, FLAGS[:-1], "the flag is misspelt")


def repaired(
    response: FrequencyResponse, quality: Quality, flags: Collection[str]
) -> tuple[FrequencyResponse, Quality]:
    """Replace points with one of these flags by the mean of their neighbours, weighted by 1/distance^2.

    The replaced points are marked: "repaired" among their flags, and by name in the response's inputs and
    title. Their coherence is set to zero, because nothing was measured there.

    Raises
    ------
    ScanError : an unknown flag, or fewer than four points without flags
    """
    check_flags(flags)
    bad = quality.flagged(*flags)
    good = np.flatnonzero(~quality.flagged())
    if not bad.any():
        return response, quality
    if len(good) < NEIGHBOURS:
        raise ScanError.too_few(
            argument="repair",
            given=f"{len(good)} points without flags",
            allowed=f"at least {NEIGHBOURS}",
            cause="the whole scan is bad: the range of the vibrometer or the drive was wrong",
            next_step="measure again; these points cannot be repaired",
        )
    places, values = response.points, response.values.copy()
    distance, near = scipy.spatial.cKDTree(places[good]).query(places[bad], k=NEIGHBOURS)
    weight = 1 / np.maximum(distance, 1e-12) ** 2
    weight /= weight.sum(axis=1, keepdims=True)
    mixed = np.einsum("lpkd,pk->lpd", values[:, good[near]], weight)
    values[:, bad] = mixed.astype(values.dtype)
    data, notes = response.dataset, response.dataset.attrs
    names = [name for name, is_bad in zip(quality.names, bad, strict=True) if is_bad]
    coherence = None
    if "coherence" in data:
        coherence = np.where(bad, 0.0, data["coherence"].values)
    mended = FrequencyResponse.of(
        values,
        frequency=response.frequency, x=places[:, 0], y=places[:, 1],
        reference=notes["reference"], origin=notes["origin"], quantity=notes["quantity"],
        direction=[str(name) for name in data["direction"].values],
        coherence=coherence,
        region=[str(name) for name in data["region"].values] if "region" in data.coords else None,
        title=f"{notes['title']} ({len(names)} points repaired)".strip(),
        inputs=json.loads(notes["inputs"]) | {"repaired": names},
    )  # fmt: skip
    marked = [
        (*point_flags, "repaired") if is_bad else point_flags
        for point_flags, is_bad in zip(quality.flags, bad, strict=True)
    ]
    return mended, replace(quality, flags=tuple(marked))
