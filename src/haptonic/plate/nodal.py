"""Names of modes of rectangular regions by their nodal lines, as in 0x17."""

from __future__ import annotations

import numpy as np

from haptonic.arrays import Array

SEPARABLE = 0.7  # least share of a product of two curves in the square of a shape
QUIET = 0.2  # of a curve's peak, below which a change of sign is not counted


def nodal_name(shape: Array) -> str:
    """Nodal lines across a region and intervals between nodal lines along it, such as "0x17".

    Parameters
    ----------
    shape : (along, across) normal displacement on a regular grid; the region is longer in the first direction

    Returns
    -------
    empty if the shape is not a product of a curve along and a curve across
    """
    left, sizes, right = np.linalg.svd(np.nan_to_num(shape), full_matrices=False)
    if not sizes[0] or sizes[0] ** 2 < SEPARABLE * (sizes**2).sum():
        return ""
    across, along = _changes(right[0]), _changes(left[:, 0])
    return f"{across}x{max(along - 1, 0)}"


def has_one_lobe(name: str) -> bool:
    """True if a mode of this name, see `nodal_name`, has one lobe across its region."""
    return name.startswith("0x")


def _changes(curve: Array) -> int:
    """Changes of sign between parts of a curve that are not small."""
    loud = curve[np.abs(curve) > QUIET * np.abs(curve).max()]
    return int((np.diff(np.sign(loud)) != 0).sum())
