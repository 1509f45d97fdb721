"""What kind of motion a field is: shares of its energies, and how the pillar's sections move."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from haptonic.arrays import Array
from haptonic.superelement.folded import FoldedMesh
from haptonic.superelement.interior import CraigBampton
from haptonic.superelement.sections import PillarSections, momentum_forms

ENERGIES = ("pillar_stiffness", "pillar_mass", "vertical_mass")


@dataclass(frozen=True)
class Measures:
    """Quadratic forms (t + m, t + m) and linear ones that say what kind of motion a field is.

    pillar_stiffness, pillar_mass : the pillars' shares; vertical_mass : the share of motion along z
    sections : how each pillar moves
    """

    pillar_stiffness: Array
    pillar_mass: Array
    vertical_mass: Array
    sections: tuple[PillarSections, ...]


@dataclass(frozen=True)
class ClassMeasures:
    """The same of one symmetry class, on its share of the boundary and its modes.

    energies : (b + m, b + m) by name; momenta : (4 sections, b + m)
    """

    energies: dict[str, Array]
    momenta: Array

    @classmethod
    def of(cls, shared: FoldedMesh, q: int, own: CraigBampton, on_ends: Array | None = None) -> ClassMeasures:
        """Measures of a reduced class; ``on_ends`` as for `FoldedMesh.symmetry_class`."""
        inner, count = own.static.shape
        on_rim = shared.rim_motion(q)
        rim, lateral = on_rim.shape
        # of all representatives; what the sides do is no motion of a pillar, and counted apart
        fields = np.zeros((3 * len(shared.folding.origin), count + own.modes.shape[1]))
        fields[:inner, :count], fields[:inner, count:] = own.static, own.modes
        if on_ends is not None:
            fields[inner + rim :, lateral:count] = on_ends
        stiff = shared.pillar_stiffness(q)
        # no force acts inside a pillar that follows its ends: of its rows those on the plate and on the ends
        # do work then
        loaded = np.diff(stiff.indptr) > 0
        loaded[:inner] &= np.repeat(shared.folding.origin < shared.mesh.topology.first_above, 3)[:inner]
        held = fields[loaded, :count].T @ (stiff[np.flatnonzero(loaded)] @ fields[:, :count])
        moved = (stiff @ fields[:, count:]).T @ fields
        strain = np.block([[held, moved[:, :count].T], [moved]])
        mass = np.repeat(shared.representative_mass, 3)
        pillar_mass, vertical_mass = (_gram(fields[kept], mass[kept]) for kept in (shared.above, np.s_[2::3]))
        vertical_mass[:lateral, :lateral] += _gram(on_rim[2::3], mass[inner : inner + rim : 3])
        energies = dict(zip(ENERGIES, (strain, pillar_mass, vertical_mass), strict=True))
        return cls(energies, momentum_forms(shared.mesh, shared.folding, q, shared.nodal_mass) @ fields)

    def on(self, fields: Array) -> ClassMeasures:
        """The same on other unknowns, from which these follow as ``fields`` (b + m, k)."""
        energies = {name: fields.T @ form @ fields for name, form in self.energies.items()}
        return ClassMeasures(energies, self.momenta @ fields)

    @classmethod
    def together(cls, pieces: Sequence[ClassMeasures]) -> ClassMeasures:
        """Of several pieces of a pillar, from below, on the same unknowns."""
        energies = {name: np.sum([one.energies[name] for one in pieces], axis=0) for name in ENERGIES}
        momenta = [one.momenta.reshape(4, -1, one.momenta.shape[1]) for one in pieces]
        whole = np.concatenate(momenta, axis=1)
        return cls(energies, whole.reshape(-1, whole.shape[2]))


def _gram(fields: Array, mass: Array) -> Array:
    """(k, k) products of fields (n, k) of diagonal mass (n,)."""
    scaled = np.sqrt(mass)[:, None] * fields
    return np.asarray(scaled.T @ scaled)
