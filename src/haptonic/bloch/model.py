"""The Bloch model of one cell: from sizes to frequencies at any wavevector, each with its error."""

from __future__ import annotations

import math
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from haptonic.arrays import Array, Complex, Fields
from haptonic.bloch.centred import lattice_pencil, parted
from haptonic.bloch.pencil import Evaluated, SplitPencil, eigenpairs, hertz
from haptonic.bloch.reach import (
    Lack,
    MeshLimits,
    check_memory,
    check_thickness,
    finer_level,
    first_level,
    growth_for,
    refusal,
)
from haptonic.bloch.reduced import ReducedCell
from haptonic.bloch.representative import Representative
from haptonic.bloch.resolution import LADDER, Resolution
from haptonic.bloch.settings import BandSettings
from haptonic.cell import UnitCell
from haptonic.parallel import one_thread
from haptonic.superelement import Tiling, on_each

# Relative error up to which what the interior leaves out is what its first order tells: where 1.4e-2 was told
# 4.7e-2 was lost, and bands had changed places; up to the share of the accuracy the interior need not grow.
TRUSTED_TRUNCATION, TRUNCATION_SHARE = 1e-3, 0.25
FIRST_ORDER = 1.5  # what was lost was at most that many times what first order told, below the trusted one
MOST_GROWTH = 4  # of the interior in all
# Times the accuracy: an error with which a mesh is left though its interior is not trusted. Of nine cells
# that lost 1e-3 to 2e-2 inside, the error of the mesh moved by 6 % at most once they lost a tenth of that.
CLEARLY = 1.1
ABOVE = 2  # modes above those asked for that may change places with them: a tenth band was 1.3 % off so
HALVES_DIVISIONS = 6  # at which the bands of each parity are counted
ERROR_DIVISIONS = 3  # of the zone's sides, for the wavevectors at which a model's errors are judged
REST = 1e-4  # share of the highest frequency below which a mode counts as a rigid-body motion


@dataclass(frozen=True)
class Solution:
    """Modes at one wavevector, lowest first.

    source : the wavevector, and that of the irreducible zone where it was solved
    frequency, error : (k,) Hz; the error bounds the distance to the exact frequency of the model
    fields : (t + m, k) unknowns of the tiling at ``source.kappa``, unit mass; `BlochModel.displacement` gives
        the motion at `kappa`
    modes : (r, k) the same in the small basis; real, unless degenerate ones were turned
    """

    source: Representative
    frequency: Array
    error: Array
    fields: Complex
    modes: Fields

    @property
    def kappa(self) -> Array:
        """(2,) phases of the wavevector, rad."""
        return self.source.image

    def turned(self, turn: Fields) -> Solution:
        """The same with new modes = old modes @ turn, (k, k) unitary among degenerate ones."""
        return replace(self, fields=self.fields @ turn, modes=self.modes @ turn)

    def lowest(self, count: int) -> Solution:
        """The first ``count`` modes."""
        return Solution(
            source=self.source,
            frequency=self.frequency[:count],
            error=self.error[:count],
            fields=self.fields[:, :count],
            modes=self.modes[:, :count],
        )


@dataclass(frozen=True)
class BlochModel:
    """Frequencies, modes and group velocities of a cell at any wavevector.

    The small basis serves the irreducible zone; `representative` carries every wavevector there.

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
        resolution = resolution.for_bands(cell, count)
        goal = resolution.projection_goal
        steps, block = resolution.steps, resolution.block

        def lowered() -> Evaluated:
            lower = Tiling.condensed(cell, resolution.lowered(cell), steps, block, measured=False)
            # a first basis, unchecked, told 2 % of a plain plate's tenth band where 0.05 % were to be told
            if many:
                return ReducedCell.of(lower, count, goal).pencil
            return parted(lattice_pencil(lower))[0]

        # these matrices are too small for threads inside the linear algebra; both models share the threads
        # that symmetry classes are given to, the larger one first
        with one_thread(), ThreadPoolExecutor(1) as aside:
            coarse = aside.submit(lowered)
            whole = Tiling.condensed(cell, resolution.plans(cell), steps, block, measured=measured)
            return cls(
                cell=cell,
                resolution=resolution,
                count=count,
                fine=ReducedCell.of(whole, count, goal),
                coarse=coarse.result(),
            )

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

    def representative(self, kappa: Array) -> Representative:
        """The wavevector of the irreducible zone that is equivalent to the phases (2,)."""
        return Representative.of(self.cell.zone, self.cell.point_group, kappa)

    def frequencies(self, kappa: Array) -> Array:
        """(count,) Hz at the phases (2,), without anything else."""
        return hertz(eigenpairs(self.fine.pencil, self.representative(kappa).kappa, self.count)[0])

    def solve(self, kappa: Array, spare: int = 0) -> Solution:
        """Modes and error estimates at the phases (2,); ``spare`` more than the bands asked for."""
        count, source = self.count + spare, self.representative(kappa)
        kappa = source.kappa
        values, modes = eigenpairs(self.fine.pencil, kappa, count + ABOVE)
        fields = self.fine.expanded(modes, kappa)
        frequency = hertz(values)
        distance = np.abs(hertz(eigenpairs(self.coarse, kappa, count + ABOVE)[0]) - frequency)
        moving = frequency > REST * self.highest
        error = self.resolution.estimate(self.cell, frequency, distance, moving)
        error += self._lost(values, fields) + frequency * self.fine.projection_error
        error += self.fine.rounding / (8 * np.pi**2 * np.maximum(frequency, REST * self.highest))
        error = _ranked(frequency, error)
        return Solution(source=source, frequency=frequency, error=error, fields=fields, modes=modes).lowest(
            count
        )

    def displacement(self, solution: Solution) -> Complex:
        """(nodes, 3, k) motion of the meshes of all tiles, one after the other, at `Solution.kappa`."""
        return solution.source.fields(self.fine.tiling, solution.fields)

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
        """Highest frequency of the last band at the zone's corners, Hz: the yardstick for what is at rest.

        At Gamma alone the last of three bands is at rest itself.
        """
        corners = self.cell.zone.corner_phases.values()
        return max(float(self.frequencies(kappa)[-1]) for kappa in corners)

    def gradient(self, kappa: Array, modes: Fields) -> Array:
        """(k, 2) exact derivatives of the frequencies with respect to the phases, Hz/rad.

        ``modes`` are those that `solve` gives at ``kappa``, of unit mass; degenerate ones must have been
        turned so that the derivative is diagonal among them. At zero frequency it is not defined: NaN.
        """
        source = self.representative(kappa)
        kappa = source.kappa
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
        return source.gradient(slopes)


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
    cell: UnitCell, settings: BandSettings, *, gaps_only: bool = False, limits: MeshLimits | None = None
) -> Iterator[BlochModel | Lack]:
    """Models of rising cost, from the first that may be accurate enough; last, why there is no further one.

    The user takes the first model that is accurate enough, else the best. Once a first mesh has begun, its
    interior may grow whatever the budget: without that it has no error to answer with.

    Parameters
    ----------
    settings : the resolution that they may hold is the only one to try, whatever the accuracy
    gaps_only : whether nothing else will be asked for
    limits : by default the budget of the settings and the free memory

    Raises
    ------
    ResourceError : not even the coarsest mesh fits
    GeometryError : a plate too thin to be computed, or a cell whose interior no mesh follows
    """
    count, accuracy, chosen = settings.count, settings.accuracy, settings.resolution
    limits = MeshLimits.of(settings.budget) if limits is None else limits
    if chosen is None:
        level = first_level(cell, count, accuracy, limits)
        mesh = LADDER[level].for_bands(cell, count)
    else:
        check_thickness(cell)
        mesh, level, limits = chosen.for_bands(cell, count), len(LADDER), replace(limits, seconds=math.inf)
        check_memory(cell, mesh, limits)
    spent, grown, answered = 0.0, 0, False
    while True:
        model = BlochModel.of(cell, mesh, count, measured=not gaps_only, many=not gaps_only)
        spent += mesh.seconds(cell)
        trusted = model.truncation <= TRUSTED_TRUNCATION
        if trusted or (chosen is not None and grown == MOST_GROWTH):
            answered = True
            yield model
        enough = trusted and model.truncation <= TRUNCATION_SHARE * accuracy
        growth = 0
        if not enough:
            needed = growth_for(model.truncation, TRUNCATION_SHARE * accuracy)
            growth = min(needed, max(MOST_GROWTH - grown, 1))
        grown += growth
        wanted = mesh.grown(growth)
        # for gaps only, the error of a mesh costs as much as the next interior
        judged = chosen is None and (trusted or not gaps_only)
        too_coarse = judged and model.mesh_error > (1.0 if trusted else CLEARLY) * accuracy
        if enough or too_coarse or grown > MOST_GROWTH:
            finer = finer_level(cell, wanted, level, model.mesh_error / accuracy, limits, spent)
            if not isinstance(finer, Lack):
                level, mesh = finer
                continue
            if trusted or grown > MOST_GROWTH:
                lack = finer
                break
        mesh = wanted
        missing = limits.lack(cell, mesh, spent)
        if missing is not None and (answered or missing.of == "memory"):
            lack = missing
            break
    if not answered:
        raise refusal(cell, count, accuracy, lack)
    yield lack


@dataclass(frozen=True)
class BestModel:
    """The model that answers; ``lack`` says why there is none of the accuracy asked for."""

    model: BlochModel
    lack: Lack | None = None

    def attributes(self, settings: BandSettings) -> dict[str, Any]:
        """What a dataset says of the accuracy: asked for, reached, and what stood in its way."""
        attributes: dict[str, Any] = {"accuracy": settings.accuracy, "budget_s": settings.budget}
        if settings.resolution is None:  # else the user chose the mesh, whatever it reaches
            attributes["largest_error"] = self.model.worst_error
        if self.lack is not None:
            attributes |= self.lack.attributes(self.model.cell)
        return attributes


def best_model(cell: UnitCell, settings: BandSettings, *, limits: MeshLimits | None = None) -> BestModel:
    """The cheapest model whose error estimates stay within an accuracy all over the zone, or else the best.

    Parameters and errors as in `candidate_models`.
    """
    best: BlochModel | None = None
    for found in candidate_models(cell, settings, limits=limits):
        if isinstance(found, Lack):
            assert best is not None, "no model, and no error that says why"
            return BestModel(best, found)
        if best is None or found.worst_error < best.worst_error:
            best = found
        if settings.resolution or best.worst_error <= settings.accuracy:
            return BestModel(best)
    raise AssertionError("the last word is why there is no further model")


def bloch_model(cell: UnitCell, settings: BandSettings, *, limits: MeshLimits | None = None) -> BlochModel:
    """The model of `best_model`; its ``worst_error`` is the accuracy that it reaches."""
    return best_model(cell, settings, limits=limits).model
