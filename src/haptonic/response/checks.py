"""Checks of the arrays and names of a frequency response."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from haptonic.errors import ResponseError
from haptonic.response.reference import Reference

DIRECTIONS = ("x", "y", "z")
REST = "rest"  # all points outside of a region; see `haptonic.response.contrast`
THE_REST = "the rest"  # the same in prose
SLACK = 1e-6  # by which a coherence may exceed 1: rounding in single precision

Numbers = NDArray[Any]


def one_of(given: str, allowed: tuple[str, ...], argument: str) -> None:
    """Refuse a word that is not an allowed one."""
    if given not in allowed:
        cause = "the word is misspelt, or haptonic does not know such a response"
        raise ResponseError.unknown(f"response.{argument}", given, allowed, cause)


def directions(given: Sequence[str]) -> None:
    """Refuse directions other than x, y and z, and repeated ones."""
    all_known = not isinstance(given, str) and all(name in DIRECTIONS for name in given)
    if not (all_known and given and len(set(given)) == len(given)):
        raise ResponseError.malformed(
            argument="response.direction",
            given=repr(given),
            allowed='a list of one to three of "x", "y" and "z", each once',
            cause="a direction was repeated, or is that of an instrument and not of the plate",
            next_step='turn the response into the axes of the plate; z is normal to it: ("z",)',
        )


def reference(given: Reference) -> None:
    """Refuse a reference that is not a name and a unit."""
    if given and not (given.name.strip() and given.unit):
        raise ResponseError.malformed(
            argument="response.reference",
            given=f'"{given}"',
            allowed='a name and a unit, such as "A1, V", or nothing',
            cause="the unit is missing",
            next_step="add the unit of the quantity that the response was divided by",
        )


def frequencies(given: Numbers) -> None:
    """Refuse frequencies that do not ascend from zero or above."""
    array = np.asarray(given)
    fine = array.ndim == 1 and array.size > 0 and array.dtype.kind == "f" and bool(np.isfinite(array).all())
    if not (fine and array[0] >= 0 and (np.diff(array) > 0).all()):
        raise ResponseError.malformed(
            argument="response.frequency",
            given=_described(array),
            allowed="one or more frequencies in Hz, finite, not negative, strictly ascending",
            cause="the lines are not sorted, or a two-sided spectrum was not folded",
            next_step="sort the lines, and leave negative frequencies out",
        )


def positions(x: Numbers, y: Numbers) -> None:
    """Refuse positions that are not finite or not in pairs."""
    for name, given in (("x", np.asarray(x)), ("y", np.asarray(y))):
        if not (given.ndim == 1 and given.size and given.dtype.kind == "f" and np.isfinite(given).all()):
            raise ResponseError.malformed(
                argument=f"response.{name}",
                given=_described(given),
                allowed="finite positions in m, one for each point",
                cause="the points have no coordinates, or another form",
                next_step="give one number for each point, in m",
            )
    if len(x) != len(y):
        raise ResponseError.mismatch(
            argument="response.y",
            given=f"{len(y)} positions along y, {len(x)} along x",
            allowed="as many as along x",
            cause="rows and columns of a grid instead of points",
            next_step="give both coordinates of every point: numpy.meshgrid(x, y), then ravel()",
        )


def response(given: Numbers, shape: tuple[int, int, int]) -> None:
    """Refuse a response of another shape or type, or with numbers that are not finite."""
    array = np.asarray(given)
    if array.dtype not in (np.complex64, np.complex128) or array.shape != shape:
        raise ResponseError.malformed(
            argument="response.response",
            given=_described(array),
            allowed=f"complex, of shape {shape}: frequency, point, direction",
            cause="an axis is missing or in another place, or only the amplitude is given",
            next_step="give the complex response with an axis for each, also where its length is 1",
        )
    _refuse_not_finite("response", array)


def coherence(given: Numbers, shape: tuple[int, int]) -> None:
    """Refuse coherences of another shape or outside of [0, 1]."""
    array = np.asarray(given)
    if array.dtype.kind != "f" or array.shape != shape:
        raise ResponseError.malformed(
            argument="response.coherence",
            given=_described(array),
            allowed=f"real, of shape {shape}: frequency, point",
            cause="an axis is missing or in another place",
            next_step="give one coherence for each line and point",
        )
    _refuse_not_finite("coherence", array)
    if array.min() < 0 or array.max() > 1 + SLACK:
        raise ResponseError.out_of_range(
            argument="response.coherence",
            given=f"{array.min():g} to {array.max():g}",
            allowed="between 0 and 1",
            cause="it is a percentage, or the spectra were averaged differently",
            next_step="give the magnitude-squared coherence",
        )


def regions(given: Sequence[str], points: int) -> None:
    """Refuse names of regions unless each point has one."""
    if len(given) != points or isinstance(given, str):
        raise ResponseError.mismatch(
            argument="response.region",
            given=f"{len(given)} names for {points} points",
            allowed="one name for each point, empty outside of any region",
            cause="a list of the regions instead of one name for each point",
            next_step="name the region of every point",
        )
    if taken := {REST, THE_REST} & set(given):
        raise ResponseError.conflict(
            argument="response.region",
            given=f'"{min(taken)}"',
            allowed="any other name",
            cause="this word means all points outside of a region",
            next_step="leave the name of these points empty, or choose another one",
        )


def one_point_each(place: NDArray[np.int64], points: NDArray[np.float64]) -> None:
    """Refuse two points at one position of a grid."""
    _, first, times = np.unique(place, return_index=True, return_counts=True)
    if times.max() > 1:
        x, y = points[first[times.argmax()]] * 1e3
        raise ResponseError.repeated(
            argument="points",
            given=f"{times.max()} points at x = {x:.4g} mm, y = {y:.4g} mm",
            allowed="one point on each place of the grid",
            cause="a point was measured twice, or two scans were joined",
            next_step="leave one of them out",
        )


def _refuse_not_finite(name: str, array: Numbers) -> None:
    bad = np.argwhere(~np.isfinite(array))
    if len(bad):
        raise ResponseError.malformed(
            argument=f"response.{name}",
            given=f"{len(bad)} numbers that are not finite, the first at line {bad[0][0]}, point {bad[0][1]}",
            allowed="finite numbers",
            cause="points that were not measured, or a division by zero",
            next_step="leave out the points without a measurement; the grid shows where they are missing",
        )


def _described(array: Numbers) -> str:
    return f"{array.dtype} of shape {array.shape}"
