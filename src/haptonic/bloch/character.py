"""What a mode is: measured on the mode itself, then named."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from haptonic.arrays import Array, Bools, Complex
from haptonic.superelement import Tiling, on_each

NAMES = (
    "pillar bending 1",
    "pillar bending 2",
    "pillar bending 3",
    "pillar bending 4+",
    "torsion",
    "traction",
    "plate flexural",
    "plate in-plane",
    "rigid body",
)
BENDING, TORSION, TRACTION, FLEXURAL, IN_PLANE, RIGID = 0, 4, 5, 6, 7, 8
PILLAR_LEADS = 0.5  # share of the kinetic energy from which a mode belongs to the pillar
# Mean square of the pillar's velocity over that of the plate, up to which the plate carries it along: 1 for a
# travelling wave, 2 on the antinode of a standing one.
CARRIED = 2.0


@dataclass(frozen=True)
class Character:
    """Measures of k modes, (k,) each, all between 0 and 1, and the name's number in `NAMES`.

    vertical : share of the kinetic energy that is motion along z
    pillar_strain, pillar_kinetic : shares of the strain and kinetic energy in the pillar
    name : position in `NAMES`
    """

    vertical: Array
    pillar_strain: Array
    pillar_kinetic: Array
    name: NDArray[np.int64]


def characters(tiling: Tiling, fields: Complex) -> Character:
    """Character of modes given as (t + m, k) unknowns of a tiling.

    A mode whose kinetic energy is mostly in the pillars is named after the rigid motion of their sections
    that carries most of it: bending (numbered by the nodes of the axis of the pillar that has most of it),
    traction, torsion. The others are named after the plate's motion, out of its plane or in it: so are those
    that carry the pillars along. Heavy pillars have most of the energy of a long wave without having a part
    in it.
    """
    measures = tiling.measures
    assert measures is not None, "condense with measured=True"
    kinetic = on_each(tiling.mass, fields)
    in_pillar = on_each(measures.pillar_mass, fields) / kinetic
    vertical = on_each(measures.vertical_mass, fields) / kinetic
    strain = on_each(tiling.stiffness, fields)
    moving = strain > 1e-7 * strain.max()  # a rigid-body motion has no strain to share
    pillar_strain = np.divide(
        on_each(measures.pillar_stiffness, fields), strain, out=np.zeros_like(strain), where=moving
    )
    name = np.where(vertical > 0.5, FLEXURAL, IN_PLANE)
    if measures.sections:
        motions = np.array([one.energies(fields) for one in measures.sections])
        total = motions.sum(axis=0)
        kind = np.argmax(total, axis=0)
        nodes = np.array([one.bending_nodes(fields) for one in measures.sections])
        most = motions.sum(axis=1).argmax(axis=0)
        bending = BENDING + np.minimum(nodes[most, np.arange(len(most))], 3)
        of_pillar = np.choose(kind, [bending, np.full_like(kind, TRACTION), np.full_like(kind, TORSION)])
        rising = sum(one.rising(fields) for one in measures.sections)
        unstretched = (of_pillar == TRACTION) & (rising > 0.5 * total[1])
        carried = _carried(tiling, fields, kinetic, in_pillar, unstretched)
        name = np.where((in_pillar > PILLAR_LEADS) & ~carried, of_pillar, name)
    return Character(vertical, pillar_strain, in_pillar, np.where(moving, name, RIGID))


def _carried(tiling: Tiling, fields: Complex, kinetic: Array, in_pillar: Array, unstretched: Bools) -> Bools:
    """(k,) whether the pillars move as the plate does below them, and little against their feet.

    unstretched : (k,) whether they mostly rise and sink with their feet; tall ones tilt as well, and move
        against their feet though the plate carries them
    """
    assert tiling.measures is not None
    sections, cell = tiling.measures.sections, tiling.cell
    plate = cell.material.density * cell.lattice.area * cell.thickness
    of_plate = (1.0 - in_pillar) * kinetic
    as_fast = in_pillar * kinetic / sum(one.mass.sum() for one in sections) < CARRIED * of_plate / plate
    still = sum(one.against_foot(fields) for one in sections) < of_plate
    return np.asarray(as_fast & (unstretched | still))
