"""Piezoelectric solids in stress-charge form: T = c^E S - e^T E, D = e S + eps^S E [ieee176]."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field

import numpy as np

from haptonic.arrays import Array
from haptonic.fields import Entries
from haptonic.materials.common import (
    VOIGT,
    Rows,
    require_between,
    require_name,
    require_positive_definite,
    rows_of,
    spread_of,
)

PROPERTIES = {"density": "kg/m^3", "loss_factor": "", "dielectric_loss": ""}


@dataclass(frozen=True)
class PiezoelectricMaterial:
    """A solid with coupled strain and electric field; a poled ceramic is poled along axis 3.

    elastic : (6, 6) rows, stiffness at constant electric field c^E, Pa, positive definite
    coupling : (3, 6) rows, piezoelectric stress constants e, C/m^2
    permittivity : (3, 3) rows, at constant strain eps^S, F/m, positive definite
    density : kg/m^3, positive
    loss_factor : mechanical, at least 0 and below 1
    dielectric_loss : loss tangent, at least 0 and below 1
    source, uncertainty, note : as for an isotropic material

    Raises
    ------
    StudyError : matrices of another shape, or constants that no stable solid has
    """

    name: str
    elastic: Rows
    coupling: Rows
    permittivity: Rows
    density: float
    loss_factor: float = 0.0
    dielectric_loss: float = 0.0
    source: str = ""
    uncertainty: Mapping[str, float] = field(default_factory=Entries)
    note: str = ""

    def __post_init__(self) -> None:
        require_name(self.name)
        for matrix, shape in {"elastic": (6, 6), "coupling": (3, 6), "permittivity": (3, 3)}.items():
            object.__setattr__(self, matrix, rows_of(matrix, getattr(self, matrix), shape))
        require_positive_definite("elastic", self.elastic)
        require_positive_definite("permittivity", self.permittivity)
        require_between("density", self.density, "kg/m^3", above=0.0)
        require_between("loss_factor", self.loss_factor, "", at_least=0.0, below=1.0)
        require_between("dielectric_loss", self.dielectric_loss, "", at_least=0.0, below=1.0)
        object.__setattr__(self, "uncertainty", spread_of(self.uncertainty, PROPERTIES))

    @property
    def stiffness(self) -> Array:
        """c^E, (6, 6), Pa, in Voigt order 11, 22, 33, 23, 13, 12 with engineering shear strains."""
        return np.array(self.elastic)

    @property
    def coupling_tensor(self) -> Array:
        """(3, 3, 3) tensor e_akl of the coupling, C/m^2: field direction, then the pair of the strain."""
        return np.array(self.coupling)[:, np.array(VOIGT)]

    def to_dict(self) -> dict[str, object]:
        """Plain values for JSON: the kind and every field."""
        plain = {
            name: [list(row) for row in getattr(self, name)]
            for name in ("elastic", "coupling", "permittivity")
        }
        return {"kind": "piezoelectric", **asdict(self), **plain, "uncertainty": dict(self.uncertainty)}
