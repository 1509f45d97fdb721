"""Scales of a cell, by which frequencies and wavevectors become dimensionless."""

from __future__ import annotations

from haptonic.cell.geometry import UnitCell
from haptonic.materials import IsotropicMaterial


def scales(cell: UnitCell) -> dict[str, float]:
    """Attributes of a dataset: the pitch (m), and for an isotropic plate the speed of shear waves (m/s)."""
    solid = cell.material
    speed = {"shear_speed_m_per_s": solid.shear_speed} if isinstance(solid, IsotropicMaterial) else {}
    return {"pitch_m": cell.lattice.pitch, **speed}
