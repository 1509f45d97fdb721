"""Numbers of a mounted plate that can be fitted, with their names in the study file."""

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
    values = {}
    is_of_one_material = all(len(cell.materials) == 1 for cell in plate.layout.cells.values())
    # the stiffness of a plate is proportional to the modulus only if it is of a single material
    if is_of_one_material and isinstance(plate.layout.material, IsotropicMaterial):
        values[YOUNG] = plate.layout.material.youngs_modulus
    if plate.loss_factor:
        values[LOSS] = plate.loss_factor
    for support in plate.supports:
        if support.stiffness is not None:
            values[_spring(support)] = support.stiffness
    for number, actuator in enumerate(plate.actuators, start=1):
        if actuator.bond is not None:
            values[f"plate.actuator[{number}].bond.thickness"] = actuator.bond.thickness
    return values


def changed(plate: Plate, values: Mapping[str, float]) -> Plate:
    """A copy of the plate with some of these numbers changed, SI."""
    unknown = values.keys() - values_of(plate).keys()
    assert not unknown, f"this plate does not have {unknown}"
    layout, actuators = plate.layout, list(plate.actuators)
    if YOUNG in values:
        cells = {n: replace(c, material=_stiffer(c.material, values)) for n, c in layout.cells.items()}
        layout = replace(layout, material=_stiffer(layout.material, values), cells=cells)
    supports = tuple(
        replace(support, stiffness=values.get(_spring(support), support.stiffness))
        if support.stiffness is not None
        else support
        for support in plate.supports
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
    """Smallest and largest thickness, m, of the fitted bonds, by actuator."""
    bounds_by_actuator = {}
    for name, ends in bounds.items():
        if match := BOND.fullmatch(name):
            bounds_by_actuator[plate.actuators[int(match[1]) - 1].name] = ends
    return bounds_by_actuator


def _stiffer(material: Material, values: Mapping[str, float]) -> IsotropicMaterial:
    assert isinstance(material, IsotropicMaterial)
    return replace(material, youngs_modulus=values[YOUNG])


def _spring(support: Support) -> str:
    return CLAMP if support.where == "corners" else EDGES
