"""Solids with three planes of symmetry along the axes: rolled sheet, fibre composites, cubic crystals."""

from __future__ import annotations

from dataclasses import asdict
from typing import Annotated

import numpy as np

from haptonic.arrays import Array
from haptonic.fields import Entries, described, needed
from haptonic.materials.common import (
    DENSITY,
    require_between,
    require_name,
    require_positive_definite,
    rows_of,
    spread_of,
)

CONSTANTS = ("c11", "c22", "c33", "c23", "c13", "c12", "c44", "c55", "c66")
PROPERTIES = {**dict.fromkeys(CONSTANTS, "Pa"), "density": "kg/m^3", "loss_factor": ""}


@described("material")
class OrthotropicMaterial:
    """A solid with nine elastic constants; its axes are those of the plate, 3 along the normal.

    c11 ... c66 : stiffnesses in Voigt order 11, 22, 33, 23, 13, 12, Pa; together positive definite
    density : kg/m^3, positive
    loss_factor, source, uncertainty, note : as for an isotropic material

    Raises
    ------
    StudyError : constants of an unstable solid
    """

    name: str
    c11: float
    c22: float
    c33: float
    c23: float
    c13: float
    c12: float
    c44: float
    c55: float
    c66: float
    density: Annotated[float, DENSITY] = needed("Mass per volume.")
    loss_factor: float = 0.0
    source: str = ""
    uncertainty: Entries[float] = Entries()
    note: str = ""

    def __post_init__(self) -> None:
        require_name(self.name)
        for constant in CONSTANTS:
            require_between(constant, getattr(self, constant), "Pa")
        require_between("loss_factor", self.loss_factor, "", at_least=0.0, below=1.0)
        require_positive_definite("stiffness", rows_of("stiffness", self.stiffness, (6, 6)))
        object.__setattr__(self, "uncertainty", spread_of(self.uncertainty, PROPERTIES))

    @classmethod
    def cubic(
        cls,
        name: str,
        *,
        c11: float,
        c12: float,
        c44: float,
        density: float,
        loss_factor: float = 0.0,
        source: str = "",
        note: str = "",
    ) -> OrthotropicMaterial:
        """A cubic crystal with its cube axes along those of the plate; stiffnesses in Pa."""
        return cls(
            name,
            *(c11, c11, c11),
            *(c12, c12, c12),
            *(c44, c44, c44),
            density=density,
            loss_factor=loss_factor,
            source=source,
            note=note,
        )

    @property
    def stiffness(self) -> Array:
        """(6, 6), Pa, in Voigt order 11, 22, 33, 23, 13, 12 with engineering shear strains."""
        return np.array(
            [
                [self.c11, self.c12, self.c13, 0, 0, 0],
                [self.c12, self.c22, self.c23, 0, 0, 0],
                [self.c13, self.c23, self.c33, 0, 0, 0],
                [0, 0, 0, self.c44, 0, 0],
                [0, 0, 0, 0, self.c55, 0],
                [0, 0, 0, 0, 0, self.c66],
            ],
            dtype=float,
        )

    def to_dict(self) -> dict[str, object]:
        """Plain values for JSON: the kind and every field."""
        return {"kind": "orthotropic", **asdict(self), "uncertainty": dict(self.uncertainty)}
