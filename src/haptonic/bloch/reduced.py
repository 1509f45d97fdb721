"""Condensed cells in a small basis, for fast solutions at any wavevector."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property
from typing import cast

import numpy as np

from haptonic.arrays import Array, Complex, Fields, Ints
from haptonic.bloch.centred import LatticePencil, PhasedPencil, RealPencil, lattice_pencil, together
from haptonic.bloch.pencil import Derived, Pencil, SplitPencil, eigenpairs
from haptonic.brillouin import IrreducibleZone
from haptonic.later import linalg as la
from haptonic.superelement import Tiling, definite, missing_energy, on_each

TRAINING_DIVISIONS = (2, 4, 8)  # of the zone's sides, for the wavevectors that span the small basis
# Share of the path from rest to the zone's corners at which a basis is checked too, because bands of a plain
# plate change fastest there. Checked at the middles of triangles only, a basis had an estimate of 7.5e-6 and
# an error of 6e-3 at 0.14.
NEAR_REST = 0.12
SPARE_MODES = 3  # modes above the last band that are added to the small basis
# Smallest inertia of a basis vector, as a share of that of a mode: in a basis that may be too coarse, and of
# what further modes add to one that is not. On 27 drawn cells the second share left 0.3 of the allowed error
# or less, with 88 % of the vectors; in every step it left 2.2 times of it on a plate of 1/200 of the pitch.
LOST_DIRECTION, ADDED_DIRECTION = 1e-10, 1e-7
TIGHTER = 0.1  # factor on that share if the basis is too coarse: little inertia may be much energy


SmallPencil = RealPencil | Pencil | SplitPencil[RealPencil | Pencil]


@dataclass(frozen=True, eq=False)
class Losses:
    """Forms on a basis that estimate the errors of modes; computed when they are first needed.

    whole : pencil of the tiling, or of its motions of one parity; basis : (n, r) of its unknowns
    """

    tiling: Tiling
    whole: PhasedPencil
    basis: Array

    @cached_property
    def pencils(self) -> tuple[Derived, Derived]:
        """The forms on the basis, two in each pencil."""
        surplus, of_kind, before = self.tiling.surplus
        first, second = (
            self.whole.projected(self.basis, pair)
            for pair in ((surplus, of_kind), (before, self.tiling.truncation))
        )
        return first, second

    def at(self, modes: Fields, kappa: Array) -> Array:
        """(4, k) values of the forms on modes (r, k)."""
        return np.array([on_each(form, modes) for pencil in self.pencils for form in pencil.at(kappa)])


@dataclass(frozen=True)
class StiffenedPencil:
    """Pencil with the surplus as additional stiffness, which changes modes about as lower orders would.

    whole : stiffness and mass; surplus : two forms that are added
    """

    whole: Derived
    surplus: Derived

    @property
    def size(self) -> int:
        return self.whole.size

    def at(self, kappa: Array) -> tuple[Fields, Fields]:
        """(r, r) stiffness and mass at the phases (2,)."""
        stiffness, mass = self.whole.at(kappa)
        return stiffness + sum(self.surplus.at(kappa)), mass

    def slopes(self, kappa: Array) -> list[tuple[Fields, Fields]]:
        """Exact derivatives of stiffness and mass with respect to each phase."""
        both = zip(self.whole.slopes(kappa), self.surplus.slopes(kappa), strict=True)
        return [(stiffness + sum(added), mass) for (stiffness, mass), added in both]


@dataclass(frozen=True)
class ReducedCell:
    """Condensed cell in a small basis for the whole irreducible zone, long waves included.

    tiling : the condensed cell; whole : its pencil
    pencil : on the small basis; bases : (n, r) for each part of the whole pencil
    errors : forms on each basis
    projection_error : relative error of frequencies due to the basis: the allowed one, or a larger one
        measured at wavevectors outside the training set
    rounding : rounding error of the eigenvalues of rest modes, (rad/s)^2
    """

    tiling: Tiling
    whole: LatticePencil
    pencil: SmallPencil
    bases: tuple[Array, ...]
    errors: tuple[Losses, ...]
    projection_error: float
    rounding: float

    @classmethod
    @definite()
    def of(cls, tiling: Tiling, count: int, goal: float) -> ReducedCell:
        """Enrich a basis until its relative error of ``count`` frequencies is at most ``goal``."""
        whole = lattice_pencil(tiling)
        parts = whole.parts
        ends = np.cumsum([part.size for part in parts])[:-1]
        masses = [part.at(np.zeros(2))[1].real for part in parts]
        bases = rest = [
            _orthonormal(part.near_rest(), mass) for part, mass in zip(parts, masses, strict=True)
        ]
        snapshots: list[list[Array]] = [[] for _ in parts]
        error, small, lost = np.inf, None, LOST_DIRECTION

        def projected(bases: list[Array]) -> SmallPencil:
            return together([part.projected(basis) for part, basis in zip(parts, bases, strict=True)])

        for wavevectors in _training(tiling.cell.zone):
            values, modes = zip(
                *(eigenpairs(whole, kappa, count + SPARE_MODES) for kappa in wavevectors), strict=True
            )
            shares = zip(*(np.split(shapes, ends) for shapes in modes), strict=True)
            added = [
                np.hstack([part.snapshots(share) for share in of_part])
                for part, of_part in zip(parts, shares, strict=True)
            ]
            if small is not None:
                deviation = _deviation(small, wavevectors, values, count)
                error = float(np.abs(deviation).max())
                if error <= goal:
                    wider = [
                        _enriched(basis, new, mass, ADDED_DIRECTION)
                        for basis, new, mass in zip(bases, added, masses, strict=True)
                    ]
                    wider_pencil = projected(wider)
                    with suppress(np.linalg.LinAlgError):  # if its mass is not definite, it is not used
                        if _deviation(wider_pencil, wavevectors, values, count).min() >= -goal:
                            bases, small = wider, wider_pencil
                    break
                # a band below the exact one belongs to a direction whose inertia is a rounding error
                lost *= TIGHTER if deviation.min() >= -goal else 1 / TIGHTER
            for of_part, new in zip(snapshots, added, strict=True):
                of_part.append(new)
            while True:
                bases = [
                    _enriched(long_waves, np.hstack(of_part), mass, lost)
                    for long_waves, of_part, mass in zip(rest, snapshots, masses, strict=True)
                ]
                small = projected(bases)
                try:
                    eigenpairs(small, np.zeros(2), 3)
                    break
                except np.linalg.LinAlgError:
                    if lost >= LOST_DIRECTION:
                        raise
                    # such small inertia is a rounding error: 1e-13 was on a plate of 1/200 of the pitch,
                    # 1e-12 was not
                    lost /= TIGHTER
        assert small is not None
        # between the checked wavevectors the error may equal the allowed one
        return cls(
            tiling=tiling,
            whole=whole,
            pencil=small,
            bases=tuple(bases),
            errors=tuple(Losses(tiling, part, of) for part, of in zip(parts, bases, strict=True)),
            projection_error=max(error, goal),
            rounding=float(np.abs(eigenpairs(small, np.zeros(2), 3)[0]).max()),
        )

    def _shares(self, modes: Fields) -> list[Fields]:
        """Modes (r, k) on each basis."""
        return np.split(modes, np.cumsum([basis.shape[1] for basis in self.bases])[:-1])

    def losses(self, modes: Fields, kappa: Array) -> tuple[Array, Array, Array]:
        """(k,) values for modes (r, k) of unit mass: energy that the mesh lacks (N/m), energy that orders one
        lower would lack in addition (N/m), and the truncation form.

        See `haptonic.superelement.surplus` and `Superelement.truncation`.
        """
        values = [
            errors.at(share, kappa) for errors, share in zip(self.errors, self._shares(modes), strict=True)
        ]
        surplus, of_kind, before, truncation = np.sum(values, axis=0)
        return missing_energy(surplus, of_kind, before), surplus + of_kind, truncation

    @property
    def stiffened(self) -> StiffenedPencil:
        """The pencil of all motions with the surplus as additional stiffness."""
        surplus, *_ = zip(*(errors.pencils for errors in self.errors), strict=True)
        return StiffenedPencil(cast("Derived", self.pencil), together(surplus))

    def parity(self, modes: Fields) -> Ints:
        """(k,) parity of modes (r, k) about the plate's middle plane: +1, -1, or 0 if it is not a mirror."""
        if isinstance(self.pencil, SplitPencil):
            return self.pencil.parity(modes)
        return np.zeros(modes.shape[1], dtype=np.int64)

    def of_parity(self, parity: int) -> ReducedCell:
        """Restrict the cell to motions of one parity."""
        assert isinstance(self.pencil, SplitPencil), "a cell without this mirror"
        part = 0 if parity > 0 else 1
        return replace(
            self,
            whole=self.whole.parts[part],
            pencil=self.pencil.parts[part],
            bases=(self.bases[part],),
            errors=(self.errors[part],),
        )

    def expanded(self, modes: Fields, kappa: Array) -> Complex:
        """(t + m, k) unknowns of the tiling from (r, k) modes of the small pencil."""
        shares = zip(self.bases, self._shares(modes), strict=True)
        return self.whole.fields(np.vstack([basis @ share for basis, share in shares]), kappa)


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


def _deviation(small: SmallPencil, wavevectors: Array, values: Sequence[Array], count: int) -> Array:
    """(w * count,) relative differences of frequencies from those of exact eigenvalues, w of (count +,)."""
    approximate = [eigenpairs(small, kappa, count)[0] for kappa in wavevectors]
    exact = [of_wavevector[:count] for of_wavevector in values]
    return np.sqrt(np.maximum(np.concatenate(approximate), 0.0) / np.concatenate(exact)) - 1


def _enriched(basis: Array, new: Array, mass: Array, lost: float) -> Array:
    """(n, r) orthonormal basis that contains another one and spans new fields of unit mass."""
    for _ in range(2):  # one pass of Gram and Schmidt is not enough
        new = new - basis @ (basis.T @ (mass @ new))
    return np.hstack([basis, _orthonormal(new, mass, lost)])


def _orthonormal(fields: Array, mass: Array, lost: float = LOST_DIRECTION) -> Array:
    """(n, r) basis of unit modal mass that spans fields (n, k) of unit mass, without dependent directions."""
    values, turn = la.eigh(fields.T @ mass @ fields)
    independent = values > lost * max(values[-1], 1.0)  # a single direction may remain
    return np.asarray(fields @ (turn[:, independent] / np.sqrt(values[independent])))
