"""Update of a plate model to other parameters (material, losses, springs, bonds) without new tiles."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from haptonic.arrays import Array, Fields
from haptonic.later import linalg as la
from haptonic.plate.body.bonds import Bond3
from haptonic.plate.body.foundations import Foundation, foundation_stiffness, total_stiffness
from haptonic.plate.body.model import PlateModel, drives_on
from haptonic.plate.body.tile import Tile, Turned
from haptonic.plate.layout.keys import PLATE, bond
from haptonic.plate.layout.parts import Plate


@dataclass(frozen=True, eq=False)
class UpdatedModel:
    """Model with updated parameters.

    turns : for each group of the assembly, new modes of its tile in terms of the old ones
    """

    model: PlateModel
    turns: tuple[Array, ...]

    def back(self, vectors: Fields) -> Fields:
        """Transform vectors (size, k) of this model to the unknowns of the original model."""
        original = vectors.copy()
        for group, turn in zip(self.model.assembly.groups, self.turns, strict=True):
            modes = group.unknowns[:, group.tile.trace_size :]
            original[modes] = np.einsum("ij,bjk->bik", turn, vectors[modes])
        return original


def updated(model: PlateModel, plate: Plate) -> UpdatedModel:
    """Update a model to a plate that differs in parameters only.

    Parameters
    ----------
    plate : as that of the model, but for factors of the stiffness of plate and pillars, loss factors,
        stiffness of springs, and thickness of those bonds for which the model was made
    """
    scale, thickness = stiffness_ratio(model.plate, plate), bond_thickness(plate)
    groups, turns = [], []
    for group in model.assembly.groups:
        tile, turn = _updated(group.tile, scale, thickness)
        groups.append(replace(group, tile=tile))
        turns.append(turn)
    foundations = tuple(
        Foundation(support_ratio(model.plate, plate, foundation.number) * foundation.stiffness,
            plate.supports[foundation.number].loss_factor, foundation.number)
        for foundation in model.foundations
    )  # fmt: skip
    total = total_stiffness(foundations, model.assembly.free)
    assembly = replace(model.assembly, groups=tuple(groups), foundations=total)
    new_model = replace(
        model, plate=plate, assembly=assembly, foundations=foundations, drives=drives_on(assembly)
    )
    return UpdatedModel(new_model, tuple(turns))


def stiffness_ratio(old: Plate, new: Plate) -> float:
    """Ratio of the stiffness of the material of plate and pillars."""
    return float(new.layout.material.stiffness[0, 0] / old.layout.material.stiffness[0, 0])


def support_ratio(old: Plate, new: Plate, number: int) -> float:
    """Ratio of the stiffness of the springs of a support."""
    first, second = (foundation_stiffness(plate.layout, plate.supports[number]) for plate in (old, new))
    return second / first


def bond_thickness(plate: Plate) -> dict[str, float]:
    """Thickness of the bond by actuator, m."""
    return {part.name: part.bond.thickness for part in plate.actuators if part.bond is not None}


def _updated(tile: Tile, scale: float, thickness: dict[str, float]) -> tuple[Tile, Array]:
    stiffness = {part: scale * form if part == PLATE else form for part, form in tile.stiffness.items()}
    modes = len(tile.values)
    if list(stiffness) == [PLATE]:
        return replace(tile, stiffness=stiffness, values=scale * tile.values), np.eye(modes)
    mass, bonds = tile.mass, dict(tile.bonds)
    for name, glue in tile.bonds.items():
        stiffness[bond(name)] = np.tensordot(glue.shares(thickness[name]), glue.stiffness, 1)
        mass = mass + (thickness[name] - glue.nominal) * glue.slope
    inner = slice(tile.trace_size, None)
    values, turn = la.eigh(sum(part[inner, inner] for part in stiffness.values()), mass[inner, inner])
    whole = la.block_diag(np.eye(tile.trace_size), turn)
    for name, glue in tile.bonds.items():
        forms = whole.T @ glue.stiffness @ whole
        bonds[name] = Bond3(glue.thickness, forms, thickness[name], whole.T @ glue.slope @ whole)
    new_tile = replace(
        tile,
        stiffness={part: whole.T @ form @ whole for part, form in stiffness.items()},
        mass=whole.T @ mass @ whole,
        values=values,
        drive={name: whole.T @ drive for name, drive in tile.drive.items()},
        inside=Turned(tile.inside, whole),
        bonds=bonds,
    )
    return new_tile, turn
