"""Character of modes: shares of their energies, and a name."""

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
    "longitudinal",
    "plate flexural",
    "plate in-plane",
    "rigid body",
    "section deformation",
)
BENDING, TORSION, LONGITUDINAL, FLEXURAL, IN_PLANE, RIGID, DEFORMATION = 0, 4, 5, 6, 7, 8, 9
PILLAR_LEADS = 0.5  # share of the kinetic energy above which a mode is a pillar mode
# Share of the kinetic energy of pillars in the rigid motion of their sections below which these deform. For a
# hollow pillar that becomes oval it was 0 to 0.01, for stout pillars that bend 0.45 and more.
LEAST_RIGID = 0.2
# Largest ratio of the mean square velocities of pillar and plate at which the pillar moves with the plate: 1
# for a travelling wave, 2 at the antinode of a standing one.
CARRIED = 2.0


@dataclass(frozen=True)
class Character:
    """Measures of k modes, (k,) each, between 0 and 1, and the number of the name in `NAMES`.

    vertical : share of motion along z in the kinetic energy
    pillar_strain, pillar_kinetic : shares of the strain and kinetic energy in the pillar
    name : position in `NAMES`
    """

    vertical: Array
    pillar_strain: Array
    pillar_kinetic: Array
    name: NDArray[np.int64]


def characters(tiling: Tiling, fields: Complex, values: Array) -> Character:
    """Compute the character of modes of unit mass, given as (t + m, k) unknowns of a tiling.

    A mode whose kinetic energy is mostly in the pillars is named after the rigid motion of their sections
    with the largest energy: bending (numbered by the nodes of the axis of the pillar with the largest
    energy), axial motion, torsion. If this motion has little of the energy, as in a tube that becomes oval,
    it is named after the deformation of the sections. Other modes are named after the motion of the plate,
    out of its plane or in it. This includes modes whose pillars move with the plate: heavy pillars can have
    most of the energy of a long wave.

    values : (k,) eigenvalues, (rad/s)^2, which are the strain energies of modes of unit mass
    """
    measures = tiling.measures
    assert measures is not None, "condense with measured=True"
    in_pillar, vertical, strain_of_pillar = (
        on_each(form, fields) if form.any() else np.zeros(len(values))
        for form in (measures.pillar_mass, measures.vertical_mass, measures.pillar_stiffness)
    )
    moving = values > 1e-7 * values.max()  # a rigid-body motion has no strain energy
    pillar_strain = np.divide(strain_of_pillar, values, out=np.zeros_like(values), where=moving)
    name = np.where(vertical > 0.5, FLEXURAL, IN_PLANE)
    if measures.sections:
        motions = np.array([pillar.energies(fields) for pillar in measures.sections])
        total = motions.sum(axis=0)
        kind = np.argmax(total, axis=0)
        nodes = np.array([pillar.bending_nodes(fields) for pillar in measures.sections])
        most = motions.sum(axis=1).argmax(axis=0)
        bending = BENDING + np.minimum(nodes[most, np.arange(len(most))], 3)
        of_pillar = np.choose(kind, [bending, np.full_like(kind, LONGITUDINAL), np.full_like(kind, TORSION)])
        is_deformed = total.sum(axis=0) < LEAST_RIGID * in_pillar
        of_pillar = np.where(is_deformed, DEFORMATION, of_pillar)
        rising = sum(pillar.rising(fields) for pillar in measures.sections)
        unstretched = (of_pillar == LONGITUDINAL) & (rising > 0.5 * total[1])
        carried = _carried(tiling, fields, in_pillar, unstretched)
        name = np.where((in_pillar > PILLAR_LEADS) & ~carried, of_pillar, name)
    return Character(vertical, pillar_strain, in_pillar, np.where(moving, name, RIGID))


def _carried(tiling: Tiling, fields: Complex, in_pillar: Array, unstretched: Bools) -> Bools:
    """(k,) True if the pillars move like the plate below them, with little motion relative to their feet.

    unstretched : (k,) True if vertical motion equal to that of the feet dominates; tall pillars also tilt, so
        they move relative to their feet although they follow the plate
    """
    assert tiling.measures is not None
    sections, cell = tiling.measures.sections, tiling.cell
    plate = cell.material.density * cell.lattice.area * cell.thickness
    of_plate = 1.0 - in_pillar
    as_fast = in_pillar / sum(pillar.mass.sum() for pillar in sections) < CARRIED * of_plate / plate
    still = sum(pillar.against_foot(fields) for pillar in sections) < of_plate
    return np.asarray(as_fast & (unstretched | still))
