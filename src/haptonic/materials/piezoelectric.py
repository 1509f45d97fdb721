"""Poled piezoelectric ceramics, T = c^E S - e^T E and D = e S + eps^S E [ieee176]."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from typing import Annotated, Any, ClassVar

import numpy as np
from pydantic import Field, field_validator

from haptonic.arrays import Array
from haptonic.fields import Aliases, Entries, Quantity, absent, described, meant, needed, problem, setting
from haptonic.fields.quantity import collected
from haptonic.materials.common import (
    DENSITY,
    VOIGT,
    LossFactor,
    MaterialName,
    Note,
    Source,
    half_widths,
    require_name,
    require_positive_definite,
)
from haptonic.names import listed

VACUUM = 8.8541878128e-12  # F/m, permittivity of vacuum
PROPERTIES = {"density": "kg/m^3", "loss_factor": "", "dielectric_loss": ""}
FORMS = (
    ("s11", "s12", "s13", "s33", "s44", "d31", "d33", "d15"),
    ("c11", "c12", "c13", "c33", "c44", "e31", "e33", "e15"),
)
"""Constants that give strain and charge by stress and field, or stress and charge by strain and field."""

Stiffness = Annotated[float, Quantity("Pa", at_least=-1e13, at_most=1e13, typical=(1e9, 5e11))] | None
Compliance = Annotated[float, Quantity("m^2/N", at_least=-1e-3, at_most=1e-3, typical=(-5e-11, 2e-10))] | None
Charge = Annotated[float, Quantity("m/V", at_least=-1e-7, at_most=1e-7, typical=(-1e-9, 2e-9))] | None
Coupling = Annotated[float, Quantity("C/m^2", at_least=-1e3, at_most=1e3, typical=(-50.0, 50.0))] | None
Relative = Annotated[float, Quantity("", at_least=1.0, at_most=1e5, typical=(5.0, 1e4))]


def _of_form(help: str, title: str, example: str) -> Any:
    """A constant of one form only."""
    return setting(None, help, title=title, examples=[example])


@described("material", kw_only=True)
class PiezoelectricMaterial:
    """A ceramic poled along axis 3, the plate's normal, and isotropic around it.

    Its constants are those of one of the two `FORMS`.

    Raises
    ------
    StudyError : a property outside its limits, constants of both forms or of none, or of an unstable solid
    """

    aliases: ClassVar[Aliases] = {
        **meant("permittivity_33", "eps33", "eps33_t", "eps33_s", "epsilon33", "er", "eps_r"),
        **meant("permittivity_11", "eps11", "eps11_t", "eps11_s", "epsilon11"),
        **absent("k31", "k33", "k15", "kp", "kt", cause="coupling factors follow from the other constants",
                 next_step="leave it out"),
        **absent("s66", "c66", cause="it follows from the constants 11 and 12", next_step="leave it out"),
        **absent(
            "turn", "angle", "rotation", cause="a poled ceramic is isotropic around the plate's normal",
            next_step="leave it out",
        ),
        **meant("dielectric_loss", "tan_delta", "tand", "loss_tangent"),
        **absent(
            "youngs_modulus", "poisson_ratio", "e", "nu",
            cause="a poled ceramic is not isotropic",
            next_step="write its compliances s11, s12, s13, s33 and s44",
        ),
    }  # fmt: skip

    s11: Compliance = _of_form("Strain along 1 over stress along 1.", "Compliance 11", "12.3 um^2/N")
    s12: Compliance = _of_form("Strain along 2 over stress along 1.", "Compliance 12", "-4.05 um^2/N")
    s13: Compliance = _of_form("Strain along 3 over stress along 1.", "Compliance 13", "-5.31 um^2/N")
    s33: Compliance = _of_form("Strain along 3 over stress along 3.", "Compliance 33", "15.5 um^2/N")
    s44: Compliance = _of_form("Shear strain between 2 and 3 over stress.", "Compliance 44", "39 um^2/N")
    d31: Charge = _of_form("Strain along 1 over the field.", "Charge constant 31", "-123 pm/V")
    d33: Charge = _of_form("Strain along 3 over the field.", "Charge constant 33", "289 pm/V")
    d15: Charge = _of_form("Shear strain over a field along 1.", "Charge constant 15", "496 pm/V")
    c11: Stiffness = _of_form("Stress along 1 over strain along 1.", "Stiffness 11", "139 GPa")
    c12: Stiffness = _of_form("Stress along 1 over strain along 2.", "Stiffness 12", "77.8 GPa")
    c13: Stiffness = _of_form("Stress along 1 over strain along 3.", "Stiffness 13", "74.3 GPa")
    c33: Stiffness = _of_form("Stress along 3 over strain along 3.", "Stiffness 33", "115 GPa")
    c44: Stiffness = _of_form("Shear stiffness between 2 and 3.", "Stiffness 44", "25.6 GPa")
    e31: Coupling = _of_form("Stress along 1 over the field, with its sign.", "Coupling 31", "-5.2 C/m^2")
    e33: Coupling = _of_form("Stress along 3 over the field, with its sign.", "Coupling 33", "15.1 C/m^2")
    e15: Coupling = _of_form("Shear stress over a field along 1.", "Coupling 15", "12.7 C/m^2")
    permittivity_11: Relative = needed(
        "Relative to vacuum; at constant stress beside d15, at constant strain beside e15.",
        examples=["1475"],
    )  # fmt: skip
    permittivity_33: Relative = needed(
        "Relative to vacuum; at constant stress beside d33, at constant strain beside e33.",
        examples=["1300"],
    )  # fmt: skip
    density: Annotated[float, DENSITY] = needed("Mass per volume.")
    loss_factor: LossFactor = 0.0
    dielectric_loss: Annotated[
        float,
        Quantity("", at_least=0.0, below=1.0, typical=(0.0, 0.1)),
        Field(description="Loss tangent of the given permittivities; makers print that of a free element."),
    ] = 0.0
    name: MaterialName = "material"
    source: Source = ""
    uncertainty: Entries[float] = setting(Entries(), "Half-widths of the plausible intervals, by property.")
    note: Note = ""

    def __post_init__(self) -> None:
        given = {name for form in FORMS for name in form if getattr(self, name) is not None}
        if given not in map(set, FORMS):
            nearest = max(FORMS, key=lambda form: len(given & set(form)))
            missing, others = set(nearest) - given, given - set(nearest)
            raise problem(
                "missing" if missing else "conflict",
                listed(sorted(given)) or "no constants",
                " or ".join(", ".join(form) for form in FORMS),
                "a constant was left out" if missing else "constants of both forms were given",
                f"add {listed(sorted(missing))}" if missing else f"leave out {listed(sorted(others))}",
                at=min(missing or others),
            )
        with collected(within="material"):
            require_name(self.name)
            if not self.is_stiffness_form:
                require_positive_definite("compliance", self._matrix("s"), "s11")
            require_positive_definite("stiffness", self.stiffness, "c11")
            require_positive_definite(
                "permittivity",
                self.permittivity,
                "permittivity_33",
                "the charge constants are too large for these compliances and permittivities",
                "check signs (d31 is negative) and powers of ten; permittivities are at constant stress",
            )

    _half_widths = field_validator("uncertainty", mode="before")(half_widths(PROPERTIES))

    @property
    def units(self) -> Mapping[str, str]:
        """SI unit of every property that may have an uncertainty."""
        return PROPERTIES

    @property
    def is_stiffness_form(self) -> bool:
        """True if stiffnesses and couplings are given, False for compliances and charge constants."""
        return self.c11 is not None

    def _matrix(self, letter: str) -> Array:
        """(6, 6) stiffness or compliance, from the constants that begin with this letter."""
        across, along, third, normal, shear = (
            getattr(self, letter + n) for n in ("11", "12", "13", "33", "44")
        )
        twist = (across - along) / 2 if letter == "c" else 2 * (across - along)  # isotropic around axis 3
        matrix = np.diag(np.array([across, across, normal, shear, shear, twist], dtype=float))
        matrix[0, 1] = matrix[1, 0] = along
        matrix[:2, 2] = matrix[2, :2] = third
        return matrix

    def _coupled(self, letter: str) -> Array:
        """(3, 6) couplings or charge constants, from the constants that begin with this letter."""
        across, along, shear = (getattr(self, letter + number) for number in ("31", "33", "15"))
        return np.array([[0, 0, 0, 0, shear, 0], [0, 0, 0, shear, 0, 0], [across, across, along, 0, 0, 0]])

    @property
    def stiffness(self) -> Array:
        """c^E, (6, 6), Pa, in Voigt order 11, 22, 33, 23, 13, 12 with engineering shear strains."""
        return self._matrix("c") if self.is_stiffness_form else np.asarray(np.linalg.inv(self._matrix("s")))

    @property
    def coupling(self) -> Array:
        """e, (3, 6), C/m^2: field direction, then strain."""
        return self._coupled("e") if self.is_stiffness_form else self._coupled("d") @ self.stiffness

    @property
    def permittivity(self) -> Array:
        """eps^S, (3, 3), at constant strain, F/m."""
        given = VACUUM * np.diag([self.permittivity_11, self.permittivity_11, self.permittivity_33])
        return given if self.is_stiffness_form else given - self._coupled("d") @ self.coupling.T

    @property
    def clamped_loss(self) -> float:
        """Loss tangent of the permittivity at constant strain, along the axis.

        A free element also loses mechanical energy: eps_T tan = eps_S tan_S + (eps_T - eps_S) loss_factor.
        """
        free, clamped = VACUUM * self.permittivity_33, float(self.permittivity[2, 2])
        total = free * self.dielectric_loss - (free - clamped) * self.loss_factor
        return self.dielectric_loss if self.is_stiffness_form else max(0.0, total / clamped)

    @property
    def coupling_tensor(self) -> Array:
        """(3, 3, 3) tensor e_akl of the coupling, C/m^2: field direction, then the pair of the strain."""
        return self.coupling[:, np.array(VOIGT)]

    def to_dict(self) -> dict[str, object]:
        """Plain values for JSON: the kind and every field."""
        return {"kind": "piezoelectric", **asdict(self), "uncertainty": dict(self.uncertainty)}
