"""Bonds of any thickness within a range, without another mesh.

Elements of a bond are boxes. For a thickness t their stiffness is ``A / t + B + C t``, from products of two,
one and no derivatives across, so three thicknesses determine it for all. Their mass is proportional to t. The
stiffness of the parts above does not depend on their height.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from haptonic.arrays import Array
from haptonic.plate.body.unreduced import Body
from haptonic.plate.layout.keys import bond


@dataclass(frozen=True, eq=False)
class Bond3:
    """Bond of an actuator on the unknowns of a tile.

    thickness : (3,) m; stiffness : (3, n, n) of the bond at these, N/m
    nominal : thickness in the tile, m; slope : (n, n) of the tile's mass with the thickness, kg/m
    """

    thickness: Array
    stiffness: Array
    nominal: float
    slope: Array

    def shares(self, thickness: float) -> Array:
        """(3,) shares of the three stiffnesses in that of another thickness, m."""
        ratio = self.thickness / thickness
        powers = np.stack([1 / ratio, np.ones(3), ratio])
        return np.asarray(np.linalg.solve(powers, np.ones(3)), dtype=np.float64)


@dataclass(frozen=True, eq=False)
class Bonded:
    """Body with the bond of an actuator in three thicknesses. thickness : (3,) m; nominal : of its tile"""

    thickness: Array
    bodies: tuple[Body, ...]
    nominal: float

    def projected(self, actuator: str, basis: Array) -> Bond3:
        """Project the bond onto fields (size, n) of the bodies."""
        part = bond(actuator)
        forms = np.stack([basis.T @ (body.stiffness[part] @ basis) for body in self.bodies])
        first, *_, last = self.bodies
        slope = (last.mass - first.mass) / (self.thickness[-1] - self.thickness[0])
        return Bond3(self.thickness, forms, self.nominal, basis.T @ (slope[:, None] * basis))
