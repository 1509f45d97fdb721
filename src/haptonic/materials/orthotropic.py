"""Solids with three planes of symmetry: cubic crystals, rolled sheet, fibre composites."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from typing import Annotated, ClassVar

import numpy as np
from pydantic import field_validator

from haptonic.arrays import Array
from haptonic.fields import Aliases, Entries, Quantity, absent, described, meant, needed, problem, setting
from haptonic.fields.quantity import collected
from haptonic.materials.common import (
    DENSITY,
    LossFactor,
    MaterialName,
    Note,
    Source,
    half_widths,
    require_name,
    require_positive_definite,
    turned,
)
from haptonic.names import listed

SYMMETRIES = {
    "cubic": ("c11", "c12", "c44"),
    "transversely isotropic": ("c11", "c12", "c13", "c33", "c44"),
    "tetragonal": ("c11", "c12", "c13", "c33", "c44", "c66"),
    "orthotropic": ("c11", "c22", "c33", "c23", "c13", "c12", "c44", "c55", "c66"),
}
"""Constants that define a solid, by its symmetry; axis 3 is the special one of the second and third."""
CONSTANTS = SYMMETRIES["orthotropic"]
PROPERTIES = {**dict.fromkeys(CONSTANTS, "Pa"), "density": "kg/m^3", "loss_factor": ""}
Diagonal = Annotated[float, Quantity("Pa", at_least=1e3, at_most=1e13, typical=(1e9, 1.2e12))]
Across = Annotated[float, Quantity("Pa", at_least=-1e13, at_most=1e13, typical=(-1e11, 5e11))]


@described("material", kw_only=True)
class OrthotropicMaterial:
    """A solid with up to nine elastic constants; its axis 3 is the plate's normal.

    The given constants are those of one of the `SYMMETRIES`; the others follow from them.

    Raises
    ------
    StudyError : a property outside its limits, other constants, or those of an unstable solid
    """

    aliases: ClassVar[Aliases] = {
        **meant("c12", "c21"), **meant("c13", "c31"), **meant("c23", "c32"),
        **meant("turn", "angle", "rotation", "orientation"),
        **{word: alias for name in CONSTANTS for word, alias in meant(name, f"c_{name[1:]}").items()},
        **absent(
            *(f"{name}{axes}" for name in "eg" for axes in (1, 2, 3, "x", "y", "z")),
            *(f"{name}{axes}" for name in ("nu", "g") for axes in (12, 13, 23, "xy", "xz", "yz")),
            cause="an anisotropic material is given by its stiffnesses",
            next_step="invert its compliance matrix, and write c11, c12 and so on",
        ),
        **absent(
            *(f"s{name[1:]}" for name in CONSTANTS),
            cause="an anisotropic material is given by its stiffnesses, not by its compliances",
            next_step="invert its compliance matrix, and write c11, c12 and so on",
        ),
        **absent(
            *(f"c{row}{column}" for row in range(1, 7) for column in range(max(row + 1, 4), 7)),
            cause="a solid whose axes are those of its planes of symmetry does not have this constant",
            next_step="give its constants along its own axes, and their angle to the plate as turn",
        ),
    }  # fmt: skip

    c11: Diagonal = needed(
        "Stiffness along axis 1. A table with it describes an anisotropic material.",
        title="Stiffness 11",
        examples=["165.7 GPa"],
    )
    c12: Across = needed("Stress along axis 1 over stretch along 2.", title="Stiffness 12",
                         examples=["63.9 GPa"])  # fmt: skip
    c44: Diagonal = needed("Shear stiffness between axes 2 and 3.", title="Stiffness 44",
                           examples=["79.6 GPa"])  # fmt: skip
    c13: Across | None = setting(None, "By default c12.", title="Stiffness 13")
    c33: Diagonal | None = setting(None, "Along the normal; by default c11.", title="Stiffness 33")
    c66: Diagonal | None = setting(
        None, "In the plane; by default c44, or (c11 - c12) / 2 if c33 is given.", title="Stiffness 66"
    )
    c22: Diagonal | None = setting(None, "By default c11.", title="Stiffness 22")
    c23: Across | None = setting(None, "By default c13.", title="Stiffness 23")
    c55: Diagonal | None = setting(None, "By default c44.", title="Stiffness 55")
    density: Annotated[float, DENSITY] = needed("Mass per volume.")
    turn: Annotated[float, Quantity("rad")] = setting(
        0.0, "Angle from the x axis of the plate to axis 1 of the material.", title="Turn of the axes",
        examples=["45 deg"],
    )  # fmt: skip
    loss_factor: LossFactor = 0.0
    name: MaterialName = "material"
    source: Source = ""
    uncertainty: Entries[float] = setting(Entries(), "Half-widths of the plausible intervals, by property.")
    note: Note = ""

    def __post_init__(self) -> None:
        given = {name for name in CONSTANTS if getattr(self, name) is not None}
        if given not in map(set, SYMMETRIES.values()):
            missing = min(
                (set(names) - given for names in SYMMETRIES.values() if given < set(names)), key=len
            )
            raise problem(
                "missing",
                listed(sorted(given)),
                "; ".join(f"{', '.join(names)} ({symmetry})" for symmetry, names in SYMMETRIES.items()),
                "no symmetry has these constants alone",
                f"add {listed(sorted(missing))}",
                at=min(missing),
            )
        with collected(within="material"):
            require_name(self.name)
            require_positive_definite("stiffness", self.stiffness, "c11")

    _half_widths = field_validator("uncertainty", mode="before")(half_widths(PROPERTIES))

    @property
    def units(self) -> Mapping[str, str]:
        """SI unit of every property that may have an uncertainty."""
        return PROPERTIES

    @property
    def constants(self) -> dict[str, float]:
        """All nine stiffnesses along the axes of the material, Pa, in Voigt order."""
        c11, c12, c44 = self.c11, self.c12, self.c44
        c13 = c12 if self.c13 is None else self.c13
        isotropic_plane = c44 if self.c33 is None else (c11 - c12) / 2
        defaults = {"c22": c11, "c33": c11, "c23": c13, "c13": c12, "c55": c44, "c66": isotropic_plane}
        given = {name: getattr(self, name) for name in CONSTANTS}
        return {name: defaults[name] if value is None else value for name, value in given.items()}

    @property
    def stiffness(self) -> Array:
        """(6, 6), Pa, in Voigt order 11, 22, 33, 23, 13, 12 of the plate's axes, for engineering strains."""
        stiffness = np.zeros((6, 6))
        for name, value in self.constants.items():
            row, column = int(name[1]) - 1, int(name[2]) - 1
            stiffness[row, column] = stiffness[column, row] = value
        return turned(stiffness, self.turn)

    def to_dict(self) -> dict[str, object]:
        """Plain values for JSON: the kind and every field."""
        return {"kind": "orthotropic", **asdict(self), "uncertainty": dict(self.uncertainty)}
