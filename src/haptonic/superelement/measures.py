"""Forms that characterise the motion of a field: shares of energies, and motion of pillar sections."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from haptonic.arrays import Array, Bools
from haptonic.superelement.bounded import portions
from haptonic.superelement.folded import FoldedMesh
from haptonic.superelement.interior import CraigBampton
from haptonic.superelement.lifting import whole_fields
from haptonic.superelement.sections import PillarSections, momentum_forms

ENERGIES = ("pillar_stiffness", "pillar_mass", "vertical_mass")
ROWS_AT_ONCE = 10_000  # rows of fields that are copied at a time


@dataclass(frozen=True)
class Measures:
    """Quadratic forms (t + m, t + m) and linear forms that characterise the motion of a field.

    pillar_stiffness, pillar_mass : shares of the pillars; vertical_mass : share of motion along z
    sections : motion of each pillar
    """

    pillar_stiffness: Array
    pillar_mass: Array
    vertical_mass: Array
    sections: tuple[PillarSections, ...]


@dataclass(frozen=True)
class ClassMeasures:
    """Measures of one symmetry class, on its share of the boundary and its modes.

    energies : (b + m, b + m) by name; momenta : (4 sections, b + m)
    """

    energies: dict[str, Array]
    momenta: Array

    @classmethod
    def of(cls, shared: FoldedMesh, q: int, own: CraigBampton, on_ends: Array | None = None) -> ClassMeasures:
        """Compute the measures of a reduced class; ``on_ends`` as for `FoldedMesh.symmetry_class`."""
        inner, count = own.static.shape
        fields = whole_fields(shared.traces[q], shared.through, own.static, own.modes, on_ends)
        stiff = shared.pillar_stiffness(q)
        # No force acts inside a pillar that responds statically to its ends. Only the rows on the plate and
        # on the ends do work then.
        loaded = np.diff(stiff.indptr) > 0
        loaded[:inner] &= np.repeat(shared.folding.origin < shared.mesh.topology.pillar_start[0], 3)[:inner]
        forces, on_plate = stiff[np.flatnonzero(loaded)], fields[loaded, :count].T
        of_static = np.hstack([on_plate @ (forces @ fields[:, few]) for few in portions(count)])
        moved = (stiff @ fields[:, count:]).T @ fields
        strain = np.block([[of_static, moved[:, :count].T], [moved]])
        mass = np.repeat(shared.representative_mass, 3)
        vertical = np.arange(len(mass)) % 3 == 2
        pillar_mass, vertical_mass = (_gram(fields, mass, rows) for rows in (shared.above, vertical))
        energies = dict(zip(ENERGIES, (strain, pillar_mass, vertical_mass), strict=True))
        return cls(energies, momentum_forms(shared.mesh, shared.folding, q, shared.nodal_mass) @ fields)

    def on(self, fields: Array) -> ClassMeasures:
        """Return the measures on other unknowns; ``fields`` (b + m, k) maps them to the present ones."""
        energies = {name: fields.T @ form @ fields for name, form in self.energies.items()}
        return ClassMeasures(energies, self.momenta @ fields)

    @classmethod
    def together(cls, pieces: Sequence[ClassMeasures]) -> ClassMeasures:
        """Sum the measures of several pieces of a pillar, from below, on the same unknowns."""
        energies = {name: np.sum([piece.energies[name] for piece in pieces], axis=0) for name in ENERGIES}
        momenta = [piece.momenta.reshape(4, -1, piece.momenta.shape[1]) for piece in pieces]
        whole = np.concatenate(momenta, axis=1)
        return cls(energies, whole.reshape(-1, whole.shape[2]))


def _gram(fields: Array, mass: Array, chosen: Bools) -> Array:
    """(k, k) products of the chosen rows of fields (n, k) of diagonal mass (n,)."""
    rows = np.flatnonzero(chosen)
    form = np.zeros((fields.shape[1],) * 2)
    for first in range(0, len(rows), ROWS_AT_ONCE):
        portion = rows[first : first + ROWS_AT_ONCE]
        scaled = np.sqrt(mass[portion])[:, None] * fields[portion]
        form += scaled.T @ scaled
    return form
