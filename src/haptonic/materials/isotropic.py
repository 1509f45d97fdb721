"""Isotropic solids and their wave speeds."""

from __future__ import annotations

import math
from dataclasses import asdict
from typing import Annotated, ClassVar

import numpy as np
from pydantic import field_validator

from haptonic.arrays import Array
from haptonic.fields import Aliases, Entries, Quantity, absent, described, meant, needed, setting
from haptonic.fields.quantity import collected
from haptonic.materials.common import (
    DENSITY,
    LossFactor,
    MaterialName,
    Note,
    Source,
    half_widths,
    require_name,
)

INCOMPRESSIBLE = (
    "a solid with a Poisson ratio of 0.5 is incompressible and has no finite bulk modulus; write 0.49 for "
    "nearly incompressible solids, such as rubber"
)
PROPERTIES = {"youngs_modulus": "Pa", "poisson_ratio": "", "density": "kg/m^3", "loss_factor": ""}


@described("material")
class IsotropicMaterial:
    """A solid with equal properties in every direction.

    Raises
    ------
    StudyError : a property outside its limits
    """

    aliases: ClassVar[Aliases] = {
        **meant("youngs_modulus", "e", "young", "youngs", "young_modulus", "elastic_modulus", "modulus"),
        **meant("poisson_ratio", "nu", "poisson", "poissons_ratio", "v"),
        **meant("density", "rho", "mass_density"),
        **meant("loss_factor", "eta", "loss", "tan_delta", "structural_loss"),
        **meant(
            "loss_factor", "damping", "damping_ratio", "zeta",
            cause="damping is given by the loss factor, which is twice a damping ratio",
            next_step='write "loss_factor"',
        ),
        **meant(
            "loss_factor", "q", "quality_factor", cause="damping is given by the loss factor, 1 / Q",
            next_step='write "loss_factor"',
        ),
        **absent(
            "g", "shear_modulus", "lambda", "mu", "lame", "bulk_modulus", "k",
            cause="an isotropic material is given by Young's modulus and Poisson's ratio",
            next_step="write youngs_modulus and poisson_ratio; E = 2 G (1 + nu)",
        ),
        **absent(
            "speed", "c", "velocity", cause="speeds of waves follow from the constants",
            next_step="write youngs_modulus, poisson_ratio and density",
        ),
    }  # fmt: skip

    youngs_modulus: Annotated[
        float,
        Quantity(
            "Pa", at_least=1e3, at_most=1e13, typical=(1e9, 5e11), exception="0.1 to 100 MPa for rubber"
        ),
    ] = needed("Stiffness in tension.", title="Young's modulus")
    poisson_ratio: Annotated[
        float, Quantity("", above=-1.0, below=0.5, typical=(0.1, 0.5), hint=INCOMPRESSIBLE)
    ] = needed("Sideways contraction over stretch.", examples=["0.34"])
    density: Annotated[float, DENSITY] = needed("Mass per volume.")
    loss_factor: LossFactor = 0.0
    name: MaterialName = "material"
    source: Source = ""
    uncertainty: Entries[float] = setting(Entries(), "Half-widths of the plausible intervals, by property.")
    note: Note = ""

    def __post_init__(self) -> None:
        with collected(within="material"):
            require_name(self.name)

    _half_widths = field_validator("uncertainty", mode="before")(half_widths(PROPERTIES))

    @property
    def units(self) -> dict[str, str]:
        """SI unit of every property that may have an uncertainty."""
        return PROPERTIES

    @property
    def shear_modulus(self) -> float:
        """Shear modulus, Pa."""
        return self.youngs_modulus / (2 * (1 + self.poisson_ratio))

    @property
    def lame(self) -> float:
        """First Lamé constant, Pa."""
        nu = self.poisson_ratio
        return self.youngs_modulus * nu / ((1 + nu) * (1 - 2 * nu))

    @property
    def stiffness(self) -> Array:
        """(6, 6) stiffness, Pa, in Voigt order 11, 22, 33, 23, 13, 12 with engineering shear strains."""
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
