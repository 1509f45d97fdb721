"""What kind of motion a field is: shares of its energies, and how the pillar's sections move."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from haptonic.arrays import Array
from haptonic.superelement.folded import FoldedCell, FoldedMesh
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
    def of(
        cls, shared: FoldedMesh, q: int, folded: FoldedCell, own: CraigBampton, on_ends: Array | None = None
    ) -> ClassMeasures:
        """Measures of a reduced class; ``on_ends`` as for `FoldedMesh.symmetry_class`."""
        trace, body = folded.trace, folded.body
        fields = np.hstack([own.static, own.modes])
        lateral, rim = len(trace.kept), trace.rim_size
        pillar = shared.pillar_stiffness(q)
        stiff = pillar.matrix().tocsr()
        rows = np.flatnonzero(np.diff(stiff.indptr))  # most of a cell is no pillar
        strain = fields[rows].T @ (stiff[rows][:, rows] @ fields[rows])
        whole, mass, in_pillar = fields, body.mass, shared.above
        if on_ends is not None:  # its values follow from the boundary's unknowns behind the trace
            top = np.zeros((len(on_ends), fields.shape[1]))
            top[:, lateral : own.static.shape[1]] = on_ends
            crossed = fields.T @ (pillar.coupling()[:, 3 * rim :] @ top)
            strain += crossed + crossed.T + top.T @ (pillar.boundary()[3 * rim :, 3 * rim :] @ top)
            whole = np.concatenate([fields, top])
            above = shared.representative_mass[shared.folding.interior + rim :]
            mass = np.concatenate([mass, np.repeat(above, 3)])
            in_pillar = np.concatenate([in_pillar, np.ones(len(top))])
        pillar_mass, vertical_mass = (
            _gram(whole[kept], mass[kept]) for kept in (np.flatnonzero(in_pillar), np.s_[2::3])
        )
        vertical_mass[:lateral, :lateral] += body.outer_mass[:lateral, :lateral] * trace.is_vertical
        momenta = momentum_forms(shared.mesh, shared.folding, q, shared.nodal_mass)
        seen = np.r_[: len(fields), len(fields) + 3 * rim : momenta.shape[1]][: len(whole)]
        energies = dict(zip(ENERGIES, (strain, pillar_mass, vertical_mass), strict=True))
        return cls(energies, np.asarray(momenta[:, seen] @ whole))

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
