"""The Bloch model of one cell: from sizes to frequencies at any wavevector, each with its error."""

from __future__ import annotations

import math
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from haptonic.arrays import Array, Complex, Fields, Ints
from haptonic.bloch.centred import CentredPencil, PhasedPencil, RealPencil, halves, lattice_pencil, split
from haptonic.bloch.pencil import Evaluated, Pencil, SplitPencil, eigenpairs, hertz
from haptonic.bloch.resolution import (
    LADDER,
    Resolution,
    check_cost,
    check_memory,
    check_start,
    check_thickness,
    first_rung,
)
from haptonic.bloch.settings import COARSEST, BandSettings
from haptonic.brillouin import IrreducibleZone
from haptonic.cell import UnitCell
from haptonic.errors import ResourceError
from haptonic.later import linalg as la
from haptonic.parallel import one_thread
from haptonic.superelement import Tiling, definite, on_each

TRAINING_DIVISIONS = (2, 4, 8)  # of the zone's sides, for the wavevectors that span the small basis
# Share of the way from rest to the zone's corners at which a basis is checked as well: there bands of a plain
# plate change fastest. Checked at the middles of triangles alone, one told 7.5e-6 and lost 6e-3 at 0.14.
NEAR_REST = 0.12
SPARE_MODES = 3  # modes beyond those asked for that go into the small basis
LOST_DIRECTION = 1e-10  # smallest share of the snapshots' inertia that still makes a basis vector
TIGHTER = 0.1  # factor on that share where it was too coarse: little inertia may be much energy
# Relative error up to which what the interior leaves out is what its first order tells: where 1.4e-2 was told
# 4.7e-2 was lost, and bands had changed places; up to the share of the accuracy the interior need not grow.
TRUSTED_TRUNCATION, TRUNCATION_SHARE = 1e-3, 0.25
FIRST_ORDER = 1.5  # what was lost was at most that many times what first order told, below the trusted one
MOST_GROWTH = 4  # of the interior at one mesh
ABOVE = 2  # modes above those asked for that may change places with them: a tenth band was 1.3 % off so
HALVES_DIVISIONS = 6  # at which the bands of each parity are counted
ERROR_DIVISIONS = 3  # of the zone's sides, for the wavevectors at which a model's errors are judged
REST = 1e-4  # share of the highest frequency below which a mode counts as a rigid-body motion


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
        parts = halves(full.middle) if full.middle is not None else None
        solved = split(full, parts) if parts else full
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
            bases = [
                _enriched(own, new, mass, lost)
                for own, new in zip(rest, _apart(np.hstack(snapshots), parts), strict=True)
            ]
            small = split(full, (bases[0], bases[1])) if parts else full.projected(bases[0])
            if error <= goal:
                break
        assert small is not None
        rounding = float(np.abs(eigenpairs(small, np.zeros(2), 3)[0]).max())
        # between the wavevectors of the check it may be off by as much as was allowed there
        return cls(tiling, full, small, np.hstack(bases), max(error, goal), rounding)

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


@dataclass(frozen=True)
class Solution:
    """Modes at one wavevector, lowest first.

    kappa : (2,) phases, rad
    frequency, error : (k,) Hz; the error bounds the distance to the exact frequency of the model
    fields : (t + m, k) unknowns of the tiling, unit mass
    modes : (r, k) the same in the small basis; real, unless degenerate ones were turned
    """

    kappa: Array
    frequency: Array
    error: Array
    fields: Complex
    modes: Fields

    def turned(self, turn: Fields) -> Solution:
        """The same with new modes = old modes @ turn, (k, k) unitary among degenerate ones."""
        return replace(self, fields=self.fields @ turn, modes=self.modes @ turn)

    def lowest(self, count: int) -> Solution:
        """The first ``count`` modes."""
        return Solution(
            self.kappa,
            self.frequency[:count],
            self.error[:count],
            self.fields[:, :count],
            self.modes[:, :count],
        )


@dataclass(frozen=True)
class BlochModel:
    """Frequencies, modes and group velocities of a cell at any wavevector.

    cell, resolution : what it was made from; count : how many bands it was made for
    fine : the model that answers; coarse : pencil of lower order, for the error estimate
    """

    cell: UnitCell
    resolution: Resolution
    count: int
    fine: ReducedCell
    coarse: Evaluated

    @classmethod
    def of(
        cls, cell: UnitCell, resolution: Resolution, count: int, *, measured: bool = True, many: bool = True
    ) -> BlochModel:
        """Make a model for ``count`` bands.

        Parameters
        ----------
        measured : whether the characters of modes will be asked for
        many : whether errors will be asked for at many wavevectors: the coarse pencil is reduced then
        """
        resolution = resolution.for_bands(count)
        goal = resolution.projection_goal
        steps, block = resolution.steps, resolution.block

        def lowered() -> Evaluated:
            lower = Tiling.condensed(cell, resolution.lowered(cell), steps, block, measured=False)
            # a first basis, unchecked, told 2 % of a plain plate's tenth band where 0.05 % were to be told
            if many:
                return ReducedCell.of(lower, count, goal).pencil
            full = lattice_pencil(lower)
            return full if full.middle is None else split(full, halves(full.middle))

        # these matrices are too small for threads inside the linear algebra; both models share the threads
        # that symmetry classes are given to, the larger one first
        with one_thread(), ThreadPoolExecutor(1) as aside:
            coarse = aside.submit(lowered)
            whole = Tiling.condensed(cell, resolution.plans(cell), steps, block, measured=measured)
            return cls(cell, resolution, count, ReducedCell.of(whole, count, goal), coarse.result())

    @cached_property
    def halves(self) -> dict[int, BlochModel]:
        """By parity, the models of what is symmetric (1) and antisymmetric (-1) about the middle plane.

        Each has the bands that are among those of the whole at every wavevector; none has one without bands.
        """
        if not isinstance(self.fine.pencil, SplitPencil):
            return {}
        assert isinstance(self.coarse, SplitPencil)
        found = {}
        wavevectors, _ = self.cell.zone.triangles(HALVES_DIVISIONS)
        modes = [eigenpairs(self.fine.pencil, kappa, self.count)[1] for kappa in wavevectors]
        for parity, coarse in zip((1, -1), self.coarse.parts, strict=True):
            count = min(int((self.fine.parity(one) == parity).sum()) for one in modes)
            if count:
                fine = self.fine.of_parity(parity)
                found[parity] = replace(self, count=count, fine=fine, coarse=coarse)
        return found

    def frequencies(self, kappa: Array) -> Array:
        """(count,) Hz at the phases (2,), without anything else."""
        return hertz(eigenpairs(self.fine.pencil, kappa, self.count)[0])

    def solve(self, kappa: Array, spare: int = 0) -> Solution:
        """Modes and error estimates at the phases (2,); ``spare`` more than the bands asked for."""
        count = self.count + spare
        values, modes = eigenpairs(self.fine.pencil, kappa, count + ABOVE)
        fields = self.fine.expanded(modes, kappa)
        frequency = hertz(values)
        distance = np.abs(hertz(eigenpairs(self.coarse, kappa, count + ABOVE)[0]) - frequency)
        moving = frequency > REST * self.highest
        error = self.resolution.estimate(self.cell, frequency, distance, moving)
        error += self._lost(values, fields) + frequency * self.fine.projection_error
        error += self.fine.rounding / (8 * np.pi**2 * np.maximum(frequency, REST * self.highest))
        error = _ranked(frequency, error)
        return Solution(kappa, frequency, error, fields, modes).lowest(count)

    def _lost(self, values: Array, fields: Complex) -> Array:
        """(k,) Hz by which the interior fields that were left out would lower each of k modes."""
        return interior_error(values, on_each(self.fine.tiling.truncation, fields))

    @cached_property
    def truncation(self) -> float:
        """Largest relative error that the interior's short space adds at the corners of the zone."""
        worst = 0.0
        for kappa in self.cell.zone.corner_phases.values():
            values, modes = eigenpairs(self.fine.pencil, kappa, self.count)
            moving = values > (2 * np.pi * REST * self.highest) ** 2
            frequency = hertz(values)
            lost = _ranked(frequency, self._lost(values, self.fine.expanded(modes, kappa)))
            worst = max(worst, float((lost[moving] / frequency[moving]).max(initial=0.0)))
        return worst

    @cached_property
    def _worst(self) -> tuple[float, float]:
        """`worst_error` and `mesh_error`."""
        wavevectors, _ = self.cell.zone.triangles(ERROR_DIVISIONS)
        worst = np.zeros(2)
        for kappa in wavevectors:
            found = self.solve(kappa)
            lost = self._lost((2 * np.pi * found.frequency) ** 2, found.fields)
            moving = found.frequency > REST * self.highest
            errors = np.stack([found.error, found.error - lost])[:, moving] / found.frequency[moving]
            worst = np.maximum(worst, errors.max(axis=1, initial=0.0))
        return float(worst[0]), float(worst[1])

    @property
    def worst_error(self) -> float:
        """Largest relative error estimate over a coarse sampling of the irreducible zone, rest left out."""
        return self._worst[0]

    @property
    def mesh_error(self) -> float:
        """The same without what the interior leaves out: more of it would not mend this.

        Lower orders have as short an interior: a band's distance to them hardly holds any of it, once what is
        left out is trusted.
        """
        return self._worst[1]

    @cached_property
    def highest(self) -> float:
        """Of the last band at the corners of the zone, Hz: the yardstick for what is at rest.

        At Gamma alone the last of three bands is at rest itself.
        """
        corners = self.cell.zone.corner_phases.values()
        return max(float(self.frequencies(kappa)[-1]) for kappa in corners)

    def gradient(self, kappa: Array, modes: Fields) -> Array:
        """(k, 2) exact derivatives of the frequencies with respect to the phases, Hz/rad.

        ``modes`` are those of the small pencil at ``kappa``, of unit mass; degenerate ones must have been
        turned so that the derivative is diagonal among them. At zero frequency it is not defined: NaN.
        """
        K, _ = self.fine.pencil.at(kappa)
        values = on_each(K, modes)
        frequency = hertz(values)
        slopes = np.empty((len(values), 2))
        for direction in range(2):
            dK, dM = self.fine.pencil.slope(kappa, direction)
            slopes[:, direction] = on_each(dK, modes) - values * on_each(dM, modes)
        moving = frequency > REST * self.highest
        slopes[~moving] = np.nan
        slopes[moving] /= 8 * np.pi**2 * frequency[moving, None]
        return slopes


def interior_error(values: Array, left_out: Array) -> Array:
    """(k,) Hz by which what the interior leaves out would lower modes of eigenvalues (k,), to first order.

    left_out : (k,) the form of the truncation on each mode
    """
    return np.asarray(0.5 * FIRST_ORDER * values * np.abs(left_out) * hertz(values))


def _ranked(frequency: Array, error: Array) -> Array:
    """(k,) Hz, errors of bands from those of k modes, lowest first.

    A band is the mode of its rank: one that may in truth be lower than it was found pushes those that it
    passes up a rank, and what stands at theirs may be it.
    """
    lowest = frequency - error
    return np.asarray(frequency - np.minimum(lowest, np.sort(lowest)))


def candidate_models(
    cell: UnitCell, settings: BandSettings, *, gaps_only: bool = False
) -> Iterator[BlochModel]:
    """Models of rising cost, from the first that may be accurate enough; the user takes the first that is.

    Parameters
    ----------
    settings : the resolution that they may hold is the only one to try, whatever the accuracy
    gaps_only : whether nothing else will be asked for

    Raises
    ------
    ResourceError : the memory does not suffice, or all rungs of the ladder were refused
    GeometryError : a plate too thin to be computed
    """
    count, accuracy, resolution = settings.count, settings.accuracy, settings.resolution
    what = {"measured": not gaps_only, "many": not gaps_only}
    check_thickness(cell)
    if resolution is None:
        check_start(cell, count, accuracy)
    spent, reached, refused, grown = 0.0, math.inf, None, 0
    for rung in LADDER[first_rung(cell, accuracy) :] if resolution is None else (resolution,):
        tried = rung.for_bands(count)
        plans = tried.plans(cell)
        if plans == refused:  # without a pillar rings make no difference
            continue
        refused = plans
        for _ in range(grown):  # what the mesh before lacked inside this one would lack as well
            tried = tried.grown()
        while True:
            if resolution is None:
                spent += check_cost(cell, tried, accuracy, spent, reached)
            else:
                check_memory(cell, tried)
            model = BlochModel.of(cell, tried, count, **what)
            trusted = model.truncation <= TRUSTED_TRUNCATION
            given_up = resolution is not None and grown == MOST_GROWTH
            if trusted or given_up:
                yield model
                reached = min(reached, model.worst_error)
            # a mesh is judged by what a trusted interior leaves of its error, and left where that is too much
            enough = trusted and model.truncation <= TRUNCATION_SHARE * accuracy
            too_coarse = trusted and resolution is None and model.mesh_error > accuracy
            grown += not enough
            if enough or too_coarse or grown > MOST_GROWTH:
                break
            tried = tried.grown()
    raise ResourceError.inaccurate(
        argument="bands.accuracy",
        given=f"{accuracy:g}",
        allowed="what the finest mesh reaches for this cell",
        cause="its own error estimates stay larger",
        next_step="ask for less accuracy",
    )


def bloch_model(cell: UnitCell, settings: BandSettings, *, or_best: bool = False) -> BlochModel:
    """The cheapest model whose error estimates stay within an accuracy all over the zone.

    Parameters and errors as in `candidate_models`. With ``or_best`` the most accurate model that was found
    answers where none reaches the accuracy, unless even its errors are beyond `COARSEST`.
    """
    best: BlochModel | None = None
    try:
        for model in candidate_models(cell, settings):
            if settings.resolution or model.worst_error <= settings.accuracy:
                return model
            if best is None or model.worst_error < best.worst_error:
                best = model
    except ResourceError:
        if not or_best or best is None or best.worst_error > COARSEST:
            raise
    assert best is not None, "a ladder without a rung"
    return best
