"""Isotropic solids and their wave speeds."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field

import numpy as np

from haptonic.materials.common import Array, Spread, require_between, require_name, spread_of

POISSON_BOUNDS = (-1.0, 0.5)
INCOMPRESSIBLE = (
    "a solid with a Poisson ratio of 0.5 is incompressible and has no finite bulk modulus; write 0.49 for "
    "something close to it, such as rubber"
)
PROPERTIES = {"youngs_modulus": "Pa", "poisson_ratio": "", "density": "kg/m^3", "loss_factor": ""}


@dataclass(frozen=True)
class IsotropicMaterial:
    """A solid that is the same in every direction.

    youngs_modulus : Pa, positive
    poisson_ratio : above -1 and below 0.5
    density : kg/m^3, positive
    loss_factor : imaginary over real part of the stiffness, at least 0 and below 1
    source : key of the bibliography (``docs/references.bib``), or words
    uncertainty : half-width of the plausible interval of a property, in its SI unit

    Raises
    ------
    StudyError : a property outside these limits
    """

    name: str
    youngs_modulus: float
    poisson_ratio: float
    density: float
    loss_factor: float = 0.0
    source: str = ""
    uncertainty: Mapping[str, float] = field(default_factory=Spread)
    note: str = ""

    def __post_init__(self) -> None:
        require_name(self.name)
        require_between("youngs_modulus", self.youngs_modulus, "Pa", above=0.0)
        lowest, highest = POISSON_BOUNDS
        stiffer = isinstance(self.poisson_ratio, int | float) and self.poisson_ratio >= highest
        hint = INCOMPRESSIBLE if stiffer else ""
        require_between("poisson_ratio", self.poisson_ratio, "", above=lowest, below=highest, hint=hint)
        require_between("density", self.density, "kg/m^3", above=0.0)
        require_between("loss_factor", self.loss_factor, "", at_least=0.0, below=1.0)
        object.__setattr__(self, "uncertainty", spread_of(self.uncertainty, PROPERTIES))

    @property
    def shear_modulus(self) -> float:
        """Pa."""
        return self.youngs_modulus / (2 * (1 + self.poisson_ratio))

    @property
    def lame(self) -> float:
        """First Lamé constant, Pa."""
        nu = self.poisson_ratio
        return self.youngs_modulus * nu / ((1 + nu) * (1 - 2 * nu))

    @property
    def stiffness(self) -> Array:
        """(6, 6), Pa, in Voigt order 11, 22, 33, 23, 13, 12 with engineering shear strains."""
        stiffness = np.zeros((6, 6))
        stiffness[:3, :3] = self.lame
        stiffness[np.arange(6), np.arange(6)] += self.shear_modulus * np.array([2, 2, 2, 1, 1, 1])
        return stiffness

    @property
    def longitudinal_speed(self) -> float:
        """Speed of bulk compressional waves, m/s."""
        return math.sqrt((self.lame + 2 * self.shear_modulus) / self.density)

    @property
    def shear_speed(self) -> float:
        """Speed of bulk shear waves, m/s."""
        return math.sqrt(self.shear_modulus / self.density)

    @property
    def rayleigh_speed(self) -> float:
        """Speed of waves along a free surface, m/s: root in (0, 1) of Rayleigh's cubic [achenbach1973]."""
        ratio = (self.shear_speed / self.longitudinal_speed) ** 2
        roots = np.roots([1.0, -8.0, 24.0 - 16.0 * ratio, -16.0 * (1.0 - ratio)])
        squares = [root.real for root in roots if abs(root.imag) < 1e-9 and 0 < root.real < 1]
        return self.shear_speed * math.sqrt(min(squares))

    def to_dict(self) -> dict[str, object]:
        """Plain values for JSON: the kind and every field."""
        return {"kind": "isotropic", **asdict(self), "uncertainty": dict(self.uncertainty)}
