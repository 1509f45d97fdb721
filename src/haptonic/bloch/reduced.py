"""A condensed cell in a small basis, in which any wavevector costs next to nothing."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from haptonic.arrays import Array, Complex, Fields, Ints
from haptonic.bloch.centred import CentredPencil, PhasedPencil, RealPencil, lattice_pencil, parted, split
from haptonic.bloch.pencil import Pencil, SplitPencil, eigenpairs
from haptonic.brillouin import IrreducibleZone
from haptonic.later import linalg as la
from haptonic.superelement import Tiling, definite

TRAINING_DIVISIONS = (2, 4, 8)  # of the zone's sides, for the wavevectors that span the small basis
# Share of the way from rest to the zone's corners at which a basis is checked as well: there bands of a plain
# plate change fastest. Checked at the middles of triangles alone, one told 7.5e-6 and lost 6e-3 at 0.14.
NEAR_REST = 0.12
SPARE_MODES = 3  # modes beyond those asked for that go into the small basis
LOST_DIRECTION = 1e-10  # smallest share of the snapshots' inertia that still makes a basis vector
TIGHTER = 0.1  # factor on that share where it was too coarse: little inertia may be much energy


@dataclass(frozen=True)
class ReducedCell:
    """A condensed cell in a small basis that serves the whole irreducible zone, long waves included.

    tiling : the condensed cell; whole : its pencil
    pencil : on the small basis; basis : (free unknowns, r)
    projection_error : relative error of a frequency that the basis may add: what was allowed, or more if more
        was seen at wavevectors that had not gone into it then
    rounding : (rad/s)^2, by how much rounding moves the eigenvalues of rest modes
    """

    tiling: Tiling
    whole: CentredPencil | PhasedPencil
    pencil: RealPencil | Pencil | SplitPencil
    basis: Array
    projection_error: float
    rounding: float

    @classmethod
    @definite()
    def of(cls, tiling: Tiling, count: int, goal: float) -> ReducedCell:
        """Enrich a basis until it adds no more than ``goal`` (relative) to ``count`` frequencies."""
        full = lattice_pencil(tiling)
        solved, parts = parted(full)
        mass = full.at(np.zeros(2))[1].real
        rest = [_orthonormal(one, mass) for one in _apart(full.near_rest(), parts)]
        snapshots: list[Array] = []
        error, small, lost = np.inf, None, LOST_DIRECTION
        for wavevectors in _training(tiling.cell.zone):
            values, modes = zip(
                *(eigenpairs(solved, kappa, count + SPARE_MODES) for kappa in wavevectors), strict=True
            )
            if parts:
                modes = tuple(np.hstack(parts) @ found for found in modes)
            if small is not None:
                found = [eigenpairs(small, kappa, count)[0] for kappa in wavevectors]
                error = max(
                    float((np.sqrt(above / exact[:count]) - 1).max())
                    for above, exact in zip(found, values, strict=True)
                )
                lost *= TIGHTER if error > goal else 1.0
            snapshots += [full.snapshots(found) for found in modes]
            while True:
                bases = [
                    _enriched(own, new, mass, lost)
                    for own, new in zip(rest, _apart(np.hstack(snapshots), parts), strict=True)
                ]
                small = split(full, (bases[0], bases[1])) if parts else full.projected(bases[0])
                try:
                    at_rest = eigenpairs(small, np.zeros(2), 3)[0]
                    break
                except np.linalg.LinAlgError:
                    if lost >= LOST_DIRECTION:
                        raise
                    # so little inertia is rounding: 1e-13 was on a plate of 1/200 of the pitch, 1e-12 was not
                    lost /= TIGHTER
            if error <= goal:
                break
        assert small is not None
        # between the wavevectors of the check it may be off by as much as was allowed there
        return cls(
            tiling=tiling,
            whole=full,
            pencil=small,
            basis=np.hstack(bases),
            projection_error=max(error, goal),
            rounding=float(np.abs(at_rest).max()),
        )

    def parity(self, modes: Fields) -> Ints:
        """(k,) of modes (r, k): +1 symmetric about the plate's middle plane, -1 antisymmetric, 0 if it is no
        mirror of the cell."""
        if isinstance(self.pencil, SplitPencil):
            return self.pencil.parity(modes)
        return np.zeros(modes.shape[1], dtype=np.int64)

    def of_parity(self, parity: int) -> ReducedCell:
        """What has one parity alone."""
        assert isinstance(self.pencil, SplitPencil), "a cell without this mirror"
        first = self.pencil.parts[0].size
        own = slice(None, first) if parity > 0 else slice(first, None)
        basis = self.basis[:, own]
        return replace(self, pencil=self.whole.projected(basis), basis=basis)

    def expanded(self, modes: Fields, kappa: Array) -> Complex:
        """(t + m, k) unknowns of the tiling from (r, k) modes of the small pencil."""
        return self.whole.periodic.expanded(self.whole.free(self.basis @ modes, kappa), kappa)


def _training(zone: IrreducibleZone) -> Iterator[Array]:
    """Wavevectors of the irreducible zone in ever denser batches, each only once."""
    seen = np.empty((0, 2))
    long_waves = NEAR_REST * np.array(list(zone.corner_phases.values()))
    for divisions in TRAINING_DIVISIONS:
        vertices, triangles = zone.triangles(divisions)
        for batch in (vertices, np.concatenate([vertices[triangles].mean(axis=1), long_waves])):
            apart = np.linalg.norm(batch[:, None] - seen, axis=2).min(axis=1, initial=np.inf)
            new = batch[apart > 1e-6]
            seen = np.concatenate([seen, new])
            yield new


def _apart(fields: Array, parts: tuple[Array, Array] | None) -> list[Array]:
    """The symmetric and the antisymmetric share of fields (n, k), or these themselves."""
    return [basis @ (basis.T @ fields) for basis in parts] if parts else [fields]


def _enriched(rest: Array, new: Array, mass: Array, lost: float) -> Array:
    """(n, r) basis that spans long waves and new fields."""
    for _ in range(2):  # one pass of Gram and Schmidt is not enough
        new = new - rest @ (rest.T @ (mass @ new))
    return np.hstack([rest, _orthonormal(new, mass, lost)])


def _orthonormal(fields: Array, mass: Array, lost: float = LOST_DIRECTION) -> Array:
    """(n, r) basis of unit modal mass that spans fields (n, k) of unit mass, but for what is hardly there."""
    values, turn = la.eigh(fields.T @ mass @ fields)
    kept = values > lost * max(values[-1], 1.0)  # one direction may be all that is left
    return np.asarray(fields @ (turn[:, kept] / np.sqrt(values[kept])))
