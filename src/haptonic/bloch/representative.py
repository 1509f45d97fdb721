"""Representation of any wavevector by an equivalent one of the irreducible zone.

With the operations W of the cell's point group (`haptonic.lattice.PointGroup`), time reversal, k -> -k, and
the reciprocal lattice every wavevector is

    kappa = s W^-T kappa' + 2 pi n,    s = 1 or -1, n integers,

with kappa' in the irreducible zone. Both have the same frequencies. Modes at kappa are images of those at
kappa', complex conjugate for time reversal; a translation of the reciprocal lattice does not change them.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product

import numpy as np

from haptonic.arrays import Array, Complex, Ints
from haptonic.brillouin import IrreducibleZone
from haptonic.errors import StudyError, shown
from haptonic.lattice import HALF_TURN, Operation, PointGroup
from haptonic.superelement import Tiling
from haptonic.superelement.image import FieldImage

IDENTITY: Operation = ((1, 0), (0, 1))
BESIDE = 1e-6  # rad, tolerance at the border of the zone; the error of the small basis grows with its square
LARGEST = 1e6  # rad; larger phases have less than ten digits within a period
STEPS = np.array(sorted(product(range(-2, 3), repeat=2), key=lambda step: np.abs(step).sum()))


def signed_operations(group: PointGroup) -> list[tuple[Operation, int]]:
    """Operations that leave frequencies over the zone unchanged, with their products with time reversal.

    The identity comes first. Half a turn changes wavevectors like time reversal.
    """
    operations = sorted(group.operations, key=lambda operation: operation != IDENTITY)
    reversals = () if HALF_TURN in group else (-1,)
    return [(operation, sign) for sign in (1, *reversals) for operation in operations]


@dataclass(frozen=True)
class Representative:
    """Wavevector of the irreducible zone that is equivalent to a given one.

    kappa : (2,) phases in the irreducible zone, rad; image : (2,) phases of the given wavevector
    operation : of the point group, from ``kappa`` to ``image``; sign : -1 with time reversal, otherwise 1
    """

    kappa: Array
    image: Array
    operation: Operation
    sign: int

    @classmethod
    def of(cls, zone: IrreducibleZone, group: PointGroup, kappa: Array) -> Representative:
        """Find the wavevector of the zone that is equivalent to the phases (2,).

        A wavevector in the zone represents itself. Otherwise the identity is preferred, then few
        translations.

        Raises
        ------
        StudyError : not two finite phases, or phases too large for their rounding errors
        """
        image = np.asarray(kappa, dtype=float)
        if image.shape != (2,) or not (np.abs(image) <= LARGEST).all():
            raise StudyError.malformed(
                argument="kappa",
                given=shown(image.tolist()),
                allowed=f"the two phases k.a1 and k.a2 of a wavevector, rad, at most {LARGEST:g}",
                cause="several wavevectors were given, a number is missing, or a value is not a number",
                next_step="give an array of two numbers, such as numpy.array([numpy.pi, 0.0]), or subtract "
                "multiples of 2 pi",
            )
        if zone.depth(image[None])[0] >= -BESIDE:
            return cls(image, image, IDENTITY, 1)
        near = image - 2 * np.pi * np.round(image / (2 * np.pi))
        signed = signed_operations(group)
        turns = np.array([sign * np.array(operation) for operation, sign in signed])
        # kappa' = s W^T (kappa - 2 pi n)
        candidates = np.einsum("wji,nj->wni", turns, near - 2 * np.pi * STEPS)
        depth = zone.depth(candidates.reshape(-1, 2))
        inside = np.flatnonzero(depth >= -BESIDE)
        # the gap between a zone and its images due to rounded corners is smaller than this
        chosen = int(inside[0]) if len(inside) else int(depth.argmax())
        assert depth[chosen] > -1e3 * BESIDE, "the images of the zone do not cover the plane"
        operation, sign = signed[chosen // len(STEPS)]
        return cls(candidates.reshape(-1, 2)[chosen], image, operation, sign)

    def gradient(self, slopes: Array) -> Array:
        """(k, 2) derivatives with respect to the phases of the image from those at ``kappa``."""
        return np.asarray(slopes @ (self.sign * np.array(self.operation)).T)

    def fields(self, tiling: Tiling, unknowns: Complex) -> Complex:
        """(nodes, 3, k) displacement on the meshes at the image, from unknowns (t + m, k) at ``kappa``."""
        shapes = tiling.lifted(unknowns)
        if self.sign < 0:
            shapes = shapes.conj()
        if self.operation == IDENTITY:
            return np.asarray(shapes)
        return FieldImage.of(tiling, self.operation).applied(shapes, self.image)


def images(group: PointGroup, kappa: Array) -> tuple[Array, Ints]:
    """(copies n, 2) phases of all images of wavevectors (n, 2), and (copies n,) number of each original."""
    matrices = [sign * np.array(operation) for operation, sign in signed_operations(group)]
    turned = [kappa @ np.linalg.inv(matrix) for matrix in matrices]
    return np.concatenate(turned), np.tile(np.arange(len(kappa)), len(turned))
