"""What is not known of a mounted plate, by the names that the study file has for it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace

from haptonic.materials import IsotropicMaterial, Material
from haptonic.plate import Plate, Support

YOUNG, LOSS, CLAMP, EDGES = (
    "material.youngs_modulus", "plate.loss_factor", "plate.clamp.spring", "plate.edges.spring",
)  # fmt: skip
BOND = re.compile(r"plate\.actuator\[(\d+)\]\.bond\.thickness")  # actuators count from 1
UNITS = {YOUNG: "Pa", LOSS: "", CLAMP: "N/m^3", EDGES: "N/m^3"}


def unit_of(name: str) -> str | None:
    """SI unit of a number that can be fitted; None if it cannot."""
    return "m" if BOND.fullmatch(name) else UNITS.get(name)


def values_of(plate: Plate) -> dict[str, float]:
    """All numbers of a plate that can be fitted, SI."""
    found = {}
    of_one = all(len(cell.materials) == 1 for cell in plate.layout.cells.values())
    # stiffness of the whole plate is in proportion to the modulus of a single material only
    if of_one and isinstance(plate.layout.material, IsotropicMaterial):
        found[YOUNG] = plate.layout.material.youngs_modulus
    if plate.loss_factor:
        found[LOSS] = plate.loss_factor
    for support in plate.supports:
        if support.stiffness is not None:
            found[_spring(support)] = support.stiffness
    for number, actuator in enumerate(plate.actuators, start=1):
        if actuator.bond is not None:
            found[f"plate.actuator[{number}].bond.thickness"] = actuator.bond.thickness
    return found


def changed(plate: Plate, values: Mapping[str, float]) -> Plate:
    """The plate with some of these numbers changed, SI."""
    unknown = values.keys() - values_of(plate).keys()
    assert not unknown, f"this plate does not have {unknown}"
    layout, actuators = plate.layout, list(plate.actuators)
    if YOUNG in values:
        cells = {n: replace(c, material=_stiffer(c.material, values)) for n, c in layout.cells.items()}
        layout = replace(layout, material=_stiffer(layout.material, values), cells=cells)
    supports = tuple(
        replace(one, stiffness=values.get(_spring(one), one.stiffness)) if one.stiffness is not None else one
        for one in plate.supports
    )
    for name, value in values.items():
        if match := BOND.fullmatch(name):
            number = int(match[1]) - 1
            bond = actuators[number].bond
            assert bond is not None
            actuators[number] = replace(actuators[number], bond=replace(bond, thickness=value))
    loss = values.get(LOSS, plate.loss_factor)
    return replace(plate, layout=layout, supports=supports, actuators=tuple(actuators), loss_factor=loss)


def bonds_of(plate: Plate, bounds: Mapping[str, tuple[float, float]]) -> dict[str, tuple[float, float]]:
    """Least and largest thickness, m, of the bonds among what is fitted, by actuator."""
    found = {}
    for name, ends in bounds.items():
        if match := BOND.fullmatch(name):
            found[plate.actuators[int(match[1]) - 1].name] = ends
    return found


def _stiffer(material: Material, values: Mapping[str, float]) -> IsotropicMaterial:
    assert isinstance(material, IsotropicMaterial)
    return replace(material, youngs_modulus=values[YOUNG])


def _spring(support: Support) -> str:
    return CLAMP if support.where == "corners" else EDGES
