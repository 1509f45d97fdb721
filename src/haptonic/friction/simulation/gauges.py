"""A six-axis sensor before its calibration: six gauge voltages as a 16-bit converter gives them.

Three beams at 120 degrees carry the plate. Each has a gauge for the load along the axis and one for the load
across the beam, as in small sensors of this kind; gains are uneven and there is some cross-talk.
"""

from __future__ import annotations

import numpy as np

from haptonic.arrays import Array

GAUGES = ("G0", "G1", "G2", "G3", "G4", "G5")
BEAM_RADIUS = 0.007  # m
GAIN = 0.8  # V for each N on a beam: a full scale of about 17 N and 0.12 N m
UNEVEN, CROSS_TALK = 0.05, 0.02
RANGE, BITS = 10.0, 16  # V either way


def calibration() -> Array:
    """(6, 6) constant matrix from the voltages of `GAUGES` (V) to Fx Fy Fz (N), Tx Ty Tz (N m)."""
    angle = 2 * np.pi / 3 * np.arange(3)
    axial = np.array([np.zeros(3), np.zeros(3), np.ones(3), BEAM_RADIUS * np.sin(angle),
                      -BEAM_RADIUS * np.cos(angle), np.zeros(3)])  # fmt: skip
    across = np.array([-np.sin(angle), np.cos(angle), *np.zeros((3, 3)), BEAM_RADIUS * np.ones(3)])
    loads = np.linalg.inv(np.hstack([axial, across]))  # forces on the beams from the six axes
    rng = np.random.default_rng(17)
    mixing = np.diag(1 + UNEVEN * rng.standard_normal(6)) + CROSS_TALK * rng.standard_normal((6, 6))
    return np.asarray(np.linalg.inv(GAIN * mixing @ loads))


def voltages(axes: Array, matrix: Array) -> Array:
    """(6, samples) gauge voltages, V, that the calibration turns into these forces and torques.

    The voltages are rounded to steps of the converter and clipped at the end of its range.
    """
    step = 2 * RANGE / 2**BITS
    steps = np.rint(np.linalg.solve(matrix, axes) / step)
    return np.asarray(step * np.clip(steps, -(2 ** (BITS - 1)), 2 ** (BITS - 1) - 1))
