"""Exact dynamic stiffness of rods: a laminate to try the algebra of slabs and waves on, without a mesh."""

import json
from pathlib import Path

import numpy as np

from haptonic.bloch.evanescent import FaceStiffness, Waves, directed

LAMINATE = json.loads((Path(__file__).parents[1] / "data" / "bragg_laminate.json").read_text("utf-8"))
MEDIA = LAMINATE["inputs"]
SPEED = {"longitudinal": "cL", "transverse": "cT"}


def medium(name: str, polarisation: str) -> tuple[float, float, float]:
    """Impedance (kg/m^2 s), speed (m/s) and thickness (m) of a layer."""
    data = MEDIA[name]
    speed = data[SPEED[polarisation]]
    return data["rho"] * speed, speed, data["thickness_mm"] * 1e-3


def rod(impedance: float, speed: float, length: float, omega: float, loss_factor: float = 0.0):
    """Dynamic stiffness of a rod per area."""
    root = np.sqrt(1 + 1j * loss_factor)
    phase = omega * length / (speed * root)
    stiffness = omega * impedance * root / np.sin(phase)
    return FaceStiffness.of(stiffness * np.array([[np.cos(phase), -1.0], [-1.0, np.cos(phase)]]))


def laminate(polarisation: str, omega: float, loss_factor: float = 0.0) -> FaceStiffness:
    """A period: one layer of aluminium, then one of epoxy."""
    first, second = (rod(*medium(name, polarisation), omega, loss_factor) for name in MEDIA)
    return first.followed_by(second)


def half_space(impedance: float, speed: float, omega: float) -> tuple[Waves, Waves]:
    """Waves to the right and to the left in a half-space, on a plane."""
    u = np.ones((1, 2), dtype=complex)
    exponent = 1j * omega / speed * np.array([-1e-3, 1e-3])
    return directed(exponent, u, 1j * omega * impedance * u * [1, -1], omega)
